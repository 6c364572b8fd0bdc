// SPDX-License-Identifier: GPL-3.0-or-later
// The uniform-field estimates with their derivatives: the kernels at dual numbers. Slow to compile.
#pragma once

#include <cmath>
#include <optional>

#include <granum/effective/sensitivity/gradients.hpp>

#include "dual_moduli.hpp"
#include "effective/checked_state.hpp"

namespace granum::effective::kernel {

/// d ln k_n/d alpha at a given force and a given profile constant A; 0 for the flat punch, where A^(-1/alpha)
/// is its radius.
double log_stiffness_by_shape(const contact::PowerLaw& law, double log_force);

/// k_n of the force area x load, by the chain rule of ln k_n. All seeds: of the power family alone.
template <int N>
Dual<N> contact_stiffness(const contact::NormalLaw& law, const Dual<N>& area, const Dual<N>& load) {
  const double value = contact_stiffness(law, area.value(), load.value());
  Dual<N> k(value, (area.derivatives() / area.value() + load.derivatives() / load.value()) *
                       (value * law.exponent_at_force(area.value() * load.value())));
  if constexpr (shape < N)
    k.derivatives()[shape] +=
        value * log_stiffness_by_shape(*law.power_law(), std::log(area.value()) + std::log(load.value()));
  return k;
}

/// Means of f^exponent over the directions; each is compiled by the one source that needs it.
AxialMoments<Dual<stress_seeds>> moments_of(const Dual<stress_seeds>& a, const Dual<stress_seeds>& root,
                                            const Dual<stress_seeds>& exponent);
AxialMoments<Dual<all_seeds>> moments_of(const Dual<all_seeds>& a, const Dual<all_seeds>& root,
                                         const Dual<all_seeds>& exponent);

/// Means of k_n^(+1 or -1) over those at the reference force, for a law whose b is not the same at every force.
AxialMoments<Dual<stress_seeds>> moments_of(const Dual<stress_seeds>& a, const Dual<stress_seeds>& root,
                                            const StiffnessRatio<Dual<stress_seeds>>& weight);

/// The stiffness of a model with derivatives by the first N seeds. Assumes a checked, loaded state.
template <int N>
Constants<Dual<N>> differentiated(const State& s, const Model& model) {
  using T = Dual<N>;
  const T stress_v = log_seeded<N>(s.stress_v, log_stress_v);
  const T stress_h = log_seeded<N>(s.stress_h, log_stress_h);
  const T a = seeded<N>(s.fabric_anisotropy, anisotropy);
  const T r = seeded<N>(s.tangential_ratio, ratio);
  const Geometry<T> packing =
      geometry(log_seeded<N>(s.coordination_number, log_coordination), log_seeded<N>(s.radius, log_radius),
               seeded<N>(s.void_ratio, voids), s.contacts);
  const AxialMoments<T> fabric = fabric_moments(a);
  const bool by_stress = model.hypothesis == Hypothesis::uniform_stress;

  AxialMoments<T> moments = fabric;
  T load = stress_v + 2 * stress_h;
  if (model.forces == ContactForces::by_direction) {
    const NormalLoads<T> loads = static_loads(a, stress_v, stress_h);
    const T root = sqrt(T(loads.horizontal / loads.vertical));
    load = root * loads.vertical;
    const double sign = by_stress ? -1 : 1;
    if (const std::optional<double> b = s.law.constant_exponent())
      moments = moments_of(a, root, seeded<N>(sign * *b, shape, -sign * *b * *b)); // d b/d alpha = -b^2
    else if constexpr (N == stress_seeds)
      moments = moments_of(a, root,
                           StiffnessRatio<T>{.law = s.law,
                                             .reference = packing.force_area * load,
                                             .stiffness = contact_stiffness(s.law, packing.force_area, load),
                                             .inverse = by_stress});
  }
  const T stiffness = contact_stiffness(s.law, packing.force_area, load);
  if (by_stress)
    return uniform_stress(T(packing.static_prefactor * stiffness), r, fabric, moments);
  return uniform_strain(T(packing.prefactor * stiffness), r, moments,
                        model.hypothesis == Hypothesis::free_spin ? Spin::free : Spin::none);
}

} // namespace granum::effective::kernel
