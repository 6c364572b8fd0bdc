// SPDX-License-Identifier: GPL-3.0-or-later
// One packing, in a box whose corner is not the origin, with contacts through its faces, clumps and walls,
// written in each format and in several units, is the same packing when it is read.
#include <algorithm>
#include <cmath>

#include <granum/core/text.hpp>
#include <granum/io/vtk/paraview.hpp>

#include "import_support.hpp"

using namespace granum;
using namespace granum::io;
using namespace granum::samples;

namespace {

constexpr Vec3 corner{-1e-3, 2e-3, -5e-3};

packing::Assembly sample(bool tilted) {
  packing::Assembly a;
  a.cell = Mat3::diagonal(4e-3, 4.5e-3, 5e-3);
  if (tilted)
    a.cell(0, 1) = 0.4e-3, a.cell(0, 2) = -0.2e-3, a.cell(1, 2) = 0.3e-3;
  a.radius = {0.5e-3, 0.4e-3, 0.6e-3, 0.3e-3};
  a.position.assign(4, corner + Vec3{0.7e-3, 1.1e-3, 1.3e-3});
  const auto touch = [&](std::uint32_t i, std::uint32_t j, const Vec3& direction, const Vec3& image) {
    packing::Contact c{.i = i, .j = j};
    c.overlap = 1e-6 * (1 + i + 2 * j);
    const Vec3 n = (1 / norm(direction)) * direction;
    c.branch = (a.radius[i] + a.radius[j] - c.overlap) * n;
    a.position[j] = a.position[i] + c.branch + image;
    c.normal_force = 0.01 * (i + j);
    const Vec3 some{1e-3, -2e-3, 3e-3 * j};
    c.tangential_force = some - dot(some, n) * n;
    c.normal_stiffness = 1e4 * (1 + j), c.tangential_stiffness = 7e3 * (2 + i);
    a.contacts.push_back(c);
  };
  touch(0, 1, {1, 0.2, 0.3}, {});
  touch(0, 3, {-1, -0.4, 0.1}, column(a.cell, 0));
  touch(1, 2, {0.1, 1, 0.5}, {});
  return a;
}

void check_same(const ImportedPacking& read, const packing::Assembly& a) {
  const packing::Assembly& found = read.assembly;
  REQUIRE(found.grain_count() == a.grain_count());
  for (int k = 0; k < 3; ++k)
    CHECK(norm(column(found.cell, k) - column(a.cell, k)) < 1e-12 * norm(column(a.cell, k)));
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    check_vector(found.position[g], a.position[g], 1e-12);
    CHECK(found.radius[g] == relative(a.radius[g], 1e-12));
  }
  CHECK(found.body == a.body);
  const auto check_contacts = [](const std::vector<packing::Contact>& all,
                                 const std::vector<packing::Contact>& expected) {
    REQUIRE(all.size() == expected.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      const packing::Contact &c = all[k], &e = expected[k];
      CHECK((c.i == e.i && c.j == e.j));
      check_vector(c.branch, e.branch, 1e-9);
      for (double packing::Contact::*const member :
           {&packing::Contact::overlap, &packing::Contact::normal_force, &packing::Contact::normal_stiffness,
            &packing::Contact::tangential_stiffness, &packing::Contact::rolling_stiffness,
            &packing::Contact::twisting_stiffness})
        CHECK(std::abs(c.*member - e.*member) <= 1e-9 * e.*member);
      check_vector(c.tangential_force, e.tangential_force, 1e-9);
    }
  };
  check_contacts(found.contacts, a.contacts);
  check_contacts(found.wall_contacts, a.wall_contacts);
}

