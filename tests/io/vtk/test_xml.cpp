// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/vtk/xml.hpp>

#include <granum/io/vtk/paraview.hpp>
#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string grains = data_text("yade_chain.vtu");
const std::string contacts = data_text("yade_chain.vtp");

ImportedPacking read_xml(const std::string& grain_text, const MaybeText& contact_text = {}) {
  return first_of(vtk_xml_format, grain_text, contact_text);
}
std::string refused(const std::string& grain_text) { return refusal_of(vtk_xml_format, grain_text); }

/// Two grains in contact through a face of a tilted cell, a third on two walls.
packing::Assembly sample() {
  packing::Assembly a{
      .cell = Mat3::diagonal(4e-3, 4e-3, 4e-3),
      .position = {{0.3e-3, 2e-3, 1.0 / 700}, {3.4e-3, 2e-3, 1.0 / 700}, {2e-3, 0.49e-3, 0.4e-3}},
      .radius = {0.5e-3, 0.45e-3, 0.5e-3},
      .contacts = {}};
  a.cell(0, 2) = 1e-3 / 3;
  a.contacts = {{.i = 0,
                 .j = 1,
                 .branch = {3.1e-3 - 4e-3, 0, 0},
                 .overlap = 5e-5,
                 .normal_force = 1.0 / 3,
                 .tangential_force = {0, 0.1, -0.02 / 3},
                 .normal_stiffness = 2e5,
                 .tangential_stiffness = 1e5 / 3,
                 .sliding = true}};
  a.wall_contacts = {{.i = 2, .j = 2, .branch = {0, -0.49e-3, 0}, .overlap = 1e-5, .normal_force = 0.5},
                     {.i = 2,
                      .j = 4,
                      .branch = {0, 0, -0.4e-3},
                      .overlap = 1e-4,
                      .normal_force = 0.7,
                      .tangential_force = {0.01, 0, 0},
                      .normal_stiffness = 3e5}};
  return a;
}

const std::vector<long> sample_id{7, 11, -3};

std::string own_grains() { return grains_vtu(sample(), sample_id); }
std::string own_contacts() { return contacts_vtp(sample(), sample_id); }

void check_grain_order(const ImportedPacking& packing) {
  REQUIRE(packing.id == std::vector<long>{-3, 7, 11});
  const packing::Assembly& a = packing.assembly;
  const packing::Assembly expected = sample();
  CHECK(a.cell == expected.cell);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t from = (k + 2) % 3;
    CHECK(a.position[k] == expected.position[from]);
    CHECK(a.radius[k] == expected.radius[from]);
  }
}

} // namespace

TEST_CASE("VTK XML: files written by granum are read back in the order of the ids") {
  const ImportedPacking packing = read_xml(own_grains(), own_contacts());
  check_grain_order(packing);
  const packing::Assembly& a = packing.assembly;
  REQUIRE((a.contacts.size() == 1 && a.wall_contacts.size() == 2));
  CHECK((a.contacts[0].i == 1 && a.contacts[0].j == 2 && a.contacts[0].sliding));
  CHECK_FALSE(a.wall_contacts[1].sliding);
  CHECK(a.contacts[0].tangential_force == sample().contacts[0].tangential_force); // to the bit
  for (const Finding finding : {Finding::boundary_unknown, Finding::law_unknown, Finding::history_unknown,
                                Finding::units_unknown, Finding::through_faces, Finding::wall_contacts})
    CHECK(packing.has(finding));
  for (const Finding finding : {Finding::cell_unknown, Finding::ids_assumed, Finding::few_digits,
                                Finding::forces_unknown, Finding::stiffness_unknown})
    CHECK_FALSE(packing.has(finding));
}

