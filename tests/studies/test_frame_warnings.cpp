// SPDX-License-Identifier: GPL-3.0-or-later
// Each warning of a measured frame, provoked by a file, and not there in the same file without its cause.
#include "studies/analyse/measured_frame.hpp"
#include <granum/io/mercury/output.hpp>

#include "read_specimen.hpp"
#include "studies/analyse/frame_warnings.hpp"
#include "thresholds.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

using namespace granum::samples;
using analysis::Given;

namespace {

const Given given_modulus{.grain_shear_modulus = specimen_grain.shear_modulus};

/// Everything but the network, or with it solved as told.
analysis::Wanted wanted(const std::optional<network::ResponseOptions>& network = {}) {
  analysis::Wanted out = analysis::everything();
  out.network = network;
  return out;
}

std::vector<std::string> warnings(const io::ImportedPacking& packing, const Given& given = given_modulus,
                                  const analysis::Wanted& measured = wanted()) {
  return studies::measure_frame(packing, given, measured).warnings;
}

/// Whether one of them has this number.
bool one_says(const std::vector<std::string>& all, const std::string& number) {
  return std::ranges::any_of(all, [&](const std::string& w) { return w.find(number) != std::string::npos; });
}

Given cones() {
  Given cone = given_modulus;
  cone.law_family = [](const contact::GrainMaterial& grain, double) {
    return contact::PowerLaw::cone(grain, 0.4);
  };
  return cone;
}

/// The specimen, changed, through a dump.
template <class Change>
io::ImportedPacking changed(const Change& change) {
  packing::Assembly a = specimen();
  change(a);
  return through_dump(a);
}

io::ImportedPacking from_dump(const std::string& grains, const std::string& contacts) {
  io::LammpsDump dump(io::TextSource::of_text("grains", grains),
                      io::TextSource::of_text("contacts", contacts));
  return dump.next().value();
}

} // namespace

TEST_CASE("frame warnings: a specimen at rest has none") {
  CHECK(studies::measure_frame(through_dump(specimen())).warnings.empty());
  CHECK(studies::measure_frame(through_csv(specimen()), given_modulus, wanted()).warnings.empty());
}

