// SPDX-License-Identifier: GPL-3.0-or-later
// How the factors go on where b exceeds 1/2: networks with k_n ~ f^b on recorded packings (exponents.csv),
// and packings of rough grains (rough.csv).
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
  [[nodiscard]] bool beyond() const { return b > kernel::largest_own_exponent; }
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

/// What is fitted beyond b = 1/2.
struct BeyondHalf {
  double power_law_loss = 0;
  double rough_shear_loss = 0, rough_bulk_loss = 0;
  double scatter_power = 1;
  std::array<double, 2> power_law_errors = {0, 0}; ///< of G and of K
  std::array<double, 2> rough_errors = {0, 0};
};

/// A packing of a power law with that b, up to 1/2, for what is known there.
inline Packing up_to_half(const StiffNetwork& n) {
  using granum::contact::PowerLaw;
  constexpr granum::contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double b = kernel::up_to_half(n.b);
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
                             const BeyondHalf& fit) {
  const Packing p = up_to_half(n);
  const Network network{n.ratio, {}};
  const double h = shear_model(p, network, equal.shear.coefficients);
  const double power = n.rough ? kernel::loss_of_rough.power : kernel::loss_of_powers.power;
  const double shear_loss = n.rough ? fit.rough_shear_loss : fit.power_law_loss;
  const double bulk_loss = n.rough ? fit.rough_bulk_loss : 0;
  const auto& c = equal.bulk.coefficients;
  // 1/K less what of the scatter of forces is left out beyond one half.
  const double spared =
      c[0] / kernel::scatter_distance(n.z, n.b, c) * (1 - kernel::left_to_one(n.b, fit.scatter_power));
  const double K = 1 / (1 / kernel::bulk_relaxation(n.z, n.ratio, kernel::up_to_half(n.b), c) - spared);
  const double G_slope = shear_residual(p, network, equal.shear).sensitivity,
               K_slope = bulk_residual(p, network, equal.bulk).sensitivity;
  const double codes = bulk_codes * kernel::looseness(n.z);
  return {.shear = std::log(h * kernel::beyond_half(h, n.b, shear_loss, power) / n.G),
          .bulk = std::log(K * kernel::beyond_half(h, n.b, bulk_loss, power) / n.K),
          .stated_shear = std::hypot(
              coefficient_error(equal.shear, p, network, kernel::shear_relaxation<Dual<shear_size>>),
              deviation(equal.shear_scatter, G_slope)),
          .stated_bulk =
              std::hypot(coefficient_error(equal.bulk, p, network, kernel::bulk_relaxation<Dual<bulk_size>>),
                         deviation(equal.bulk_scatter, K_slope), codes)};
}

/// What beyond_half's losses, and what their errors are multiplied by.
inline double lost_strain(const StiffNetwork& n, const EqualFit& equal) {
  const double h = shear_model(up_to_half(n), {n.ratio, {}}, equal.shear.coefficients);
  const double power = n.rough ? kernel::loss_of_rough.power : kernel::loss_of_powers.power;
  return (1 - h) * (1 - kernel::left_to_one(n.b, power));
}
inline double unknown_strain(const StiffNetwork& n, const EqualFit& equal) {
  const double h = shear_model(up_to_half(n), {n.ratio, {}}, equal.shear.coefficients);
  return (1 - h) * kernel::unknown_beyond_half(n.b, n.rough);
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

/// The loss that makes errors of the chosen networks smallest: they go with it as -(1 - h) (1 - left_to_one).
inline double fit_loss(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                       const BeyondHalf& without, double StiffErrors::*error, const StiffChoice& chosen) {
  const std::map<std::string, double> weights = weights_of(networks, chosen);
  double product = 0, square = 0;
  for (const StiffNetwork& n : networks)
    if (chosen(n)) {
      const double weight = weights.at(n.recipe());
      const double slope = lost_strain(n, equal);
      product += weight * slope * (errors_of(n, equal, 0, without).*error);
      square += weight * slope * slope;
    }
  return product / square;
}

/// The power of what K is spared of the scatter of forces, by golden section.
inline double fit_scatter_power(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                                const StiffChoice& chosen) {
  const std::map<std::string, double> weights = weights_of(networks, chosen);
  const auto sum_of_squares = [&](double power) {
    double sum = 0;
    for (const StiffNetwork& n : networks)
      if (chosen(n))
        sum += weights.at(n.recipe()) * std::pow(errors_of(n, equal, 0, {.scatter_power = power}).bulk, 2);
    return sum;
  };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = 1, high = 3;
  while (high - low > 1e-9) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (sum_of_squares(a) < sum_of_squares(b) ? high : low) = sum_of_squares(a) < sum_of_squares(b) ? b : a;
  }
  return (low + high) / 2;
}