TEST_CASE("VTK XML: grains only, a packing without contacts, stiffnesses that the writer did not know") {
  const ImportedPacking alone = read_xml(own_grains());
  check_grain_order(alone);
  CHECK_FALSE(alone.time);
  CHECK(read_xml(grains_vtu(sample(), sample_id, 1.0 / 3)).time == 1.0 / 3);
  CHECK(alone.has(Finding::contacts_unknown));
  packing::Assembly a = sample();
  for (auto* contacts : {&a.contacts, &a.wall_contacts})
    for (packing::Contact& c : *contacts)
      c.normal_stiffness = c.tangential_stiffness = 0;
  CHECK(read_xml(own_grains(), contacts_vtp(a, sample_id)).has(Finding::stiffness_unknown));
  a.contacts.clear();
  a.wall_contacts.clear();
  const ImportedPacking empty = read_xml(own_grains(), contacts_vtp(a, sample_id));
  CHECK(empty.assembly.contacts.empty());
  CHECK_FALSE(empty.has(Finding::contacts_unknown));
}

TEST_CASE("VTK XML: YADE's recorder, contacts matched with the centres of the grains") {
  const ImportedPacking packing = read_xml(grains, contacts);
  // Forces of nine printed digits; overlaps from coordinates of single precision: 1e-10 m of 1e-7 m.
  check_chain(packing, 3e-9, 1e-2);
  for (const Finding finding :
       {Finding::few_digits, Finding::cell_unknown, Finding::boundary_unknown, Finding::ids_assumed,
        Finding::tangential_unknown, Finding::stiffness_unknown, Finding::history_unknown})
    CHECK(packing.has(finding));
  CHECK(packing.assembly.contacts[0].tangential_force == Vec3{});
  CHECK(packing.id == std::vector<long>{0, 1, 2});
}

TEST_CASE("VTK XML: every way in which VTK packs arrays gives the same numbers") {
  const ImportedPacking text = read_xml(grains);
  const std::string lines = data_text("vtk_appended.vtp");
  for (const char* name :
       {"vtk_appended.vtu", "vtk_packed.vtu", "vtk_raw.vtu", "vtk_blocks.vtu", "vtk_big.vtu"}) {
    INFO(name);
    const ImportedPacking packing = read_xml(data_text(name));
    CHECK(packing.assembly.position == text.assembly.position);
    CHECK(packing.assembly.radius == text.assembly.radius);
    CHECK(packing.id == std::vector<long>{0, 2, 4});
    CHECK(packing.has(Finding::few_digits));
    check_chain(read_xml(data_text(name), lines), 1e-9, 1e-2);
  }
}

TEST_CASE("VTK XML: names in any case, arrays in any order, the time, and skipped arrays") {
  const std::string field =
      "<FieldData><DataArray type=\"String\" Name=\"note\" format=\"ascii\">65 66</DataArray>"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\">0.25</DataArray>"
      "</FieldData><Piece";
  std::string file = with(with(grains, "<Piece", field), "Name=\"radii\"", "Name=\"Radius\"");
  file = with(file, "0.0005 0.0005 0.0005\n", "5e-4\n\t0.0005\r\n 0.0005 ");
  const ImportedPacking packing = read_xml(file);
  CHECK(packing.time == 0.25);
  CHECK(packing.assembly.radius == std::vector<double>{5e-4, 5e-4, 5e-4});
}