TEST_CASE("frame warnings: each begins at its threshold") {
  const io::ImportedPacking good = through_dump(specimen());
  studies::MeasuredFrame measured = studies::measure_frame(good, given_modulus, wanted());
  REQUIRE(measured.warnings.empty());
  REQUIRE(measured.packing.fabric->density);
  REQUIRE(measured.packing.law_check);
  using Change = void (*)(io::ImportedPacking&, analysis::Measurement&, double);
  const std::pair<double, Change> rows[] = {
      {0.2, [](auto&, auto& m, double x) { m.void_ratio = x; }},
      {3, [](auto&, auto& m, double x) { m.void_ratio = x; }},
      {10, [](auto& p, auto&, double x) { p.assembly.radius[0] *= x; }},
      {0.01, [](auto&, auto& m, double x) { m.fabric->density->chi_square.p_value = x; }},
      {0.01, [](auto&, auto& m, double x) { m.fabric->axisymmetry->both.p_value = x; }},
      {1e-3, [](auto&, auto& m, double x) { m.forces->unbalance->force_ratio = x; }},
      {0.02,
       [](auto&, auto& m, double x) {
         m.moments = "contacts carry moments";
         m.forces->unbalance = packing::Unbalance{.force_ratio = 0, .moment_ratio = x};
       }},
      {0.06,
       [](auto&, auto& m, double x) {
         m.moments = "contacts carry moments";
         m.forces->unbalance = packing::Unbalance{.force_ratio = 0.02, .moment_ratio = x};
       }},
      {0.01, [](auto&, auto& m, double x) { m.law_check->misfit_90 = x; }},
      {0.99, [](auto&, auto& m, double x) { m.law_check->coefficient_ratio = x; }},
      {1.01, [](auto&, auto& m, double x) { m.law_check->coefficient_ratio = x; }},
      {1e6, [](auto&, auto& m, double x) { m.grain->shear_modulus = x; }},
      {1e12, [](auto&, auto& m, double x) { m.grain->shear_modulus = x; }},
      {0.05,
       [](auto& p, auto& m, double x) {
         p.notes.push_back({io::Finding::units_unknown, ""});
         m.grain.reset();
         m.sizes.equivalent = x;
       }},
      {0.1,
       [](auto&, auto& m, double x) {
         m.counts.contacts = 2000;
         m.stress->symmetric = Mat3::diagonal(1, 1 + x, 1 - x);
       }},
      {0.1,
       [](auto&, auto& m, double x) {
         m.counts.contacts = 2000;
         m.stress->symmetric = Mat3::identity();
         m.stress->symmetric(0, 2) = m.stress->symmetric(2, 0) = x / 2;
       }},
      {0.4, // of a hundred contacts
       [](auto&, auto& m, double x) {
         m.counts.contacts = 100;
         m.stress->symmetric = Mat3::diagonal(1 + x, 1, 1 - x);
       }},
      {20,
       [](auto&, auto& m, double x) {
         m.counts.contacts = static_cast<std::size_t>(x);
         m.stress->symmetric = Mat3::diagonal(2, 0, 1);
       }},
  };
  for (const auto& row : rows)
    check_threshold(row.first, [&](double value) {
      io::ImportedPacking packing = good;
      studies::MeasuredFrame frame = measured;
      row.second(packing, frame.packing, value);
      studies::add_warnings(packing, frame);
      return frame.warnings.size();
    });
  const auto median = 1 / analysis::rounded_share(good.assembly, 1);
  check_threshold(0.01 * median, [&](double x) {
    io::ImportedPacking packing = good;
    packing.notes.push_back({io::Finding::few_digits, ""});
    packing.rounding.overlap = x;
    studies::MeasuredFrame frame = measured;
    studies::add_warnings(packing, frame);
    return frame.warnings.size();
  });
}

TEST_CASE("frame warnings: few digits are reported by their effect on the overlaps") {
  std::vector<double> overlaps;
  for (const packing::Contact& c : specimen().contacts)
    overlaps.push_back(c.overlap);
  std::sort(overlaps.begin(), overlaps.end());
  const double median = overlaps[overlaps.size() / 2];
  // lines of centres with all digits: those of the coordinates do not matter
  const io::ImportedPacking coordinates = through_dump(specimen(), 6);
  CHECK(coordinates.has(io::Finding::few_digits));
  CHECK(coordinates.rounding.overlap == 0);
  CHECK(warnings(coordinates).empty());
  // six digits of a millimetre: half a nanometre
  const io::ImportedPacking six = through_dump(specimen(), 6, 6);
  CHECK(six.rounding.overlap == relative(5e-10, 1e-12));
  CHECK(six.rounding.force == relative(5e-6, 1e-12));
  REQUIRE(six.rounding.overlap < 0.1 * median);
  CHECK(warnings(six).empty());
  const analysis::Measurement found = studies::measure_frame(six).packing; // G_g comes out of them
  REQUIRE(found.grain);
  CHECK(found.grain->shear_modulus ==
        relative(specimen_grain.shear_modulus, 3 * six.rounding.overlap / median));
  // four digits tell nothing of the overlaps, and leave a little on the grains
  const io::ImportedPacking four = through_dump(specimen(), 6, 4);
  CHECK(four.rounding.overlap == relative(5e-8, 1e-12));
  CHECK(one_says(warnings(four), " 4 "));
  CHECK(one_says(warnings(four), "5e-08 m"));
  CHECK_FALSE(warnings(six, cones()).empty()); // another law shows at six digits
}

