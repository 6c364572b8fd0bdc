// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/grain_fields.hpp"

#include <sstream>

#include <granum/analysis/rearrangement.hpp>
#include <granum/packing/forces.hpp>

#include "packing/sample_packings.hpp"
#include "unit.hpp"

namespace {

const io::GrainField& field(const std::vector<io::GrainField>& all, const std::string& name) {
  for (const io::GrainField& one : all)
    if (one.name == name)
      return one;
  throw InvalidArgument("no field " + name);
}

} // namespace

TEST_CASE("fields of grains: those of known forces, and displacements of grains or of their bodies") {
  io::ImportedPacking packing;
  packing.assembly = samples::random_network({.seed = 1, .repeats = 2});
  const std::size_t grains = packing.assembly.grain_count();
  const network::StrainMotions motions =
      network::linear_response(packing.assembly, {.motions = true}).motions();
  const auto all = studies::grain_fields(packing, motions);
  CHECK(all.size() == 5 + 6);
  const std::vector<Mat3> stress = grain_stresses(packing.assembly);
  for (std::size_t g = 0; g < grains; ++g) {
    CHECK(field(all, "grain_stress").values[9 * g + 5] == stress[g](1, 2));
    CHECK(field(all, "pressure").values[g] == trace(stress[g]) / 3);
    CHECK(field(all, "nonaffine_23").values[3 * g + 1] == motions[3][g].displacement.y);
  }
  packing.notes.push_back({io::Finding::tangential_unknown, ""});
  CHECK(studies::grain_fields(packing, {}).size() == 4); // no stress
  packing.notes.push_back({io::Finding::forces_unknown, ""});
  CHECK(studies::grain_fields(packing, {}).size() == 3); // no pressure
  for (std::uint32_t g = 0; g < grains; ++g)
    packing.assembly.body.push_back(g == 0 ? 0 : g - 1);
  const auto of_bodies =
      studies::grain_fields(packing, network::linear_response(packing.assembly, {.motions = true}).motions());
  CHECK(field(of_bodies, "nonaffine_11").values[0] == field(of_bodies, "nonaffine_11").values[3]);
  CHECK(field(of_bodies, "nonaffine_11").values[0] != field(of_bodies, "nonaffine_11").values[6]);
}

TEST_CASE("D2min between two frames goes by the ids of the grains, of those that are in both") {
  io::ImportedPacking before, after;
  before.assembly = after.assembly = samples::random_network({.seed = 1, .repeats = 2});
  const std::size_t grains = before.assembly.grain_count();
  for (std::size_t g = 0; g < grains; ++g)
    before.id.push_back(static_cast<long>(2 * g));
  after.id = before.id;
  after.assembly.position[4] += (0.1 * after.assembly.radius[4]) * Vec3{1, 1, 0};
  const std::vector<double> all = studies::d2min(before, after);
  CHECK(field(studies::grain_fields(after, {}, &before), "D2min").values == all);
  CHECK(std::max_element(all.begin(), all.end()) - all.begin() == 4);
  // Neighbours are pairs of centres within 1.5 sums of radii, whatever touches.
  packing::Assembly wide = before.assembly;
  wide.contacts.clear();
  samples::connect(wide, 1.5);
  const std::vector<double> by_hand = analysis::d2min(before.assembly, after.assembly, wide.contacts);
  for (std::size_t g = 0; g < grains; ++g)
    CHECK(std::abs(all[g] - by_hand[g]) <= 1e-12 * all[4]);
  CHECK(studies::d2min(before, after, 1.1) != all);
  io::ImportedPacking turned = after; // its grains in the reverse order
  turned.assembly.contacts.clear();
  std::ranges::reverse(turned.id);
  std::ranges::reverse(turned.assembly.position);
  std::ranges::reverse(turned.assembly.radius);
  const std::vector<double> reversed = studies::d2min(before, turned);
  for (std::size_t g = 0; g < grains; ++g)
    CHECK(std::abs(reversed[grains - 1 - g] - all[g]) <= 1e-12 * all[4]);

  io::ImportedPacking later = after; // a grain came, and another went
  later.assembly.contacts.clear();
  later.id.front() = -5;
  const std::vector<double> partly = studies::d2min(before, later);
  CHECK(partly[0] == 0);
  CHECK(partly[4] > 0);
  for (long& id : later.id)
    id = 2 * id + 1;
  CHECK(studies::d2min(before, later) == std::vector<double>(grains, 0.0));
  CHECK_THROWS_AS((void)studies::d2min(before, after, 0.5), InvalidArgument);
}

TEST_CASE("extended XYZ: cell, faces, columns and grains") {
  const packing::Assembly a{.cell = {{{4, 1, 0}, {0, 5, 0}, {0, 0, 6}}},
                            .position = {{1.0 / 3, 2, 3}, {4, 5, 6}},
                            .radius = {0.5, 0.25},
                            .contacts = {}};
  const std::vector<io::GrainField> fields{{.name = "push", .components = 2, .values = {1, 2, 3, 4}},
                                           {.name = "kind", .values = {0, 1}, .whole = true}};
  CHECK(
      io::grains_xyz(a, {true, true, false}, fields, std::vector<long>{7, 9}, 0.5) ==
      "2\nLattice=\"4 0 0 1 5 0 0 0 6\" pbc=\"T T F\" Properties=id:I:1:pos:R:3:push:R:2:kind:I:1 Time=0.5\n"
      "7 0.3333333333333333 2 3 1 2 0\n9 4 5 6 3 4 1\n");
  CHECK_THROWS_AS((void)io::grains_xyz(a, {}, fields, std::vector<long>{1}), InvalidArgument);
  CHECK_THROWS_AS((void)io::grains_xyz(a, {}, std::vector<io::GrainField>{{.name = "short"}}),
                  InvalidArgument);
}
