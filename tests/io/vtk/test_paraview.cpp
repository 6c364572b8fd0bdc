// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/vtk/paraview.hpp>

#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;

namespace {

/// The numbers of one array of a file, as text and as numbers.
std::vector<double> array(const std::string& file, const std::string& name) {
  const std::size_t heading = file.find("Name=\"" + name + '"');
  REQUIRE(heading != std::string::npos);
  const std::size_t begin = file.find('>', heading) + 1;
  std::istringstream numbers(file.substr(begin, file.find("</DataArray>", begin) - begin));
  std::vector<double> values;
  for (double value; numbers >> value;)
    values.push_back(value);
  return values;
}

/// Three grains, one of them touched through a face of the cell, and one alone.
packing::Assembly chain() {
  packing::Assembly assembly{
      .cell = Mat3::diagonal(4e-3, 4e-3, 4e-3),
      .position = {{1e-3, 2e-3, 2e-3}, {1.9e-3, 2e-3, 2e-3}, {1e-3, 2e-3, 0.1}, {3e-3, 1e-3, 0}},
      .radius = {0.5e-3, 0.5e-3, 0.25e-3, 1.0 / 3e4},
      .contacts = {}};
  assembly.position[2].z = 2e-3 + 0.7e-3;
  assembly.contacts = {{.i = 0, .j = 1, .branch = {0.9e-3, 0, 0}, .overlap = 1e-4, .normal_force = 2},
                       {.i = 0,
                        .j = 2,
                        .branch = {0, 0, 0.7e-3},
                        .overlap = 5e-5,
                        .normal_force = 1.0 / 3,
                        .tangential_force = {0.1, -0.2, 0},
                        .sliding = true},
                       {.i = 1, .j = 2, .branch = {3.1e-3, 0, 0.7e-3 - 4e-3}, .normal_force = 1}};
  return assembly;
}

} // namespace

TEST_CASE("ParaView: grains keep every bit, with their forces") {
  const packing::Assembly assembly = chain();
  const std::string file = grains_vtu(assembly);
  CHECK(file.find("<Piece NumberOfPoints=\"4\" NumberOfCells=\"4\">") != std::string::npos);
  const std::vector<double> points = array(file, "Points");
  REQUIRE(points.size() == 12);
  for (std::size_t k = 0; k < 12; ++k)
    CHECK(points[k] == assembly.position[k / 3][static_cast<int>(k % 3)]);
  CHECK(array(file, "radius") == assembly.radius);
  CHECK(array(file, "contacts") == std::vector<double>{2, 2, 2, 0});
  CHECK(array(file, "rattler") == std::vector<double>{0, 0, 0, 1});
  CHECK(array(file, "id") == std::vector<double>{0, 1, 2, 3});
  CHECK(array(file, "offsets") == std::vector<double>{1, 2, 3, 4});
  CHECK(array(file, "types") == std::vector<double>{1, 1, 1, 1});
  const std::vector<long> id{7, 9, 11, 13};
  CHECK(array(grains_vtu(assembly, id), "id") == std::vector<double>{7, 9, 11, 13});
}

TEST_CASE("ParaView: pressures of the grains, by volume, are the mean stress of the packing") {
  packing::Assembly assembly = chain();
  assembly.wall_contacts = {{.i = 1, .j = 4, .branch = {0, 0, -0.4e-3}, .normal_force = 5}};
  const std::vector<double> pressure = array(grains_vtu(assembly), "pressure");
  double sum = 0;
  for (std::size_t g = 0; g < 4; ++g)
    sum +=
        pressure[g] * 4 / 3 * std::numbers::pi * assembly.radius[g] * assembly.radius[g] * assembly.radius[g];
  CHECK(sum / assembly.volume() == relative(contact_stress(assembly).mean(), 1e-14));
  CHECK(pressure[3] == 0);
}

TEST_CASE("ParaView: contacts are lines along their branches, with forces") {
  const packing::Assembly assembly = chain();
  const std::vector<long> id{7, 9, 11, 13};
  const std::string file = contacts_vtp(assembly, id);
  CHECK(file.find("<Piece NumberOfPoints=\"6\" NumberOfLines=\"3\">") != std::string::npos);
  const std::vector<double> points = array(file, "Points");
  for (std::size_t c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = 6 * c + static_cast<std::size_t>(k);
      CHECK(points[at] == assembly.position[assembly.contacts[c].i][k]);
      CHECK(points[at + 3] == assembly.position[assembly.contacts[c].i][k] + assembly.contacts[c].branch[k]);
    }
  CHECK(array(file, "normal_force") == std::vector<double>{2, 1.0 / 3, 1});
  CHECK(array(file, "tangential_force") == std::vector<double>{0, 0, 0, 0.1, -0.2, 0, 0, 0, 0});
  CHECK(array(file, "sliding") == std::vector<double>{0, 1, 0});
  CHECK(array(file, "through_face") == std::vector<double>{0, 0, 1});
  CHECK(array(file, "grains") == std::vector<double>{7, 9, 7, 11, 9, 11});
  CHECK(array(file, "connectivity") == std::vector<double>{0, 1, 2, 3, 4, 5});
  CHECK(array(file, "offsets") == std::vector<double>{2, 4, 6});
  CHECK(file.find("Name=\"connectivity\" NumberOfComponents=\"1\"") != std::string::npos);
}

TEST_CASE("ParaView: contacts with walls are lines to the walls, behind the others") {
  packing::Assembly assembly = chain();
  assembly.wall_contacts = {
      {.i = 1, .j = 4, .branch = {0, 0, -0.4e-3}, .normal_force = 5, .normal_stiffness = 7}};
  const std::vector<long> id{7, 9, 11, 13};
  const std::string file = contacts_vtp(assembly, id);
  CHECK(array(file, "wall") == std::vector<double>{-1, -1, -1, 4});
  CHECK(array(file, "grains") == std::vector<double>{7, 9, 7, 11, 9, 11, 9, 9});
  CHECK(array(file, "normal_force") == std::vector<double>{2, 1.0 / 3, 1, 5});
  CHECK(array(file, "normal_stiffness") == std::vector<double>{0, 0, 0, 7});
  CHECK(array(file, "through_face") == std::vector<double>{0, 0, 1, 0});
  const std::vector<double> points = array(file, "Points");
  REQUIRE(points.size() == 24);
  CHECK(points[23] == assembly.position[1].z - 0.4e-3);
}

TEST_CASE("ParaView: the edges of the cell are listed in order") {
  packing::Assembly assembly = chain();
  assembly.cell(0, 2) = 1e-3; // of the third edge
  CHECK(array(grains_vtu(assembly), "cell") == std::vector<double>{4e-3, 0, 0, 0, 4e-3, 0, 1e-3, 0, 4e-3});
}

TEST_CASE("ParaView: an assembly without contacts, and one without grains") {
  const packing::Assembly none{.cell = Mat3::diagonal(1, 1, 1), .position = {}, .radius = {}, .contacts = {}};
  CHECK(grains_vtu(none).find("NumberOfPoints=\"0\"") != std::string::npos);
  CHECK(contacts_vtp(none).find("NumberOfLines=\"0\"") != std::string::npos);
  const std::vector<long> id{1};
  CHECK_THROWS_WITH_AS(grains_vtu(none, id), doctest::Contains("id"), InvalidArgument);
}
