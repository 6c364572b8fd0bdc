// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/arrays.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    for (const auto& [quantity, column] : io::parse_column_map(fuzz::text(data, size)))
      fuzz::demand(!quantity.empty() && !column.empty());
  } catch (const InvalidArgument&) {
    return 0;
  }
  return 0;
}
