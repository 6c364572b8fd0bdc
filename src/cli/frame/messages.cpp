// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages.hpp"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "help.hpp"

namespace granum::cli {

namespace {

void (*of_broken_pipes)(int) = SIG_DFL; ///< setting at the start of the program

} // namespace

void open_missing_streams() noexcept {
  // The system assigns the lowest free number, so the first missing stream is filled first. It is read-only:
  // writing to it fails.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1 && errno == EBADF)
      (void)open("/dev/null", O_RDONLY);
}

void take_writing_errors() noexcept {
  of_broken_pipes = std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
    return;
  const int error = errno;
  if (error == EPIPE && of_broken_pipes == SIG_DFL) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  throw FileError("standard output", 0, std::string("cannot be written: ") + std::strerror(error));
}

void to_standard_error(std::string_view text) noexcept {
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
    line.append(printable(message)).append("\n");
    to_standard_error(isatty(STDERR_FILENO) == 1 ? within_width(line) : line); // files keep one line each
  } catch (...) {                                                              // no memory for the line
    to_standard_error(message);
  }
}

} // namespace granum::cli
