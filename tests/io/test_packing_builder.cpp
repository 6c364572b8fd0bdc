// SPDX-License-Identifier: GPL-3.0-or-later
// What every reader shares: rows that make a packing, and what is noted or refused of them.
#include "io/packing_builder.hpp"

#include <functional>
#include <random>
#include <tuple>

#include "import_support.hpp"
#include "thresholds.hpp"

using namespace granum;
using namespace granum::io;

namespace {

constexpr double apart = 1.99; // of grains of radius 1

/// A chain along x without a box.
PackingBuilder chain(std::size_t count, const PackingFileOptions& options = {},
                     const std::function<void(std::size_t, GrainRow&)>& change = {}) {
  PackingBuilder builder("grains", "contacts", options);
  std::vector<GrainRow> rows;
  for (std::size_t k = count; k-- > 0;) {
    const auto place = static_cast<double>(k);
    rows.push_back(
        {.id = 3 * static_cast<long>(k), .position = {apart * place, 1, -2}, .radius = 1, .line = k});
    if (change)
      change(k, rows.back());
  }
  builder.set_grains(rows);
  return builder;
}

PairRow row_of(const PackingBuilder& builder, std::uint32_t a, std::uint32_t b) {
  return {.a = a,
          .b = b,
          .branch = builder.straight(a, b),
          .overlap = 2 - apart,
          .normal_force = 1,
          .tangential_force = {0, a < b ? 0.5 : -0.5, 0}};
}

/// The first number of a note; 0 without the note.
std::size_t counted(const ImportedPacking& packing, Finding finding) {
  for (const ImportNote& note : packing.notes)
    if (note.finding == finding)
      return std::stoul(note.text.substr(note.text.find_first_of("0123456789")));
  return 0;
}

} // namespace

TEST_CASE("packing builder: rows of a pair from either side and in any order make one contact") {
  for (const bool both_sides : {false, true}) {
    PackingBuilder builder = chain(4);
    if (both_sides)
      builder.expect_both_sides();
    for (const auto& [a, b] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{
             {2, 3}, {1, 0}, {0, 1}, {1, 0}, {0, 1}, {1, 0}, {1, 2}, {2, 1}})
      builder.add(row_of(builder, a, b));
    const ImportedPacking packing = builder.finish(7, 0.25);
    REQUIRE(packing.assembly.contacts.size() == 3);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const packing::Contact& c = packing.assembly.contacts[k];
      CHECK((c.i == k && c.j == k + 1));
      samples::check_vector(c.branch, {apart, 0, 0}, 1e-14);
      samples::check_vector(force(c), {1, 0.5, 0}, 1e-14);
    }
    CHECK(packing.id == std::vector<long>{0, 3, 6, 9});
    CHECK(counted(packing, Finding::duplicated) == (both_sides ? 3 : 5));
    CHECK(counted(packing, Finding::one_sided) == (both_sides ? 1 : 0));
    CHECK_FALSE(packing.has(Finding::open_contacts));
    CHECK(packing.has(Finding::unsorted) == !both_sides);
    // No box: the smallest around the grains.
    CHECK(packing.has(Finding::cell_unknown));
    CHECK(packing.assembly.volume() == relative((3 * apart + 2) * 2 * 2, 1e-14));
  }
}

