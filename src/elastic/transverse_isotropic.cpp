// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: both the stiffness and the compliance are a block {M11, M12, M13, M33} of the normal components
// and a shear entry; one inverse of that block serves both ways.
#include <granum/elastic/transverse_isotropic.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/error.hpp>

namespace granum::elastic {

namespace {

struct NormalBlock {
  double m11, m12, m13, m33;
};

/// A block and its shear entry, all of them times 2^exponent. The exponent is 0 unless products of entries
/// would leave the range of a double.
struct Scaled {
  NormalBlock block;
  double shear;
  int exponent;
};

Scaled scaled(const NormalBlock& b, double shear) {
  const double largest = std::max({std::abs(b.m11), std::abs(b.m33), std::abs(shear)});
  if ((largest > 1e-90 && largest < 1e90) || !(largest > 0) || !std::isfinite(largest))
    return {b, shear, 0};
  const int e = std::ilogb(largest);
  const auto down = [e](double x) { return std::scalbn(x, -e); };
  return {{down(b.m11), down(b.m12), down(b.m13), down(b.m33)}, down(shear), e};
}
Scaled scaled(const TransverselyIsotropic& c) { return scaled({c.C11, c.C12, c.C13, c.C33}, c.C44); }
Scaled scaled(const TransverselyIsotropicCompliance& s) {
  return scaled({s.S11, s.S12, s.S13, s.S33}, s.S44);
}

/// m33 (m11+m12) - 2 m13^2: the determinant of the block over m11 - m12.
double axial_determinant(const NormalBlock& b) { return b.m33 * (b.m11 + b.m12) - 2 * b.m13 * b.m13; }

bool is_definite(const Scaled& scaled) {
  const auto& [b, shear, exponent] = scaled;
  return std::isfinite(b.m11) && std::isfinite(b.m33) && std::isfinite(shear) && shear > 0 &&
         b.m11 - b.m12 > 0 && b.m11 + b.m12 > 0 && axial_determinant(b) > 0;
}

void require_positive_definite(const Scaled& scaled, const char* what) {
  if (!is_definite(scaled))
    throw InvalidArgument(std::string("transversely isotropic ") + what +
                          " must be finite and positive definite");
}

/// The stiffness, once it is known to have an inverse.
Scaled checked(const TransverselyIsotropic& c) {
  const Scaled stiffness = scaled(c);
  require_positive_definite(stiffness, "stiffness");
  return stiffness;
}

NormalBlock inverse(const NormalBlock& b) {
  const double sum = b.m33 / axial_determinant(b); // of the inverse's 11 and 12 entries
  const double difference = 1 / (b.m11 - b.m12);
  return {(sum + difference) / 2, (sum - difference) / 2, -b.m13 / axial_determinant(b),
          (b.m11 + b.m12) / axial_determinant(b)};
}

} // namespace

bool TransverselyIsotropic::positive_definite() const { return is_definite(scaled(*this)); }

double TransverselyIsotropic::E_v() const {
  const auto [b, shear, exponent] = checked(*this);
  return std::scalbn(axial_determinant(b) / (b.m11 + b.m12), exponent);
}

double TransverselyIsotropic::E_h() const {
  const auto [b, shear, exponent] = checked(*this);
  return std::scalbn(1 / inverse(b).m11, exponent);
}

double TransverselyIsotropic::nu_vh() const {
  const NormalBlock b = checked(*this).block;
  return b.m13 / (b.m11 + b.m12);
}

double TransverselyIsotropic::nu_hv() const {
  const NormalBlock s = inverse(checked(*this).block);
  return -s.m13 / s.m11;
}

double TransverselyIsotropic::nu_hh() const {
  const NormalBlock s = inverse(checked(*this).block);
  return -s.m12 / s.m11;
}

std::optional<double> young_modulus(const TransverselyIsotropic& stiffness, Loading loading) {
  if (stiffness.positive_definite())
    return loading == Loading::vertical ? stiffness.E_v() : stiffness.E_h();
  const bool without_shear_stiffness = stiffness.C44 == 0 && stiffness.C66() == 0;
  return without_shear_stiffness ? std::optional(0.0) : std::nullopt;
}

TransverselyIsotropicCompliance compliance(const TransverselyIsotropic& stiffness) {
  const auto [c, shear, exponent] = checked(stiffness);
  const NormalBlock s = inverse(c);
  const auto back = [e = exponent](double x) { return std::scalbn(x, -e); };
  return {.S11 = back(s.m11),
          .S33 = back(s.m33),
          .S12 = back(s.m12),
          .S13 = back(s.m13),
          .S44 = 1 / stiffness.C44};
}

TransverselyIsotropic stiffness(const TransverselyIsotropicCompliance& compliance) {
  const Scaled flexible = scaled(compliance);
  require_positive_definite(flexible, "compliance");
  const NormalBlock c = inverse(flexible.block);
  const auto back = [e = flexible.exponent](double x) { return std::scalbn(x, -e); };
  return {.C11 = back(c.m11),
          .C33 = back(c.m33),
          .C12 = back(c.m12),
          .C13 = back(c.m13),
          .C44 = 1 / compliance.S44};
}

VoigtStiffness voigt(const TransverselyIsotropic& c) {
  VoigtStiffness full;
  full.matrix.topLeftCorner<3, 3>() << c.C11, c.C12, c.C13, //
      c.C12, c.C11, c.C13,                                  //
      c.C13, c.C13, c.C33;
  full.matrix(3, 3) = full.matrix(4, 4) = c.C44;
  full.matrix(5, 5) = c.C66();
  return full;
}

} // namespace granum::elastic
