// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/packing.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run([&] {
    const fuzz::Parts input = fuzz::parts(fuzz::text(data, size));
    io::TextSource grains = io::TextSource::of_text("grains", input.first);
    if (input.second)
      fuzz::check(
          io::read_packing_csv(std::move(grains), io::TextSource::of_text("contacts", *input.second)));
    else
      fuzz::check(io::read_packing_csv(std::move(grains)));
  });
}
