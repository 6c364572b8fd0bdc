// SPDX-License-Identifier: GPL-3.0-or-later
// A window of a packing: the whole of it is the whole packing, parts add up, and what it is asked for is
// checked.
#include "studies/analyse/window.hpp"

#include "read_specimen.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

using namespace granum::samples;
using studies::WindowChoice;

namespace {

analysis::Measurement seen_through(const io::ImportedPacking& packing, const WindowChoice& choice) {
  analysis::Wanted wanted;
  wanted.window = studies::window_in(packing, choice);
  return studies::measure_frame(packing, {.grain_shear_modulus = 30e9}, wanted).packing;
}

/// Spheres of two sizes one above the other, between a floor and a free surface, in a cell periodic sideways.
io::ImportedPacking column() {
  io::ImportedPacking packing;
  packing.periodic = {true, true, false};
  packing.assembly = {.cell = Mat3::diagonal(1, 1, 4),
                      .position = {{0.1, 0.5, 0.4}, {0.1, 0.5, 1.1}, {0.6, 0.5, 3.5}},
                      .radius = {0.4, 0.3, 0.1},
                      .contacts = {{.i = 0, .j = 1, .branch = {0, 0, 0.7}, .normal_force = 1}}};
  return packing;
}

} // namespace

TEST_CASE("window: the whole of a periodic packing is the packing, wherever the window begins") {
  const io::ImportedPacking packing = through_csv(specimen());
  for (const double begin : {0.0, 0.3e-3, -7e-3}) {
    const analysis::Measurement all = seen_through(packing, {.low = {begin, begin, begin}});
    REQUIRE(all.interior);
    CHECK(all.interior->grains == packing.assembly.grain_count());
    CHECK(all.interior->void_ratio == relative(all.void_ratio, 1e-9));
    CHECK(all.interior->micro.coordination_number == all.counts.coordination_number);
    CHECK(all.interior->micro.rattler_fraction == all.counts.mechanical.rattler_fraction);
    for (int i = 0; i < 3; ++i)
      CHECK(all.interior->stress(i, i) == relative(all.stress->tensor(i, i), 1e-9));
    CHECK(all.state->stress_v == relative(all.stress->symmetric(2, 2), 1e-9));
  }
}

TEST_CASE("window: solid volume and force times branch of two halves are those of the whole") {
  const io::ImportedPacking packing = through_csv(specimen());
  const double edge = packing.assembly.cell(2, 2), cut = 0.4 * edge;
  WindowChoice lower, upper;
  lower.low[2] = 0;
  lower.high[2] = upper.low[2] = cut;
  upper.high[2] = edge;
  const analysis::Measurement low = seen_through(packing, lower), high = seen_through(packing, upper);
  CHECK(0.4 / (1 + low.interior->void_ratio) + 0.6 / (1 + high.interior->void_ratio) ==
        relative(1 / (1 + low.void_ratio), 1e-9));
  CHECK(0.4 * low.interior->stress(2, 2) + 0.6 * high.interior->stress(2, 2) ==
        relative(low.stress->tensor(2, 2), 1e-9));
  // the closed forms take the state of the window
  CHECK(low.state->void_ratio == low.interior->void_ratio);
  CHECK(low.state->stress_v == low.interior->stress(2, 2));
}

TEST_CASE("window: the grains between walls, an edge of the cell along periodic axes, depth from the highest "
          "grain with a contact") {
  const analysis::Window whole = studies::window_in(column(), {});
  CHECK(std::abs(whole.low.z) < 1e-15);
  CHECK(whole.high.z == relative(3.6, 1e-15));
  CHECK(whole.high.x - whole.low.x == relative(1, 1e-15));
  const WindowChoice choice{.depth = std::pair{0.2, 0.9}};
  const analysis::Window window = studies::window_in(column(), choice);
  CHECK(window.high.z == relative(1.2, 1e-15));
  CHECK(window.low.z == relative(0.5, 1e-15));
  io::ImportedPacking gas = column();
  gas.assembly.contacts.clear();
  CHECK_THROWS_WITH_AS((void)studies::window_in(gas, choice), doctest::Contains("--depth"), InvalidArgument);
}

