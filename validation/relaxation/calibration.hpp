// SPDX-License-Identifier: GPL-3.0-or-later
// How the coefficients of the relaxation factors follow from the recorded networks.
#pragma once

#include <algorithm>
#include <functional>

#include <granum/effective/uniform_field.hpp>

#include "effective/relaxation_kernel.hpp"
#include "least_squares.hpp"
#include "packings.hpp"

namespace relaxation {

namespace kernel = granum::effective::kernel;

constexpr int shear_size = 8, bulk_size = 6, stretch_size = 2;
using ShearFit = Fit<shear_size>;
using BulkFit = Fit<bulk_size>;
using StretchFit = Fit<stretch_size>;

constexpr double lowest_usual_ratio = 0.5; // no-slip contacts have k_t/k_n from 2/3 to 1
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
           std::log(factor(p, network)), weight(network.ratio), p.specimen});
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
      rows.push_back({model, std::log(c.C33 / c.C11 / (level.C33 / level.C11)), 1, p.specimen});
      // The shear moduli respond half as much: half the weight, for the same error of a modulus.
      const double level_ratio = (level.C11 - level.C12) / 2 / level.C44;
      rows.push_back({model, -2 * std::log(c.C66() / c.C44 / level_ratio), 0.5, p.specimen});
    }
  return least_squares<stretch_size>(std::move(rows), {2.3, 0.8});
}

// ---- scatter of specimens about the curves ----

struct Scatter {
  double base = 0; ///< relative
  double gain = 0; ///< times the sensitivity to the packing's hidden difference
};

/// The two variances, base^2 and gain^2, that make var = base^2 + gain^2 s^2 most likely.
inline Scatter fit_scatter(const std::vector<double>& errors, const std::vector<double>& sensitivities) {
  double v = 1e-3, w = 1e-4;
  for (int round = 0; round < 200; ++round) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const Eigen::Vector2d row(1, sensitivities[k] * sensitivities[k]);
      const double variance = v + w * row[1];
      normal += row * row.transpose() / (variance * variance);
      right += row * errors[k] * errors[k] / (variance * variance);
    }
    const Eigen::Vector2d next = normal.inverse() * right;
    v = std::max(next[0], 1e-8);
    w = std::max(next[1], 1e-12);
  }
  return {std::sqrt(v), std::sqrt(w)};
}

/// Hidden differences act on G as a shift of z*.
inline Scatter shear_scatter(const std::vector<Packing>& packings, const ShearFit& fit) {
  std::vector<double> errors, sensitivities;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (p.isotropic() && n.ratio >= 0.1) {
        const double h = shear_model(p, n, fit.coefficients);
        errors.push_back(std::log(h / shear_factor(p, n)));
        const Inputs<double> in(p, n);
        const Dual<1> z(in.z, 1, 0);
        const Dual<1> slope = kernel::shear_relaxation(z, Dual<1>(in.r), Dual<1>(in.b),
                                                       kernel::constants<Dual<1>>(fit.coefficients));
        sensitivities.push_back(slope.derivatives()[0] / h);
      }
  return fit_scatter(errors, sensitivities);
}

/// ... and on K as a shift of ln r: the tangential forces that a packing carries are its own.
inline Scatter bulk_scatter(const std::vector<Packing>& packings, const BulkFit& fit) {
  std::vector<double> errors, sensitivities;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (p.isotropic() && n.ratio >= 0.1) {
        const double h = bulk_model(p, n, fit.coefficients);
        errors.push_back(std::log(h / bulk_factor(p, n)));
        const Inputs<double> in(p, n);
        const Dual<1> r(in.r, 1, 0);
        const Dual<1> slope = kernel::bulk_relaxation(Dual<1>(in.z), r, Dual<1>(in.b),
                                                      kernel::constants<Dual<1>>(fit.coefficients));
        sensitivities.push_back(in.r * slope.derivatives()[0] / h);
      }
  return fit_scatter(errors, sensitivities);
}

// ---- closing gaps ----

struct ClosingGaps {
  Fit<4> growth;   ///< z_0, A, q, s
  Fit<2> rattlers; ///< c, k
  double scatter = 0;

  [[nodiscard]] double mechanical_coordination(const Packing& p) const {
    const auto& [initial, amplitude, exponent, spread] = growth.coefficients;
    return initial + amplitude * (1 - spread * p.exponent()) * std::pow(p.relative_overlap, exponent);
  }
};

