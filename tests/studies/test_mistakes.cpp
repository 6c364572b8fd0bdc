// SPDX-License-Identifier: GPL-3.0-or-later
// Each plausible mistake in a file of a good packing has a warning with its numbers, the good packing none.
#include <granum/core/units.hpp>

#include "read_specimen.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/mistakes.hpp"
#include "thresholds.hpp"
#include "written_packing.hpp"

#include "unit.hpp"

using namespace granum::samples;
using analysis::Given;

namespace {

std::vector<std::string> mistakes_in(const io::ImportedPacking& packing, const Given& given = {}) {
  analysis::Wanted wanted = analysis::everything();
  wanted.network.reset();
  return studies::measure_frame(packing, given, wanted).warnings;
}

bool one_names(const std::vector<std::string>& warnings, const std::string& number) {
  for (const std::string& warning : warnings)
    if (warning.find(number) != std::string::npos)
      return true;
  return false;
}

/// The specimen, its lengths and its radii times factors, overlaps as the files then have them.
io::ImportedPacking rescaled(double lengths, double radii) {
  packing::Assembly a = specimen();
  for (int k = 0; k < 3; ++k)
    a.cell(k, k) *= lengths;
  for (Vec3& x : a.position)
    x *= lengths;
  for (double& radius : a.radius)
    radius *= lengths * radii;
  for (packing::Contact& c : a.contacts)
    c.branch *= lengths;
  return through_dump(a);
}

/// Pairs of grains of radius 1 along x, each apart from the others: so many with a row, and without one.
io::ImportedPacking pairs(std::size_t listed, std::size_t missing, double overlap, double missing_overlap) {
  io::ImportedPacking packing;
  packing::Assembly& a = packing.assembly;
  a.cell = Mat3::diagonal(600, 10, 10);
  for (std::uint32_t k = 0; k < listed + missing; ++k) {
    const double deep = k < listed ? overlap : missing_overlap;
    a.position.insert(a.position.end(), {{5.0 * k + 1, 5, 5}, {5.0 * k + 3 - deep, 5, 5}});
    a.radius.insert(a.radius.end(), 2, 1.0);
    if (k < listed)
      a.contacts.push_back({.i = 2 * k, .j = 2 * k + 1, .branch = {2 - deep, 0, 0}, .overlap = deep});
  }
  for (std::size_t g = 0; g < a.grain_count(); ++g)
    packing.id.push_back(static_cast<long>(100 + g));
  return packing;
}

std::vector<std::string> found_in(const io::ImportedPacking& packing, double void_ratio = 0.6,
                                  studies::MeasuredFrame frame = {}) {
  frame.packing.void_ratio = void_ratio;
  std::vector<std::string> out;
  studies::judge_mistakes(packing, frame, out);
  return out;
}

} // namespace

TEST_CASE(
    "mistakes: a good packing has none, units and materials that are not its own are named with numbers") {
  io::ImportedPacking no_law = rescaled(1e3, 1); // there the size of the grains shows what G_g does not
  for (packing::Contact& c : no_law.assembly.contacts)
    c.normal_force = 1;
  CHECK(one_names(mistakes_in(no_law), "500 mm"));
  CHECK(one_names(mistakes_in(rescaled(1, 2)), "e = 0.")); // diameters, which are halved
  CHECK(one_names(mistakes_in(rescaled(1, 0.999)), "1.000"));
  CHECK_FALSE(mistakes_in(rescaled(1, 0.51)).empty());
  CHECK(one_names(mistakes_in(rescaled(1e3, 1)), "30 kPa"));
  CHECK(mistakes_in(rescaled(10, 1), {.grain_shear_modulus = 30e9}).size() == 1);
  CHECK(mistakes_in(rescaled(1, 1)).empty());
  CHECK(mistakes_in(rescaled(1, 1), {.grain_shear_modulus = 30e9}).empty());
}

TEST_CASE("mistakes: a box too small, but for overlaps of bodies") {
  packing::Assembly a = specimen();
  a.cell(2, 2) *= 0.6;
  a.contacts.clear();
  io::ImportedPacking of_pairs = through_dump(a); // their overlaps may count twice
  for (std::uint32_t g = 0; g < a.grain_count(); ++g)
    of_pairs.assembly.body.push_back(g / 2);
  CHECK(mistakes_in(of_pairs).size() + 1 == mistakes_in(through_dump(a)).size());
}

