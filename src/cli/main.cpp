// SPDX-License-Identifier: GPL-3.0-or-later
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include <granum/core/error.hpp>

#include "cli/commands.hpp"
#include "cli/frame/long_work.hpp"
#include "cli/frame/messages.hpp"

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

} // namespace

/// Converts errors to messages and exit codes.
int main(int argc, char** argv) {
  ExitCode code = ExitCode::ok;
  open_missing_streams();
  take_writing_errors();
  try {
    code = parse_and_run(argc, argv);
  } catch (const InvalidArgument& error) {
    code = fail(ExitCode::usage, error.what());
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