/// z* = z_0 + A (1 - s b) w^q with w the relative overlap; x_0 = c exp(-k (z* - 4)).
inline ClosingGaps fit_closing_gaps(const std::vector<Packing>& packings, const std::string& preparation) {
  std::vector<Observation<4>> growth;
  std::vector<Observation<2>> rattlers;
  const auto belongs = [&](const Packing& p) {
    return p.preparation == preparation && p.relative_overlap < largest_overlap;
  };
  for (const Packing& p : packings) {
    if (!belongs(p))
      continue;
    const Dual<4> log_overlap(std::log(p.relative_overlap));
    const double b = p.exponent();
    growth.push_back({[=](const Numbers<Dual<4>, 4>& c) {
                        const Dual<4> power = c[2] * log_overlap;
                        const Dual<4> amplitude = c[1] * (1.0 - c[3] * b);
                        return Dual<4>(c[0] + amplitude * exp(power));
                      },
                      p.mechanical_coordination, 1, p.specimen});
    const Dual<2> above(p.mechanical_coordination - 4);
    rattlers.push_back({[=](const Numbers<Dual<2>, 2>& c) {
                          const Dual<2> power = -c[1] * above;
                          return Dual<2>(c[0] * exp(power));
                        },
                        p.rattler_fraction, 1, p.specimen});
  }
  ClosingGaps gaps{
      .growth = least_squares<4>(std::move(growth), {preparation == "dense" ? 6.0 : 4.0, 20, 0.5, 0.1}),
      .rattlers = least_squares<2>(std::move(rattlers), {0.1, 1})};
  double sum = 0;
  int count = 0;
  for (const Packing& p : packings)
    if (belongs(p)) {
      sum += std::pow(p.mechanical_coordination - gaps.mechanical_coordination(p), 2);
      ++count;
    }
  gaps.scatter = std::sqrt(sum / count);
  return gaps;
}

// ---- everything that relaxation_coefficients.hpp holds ----

struct Result {
  ShearFit shear;
  BulkFit bulk;
  StretchFit stretch;
  Scatter shear_scatter;
  Scatter bulk_scatter;
  ClosingGaps dense;
  ClosingGaps loose;
  double shear_by_stress = 0; ///< further error of G under unequal stresses, over |ln(stress_v/stress_h)|
  double bulk_by_stress = 0;  ///< the same of K
  double stretch_scatter = 0; ///< what is left of ln C33/C11, over ln of the stretch
};

inline bool everything(const Packing&) { return true; }

/// The relaxed closed form of one network of one state, with the coefficients of a result.
struct RelaxedState {
  kernel::RelaxedConstants<double> c;
  double log_stretch = 0;
};
inline RelaxedState relaxed_state(const Packing& p, const Network& n, const Result& result) {
  State state = p.state;
  state.tangential_ratio = n.ratio;
  const double h = shear_model(p, n, result.shear.coefficients);
  const double a = state.fabric_anisotropy;
  const double stretch =
      kernel::log_stretch(h, p.exponent(), std::log((5 + a) / (5 - 3 * a)),
                          std::log(state.stress_v / state.stress_h), result.stretch.coefficients);
  return {kernel::relax(constants_of(granum::effective::uniform_strain(state).stiffness),
                        bulk_model(p, n, result.bulk.coefficients), h, stretch),
          stretch};
}

/// How far sheared states are from the formula: C33/C11 by the stretch, G and K by the stress ratio, beyond
/// the scatter of isotropic states.
inline void fit_sheared_scatter(const std::vector<Packing>& packings, Result& result) {
  double left = 0, stretch = 0, G_left = 0, K_left = 0, stress = 0;
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (!p.isotropic() && n.ratio >= lowest_usual_ratio) {
        const auto [c, log_stretch] = relaxed_state(p, n, result);
        const TransverselyIsotropic relaxed{
            .C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
        const TransverselyIsotropic& measured = n.stiffness;
        left += std::pow(std::log(c.C33 / c.C11 / (measured.C33 / measured.C11)), 2);
        stretch += log_stretch * log_stretch;
        G_left +=
            std::pow(std::log(isotropic_shear_modulus(relaxed) / isotropic_shear_modulus(measured)), 2) -
            result.shear_scatter.base * result.shear_scatter.base;
        K_left += std::pow(std::log(relaxed.bulk_modulus() / measured.bulk_modulus()), 2) -
                  result.bulk_scatter.base * result.bulk_scatter.base;
        stress += std::pow(std::log(p.state.stress_v / p.state.stress_h), 2);
      }
  result.stretch_scatter = std::sqrt(left / stretch);
  result.shear_by_stress = std::sqrt(std::max(0.0, G_left / stress));
  result.bulk_by_stress = std::sqrt(std::max(0.0, K_left / stress));
}

inline Result fit_everything(const std::vector<Packing>& packings) {
  Result result{.shear = fit_shear(packings, everything),
                .bulk = fit_bulk(packings, everything),
                .stretch = {},
                .shear_scatter = {},
                .bulk_scatter = {},
                .dense = fit_closing_gaps(packings, "dense"),
                .loose = fit_closing_gaps(packings, "loose")};
  result.stretch = fit_stretch(packings, result.shear, result.bulk, everything);
  result.shear_scatter = shear_scatter(packings, result.shear);
  result.bulk_scatter = bulk_scatter(packings, result.bulk);
  fit_sheared_scatter(packings, result);
  return result;
}

} // namespace relaxation
