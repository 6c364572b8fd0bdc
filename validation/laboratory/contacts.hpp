// SPDX-License-Identifier: GPL-3.0-or-later
// What contacts measured speeds and moduli imply: fitted to one half of the pressures, tried on the other.
#pragma once

#include <granum/elastic/waves.hpp>
#include <granum/inverse/inference.hpp>
#include <granum/plot/chart.hpp>
#include <granum/sands/known_sands.hpp>
#include <granum/sands/pooled_law.hpp>

#include "../common.hpp"
#include "specimens.hpp"

namespace laboratory {

using granum::inverse::Observation;
using granum::inverse::Quantity;

/// How well a speed is read off a printed figure: a choice, the sources state none.
inline constexpr double reading_error = 0.015;
inline const char* const contact_kinds[] = {"given", "rough", "power-law"};

inline granum::inverse::InferenceAnswer
ask(const Grains& grains, const std::vector<Observation>& known, const char* contacts,
    granum::inverse::GrowthRule growth = granum::inverse::GrowthRule::packings) {
  return granum::inverse::infer(known, {.grain_density = grains.density,
                                        .growth = growth,
                                        .contacts = granum::inverse::unknown_contacts(contacts)});
}

/// Both speeds at the pressures of one half.
inline std::vector<Observation> observed(const Grains& grains, std::span<const Measured> measured) {
  std::vector<Observation> all;
  for (const Measured& m : measured) {
    const State state = spheres(grains, void_ratio_of(porosity), m.pressure);
    all.push_back({Quantity::V_s, {m.V_s, reading_error * m.V_s}, state});
    if (!std::isnan(m.V_p))
      all.push_back({Quantity::V_p, {m.V_p, reading_error * m.V_p}, state});
  }
  return all;
}

inline granum::Measured foretold_speed(const Grains& grains, const granum::inverse::Inference& fit,
                                       double pressure) {
  return fit.predict(Quantity::V_s, spheres(grains, void_ratio_of(porosity), pressure));
}

/// Relative ones of predicted V_s, with the stated error of both.
inline Errors misses_of(const Grains& grains, const granum::inverse::Inference& fit,
                        std::span<const Measured> asked) {
  Errors misses;
  for (const Measured& m : asked) {
    const granum::Measured speed = foretold_speed(grains, fit, m.pressure);
    misses.add(speed.value / m.V_s - 1, std::hypot(speed.standard_error / speed.value, reading_error));
  }
  return misses;
}

inline void print_numbers(const granum::inverse::Inference& fit, const State& first) {
  const auto z = fit.packing(first).mechanical_coordination_number;
  std::printf(" z* %.2f +- %.2f", z.value, z.standard_error);
  if (fit.contacts())
    for (std::size_t k = 1; k < fit.contacts()->numbers.size(); ++k) {
      const auto& number = fit.contacts()->numbers[k];
      const double unit = number.unit == "m" ? 1e-9 : 1;
      std::printf(", %s %.3g +- %.2g%s%s", number.key.c_str(), number.value.value / unit,
                  number.value.standard_error / unit, unit < 1 ? " nm" : "",
                  number.determined() ? "" : " (not determined)");
    }
  std::printf("\n");
}

/// The upper half of the pressures and the lower one foretold from each other: misses, printed.
inline Errors half_by_half(const char* what, const Grains& grains, std::span<const Measured> measured,
                           const char* contacts,
                           granum::inverse::GrowthRule growth = granum::inverse::GrowthRule::packings) {
  const auto lower = measured.first(measured.size() / 2), upper = measured.subspan(measured.size() / 2);
  const auto fit = [&](std::span<const Measured> known) {
    return ask(grains, observed(grains, known), contacts, growth).together.value();
  };
  const Errors above = misses_of(grains, fit(lower), upper), below = misses_of(grains, fit(upper), lower);
  std::printf("  %-22s upper %.1f %% (%.1f stated errors), lower %.1f %% (%.1f)", what, 100 * above.worst(),
              above.worst_in_stated(), 100 * below.worst(), below.worst_in_stated());
  Errors both = above;
  both.add(below);
  return both;
}

/// The misses of every kind of contacts.
inline std::vector<Errors> print_contacts(const Grains& grains, const std::vector<Measured>& measured) {
  using granum::inverse::GrowthRule;
  std::printf("\n%s, V_s and V_p: contacts implied by one half of the pressures, V_s tried on the other\n",
              grains.name);
  std::vector<Errors> all;
  for (const char* kind : contact_kinds) {
    const auto fit = ask(grains, observed(grains, measured), kind).together.value();
    all.push_back(half_by_half(kind, grains, measured, kind));
    std::printf("; all: chi^2 %.1f of %zu;", fit.chi_square(), fit.degrees_of_freedom());
    print_numbers(fit, spheres(grains, void_ratio_of(porosity), measured.front().pressure));
    const auto upper = std::span(measured).subspan(measured.size() / 2);
    std::printf("%26s", "upper half alone:");
    print_numbers(ask(grains, observed(grains, upper), kind).together.value(),
                  spheres(grains, void_ratio_of(porosity), upper.front().pressure));
  }
  for (const auto& [what, growth] : {std::pair{"rough, z* fixed", GrowthRule::fixed},
                                     std::pair{"rough, growth fitted", GrowthRule::fitted}}) {
    half_by_half(what, grains, measured, "rough", growth);
    std::printf("\n");
  }
  return all;
}

/// A published law of a sand at four pressures, with the Poisson's ratio that sands are measured to have.
inline void print_sand_contacts(const char* law, double void_ratio) {
  std::vector<Observation> known;
  for (const double pressure : {50e3, 100e3, 200e3, 300e3}) {
    const double G = granum::sands::shear_modulus(granum::sands::measured_law(law),
                                                  {.void_ratio = void_ratio, .mean_stress = pressure})
                         .shear_modulus;
    const double nu = granum::sands::poisson_ratio({}, pressure).value;
    const double K = G * 2 * (1 + nu) / (3 * (1 - 2 * nu));
    const State state = spheres(quartz, void_ratio, pressure);
    known.push_back({Quantity::G_vh, {G, 0.03 * G}, state});
    known.push_back({Quantity::K, {K, 0.10 * K}, state});
  }
  std::printf("\n%s, e %.2f, G by law and nu 0.20 at 100 kPa\n", law, void_ratio);
  for (const char* kind : contact_kinds) {
    const auto answer = ask(quartz, known, kind);
    if (!answer.together) {
      std::printf("  %-10s no coordination number explains it\n", kind);
      continue;
    }
    std::printf("  %-10s chi^2 %.1f of %zu;", kind, answer.together->chi_square(),
                answer.together->degrees_of_freedom());
    print_numbers(*answer.together, known.front().state);
  }
}

/// V_s over the pressure: measured, and by contacts that the lower half implies.
inline granum::plot::Chart contact_chart(const Grains& grains, const std::vector<Measured>& measured) {
  namespace plot = granum::plot;
  plot::Chart picture{.title = "Dry Ottawa sand: contacts implied by its lower five pressures",
                      .x = {.title = "p' [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6},
                      .y = {.title = "V_s [m/s]", .scale = plot::Scale::logarithmic, .unit = 1}};
  const std::span all(measured);
  const auto lower = all.first(all.size() / 2);
  const char* const names[] = {"smooth spheres", "rough spheres", "power law"};
  for (std::size_t k = 0; k < std::size(contact_kinds); ++k) {
    const auto answer = ask(grains, observed(grains, lower), contact_kinds[k]);
    plot::Series line{.name = names[k], .mark = plot::Mark::line, .style = k};
    for (int step = 0; step <= 40; ++step) {
      const double p = measured.front().pressure *
                       std::pow(measured.back().pressure / measured.front().pressure, step / 40.0);
      line.add(p, foretold_speed(grains, answer.together.value(), p).value);
    }
    picture.series.push_back(std::move(line));
  }
  plot::Series points{
      .name = "measured", .mark = plot::Mark::marker, .style = 0, .colour = plot::Colour::measured};
  for (const Measured& m : measured)
    points.add(m.pressure, m.V_s);
  picture.series.push_back(std::move(points));
  return picture;
}

} // namespace laboratory
