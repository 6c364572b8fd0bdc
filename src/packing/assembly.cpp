// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/assembly.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>

namespace granum::packing {

namespace {

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

[[noreturn]] void reject(const char* what, std::size_t index, const char* rule) {
  throw InvalidArgument(std::string(what) + " " + std::to_string(index) + ": " + rule);
}

void require_valid(const char* kind, std::size_t index, const Contact& c) {
  if (!finite(c.branch) || !(norm(c.branch) > 0))
    reject(kind, index, "its branch vector must be finite and not zero");
  if (!std::isfinite(c.normal_force) || !finite(c.tangential_force))
    reject(kind, index, "its force is not finite");
  if (!(c.normal_stiffness >= 0) || !std::isfinite(c.normal_stiffness) || !(c.tangential_stiffness >= 0) ||
      !std::isfinite(c.tangential_stiffness))
    reject(kind, index, "its stiffnesses must be finite and not negative");
  if (!(c.rolling_stiffness >= 0) || !std::isfinite(c.rolling_stiffness) || !(c.twisting_stiffness >= 0) ||
      !std::isfinite(c.twisting_stiffness))
    reject(kind, index, "its rolling and twisting stiffness must be finite and not negative");
}

/// Every number from 0 to the largest has a grain.
void require_bodies(const std::vector<std::uint32_t>& body, std::size_t grains) {
  if (body.empty())
    return;
  if (body.size() != grains)
    throw InvalidArgument("assembly: " + std::to_string(grains) + " grains but " +
                          std::to_string(body.size()) + " numbers of bodies");
  std::vector<bool> has_grain(grains);
  std::size_t bodies = 0;
  for (std::size_t g = 0; g < grains; ++g) {
    if (body[g] >= grains)
      reject("grain", g, "its body must have a number below that of grains");
    bodies = std::max(bodies, std::size_t{body[g]} + 1);
    has_grain[body[g]] = true;
  }
  for (std::size_t b = 0; b < bodies; ++b)
    if (!has_grain[b])
      reject("body", b, "needs a grain: bodies are numbered without gaps");
}

} // namespace

void require_valid(const Assembly& assembly) {
  const std::size_t n = assembly.grain_count();
  if (assembly.radius.size() != n)
    throw InvalidArgument("assembly: " + std::to_string(n) + " positions but " +
                          std::to_string(assembly.radius.size()) + " radii");
  if (!(assembly.volume() > 0) || !std::isfinite(assembly.volume()))
    throw InvalidArgument("cell volume", assembly.volume(), "m^3", "(0, inf)");
  for (std::size_t g = 0; g < n; ++g) {
    stop_point(g);
    if (!finite(assembly.position[g]))
      reject("grain", g, "its position is not finite");
    if (!(assembly.radius[g] > 0) || !std::isfinite(assembly.radius[g]))
      reject("grain", g, "its radius must be finite and positive");
  }
  require_bodies(assembly.body, n);
  for (std::size_t k = 0; k < assembly.contacts.size(); ++k) {
    stop_point(k);
    const Contact& c = assembly.contacts[k];
    if (!(c.i < c.j) || c.j >= n)
      reject("contact", k, "needs grain indices i < j < number of grains");
    require_valid("contact", k, c);
  }
  for (std::size_t k = 0; k < assembly.wall_contacts.size(); ++k) {
    if (assembly.wall_contacts[k].i >= n)
      reject("wall contact", k, "needs a grain index i < number of grains");
    require_valid("wall contact", k, assembly.wall_contacts[k]);
  }
}

Vec3 cell_widths(const Mat3& cell) {
  const double volume = determinant(cell);
  Vec3 widths;
  for (int k = 0; k < 3; ++k)
    widths[k] = volume / norm(cross(column(cell, (k + 1) % 3), column(cell, (k + 2) % 3)));
  return widths;
}

} // namespace granum::packing
