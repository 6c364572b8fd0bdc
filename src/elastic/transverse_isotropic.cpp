// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: both the stiffness and the compliance are a block {M11, M12, M13, M33} of the normal components
// and a shear entry; one inverse of that block serves both ways.
#include <granum/elastic/transverse_isotropic.hpp>

#include <cmath>
#include <string>

#include <granum/core/error.hpp>

namespace granum::elastic {

namespace {

struct NormalBlock {
  double m11, m12, m13, m33;
};

NormalBlock block(const TransverselyIsotropic& c) { return {c.C11, c.C12, c.C13, c.C33}; }
NormalBlock block(const TransverselyIsotropicCompliance& s) { return {s.S11, s.S12, s.S13, s.S33}; }

/// m33 (m11+m12) - 2 m13^2: the determinant of the block over m11 - m12.
double axial_determinant(const NormalBlock& b) { return b.m33 * (b.m11 + b.m12) - 2 * b.m13 * b.m13; }

bool positive_definite(const NormalBlock& b, double shear) {
  return std::isfinite(b.m11) && std::isfinite(b.m33) && std::isfinite(shear) && shear > 0 &&
         b.m11 - b.m12 > 0 && b.m11 + b.m12 > 0 && axial_determinant(b) > 0;
}

void require_positive_definite(const NormalBlock& b, double shear, const char* what) {
  if (!positive_definite(b, shear))
    throw InvalidArgument(std::string("transversely isotropic ") + what +
                          " must be finite and positive definite");
}

/// The block of the stiffness, once it is known to have an inverse.
NormalBlock checked(const TransverselyIsotropic& c) {
  require_positive_definite(block(c), c.C44, "stiffness");
  return block(c);
}

NormalBlock inverse(const NormalBlock& b) {
  const double sum = b.m33 / axial_determinant(b); // of the inverse's 11 and 12 entries
  const double difference = 1 / (b.m11 - b.m12);
  return {(sum + difference) / 2, (sum - difference) / 2, -b.m13 / axial_determinant(b),
          (b.m11 + b.m12) / axial_determinant(b)};
}

} // namespace

bool TransverselyIsotropic::positive_definite() const {
  return elastic::positive_definite(block(*this), C44);
}

double TransverselyIsotropic::E_v() const {
  const NormalBlock b = checked(*this);
  return axial_determinant(b) / (b.m11 + b.m12);
}

double TransverselyIsotropic::E_h() const { return 1 / inverse(checked(*this)).m11; }

double TransverselyIsotropic::nu_vh() const {
  const NormalBlock b = checked(*this);
  return b.m13 / (b.m11 + b.m12);
}

double TransverselyIsotropic::nu_hv() const {
  const NormalBlock s = inverse(checked(*this));
  return -s.m13 / s.m11;
}

double TransverselyIsotropic::nu_hh() const {
  const NormalBlock s = inverse(checked(*this));
  return -s.m12 / s.m11;
}

std::optional<double> young_modulus(const TransverselyIsotropic& stiffness, Loading loading) {
  if (stiffness.positive_definite())
    return loading == Loading::vertical ? stiffness.E_v() : stiffness.E_h();
  const bool without_shear_stiffness = stiffness.C44 == 0 && stiffness.C66() == 0;
  return without_shear_stiffness ? std::optional(0.0) : std::nullopt;
}

TransverselyIsotropicCompliance compliance(const TransverselyIsotropic& stiffness) {
  const NormalBlock s = inverse(checked(stiffness));
  return {.S11 = s.m11, .S33 = s.m33, .S12 = s.m12, .S13 = s.m13, .S44 = 1 / stiffness.C44};
}

TransverselyIsotropic stiffness(const TransverselyIsotropicCompliance& compliance) {
  require_positive_definite(block(compliance), compliance.S44, "compliance");
  const NormalBlock c = inverse(block(compliance));
  return {.C11 = c.m11, .C33 = c.m33, .C12 = c.m12, .C13 = c.m13, .C44 = 1 / compliance.S44};
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
