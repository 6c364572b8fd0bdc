// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_files.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run([&] {
    const io::PackingFrames frames = io::extended_xyz_format.read(
        io::TextSource::of_text("grains.xyz", fuzz::text(data, size)), std::nullopt, {});
    while (const auto packing = frames.next())
      fuzz::check(*packing);
  });
}
