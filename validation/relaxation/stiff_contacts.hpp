// SPDX-License-Identifier: GPL-3.0-or-later
// How the factors go on where the packings of the fit end: networks with k_n ~ f^b on recorded packings
// beyond b = 1/2 (exponents.csv), and packings of rough grains beyond b = 1/3 (rough.csv).
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <granum/contact/power_law.hpp>

#include "coverage.hpp"
#include "reading.hpp"
#include "scatter.hpp"
#include "size_coverage.hpp"

namespace relaxation {

/// One network of a packing of equal grains: the factors of G and K over the closed form, which takes k_n at
/// the mean force.
struct StiffNetwork {
  bool rough = false;
  std::string contact; ///< of the packing
  std::string preparation;
  std::string packing; ///< whose networks are not independent of one another
  int seed = 0;
  double b = 0;
  double z = 0;
  double ratio = 0; ///< k_t/k_n
  double G = 0, K = 0;

  [[nodiscard]] std::string recipe() const { return contact + " " + preparation; }
  /// Fits see the first seed of a record, others judge.
  [[nodiscard]] bool fitted() const { return seed % 100 == 0; }
  [[nodiscard]] bool beyond() const { return b > (rough ? kernel::rough_spheres : kernel::power_laws).from; }
};

/// \param    rough   whether the file is rough.csv
inline std::vector<StiffNetwork> read_stiff_networks(const std::string& path, bool rough) {
  struct Suffix {
    const char* text;
    double value;
  };
  static constexpr Suffix exponents[] = {{"0", 0},           {"0.333", 1.0 / 3}, {"0.5", 0.5},
                                         {"0.667", 2.0 / 3}, {"0.8", 0.8},       {"1", 1}};
  static constexpr Suffix ratios[] = {{"0.6", 0.6}, {"0.919", 0.918918918918919}};
  const granum::io::CsvTable table = granum::io::read_csv(path);
  std::vector<StiffNetwork> all;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::vector<std::string>& fields = table.fields(k);
    const detail::Row row = detail::numbers(table.headings(), fields);
    if (row.at("z_star") < lowest_usual_coordination ||
        (!rough && detail::relative_overlap(detail::state(row, fields[0], 1)) > largest_overlap))
      continue;
    const auto add = [&](const std::string& b_text, double b) {
      for (const auto& [r_text, r] : ratios)
        all.push_back({.rough = rough,
                       .contact = fields[0],
                       .preparation = fields[1],
                       .packing = fields[0] + " " + fields[1] + " " + fields[2] + " " + fields[4],
                       .seed = static_cast<int>(row.at("seed")),
                       .b = b,
                       .z = row.at("z_star"),
                       .ratio = r,
                       .G = row.at("G_" + b_text + "_" + r_text),
                       .K = row.at("K_" + b_text + "_" + r_text)});
    };
    if (rough)
      add("own", row.at("b"));
    else
      for (const auto& [text, b] : exponents)
        add(text, b);
  }
  return all;
}

/// What is fitted of both kinds of contacts.
struct Beyond {
  kernel::GoingOn power_laws{.from = kernel::power_laws.from, .shear_loss = 0, .scatter_power = 1};
  kernel::GoingOn rough{.from = kernel::rough_spheres.from, .shear_loss = 0, .scatter_power = 1};

  [[nodiscard]] const kernel::GoingOn& of(const StiffNetwork& n) const {
    return n.rough ? rough : power_laws;
  }
};

/// A packing of a power law of that b, up to 1/2, for what is known there.
inline Packing packing_of(const StiffNetwork& n, double b) {
  using granum::contact::PowerLaw;
  constexpr granum::contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  return {.contact = n.contact,
          .preparation = n.preparation,
          .recipe = n.recipe(),
          .specimen = n.packing,
          .state = {.law = b > 0 ? PowerLaw::general(grain, 1 / b - 1, 180) : PowerLaw::flat(grain, 5.7e-6)},
          .mechanical_coordination = n.z,
          .networks = {}};
}

/// ln of the factors over those of the network, and the errors that are stated of own packings there.
struct StiffErrors {
  double shear = 0, bulk = 0;
  double stated_shear = 0, stated_bulk = 0;
};

