// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string data = data_text("lammps_chain.data");

std::string data_refused(const std::string& text) {
  return refusal([&] { (void)read_lammps_data(text_source("d", text)); });
}

} // namespace

TEST_CASE("LAMMPS data: diameters become radii, all digits are kept") {
  const ImportedPacking packing = read_lammps_data(data_source("lammps_chain.data"));
  CHECK(packing.id == std::vector<long>{1, 2, 3});
  CHECK(packing.assembly.radius == std::vector<double>{0.5e-3, 0.5e-3, 0.5e-3});
  CHECK(packing.assembly.position[1] ==
        Vec3{0.001999900327473458, 0.0020000001625631036, 0.0019999990753136595});
  CHECK(packing.assembly.cell == Mat3::diagonal(4e-3, 4e-3, 4e-3));
  CHECK(packing.step == 20);
  CHECK(packing.has(Finding::contacts_unknown));
  CHECK(packing.has(Finding::boundary_unknown));
  CHECK_FALSE(packing.has(Finding::few_digits));
}

TEST_CASE("LAMMPS data: a tilted box is the box itself, not its bounds") {
  const ImportedPacking packing = read_lammps_data(data_source("lammps_tilted.data"));
  CHECK(packing.assembly.cell == Mat3{{{4e-3, 4e-4, 0}, {0, 4e-3, 0}, {0, 0, 4e-3}}});
  CHECK(packing.assembly.position[2] == Vec3{0.0019999, 0.002, 0.0029998});
  CHECK(packing.has(Finding::few_digits));
}

TEST_CASE("LAMMPS data: eight significant digits are too few for overlaps, nine give no note") {
  const auto few = [](const std::string& coordinate) {
    const std::string text =
        "title\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms\n\n1 1 0.5 1 0 0 " + coordinate;
    return read_lammps_data(text_source("d", text)).has(Finding::few_digits);
  };
  CHECK(few("0.0012345678"));
  CHECK(few("-1.2345678e-123"));
  CHECK_FALSE(few("0.00123456789"));
  CHECK_FALSE(few("1.2345678901234567e+00"));
}

TEST_CASE("LAMMPS data: sections in another order, without hint, without image flags") {
  const std::string text =
      "title\n 2 atoms # two\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nVelocities\n\n1 0 0 0 0 0 0\n\n"
      "Atoms\n\n9 1 0.5 1 0 0 0\n4 1 0.25 1 0.5 0 0\n\nBonds\n\n1 1 1 2\n";
  const ImportedPacking packing = read_lammps_data(text_source("d", text));
  CHECK(packing.id == std::vector<long>{4, 9});
  CHECK(packing.assembly.radius == std::vector<double>{0.125, 0.25});
}

TEST_CASE("LAMMPS data: each field that is wrong is refused with path and line") {
  const auto changed = [](const std::string& from, const std::string& to) {
    return data_refused(with(data, from, to));
  };
  CHECK(data_refused("").starts_with("d:"));
  CHECK(data_refused("title\n") != "");
  check_refused(changed, {{"Atoms # sphere", "Atoms # atomic", "d:10:"},
                          {"3 atoms", "3 apples", ""},
                          {"3 atoms", "4 atoms", "d:16:"},
                          {"3 atoms", "2 atoms", "d:14:"},
                          {"3 atoms", "-3 atoms", "d:3:"},
                          {"ylo yhi", "ylo", ""},
                          {"0 0.004 ylo", "0 x ylo", "d:7:"},
                          {"0 0.004 ylo", "0 -1 ylo", ""},
                          {"2 1 0.001", "1 1 0.001", "d:13:"},
                          {"2 1 0.001", "2 1 0", "d:13:"},
                          {"2 1 0.001", "2 1 nan", "d:13:"},
                          {"2 1 0.001", "2 0.001", "d:13:"},
                          {"0.0019999990753136595", "inf", "d:13:"},
                          {"2 1 0.001", "b 1 0.001", "d:13:"}}); // reads as the next section
}

TEST_CASE("LAMMPS data: written packings are read back to the bit") {
  for (const char* file : {"lammps_chain.data", "lammps_tilted.data"}) {
    const ImportedPacking first = read_lammps_data(data_source(file));
    const std::string text = lammps_data(first.assembly, 2650, first.id);
    const ImportedPacking second = read_lammps_data(text_source("written", text));
    CHECK(second.assembly == first.assembly);
    CHECK(second.id == first.id);
    CHECK(text.find(" 2650 ") != std::string::npos);
  }
}

TEST_CASE("LAMMPS data: packings that LAMMPS cannot read are refused") {
  packing::Assembly assembly = read_lammps_data(data_source("lammps_chain.data")).assembly;
  CHECK(lammps_data(assembly, 1.5).find("\n3 1 0.001 1.5 ") != std::string::npos);
  CHECK_THROWS_WITH_AS(lammps_data(assembly, 0), doctest::Contains("density = 0"), InvalidArgument);
  const std::vector<long> two{1, 2}, from_zero{0, 1, 2};
  CHECK_THROWS_WITH_AS(lammps_data(assembly, 1, two), doctest::Contains("id"), InvalidArgument);
  CHECK_THROWS_AS(lammps_data(assembly, 1, from_zero), InvalidArgument);
  assembly.cell(1, 0) = 1e-4;
  CHECK_THROWS_AS(lammps_data(assembly, 1), InvalidArgument);
}