TEST_CASE("mistakes: rows are missed from a tenth of the usual overlap on, more than one in twenty of them") {
  const auto noted = [](std::size_t listed, std::size_t missing, double overlap) {
    return found_in(pairs(listed, missing, 1e-3, overlap * 1e-3)).size();
  };
  check_threshold(0.1, [&](double overlap) { return noted(20, 5, overlap); });
  CHECK(noted(95, 5, 1) == 0);
  CHECK(noted(94, 6, 1) == 1);
  const io::ImportedPacking some = pairs(20, 5, 1e-3, 1e-3);
  CHECK((one_names(found_in(some), "5 of 25 ") && found_in(some, -0.5).size() == 1));
  check_threshold(0.5e-4, [&](double digits) { // half a tenth of the usual overlap
    io::ImportedPacking packing = some;
    packing.rounding.length = digits;
    return found_in(packing).size();
  });
  check_threshold(0.2, [&](double e) { return one_names(found_in(some, e), "5 of 25 "); });
  io::ImportedPacking bodies = some;
  for (std::uint32_t g = 0; g < 50; ++g)
    bodies.assembly.body.push_back(g / 2);
  CHECK(found_in(bodies).empty());
  for (const io::Finding finding : {io::Finding::contacts_from_overlaps, io::Finding::cell_unknown}) {
    io::ImportedPacking excused = some;
    excused.notes.push_back({finding, ""});
    CHECK(found_in(excused).empty());
  }
  check_threshold(0.05, [&](double left) { // the forces on the grains are a sign of it from here on
    studies::MeasuredFrame frame;
    frame.packing.forces.emplace().unbalance.emplace().force_ratio = left;
    return one_names(found_in(some, 0.6, frame), "5.0");
  });
}

TEST_CASE("mistakes: the cause that is named changes at its threshold") {
  const auto words = [](double e, double distance, double overlap) { // of grains whose radii add up to 2
    io::ImportedPacking packing = pairs(4, 0, 2 * (1 - distance), 0);
    for (packing::Contact& c : packing.assembly.contacts)
      c.overlap = overlap;
    std::string text;
    for (const std::string& found : found_in(packing, e))
      text += found;
    std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
    return text;
  };
  const auto differ = [](const std::string& a, const std::string& b) {
    return !a.empty() && !b.empty() && a != b;
  };
  CHECK(differ(words(0.1, 0.749, 1e-3), words(0.1, 0.751, 1e-3)));
  CHECK(differ(words(0.6, 1.899, 0), words(0.6, 1.901, 0)));
  CHECK(differ(words(0.6, 0.999, 0), words(0.6, 1.001, 0)));
  CHECK(words(0.6, 1.1, 1e-3).empty());
  const std::vector<std::string> halved = found_in(pairs(4, 0, 0.6, 0), 0.1); // (1 + 0.1) 2^3 - 1
  CHECK((one_names(halved, " 70 %") && one_names(halved, " 7.8")));
  const auto shown = [](double modulus) { // "Then G in mm is shown as G" from 1e8 on
    studies::MeasuredFrame frame;
    frame.packing.grain = contact::GrainMaterial{modulus, 0.2};
    frame.packing.law_check.emplace();
    return one_names(found_in(pairs(4, 0, 1e-3, 0), 0.6, frame), pretty(1e6 * modulus, Dimension::pressure));
  };
  check_threshold(100, shown);
  CHECK((shown(3e4) && !shown(2e12)));
}

TEST_CASE("mistakes: grains at the place of another are counted, the first two by their ids") {
  io::ImportedPacking packing = pairs(4, 0, 1e-3, 0);
  const Vec3 at = packing.assembly.position[5];
  packing.assembly.position[2] = packing.assembly.position[7] = at;
  const std::vector<std::string> found = found_in(packing);
  CHECK((one_names(found, "2 grains") && one_names(found, "102 and 105")));
}
