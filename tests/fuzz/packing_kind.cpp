// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_files.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run([&] {
    io::TextSource source = io::TextSource::of_text("file", fuzz::text(data, size));
    fuzz::demand(!io::description(io::recognise(source)).empty());
    fuzz::demand(source.next() && source.line_number() == 1);
  });
}
