// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/known_sands.hpp>

#include "unit.hpp"

using namespace granum::sands;

namespace {

double modulus(const char* key, const SandState& sand) {
  return shear_modulus(measured_law(key), sand).shear_modulus;
}

} // namespace

TEST_CASE("Toyoura sand at 98 kPa: 107, 88 and 71 MPa are cited at e = 0.7, 0.8 and 0.9") {
  CHECK(modulus("kokusho", {0.7, 98e3}) == relative(107e6, 0.015));
  CHECK(modulus("kokusho", {0.8, 98e3}) == relative(88e6, 0.015));
  CHECK(modulus("kokusho", {0.9, 98e3}) == relative(71e6, 0.015));
}

TEST_CASE("values worked by hand at 100 kPa, where powers of p/p_a are 1") {
  const double ulps = 4e-15;
  CHECK(modulus("hardin-richart-round", {0.5, 100e3}) == relative(6908 * 1.67 * 1.67 / 1.5 * 10 * 1e3, ulps));
  CHECK(modulus("hardin-richart-angular", {1, 100e3}) == relative(3230 * 1.97 * 1.97 / 2 * 10 * 1e3, ulps));
  CHECK(modulus("jamiolkowski", {1, 100e3}) == relative(600 * 100 * 1e3, ulps));
  CHECK(modulus("oztoprak-bolton", {1, 100e3}) == relative(5760 * 100e3 / 8, ulps));
  const double zero = 1.94 * std::exp(-0.066);
  CHECK(modulus("wichtmann-triantafyllidis", {0.5, 100e3, 1}) ==
        relative((1563 + 3.13) * (zero - 0.5) * (zero - 0.5) / 1.5 * 100e3, ulps));
}

TEST_CASE("all laws: G falls with e, grows with p, and lies within a factor of 1.8 of their mean at a usual "
          "state") {
  double sum = 0;
  for (const MeasuredLaw& law : measured_laws()) {
    CAPTURE(law.key);
    const auto G = [&](double e, double p) { return shear_modulus(law, {e, p}).shear_modulus; };
    CHECK(G(0.75, 100e3) < G(0.65, 100e3));
    CHECK(G(0.7, 200e3) > G(0.7, 100e3));
    const double s = std::log(G(0.7, 200e3) / G(0.7, 100e3)) / std::log(2.0);
    CHECK(s > 0.4);
    CHECK(s < 0.55);
    sum += std::log(G(0.7, 100e3));
  }
  for (const MeasuredLaw& law : measured_laws())
    CHECK(std::abs(std::log(shear_modulus(law, {0.7, 100e3}).shear_modulus) -
                   sum / static_cast<double>(measured_laws().size())) < std::log(1.8));
}

TEST_CASE("Wichtmann and Triantafyllidis: well graded sands are softer at the same void ratio") {
  double last = modulus("wichtmann-triantafyllidis", {0.55, 100e3, 1.5});
  for (const double uniformity : {2.0, 3.0, 5.0, 8.0}) {
    const double G = modulus("wichtmann-triantafyllidis", {0.55, 100e3, uniformity});
    CHECK(G < last);
    last = G;
  }
}

TEST_CASE("a law reports values outside of its tests") {
  const MeasuredLaw& law = measured_law("kokusho");
  CHECK(shear_modulus(law, {0.7, 98e3}).validity.ok());
  CHECK(shear_modulus(law, {0.5, 98e3}).validity.notes.size() == 1);
  CHECK(shear_modulus(law, {0.5, 5e6}).validity.notes.size() == 2);
  CHECK(shear_modulus(law, {0.7, 98e3, 30}).validity.ok()); // it does not ask for C_u
  CHECK(shear_modulus(measured_law("wichtmann-triantafyllidis"), {0.2, 98e3, 30}).validity.notes.size() == 2);
}

TEST_CASE("impossible sands are refused by a law") {
  for (const MeasuredLaw& law : measured_laws()) {
    CAPTURE(law.key);
    CHECK_THROWS_AS((void)shear_modulus(law, {0, 100e3}), InvalidArgument);
    CHECK_THROWS_AS((void)shear_modulus(law, {0.7, -1}), InvalidArgument);
    CHECK_THROWS_AS((void)shear_modulus(law, {0.7, 100e3, 0.5}), InvalidArgument);
    CHECK_THROWS_AS((void)shear_modulus(law, {0.7, 100e3, 1.5, 1}), InvalidArgument); // d50 of a metre
  }
  CHECK_THROWS_AS((void)modulus("kokusho", {2.2, 100e3}), InvalidArgument);
  CHECK_THROWS_AS((void)modulus("wichtmann-triantafyllidis", {1.9, 100e3, 3}), InvalidArgument);
  CHECK_THROWS_WITH((void)measured_law("iwasaki"),
                    doctest::Contains("hardin-richart-round, hardin-richart-angular, kokusho"));
}