TEST_CASE("packing builder: what is refused, and from where on") {
  using Change = std::function<void(PairRow&, double)>;
  const auto threshold = [](double at, const Change& change, bool states_branch = false) {
    check_threshold(at, [&](double value) {
      PackingBuilder builder = chain(2);
      PairRow row = row_of(builder, 0, 1);
      change(row, value);
      return refusals([&] {
        if (states_branch)
          builder.require_agreement(row);
        builder.add(row);
      });
    });
  };
  threshold(4, [](PairRow& row, double x) { row.branch = {x, 0, 0}; });
  threshold(
      0.02, [](PairRow& row, double x) { row.branch.y = x; }, true);
  for (double PairRow::*const member : {&PairRow::overlap, &PairRow::normal_force, &PairRow::normal_stiffness,
                                        &PairRow::tangential_stiffness})
    threshold(1e60, [member](PairRow& row, double x) { row.*member = x; });
  threshold(1e60, [](PairRow& row, double x) { row.tangential_force.z = x; });
  check_threshold(1e60, [](double x) {
    const auto change = [x](std::size_t, GrainRow& grain) { grain.radius = x; };
    return refusals([&] { (void)chain(2, {.box = CsvBox{Mat3::identity(), {}}}, change); });
  });
  // Two rows of a pair state the same up to rounding.
  for (Vec3 PairRow::*const member : {&PairRow::branch, &PairRow::tangential_force})
    check_threshold(1e-5, [member](double x) {
      PackingBuilder builder = chain(2);
      PairRow row = row_of(builder, 0, 1);
      row.normal_force = 0;
      builder.add(row);
      (row.*member) *= 1 - x;
      builder.add(row);
      std::size_t contacts = 0; // two where branches differ, none where forces do
      (void)refusals([&] { contacts = builder.finish(0, {}).assembly.contacts.size(); });
      return contacts;
    });
  // A given box is that of the file, to 1e-4 of its longest edge.
  check_threshold(4e-4, [](double x) {
    PackingBuilder builder("grains", "contacts", {.box = CsvBox{Mat3::diagonal(4 + x, 3, 2), {}}});
    return refusals([&] { builder.set_cell(Mat3::diagonal(4, 3, 2), {}, 1); });
  });
  PackingBuilder walls = chain(1);
  const PairRow row{.branch = {1, 0, 0}};
  for (const long wall : {0L, 4294967295L})
    CHECK(refusals([&] { walls.add_wall(row, wall); }) == 0);
  for (const long wall : {-1L, 4294967296L})
    CHECK(refusals([&] { walls.add_wall(row, wall); }) == 1);
  CHECK(counted(walls.finish(0, {}), Finding::wall_contacts) == 2);
}

TEST_CASE("periodic cell: nearest and touching images are those of a search over the lattice") {
  std::mt19937 bits(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 400; ++trial) {
    const std::array<bool, 3> periodic{trial % 2 == 0, trial % 4 < 2, trial % 8 < 4};
    const bool everywhere = periodic == std::array{true, true, true}; // else edges lean a little alone
    Mat3 cell = Mat3::identity();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        cell(i, j) += (i == j ? 0.3 : everywhere ? 1.5 : 0.3) * number(bits);
    if (!(determinant(cell) > 0.1))
      continue;
    // Reduced: the same lattice, whose edges lean by no more than half of each other.
    const Mat3 given = cell;
    const bool changed = reduce_cell(cell, periodic);
    CHECK(determinant(cell) == relative(determinant(given), 1e-12));
    bool same = true;
    for (int k = 0; k < 3; ++k) {
      const Vec3 steps = inverse_of(given) * column(cell, k), edge = column(cell, k);
      for (int other = 0; other < 3; ++other) {
        const bool both = periodic[static_cast<std::size_t>(k)] && periodic[static_cast<std::size_t>(other)];
        CHECK(std::abs(steps[other] - (both ? std::round(steps[other]) : k == other)) < 1e-12);
        same = same && (std::abs(steps[other] - (k == other)) < 1e-12);
        if (both && k != other)
          CHECK(std::abs(dot(edge, column(cell, other))) <=
                0.501001 * std::max(dot(edge, edge), dot(column(cell, other), column(cell, other))));
      }
    }
    CHECK(changed == !same);
    const PeriodicCell images(cell, periodic);
    const auto wide = [&](std::size_t k) { return (periodic[k] ? 3 : 0.5) * number(bits); };
    const Vec3 from = cell * Vec3{wide(0), wide(1), wide(2)};
    const double length = (0.5 + 0.5 * number(bits)) *
                          std::min({norm(column(cell, 0)), norm(column(cell, 1)), norm(column(cell, 2))});
    double least = norm(from);
    std::vector<double> near;
    const auto reach = [&](std::size_t k) { return periodic[k] ? 12 : 0; };
    for (int a = -reach(0); a <= reach(0); ++a)
      for (int b = -reach(1); b <= reach(1); ++b)
        for (int c = -reach(2); c <= reach(2); ++c) {
          const double distance = norm(from + cell * Vec3{1.0 * a, 1.0 * b, 1.0 * c});
          least = std::min(least, distance);
          if (distance <= length)
            near.push_back(distance);
        }
    CHECK(norm(images.nearest(from)) == relative(least, 1e-12));
    std::sort(near.begin(), near.end());
    if (near.empty())
      near.push_back(least);
    const std::vector<Vec3> found = images.images(from, length);
    REQUIRE(found.size() == near.size());
    for (std::size_t k = 0; k < near.size(); ++k)
      CHECK(norm(found[k]) == relative(near[k], 1e-12));
  }
  // An edge may lean by half of another, and a thousandth for rounding.
  check_threshold(0.501, [](double lean) {
    Mat3 cell = Mat3::identity();
    cell(0, 1) = lean;
    return reduce_cell(cell, {true, true, true}) ? 1 : 0;
  });
  for (int k = 0; k < 3; ++k) {
    Mat3 cell = Mat3::diagonal(0.5, 0.5, 0.5);
    CHECK_FALSE(is_upside_down(cell));
    cell(k, k) = -0.5;
    CHECK(is_upside_down(cell));
    cell(2, 1) = 0.1;
    CHECK_FALSE(is_upside_down(cell));
  }
}

