// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_files.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run([&] {
    const io::FileKind kind = io::recognise(io::TextSource::of_text("file", fuzz::text(data, size)));
    fuzz::demand(!io::description(kind).empty());
  });
}