inline StiffErrors errors_of(const StiffNetwork& n, const EqualFit& equal, double bulk_codes,
                             const kernel::GoingOn& contacts) {
  const kernel::ByExponent<double> b = kernel::by_exponent(n.b, contacts);
  const Packing p = packing_of(n, b.own);
  const Network network{n.ratio, {}};
  const double h = shear_model(p, network, equal.shear.coefficients);
  const double K = kernel::stiffened_bulk(n.z, n.ratio, b, equal.bulk.coefficients);
  const double G_slope = shear_residual(p, network, equal.shear).sensitivity,
               K_slope = bulk_residual(p, network, equal.bulk).sensitivity;
  const double codes = bulk_codes * kernel::looseness(n.z);
  return {.shear = std::log(h * kernel::left_of_shear(h, b) / n.G),
          .bulk = std::log(K / n.K),
          .stated_shear = std::hypot(
              coefficient_error(equal.shear, p, network, kernel::shear_relaxation<Dual<shear_size>>),
              deviation(equal.shear_scatter, G_slope)),
          .stated_bulk =
              std::hypot(coefficient_error(equal.bulk, p, network, kernel::bulk_relaxation<Dual<bulk_size>>),
                         deviation(equal.bulk_scatter, K_slope), codes)};
}

/// 1 - h at the b from which a network goes on.
inline double unstrained(const StiffNetwork& n, const EqualFit& equal, const kernel::GoingOn& contacts) {
  const Packing p = packing_of(n, kernel::by_exponent(n.b, contacts).own);
  return 1 - shear_model(p, {n.ratio, {}}, equal.shear.coefficients);
}
/// What losses and further errors are multiplied by.
inline double unknown_strain(const StiffNetwork& n, const EqualFit& equal, const kernel::GoingOn& contacts) {
  return unstrained(n, equal, contacts) * kernel::share_beyond(n.b, contacts.from);
}

using StiffChoice = std::function<bool(const StiffNetwork&)>;

/// Each recipe, a contact and a preparation, weighs the same.
inline std::map<std::string, double> weights_of(const std::vector<StiffNetwork>& networks,
                                                const StiffChoice& chosen) {
  std::map<std::string, double> weights;
  for (const StiffNetwork& n : networks)
    if (chosen(n))
      weights[n.recipe()] += 1;
  for (auto& [recipe, weight] : weights)
    weight = 1 / weight;
  return weights;
}

/// The loss of G that makes errors of the chosen networks smallest: they fall in proportion to it.
inline double fit_shear_loss(const std::vector<StiffNetwork>& networks, const EqualFit& equal, double from,
                             const StiffChoice& chosen) {
  const std::map<std::string, double> weights = weights_of(networks, chosen);
  const kernel::GoingOn without{.from = from, .shear_loss = 0, .scatter_power = 1};
  double product = 0, square = 0;
  for (const StiffNetwork& n : networks)
    if (chosen(n)) {
      const double weight = weights.at(n.recipe());
      const double slope = unknown_strain(n, equal, without);
      product += weight * slope * errors_of(n, equal, 0, without).shear;
      square += weight * slope * slope;
    }
  return product / square;
}

/// The power of what K is spared of the scatter of forces, by golden section.
inline double fit_scatter_power(const std::vector<StiffNetwork>& networks, const EqualFit& equal, double from,
                                const StiffChoice& chosen) {
  const std::map<std::string, double> weights = weights_of(networks, chosen);
  const auto sum_of_squares = [&](double power) {
    const kernel::GoingOn contacts{.from = from, .shear_loss = 0, .scatter_power = power};
    double sum = 0;
    for (const StiffNetwork& n : networks)
      if (chosen(n))
        sum += weights.at(n.recipe()) * std::pow(errors_of(n, equal, 0, contacts).bulk, 2);
    return sum;
  };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = 0.1, high = 3;
  while (high - low > 1e-9) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (sum_of_squares(a) < sum_of_squares(b) ? high : low) = sum_of_squares(a) < sum_of_squares(b) ? b : a;
  }
  return (low + high) / 2;
}

/// Means alone, from the chosen networks of one kind.
inline kernel::GoingOn fit_going_on(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                                    bool rough, const StiffChoice& chosen) {
  const double from = (rough ? kernel::rough_spheres : kernel::power_laws).from;
  const StiffChoice of_kind = [&](const StiffNetwork& n) {
    return n.rough == rough && n.beyond() && chosen(n);
  };
  return {.from = from,
          .shear_loss = fit_shear_loss(networks, equal, from, of_kind),
          .scatter_power = fit_scatter_power(networks, equal, from, of_kind)};
}

