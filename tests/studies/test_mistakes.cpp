// SPDX-License-Identifier: GPL-3.0-or-later
// Each plausible mistake in a file of a good packing has a warning with its numbers, the good packing none.
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
    io::ImportedPacking packing;
    packing::Assembly& a = packing.assembly;
    a.cell = Mat3::diagonal(600, 10, 10);
    for (std::uint32_t k = 0; k < listed + missing; ++k) { // pairs along x, each apart from the others
      const double deep = 1e-3 * (k < listed ? 1 : overlap);
      a.position.insert(a.position.end(), {{5.0 * k + 1, 5, 5}, {5.0 * k + 3 - deep, 5, 5}});
      a.radius.insert(a.radius.end(), 2, 1.0);
      if (k < listed)
        a.contacts.push_back({.i = 2 * k, .j = 2 * k + 1, .branch = {2 - deep, 0, 0}, .overlap = deep});
    }
    for (std::size_t g = 0; g < a.grain_count(); ++g)
      packing.id.push_back(static_cast<long>(g));
    studies::MeasuredFrame frame;
    frame.packing.void_ratio = 0.6;
    std::vector<std::string> out;
    studies::judge_mistakes(packing, frame, out);
    return out.size();
  };
  check_threshold(0.1, [&](double overlap) { return noted(20, 5, overlap); });
  CHECK(noted(95, 5, 1) == 0);
  CHECK(noted(94, 6, 1) == 1);
}
