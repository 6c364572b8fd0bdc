// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run(
      [&] { fuzz::check(io::read_lammps_data(io::TextSource::of_text("data", fuzz::text(data, size)))); });
}
