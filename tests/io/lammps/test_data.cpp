// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string data = data_text("lammps_chain.data");

/// A box tilted along x by a tenth of its edge.
const std::string tilted = with(data, "zhi\n", "zhi\n0.0004 0 0 xy xz yz\n");

ImportedPacking read(const std::string& text) { return read_lammps_data(text_source("g", text)); }

} // namespace

TEST_CASE("LAMMPS data: diameters become radii, all digits are kept") {
  const ImportedPacking packing = read(data);
  CHECK(packing.id == std::vector<long>{1, 2, 3});
  CHECK(packing.assembly.radius == std::vector<double>{0.5e-3, 0.5e-3, 0.5e-3});
  CHECK(packing.assembly.position[1] ==
        Vec3{0.001999900327473458, 0.0020000001625631036, 0.0019999990753136595});
  CHECK(packing.assembly.cell == Mat3::diagonal(4e-3, 4e-3, 4e-3));
  CHECK(packing.step == 20);
  CHECK(packing.has(Finding::contacts_unknown));
  CHECK(packing.has(Finding::boundary_unknown));
  CHECK_FALSE(packing.has(Finding::few_digits));
  // a tilted box is the box itself, not its bounds
  CHECK(read(tilted).assembly.cell == Mat3{{{4e-3, 4e-4, 0}, {0, 4e-3, 0}, {0, 0, 4e-3}}});
}

TEST_CASE("LAMMPS data: eight significant digits are too few for overlaps, nine give no note") {
  const auto few = [](const std::string& coordinate) {
    const std::string text =
        "title\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms\n\n1 1 0.5 1 0 0 " + coordinate;
    return read(text).has(Finding::few_digits);
  };
  CHECK(few("0.0012345678"));
  CHECK(few("-1.2345678e-123"));
  CHECK_FALSE(few("0.00123456789"));
  CHECK_FALSE(few("1.2345678901234567e+00"));
}

TEST_CASE("LAMMPS data: sections in another order, without hint, without image flags") {
  const std::string text =
      "title\n 2 atoms # two\n-1 1 xlo xhi\n0.5 1 ylo yhi\n-3 -2 zlo zhi\n\nVelocities\n\n1 0 0 0 0 0 0\n\n"
      "Atoms\n\n9 1 0.5 1 0 0 0\n4 1 0.25 1 0.5 0 0\n\nBonds\n\n1 1 1 2\n";
  const ImportedPacking packing = read(text);
  CHECK(packing.id == std::vector<long>{4, 9});
  CHECK(packing.assembly.radius == std::vector<double>{0.125, 0.25});
  CHECK(packing.assembly.cell == Mat3::diagonal(2, 0.5, 1));
}

TEST_CASE("LAMMPS data: each field that is wrong is refused with path and line") {
  check_refused(lammps_data_format, data, {},
                {{"Atoms # sphere", {"Atoms # atomic"}, "g:10:"},
                 {"3 atoms", {"3 apples"}, ""},
                 {"3 atoms", {"4 atoms"}, "g:16:"},
                 {"3 atoms", {"2 atoms"}, "g:14:"},
                 {"3 atoms", {"-3 atoms"}, "g:3:"},
                 {"ylo yhi", {"ylo"}, ""},
                 {"0 0.004 ylo", {"0 x ylo"}, "g:7:"},
                 {"0 0.004 ylo", {"0 -1 ylo"}, ""},
                 {"2 1 0.001", {"1 1 0.001", "2 1 0", "2 1 nan", "2 0.001"}, "g:13:"},
                 {"0.0019999990753136595", {"inf"}, "g:13:"},
                 {"2 1 0.001", {"b 1 0.001"}, "g:13:"}}); // reads as the next section
  CHECK(refusal_of(lammps_data_format, "").starts_with("g:"));
  CHECK(refusal_of(lammps_data_format, "title\n") != "");
}

TEST_CASE("LAMMPS data: written packings are read back to the bit") {
  for (const std::string& file : {data, tilted}) {
    const ImportedPacking first = read(file);
    const std::string text = lammps_data(first.assembly, 2650, first.id);
    const ImportedPacking second = read(text);
    CHECK(second.assembly == first.assembly);
    CHECK(second.id == first.id);
    CHECK(text.find(" 2650 ") != std::string::npos);
  }
}

TEST_CASE("LAMMPS data: packings that LAMMPS cannot read are refused") {
  packing::Assembly assembly = read(data).assembly;
  CHECK(lammps_data(assembly, 1.5).find("\n3 1 0.001 1.5 ") != std::string::npos);
  CHECK_THROWS_WITH_AS(lammps_data(assembly, 0), doctest::Contains("density = 0"), InvalidArgument);
  const std::vector<long> two{1, 2}, from_zero{0, 1, 2};
  CHECK_THROWS_WITH_AS(lammps_data(assembly, 1, two), doctest::Contains("id"), InvalidArgument);
  CHECK_THROWS_AS(lammps_data(assembly, 1, from_zero), InvalidArgument);
  assembly.cell(1, 0) = 1e-4;
  CHECK_THROWS_AS(lammps_data(assembly, 1), InvalidArgument);
}
