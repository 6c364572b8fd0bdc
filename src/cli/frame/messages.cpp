// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages.hpp"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include <granum/core/utf8.hpp>

namespace granum::cli {

namespace {

/// While an object of this class exists, writing to a pipe without a reader gives an error instead of the
/// signal that would end the program.
class PipesMayBreak {
 public:
  PipesMayBreak() noexcept {
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &before_);
  }
  ~PipesMayBreak() { sigaction(SIGPIPE, &before_, nullptr); }
  PipesMayBreak(const PipesMayBreak&) = delete;
  PipesMayBreak& operator=(const PipesMayBreak&) = delete;

 private:
  struct sigaction before_ = {};
};

} // namespace

void open_missing_streams() noexcept {
  // The lowest free number is the one that is given, so the first of the missing is filled first. For reading
  // alone: writing to it fails.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF)
      (void)open("/dev/null", O_RDONLY);
}

void to_standard_error(std::string_view text) noexcept {
  const PipesMayBreak guard;
  while (!text.empty()) {
    const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void say(std::string_view kind, std::string_view message) noexcept {
  try {
    std::string line = "granum: ";
    if (!kind.empty())
      line.append(kind).append(": ");
    to_standard_error(line.append(printable(message)).append("\n"));
  } catch (...) { // no memory for the line
    to_standard_error(message);
  }
}

} // namespace granum::cli
