// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/yade/files.hpp>

#include "io/import_support.hpp"

using namespace granum;
using namespace granum::io;
using namespace granum::samples;

namespace {

// in the form of VTKExporter.exportSpheres, which the samples that YADE wrote do not hold
const std::string spheres =
    "# vtk DataFile Version 3.0.\ncomment\nASCII\n\nDATASET POLYDATA\nPOINTS 3 double\n"
    "0.001 0.002 0.002\n0.0019999 0.002 0.002\n0.0019999 0.002 0.0029998\n\nPOINT_DATA 3\n"
    "SCALARS radius double 1\nLOOKUP_TABLE default\n0.0005\n0.0005\n0.0005\n\n"
    "VECTORS v double\n0 0 1\n0 0 2\n0 0 3\n";
const std::string pairs = data_text("yade_chain.vtk");

std::string refusal_of_vtk(const std::string& sphere_text, const std::string& pair_text = pairs) {
  return refusal([&] { (void)read_yade_vtk(text_source("s", sphere_text), text_source("i", pair_text)); });
}

} // namespace

TEST_CASE("YADE VTK: contacts find their spheres, forces on the second one") {
  const ImportedPacking packing = read_yade_vtk(text_source("s", spheres), data_source("yade_chain.vtk"));
  REQUIRE(packing.assembly.contacts.size() == 2);
  const packing::Contact &ab = packing.assembly.contacts[0], &bc = packing.assembly.contacts[1];
  CHECK((ab.i == 0 && ab.j == 1 && bc.i == 1 && bc.j == 2));
  check_vector(ab.branch, {0.9999e-3, 0, 0}, 1e-12);
  CHECK(ab.overlap == relative(1e-7, 1e-8));
  CHECK(ab.normal_force == 0.0233028);
  CHECK(bc.normal_force == 0.065646);
  CHECK(ab.tangential_force == Vec3{1.66955e-10, 0.0032045, 0.000293169});
  for (const Finding finding : {Finding::few_digits, Finding::cell_unknown, Finding::boundary_unknown,
                                Finding::ids_assumed, Finding::stiffness_unknown})
    CHECK(packing.has(finding));
  CHECK(read_yade_vtk(text_source("s", spheres)).has(Finding::contacts_unknown));
}

TEST_CASE("YADE VTK: numbers may be spread over lines as they like, and forces may be missing") {
  const std::string spread =
      with(spheres, "0.001 0.002 0.002\n0.0019999 0.002", "0.001 0.002\n0.002 0.0019999\n0.002");
  const std::string bare = pairs.substr(0, pairs.find("CELL_DATA"));
  const ImportedPacking packing = read_yade_vtk(text_source("s", spread), text_source("i", bare));
  CHECK(packing.assembly.contacts.size() == 2);
  CHECK(packing.has(Finding::forces_unknown));
}

