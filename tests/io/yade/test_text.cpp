// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/yade/files.hpp>

#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string script_grains = "# granum: grains of a YADE scene, SI\n# step 20\n# time 2.5e-07\n"
                                  "# cell 0.004 0 0 0 0.004 0 0 0 0.004\n# id x y z r\n"
                                  "0 0.001 0.002 0.002 0.0005\n1 0.0019999 0.002 0.002 0.0005\n"
                                  "2 0.0019999 0.002 0.0029998 0.0005\n";
const std::string heading =
    "# id1 id2 cellDistX cellDistY cellDistZ cpx cpy cpz nx ny nz pd fnx fny fnz fsx fsy fsz kn ks\n";
const std::string script_contacts = data_text("yade_chain.contacts");

ImportedPacking read_script(const std::string& grain_text, const MaybeText& contact_text = {}) {
  return first_of(yade_text_format, grain_text, contact_text);
}
std::string script_refused(const std::string& grain_text, const std::string& contact_text = script_contacts) {
  return refusal_of(yade_text_format, grain_text, contact_text);
}
const std::string exported_grains = data_text("yade_script.grains"),
                  exported_contacts = data_text("yade_script.contacts");

} // namespace

TEST_CASE(
    "YADE: what the script writes keeps all digits, without bodies that are no spheres, walls are second") {
  const ImportedPacking packing = read_script(exported_grains, exported_contacts);
  check_chain(packing, 1e-15, 1e-15);
  CHECK(packing.id == std::vector<long>{0, 2, 4});
  CHECK(packing.step == 20);
  CHECK(packing.time == 1.0 / 3);
  CHECK(packing.assembly.cell == Mat3::diagonal(4e-3, 4e-3, 4e-3));
  CHECK(packing.assembly.contacts[0].tangential_force == Vec3{0, 0.01 / 3, 0});
  CHECK(packing.assembly.contacts[0].normal_stiffness == 352941.177);
  for (const Finding finding : {Finding::walls_unknown, Finding::cell_unknown, Finding::stiffness_unknown})
    CHECK_FALSE(packing.has(finding));
  check_vector(residuals(packing.assembly)[2].force, {0, 0, force_bc}, 1e-15);
  REQUIRE(packing.assembly.wall_contacts.size() == 1);
  const packing::Contact& wall = packing.assembly.wall_contacts[0];
  CHECK((wall.i == 0 && wall.j == 3)); // body 3, exported from wall to sphere
  check_vector(wall.branch, {-0.49e-3, 0, 0}, 1e-15);
  CHECK(wall.normal_force == 0.25);
  CHECK(wall.tangential_force == Vec3{0, -0.125, 0});
  CHECK(wall.normal_stiffness == 1000);
  CHECK(packing.has(Finding::wall_contacts));
}

TEST_CASE("YADE: rows that it printed itself") {
  const ImportedPacking packing = read_script(script_grains, script_contacts);
  const packing::Contact &ab = packing.assembly.contacts[0], &bc = packing.assembly.contacts[1];
  CHECK(ab.overlap == 9.93569733362e-08);
  CHECK(ab.normal_force == relative(0.0233028264076, 1e-11));
  CHECK(bc.normal_force == relative(0.0656459528618, 1e-11));
  check_vector(ab.tangential_force, {1.6695489126e-10, 0.00320450045648, 0.00029316886604}, 1e-15);
  CHECK(bc.tangential_stiffness / bc.normal_stiffness == relative(2 * 0.85 / 1.85, 1e-12)); // MindlinPhys
  CHECK(norm(ab.branch) == relative(1e-3 - 9.93569733362e-08, 1e-14));
}

TEST_CASE("YADE: a row may have its grains in either order, the first one of all second") {
  const std::string place = " 0 0 0 0.0015 0.002 0.002 ";
  const auto contacts = [&](const std::string& row) {
    return read_script(script_grains, heading + row).assembly.contacts;
  };
  const auto straight = contacts("0 1" + place + "1 0 0 1e-7 0.02 0 0 0 0.01 0 3 2\n"),
             turned = contacts("1 0" + place + "-1 0 0 1e-7 -0.02 0 0 0 -0.01 0 3 2\n");
  REQUIRE(straight.size() == 1);
  CHECK(straight == turned);
}