/// Appends numbers, all times a factor, behind a separator.
void put(std::string& text, const char* between, double factor, const std::vector<double>& numbers) {
  for (const double number : numbers)
    text += between + exact_text(factor * number);
}
std::vector<double> parts(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The contacts in the order of the file: the second turned round.
std::vector<packing::Contact> listed(const packing::Assembly& a) {
  std::vector<packing::Contact> out = a.contacts;
  packing::Contact& c = out[1];
  std::swap(c.i, c.j);
  c.branch = -c.branch;
  c.tangential_force = -c.tangential_force;
  return out;
}

struct Units {
  const char* name;
  double length, force, time; ///< in SI
};

enum class Forces { split, whole, size };

ImportedPacking through_lammps(const packing::Assembly& a, const Units& in, Forces forces,
                               const char* place) {
  const double L = 1 / in.length, F = 1 / in.force;
  const Mat3& m = a.cell;
  const double xy = m(0, 1), xz = m(0, 2), yz = m(1, 2);
  std::string head = std::string("ITEM: UNITS\n") + in.name + "\nITEM: TIME\n" + exact_text(0.5 / in.time) +
                     "\nITEM: TIMESTEP\n7\nITEM: NUMBER OF ";
  std::string box = "\nITEM: BOX BOUNDS xy xz yz pp pp pp\n";
  const Vec3 low{std::min({0.0, xy, xz, xy + xz}), std::min(0.0, yz), 0},
      high{m(0, 0) + std::max({0.0, xy, xz, xy + xz}), m(1, 1) + std::max(0.0, yz), m(2, 2)};
  const double tilt[] = {xy, xz, yz};
  for (int k = 0; k < 3; ++k) {
    put(box, "", L, {corner[k] + low[k]});
    put(box, " ", L, {corner[k] + high[k], tilt[k]});
    box += '\n';
  }
  const bool scaled = place[1] == 's';
  std::string grains = head + "ATOMS\n4" + box + "ITEM: ATOMS id mol diameter";
  for (const char axis : {'x', 'y', 'z'})
    grains += std::string(" ") + axis + (place + 1);
  for (std::size_t g = a.grain_count(); g-- > 0;) {
    grains += "\n" + std::to_string(g + 3) + " " + std::to_string(a.body.empty() ? 0 : a.body[g] + 1);
    put(grains, " ", 2 * L, {a.radius[g]});
    if (scaled)
      put(grains, " ", 1, parts(inverse_of(m) * (a.position[g] - corner)));
    else
      put(grains, " ", L, parts(a.position[g]));
  }
  std::string contacts = head + "ENTRIES\n3" + box + "ITEM: ENTRIES id1 id2 dx dy dz delta kn kt" +
                         (forces == Forces::split  ? " fnx fny fnz ftx fty ftz"
                          : forces == Forces::size ? " force ftx fty ftz"
                                                   : " fx fy fz");
  for (const packing::Contact& c : listed(a)) { // forces on the first grain
    contacts += "\n" + std::to_string(c.i + 3) + " " + std::to_string(c.j + 3);
    put(contacts, " ", -L, parts(c.branch));
    put(contacts, " ", L, {c.overlap});
    put(contacts, " ", F / L, {c.normal_stiffness, c.tangential_stiffness});
    if (forces == Forces::split)
      put(contacts, " ", -F, parts(c.normal_force * normal(c)));
    else if (forces == Forces::size)
      put(contacts, " ", F, {c.normal_force});
    put(contacts, " ", -F, parts(forces == Forces::whole ? force(c) : c.tangential_force));
  }
  return first_of(lammps_dump_format, grains + "\n", contacts + "\n");
}

ImportedPacking through_csv(const packing::Assembly& a, const std::string& length, double per_length,
                            const std::string& force_unit, double per_force) {
  const auto heading = [](const std::vector<const char*>& names, const std::string& unit) {
    std::string text;
    for (const char* const name : names)
      text += std::string(",") + name + (unit.empty() ? "" : "_" + unit);
    return text;
  };
  std::string grains = "id,body" + heading({"x", "y", "z", "diameter"}, length);
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    grains += "\n" + std::to_string(g + 5) + "," + std::to_string(a.body.empty() ? 0 : a.body[g] + 1);
    put(grains, ",", per_length, parts(a.position[g]));
    put(grains, ",", 2 * per_length, {a.radius[g]});
  }
  std::string contacts = "id1,id2" + heading({"fx", "fy", "fz"}, force_unit) +
                         heading({"delta", "lx", "ly", "lz"}, length) + heading({"kn", "kt"}, "N/m");
  for (const packing::Contact& c : listed(a)) {
    contacts += "\n" + std::to_string(c.i + 5) + "," + std::to_string(c.j + 5);
    put(contacts, ",", per_force, parts(force(c)));
    put(contacts, ",", per_length, {c.overlap, c.branch.x, c.branch.y, c.branch.z});
    put(contacts, ",", 1, {c.normal_stiffness, c.tangential_stiffness});
  }
  return first_of(csv_format, grains + "\n", contacts + "\n", {.box = CsvBox{a.cell}});
}

