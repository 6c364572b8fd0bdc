// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "io/packing_builder.hpp"

namespace granum::io {

/// Finds the grain whose centre is the very point that a contact ends at: files of YADE name no grains.
class CentreIndex {
 public:
  explicit CentreIndex(const std::vector<Vec3>& centres);

  /// \return   empty if there is no centre
  /// \throws   FileError if several are
  [[nodiscard]] std::optional<std::uint32_t> look_up(const Vec3& point, const PackingBuilder& builder,
                                                     std::size_t line) const;
  /// \throws   FileError also if no centre is there
  [[nodiscard]] std::uint32_t find(const Vec3& point, const PackingBuilder& builder, std::size_t line) const;

 private:
  using Key = std::tuple<double, double, double>;
  std::map<Key, std::uint32_t> index_;
};

} // namespace granum::io
