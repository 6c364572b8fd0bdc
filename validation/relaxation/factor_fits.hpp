// SPDX-License-Identifier: GPL-3.0-or-later
// The fits of the relaxation factors to the recorded networks.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include <granum/effective/uniform_field.hpp>

#include "effective/relaxation_kernel.hpp"
#include "effective/relaxed_constants.hpp"
#include "least_squares.hpp"
#include "packings.hpp"

namespace relaxation {

namespace kernel = granum::effective::kernel;

constexpr int shear_size = 8, bulk_size = 6, stretch_size = 2;
using ShearFit = Fit<shear_size>;
using BulkFit = Fit<bulk_size>;
using StretchFit = Fit<stretch_size>;

constexpr double lowest_usual_ratio = 0.5; // no-slip contacts have k_t/k_n from 2/3 to 1
constexpr double lowest_usual_coordination = 4.3;
constexpr double largest_overlap =
    0.01; // of the diameter: beyond, branches are too short for the closed form

/// Contacts that are far softer along than across serve the limits of the formula, not its use.
inline double weight(double ratio) {
  if (ratio >= 0.3)
    return 1;
  return ratio == 0.03 ? 0.3 : 0.5;
}

/// Without tangential stiffness most packings that friction holds together are floppy.
inline bool has_shear_factor(const Packing& p, const Network& n) {
  return n.ratio > 0 || shear_factor(p, n) > 0.03;
}
/// Packings whose forces need no friction are the only ones that keep a bulk modulus without it.
inline bool has_bulk_factor(const Packing& p, const Network& n) {
  return n.ratio > 0 || (p.preparation.starts_with("dense") && p.mechanical_coordination > 6);
}

/// The inputs of the formulas as constants of type T.
template <class T>
struct Inputs {
  T z, r, b;
  Inputs(const Packing& p, const Network& n) : z(p.mechanical_coordination), r(n.ratio), b(p.exponent()) {}
};

using Choice = std::function<bool(const Packing&)>;
inline bool everything(const Packing&) { return true; }

template <int n>
std::vector<Observation<n>>
observe(const std::vector<Packing>& packings, const Choice& chosen,
        bool (*usable)(const Packing&, const Network&), double (*factor)(const Packing&, const Network&),
        Dual<n> (*model)(const Dual<n>&, const Dual<n>&, const Dual<n>&, const Numbers<Dual<n>, n>&)) {
  std::vector<Observation<n>> rows;
  for (const Packing& p : packings)
    for (const Network& network : p.networks) {
      if (!p.isotropic() || !chosen(p) || !usable(p, network))
        continue;
      const Inputs<Dual<n>> in(p, network);
      rows.push_back(
          {[in, model](const Numbers<Dual<n>, n>& c) { return Dual<n>(log(model(in.z, in.r, in.b, c))); },
           std::log(factor(p, network)), weight(network.ratio), p.recipe});
    }
  return rows;
}

inline ShearFit fit_shear(const std::vector<Packing>& packings, const Choice& chosen) {
  return least_squares<shear_size>(observe<shear_size>(packings, chosen, has_shear_factor, shear_factor,
                                                       kernel::shear_relaxation<Dual<shear_size>>),
                                   {0.37, 0.25, 3.3, 0.1, 1.5, 1.2, 2.4, 3.95});
}
inline BulkFit fit_bulk(const std::vector<Packing>& packings, const Choice& chosen) {
  return least_squares<bulk_size>(observe<bulk_size>(packings, chosen, has_bulk_factor, bulk_factor,
                                                     kernel::bulk_relaxation<Dual<bulk_size>>),
                                  {0.23, 3.55, 0.17, 2.95, 0.005, 0.8});
}

inline double shear_model(const Packing& p, const Network& n, const Numbers<double, shear_size>& c) {
  const Inputs<double> in(p, n);
  return kernel::shear_relaxation(in.z, in.r, in.b, c);
}
inline double bulk_model(const Packing& p, const Network& n, const Numbers<double, bulk_size>& c) {
  const Inputs<double> in(p, n);
  return kernel::bulk_relaxation(in.z, in.r, in.b, c);
}

inline kernel::RelaxedConstants<double> constants_of(const TransverselyIsotropic& c) {
  return {c.C11, c.C33, c.C12, c.C13, c.C44};
}

/// ln of the stretch that makes C33/C11 and G_hh/G_vh of the relaxed closed form those of the network.
inline StretchFit fit_stretch(const std::vector<Packing>& packings, const ShearFit& shear,
                              const BulkFit& bulk, const Choice& chosen) {
  using D = Dual<stretch_size>;
  std::vector<Observation<stretch_size>> rows;
  for (const Packing& p : packings)
    for (const Network& network : p.networks) {
      if (p.isotropic() || !chosen(p) || network.ratio < 0.3)
        continue;
      State state = p.state;
      state.tangential_ratio = network.ratio;
      const double h = shear_model(p, network, shear.coefficients);
      const auto level = kernel::relax(constants_of(granum::effective::uniform_strain(state).stiffness),
                                       bulk_model(p, network, bulk.coefficients), h, 0.0);
      const TransverselyIsotropic& c = network.stiffness;
      const double a = state.fabric_anisotropy;
      const D log_fabric(std::log((5 + a) / (5 - 3 * a))),
          log_stress(std::log(state.stress_v / state.stress_h));
      const auto model = [=, b = D(p.exponent())](const Numbers<D, stretch_size>& k) {
        return kernel::log_stretch(D(h), b, log_fabric, log_stress, k);
      };
      rows.push_back({model, std::log(c.C33 / c.C11 / (level.C33 / level.C11)), 1, p.recipe});
      // The shear moduli respond half as much: half the weight, for the same error of a modulus.
      const double level_ratio = (level.C11 - level.C12) / 2 / level.C44;
      rows.push_back({model, -2 * std::log(c.C66() / c.C44 / level_ratio), 0.5, p.recipe});
    }
  return least_squares<stretch_size>(std::move(rows), {2.3, 0.8});
}

} // namespace relaxation
