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
      .position = {{1e-3, 2e-3, 2e-3}, {1.9e-3, 2e-3, 2e-3}, {1e-3, 2e-3, 2.7e-3}, {3e-3, 1e-3, 0}},
      .radius = {0.5e-3, 0.5e-3, 0.25e-3, 1.0 / 3e4},
      .contacts = {}};
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

const std::vector<long> ids{7, 9, 11, 13};

} // namespace

TEST_CASE("ParaView: grains keep every bit, with their forces, the edges of the cell are listed in order") {
  packing::Assembly assembly = chain();
  assembly.cell(0, 2) = 1e-3; // of the third edge
  const std::string file = grains_vtu(assembly);
  CHECK(file.find("<Piece NumberOfPoints=\"4\" NumberOfCells=\"4\">") != std::string::npos);
  const std::vector<double> points = array(file, "Points");
  REQUIRE(points.size() == 12);
  for (std::size_t k = 0; k < 12; ++k)
    CHECK(points[k] == assembly.position[k / 3][static_cast<int>(k % 3)]);
  const std::pair<const char*, std::vector<double>> expected[] = {
      {"radius", assembly.radius},
      {"contacts", {2, 2, 2, 0}},
      {"rattler", {0, 0, 0, 1}},
      {"id", {0, 1, 2, 3}},
      {"offsets", {1, 2, 3, 4}},
      {"types", {1, 1, 1, 1}},
      {"cell", {4e-3, 0, 0, 0, 4e-3, 0, 1e-3, 0, 4e-3}}};
  for (const auto& [name, values] : expected)
    CHECK(array(file, name) == values);
  CHECK(array(grains_vtu(assembly, ids), "id") == std::vector<double>{7, 9, 11, 13});
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

TEST_CASE("ParaView: contacts are lines along their branches, those with walls behind the others") {
  packing::Assembly assembly = chain();
  assembly.wall_contacts = {
      {.i = 1, .j = 4, .branch = {0, 0, -0.4e-3}, .normal_force = 5, .normal_stiffness = 7}};
  const std::string file = contacts_vtp(assembly, ids);
  CHECK(file.find("<Piece NumberOfPoints=\"8\" NumberOfLines=\"4\">") != std::string::npos);
  CHECK(file.find("Name=\"connectivity\" NumberOfComponents=\"1\"") != std::string::npos);
  std::vector<packing::Contact> all = assembly.contacts;
  all.push_back(assembly.wall_contacts[0]);
  const std::vector<double> points = array(file, "Points");
  REQUIRE(points.size() == 24);
  for (std::size_t c = 0; c < 4; ++c)
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = 6 * c + static_cast<std::size_t>(k);
      CHECK(points[at] == assembly.position[all[c].i][k]);
      CHECK(points[at + 3] == assembly.position[all[c].i][k] + all[c].branch[k]);
    }
  const std::pair<const char*, std::vector<double>> expected[] = {
      {"normal_force", {2, 1.0 / 3, 1, 5}},
      {"tangential_force", {0, 0, 0, 0.1, -0.2, 0, 0, 0, 0, 0, 0, 0}},
      {"normal_stiffness", {0, 0, 0, 7}},
      {"sliding", {0, 1, 0, 0}},
      {"through_face", {0, 0, 1, 0}},
      {"wall", {-1, -1, -1, 4}},
      {"grains", {7, 9, 7, 11, 9, 11, 9, 9}},
      {"connectivity", {0, 1, 2, 3, 4, 5, 6, 7}},
      {"offsets", {2, 4, 6, 8}}};
  for (const auto& [name, values] : expected)
    CHECK(array(file, name) == values);
}

TEST_CASE("ParaView: an assembly without contacts, and one without grains") {
  const packing::Assembly none{.cell = Mat3::diagonal(1, 1, 1), .position = {}, .radius = {}, .contacts = {}};
  CHECK(grains_vtu(none).find("NumberOfPoints=\"0\"") != std::string::npos);
  CHECK(contacts_vtp(none).find("NumberOfLines=\"0\"") != std::string::npos);
  CHECK_THROWS_WITH_AS(grains_vtu(none, ids), doctest::Contains("id"), InvalidArgument);
}