TEST_CASE("frame warnings: forces of 0, a row twice, tension, and forces of another law or material") {
  CHECK_FALSE(warnings(changed([](packing::Assembly& a) {
                for (packing::Contact& c : a.contacts)
                  c.normal_force = 0, c.tangential_force = {};
              })).empty());
  const packing::Assembly& a = specimen();
  std::string contacts = dump_contacts(a, 7);
  const std::size_t row = contacts.find('\n', contacts.find("ITEM: ENTRIES id1")) + 1;
  const std::string first = contacts.substr(row, contacts.find('\n', row) + 1 - row);
  const std::string count = "ENTRIES\n" + std::to_string(a.contacts.size()) + "\n";
  const std::string more = "ENTRIES\n" + std::to_string(a.contacts.size() + 1) + "\n";
  contacts = (contacts + first).replace(contacts.find(count), count.size(), more);
  CHECK(one_says(warnings(from_dump(dump_grains(a, 7), contacts)), "1 "));

  const auto pulled = changed([](packing::Assembly& p) { p.contacts[3].normal_force *= -0.1; });
  CHECK(one_says(warnings(pulled), "1 "));
  io::ImportedPacking bonded = pulled;
  for (packing::Contact& c : bonded.assembly.contacts)
    c.rolling_stiffness = 1e-3;
  CHECK(warnings(bonded) != warnings(pulled));
  const auto damped = changed([](packing::Assembly& p) {
    for (std::size_t k = 0; k < p.contacts.size(); k += 4)
      p.contacts[k].normal_force *= 1.1;
  });
  const auto nearly = changed([](packing::Assembly& p) { p.contacts[3].normal_force *= 1.1; });
  CHECK(warnings(damped).size() > warnings(nearly).size());

  Given soft = given_modulus;
  soft.grain_shear_modulus = 20e9;
  CHECK_FALSE(warnings(through_dump(a), cones()).empty());
  CHECK(one_says(warnings(through_dump(a), soft), "1.5"));
}

TEST_CASE("frame warnings: walls among the grains, boxes with walls, or none") {
  const auto in_one_plane = [](int count) {
    return changed([count](packing::Assembly& a) {
      for (int k = 0; k < count; ++k) {
        a.position.push_back({1e-4 * k, 2e-4 * k, 1e-3});
        a.radius.push_back(specimen_radius);
      }
    });
  };
  CHECK(warnings(in_one_plane(20)).size() > warnings(in_one_plane(5)).size());
  CHECK(one_says(warnings(in_one_plane(20)), "20 "));
  CHECK_FALSE(warnings(changed([](packing::Assembly& a) {
                a.position.push_back({0, 0, 0});
                a.radius.push_back(0.1);
              })).empty());
  // the fixed faces cut no contact only where the grains are few
  const auto three = [](const std::optional<io::CsvBox>& box) {
    const std::string rows =
        "id,x_mm,y_mm,z_mm,radius_mm\n1,1,2,2,0.5\n2,1.9999,2,2,0.5\n3,1.9999,2,2.9998,0.5\n";
    return warnings(io::read_packing_csv(io::TextSource::of_text("g", rows), {}, {.box = box}));
  };
  io::CsvBox walled{Mat3::diagonal(4e-3, 4e-3, 4e-3)};
  const auto periodic = three(walled);
  walled.periodic = {true, true, false};
  CHECK(three(walled).size() > periodic.size());
  CHECK(three({}) != periodic);
}

TEST_CASE("frame warnings: contacts with walls") {
  const std::string data = "2 0 0 0 0 0.004 0.004 0.004\n0.001 0.002 0.0005 0 0 0 0.0005 0 0 0 0 0 0 0\n"
                           "0.0019999 0.002 0.0005 0 0 0 0.0005 0 0 0 0 0 0 0\n";
  const std::string pair = "# 0 1\n# 0 0 0 0.004 0.004 0.004\n# 0.0005 0.0005 0 0 0 0\n"
                           "0 1 0 0.00149995 0.002 0.0005 1e-07 0 0.0235294118 0 1 0 0 0 0 0\n"
                           "0 0 1 0.00149995 0.002 0.0005 1e-07 0 0.0235294118 0 -1 0 0 0 0 0\n";
  const std::string wall = "0 0 -1 0.001 0.002 0 1e-07 0 0.02 0 0 0 -1 0 0 0\n";
  const auto read = [&](const std::string& fstat) {
    return io::MercuryOutput(io::TextSource::of_text("d", data), io::TextSource::of_text("f", fstat))
        .next()
        .value();
  };
  const io::ImportedPacking walled = read(pair + wall);
  CHECK(warnings(walled) != warnings(read(pair)));
  const analysis::Counts counts = studies::measure_frame(walled, given_modulus, wanted()).packing.counts;
  CHECK(counts.wall_contacts == 1);
  CHECK(counts.coordination_number == 1);
  CHECK(counts.coordination_number_with_walls == 1.5);
}

