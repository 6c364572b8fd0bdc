// SPDX-License-Identifier: GPL-3.0-or-later
// How the factors continue where the packings of the fit end: networks with k_n ~ f^b on recorded packings
// beyond b = 1/2 (exponents.csv), and packings of rough grains beyond b = 1/3 (rough.csv).
#pragma once

#include "../common.hpp"
#include "reading.hpp"
#include "size_fits.hpp"

namespace relaxation {

/// One network of a packing of equal grains: the factors of G and K over the closed form, which takes k_n at
/// the mean force.
struct StiffNetwork {
  bool rough = false;
  std::string contact; ///< of the packing
  std::string preparation;
  std::string packing; ///< whose networks are not independent of one another
  std::string recipe;
  int seed = 0;
  double b = 0;
  double z = 0;
  double ratio = 0; ///< k_t/k_n
  double G = 0, K = 0;

  /// Fits see the first seed of a record, others judge.
  [[nodiscard]] bool fitted() const { return seed % 100 == 0; }
  [[nodiscard]] bool beyond() const { return b > (rough ? kernel::rough_spheres : kernel::power_laws).from; }
};

/// \param    rough   whether the file is rough.csv
inline std::vector<StiffNetwork> read_stiff_networks(const std::string& path, bool rough) {
  std::vector<StiffNetwork> all;
  for (const Entry& row : read_record(path)) {
    const std::string &contact = row.text("contact"), &preparation = row.text("preparation");
    if (row("z_star") < lowest_usual_coordination ||
        (!rough && detail::relative_overlap(detail::state(row, contact, 1)) > largest_overlap))
      continue;
    for (const double b : rough ? std::vector{row("b")} : std::vector{0.0, 1.0 / 3, 0.5, 2.0 / 3, 0.8, 1.0})
      for (const double r : {0.6, no_slip_ratio}) {
        const std::string of =
            (rough ? "_own_" : "_" + granum::short_text(b, 3) + "_") + granum::short_text(r, 3);
        all.push_back(
            {.rough = rough,
             .contact = contact,
             .preparation = preparation,
             .packing = contact + " " + preparation + " " + row.text("seed") + " " + row.text("stage"),
             .recipe = contact + " " + preparation,
             .seed = static_cast<int>(row("seed")),
             .b = b,
             .z = row("z_star"),
             .ratio = r,
             .G = row("G" + of),
             .K = row("K" + of)});
      }
  }
  return all;
}

/// What is fitted of both kinds of contacts.
struct Beyond {
  kernel::GoingOn power_laws = {}, rough = {};

  [[nodiscard]] const kernel::GoingOn& of(const StiffNetwork& n) const {
    return n.rough ? rough : power_laws;
  }
};

/// ln of the factors over those of the network, and the errors that are stated of own packings there.
struct StiffErrors {
  Judged G, K;
  double unknown = 0; ///< what losses and further errors are multiplied by
};

inline StiffErrors errors_of(const StiffNetwork& n, const EqualFit& equal, double bulk_codes,
                             const kernel::GoingOn& contacts) {
  using granum::contact::PowerLaw;
  constexpr granum::contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const kernel::ByExponent<double> b = kernel::by_exponent(n.b, contacts);
  // A packing of a power law of that b, up to 1/2, for what is known there.
  const Packing p{.state = {.law = b.own > 0 ? PowerLaw::general(grain, 1 / b.own - 1, 180)
                                             : PowerLaw::flat(grain, 5.7e-6)},
                  .mechanical_coordination = n.z};
  const Network network{n.ratio, {}};
  const double h = value(equal.shear, p, network);
  const double K = kernel::stiffened_bulk(n.z, n.ratio, b, equal.bulk.coefficients);
  const double by_contacts =
                   stated_error(equal.shear, p, network, residual(equal.shear, p, network).sensitivity),
               of_bulk = stated_error(equal.bulk, p, network, residual(equal.bulk, p, network).sensitivity);
  return {.G = {std::log(h * kernel::left_of_shear(h, b) / n.G), by_contacts},
          .K = {std::log(K / n.K), std::hypot(of_bulk, bulk_codes * kernel::looseness(n.z))},
          .unknown = (1 - h) * kernel::share_beyond(n.b, contacts.from)};
}

using StiffChoice = std::function<bool(const StiffNetwork&)>;

/// Those of them that are chosen.
inline std::vector<StiffNetwork> chosen_of(const std::vector<StiffNetwork>& all, const StiffChoice& chosen) {
  std::vector<StiffNetwork> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), chosen);
  return some;
}

