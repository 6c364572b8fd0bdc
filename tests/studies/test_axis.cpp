// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/axis.hpp"

#include <granum/packing/forces.hpp>

#include "read_specimen.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

using namespace granum::samples;
using studies::about_axis;
using studies::Axis;

namespace {

/// The specimen under more stress along z: forces grow with their share of z.
packing::Assembly pressed() {
  packing::Assembly a = specimen();
  for (packing::Contact& c : a.contacts) {
    const double cosine = c.branch.z / norm(c.branch);
    c.normal_force *= 1 + 3 * cosine * cosine;
  }
  return a;
}

Mat3 stress_of(const io::ImportedPacking& packing) {
  return packing::contact_stress(packing.assembly).symmetric;
}

std::size_t warnings(const io::ImportedPacking& packing) {
  return studies::measure_frame(packing, {}, {.force_bins = 32}).warnings.size();
}

} // namespace

TEST_CASE("axis: x and y become z, with the cell and its faces") {
  io::ImportedPacking packing = through_dump(specimen());
  packing.assembly.cell(0, 0) *= 2; // edges of three lengths
  packing.assembly.cell(1, 1) *= 3;
  packing.periodic = {true, false, true};
  const Mat3 s = stress_of(packing);
  for (const auto& [axis, first] : {std::pair(Axis::x, 1), std::pair(Axis::y, 2), std::pair(Axis::z, 0)}) {
    const io::ImportedPacking turned = about_axis(packing, axis);
    const Mat3 t = stress_of(turned);
    for (int i = 0; i < 3; ++i) {
      const int k = (i + first) % 3;
      for (int j = 0; j < 3; ++j) {
        CHECK(t(i, j) == relative(s(k, (j + first) % 3), 1e-12));
        CHECK(turned.assembly.cell(i, j) == packing.assembly.cell(k, (j + first) % 3));
      }
      CHECK(turned.periodic[static_cast<std::size_t>(i)] == packing.periodic[static_cast<std::size_t>(k)]);
    }
    CHECK(determinant(turned.assembly.cell) > 0);
  }
  CHECK((studies::parse_axis("y") == Axis::y && studies::parse_axis("principal") == Axis::principal));
  CHECK_FALSE(studies::parse_axis("w"));
}

TEST_CASE("axis: the principal one is that of the stress") {
  const io::ImportedPacking upright = through_dump(pressed());
  const io::ImportedPacking turned = about_axis(about_axis(upright, Axis::x), Axis::principal);
  const Mat3 s = stress_of(upright), t = stress_of(turned);
  CHECK(t(2, 2) == relative(s(2, 2), 0.02)); // the specimen is not exactly symmetric
  CHECK(std::abs(t(0, 1)) + std::abs(t(0, 2)) + std::abs(t(1, 2)) < 1e-9 * t(2, 2));
  CHECK(trace(t) == relative(trace(s), 1e-12));
  io::ImportedPacking walled = upright, blind = upright;
  walled.periodic = {true, true, false};
  blind.notes.push_back({io::Finding::forces_unknown, ""});
  for (const io::ImportedPacking& refused : {walled, blind})
    CHECK_THROWS_AS((void)about_axis(refused, Axis::principal), InvalidArgument);
}

TEST_CASE("axis: a stress that is not symmetric about z is warned of, with its directions") {
  const io::ImportedPacking upright = through_dump(pressed());
  const io::ImportedPacking lying = about_axis(upright, Axis::x);
  CHECK(studies::measure_frame(lying, {}, {}).triaxial);
  CHECK_FALSE(studies::measure_frame(upright, {}, {}).triaxial);
  CHECK(warnings(lying) == warnings(upright) + 1);
  CHECK(warnings(about_axis(lying, Axis::principal)) == warnings(upright));
}
