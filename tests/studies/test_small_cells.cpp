// SPDX-License-Identifier: GPL-3.0-or-later
// Cells narrower than two diameters, in which a pair of grains touches through several images.
#include <granum/contact/grains.hpp>

#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/overlaps.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

using namespace granum::samples;

namespace {

const contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};

/// Two unequal grains in a cell, the second off its middle: eight contacts of eight lengths.
packing::Assembly two_grains() {
  packing::Assembly out{.cell = Mat3::diagonal(1e-3, 1.02e-3, 0.98e-3),
                        .position = {{0.1e-3, 0.2e-3, 0.15e-3}, {0.61e-3, 0.69e-3, 0.655e-3}},
                        .radius = {0.47e-3, 0.45e-3},
                        .contacts = {}};
  out.contacts = studies::overlapping_pairs(out, {true, true, true});
  const auto law = contact::PowerLaw::sphere(quartz, contact::pair_radius(out.radius[0], out.radius[1]));
  for (packing::Contact& c : out.contacts)
    c.normal_force = law.force(c.overlap);
  return out;
}

/// What LAMMPS writes of a pair without its line of centres: overlap and force.
io::ImportedPacking through_overlaps(const packing::Assembly& a) {
  std::string contacts = "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n" + std::to_string(a.contacts.size()) +
                         "\n" + dump_box(a, "pp pp pp") + "ITEM: ENTRIES id1 id2 delta force\n";
  for (const packing::Contact& c : a.contacts)
    contacts += std::to_string(c.i + 1) + " " + std::to_string(c.j + 1) + " " +
                words({c.overlap, c.normal_force}, " ") + "\n";
  return io::LammpsDump(io::TextSource::of_text("g", dump_grains(a, 7)),
                        io::TextSource::of_text("c", contacts))
      .next()
      .value();
}

/// Contacts by the number of their image, whatever their order in the file.
void check_same_contacts(const packing::Assembly& read, const packing::Assembly& own) {
  REQUIRE(read.contacts.size() == own.contacts.size());
  for (const packing::Contact& expected : own.contacts) {
    int found = 0;
    for (const packing::Contact& c : read.contacts)
      if (norm(c.branch - expected.branch) < 1e-12 * norm(expected.branch)) {
        ++found;
        CHECK(c.normal_force == relative(expected.normal_force, 1e-11));
        CHECK(norm(c.tangential_force - expected.tangential_force) < 1e-11 * expected.normal_force);
        CHECK(c.overlap == relative(expected.overlap, 1e-11));
      }
    CHECK(found == 1);
  }
}

} // namespace

TEST_CASE("small cells: contacts of a pair through several images come out of files as they were") {
  const packing::Assembly own = two_grains();
  REQUIRE(own.contacts.size() == 8);
  for (const io::ImportedPacking& read :
       {through_csv(own), through_dump(own), through_mercury(own), through_overlaps(own)}) {
    check_same_contacts(read.assembly, own);
    CHECK_FALSE(read.has(io::Finding::duplicated));
  }
}

TEST_CASE("small cells: equal images are taken one after the other, and rows beyond them repeat") {
  packing::Assembly own = two_grains();
  own.position[1] = own.position[0] + Vec3{0.5e-3, 0.51e-3, 0.49e-3}; // all eight lengths are equal
  own.contacts = studies::overlapping_pairs(own, {true, true, true});
  REQUIRE(own.contacts.size() == 8);
  for (packing::Contact& c : own.contacts)
    c.normal_force = 0.01;
  check_same_contacts(through_overlaps(own).assembly, own);
  own.contacts.push_back(own.contacts.back());
  const io::ImportedPacking repeated = through_overlaps(own);
  CHECK(repeated.assembly.contacts.size() == 8);
  CHECK(repeated.has(io::Finding::duplicated));
}

TEST_CASE("small cells: rows without an image, or with two forces for one contact, are refused") {
  const packing::Assembly own = two_grains();
  packing::Assembly longer = own, twice = own;
  longer.contacts[3].branch *= 1.1;
  twice.contacts.push_back(own.contacts[3]);
  twice.contacts.back().normal_force *= 2;
  for (const packing::Assembly& wrong : {longer, twice})
    CHECK_THROWS_AS((void)through_dump(wrong), FileError);
}