TEST_CASE("YADE: a pair through a face, in a sheared cell") {
  const std::string two = with(script_grains.substr(0, script_grains.find("0 0.001")), "0.004 0 0 0 0.004",
                               "0.004 0.0004 0 0 0.004") +
                          "4 0.002 0.0004 0.002 0.0005\n7 0.0024 0.0034001 0.002 0.0005\n";
  const std::string row = "4 7 0 -1 0 0 0 0 0 -1 0 1e-07 0 -0.0235294118 0 0 0 0 1 1\n";
  const ImportedPacking packing = read_script(two, heading + row);
  REQUIRE(packing.assembly.contacts.size() == 1);
  check_vector(packing.assembly.contacts[0].branch, {0, -0.9999e-3, 0}, 1e-12);
  CHECK(packing.assembly.contacts[0].normal_force == force_ab);
  CHECK(packing.has(Finding::through_faces));
  CHECK(script_refused(two, heading + with(row, "0 -1 0 0 0 0", "0 1 0 0 0 0")).starts_with("c:2:"));
}

TEST_CASE("YADE: its text exports give the geometry, with a note on its few digits") {
  for (const char* name : {"yade_text.txt", "yade_text_ext.txt"}) {
    const ImportedPacking packing = read_script(data_text(name));
    CHECK(packing.assembly.position[2] == Vec3{0.0019999, 0.002, 0.0029998});
    CHECK(packing.assembly.radius[2] == 0.5e-3);
    CHECK(packing.id == std::vector<long>{0, 1, 2});
    for (const Finding finding : {Finding::few_digits, Finding::cell_unknown, Finding::contacts_unknown})
      CHECK(packing.has(finding));
    CHECK(packing.has(Finding::ids_assumed) == (std::string(name) == "yade_text.txt"));
    check_vector(column(packing.assembly.cell, 0), {1.9999e-3, 0, 0}, 1e-12); // around the grains
  }
  const ImportedPacking both = read_script(data_text("yade_text.txt"), script_contacts);
  CHECK(both.assembly.contacts[0].overlap == 9.93569733362e-08); // overlaps keep the digits of the contacts
}

TEST_CASE("YADE: contacts that were not exported are counted") {
  const ImportedPacking packing = read_script(script_grains, "# left_out 3\n" + script_contacts);
  CHECK(packing.has(Finding::walls_unknown));
  CHECK(packing.assembly.wall_contacts.empty());
  CHECK_FALSE(read_script(script_grains, script_contacts).has(Finding::walls_unknown));
}

TEST_CASE("YADE: each field that is wrong is refused with path and line") {
  const std::vector<Wrong> of_grains{{"# id x y z r", {"# rows"}, "g:6:"},
                                     {"x y z r", {"x y z radius", "x y r"}, "g:6:"},
                                     {"0 0.001", {"1 0.001"}, "g:7:"},
                                     {"0 0.001", {"0 nan"}, "g:6:"},
                                     {"0.002 0.0005", {"0.002 -0.0005"}, "g:6:"},
                                     {"# cell 0.004", {"# cell", "# cell 0"}, "g:4:"},
                                     {"# step 20", {"# step x"}, "g:2:"},
                                     {"# time 2.5e-07", {"# time"}, "g:3:"}};
  const std::vector<Wrong> of_contacts{
      {"id2", {"second"}, "c:1:"},
      {" pd ", {" overlap "}, "c:1:"},
      {"\n0 1 0", {"\n0 5 0", "\n0 0 0", "\n0 1.5 0"}, "c:2:"},
      {"0.00199999954538 1 ", {"0.00199999954538 3 ", "0.00199999954538 -1 "}, "c:2:"},
      {"0.0233028264076", {"inf"}, "c:2:"},
      {"0.00320450045648", {"?"}, "c:2:"},
      {"9.93569733362e-08", {"1e-07e"}, "c:2:"},
      {"351804.593455", {"-1"}, "c:2:"},
      {" 323279.896688", {""}, "c:2:"}};
  check_refused(yade_text_format, script_grains, script_contacts, of_grains, of_contacts);
  CHECK(script_refused("").starts_with("g:"));
  CHECK(script_refused(script_grains, "").starts_with("c:"));
  CHECK(script_refused(script_grains, "0 1\n").starts_with("c:1:"));
}
