// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/profile.hpp>

#include "packing/sample_packings.hpp"
#include "unit.hpp"

using namespace granum::analysis;

namespace {

/// A disordered periodic network of unequal grains in an upright cell, with forces.
packing::Assembly upright() {
  samples::Uniform uniform(7);
  packing::Assembly a = samples::lattice(samples::face_centred, {.repeats = 4});
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    a.position[g] = a.position[g] + uniform.vector(0.1);
    a.radius[g] = uniform(0.35, 0.55);
  }
  a.contacts.clear();
  samples::connect(a, 1.15);
  for (packing::Contact& c : a.contacts) {
    c.normal_force = uniform(0.5, 2);
    const Vec3 push = uniform.vector(0.3);
    c.tangential_force = push - dot(push, normal(c)) * normal(c);
  }
  return a;
}

Window whole_of(const packing::Assembly& a) {
  return {.low = {}, .high = {a.cell(0, 0), a.cell(1, 1), a.cell(2, 2)}};
}

Measurement measured(const packing::Assembly& a) {
  return measure(a, {.grain_shear_modulus = 1e4}, {.closed_forms = true});
}

} // namespace

TEST_CASE("slices of a periodic packing add up to its stress, its solids, its grains and their contacts") {
  const packing::Assembly a = upright();
  const Measurement whole = measured(a);
  double solid = 0;
  Mat3 forces{};
  for (const double r : a.radius)
    solid += 4.0 / 3 * std::numbers::pi * r * r * r;
  for (const packing::Contact& c : a.contacts)
    forces += outer(force(c), c.branch);
  const double area[] = {a.volume() / a.cell(0, 0), a.volume() / a.cell(1, 1), a.volume() / a.cell(2, 2)};
  for (const int axis : {0, 1, 2})
    for (const std::size_t slices : {std::size_t{1}, std::size_t{7}, std::size_t{40}}) {
      CAPTURE(axis);
      CAPTURE(slices);
      double solids = 0, ends = 0;
      std::size_t grains = 0;
      Mat3 sum{};
      for (const Slice& slice : profile(a, whole, whole_of(a), axis, slices)) {
        const double volume = area[axis] * (slice.high - slice.low);
        solids += volume * slice.solid_fraction;
        sum += volume * slice.part.stress;
        grains += slice.part.grains;
        ends += slice.part.micro.coordination_number * static_cast<double>(slice.part.grains);
      }
      CHECK(solids == relative(solid, 1e-10));
      CHECK(grains == a.grain_count());
      CHECK(ends == relative(2.0 * static_cast<double>(a.contacts.size()), 1e-12));
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          CHECK(std::abs(sum(i, k) - forces(i, k)) <= 1e-12 * trace(forces));
    }
}

TEST_CASE("the stress of a slice is that of points spread along every branch") {
  const packing::Assembly a = upright();
  const std::vector<Slice> slices = profile(a, measured(a), whole_of(a), 2, 5);
  const Slice& slice = slices[2];
  constexpr int points = 2000;
  Mat3 sum{};
  for (const packing::Contact& c : a.contacts) {
    int inside = 0;
    for (int k = 0; k < points; ++k) {
      const double z = a.position[c.i].z + (k + 0.5) / points * c.branch.z;
      const double home = z - a.cell(2, 2) * std::floor(z / a.cell(2, 2));
      inside += home >= slice.low && home < slice.high;
    }
    sum += static_cast<double>(inside) / points * outer(force(c), c.branch);
  }
  const double volume = a.volume() / 5;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(std::abs(sum(i, k) / volume - slice.part.stress(i, k)) < 1e-3 * trace(slice.part.stress));
}

TEST_CASE("one slice has the rung 3 of the whole, and air has nothing") {
  packing::Assembly a = upright();
  const Measurement whole = measured(a);
  const std::vector<Slice> one = profile(a, whole, whole_of(a), 2, 1);
  REQUIRE(whole.closed_form(effective::RungName::relaxed));
  REQUIRE(one.front().relaxed);
  CHECK(one.front().relaxed->stiffness.G_vh() ==
        relative(whole.closed_form(effective::RungName::relaxed)->stiffness.G_vh(), 1e-9));

  a.cell(2, 2) *= 3; // air above, not to be looked for across the face
  std::erase_if(a.contacts, [&](const packing::Contact& c) {
    return std::abs(a.position[c.i].z + c.branch.z - a.position[c.j].z) > 1e-9;
  });
  const Slice top = profile(a, measured(a), whole_of(a), 2, 3)[1];
  CHECK(top.part.grains == 0);
  CHECK(top.part.micro.coordination_number == 0);
  CHECK(top.part.stress(2, 2) == 0);
  CHECK_FALSE(top.relaxed);
}

TEST_CASE("profiles of impossible axes and slices are refused") {
  const packing::Assembly a = upright();
  const Measurement whole = measured(a);
  Window wide = whole_of(a);
  wide.high.x *= 1.5;
  CHECK_THROWS_AS((void)profile(a, whole, whole_of(a), 3, 4), InvalidArgument);
  CHECK_THROWS_AS((void)profile(a, whole, whole_of(a), -1, 4), InvalidArgument);
  CHECK_THROWS_AS((void)profile(a, whole, whole_of(a), 2, 0), InvalidArgument);
  CHECK_THROWS_AS((void)profile(a, whole, wide, 2, 4), InvalidArgument);
}
