// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/orientation.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using fabric::FabricMeasures;

namespace {

constexpr double place = std::numeric_limits<double>::epsilon();

void check_same(const FabricMeasures& m, const FabricMeasures& expected) {
  CHECK(std::abs(m.F11 - expected.F11) < 4 * place);
  CHECK(std::abs(m.F33 - expected.F33) < 4 * place);
  CHECK(std::abs(m.mean_cos_2gamma - expected.mean_cos_2gamma) < 8 * place);
  // rounding of F33 times its slopes, 7.5 and at most 40
  CHECK(std::abs(m.P2_coefficient - expected.P2_coefficient) < 15 * place * 2);
  CHECK(std::abs(m.anisotropy - expected.anisotropy) < 40 * place * 2);
  CHECK(m.validity.ok() == expected.validity.ok());
}

} // namespace

TEST_CASE("fabric measures: every one leads to every other") {
  for (double a = -5; a < 1.66; a += 0.09) {
    CAPTURE(a);
    const FabricMeasures m = fabric::measures_from_anisotropy(a);
    CHECK(m.anisotropy == a);
    check_same(fabric::measures_from_F33(m.F33), m);
    check_same(fabric::measures_from_P2_coefficient(m.P2_coefficient), m);
    check_same(fabric::measures_from_mean_cos_2gamma(m.mean_cos_2gamma), m);
    CHECK(fabric::measures_from_F33(m.F33).F33 == m.F33);
    CHECK(fabric::measures_from_mean_cos_2gamma(m.mean_cos_2gamma).mean_cos_2gamma == m.mean_cos_2gamma);
    CHECK(m.validity.ok() == (std::abs(a) <= 1));
  }
}

TEST_CASE("fabric measures: they are moments of the density and its coefficient in Legendre polynomials") {
  for (double a = -1; a <= 1; a += 0.125) {
    const FabricMeasures m = fabric::measures_from_anisotropy(a);
    const auto moments = fabric::second_moments(a);
    CHECK(std::abs(m.F11 - moments.F11) < 2 * place);
    CHECK(std::abs(m.F33 - moments.F33) < 2 * place);
    CHECK(std::abs(m.mean_cos_2gamma - (moments.F33 - 2 * moments.F11)) < 4 * place);
    CHECK(std::abs(fabric::anisotropy_from_F33(m.F33) - m.anisotropy) < 40 * place);
    for (double gamma = 0; gamma < 1.6; gamma += 0.2) {
      const double cosine = std::cos(gamma), P2 = (3 * cosine * cosine - 1) / 2;
      CHECK(std::abs(fabric::density(gamma, a) - (1 + m.P2_coefficient * P2) / (4 * std::numbers::pi)) <
            1e-15);
    }
  }
}

TEST_CASE("fabric measures: nearly isotropic fabric keeps its digits") {
  for (const double a_c : {1e-16, -1e-9, 1e-3}) {
    const FabricMeasures m = fabric::measures_from_P2_coefficient(a_c);
    CHECK(m.anisotropy == relative(3 * a_c / (4 + a_c), 4 * place));
    CHECK(fabric::measures_from_anisotropy(m.anisotropy).P2_coefficient == relative(a_c, 4 * place));
  }
  // the double nearest to 1/3 is below it by 2^-54/3: no rounding may hide it
  CHECK(fabric::measures_from_F33(1.0 / 3).P2_coefficient == relative(-2.5 * 0x1p-54, place));
  CHECK(fabric::measures_from_mean_cos_2gamma(-1.0 / 3).P2_coefficient == relative(1.25 * 0x1p-54, place));
}

TEST_CASE("fabric measures: the ends of the density and of all that vectors can have") {
  CHECK(fabric::measures_from_F33(0.2).anisotropy == relative(-1, 4 * place));
  CHECK(fabric::measures_from_P2_coefficient(2).F33 == relative(0.6, place));
  CHECK(fabric::measures_from_P2_coefficient(2).anisotropy == 1);
  CHECK(fabric::measures_from_P2_coefficient(-1).anisotropy == -1);
  for (const FabricMeasures& vertical :
       {fabric::measures_from_F33(1), fabric::measures_from_anisotropy(5.0 / 3),
        fabric::measures_from_P2_coefficient(5), fabric::measures_from_mean_cos_2gamma(1)}) {
    CHECK(vertical.F33 == relative(1, place));
    CHECK(vertical.F33 <= 1);
    CHECK(vertical.F11 >= 0);
    CHECK(vertical.mean_cos_2gamma <= 1);
    CHECK(vertical.anisotropy == relative(5.0 / 3, 4 * place));
    CHECK(vertical.validity.notes.size() == 1);
  }
  for (const FabricMeasures& flat :
       {fabric::measures_from_F33(0), fabric::measures_from_anisotropy(-5),
        fabric::measures_from_P2_coefficient(-2.5), fabric::measures_from_mean_cos_2gamma(-1)}) {
    CHECK(flat.F33 == 0);
    CHECK(flat.F11 == 0.5);
    CHECK(flat.anisotropy == -5);
    CHECK(flat.validity.notes.size() == 1);
  }
}

TEST_CASE("fabric measures: contact tensor of LAMMPS and fabric tensor convert into each other") {
  const Mat3 F{{{0.31, 0.02, -0.01}, {0.02, 0.28, 0.03}, {-0.01, 0.03, 0.41}}};
  const Mat3 A = fabric::contact_tensor(F);
  CHECK(std::abs(trace(A)) < 1e-15);
  CHECK(A(2, 2) == relative(fabric::measures_from_F33(0.41).P2_coefficient, 1e-14));
  CHECK(A(0, 1) == relative(0.15, 1e-15));
  const Mat3 back = fabric::fabric_from_contact_tensor(A);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(std::abs(back(i, j) - F(i, j)) < 1e-16);
  for (const double sign : {1, -1}) { // rounding of the traces
    const auto refused = [](const auto& convert, const Mat3& tensor) {
      return refusals([&] { (void)convert(tensor); });
    };
    check_threshold(1e-6, [&](double off) {
      return refused(fabric::contact_tensor, F + (sign * off / 3) * Mat3::identity());
    });
    check_threshold(1e-5, [&](double off) {
      return refused(fabric::fabric_from_contact_tensor, A + (sign * off / 3) * Mat3::identity());
    });
  }
  CHECK_THROWS_AS((void)fabric::contact_tensor(Mat3::identity()), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::fabric_from_contact_tensor(F), InvalidArgument);
  for (const auto& [i, j] : {std::pair(0, 2), std::pair(2, 0)}) { // half of each
    Mat3 half_of_F = F, half_of_A = A;
    half_of_F(i, j) = half_of_A(i, j) = 0;
    CHECK_THROWS_AS((void)fabric::contact_tensor(half_of_F), InvalidArgument);
    CHECK_THROWS_AS((void)fabric::fabric_from_contact_tensor(half_of_A), InvalidArgument);
  }
}

TEST_CASE("fabric measures: bad input") {
  for (const auto& [from, bad] : {std::pair(&fabric::measures_from_anisotropy, 1.7),
                                  {&fabric::measures_from_anisotropy, -5.1},
                                  {&fabric::measures_from_F33, 1.01},
                                  {&fabric::measures_from_F33, std::nan("")},
                                  {&fabric::measures_from_P2_coefficient, 5.1},
                                  {&fabric::measures_from_mean_cos_2gamma, -1.1}})
    CHECK_THROWS_AS((void)from(bad), InvalidArgument);
}
