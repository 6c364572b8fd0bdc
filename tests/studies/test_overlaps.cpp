// SPDX-License-Identifier: GPL-3.0-or-later
// A packing whose contacts are thrown away has them again, from the positions and radii of its grains.
#include "studies/analyse/overlaps.hpp"

#include <random>

#include "read_specimen.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

using namespace granum::samples;
using analysis::Given;
using io::Finding;

namespace {

constexpr std::array<bool, 3> everywhere{true, true, true};

io::ImportedPacking grains_alone(const packing::Assembly& a) {
  io::LammpsDump dump(io::TextSource::of_text("grains", dump_grains(a, 7)));
  return dump.next().value();
}

/// Pairs of a packing in the nearest images, all of them looked at.
std::size_t pairs_by_all_images(const packing::Assembly& a, const std::vector<packing::Contact>& found,
                                const std::array<double, 3>& reach) {
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < a.position.size(); ++i)
    for (std::uint32_t j = i + 1; j < a.position.size(); ++j)
      for (double x = -reach[0]; x <= reach[0]; ++x)
        for (double y = -reach[1]; y <= reach[1]; ++y)
          for (double z = -reach[2]; z <= reach[2]; ++z) {
            const Vec3 branch = a.position[j] + a.cell * Vec3{x, y, z} - a.position[i];
            if (norm(branch) >= a.radius[i] + a.radius[j])
              continue;
            ++pairs;
            CHECK(std::ranges::any_of(found, [&](const packing::Contact& c) {
              return c.i == i && c.j == j && norm(c.branch - branch) < 1e-12;
            }));
          }
  return pairs;
}

} // namespace

TEST_CASE("overlaps: the contacts of a specimen come back from its grains") {
  const packing::Assembly& a = specimen();
  const auto found = studies::overlapping_pairs(a, everywhere);
  REQUIRE(found.size() == a.contacts.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const packing::Contact &c = found[k], &own = a.contacts[k];
    CHECK((c.i == own.i && c.j == own.j));
    CHECK(norm(c.branch - own.branch) <= 1e-12 * norm(own.branch));
    CHECK(std::abs(c.overlap - own.overlap) <= 1e-12 * specimen_radius);
  }
}

TEST_CASE("overlaps: pairs reach through periodic faces alone") {
  packing::Assembly a{
      .cell = Mat3::diagonal(10, 10, 10),
      .position = {{0.2, 5, 5}, {9.7, 5, 5}, {5, 0.2, 5}, {5, 9.7, 5}, {5, 5, 0.2}, {5, 5, 9.7}},
      .radius = {0.5, 0.3, 0.5, 0.3, 0.5, 0.3},
      .contacts = {}};
  for (int flags = 0; flags < 8; ++flags) {
    const std::array<bool, 3> periodic{(flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0};
    std::vector<packing::Contact> found = studies::overlapping_pairs(a, periodic);
    std::ranges::sort(found, {}, &packing::Contact::i);
    for (int axis = 0, k = 0; axis < 3; ++axis)
      if (periodic[static_cast<std::size_t>(axis)]) {
        REQUIRE(found.size() > static_cast<std::size_t>(k));
        const packing::Contact& c = found[static_cast<std::size_t>(k++)];
        CHECK(norm(c.branch - Vec3{axis == 0 ? -0.5 : 0, axis == 1 ? -0.5 : 0, axis == 2 ? -0.5 : 0}) <
              1e-12);
        CHECK(c.overlap == relative(0.3, 1e-12));
      }
    CHECK(found.size() == static_cast<std::size_t>(std::ranges::count(periodic, true)));
  }
  CHECK(studies::overlapping_pairs({.cell = a.cell, .position = {}, .radius = {}, .contacts = {}}, everywhere)
            .empty());
}

TEST_CASE("overlaps: a narrow oblique cell has the pairs that a look at every image finds") {
  packing::Assembly a{
      .cell = {{{9, 0.7, 0.4}, {0, 3.1, 0.5}, {0, 0, 2.3}}}, .position = {}, .radius = {}, .contacts = {}};
  std::mt19937_64 bits(5);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(bits() >> 11), -53); };
  for (int k = 0; k < 40; ++k) {
    a.position.push_back(a.cell * Vec3{uniform(), uniform(), uniform()});
    a.radius.push_back(0.3 + 0.5 * uniform());
  }
  const auto found = studies::overlapping_pairs(a, {true, true, false});
  CHECK(found.size() > 40);
  CHECK(found.size() == pairs_by_all_images(a, found, {1, 1, 0}));
}

