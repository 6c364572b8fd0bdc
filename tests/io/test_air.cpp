// SPDX-License-Identifier: GPL-3.0-or-later
// The size of the box beyond the grains changes no number.
#include <granum/io/imported_packing.hpp>

#include <granum/analysis/measure.hpp>
#include <granum/core/text.hpp>
#include <granum/io/csv/packing.hpp>

#include "import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

/// A lattice of 5 x 5 x 6 grains of radius 0.5 m, 0.99 m apart, that fills a periodic box sideways; `shift`
/// moves it along z, through the face where the box is periodic.
ImportedPacking pile(double height, double shift = 0, bool periodic = true) {
  constexpr int n = 5, layers = 6;
  constexpr double apart = 0.99;
  std::string rows = "# units: SI\nid,x,y,z,radius\n", pairs = "# units: SI\nid1,id2,fx,fy,fz\n";
  const auto id = [](int i, int j, int k) { return std::to_string(((i % n) * n + j % n) * layers + k); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < layers; ++k) {
        const double z = 0.5 + apart * k + shift;
        rows += id(i, j, k) + "," + short_text(apart * i, 17) + "," + short_text(apart * j, 17) + "," +
                short_text(periodic ? z - height * std::floor(z / height) + height * ((i + k) % 3) : z, 17) +
                ",0.5\n"; // through any number of boxes
        pairs += id(i, j, k) + "," + id(i + 1, j, k) + ",100,0,0\n" + id(i, j, k) + "," + id(i, j + 1, k) +
                 ",0,100,0\n";
        if (k + 1 < layers)
          pairs += id(i, j, k) + "," + id(i, j, k + 1) + ",0,0,200\n";
      }
  const CsvBox box{.cell = Mat3::diagonal(n * apart, n * apart, height), .periodic = {true, true, periodic}};
  return first_of(csv_format, rows, pairs, {.box = box});
}

} // namespace

TEST_CASE("air: a box of any height gives the numbers of the box that ends at the grains") {
  constexpr double filled = 5 * 0.99 + 1;
  const ImportedPacking tight = pile(filled, 0, false);
  CHECK_FALSE(tight.has(Finding::air_left_out));
  const analysis::Given given{.grain_shear_modulus = 1e9};
  const analysis::Measurement expected = analysis::measure(tight.assembly, given, analysis::everything());
  REQUIRE(expected.network);
  CHECK(expected.stress->symmetric(2, 2) == relative(25 * 5 * 200 * 0.99 / (4.95 * 4.95 * filled), 1e-12));
  for (const double height : {filled + 2.1, 2 * filled, 40 * filled})
    for (const double shift : {0.0, 1.3, -2.2, height - 0.5}) {
      for (const bool periodic : {true, false}) {
        CAPTURE(height);
        CAPTURE(shift);
        const ImportedPacking packing = pile(height, shift, periodic);
        CHECK(packing.has(Finding::air_left_out));
        CHECK(packing.periodic == std::array<bool, 3>{true, true, false});
        CHECK(packing.assembly.cell(2, 2) == relative(filled, 1e-12));
        CHECK(packing.assembly.contacts.size() == tight.assembly.contacts.size());
        const analysis::Measurement found =
            analysis::measure(packing.assembly, given, analysis::everything());
        CHECK(found.void_ratio == relative(expected.void_ratio, 1e-12));
        CHECK(found.stress->symmetric(2, 2) == relative(expected.stress->symmetric(2, 2), 1e-12));
        CHECK(found.network->relaxed.stiffness.matrix(0, 0) ==
              relative(expected.network->relaxed.stiffness.matrix(0, 0), 1e-9));
      }
      // neighbours of a pile that reached through the face are side by side
      const ImportedPacking packing = pile(height, shift);
      for (const packing::Contact& c : packing.assembly.contacts)
        CHECK(std::abs(packing.assembly.position[c.j].z - packing.assembly.position[c.i].z - c.branch.z) <
              1e-9);
    }
}

TEST_CASE("air: thin slabs, few grains and a gas keep their box") {
  constexpr double filled = 5 * 0.99 + 1;
  CHECK_FALSE(pile(filled + 1.9).has(Finding::air_left_out));
  const auto of = [](int grains, double apart) {
    ImportedPacking packing;
    packing.assembly.cell = Mat3::diagonal(60, 60, 60);
    for (int k = 0; k < grains; ++k) {
      packing.assembly.position.push_back({apart * (k % 5), apart * (k / 5 % 5), apart * (k / 25)});
      packing.assembly.radius.push_back(0.5);
    }
    return without_air(packing);
  };
  CHECK(of(100, 1).has(Finding::air_left_out));
  CHECK(of(125, 1.9).has(Finding::air_left_out)); // 0.103 of the rest is solid, 0.090 below
  CHECK_FALSE(of(99, 1).has(Finding::air_left_out));
  CHECK_FALSE(of(125, 2).has(Finding::air_left_out));
}
