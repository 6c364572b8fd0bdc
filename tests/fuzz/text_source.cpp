// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a file, plain or compressed: whatever zlib makes of them, the lines end and are numbered.
#include <granum/io/text/source.hpp>

#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int file = memfd_create("fuzz", 0);
  fuzz::demand(file >= 0 && write(file, data, size) == static_cast<ssize_t>(size));
  const int result = fuzz::run([&] {
    io::TextSource source(std::filesystem::path("/proc/self/fd/" + std::to_string(file)));
    std::size_t lines = 0;
    while (source.next()) {
      fuzz::demand(source.line_number() == ++lines);
      fuzz::demand(source.line().find('\n') == std::string_view::npos);
    }
  });
  close(file);
  return result;
}
