// SPDX-License-Identifier: GPL-3.0-or-later
// Each plausible mistake in a file of a good packing has a sentence that names it, and the good packing has
// none.
#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "read_specimen.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/mistakes.hpp"
#include "thresholds.hpp"
#include "written_packing.hpp"

using namespace granum;
using namespace granum::samples;
using analysis::Given;

namespace {

analysis::Wanted wanted_of_mistakes() {
  analysis::Wanted out = analysis::everything();
  out.network.reset();
  return out;
}

bool warns_of_mistake(const io::ImportedPacking& packing, const std::string& words, const Given& given = {}) {
  const auto warnings = studies::measure_frame(packing, given, wanted_of_mistakes()).warnings;
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

/// The specimen through a dump, its lengths and its radii times factors, overlaps as the files then have
/// them.
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

TEST_CASE("mistakes: a good packing has none, in any unit of length") {
  CHECK(studies::measure_frame(rescaled(1, 1), {}, wanted_of_mistakes()).warnings.empty());
  CHECK(studies::measure_frame(rescaled(10, 1), {.grain_shear_modulus = 30e9}, wanted_of_mistakes())
            .warnings.size() == 1);
}

TEST_CASE("mistakes: diameters in the column of radii") {
  CHECK(warns_of_mistake(rescaled(1, 2),
                         "does the column of radii contain diameters? Halved, they give e = 0."));
  CHECK_FALSE(warns_of_mistake(rescaled(1, 2), "are in no row"));
  CHECK_FALSE(warns_of_mistake(rescaled(1, 1), "void ratio"));
}

TEST_CASE("mistakes: a box too small, and one that is mostly empty") {
  packing::Assembly a = specimen();
  a.cell(2, 2) *= 0.6;
  a.contacts.clear();
  CHECK(warns_of_mistake(through_dump(a), "no packing of grains is so dense"));
  io::ImportedPacking of_pairs = through_dump(a); // their overlaps may count twice
  for (std::uint32_t g = 0; g < a.grain_count(); ++g)
    of_pairs.assembly.body.push_back(g / 2);
  CHECK_FALSE(warns_of_mistake(of_pairs, "void ratio"));
  a.cell(2, 2) *= 10;
  CHECK(warns_of_mistake(through_dump(a), "most of the box is empty"));
}

TEST_CASE("mistakes: every contact open") {
  CHECK(warns_of_mistake(rescaled(1, 0.999), "every contact is open: the centres are 1.000"));
  CHECK(warns_of_mistake(rescaled(1, 0.999), "written with enough digits?"));
  CHECK(warns_of_mistake(rescaled(1, 0.51), "are the radii half of what they should be?"));
  CHECK_FALSE(warns_of_mistake(rescaled(1, 1), "every contact is open"));
}

TEST_CASE("mistakes: rows of contacts that are missing") {
  packing::Assembly a = specimen();
  const std::size_t all = a.contacts.size();
  for (std::size_t k = all; k-- > 0;)
    if (k % 2 == 1)
      a.contacts.erase(a.contacts.begin() + static_cast<std::ptrdiff_t>(k));
  CHECK(warns_of_mistake(through_dump(a),
                         " pairs of overlapping spheres are in no row of the contacts, and forces of "));
  packing::Assembly one = specimen();
  one.contacts.pop_back();
  CHECK_FALSE(warns_of_mistake(through_dump(one), "are in no row"));
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

TEST_CASE("mistakes: lengths in mm taken for m") {
  CHECK(warns_of_mistake(rescaled(1e3, 1), "30 GPa is shown as 30 kPa"));
  // where the law does not tell G_g, the size of the grains does
  io::ImportedPacking large = rescaled(1e3, 1);
  for (packing::Contact& c : large.assembly.contacts)
    c.normal_force = 1;
  CHECK(warns_of_mistake(large, "radii of 500 mm: are the lengths in mm?"));
}

TEST_CASE("mistakes: grains softer than rubber, harder than diamond") {
  CHECK(warns_of_mistake(rescaled(1, 1), "G_g of the grains is 1 kPa, softer than rubber",
                         {.grain_shear_modulus = 1e3}));
  CHECK(warns_of_mistake(rescaled(1, 1), "more than diamond has", {.grain_shear_modulus = 30e12}));
  CHECK_FALSE(warns_of_mistake(rescaled(1, 1), "G_g of the grains", {.grain_shear_modulus = 30e9}));
}
