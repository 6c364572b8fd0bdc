// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/mercury/output.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run([&] {
    const fuzz::Parts input = fuzz::parts(fuzz::text(data, size));
    io::TextSource grains = io::TextSource::of_text("data", input.first);
    io::MercuryOutput output =
        input.second ? io::MercuryOutput(std::move(grains), io::TextSource::of_text("fstat", *input.second))
                     : io::MercuryOutput(std::move(grains));
    while (const auto packing = output.next())
      fuzz::check(*packing);
  });
}
