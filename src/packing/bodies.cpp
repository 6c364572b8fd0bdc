// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/bodies.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include <granum/core/error.hpp>

namespace granum::packing {

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

} // namespace granum::packing