ImportedPacking through_yade(const packing::Assembly& a) {
  std::string grains = "# granum: grains of a YADE scene, SI\n# step 7\n# time 0.5\n# cell";
  for (int row = 0; row < 3; ++row)
    put(grains, " ", 1, {a.cell(row, 0), a.cell(row, 1), a.cell(row, 2)});
  grains += "\n# id x y z r clumpId";
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    grains += "\n" + std::to_string(g + 2);
    put(grains, " ", 1, parts(a.position[g]));
    put(grains, " ", 1, {a.radius[g]});
    grains += " " + std::to_string(a.body.empty() ? -1L : static_cast<long>(a.body[g]));
  }
  std::string contacts = "# granum: contacts of a YADE scene\n# id1 id2 nx ny nz pd fnx fny fnz fsx fsy fsz "
                         "kn ks kr ktw cellDistX cellDistY cellDistZ";
  std::vector<packing::Contact> all = listed(a);
  all.insert(all.end(), a.wall_contacts.begin(), a.wall_contacts.end());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const packing::Contact& c = all[k];
    const bool wall = k >= a.contacts.size();
    contacts += "\n" + std::to_string(c.i + 2) + " " +
                std::to_string(wall ? -1 - static_cast<long>(c.j) : static_cast<long>(c.j) + 2);
    put(contacts, " ", 1, parts(normal(c)));
    put(contacts, " ", 1, {c.overlap});
    put(contacts, " ", 1, parts(c.normal_force * normal(c)));
    put(contacts, " ", 1, parts(c.tangential_force));
    put(contacts, " ", 1,
        {c.normal_stiffness, c.tangential_stiffness, c.rolling_stiffness, c.twisting_stiffness});
    const Vec3 image = wall ? Vec3{} : inverse_of(a.cell) * (c.branch + a.position[c.i] - a.position[c.j]);
    for (int axis = 0; axis < 3; ++axis)
      contacts += " " + std::to_string(std::lround(image[axis]));
  }
  return first_of(yade_text_format, grains + "\n", contacts + "\n");
}

ImportedPacking through_mercury(const packing::Assembly& a) {
  std::string data = "4 0.5";
  put(data, " ", 1, parts(corner));
  put(data, " ", 1, parts(corner + Vec3{a.cell(0, 0), a.cell(1, 1), a.cell(2, 2)}));
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    data += '\n';
    put(data, " ", 1, parts(a.position[g]));
    put(data, " ", 1, {0, 0, 0, a.radius[g], 0, 0, 0, 0, 0, 0, 0});
  }
  std::string fstat = "# 0.5 1\n# 0\n# 0";
  const auto row = [&](std::uint32_t i, long j, const Vec3& point, const packing::Contact& c, double turn) {
    fstat += "\n0.5 " + std::to_string(i) + " " + std::to_string(j);
    const double size = norm(c.tangential_force);
    put(fstat, " ", 1, parts(point));
    put(fstat, " ", 1, {c.overlap, 0, c.normal_force, size});
    put(fstat, " ", turn, parts(normal(c)));
    put(fstat, " ", turn / size, parts(c.tangential_force));
  };
  for (const packing::Contact& c : a.contacts) { // from either side, from the second grain to the first
    row(c.i, c.j, a.position[c.i] + 0.5 * c.branch, c, -1);
    row(c.j, c.i, a.position[c.i] + 0.5 * c.branch, c, 1);
  }
  for (const packing::Contact& c : a.wall_contacts)
    for (const double turn : {1.0, -1.0}) // a normal of either sign
      if (turn == (c.j == 0 ? 1 : -1))
        row(c.i, -1 - static_cast<long>(c.j), a.position[c.i] + c.branch, c, turn);
  return first_of(mercury_format, data + "\n", fstat + "\n");
}

