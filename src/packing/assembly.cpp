// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/assembly.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/packing/forces.hpp>

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

namespace {

std::vector<std::uint32_t> numbers_of_bodies(const Assembly& assembly) {
  if (!assembly.body.empty())
    return assembly.body;
  std::vector<std::uint32_t> own(assembly.grain_count());
  std::iota(own.begin(), own.end(), 0U);
  return own;
}

/// A difference of positions as short as images along the edges make it.
Vec3 nearest(const Mat3& cell, const Mat3& to_parts, Vec3 difference) {
  const Vec3 part = to_parts * difference;
  for (int k = 0; k < 3; ++k)
    if (const double turns = std::round(part[k]); turns != 0)
      difference -= turns * column(cell, k);
  return difference;
}

void place_bodies(const Assembly& assembly, const std::vector<std::uint32_t>& body, Bodies& out) {
  const std::size_t count = body.empty() ? 0 : std::size_t{*std::max_element(body.begin(), body.end())} + 1;
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> first(count, none);
  std::vector<double> volume(count);
  std::vector<Vec3> moment(count);
  const Mat3 to_parts = inverse_of(assembly.cell);
  for (std::size_t g = 0; g < body.size(); ++g) {
    const std::uint32_t b = body[g];
    if (first[b] == none)
      first[b] = g;
    out.offset[g] = nearest(assembly.cell, to_parts, assembly.position[g] - assembly.position[first[b]]);
    const double own = assembly.radius[g] * assembly.radius[g] * assembly.radius[g];
    volume[b] += own;
    moment[b] += own * out.offset[g];
  }
  for (std::size_t b = 0; b < count; ++b) {
    moment[b] *= 1 / volume[b];
    out.assembly.position.push_back(assembly.position[first[b]] + moment[b]);
    out.assembly.radius.push_back(std::cbrt(volume[b]));
  }
  for (std::size_t g = 0; g < body.size(); ++g)
    out.offset[g] -= moment[body[g]];
}

/// The same force on another branch.
void set_branch(Contact& c, const Vec3& branch) {
  const Vec3 whole = force(c);
  c.branch = branch;
  c.normal_force = dot(whole, normal(c));
  c.tangential_force = whole - c.normal_force * normal(c);
}

Contact turned(Contact c) {
  std::swap(c.i, c.j);
  c.branch = -c.branch;
  c.tangential_force = -c.tangential_force;
  return c;
}

[[noreturn]] void refuse_image(std::uint32_t body) {
  throw InvalidArgument("body " + std::to_string(body) +
                        " touches its own image: the cell is too narrow for it");
}

} // namespace

Bodies bodies(const Assembly& assembly) {
  require_valid(assembly);
  const std::vector<std::uint32_t> body = numbers_of_bodies(assembly);
  Bodies out;
  out.assembly.cell = assembly.cell;
  out.offset.resize(body.size());
  place_bodies(assembly, body, out);
  std::vector<std::pair<Contact, std::size_t>> found;
  for (std::size_t k = 0; k < assembly.contacts.size(); ++k) {
    Contact c = assembly.contacts[k];
    const Vec3 between = out.offset[c.j] - out.offset[c.i], apart = c.branch - between;
    c.i = body[c.i];
    c.j = body[c.j];
    if (c.i == c.j && norm(apart) > 0.5 * norm(c.branch))
      refuse_image(c.i);
    if (c.i == c.j)
      continue;
    set_branch(c, apart);
    found.emplace_back(c.i < c.j ? c : turned(c), k);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first.i, a.first.j) < std::tie(b.first.i, b.first.j);
  });
  for (const auto& [contact, number] : found) {
    out.assembly.contacts.push_back(contact);
    out.contact.push_back(number);
  }
  for (Contact c : assembly.wall_contacts) {
    set_branch(c, out.offset[c.i] + c.branch);
    c.i = body[c.i];
    out.assembly.wall_contacts.push_back(c);
  }
  return out;
}

double solid_fraction(const Assembly& assembly) {
  require_valid(assembly);
  double cubes = 0;
  for (const double radius : assembly.radius)
    cubes += radius * radius * radius;
  return 4 * std::numbers::pi / 3 * cubes / assembly.volume();
}

double void_ratio(const Assembly& assembly) {
  const double solid = solid_fraction(assembly);
  if (assembly.grain_count() == 0)
    throw InvalidArgument("void_ratio: the assembly has no grains");
  return 1 / solid - 1;
}

Weight common_weight(const Assembly& assembly) {
  const std::vector<Residual> left = residuals(assembly);
  std::vector<bool> touches(assembly.grain_count());
  for (const Contact& c : assembly.contacts)
    touches[c.i] = touches[c.j] = true;
  for (const Contact& c : assembly.wall_contacts)
    touches[c.i] = true;
  const auto volume = [&](std::size_t g) {
    const double radius = assembly.radius[g];
    return 4 * std::numbers::pi / 3 * radius * radius * radius;
  };
  Vec3 force{};
  double squares = 0;
  for (std::size_t g = 0; g < left.size(); ++g)
    if (touches[g]) {
      force += volume(g) * left[g].force;
      squares += volume(g) * volume(g);
    }
  if (!(squares > 0))
    return {};
  Weight weight{.per_volume = (-1 / squares) * force};
  double with = 0, without = 0;
  for (std::size_t g = 0; g < left.size(); ++g)
    if (touches[g]) {
      with += norm(left[g].force);
      without += norm(left[g].force + volume(g) * weight.per_volume);
    }
  if (with > 0)
    weight.left_over = without / with;
  return weight;
}

} // namespace granum::packing
