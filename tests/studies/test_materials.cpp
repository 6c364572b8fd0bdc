// SPDX-License-Identifier: GPL-3.0-or-later
// Files of LAMMPS with two materials, or with linear springs: the law is found again to the digits that it
// was written with, and what is missing is named.
#include "studies/analyse/materials.hpp"

#include <granum/io/lammps/files.hpp>

#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/overlaps.hpp"
#include "unit.hpp"

using analysis::Given;
using studies::MaterialsByType;

namespace {

const std::string folder = GRANUM_IO_DATA "/";
const MaterialsByType both{{1, {30e9, 0.15}}, {2, {3e9, 0.3}}};

io::ImportedPacking read(const std::string& contacts) {
  io::LammpsDump dump(io::TextSource(folder + "lammps_types.atoms"), io::TextSource(folder + contacts));
  return dump.next().value();
}

Given with_materials(const io::ImportedPacking& packing) {
  Given given{.law_assumed = true};
  given.materials = studies::materials_of(packing, both);
  return given;
}

bool says(const std::vector<std::string>& texts, const std::string& words) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(words) != std::string::npos; });
}

} // namespace

TEST_CASE("materials: types come out of the files, and each grain has one material") {
  io::ImportedPacking packing = read("lammps_types.contacts");
  REQUIRE(packing.type.size() == 64);
  const auto materials = studies::materials_of(packing, both);
  CHECK(std::count(packing.type.begin(), packing.type.end(), 2) > 10);
  for (std::size_t g = 0; g < 64; ++g)
    CHECK(materials[g].shear_modulus == (packing.type[g] == 1 ? 30e9 : 3e9));
  CHECK(studies::materials_of(packing, {}).empty());
  CHECK_THROWS_WITH_AS((void)studies::materials_of(packing, {{1, {30e9, 0.15}}}),
                       doctest::Contains("--material"), InvalidArgument);
  packing.type.clear();
  CHECK_THROWS_AS((void)studies::materials_of(packing, both), InvalidArgument);
}

TEST_CASE("materials: LAMMPS' forces between two materials are those of pair_material") {
  const io::ImportedPacking packing = read("lammps_types.contacts");
  const studies::MeasuredFrame frame = studies::measure_frame(packing, with_materials(packing));
  REQUIRE(frame.packing.law_check);
  CHECK(frame.packing.law_check->worst_misfit < 1e-11);
  CHECK(frame.packing.law_check->coefficient_ratio.value() == relative(1, 1e-11));
  // grains alone have the same forces from their overlaps
  io::ImportedPacking alone = packing;
  alone.assembly.contacts.clear();
  alone.notes = {{io::Finding::contacts_unknown, ""}};
  const io::ImportedPacking again = studies::with_overlap_contacts(alone, with_materials(packing));
  REQUIRE(again.assembly.contacts.size() == packing.assembly.contacts.size());
  for (std::size_t k = 0; k < again.assembly.contacts.size(); ++k)
    CHECK(again.assembly.contacts[k].normal_force ==
          relative(packing.assembly.contacts[k].normal_force, 1e-10));
}

TEST_CASE("materials: the kinds of contacts and their forces reach the closed forms") {
  const io::ImportedPacking packing = read("lammps_types.contacts");
  const effective::State state =
      studies::measure_frame(packing, with_materials(packing)).packing.state.value();
  REQUIRE(state.pair_shares.size() == 3); // the softest pair first
  const packing::Assembly& assembly = packing.assembly;
  const double all = static_cast<double>(assembly.contacts.size());
  double force = 0, uneven = 0, mean = 0;
  std::array<double, 3> count{}, forces{}, work{}, lengths{}, even{};
  for (const packing::Contact& c : assembly.contacts) {
    const auto k = static_cast<std::size_t>(2 - (packing.type[c.i] == 2) - (packing.type[c.j] == 2));
    const double l = norm(c.branch), stiffness = state.pair_shares[k].stiffness;
    ++count[k];
    force += c.normal_force / all;
    forces[k] += c.normal_force;
    uneven += stiffness * std::cbrt(c.normal_force) * (l * l);
    even[k] += stiffness * (l * l);
    work[k] += c.normal_force * l;
    lengths[k] += l;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(state.pair_shares[k].share == relative(count[k] / all, 1e-12));
    CHECK(state.pair_shares[k].force == relative(forces[k] / count[k] / force, 1e-12));
    mean += even[k] * std::cbrt(work[k] / lengths[k]);
  }
  CHECK(state.unevenness.value().value == relative(std::log(uneven / mean), 1e-9));
  // One material for every grain is that material, to the bit.
  Given one{.grain_shear_modulus = 30e9}, each = one;
  each.materials.assign(assembly.grain_count(), {30e9, 0.15});
  const effective::State as_one = studies::measure_frame(packing, one).packing.state.value(),
                         as_each = studies::measure_frame(packing, each).packing.state.value();
  CHECK(as_each.pair_shares.empty());
  CHECK(as_each.unevenness.value().value == as_one.unevenness.value().value);
}

