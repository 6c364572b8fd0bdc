// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/engineering_moduli.hpp>

#include <granum/core/error.hpp>
#include <granum/elastic/eigen_system.hpp>
#include <granum/elastic/mandel.hpp>

namespace granum::elastic {

namespace {

/// 1/S_kk of one of the first three axes, S the inverse of the Mandel matrix: there it is that of Voigt.
double youngs_modulus(const EigenSystem& system, int axis) {
  constexpr double rounding = 1e-13;
  const double softest = rounding * system.values[5];
  double compliance = 0;
  for (int k = 0; k < 6; ++k) {
    const double share = system.vectors(axis, k) * system.vectors(axis, k);
    if (system.values[k] > softest)
      compliance += share / system.values[k];
    else if (share > rounding)
      return 0;
  }
  return compliance > 0 ? 1 / compliance : 0;
}

} // namespace

EngineeringModuli engineering_moduli(const VoigtStiffness& stiffness) {
  const Matrix6& c = stiffness.matrix;
  require_symmetric<6>("stiffness", c);
  const double scale = c.cwiseAbs().maxCoeff();
  if (scale == 0)
    return {};
  const Matrix6 m = mandel(VoigtStiffness{c / scale}).matrix;
  const EigenSystem system = eigen_system((m + m.transpose()) / 2);
  return {.bulk_modulus = c.topLeftCorner<3, 3>().sum() / 9,
          .E_1 = scale * youngs_modulus(system, 0),
          .E_2 = scale * youngs_modulus(system, 1),
          .E_3 = scale * youngs_modulus(system, 2),
          .C44 = c(3, 3),
          .C55 = c(4, 4),
          .C66 = c(5, 5)};
}

} // namespace granum::elastic
