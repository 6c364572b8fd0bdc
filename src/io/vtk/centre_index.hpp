// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "io/packing_builder.hpp"

namespace granum::io {

/// Finds the grain whose centre is the very point that a contact ends at: files of YADE name no grains.
class CentreIndex {
 public:
  explicit CentreIndex(const std::vector<Vec3>& centres);

  /// \throws   FileError if no centre is there, or several
  [[nodiscard]] std::uint32_t find(const Vec3& point, const PackingBuilder& builder, std::size_t line) const;

 private:
  using Key = std::tuple<double, double, double>;
  std::map<Key, std::uint32_t> index_;
};

} // namespace granum::io