TEST_CASE("VTK XML: each field of the grains that is wrong is refused with path and line") {
  check_refused(vtk_xml_format, grains, {},
                {{"</VTKFile>", {""}, ""},
                 {"LittleEndian", {"MiddleEndian"}, "g:2:"},
                 {"header_type=\"UInt32\"", {"header_type=\"Int32\""}, "g:2:"},
                 {"NumberOfPoints=\"3\"", {"NumberOfPoints=\"-3\""}, "g:4:"},
                 {"NumberOfPoints=\"3\"", {"NumberOfPoints=\"2\""}, "g:45:"},
                 {"NumberOfPoints=\"3\"", {"NumberOfPoints=\"0\""}, ""},
                 {"</Piece>", {"</Piece><Piece/>"}, ""},
                 {"Name=\"radii\"", {"Name=\"size\""}, "g:"},
                 {"0.0005 0.0005 0.0005", {"0.0005 0.0005"}, "g:8:"},
                 {"0.0005 0.0005 0.0005", {"0.0005 wide 0.0005", "0.0005 inf 0.0005"}, "g:7:"},
                 {"0.0005 0.0005 0.0005", {"0.0005 nan 0.0005", "0.0005 0.0005 0"}, ""},
                 {"0.0010000000474974513", {"nan"}, ""},
                 {"Points\" NumberOfComponents=\"3\"", {"Points\" NumberOfComponents=\"2\""}, "g:43:"},
                 {"Name=\"radii\" format=\"ascii\"", {"Name=\"radii\" format=\"morse\""}, "g:6:"},
                 {"<Points>", {"<Point>"}, "g:"}}); // tags that do not close
  for (const char* text : {"", "ITEM: TIMESTEP\n", "<svg/>"})
    CHECK(refused(text).starts_with("g:1:"));
  CHECK(refused("<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile/>") != "");
  CHECK(refused("<VTKFile/>").starts_with("g:"));
  const std::string cell = "Name=\"cell\" NumberOfComponents=\"9\" NumberOfTuples=\"1\" format=\"ascii\">\n0";
  check_refused(vtk_xml_format, own_grains(), {},
                {{"\n7\n11\n", {"\n7\n7\n", "\n7\n1.5\n"}, ""}, {cell + ".004", {cell}, ""}});
}

TEST_CASE("VTK XML: packed arrays that are damaged are refused") {
  const auto damaged = [](const char* file, const std::vector<Wrong>& changes) {
    check_refused(vtk_xml_format, data_text(file), {}, changes);
  };
  // "radii" of vtk_packed: one block, then its bytes
  const std::string block = "AQAAAACAAAAYAAAAEwAAAA==";
  damaged("vtk_packed.vtu",
          {{block + "eJz7", {block + "eJz8", block + "eJ!7", block, "AQAAAACAAAAY/////wAAAA==eJz7"}, "g:6:"},
           {"NumberOfPoints=\"3\"", {"NumberOfPoints=\"4\""}, "g:19:"}});
  damaged("vtk_big.vtu", {{"type=\"Float64\" Name=\"radii\"", {"type=\"Bit\" Name=\"radii\""}, "g:6:"},
                          {"AAAAGD", {"//////"}, ""}});
  damaged("vtk_appended.vtu", {{"offset=\"0\"", {"offset=\"9999\""}, "g:6:"},
                               {"encoding=\"base64\"", {"encoding=\"base32\""}, ""}});
  CHECK(refused(with(data_text("vtk_packed.vtu"), "vtkZLibDataCompressor", "vtkLZ4DataCompressor"))
            .find("vtkLZ4DataCompressor") != std::string::npos);
  const std::string raw = data_text("vtk_raw.vtu");
  CHECK(refused(raw.substr(0, raw.find("\n   _") + 5 + 96 + 20)) != "");
}

TEST_CASE("VTK XML: each field of the contacts that is wrong is refused") {
  check_refused(vtk_xml_format, grains, contacts, {},
                {{"type=\"PolyData\"", {"type=\"ImageData\""}, "c:"},
                 {"0 1 1 2", {"0 1 1 3", "0 1 1 -1", "0 1 1 1.5", "0 1 1 1"}, ""},
                 {"2 4\n", {"3 4\n"}, ""},
                 {"0.023529411764649337 0.06655122646467276\n", {"0.0235\n"}, ""},
                 {"0.0029998000245541334", {"0.0039998", "nan"}, ""},
                 {"0.023529411764649337 0.06", {"nan 0.06"}, ""},
                 {"<Lines>", {"<Curves>"}, "c:"}});
  check_refused(vtk_xml_format, own_grains(), own_contacts(), {},
                {{"\n7 11\n", {"\n7 12\n", "\n7 7\n", "\n11 7\n"}, ""},
                 {"\n-1\n2\n4\n", {"\n-1\n2\n4.5\n", "\n-1\n2\n5000000000\n"}, ""},
                 {"\n0.3333333333333333\n0.5\n0.7\n", {"\n0.3333333333333333\nnan\n0.7\n"}, ""},
                 {"\n2e+05\n0\n3e+05\n", {"\n-2e+05\n0\n3e+05\n"}, ""}});
}
