// SPDX-License-Identifier: GPL-3.0-or-later
// Each warning of a measured frame, provoked by a file, and not there in the same file without its cause.
#include <algorithm>
#include <cmath>

#include "studies/analyse/measured_frame.hpp"
#include <doctest/doctest.h>
#include <granum/io/mercury/output.hpp>

#include "read_specimen.hpp"
#include "relative.hpp"
#include "studies/analyse/frame_warnings.hpp"
#include "thresholds.hpp"
#include "written_packing.hpp"

using namespace granum;
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

bool warns(const io::ImportedPacking& packing, const std::string& words, const Given& given = given_modulus,
           const analysis::Wanted& measured = wanted()) {
  for (const std::string& warning : studies::measure_frame(packing, given, measured).warnings)
    if (warning.find(words) != std::string::npos)
      return true;
  return false;
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
  CHECK_FALSE(warns(coordinates, "significant digits"));
  CHECK_FALSE(warns(coordinates, "overlaps are rounded"));
  // six digits of a millimetre: half a nanometre
  const io::ImportedPacking six = through_dump(specimen(), 6, 6);
  CHECK(six.rounding.overlap == relative(5e-10, 1e-12));
  CHECK(six.rounding.force == relative(5e-6, 1e-12));
  REQUIRE(six.rounding.overlap < 0.1 * median);
  CHECK_FALSE(warns(six, "overlaps are rounded"));
  CHECK_FALSE(warns(six, "do not follow the contact law"));
  CHECK_FALSE(warns(six, "not at rest"));
  const analysis::Measurement found = studies::measure_frame(six).packing; // G_g comes out of them
  REQUIRE(found.grain);
  CHECK(found.grain->shear_modulus ==
        relative(specimen_grain.shear_modulus, 3 * six.rounding.overlap / median));
  // four digits tell nothing of the overlaps, and leave a little on the grains
  const io::ImportedPacking four = through_dump(specimen(), 6, 4);
  CHECK(four.rounding.overlap == relative(5e-8, 1e-12));
  CHECK(warns(four, "have at most 4 significant digits: overlaps are known to 5e-08 m, "));
  CHECK(warns(four, "forces and overlaps do not give the contact law: the overlaps are rounded"));
  CHECK_FALSE(warns(four, "not at rest"));
  // another law shows at six digits
  Given cones = given_modulus;
  cones.law_family = [](const contact::GrainMaterial& g, double) { return contact::PowerLaw::cone(g, 0.4); };
  CHECK(warns(six, "do not follow the contact law", cones));
}

TEST_CASE("frame warnings: grains that touch without a force") {
  const auto none = changed([](packing::Assembly& a) {
    for (packing::Contact& c : a.contacts)
      c.normal_force = 0, c.tangential_force = {};
  });
  CHECK(warns(none, "all forces are 0"));
  const auto one = changed([](packing::Assembly& a) {
    for (std::size_t k = 1; k < a.contacts.size(); ++k)
      a.contacts[k].normal_force = 0, a.contacts[k].tangential_force = {};
  });
  CHECK_FALSE(warns(one, "all forces are 0"));
}

TEST_CASE("frame warnings: a row twice") {
  const packing::Assembly& a = specimen();
  std::string contacts = dump_contacts(a, 7);
  const std::size_t header = contacts.find("ITEM: ENTRIES id1");
  const std::size_t row = contacts.find('\n', header) + 1;
  const std::string first = contacts.substr(row, contacts.find('\n', row) + 1 - row);
  const std::string count = "ENTRIES\n" + std::to_string(a.contacts.size()) + "\n";
  const std::string more = "ENTRIES\n" + std::to_string(a.contacts.size() + 1) + "\n";
  contacts = (contacts + first).replace(contacts.find(count), count.size(), more);
  CHECK(warns(from_dump(dump_grains(a, 7), contacts), "1 rows repeat a pair"));
}

TEST_CASE("frame warnings: viscous parts show as tension, as scatter and as unrest") {
  const auto pulled = changed([](packing::Assembly& a) { a.contacts[3].normal_force *= -0.1; });
  CHECK(warns(pulled, "1 contacts are in tension"));
  CHECK_FALSE(warns(pulled, "bonds"));
  io::ImportedPacking bonded = pulled;
  for (packing::Contact& c : bonded.assembly.contacts)
    c.rolling_stiffness = 1e-3;
  CHECK(warns(bonded, "bonds"));
  const auto damped = changed([](packing::Assembly& a) {
    for (std::size_t k = 0; k < a.contacts.size(); k += 4)
      a.contacts[k].normal_force *= 1.1;
  });
  CHECK(warns(damped, "do not follow the contact law"));
  CHECK(warns(damped, "the packing is not at rest"));
  const auto nearly = changed([](packing::Assembly& a) { a.contacts[3].normal_force *= 1.1; });
  CHECK_FALSE(warns(nearly, "do not follow the contact law"));
}