/// Means alone, from these networks, which lie beyond: the loss of G that makes errors smallest, to which
/// they are proportional, and the power of what K is spared of the scatter of forces, by golden section.
/// Each recipe weighs the same.
inline kernel::GoingOn fit_going_on(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                                    double from) {
  const std::map<std::string, double> counts = counts_of(networks);
  double product = 0, square = 0;
  for (const StiffNetwork& n : networks) {
    const StiffErrors e = errors_of(n, equal, 0, {from, 0, 1});
    product += e.unknown * e.G.error / counts.at(n.recipe);
    square += e.unknown * e.unknown / counts.at(n.recipe);
  }
  const auto sum_of_squares = [&](double power) {
    double sum = 0;
    for (const StiffNetwork& n : networks)
      sum += std::pow(errors_of(n, equal, 0, {from, 0, power}).K.error, 2) / counts.at(n.recipe);
    return sum;
  };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = 0.1, high = 3;
  while (high - low > 1e-9) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    const bool lower = sum_of_squares(a) < sum_of_squares(b);
    (lower ? high : low) = lower ? b : a;
  }
  return {.from = from, .shear_loss = product / square, .scatter_power = (low + high) / 2};
}

/// Means of all networks of fitted seeds; errors that make those of preparations left out most likely.
inline kernel::GoingOn fit_kind(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                                double bulk_codes, bool rough) {
  const double from = (rough ? kernel::rough_spheres : kernel::power_laws).from;
  const std::vector<StiffNetwork> fitted =
      chosen_of(networks, [rough](const StiffNetwork& n) { return n.rough == rough && n.fitted(); });
  const std::vector<StiffNetwork> beyond =
      chosen_of(fitted, [](const StiffNetwork& n) { return n.beyond(); });
  const std::map<std::string, double> counts = counts_of(fitted);
  std::set<std::string> preparations;
  for (const StiffNetwork& n : beyond)
    preparations.insert(n.preparation);
  std::vector<Deviation> G, K;
  for (const std::string& left_out : preparations) {
    const auto left = [&](const StiffNetwork& n) { return n.preparation == left_out; };
    const kernel::GoingOn others = fit_going_on(chosen_of(beyond, std::not_fn(left)), equal, from);
    for (const StiffNetwork& n : chosen_of(beyond, left)) {
      const StiffErrors e = errors_of(n, equal, bulk_codes, others);
      const auto add = [&](std::vector<Deviation>& to, const Judged& j) {
        to.push_back({.squared = j.error * j.error,
                      .weight = 1 / counts.at(n.recipe),
                      .known = j.stated * j.stated,
                      .measure = e.unknown * e.unknown});
      };
      add(G, e.G);
      add(K, e.K);
    }
  }
  kernel::GoingOn fit = fit_going_on(beyond, equal, from);
  fit.errors = {further_scatter(G), further_scatter(K)};
  return fit;
}

inline Beyond fit_beyond(const std::vector<StiffNetwork>& networks, const EqualFit& equal,
                         double bulk_codes) {
  return {.power_laws = fit_kind(networks, equal, bulk_codes, false),
          .rough = fit_kind(networks, equal, bulk_codes, true)};
}

/// Errors of the chosen networks against what is stated, printed.
inline ErrorsOfBoth report_of(const std::string& what, const std::vector<StiffNetwork>& networks,
                              const EqualFit& equal, double bulk_codes, const Beyond& fit,
                              const StiffChoice& chosen) {
  std::map<std::string, double> at_half; // error of G there
  for (const StiffNetwork& n : networks)
    if (!n.rough && n.b == kernel::largest_own_exponent)
      at_half[n.packing + " " + std::to_string(n.ratio)] = errors_of(n, equal, bulk_codes, fit.of(n)).G.error;
  ErrorsOfBoth errors;
  Errors trend; // of G over that of b = 1/2 on the same packing
  for (const StiffNetwork& n : chosen_of(networks, chosen)) {
    const StiffErrors e = errors_of(n, equal, bulk_codes, fit.of(n));
    const auto& [of_shear, of_bulk] = fit.of(n).errors;
    errors.G.add(e.G.error, std::hypot(e.G.stated, of_shear * e.unknown));
    errors.K.add(e.K.error, std::hypot(e.K.stated, of_bulk * e.unknown));
    trend.add(n.rough ? 0 : e.G.error - at_half.at(n.packing + " " + std::to_string(n.ratio)));
  }
  print_errors("  " + what, {{"G", &errors.G}, {"trend", &trend}, {"K", &errors.K}});
  return errors;
}

} // namespace relaxation
