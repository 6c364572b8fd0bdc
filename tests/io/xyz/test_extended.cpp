// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/grain_fields.hpp>
#include <granum/io/packing_files.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string xyz_by_hand =
    "2\n"
    "Lattice=\"4 0 0  0.5 5 0  0 0 6\" Time=1.5 pbc='T F T' "
    "Properties=species:S:1:id:I:1:Radius:R:1:pos:R:3:velo:R:3:particle_type:I:1\n"
    "Si 7 0.5 1 2 3 0 0 0 2\n"
    "Si 3 0.25 1.5 2.5 3.5 0 0 0 1\n";

} // namespace

TEST_CASE("extended XYZ: columns in any order, cell, faces and time are read, what is left is named") {
  const ImportedPacking packing = first_of(extended_xyz_format, xyz_by_hand);
  const packing::Assembly& a = packing.assembly;
  CHECK(packing.id == std::vector<long>{3, 7});
  CHECK(packing.type == std::vector<long>{1, 2});
  CHECK(a.radius == std::vector<double>{0.25, 0.5});
  check_vector(a.position[1], {1, 2, 3}, 0);
  check_vector(Vec3{a.cell(0, 1), a.cell(1, 1), a.cell(2, 1)}, {0.5, 5, 0}, 1e-15); // the second edge
  CHECK(packing.periodic == std::array<bool, 3>{true, false, true});
  CHECK(packing.time == 1.5);
  CHECK(first_of(extended_xyz_format, with(xyz_by_hand, "6\" Time", "6\"Time")).time == 1.5);
  CHECK(packing.has(Finding::contacts_unknown));
  CHECK_FALSE(packing.has(Finding::cell_unknown));
  CHECK(packing.has(Finding::not_used));
}

TEST_CASE("extended XYZ: what granum writes for OVITO it reads again, to the bit, frame by frame") {
  packing::Assembly grains{.cell = {{{4, 0.3, 0}, {0, 5, 0.1}, {0, 0, 6}}},
                           .position = {{1.0 / 3, 2, 3}, {1.1, 2.2, 3.3}},
                           .radius = {0.5, 0.7},
                           .contacts = {}};
  const std::vector<long> id{4, 9};
  const std::string text =
      grains_xyz(grains, {true, true, true}, grain_fields(grains, KnownForces::none), id, 0.25);
  const PackingFrames all = states_of(extended_xyz_format, text + text);
  for (int k = 0; k < 2; ++k) {
    const auto packing = all.next();
    REQUIRE(packing);
    CHECK(packing->id == id);
    CHECK(packing->assembly.position == grains.position);
    CHECK(packing->assembly.radius == grains.radius);
    CHECK(packing->assembly.cell == grains.cell);
    CHECK(packing->time == 0.25);
    CHECK(packing->step == k);
  }
  CHECK_FALSE(all.next());
  const auto has = [&](KnownForces known, const std::string& name) {
    const std::vector<GrainField> fields = grain_fields(grains, known);
    return std::ranges::find(fields, name, &GrainField::name) != fields.end();
  };
  for (const KnownForces known : {KnownForces::none, KnownForces::normal, KnownForces::all}) {
    CHECK(has(known, "pressure") == (known != KnownForces::none));
    CHECK(has(known, "grain_stress") == (known == KnownForces::all));
  }
}

TEST_CASE("extended XYZ: without a lattice the box is that of the user, or around the grains") {
  const std::string bare = "1\nProperties=pos:R:3:radius:R:1\n1 2 3 0.5\n";
  const ImportedPacking around = first_of(extended_xyz_format, bare);
  CHECK((around.has(Finding::cell_unknown) && around.has(Finding::ids_assumed)));
  const CsvBox box{.cell = Mat3::diagonal(2, 3, 4)};
  CHECK(first_of(extended_xyz_format, bare, {}, {.box = box}).assembly.volume() == 24);
  TextSource source = text_source("a file", xyz_by_hand);
  CHECK(recognise(source).format == &extended_xyz_format);
}

TEST_CASE("extended XYZ: files that are none, or are cut, are refused with the line") {
  check_refused(extended_xyz_format, xyz_by_hand, {},
                {{"2\nLattice", {"3\nLattice"}, "g:4"},
                 {"Radius", {"size"}, ""},
                 {"pos:R:3", {"pos:R:2"}, ""},
                 {"velo:R:3", {"velo:R:x"}, ""},
                 {"Properties", {"Props"}, ""},
                 {"4 0 0  0.5", {"4 0  0.5"}, ""},
                 {"0.25", {"-0.25"}, "g:4"},
                 {"Si 3", {"Si 7"}, "g:4"},
                 {"1.5 2.5", {"1.5 nan"}, "g:4"}});
  for (const std::string& cut :
       {std::string(), std::string("2\n"), xyz_by_hand.substr(0, xyz_by_hand.size() - 40)})
    CHECK(refusal_of(extended_xyz_format, cut).starts_with("g:"));
}