/// Means alone, from the chosen networks beyond b = 1/2.
inline BeyondHalf fit_means_beyond_half(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                                        const StiffChoice& chosen) {
  const auto of = [&](bool rough) {
    return StiffChoice(
        [rough, chosen](const StiffNetwork& n) { return n.rough == rough && n.beyond() && chosen(n); });
  };
  BeyondHalf fit;
  fit.scatter_power = fit_scatter_power(networks, equal, of(false));
  const BeyondHalf without = fit;
  fit.power_law_loss = fit_loss(networks, equal, without, &StiffErrors::shear, of(false));
  fit.rough_shear_loss = fit_loss(networks, equal, without, &StiffErrors::shear, of(true));
  fit.rough_bulk_loss = fit_loss(networks, equal, without, &StiffErrors::bulk, of(true));
  return fit;
}

/// Means of all networks of fitted seeds; errors that make those of preparations left out most likely.
inline BeyondHalf fit_beyond_half(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                                  double bulk_codes) {
  const StiffChoice fitted = [](const StiffNetwork& n) { return n.fitted(); };
  BeyondHalf fit = fit_means_beyond_half(networks, equal, fitted);
  const std::map<std::string, double> weights = weights_of(networks, fitted);
  std::set<std::string> preparations;
  for (const StiffNetwork& n : networks)
    if (n.fitted())
      preparations.insert(n.preparation);
  std::vector<Deviation> G[2], K[2]; // of power laws, of rough contacts
  for (const std::string& left_out : preparations) {
    const BeyondHalf others = fit_means_beyond_half(
        networks, equal, [&](const StiffNetwork& n) { return n.fitted() && n.preparation != left_out; });
    for (const StiffNetwork& n : networks)
      if (n.fitted() && n.preparation == left_out && unknown_strain(n, equal) > 0) {
        const StiffErrors e = errors_of(n, equal, bulk_codes, others);
        const double measure = std::pow(unknown_strain(n, equal), 2), weight = weights.at(n.recipe());
        G[n.rough].push_back({.squared = e.shear * e.shear,
                              .weight = weight,
                              .known = e.stated_shear * e.stated_shear,
                              .measure = measure});
        K[n.rough].push_back({.squared = e.bulk * e.bulk,
                              .weight = weight,
                              .known = e.stated_bulk * e.stated_bulk,
                              .measure = measure});
      }
  }
  fit.power_law_errors = {further_scatter(G[0]), further_scatter(K[0])};
  fit.rough_errors = {further_scatter(G[1]), further_scatter(K[1])};
  return fit;
}

// ---- what is said of it ----

/// Errors of the chosen networks, against what is stated.
struct StiffReport {
  Errors G, K, G_trend; ///< the trend: of G over that of b = 1/2 on the same packing
  CoverageOfBoth coverage;
};

inline StiffReport report_of(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                             double bulk_codes, const BeyondHalf& fit, const StiffChoice& chosen) {
  std::map<std::string, double> at_half; // error of G there
  for (const StiffNetwork& n : networks)
    if (!n.rough && n.b == kernel::largest_own_exponent)
      at_half[n.packing + " " + std::to_string(n.ratio)] = errors_of(n, equal, bulk_codes, fit).shear;
  StiffReport report;
  for (const StiffNetwork& n : networks) {
    if (!chosen(n))
      continue;
    const StiffErrors e = errors_of(n, equal, bulk_codes, fit);
    const auto& [of_shear, of_bulk] = n.rough ? fit.rough_errors : fit.power_law_errors;
    const double unknown = unknown_strain(n, equal);
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