TEST_CASE("packing builder: of several images that touch, the one that fits the row, each once") {
  // Two grains of radius 1 with images on either side of each other.
  const auto second_at = [](double place, double edge) {
    const auto change = [place](std::size_t k, GrainRow& grain) {
      grain.position = {k == 0 ? 0 : place, 0, 0};
      grain.id = 7 + static_cast<long>(k);
    };
    return chain(2, {.box = CsvBox{Mat3::diagonal(edge, 9, 9), {true, false, false}}}, change);
  };
  PackingBuilder builder = second_at(1.5, 3.2);
  CHECK((builder.find(7) == 0U && builder.find(8) == 1U && !builder.find(6) && !builder.find(9)));
  CHECK(builder.ambiguous(0, 1));
  for (const auto& [direction, distance, image] :
       std::vector<std::tuple<double, std::optional<double>, double>>{
           {2, {}, 1.5}, {-2, {}, -1.7}, {0, 1.51, 1.5}, {0, 1.69, -1.7}, {3, 1.5, 1.5}, {-3, 1.69, -1.7}}) {
    PackingBuilder fresh = second_at(1.5, 3.2);
    CHECK(fresh.touching_image(0, 1, {direction, 0, 0}, distance).x == relative(image, 1e-12));
    CHECK(fresh.touching_image(1, 0, {-direction, 0, 0}, distance).x == relative(-image, 1e-12));
  }
  // Rows that say nothing go to one image after the other, from whichever side.
  CHECK(builder.touching_image(0, 1, {}, {}).x == 1.5);
  CHECK(builder.touching_image(1, 0, {}, {}).x == relative(1.7, 1e-12));
  check_threshold(1e-4, [&](double off) { // two distances that hardly differ in how well they fit
    PackingBuilder fresh = second_at(1.5, 3.2);
    return fresh.touching_image(0, 1, {}, 1.6 + off).x > 0 ? 1 : 0;
  });
  check_threshold(2.02, [&](double far) { // grains touch up to 1 % of their radii
    return second_at(1.9, 1.9 + far).ambiguous(0, 1) ? 1 : 0;
  });
}

