// SPDX-License-Identifier: GPL-3.0-or-later
#include "centre_index.hpp"

#include <cmath>

namespace granum::io {

namespace {

constexpr std::uint32_t several = 0xffffffff;

} // namespace

CentreIndex::CentreIndex(const std::vector<Vec3>& centres) {
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const Vec3& p = centres[k];
    const auto [at, fresh] = index_.emplace(Key{p.x, p.y, p.z}, static_cast<std::uint32_t>(k));
    if (!fresh)
      at->second = several;
  }
}

std::optional<std::uint32_t> CentreIndex::look_up(const Vec3& point, const PackingBuilder& builder,
                                                  std::size_t line) const {
  const bool ordered = !std::isnan(point.x) && !std::isnan(point.y) && !std::isnan(point.z);
  const auto found = ordered ? index_.find({point.x, point.y, point.z}) : index_.end();
  if (found == index_.end())
    return std::nullopt;
  if (found->second == several)
    builder.fail_contact(line, "the contact ends where two spheres have their centres");
  return found->second;
}

std::uint32_t CentreIndex::find(const Vec3& point, const PackingBuilder& builder, std::size_t line) const {
  const auto found = look_up(point, builder, line);
  if (!found)
    builder.fail_contact(line, "the contact ends at no centre of a sphere; pairs through periodic faces need "
                               "share/yade/granum_export.py");
  return *found;
}

} // namespace granum::io