TEST_CASE("frame warnings: directions that no E(gamma, a) has") {
  // every normal at 45 degrees, evenly round the axis: axisymmetric, but no such density
  io::ContactTable cone;
  for (int k = 0; k < 400; ++k)
    cone.normal.push_back(
        {std::sqrt(0.5) * std::cos(0.7 * k), std::sqrt(0.5) * std::sin(0.7 * k), std::sqrt(0.5)});
  CHECK(studies::measure_frame(cone).warnings.size() == 1);
  // normals of one vertical plane
  io::ContactTable plane;
  for (int k = 0; k < 400; ++k)
    plane.normal.push_back({std::sin(0.7 * k), 0, std::cos(0.7 * k)});
  CHECK_FALSE(studies::measure_frame(plane).warnings.empty());
}

TEST_CASE("frame warnings: too few iterations, and forces that matter compared with the stiffness") {
  const auto of = [](const Given& given, const network::ResponseOptions& options) {
    return warnings(through_csv(specimen()), given, wanted(options)).size();
  };
  CHECK(of(given_modulus, {}) == 0);
  CHECK(of(given_modulus, {.iteration_limit = 1}) > 0);
  const Given soft{.grain_shear_modulus = specimen_grain.shear_modulus / 1000}; // for the same forces
  CHECK(of(soft, {}) > warnings(through_csv(specimen()), soft).size());
}

TEST_CASE("frame warnings: strains that nothing resists are named") {
  // a straight chain through the faces of the cell bears stress along itself, and nothing else
  packing::Assembly chain{
      .cell = Mat3::diagonal(4e-3, 4e-3, 3.96e-3), .position = {}, .radius = {}, .contacts = {}};
  for (int k = 0; k < 4; ++k) {
    chain.position.push_back({2e-3, 2e-3, 0.99e-3 * k});
    chain.radius.push_back(0.5e-3);
  }
  const auto link = [&](std::uint32_t i, std::uint32_t j, double along) {
    chain.contacts.push_back({.i = i, .j = j, .branch = {0, 0, along}, .overlap = 1e-5, .normal_force = 1});
  };
  link(0, 1, 0.99e-3);
  link(0, 3, -0.99e-3);
  link(1, 2, 0.99e-3);
  link(2, 3, 0.99e-3);
  const analysis::Wanted solved = wanted(network::ResponseOptions{});
  CHECK(one_says(warnings(through_csv(chain), given_modulus, solved), " 5 ")); // of six
  // a ring of four that does not reach through the cell bears nothing at all
  packing::Assembly ring{
      .cell = Mat3::diagonal(9e-3, 9e-3, 9e-3), .position = {}, .radius = {}, .contacts = {}};
  ring.position = {
      {4e-3, 4e-3, 4e-3}, {4.99e-3, 4e-3, 4e-3}, {4.99e-3, 4.99e-3, 4e-3}, {4e-3, 4.99e-3, 4e-3}};
  ring.radius.assign(4, 0.5e-3);
  const auto pair = [&](std::uint32_t i, std::uint32_t j) {
    ring.contacts.push_back(
        {.i = i, .j = j, .branch = ring.position[j] - ring.position[i], .overlap = 1e-5, .normal_force = 1});
  };
  pair(0, 1);
  pair(0, 3);
  pair(1, 2);
  pair(2, 3);
  CHECK(warnings(through_csv(ring), given_modulus, solved).size() >
        warnings(through_csv(ring), given_modulus).size());
}
