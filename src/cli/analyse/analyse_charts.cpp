// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured, as charts.
#include <algorithm>
#include <numbers>

#include <fmt/core.h>
#include <granum/core/text.hpp>
#include <granum/fabric/orientation.hpp>

#include "analyse.hpp"

namespace granum::cli {

namespace {

/// E(gamma; a), smooth, over a quarter.
plot::Series density_curve(double anisotropy) {
  constexpr int points = 90;
  plot::Series curve{.name = "E(\u03b3; a = " + short_text(anisotropy, 3) + ")",
                     .mark = plot::Mark::line,
                     .style = 0,
                     .colour = plot::Colour::closed_form};
  for (int k = 0; k <= points; ++k) {
    const double angle = std::numbers::pi / 2 * k / points;
    curve.add(angle, fabric::density(angle, anisotropy));
  }
  return curve;
}

plot::Series isotropic_circle() {
  const double even = 1 / (4 * std::numbers::pi);
  return {
      .name = "no direction preferred",
      .mark = plot::Mark::line,
      .x = {0, std::numbers::pi / 8, std::numbers::pi / 4, 3 * std::numbers::pi / 8, std::numbers::pi / 2},
      .y = {even, even, even, even, even},
      .style = 1,
      .tone = plot::Tone::grey};
}

/// Position on the ladder; empty if not on it.
std::optional<int> rung_number(const RungResult& result) {
  for (const effective::Rung& rung : effective::rungs())
    if (result.name == rung.column)
      return rung.number;
  return std::nullopt;
}

/// A quantity of the states over their mean stress, in order of increasing stress.
template <class Value>
plot::Series points(const AnalyseAnswer& answer, const StateSeries& series, const Value& value) {
  std::vector<std::pair<double, double>> list;
  for (const std::size_t k : series.frames) {
    const auto p = studies::mean_stress(answer.frames[k]);
    const std::optional<double> y = value(answer.frames[k]);
    if (p && *p > 0 && y)
      list.emplace_back(*p, *y);
  }
  std::sort(list.begin(), list.end());
  plot::Series out{.mark = plot::Mark::both};
  for (const auto& [p, y] : list)
    out.add(p, y);
  return out;
}

std::optional<double> modulus(const FrameAnswer& frame, const std::string& rung,
                              double studies::Moduli::*of) {
  const RungResult* found = find_rung(frame, rung);
  if (found == nullptr || !((*found->moduli).*of > 0))
    return std::nullopt;
  return (*found->moduli).*of;
}

/// The name of a series in a legend, followed by a word; only the word if there is one series.
std::string legend(const AnalyseAnswer& answer, const StateSeries& series, const std::string& word) {
  return answer.series.size() < 2 ? word : series.name + (word.empty() ? "" : ", " + word);
}

plot::Chart chart(const std::string& y, plot::Scale scale, double unit) {
  return {.x = {.title = "p [kPa]", .scale = plot::Scale::logarithmic, .unit = 1e3},
          .y = {.title = y, .scale = scale, .unit = unit},
          .width = 300,
          .height = 260,
          .legend_below = true};
}

/// G or K of the network as points with the fitted law, and of rung 3 as hollow points.
plot::Chart modulus_chart(const AnalyseAnswer& answer, const char* name, double studies::Moduli::*of,
                          bool with_law) {
  plot::Chart out = chart(std::string(name) + " [MPa]", plot::Scale::logarithmic, 1e6);
  for (std::size_t k = 0; k < answer.series.size(); ++k) {
    const StateSeries& series = answer.series[k];
    const RungSeries* shown = shown_rung(series);
    if (shown == nullptr)
      continue;
    const auto add = [&](const std::string& rung, plot::Tone tone, const std::string& word) {
      plot::Series of_rung =
          points(answer, series, [&](const FrameAnswer& f) { return modulus(f, rung, of); });
      of_rung.mark = plot::Mark::marker;
      of_rung.name = legend(answer, series, word);
      of_rung.style = k;
      of_rung.tone = tone;
      if (!of_rung.x.empty())
        out.series.push_back(std::move(of_rung));
    };
    add(shown->name, plot::Tone::full, shown->name == network_name() ? "network" : "rung 3");
    if (shown->name == network_name())
      add(studies::relaxed_name(), plot::Tone::hollow, "rung 3");
    if (!with_law || !shown->fit.sum || out.series.empty())
      continue;
    const hardin::Fit& law = *shown->fit.sum;
    plot::Series line = points(answer, series, [&](const FrameAnswer& frame) {
      const double p = studies::mean_stress(frame).value_or(1);
      return std::optional(
          hardin::shear_modulus(law.equation, {p, p, frame.measured.packing.interior_void_ratio()}));
    });
    line.mark = plot::Mark::line;
    line.style = k;
    line.name = legend(
        answer, series,
        fmt::format("s = {:.3f} \u00b1 {:.3f}", law.exponent_sum.value, law.exponent_sum.standard_error));
    out.series.push_back(std::move(line));
  }
  return out;
}

template <class Value>
plot::Chart count_chart(const AnalyseAnswer& answer, const char* title, const Value& value) {
  plot::Chart out = chart(title, plot::Scale::linear, 1);
  for (std::size_t k = 0; k < answer.series.size(); ++k) {
    plot::Series one = points(answer, answer.series[k], value);
    one.name = legend(answer, answer.series[k], "");
    one.style = k;
    if (!one.x.empty())
      out.series.push_back(std::move(one));
  }
  return out;
}

/// z* or C_n, of the window where there is one.
std::optional<double> contacts_per_grain(const FrameAnswer& frame, bool without_rattlers) {
  const analysis::Measurement& m = frame.measured.packing;
  if (!frame.measured.contacts_known)
    return std::nullopt;
  if (without_rattlers)
    return m.interior ? m.interior->micro.mechanical_coordination_number
                      : m.counts.mechanical.coordination_number;
  return m.interior ? m.interior->micro.coordination_number : m.counts.coordination_number;
}

bool stress_varies(const AnalyseAnswer& answer) {
  constexpr double by_a_tenth = 1.1;
  double low = 0, high = 0;
  for (const FrameAnswer& frame : answer.frames)
    if (const auto p = studies::mean_stress(frame); p && *p > 0) {
      low = low == 0 ? *p : std::min(low, *p);
      high = std::max(high, *p);
    }
  return low > 0 && high >= by_a_tenth * low;
}

plot::Series counted_contacts() {
  return {.name = "contacts, \u221an bars",
          .mark = plot::Mark::marker,
          .style = 0,
          .colour = plot::Colour::measured};
}

} // namespace

std::string megapascal(double pascal) { return short_text(pascal / 1e6, 3) + " MPa"; }

const RungSeries* shown_rung(const StateSeries& series) {
  for (const std::string& name : {network_name(), studies::relaxed_name()})
    for (const RungSeries& rung : series.rungs)
      if (rung.name == name && rung.fit.states > 0)
        return &rung;
  return nullptr;
}

std::vector<Picture> state_pictures(const AnalyseAnswer& answer) {
  if (!stress_varies(answer))
    return {};
  std::vector<Picture> all{
      {{modulus_chart(answer, "G", &studies::Moduli::G, true)},
       "Dependence on stress: shear modulus over mean stress, with the fitted G ~ p^s."},
      {{modulus_chart(answer, "K", &studies::Moduli::K, false)}, "Bulk modulus over mean stress."},
      {{count_chart(answer, "z*", [](const FrameAnswer& f) { return contacts_per_grain(f, true); })},
       "Contacts per grain without rattlers."},
      {{count_chart(answer, "C_n", [](const FrameAnswer& f) { return contacts_per_grain(f, false); })},
       "Contacts per grain, rattlers included."},
      {{count_chart(
           answer, "e",
           [](const FrameAnswer& f) { return std::optional(f.measured.packing.interior_void_ratio()); })},
       "Void ratio."}};
  std::erase_if(all, [](const Picture& one) { return one.charts.front().series.empty(); });
  for (Picture& one : all)
    one.files = {"frames.csv", "states.svg"};
  return all;
}

plot::Chart rose_chart(const FrameAnswer& frame) {
  const analysis::Fabric& f = *frame.measured.packing.fabric;
  const double a = f.by_likelihood ? f.by_likelihood->anisotropy : f.by_moment.anisotropy;
  std::vector<std::size_t> counts;
  for (const fabric::RoseBin& bin : f.rose)
    counts.push_back(bin.count);
  plot::Series bins = counted_contacts();
  for (const fabric::RoseBin& bin : fabric::readable_rose(counts, 0))
    bins.add((bin.low + bin.high) / 2, bin.density, bin.density_error);
  return {.title = "Directions of " + std::to_string(f.contacts) + " contacts, step " +
                   std::to_string(frame.measured.step),
          .x = {.title = "\u03b3 from the vertical"},
          .y = {.title = "E [1/sr]"},
          .series = {bins, density_curve(a), isotropic_circle()},
          .width = 320,
          .height = 320,
          .legend_below = true,
          .finding = "Rose of contact directions: " +
                     std::string(a > 0 ? "longer towards the vertical" : "longer towards the horizontal") +
                     ", a = " + short_text(a, 3),
          .rose = true};
}

plot::Chart force_chart(const FrameAnswer& frame) {
  const packing::ForceDistribution& d = frame.measured.packing.forces->distribution;
  plot::Series bins = counted_contacts();
  for (const packing::ForceBin& bin : d.bins) {
    if (bin.count == 0)
      continue; // the axis is logarithmic
    bins.add((bin.low + bin.high) / 2, bin.density, bin.count > 1 ? bin.density_error : 0);
  }
  return {.title = "Normal forces of " + std::to_string(d.pressing) + " contacts, step " +
                   std::to_string(frame.measured.step),
          .x = {.title = "f_n/\u27e8f_n\u27e9"},
          .y = {.title = "probability density", .scale = plot::Scale::logarithmic},
          .series = {bins},
          .width = 320,
          .height = 300,
          .legend_below = true};
}

plot::Chart rung_chart(const FrameAnswer& frame) {
  plot::Chart chart{.x = {.title = "rung (higher rungs assume less)"},
                    .y = {.title = "G [MPa]", .unit = 1e6},
                    .width = 360,
                    .height = 300,
                    .legend_below = true};
  plot::Series strained{.name = "uniform strain",
                        .mark = plot::Mark::marker,
                        .style = 1,
                        .colour = plot::Colour::uniform_strain};
  plot::Series relaxed{.name = "relaxed, \u00b1 stated error",
                       .mark = plot::Mark::marker,
                       .style = 0,
                       .colour = plot::Colour::closed_form};
  for (const RungResult& rung : frame.rungs) {
    const std::optional<int> at = rung_number(rung);
    if (!at || !rung.moduli || rung.name == network_name())
      continue;
    plot::Series& forms =
        rung.name == effective::rung(effective::RungName::relaxed).column ? relaxed : strained;
    forms.add(*at, rung.moduli->G, rung.relative_error ? rung.relative_error->G_vh * rung.moduli->G : 0);
  }
  std::string answers;
  for (plot::Series* forms : {&strained, &relaxed}) {
    for (const double G : forms->y)
      answers += (answers.empty() ? " " : ", ") + megapascal(G);
    if (!forms->x.empty())
      chart.series.push_back(std::move(*forms));
  }
  chart.finding = "G of rungs 0 to 3:" + answers;
  if (const RungResult* network = find_rung(frame, network_name())) {
    const double G = network->moduli->G;
    chart.series.push_back({.name = "this network, rung 4",
                            .mark = plot::Mark::line,
                            .x = {0, 4},
                            .y = {G, G},
                            .style = 0,
                            .colour = plot::Colour::measured});
    chart.finding += "; the network has " + megapascal(G);
  }
  return chart;
}

} // namespace granum::cli
