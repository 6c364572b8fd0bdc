// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/packing.hpp>

#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string grain_rows =
    "id,x_mm,y_mm,z_mm,radius_mm\n1,1,2,2,0.5\n2,1.9999,2,2,0.5\n3,1.9999,2,2.9998,0.5\n";
const std::string contacts =
    "# units: SI\nid1,id2,nx,ny,nz,fx,fy,fz,lx,ly,lz\n1,2,1,0,0,0.0235294118,0.01,0,0.0009999,0,0\n"
    "3,2,0,0,-1,0,0,-0.0665512265,0,0,-0.0009998\n";
const CsvBox box{Mat3::diagonal(4e-3, 4e-3, 4e-3)};

ImportedPacking read(const std::string& grain_text, const MaybeText& contact_text) {
  return first_of(csv_format, grain_text, contact_text, {.box = box});
}
std::string refused(const std::string& grain_text, const std::string& contact_text = contacts) {
  return refusal_of(csv_format, grain_text, contact_text, {.box = box});
}
ContactTable table(const std::string& text) { return read_contact_csv(text_source("c", text)); }

} // namespace

TEST_CASE(
    "CSV: the chain with units in the headings or SI throughout, forces exerted by the first on the second") {
  const ImportedPacking packing = read(grain_rows, contacts);
  check_chain(packing, 1e-15, 1e-8);
  CHECK(packing.assembly.contacts[0].tangential_force == Vec3{0, 0.01, 0});
  check_vector(residuals(packing.assembly)[0].force, {-force_ab, -0.01, 0}, 1e-15);
  CHECK(packing.has(Finding::law_unknown));
  CHECK_FALSE(packing.has(Finding::boundary_unknown));

  const ImportedPacking scalar =
      read(grain_rows, "id1,id2,nx,ny,nz,fn_mN,ft_mN,delta_mm\n1,2,1,0,0,23.5294118,1,1e-4\n"
                       "2,3,0,0,1,66.5512265,2,2e-4\n");
  check_chain(scalar, 1e-15, 1e-15);
  CHECK(scalar.has(Finding::tangential_unknown));
}

TEST_CASE("CSV: numbers whose products overflow are refused, with grains and without") {
  const std::string huge = with(contacts, "0.0235294118", "1e305");
  CHECK(refused(grain_rows, huge) != "");
  CHECK(refusal([&] { (void)table(huge); }).starts_with("c:3: "));
  CHECK(refusal([] { (void)table("nx,ny,nz,fn_N\n1,0,0,1e200\n"); }).starts_with("c:2: "));
  CHECK(refused(with(grain_rows, "1.9999", "1e90")) != "");
  CHECK(refused(with(grain_rows, "2,0.5", "2,1e90")) != "");
}

TEST_CASE("CSV: normals alone are enough for a table of contacts") {
  const ContactTable t = table("nx,ny,nz\n0,0,2\n3,4,0\n");
  REQUIRE(t.normal.size() == 2);
  CHECK(t.normal[0] == Vec3{0, 0, 1});
  check_vector(t.normal[1], {0.6, 0.8, 0}, 1e-15);
  CHECK((t.id.empty() && t.force.empty() && t.branch.empty() && t.overlap.empty() && t.normal_force.empty()));
  const ContactTable full = table(contacts);
  CHECK(full.id[1] == std::array<long, 2>{3, 2});
  CHECK(full.force[0] == Vec3{force_ab, 0.01, 0});
  CHECK(full.line == std::vector<std::size_t>{3, 4});
}

TEST_CASE("CSV: a table without forces keeps its contacts even where grains seem apart") {
  const ImportedPacking packing =
      read(with(grain_rows, "2,1.9999,2", "2,2.001,2"), "id1,id2,nx,ny,nz\n1,2,1,0,0\n");
  REQUIRE(packing.assembly.contacts.size() == 1);
  CHECK(packing.has(Finding::forces_unknown));
  CHECK(packing.has(Finding::open_contacts));
}