TEST_CASE("packing builder: rows that are no contacts, or open ones, and signs of all forces") {
  const auto finished = [](std::size_t contacts,
                           const std::function<void(PackingBuilder&, PairRow&)>& change) {
    PackingBuilder builder = chain(contacts + 1);
    for (std::uint32_t k = 0; k < contacts; ++k) {
      PairRow row = row_of(builder, k, k + 1);
      change(builder, row);
      builder.add(row);
    }
    return builder.finish(0, {});
  };
  const auto neighbours = [](PackingBuilder&, PairRow& row) {
    row.overlap = -0.1, row.normal_force = 0, row.tangential_force = {};
  };
  CHECK(counted(finished(3, neighbours), Finding::open_contacts) == 3);
  CHECK(finished(3, neighbours).assembly.contacts.empty());
  const ImportedPacking open = finished(3, [](PackingBuilder&, PairRow& row) { row.overlap = 0; });
  CHECK(counted(open, Finding::open_contacts) == 3);
  CHECK(open.assembly.contacts.size() == 3);
  const ImportedPacking no_forces = finished(3, [&](PackingBuilder& builder, PairRow& row) {
    builder.expect_no_forces();
    neighbours(builder, row);
  });
  CHECK(no_forces.assembly.contacts.size() == 3);
  // All of at least ten contacts pull, though they overlap: the other sign. Bonds over gaps may pull.
  CHECK_FALSE(finished(10, [](PackingBuilder&, PairRow& row) {
                row.overlap = -0.1, row.normal_force = -1;
              }).has(Finding::signs_turned));
  for (const std::size_t contacts : {9U, 10U}) {
    const ImportedPacking pulled =
        finished(contacts, [](PackingBuilder&, PairRow& row) { row.normal_force = -1; });
    CHECK(counted(pulled, Finding::signs_turned) == (contacts < 10 ? 0 : 10));
    samples::check_vector(force(pulled.assembly.contacts.front()),
                          contacts < 10 ? Vec3{-1, 0.5, 0} : Vec3{1, -0.5, 0}, 1e-14);
  }
}

TEST_CASE("packing builder: sums of the forces beside those that the file of grains states") {
  const auto noted = [](std::size_t grains_off, double off, bool wall = false) {
    PackingBuilder builder = chain(10, {}, [&](std::size_t k, GrainRow& grain) {
      const Vec3 each = {1, 0.5, 0};
      grain.force = (k > 0 ? 1 : 0) * each - (k < 9 || wall ? 1 : 0) * each;
      if (k < grains_off)
        grain.force->x += off * norm(each);
    });
    for (std::uint32_t k = 0; k < 9; ++k)
      builder.add(row_of(builder, k, k + 1));
    if (wall) // as large a force as the others
      builder.add_wall(
          {.a = 9, .branch = {1, 0, 0}, .normal_force = 1, .tangential_force = {0, 0.5, 0}, .line = 1}, 0);
    return counted(builder.finish(0, {}), Finding::unbalanced_rows);
  };
  for (const bool wall : {false, true})
    check_threshold(0.01, [&](double off) { return noted(1, off, wall); });
  CHECK(noted(5, 1) == 5);
  CHECK(noted(6, 1) == 0); // weight
}

TEST_CASE("packing builder: few digits are those of the longest number, and round the largest") {
  DigitWatch watch;
  CHECK_FALSE(watch.few());
  for (const char* const number : {"-123.5", "0.0001234567", "7e2"})
    watch.see(number);
  CHECK(watch.few());
  CHECK(watch.most() == 7);
  CHECK(watch.rounding() == relative(0.5e-4, 1e-12));          // of 700.0000
  CHECK(watch.relative_rounding() == relative(0.5e-6, 1e-12)); // of 1.000000
  watch.see("1.2345678");
  CHECK(watch.few());
  watch.see("1.23456789");
  CHECK_FALSE(watch.few());
  CHECK(watch.rounding() == 0);
  CHECK(watch.relative_rounding() == 0);
  PackingBuilder single = chain(3);
  single.note_single_precision("");
  single.note_overlap_digits({}, "");
  single.skip_empty(2);
  const ImportedPacking packing = single.finish(0, {});
  CHECK(packing.rounding.length == relative(2 * apart * 0x1p-24, 1e-12));
  CHECK(packing.rounding.overlap == packing.rounding.length);
  CHECK(counted(packing, Finding::empty_rows) == 2);
}
