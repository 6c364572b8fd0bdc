// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_format.hpp>

#include <utility>

namespace granum::io {

PackingFrames one_frame(ImportedPacking packing) {
  return {
      .next = [packing = std::optional(std::move(packing))]() mutable { return std::exchange(packing, {}); }};
}

} // namespace granum::io
