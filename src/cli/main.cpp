// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <filesystem>
#include <new>
#include <span>
#include <string>
#include <string_view>

#include <granum/core/error.hpp>

#include "cli/commands.hpp"
#include "cli/frame/messages.hpp"
#include "cli/frame/option_row.hpp"
#include "cli/frame/stop_signal.hpp"

namespace {

using namespace granum;
using namespace granum::cli;

/// The command of the command line, for messages.
std::string asked_for(int argc, char** argv) {
  std::string words = "granum";
  for (int k = 1; k < argc; ++k)
    words += std::string(" ") + argv[k];
  return words;
}

/// The message of an error; the name of a number that the library refused is as typed: "--stress-h" for
/// "stress_h".
std::string as_typed(const InvalidArgument& error, int argc, char** argv) {
  const std::string text = error.what();
  if (!error.refused() || !text.starts_with(error.refused()->name))
    return text;
  const std::string name = error.refused()->name;
  const std::string option = name == "fabric_anisotropy" ? "--fabric" : option_of(name);
  for (const std::string_view word : std::span(argv, static_cast<std::size_t>(argc)))
    if (word == option || word.starts_with(option + "="))
      return option + text.substr(name.size());
  return text;
}

} // namespace

/// Converts errors to messages and exit codes.
int main(int argc, char** argv) {
  ExitCode code = ExitCode::ok;
  open_missing_streams();
  take_writing_errors();
  try {
    code = parse_and_run(argc, argv);
  } catch (const InvalidArgument& error) {
    code = fail(ExitCode::usage, as_typed(error, argc, argv));
  } catch (const FileError& error) {
    code = fail(ExitCode::file, error.what());
  } catch (const std::filesystem::filesystem_error& error) { // such as a name that is too long
    code = fail(ExitCode::file, error.what());
  } catch (const NotConverged& error) {
    code = fail(ExitCode::not_converged, error.what());
  } catch (const Stopped& error) {
    say("", error.what());
    code = exit_code_of_stop();
  } catch (const std::bad_alloc&) {
    code = fail(ExitCode::fell_short, "out of memory: there is not enough for " + asked_for(argc, argv) +
                                          "; fewer grains, states or frames need less");
  } catch (const std::exception& error) {
    code = fail(ExitCode::fell_short, error.what());
  }
  return static_cast<int>(code);
}