void add_walls(packing::Assembly& a) {
  for (const std::uint32_t wall : {0U, 1U}) {
    packing::Contact c{.i = wall + 1, .j = wall, .branch = {0, (wall == 0 ? -1 : 1) * 0.39e-3, 0}};
    c.overlap = a.radius[c.i] - 0.39e-3;
    c.normal_force = 0.02 + wall;
    c.tangential_force = {1e-3, 0, -2e-3};
    a.wall_contacts.push_back(c);
  }
}

} // namespace

TEST_CASE("round trip: LAMMPS in all units, forces whole and split, coordinates in parts of the box too") {
  for (const bool tilted : {false, true})
    for (const bool clumps : {false, true}) {
      packing::Assembly a = sample(tilted);
      if (clumps)
        a.body = {0, 1, 2, 1};
      for (const Units& units : {Units{"si", 1, 1, 1}, Units{"cgs", 1e-2, 1e-5, 1},
                                 Units{"micro", 1e-6, 1e-9, 1e-6}, Units{"nano", 1e-9, 1e-12, 1e-9}})
        for (const Forces forces : {Forces::split, Forces::whole, Forces::size})
          for (const char* const place : {"x", "xu", "xs", "xsu"}) {
            const ImportedPacking read = through_lammps(a, units, forces, place);
            check_same(read, a);
            CHECK(*read.time == relative(0.5, 1e-12));
            CHECK(read.step == 7);
            CHECK(read.id == std::vector<long>{3, 4, 5, 6});
          }
    }
}

TEST_CASE("round trip: CSV in all units, with clumps") {
  packing::Assembly a = sample(true);
  a.body = {0, 1, 2, 1};
  check_same(through_csv(a, "m", 1, "N", 1), a);
  check_same(through_csv(a, "mm", 1e3, "mN", 1e3), a);
  check_same(through_csv(a, "um", 1e6, "kN", 1e-3), a);
}

TEST_CASE("round trip: YADE with clumps, also the first, walls and resistance to turning") {
  packing::Assembly a = sample(true);
  check_same(through_yade(a), a);
  a.body = {0, 1, 2, 0};
  a.contacts.erase(a.contacts.begin() + 1); // within the clump
  add_walls(a);
  for (packing::Contact& c : a.contacts)
    c.rolling_stiffness = 1e-3 * (c.i + 1), c.twisting_stiffness = 2e-3;
  const ImportedPacking read = through_yade(a);
  check_same(read, a);
  CHECK(read.step == 7);
  CHECK(read.time == 0.5);
}

TEST_CASE("round trip: granum's own files for ParaView, with walls") {
  packing::Assembly a = sample(true);
  add_walls(a);
  const std::vector<long> id{-3, 7, 11, 20};
  const ImportedPacking read = first_of(vtk_xml_format, grains_vtu(a, id, 0.5), contacts_vtp(a, id));
  check_same(read, a);
  CHECK((read.id == id && read.time == 0.5));
}

TEST_CASE("round trip: MercuryDPM with walls, whose normals have either sign") {
  packing::Assembly a = sample(false);
  for (packing::Contact& c : a.contacts)
    c.normal_stiffness = c.tangential_stiffness = 0; // not in the files
  add_walls(a);
  const ImportedPacking read = through_mercury(a);
  check_same(read, a);
  CHECK(read.time == 0.5);
}