TEST_CASE("frame warnings: another law, another material") {
  Given cone = given_modulus;
  cone.law_family = [](const contact::GrainMaterial& grain, double) {
    return contact::PowerLaw::cone(grain, 0.4);
  };
  CHECK(warns(through_dump(specimen()), "do not follow the contact law", cone));
  Given soft = given_modulus;
  soft.grain_shear_modulus = 20e9;
  CHECK(warns(through_dump(specimen()), "forces are 1.5 times those of the given law", soft));
}

TEST_CASE("frame warnings: walls among the grains") {
  const auto large = changed([](packing::Assembly& a) {
    a.position.push_back({0, 0, 0});
    a.radius.push_back(0.1);
  });
  CHECK(warns(large, "times the radius of the others"));
  const auto plane = changed([](packing::Assembly& a) {
    for (int k = 0; k < 20; ++k) {
      a.position.push_back({1e-4 * k, 2e-4 * k, 1e-3});
      a.radius.push_back(specimen_radius);
    }
  });
  CHECK(warns(plane, "20 grains have exactly the same z"));
  const auto few = changed([](packing::Assembly& a) {
    for (int k = 0; k < 5; ++k) {
      a.position.push_back({1e-4 * k, 2e-4 * k, 1e-3});
      a.radius.push_back(specimen_radius);
    }
  });
  CHECK_FALSE(warns(few, "grains have exactly the same"));
}

TEST_CASE("frame warnings: boxes with walls, or none") {
  const packing::Assembly& a = specimen();
  // the fixed faces cut no contact only where the grains are few
  const std::string three =
      "id,x_mm,y_mm,z_mm,radius_mm\n1,1,2,2,0.5\n2,1.9999,2,2,0.5\n3,1.9999,2,2.9998,0.5\n";
  CHECK(warns(io::read_packing_csv(io::TextSource::of_text("g", three)), "no box in the file"));
  io::CsvBox walled{Mat3::diagonal(4e-3, 4e-3, 4e-3)};
  CHECK_FALSE(
      warns(io::read_packing_csv(io::TextSource::of_text("g", three), {}, {.box = walled}), "not periodic"));
  walled.periodic = {true, true, false};
  CHECK(
      warns(io::read_packing_csv(io::TextSource::of_text("g", three), {}, {.box = walled}), "not periodic"));
  CHECK_FALSE(warns(through_csv(a), "no box"));
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
  CHECK_FALSE(warns(read(pair), "with walls"));
  const io::ImportedPacking walled = read(pair + wall);
  CHECK(warns(walled, "1 contacts with walls"));
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
  const auto warned = [](const io::ContactTable& table, const std::string& words) {
    for (const std::string& warning : studies::measure_frame(table).warnings)
      if (warning.find(words) != std::string::npos)
        return true;
    return false;
  };
  CHECK(warned(cone, "E(gamma; a) does not describe"));
  CHECK_FALSE(warned(cone, "not symmetric about z"));
  // normals of one vertical plane
  io::ContactTable plane;
  for (int k = 0; k < 400; ++k)
    plane.normal.push_back({std::sin(0.7 * k), 0, std::cos(0.7 * k)});
  CHECK(warned(plane, "not symmetric about z"));
}

TEST_CASE("frame warnings: a network that was given too few iterations") {
  CHECK_FALSE(
      warns(through_csv(specimen()), "did not converge", given_modulus, wanted(network::ResponseOptions{})));
  CHECK(warns(through_csv(specimen()), "the network did not converge", given_modulus,
              wanted(network::ResponseOptions{.iteration_limit = 1})));
}

TEST_CASE("frame warnings: forces that matter compared with the stiffness of the contacts") {
  const char* words = "change a shear modulus by";
  CHECK_FALSE(warns(through_csv(specimen()), words, given_modulus, wanted(network::ResponseOptions{})));
  const Given soft{.grain_shear_modulus = specimen_grain.shear_modulus / 1000}; // for the same forces
  CHECK(warns(through_csv(specimen()), words, soft, wanted(network::ResponseOptions{})));
  CHECK_FALSE(warns(through_csv(specimen()), words, soft));
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
  CHECK(warns(through_csv(chain), "the network does not resist 5 of six strains (", given_modulus,
              wanted(network::ResponseOptions{})));
  CHECK_FALSE(
      warns(through_csv(specimen()), "does not resist", given_modulus, wanted(network::ResponseOptions{})));
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
  CHECK(warns(through_csv(ring), "the network has no stiffness for any strain", given_modulus,
              wanted(network::ResponseOptions{})));
}
