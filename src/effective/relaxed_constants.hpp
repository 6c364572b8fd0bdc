// SPDX-License-Identifier: GPL-3.0-or-later
// Unchecked formulas from the stiffness of uniform strain and the relaxation factors to the relaxed
// stiffness, templates on the number type. Private as those of relaxation_kernel.hpp.
#pragma once

#include <cmath>

#include "relaxation_coefficients.hpp"

namespace granum::effective::kernel {

/// Overlap over the diameter up to which branches are shortened: beyond, grains are no longer grains.
inline constexpr double longest_shortening = 0.1;

/// Factor of all moduli for branches l = D (1 - w) that overlaps shorten, where uniform strain takes l = D:
/// the moduli go as k_n l^2, k_n as f^b, and the force as 1/l at a given stress. K of uniform strain of
/// recorded packings agrees within 6 % of the change [validation/relaxation].
/// \param  w   mean overlap over the diameter, up to longest_shortening
template <class T>
T shortened_branches(const T& w, const T& b) {
  using std::exp;
  using std::log;
  const T left = 1.0 - w, power = 2.0 - b;
  return exp(T(power * log(left)));
}

/// The relaxed stiffness from that of uniform strain. The amplitudes of volumetric and deviatoric strain are
/// multiplied by sqrt(bulk) and sqrt(shear); then the axis is stretched against the plane at constant volume,
/// so that C33/C11 grows by the factor stretch. Both steps are congruences: they preserve symmetry, positive
/// definiteness and transverse isotropy, and turn an isotropic stiffness at stretch 1 into (bulk K, shear G)
/// exactly.
template <class T>
struct RelaxedConstants {
  T C11, C33, C12, C13, C44;
};
template <class T>
T bulk_modulus(const RelaxedConstants<T>& c) {
  return (2.0 * c.C11 + c.C33 + 2.0 * c.C12 + 4.0 * c.C13) / 9.0;
}
/// Before its upper bound is applied.
template <class T>
RelaxedConstants<T> unbounded_relax(const RelaxedConstants<T>& c, const T& bulk, const T& shear,
                                    const T& log_stretch) {
  using std::exp;
  using std::sqrt;
  // M = sqrt(bulk) J + sqrt(shear) (1 - J), J the volumetric projector: s 1 + t J. On the normal block,
  // (M C M)_ij = s^2 C_ij + s t (p_i + p_j)/3 + t^2 p/9 with p_i the row sums and p their sum.
  const T s = sqrt(shear);
  const T t = sqrt(bulk) - s;
  const T row_h = c.C11 + c.C12 + c.C13;
  const T row_v = c.C33 + 2.0 * c.C13;
  const T mean = (2.0 * row_h + row_v) / 9.0;
  const T common = t * t * mean;
  const T hh = 2.0 / 3.0 * s * t * row_h + common;
  const T vv = 2.0 / 3.0 * s * t * row_v + common;
  const T hv = s * t * (row_h + row_v) / 3.0 + common;
  const T sixth = exp(log_stretch / 6.0);
  const T plane = 1.0 / (sixth * sixth);
  const T axis = sixth * sixth * sixth * sixth;
  return {T(plane * (shear * c.C11 + hh)), T(axis * (shear * c.C33 + vv)), T(plane * (shear * c.C12 + hh)),
          T(sixth * (shear * c.C13 + hv)), T(sixth * shear * c.C44)};
}

/// Fabric and stresses far beyond the calibration, both along the axis, give a stretch that raises K above
/// that of uniform strain, its upper bound: then all constants are scaled down to it.
template <class T>
RelaxedConstants<T> relax(const RelaxedConstants<T>& c, const T& bulk, const T& shear, const T& log_stretch) {
  const RelaxedConstants<T> r = unbounded_relax(c, bulk, shear, log_stretch);
  const T bound = bulk_modulus(c), K = bulk_modulus(r);
  if (!(K > bound && bound > 0.0))
    return r;
  const T share = bound / K;
  return {T(share * r.C11), T(share * r.C33), T(share * r.C12), T(share * r.C13), T(share * r.C44)};
}

/// ln of that stretch: directions with more or stiffer contacts relax less than the average.
/// \param  log_fabric  ln(F33/F11);  \param  log_stress  ln(stress_v/stress_h)
template <class T>
T log_stretch(const T& shear, const T& b, const T& log_fabric, const T& log_stress,
              const StretchCoefficients<T>& c) {
  const T anisotropy = c[0] * log_fabric + c[1] * b * log_stress;
  return (1.0 - shear) * anisotropy;
}

} // namespace granum::effective::kernel