/// Means of all networks of fitted seeds; errors that make those of preparations left out most likely.
inline kernel::GoingOn fit_kind(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                                double bulk_codes, bool rough) {
  const StiffChoice fitted = [rough](const StiffNetwork& n) { return n.rough == rough && n.fitted(); };
  const std::map<std::string, double> weights = weights_of(networks, fitted);
  std::set<std::string> preparations;
  for (const StiffNetwork& n : networks)
    if (fitted(n))
      preparations.insert(n.preparation);
  std::vector<Deviation> G, K;
  for (const std::string& left_out : preparations) {
    const kernel::GoingOn others = fit_going_on(networks, equal, rough, [&](const StiffNetwork& n) {
      return n.fitted() && n.preparation != left_out;
    });
    for (const StiffNetwork& n : networks)
      if (fitted(n) && n.preparation == left_out && n.beyond()) {
        const StiffErrors e = errors_of(n, equal, bulk_codes, others);
        const double measure = std::pow(unknown_strain(n, equal, others), 2), weight = weights.at(n.recipe());
        G.push_back({.squared = e.shear * e.shear,
                     .weight = weight,
                     .known = e.stated_shear * e.stated_shear,
                     .measure = measure});
        K.push_back({.squared = e.bulk * e.bulk,
                     .weight = weight,
                     .known = e.stated_bulk * e.stated_bulk,
                     .measure = measure});
      }
  }
  kernel::GoingOn fit = fit_going_on(networks, equal, rough, fitted);
  fit.errors = {further_scatter(G), further_scatter(K)};
  return fit;
}

inline Beyond fit_beyond(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                         double bulk_codes) {
  return {.power_laws = fit_kind(networks, equal, bulk_codes, false),
          .rough = fit_kind(networks, equal, bulk_codes, true)};
}

// ---- what is said of it ----

/// Errors of the chosen networks, against what is stated.
struct StiffReport {
  Errors G, K, G_trend; ///< the trend: of G over that of b = 1/2 on the same packing
  CoverageOfBoth coverage;
};

inline StiffReport report_of(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                             double bulk_codes, const Beyond& fit, const StiffChoice& chosen) {
  std::map<std::string, double> at_half; // error of G there
  for (const StiffNetwork& n : networks)
    if (!n.rough && n.b == kernel::largest_own_exponent)
      at_half[n.packing + " " + std::to_string(n.ratio)] = errors_of(n, equal, bulk_codes, fit.of(n)).shear;
  StiffReport report;
  for (const StiffNetwork& n : networks) {
    if (!chosen(n))
      continue;
    const StiffErrors e = errors_of(n, equal, bulk_codes, fit.of(n));
    const auto& [of_shear, of_bulk] = fit.of(n).errors;
    const double unknown = unknown_strain(n, equal, fit.of(n));
    report.G.add(e.shear);
    report.K.add(e.bulk);
    report.coverage.shear.add(e.shear, std::hypot(e.stated_shear, of_shear * unknown));
    report.coverage.bulk.add(e.bulk, std::hypot(e.stated_bulk, of_bulk * unknown));
    if (!n.rough)
      report.G_trend.add(e.shear - at_half.at(n.packing + " " + std::to_string(n.ratio)));
  }
  return report;
}

inline void print_report(const std::string& what, const StiffReport& r) {
  std::printf(
      "  %-34s %4d | G rms %5.2f %% mean %+5.2f %% trend %5.2f %%, %3.0f and %3.0f %% within one and two "
      "stated errors of %4.1f %% at most | K rms %5.2f %% mean %+5.2f %%, %3.0f and %3.0f %%, %4.1f %%\n",
      what.c_str(), r.G.count(), 100 * r.G.rms(), 100 * r.G.mean(), 100 * r.G_trend.rms(),
      100 * r.coverage.shear.one(), 100 * r.coverage.shear.two(), 100 * r.coverage.shear.largest_stated,
      100 * r.K.rms(), 100 * r.K.mean(), 100 * r.coverage.bulk.one(), 100 * r.coverage.bulk.two(),
      100 * r.coverage.bulk.largest_stated);
}

} // namespace relaxation
