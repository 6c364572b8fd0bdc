// SPDX-License-Identifier: GPL-3.0-or-later
// Cells narrower than two diameters, in which a pair of grains touches through several images.
#include <map>

#include <granum/contact/grains.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/packing/assembly.hpp>

#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/overlaps.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

using namespace granum::samples;

namespace {

const contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};

/// Two unequal grains in a leaning cell, the second off its middle: eight contacts of eight lengths.
packing::Assembly two_grains() {
  packing::Assembly out{.cell = Mat3::diagonal(1e-3, 1.02e-3, 0.98e-3),
                        .position = {{0.1e-3, 0.2e-3, 0.15e-3}, {0.61e-3, 0.69e-3, 0.655e-3}},
                        .radius = {0.47e-3, 0.45e-3},
                        .contacts = {}};
  out.cell(0, 1) = 0.03e-3;
  out.contacts = studies::overlapping_pairs(out, {true, true, true});
  for (packing::Contact& c : out.contacts) {
    const auto law =
        contact::PowerLaw::sphere(quartz, contact::pair_radius(out.radius[c.i], out.radius[c.j]));
    c.normal_force = law.force(c.overlap);
    const Vec3 across = cross(normal(c), Vec3{0.3, 0.5, 0.7});
    c.tangential_force = 0.2 * c.normal_force * across;
  }
  return out;
}

