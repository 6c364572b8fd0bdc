// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/yade/files.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run_packing(data, size, [](auto... files) { return io::read_yade(std::move(files)...); });
}