TEST_CASE(
    "CSV: without a box the smallest upright one stands for it, and diameters and row numbers are taken") {
  const ImportedPacking packing = first_of(csv_format, "# units: SI\nx,y,z,diameter\n0,0,0,1\n2,0,1,1\n");
  CHECK(packing.assembly.cell == Mat3::diagonal(3, 1, 2));
  CHECK(packing.id == std::vector<long>{0, 1});
  for (const Finding finding : {Finding::cell_unknown, Finding::ids_assumed, Finding::contacts_unknown})
    CHECK(packing.has(finding));
}

TEST_CASE("CSV: each field that is wrong is refused with path and line") {
  const std::vector<Wrong> of_grains{
      {"x_mm,y_mm,z_mm", {"u,v,w"}, "g:"}, {"y_mm", {"y"}, "g:1:"},
      {"radius_mm", {"size_mm"}, "g:1:"},  {"1,1,2", {"1,nan,2", "1.5,1,2"}, "g:2:"},
      {"1,1,2", {"2,1,2"}, "g:3:"},        {"2,2,0.5\n2", {"2,2,0\n2"}, "g:2:"}};
  const std::vector<Wrong> of_contacts{
      {"# units: SI", {"# units: cgs"}, "c:1:"},
      {"nx,ny", {"nx,b"}, "c:2:"},
      {"id1,id2", {"one,two"}, "c:"},
      {"id1,id2", {"id1,two"}, "c:2:"},
      {"1,2,1,0,0", {"1,2,0,0,0", "1,2,-1,0,0", "1,9,1,0,0", "1,1,1,0,0"}, "c:3:"},
      {"0.0235294118", {"0.02x"}, "c:3:"},
      {"0.0009999", {"-0.0009999"}, "c:3:"},
      {",0.0009999,0,0", {",0.0009999,0"}, "c:3:"}};
  check_refused(csv_format, grain_rows, contacts, of_grains, of_contacts);
  // all three of a normal, or none
  CHECK(refused(grain_rows, with(contacts, "nx,ny,nz", "nx,b,c")).find("ny") != std::string::npos);
  CHECK(refused(grain_rows, "").starts_with("c:"));
}

TEST_CASE("CSV: pairs by ids and forces have the normals of their grains, bodies join grains") {
  const std::string row =
      "id,x_m,y_m,z_m,radius_m\n1,0.001,0.005,0.005,0.0005\n2,0.00199,0.005,0.005,0.0005\n"
      "3,0.00298,0.005,0.005,0.0005\n";
  const ImportedPacking sizes =
      first_of(csv_format, row, "id1,id2,fn_N,ft_N\n1,2,0.0123,0.001\n2,3,0.0123,0.001\n");
  REQUIRE(sizes.assembly.contacts.size() == 2);
  CHECK(sizes.assembly.contacts[1].normal_force == 0.0123);
  CHECK(sizes.has(Finding::tangential_unknown));
  const ImportedPacking vectors =
      first_of(csv_format, row, "id1,id2,fx_N,fy_N,fz_N\n1,2,0.0123,0.001,0\n2,3,0.0123,0,0\n");
  REQUIRE(vectors.assembly.contacts.size() == 2);
  CHECK(vectors.assembly.contacts[0].normal_force == doctest::Approx(0.0123));
  CHECK(vectors.assembly.contacts[0].tangential_force.y == doctest::Approx(0.001));
  // contacts within a body carry nothing
  const ImportedPacking p = first_of(
      csv_format,
      "id,x_m,y_m,z_m,radius_m,body\n1,1,5,5,0.6,1\n2,2,5,5,0.6,1\n3,3.1,5,5,0.6,0\n4,4.2,5,5,0.6,9\n"
      "5,5.2,5,5,0.6,9\n",
      "id1,id2,fn_N\n1,2,4\n2,3,1\n3,4,1\n");
  CHECK(p.has(Finding::bodies));
  CHECK(p.assembly.body == std::vector<std::uint32_t>{0, 0, 1, 2, 2});
  CHECK(p.assembly.contacts.size() == 2);
}