/// Copies of a periodic packing side by side, two along each edge.
packing::Assembly twice(const packing::Assembly& one) {
  constexpr int copies = 2;
  const Mat3 to_parts = inverse_of(one.cell);
  packing::Assembly out{.cell = one.cell, .position = {}, .radius = {}, .contacts = {}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      out.cell(i, j) *= copies;
  const auto place = [&](std::uint32_t grain, int x, int y, int z) {
    const auto turn = [](int k) { return ((k % copies) + copies) % copies; };
    return static_cast<std::uint32_t>(((turn(x) * copies + turn(y)) * copies + turn(z)) *
                                          static_cast<int>(one.grain_count()) +
                                      static_cast<int>(grain));
  };
  for (int x = 0; x < copies; ++x)
    for (int y = 0; y < copies; ++y)
      for (int z = 0; z < copies; ++z) {
        const Vec3 shift = one.cell * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
        for (std::size_t g = 0; g < one.grain_count(); ++g) {
          out.position.push_back(one.position[g] + shift);
          out.radius.push_back(one.radius[g]);
        }
        for (packing::Contact c : one.contacts) {
          const Vec3 through = to_parts * (c.branch - (one.position[c.j] - one.position[c.i]));
          const auto step = [](double part) { return static_cast<int>(std::lround(part)); };
          c.j = place(c.j, x + step(through.x), y + step(through.y), z + step(through.z));
          c.i = place(c.i, x, y, z);
          if (c.i > c.j) {
            std::swap(c.i, c.j);
            c.branch = -c.branch;
            c.tangential_force = -c.tangential_force;
          }
          out.contacts.push_back(c);
        }
      }
  std::stable_sort(out.contacts.begin(), out.contacts.end(),
                   [](const auto& a, const auto& b) { return std::pair(a.i, a.j) < std::pair(b.i, b.j); });
  return out;
}

elastic::Matrix6 relaxed(const packing::Assembly& packing) {
  return network::linear_response(packing).relaxed().matrix;
}

/// A table of contacts with normals instead of lines of centres, or without overlaps.
io::ImportedPacking through_normals(const packing::Assembly& a) {
  std::string contacts = "# units: SI\nid1,id2,nx,ny,nz,fx,fy,fz\n";
  for (const packing::Contact& c : a.contacts) {
    const Vec3 n = normal(c), f = force(c);
    contacts += std::to_string(c.i) + "," + std::to_string(c.j) + "," +
                words({n.x, n.y, n.z, f.x, f.y, f.z}, ",") + "\n";
  }
  return io::read_packing_csv(io::TextSource::of_text("g", csv_grains(a)),
                              io::TextSource::of_text("c", contacts), {.box = io::CsvBox{a.cell}});
}

/// What LAMMPS writes of a pair without its line of centres: overlap and force, and the vector where asked.
io::ImportedPacking through_overlaps(const packing::Assembly& a, bool vectors) {
  std::string contacts = "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n" + std::to_string(a.contacts.size()) +
                         "\n" + dump_box(a, "pp pp pp") + "ITEM: ENTRIES id1 id2 delta force" +
                         (vectors ? " fx fy fz\n" : "\n");
  for (const packing::Contact& c : a.contacts) {
    const Vec3 f = -force(c);
    contacts += std::to_string(c.i + 1) + " " + std::to_string(c.j + 1) + " " +
                words({c.overlap, c.normal_force}, " ") + (vectors ? " " + words({f.x, f.y, f.z}, " ") : "") +
                "\n";
  }
  io::LammpsDump dump(io::TextSource::of_text("g", dump_grains(a, 7)),
                      io::TextSource::of_text("c", contacts));
  return dump.next().value();
}

/// The same cell upright, for formats that know no other.
packing::Assembly upright() {
  packing::Assembly out = two_grains();
  out.cell(0, 1) = 0;
  out.contacts = studies::overlapping_pairs(out, {true, true, true});
  for (packing::Contact& c : out.contacts)
    c.normal_force = contact::PowerLaw::sphere(quartz, contact::pair_radius(out.radius[0], out.radius[1]))
                         .force(c.overlap);
  return out;
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

TEST_CASE("small cells: two grains in a cell are eight copies of them in eight cells") {
  packing::Assembly one = two_grains();
  REQUIRE(one.contacts.size() == 8);
  assign_hertz_stiffness(one, quartz, 0.9);
  const packing::Assembly eight = twice(one);
  CHECK(eight.grain_count() == 16);
  CHECK(eight.contacts.size() == 64);
  CHECK(void_ratio(eight) == relative(void_ratio(one), 1e-13));
  const elastic::Matrix6 affine = network::linear_response(one).affine().matrix;
  CHECK((network::linear_response(eight).affine().matrix - affine).norm() < 1e-13 * affine.norm());
  CHECK((relaxed(eight) - relaxed(one)).norm() < 1e-9 * affine.norm());
  CHECK((relaxed(one) - affine).norm() > 1e-3 * affine.norm()); // the grains do move against the mean strain
  CHECK(coordination_number(one) == 8);
  CHECK(mechanical_coordination(one, packing::ContactKind::frictional).coordination_number == 8);
}

TEST_CASE("small cells: contacts of a pair through several images come out of files as they were") {
  const packing::Assembly own = upright();
  REQUIRE(own.contacts.size() == 8);
  check_same_contacts(through_csv(own).assembly, own);
  check_same_contacts(through_dump(own).assembly, own);
  check_same_contacts(through_vtk(own).assembly, own);
  check_same_contacts(through_mercury(own).assembly, own);
  check_same_contacts(through_normals(own).assembly, own);
  check_same_contacts(through_overlaps(own, true).assembly, own);
  check_same_contacts(through_overlaps(own, false).assembly, own);
  CHECK_FALSE(through_csv(own).has(io::Finding::duplicated));
}

TEST_CASE("small cells: equal images are taken one after the other, and rows beyond them repeat") {
  packing::Assembly own = upright();
  own.position[1] = own.position[0] + Vec3{0.5e-3, 0.51e-3, 0.49e-3}; // all eight lengths are equal
  own.contacts = studies::overlapping_pairs(own, {true, true, true});
  REQUIRE(own.contacts.size() == 8);
  for (packing::Contact& c : own.contacts)
    c.normal_force = 0.01;
  check_same_contacts(through_overlaps(own, false).assembly, own);
  own.contacts.push_back(own.contacts.back());
  const io::ImportedPacking repeated = through_overlaps(own, false);
  CHECK(repeated.assembly.contacts.size() == 8);
  CHECK(repeated.has(io::Finding::duplicated));
}

TEST_CASE("small cells: rows without an image, or with two forces for one contact, are refused") {
  packing::Assembly own = upright();
  own.contacts[3].branch *= 1.1;
  CHECK_THROWS_AS((void)through_dump(own), FileError);
  own = upright();
  own.contacts.push_back(own.contacts[3]);
  own.contacts.back().normal_force *= 2;
  CHECK_THROWS_AS((void)through_dump(own), FileError);
}