TEST_CASE("materials: without them the cause is named, and Hertz' contacts have k_n = 1.5 f/d") {
  const io::ImportedPacking packing = read("lammps_types.contacts");
  Given known = with_materials(packing), unknown{.law_assumed = true};
  const studies::MeasuredFrame untold = studies::measure_frame(packing, unknown);
  CHECK(says(untold.warnings, "--material"));
  CHECK(says(untold.packing.notes, "1.5 f/d"));
  REQUIRE(untold.packing.law_check);
  CHECK_FALSE(untold.packing.law_check->coefficient_ratio); // of no given modulus
  // the same k_n as of both materials, also where it is asked for; k_t differs by the ratio alone
  known.tangential_ratio = unknown.tangential_ratio = 0.8;
  Given ratio = unknown;
  ratio.stiffness_from = packing::StiffnessFrom::ratio;
  const analysis::Measurement by_materials = studies::measure_frame(packing, known).packing,
                              by_forces = studies::measure_frame(packing, unknown).packing,
                              by_ratio = studies::measure_frame(packing, ratio).packing;
  const auto relaxed = [](const analysis::Measurement& m) {
    return m.solved_network().response.relaxed().matrix;
  };
  for (const analysis::Measurement& m : {by_forces, by_ratio})
    CHECK((relaxed(m) - relaxed(by_materials)).norm() < 1e-9 * relaxed(by_materials).norm());
  // closed forms take nearly the mean of the two materials
  REQUIRE((by_materials.grain && by_forces.grain));
  // also where most contacts are of one pair of types
  io::ImportedPacking few = packing;
  for (packing::Contact& c : few.assembly.contacts) {
    const double radius = few.assembly.radius[c.i];
    const bool second = few.type[c.i] == 2 && few.type[c.j] == 2;
    c.normal_force = (second ? 3e9 : 1e9) * std::sqrt(radius) * std::pow(c.overlap, 1.5);
  }
  CHECK(says(studies::measure_frame(few, unknown).packing.notes, "1.5 f/d"));
  // forces that go otherwise are not taken so
  io::ImportedPacking cones = packing;
  for (packing::Contact& c : cones.assembly.contacts)
    c.normal_force *= std::sqrt(c.overlap / 1e-7);
  CHECK_FALSE(studies::measure_frame(cones, unknown).packing.network);
}

TEST_CASE("materials: linear springs are taken as they are") {
  io::ImportedPacking packing = read("lammps_hooke.contacts");
  const studies::MeasuredFrame frame = studies::measure_frame(packing, {.law_assumed = true});
  CHECK(says(frame.packing.notes, "100000 N/m"));
  REQUIRE(frame.packing.law);
  CHECK(frame.packing.law->stiffness_at_force(0.1) == relative(1e5, 1e-9));
  REQUIRE(frame.packing.network);
  CHECK(says(frame.warnings, "0.9189"));
  const Given given{.law_assumed = true, .tangential_ratio = 2.0 / 7};
  CHECK_FALSE(says(studies::measure_frame(packing, given).warnings, "k_t"));
  io::ImportedPacking stiff = packing;
  for (packing::Contact& c : stiff.assembly.contacts) {
    c.normal_stiffness = 1e5;
    c.tangential_stiffness = 5e4;
  }
  CHECK_FALSE(says(studies::measure_frame(stiff, {.law_assumed = true}).warnings, "k_t"));
  // where the user has said another law, it stays
  const studies::MeasuredFrame said = studies::measure_frame(packing, Given{});
  CHECK_FALSE(said.packing.law);
  CHECK(says(said.warnings, "d^1"));
  CHECK(analysis::linear_spring(packing.assembly));
  // overlaps that are all alike show no springs
  for (packing::Contact& c : packing.assembly.contacts) {
    c.overlap = 1e-6;
    c.normal_force = 0.1;
  }
  CHECK_FALSE(analysis::linear_spring(packing.assembly));
}