TEST_CASE("overlaps: a chain of 20,001 grains in a narrow cell") {
  constexpr std::size_t count = 20001;
  constexpr double spacing = 1.998;
  packing::Assembly a{.cell = Mat3::diagonal(spacing * count, 3.9, 3.9),
                      .position = {},
                      .radius = std::vector<double>(count, 1.0),
                      .contacts = {}};
  for (std::size_t k = 0; k < count; ++k)
    a.position.push_back({spacing * (static_cast<double>(k) + 0.5), 1.9, 1.9});
  CHECK(studies::overlapping_pairs(a, everywhere).size() == count);
}

TEST_CASE("overlaps: with the material, forces and moduli are those of the specimen") {
  const packing::Assembly& a = specimen();
  const Given given{.grain_shear_modulus = specimen_grain.shear_modulus};
  const io::ImportedPacking packing = studies::with_overlap_contacts(grains_alone(a), given);
  CHECK(packing.has(Finding::contacts_from_overlaps));
  CHECK(packing.has(Finding::tangential_unknown));
  CHECK_FALSE(packing.has(Finding::forces_unknown));
  for (std::size_t k = 0; k < a.contacts.size(); ++k)
    CHECK(std::abs(packing.assembly.contacts[k].normal_force - a.contacts[k].normal_force) <=
          1e-6 * a.contacts[k].normal_force);
  const studies::MeasuredFrame frame = studies::measure_frame(packing, given);
  const studies::MeasuredFrame whole = studies::measure_frame(through_dump(a), given);
  CHECK(frame.contacts_known);
  CHECK_FALSE(frame.packing.law_check);
  CHECK(frame.packing.network->G_vh() == relative(whole.packing.network->G_vh(), 1e-6));
  CHECK(frame.packing.counts.mechanical.coordination_number ==
        whole.packing.counts.mechanical.coordination_number);
  CHECK(frame.warnings.size() == 1);
}

TEST_CASE("overlaps: without a material there are contacts and no forces") {
  const studies::MeasuredFrame frame =
      studies::measure_frame(studies::with_overlap_contacts(grains_alone(specimen()), {}));
  CHECK(frame.contacts_known);
  CHECK(frame.packing.counts.coordination_number > 4);
  CHECK(frame.packing.fabric);
  CHECK_FALSE((frame.packing.stress || frame.packing.forces || frame.packing.network));
  CHECK_FALSE(frame.warnings.empty());
}

TEST_CASE(
    "overlaps: grains that do not overlap leave the contacts unknown, and known ones stay as they are") {
  packing::Assembly a = specimen();
  for (double& radius : a.radius)
    radius *= 0.9;
  const io::ImportedPacking packing = studies::with_overlap_contacts(grains_alone(a), {});
  CHECK(packing.assembly.contacts.empty());
  const studies::MeasuredFrame frame = studies::measure_frame(packing);
  CHECK_FALSE(frame.contacts_known);
  CHECK_FALSE(frame.warnings.empty());
  const io::ImportedPacking whole = through_dump(specimen());
  CHECK(studies::with_overlap_contacts(whole, {}).assembly == whole.assembly);
  CHECK(studies::measure_frame(whole).contacts_known);
}

TEST_CASE("overlaps: one boulder among small grains meets those that it overlaps, in cells of any width") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 1);
  packing::Assembly a{
      .cell = Mat3::diagonal(0.9, 1, 1.1), .position = {{0.5, 0.5, 0.5}}, .radius = {0.3}, .contacts = {}};
  for (int k = 0; k < 500; ++k) {
    a.position.push_back({0.9 * place(random), place(random), 1.1 * place(random)});
    a.radius.push_back(0.005);
  }
  const auto found = studies::overlapping_pairs(a, everywhere);
  CHECK(found.size() == pairs_by_all_images(a, found, {1, 1, 1}));
}

TEST_CASE("overlaps: a grain that reaches its own image, and a grain twice at one place, are named") {
  io::ImportedPacking one;
  one.id = {1};
  one.assembly = {
      .cell = Mat3::diagonal(1, 1, 1), .position = {{0, 0, 0}}, .radius = {0.5 * (1 + 1e-7)}, .contacts = {}};
  one.notes.push_back({Finding::contacts_unknown, ""});
  const io::ImportedPacking lattice = studies::with_overlap_contacts(one, {.grain_shear_modulus = 30e9});
  CHECK(lattice.has(Finding::own_image));
  CHECK(lattice.assembly.contacts.size() == 3 * lattice.assembly.grain_count());
  io::ImportedPacking twice = one;
  twice.id = {1, 2};
  twice.assembly.cell = Mat3::diagonal(3, 3, 3);
  twice.assembly.position.push_back(twice.assembly.position.front());
  twice.assembly.radius.push_back(0.4);
  CHECK(std::ranges::any_of(studies::measure_frame(twice).warnings, [](const std::string& w) {
    return w.find("1 and 2") != std::string::npos; // their ids
  }));
}
