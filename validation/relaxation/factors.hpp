// SPDX-License-Identifier: GPL-3.0-or-later
// The fits of the relaxation factors to the recorded networks, and their errors.
#pragma once

#include <granum/effective/uniform_field.hpp>

#include "../common.hpp"
#include "effective/relaxation_kernel.hpp"
#include "effective/relaxed_constants.hpp"
#include "least_squares.hpp"
#include "packings.hpp"
#include "scatter.hpp"

namespace relaxation {

namespace kernel = granum::effective::kernel;

constexpr double lowest_usual_ratio = 0.5; // no-slip contacts have k_t/k_n from 2/3 to 1
constexpr double lowest_usual_coordination = 4.3;
constexpr double largest_overlap =
    0.01; // of the diameter: beyond, branches are too short for the closed form

using Choice = std::function<bool(const Packing&)>;
using Label = std::function<std::string(const Packing&)>;
inline bool everything(const Packing&) { return true; }
inline bool is_isotropic(const Packing& p) { return p.isotropic(); }
inline bool is_sheared(const Packing& p) { return !p.isotropic(); }
inline std::string preparation_of(const Packing& p) { return unsheared(p.preparation); }

// ---- the two factors ----

/// What is measured are moduli over those of uniform strain with the network's own stiffnesses, times what
/// these differ from the closed form. Of equal grains the lengths of the branches drop out.
struct Shear {
  static constexpr int size = 8;
  static constexpr Numbers<double, size> start{0.37, 0.25, 3.3, 0.1, 1.5, 1.2, 2.4, 3.95};
  static constexpr bool hides_contacts = true; ///< what is hidden acts as a shift of z*

  template <class T>
  static T model(const T& z, const T& r, const T& b, const Numbers<T, size>& c) {
    return kernel::shear_relaxation(z, r, b, c);
  }
  static double measured(const Packing& p, const Network& n) {
    const double affine = 0.3 * p.strain_bulk_modulus * (2 + 3 * n.ratio);
    return p.affine_share * isotropic_shear_modulus(n.stiffness) / affine;
  }
  /// Without tangential stiffness most packings that friction holds together are floppy.
  static bool usable(const Packing& p, const Network& n) { return n.ratio > 0 || measured(p, n) > 0.03; }
};

struct Bulk {
  static constexpr int size = 6;
  static constexpr Numbers<double, size> start{0.23, 3.55, 0.17, 2.95, 0.005, 0.8};
  /// What is hidden acts as a shift of ln r: the tangential forces that a packing carries are its own.
  static constexpr bool hides_contacts = false;