TEST_CASE("window: a window beyond the grains, or without width, is refused") {
  const struct {
    double low, high;
    std::size_t axis;
    const char* name;
  } rows[] = {{1, 5, 2, " z"}, {-1, 1, 2, " z"}, {2, 1, 0, " x"}, {0, 1.5, 0, " x"}, {3, 3.5, 2, ""}};
  for (const auto& row : rows) {
    WindowChoice choice;
    choice.low[row.axis] = row.low;
    choice.high[row.axis] = row.high;
    CHECK_THROWS_WITH_AS((void)seen_through(column(), choice), doctest::Contains(row.name), InvalidArgument);
  }
  for (const double beyond : {3e-9, 5e-9}) // rounding of an edge of 4 may be beyond
    for (const auto& [low, high] : {std::pair{-beyond, 3.0}, {0.5, 3.6 + beyond}}) {
      WindowChoice choice;
      choice.low[2] = low;
      choice.high[2] = high;
      if (beyond < 4e-9)
        CHECK(studies::window_in(column(), choice).high.z == high);
      else
        CHECK_THROWS_AS((void)studies::window_in(column(), choice), InvalidArgument);
    }
}

TEST_CASE("window: the interior that is chosen lies two to three grains from walls, and is whole along "
          "periodic axes") {
  const auto lattice = [](int wide, int layers) {
    io::ImportedPacking packing;
    packing.periodic = {true, true, false};
    packing.assembly.cell = Mat3::diagonal(wide, wide, 20);
    for (int i = 0; i < wide; ++i)
      for (int j = 0; j < wide; ++j)
        for (int k = 0; k < layers; ++k) {
          const auto g = static_cast<std::uint32_t>(packing.assembly.grain_count());
          packing.assembly.position.push_back({0.5 + i, 0.5 + j, 0.5 + k});
          packing.assembly.radius.push_back(0.5);
          if (k > 0)
            packing.assembly.contacts.push_back({.i = g - 1, .j = g, .branch = {0, 0, 1}, .normal_force = 1});
        }
    return packing;
  };
  // Layers of 2.5 diameters if five are left between them, else of 2; three must be left.
  for (const auto& [layers, layer] : {std::pair{10, 2.5}, {9, 2.0}, {7, 2.0}}) {
    io::ImportedPacking packing = lattice(6, layers);
    packing.assembly.position.push_back({1, 1, 15}); // in flight
    packing.assembly.radius.push_back(0.5);
    const auto chosen = studies::interior_window(packing);
    REQUIRE(chosen);
    CHECK_FALSE(chosen->low[0]);
    CHECK(*chosen->low[2] == relative(layer, 1e-12));
    CHECK(*chosen->high[2] == relative(layers - layer, 1e-12));
  }
  CHECK_FALSE(studies::interior_window(lattice(6, 6)));
  // 200 grains, and 100 contacts in the window: 25 at each height.
  io::ImportedPacking packing = lattice(5, 8);
  CHECK(studies::interior_window(packing));
  packing.assembly.position.pop_back();
  packing.assembly.radius.pop_back();
  packing.assembly.contacts.pop_back();
  CHECK_FALSE(studies::interior_window(packing));
  packing = lattice(6, 7);
  std::size_t kept = 0;
  std::erase_if(packing.assembly.contacts, [&](const packing::Contact& c) {
    const double middle = packing.assembly.position[c.i].z + 0.5;
    return middle > 1.5 && middle < 5.5 && ++kept > 100;
  });
  CHECK(studies::interior_window(packing));
  packing.assembly.contacts.erase(packing.assembly.contacts.begin() + 1); // at a height of 2
  CHECK_FALSE(studies::interior_window(packing));
  packing = lattice(6, 10);
  packing.periodic = {true, true, true};
  CHECK_FALSE(studies::interior_window(packing));
  packing.periodic = {false, true, false}; // 6 - 4 diameters are no interior
  CHECK_FALSE(studies::interior_window(packing));
}