TEST_CASE("YADE VTK: each field that is wrong is refused with path and line") {
  const auto sphere = [](const std::string& from, const std::string& to) {
    return refusal_of_vtk(with(spheres, from, to));
  };
  const auto pair = [](const std::string& from, const std::string& to) {
    return refusal_of_vtk(spheres, with(pairs, from, to));
  };
  CHECK(refusal_of_vtk("").find("expected a first line '# vtk DataFile") != std::string::npos);
  CHECK(sphere("ASCII", "BINARY") == "s:3: expected a third line 'ASCII'");
  CHECK(sphere("POLYDATA", "STRUCTURED_GRID") == "s:5: expected DATASET POLYDATA or UNSTRUCTURED_GRID");
  CHECK(sphere("POINTS 3", "POINTS 4") == "s:11: expected a finite number as coordinate, found 'POINT_DATA'");
  CHECK(
      sphere("POINTS 3", "POINTS 2").starts_with("s:9: expected a section of a VTK file, found '0.0019999'"));
  CHECK(sphere("POINTS 3", "POINTS -3") == "s:6: expected a number of points, found -3");
  CHECK(sphere("POINTS 3", "DOTS 3") == "s:6: expected a section of a VTK file, found 'DOTS'");
  CHECK(sphere("0.001 0.002", "0.001 nan") == "s:7: expected a finite number as coordinate, found 'nan'");
  CHECK(sphere("SCALARS radius", "SCALARS size").find("expected point data SCALARS radius") !=
        std::string::npos);
  CHECK(sphere("default\n0.0005", "default\n0") == "s:7: expected a positive radius of grain 0, found 0");
  CHECK(sphere("LOOKUP_TABLE default\n", "").starts_with("s:13: expected LOOKUP_TABLE"));
  CHECK(sphere("POINT_DATA 3", "POINT_DATA 2")
            .starts_with("s:11: expected as many values as there are points"));
  CHECK(sphere("0 0 3\n", "0 0\n") == "s:21: the file ends; expected value");
  CHECK(sphere("double 1\n", "double 7\n") == "s:12: expected 1 to 4 components, found 7");
  CHECK(pair("0.0019999 0.002 0.0029998", "0.0019999 0.002 0.0039998")
            .starts_with("i:13: the contact ends at no centre"));
  CHECK(pair("2 2 3", "2 2 4") == "i:13: expected 2 and two numbers of points, found '2 2 4'");
  CHECK(pair("2 2 3", "3 2 3").starts_with("i:13: expected 2 and two numbers of points"));
  CHECK(pair("2 2 3", "2 2 2") == "i:13: the grain 1 is in contact with itself");
  CHECK(pair("0.0233028", "inf") == "i:18: expected a finite number as value, found 'inf'");
  CHECK(pair("CELL_DATA 2", "CELL_DATA 3").starts_with("i:15: expected as many values"));
  CHECK(refusal_of_vtk(with(spheres, "0.0019999 0.002 0.002\n", "0.001 0.002 0.002\n"))
            .find("where two spheres") != std::string::npos);
}

TEST_CASE("YADE VTK: LIGGGHTS' dump custom/vtk has ids and types in a field, points as cells") {
  const std::string dump =
      "# vtk DataFile Version 3.0\nGenerated by LIGGGHTS\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n"
      "0.001 0.002 0.002 0.0019999 0.002 0.002 \n0.0019999 0.002 0.0029998 \nCELLS 3 6\n1 0 \n1 1 \n1 2 \n\n"
      "CELL_TYPES 3\n1\n1\n1\n\nPOINT_DATA 3\nFIELD FieldData 4\nid 1 3 int\n7 5 6 \ntype 1 3 int\n2 1 1 \n"
      "radius 1 3 double\n0.0005 0.0004 0.0005 \nv 3 3 double\n0 0 0 0 0 0 0 0 0 \n";
  const ImportedPacking packing = read_yade_vtk(text_source("d", dump));
  CHECK(packing.id == std::vector<long>{5, 6, 7});
  CHECK(packing.type == std::vector<long>{1, 1, 2});
  CHECK(packing.assembly.radius == std::vector<double>{0.0004, 0.0005, 0.0005});
  CHECK(packing.assembly.position[2] == Vec3{0.001, 0.002, 0.002});
  CHECK_FALSE(packing.has(Finding::ids_assumed));
  const auto broken = [&](const std::string& from, const std::string& to) {
    return refusal([&] { (void)read_yade_vtk(text_source("d", with(dump, from, to))); });
  };
  CHECK(broken("CELLS 3 6", "CELLS 3 7").find("number of a point") != std::string::npos);
  CHECK(broken("type 1 3 int", "type 1 2 int").find("as many tuples") != std::string::npos);
  CHECK(broken("FIELD FieldData 4", "FIELD FieldData 5").find("expected 5 arrays of a FIELD") !=
        std::string::npos);
  CHECK(broken("2 1 1", "2.5 1 1").find("expected integers as type, found 2.5") != std::string::npos);
  CHECK(broken("7 5 6", "7 5 5").find("the grain 5 is also on line") != std::string::npos);
}