  template <class T>
  static T model(const T& z, const T& r, const T& b, const Numbers<T, size>& c) {
    return kernel::bulk_relaxation(z, r, b, c);
  }
  static double measured(const Packing& p, const Network& n) {
    return p.affine_share * n.stiffness.bulk_modulus() / p.strain_bulk_modulus;
  }
  /// Packings whose forces need no friction are the only ones that keep a bulk modulus without it.
  static bool usable(const Packing& p, const Network& n) {
    return n.ratio > 0 || (p.preparation.starts_with("dense") && p.mechanical_coordination > 6);
  }
};

template <class Of>
struct FactorFit : Fit<Of::size> {
  ScatterParts scatter;
};

template <class Of>
double value(const FactorFit<Of>& fit, const Packing& p, const Network& n) {
  return Of::template model<double>(p.mechanical_coordination, n.ratio, p.exponent(), fit.coefficients);
}

template <class Of>
Residual residual(const FactorFit<Of>& fit, const Packing& p, const Network& n) {
  using D = Dual<1>;
  D z(p.mechanical_coordination), r(n.ratio);
  (Of::hides_contacts ? z : r).slopes[0] = 1;
  const D h = Of::template model<D>(z, r, p.exponent(), kernel::constants<D>(fit.coefficients));
  return {p.recipe, std::log(h.value / Of::measured(p, n)),
          (Of::hides_contacts ? 1 : n.ratio) * h.slopes[0] / h.value};
}

/// Standard error of ln of a factor of that sensitivity for a packing of another recipe: of the coefficients,
/// and the scatter.
template <class Of>
double stated_error(const FactorFit<Of>& fit, const Packing& p, const Network& n, double sensitivity) {
  using D = Dual<Of::size>;
  const D h = Of::template model<D>(p.mechanical_coordination, n.ratio, p.exponent(), fit.duals());
  double variance = 0;
  for (std::size_t j = 0; j < h.slopes.size(); ++j)
    for (std::size_t k = 0; k < h.slopes.size(); ++k)
      variance += h.slopes[j] * fit.covariance[j][k] * h.slopes[k];
  return std::hypot(std::sqrt(variance) / h.value, fit.scatter.deviation(sensitivity));
}

/// Contacts that are far softer along than across serve the limits of the formula, not its use.
inline double weight(double ratio) { return ratio >= 0.3 ? 1 : ratio == 0.03 ? 0.3 : 0.5; }

/// To the isotropic states among the chosen packings; the scatter is that of networks that are not much
/// softer along their contacts than across.
template <class Of>
FactorFit<Of> fit_factor(const std::vector<Packing>& packings, const Choice& chosen) {
  constexpr double lowest_ratio = 0.1;
  using D = Dual<Of::size>;
  std::vector<Observation<Of::size>> rows;
  const auto each = [&](const auto& take) {
    for (const Packing& p : packings)
      for (const Network& n : p.networks)
        if (p.isotropic() && chosen(p))
          take(p, n);
  };
  each([&](const Packing& p, const Network& n) {
    if (Of::usable(p, n))
      rows.push_back({[z = p.mechanical_coordination, r = n.ratio, b = p.exponent()](
                          const Numbers<D, Of::size>& c) { return log(Of::template model<D>(z, r, b, c)); },
                      std::log(Of::measured(p, n)), weight(n.ratio), p.recipe});
  });
  FactorFit<Of> fit{least_squares<Of::size>(std::move(rows), Of::start), {}};
  std::vector<Residual> residuals;
  each([&](const Packing& p, const Network& n) {
    if (n.ratio >= lowest_ratio)
      residuals.push_back(residual(fit, p, n));
  });
  fit.scatter = scatter_parts(residuals);
  return fit;
}

/// What the fit to equal grains says.
struct EqualFit {
  FactorFit<Shear> shear;
  FactorFit<Bulk> bulk;
};
inline EqualFit fit_equal(const std::vector<Packing>& packings, const Choice& chosen) {
  return {fit_factor<Shear>(packings, chosen), fit_factor<Bulk>(packings, chosen)};
}

// ---- the stretch ----

using StretchFit = Fit<2>;

inline kernel::RelaxedConstants<double> constants_of(const TransverselyIsotropic& c) {
  return {c.C11, c.C33, c.C12, c.C13, c.C44};
}

/// The relaxed closed form of one network of one state.
struct RelaxedState {
  double h = 0, log_fabric = 0, log_stress = 0, log_stretch = 0;
  kernel::RelaxedConstants<double> c = {};
};
inline RelaxedState relaxed_state(const Packing& p, const Network& n, const EqualFit& fit,
                                  const Numbers<double, 2>& stretch) {
  State state = p.state;
  state.tangential_ratio = n.ratio;
  const double a = state.fabric_anisotropy;
  RelaxedState r{.h = value(fit.shear, p, n),
                 .log_fabric = std::log((5 + a) / (5 - 3 * a)),
                 .log_stress = std::log(state.stress_v / state.stress_h)};
  r.log_stretch = kernel::log_stretch(r.h, p.exponent(), r.log_fabric, r.log_stress, stretch);
  r.c = kernel::relax(constants_of(granum::effective::uniform_strain(state).stiffness), value(fit.bulk, p, n),
                      r.h, r.log_stretch);
  return r;
}

/// ln of the stretch that makes C33/C11 and G_hh/G_vh of the relaxed closed form those of the network.
inline StretchFit fit_stretch(const std::vector<Packing>& packings, const EqualFit& equal) {
  using D = Dual<2>;
  std::vector<Observation<2>> rows;
  for (const Packing& p : packings)
    for (const Network& network : p.networks) {
      if (p.isotropic() || network.ratio < 0.3)
        continue;
      const RelaxedState level = relaxed_state(p, network, equal, {});
      const TransverselyIsotropic& c = network.stiffness;
      const auto model = [=, b = p.exponent()](const Numbers<D, 2>& k) {
        return kernel::log_stretch<D>(level.h, b, level.log_fabric, level.log_stress, k);
      };
      rows.push_back({model, std::log(c.C33 / c.C11 / (level.c.C33 / level.c.C11)), 1, p.recipe});
      // The shear moduli respond half as much: half the weight, for the same error of a modulus.
      const double level_ratio = (level.c.C11 - level.c.C12) / 2 / level.c.C44;
      rows.push_back({model, -2 * std::log(c.C66() / c.C44 / level_ratio), 0.5, p.recipe});
    }
  return least_squares<2>(std::move(rows), {2.3, 0.8});
}

// ---- errors ----

/// Of the factors of isotropic states, k_t/k_n from low to high.
inline ErrorsOfBoth errors_of(const std::vector<Packing>& packings, const EqualFit& fit, double low,
                              double high, const Choice& chosen) {
  ErrorsOfBoth errors;
  for (const Packing& p : packings)
    for (const Network& n : p.networks) {
      if (!p.isotropic() || !chosen(p) || n.ratio < low || n.ratio > high)
        continue;
      if (Shear::usable(p, n))
        errors.G.add(value(fit.shear, p, n) / Shear::measured(p, n) - 1);
      if (Bulk::usable(p, n))
        errors.K.add(value(fit.bulk, p, n) / Bulk::measured(p, n) - 1);
    }
  return errors;
}

/// Each value that a label has among isotropic packings left out in turn: errors printed, and all together.
/// \param    errors_without   takes the choice of what is left out, and that of what is kept
template <class ErrorsWithout>
ErrorsOfBoth left_out(const std::vector<Packing>& packings, const std::string& title, const Label& label,
                      const ErrorsWithout& errors_without) {
  std::set<std::string> values;
  for (const Packing& p : packings)
    if (p.isotropic())
      values.insert(label(p));
  ErrorsOfBoth all;
  for (const std::string& value : values) {
    const Choice left = [&](const Packing& p) { return label(p) == value; };
    const ErrorsOfBoth here = errors_without(left, [&](const Packing& p) { return !left(p); });
    print_errors("  without " + title + " " + value, here);
    all.add(here);
  }
  print_errors("left out by " + title + ", together", all);
  return all;
}

} // namespace relaxation
