// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_series.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace granum::cli {

namespace {

/// The rung whose G the pictures show: the network, else rung 3.
const RungSeries* shown_rung(const StateSeries& series) {
  for (const std::string& name : {std::string(network_name), studies::relaxed_name()})
    for (const RungSeries& rung : series.rungs)
      if (rung.name == name && rung.fit.states > 0)
        return &rung;
  return nullptr;
}

/// A quantity of the states over their mean stress, by rising stress.
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
  plot::Series out{.name = {}, .mark = plot::Mark::both, .x = {}, .y = {}};
  for (const auto& [p, y] : list) {
    out.x.push_back(p);
    out.y.push_back(y);
  }
  return out;
}

std::optional<double> modulus(const FrameAnswer& frame, const std::string& rung,
                              double studies::Moduli::*of) {
  const RungResult* found = find_rung(frame, rung);
  if (found == nullptr || !((*found->moduli).*of > 0))
    return std::nullopt;
  return (*found->moduli).*of;
}

/// The name of a series in a legend, with a word behind it; the word alone where there is one series.
std::string legend(const AnalyseAnswer& answer, const StateSeries& series, const std::string& word) {
  return answer.series.size() < 2 ? word : series.name + (word.empty() ? "" : ", " + word);
}

plot::Chart chart(const std::string& y, plot::Scale scale, double unit) {
  return {.title = "",
          .x = {.title = "p [kPa]", .scale = plot::Scale::logarithmic, .unit = 1e3},
          .y = {.title = y, .scale = scale, .unit = unit},
          .series = {},
          .width = 300,
          .height = 260,
          .legend_below = true};
}

/// G or K of the network as points with their law, and of rung 3 as hollow ones.
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
    add(shown->name, plot::Tone::full, shown->name == network_name ? "network" : "rung 3");
    if (shown->name == network_name)
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

std::optional<double> mechanical_coordination(const FrameAnswer& frame) {
  const analysis::Measurement& m = frame.measured.packing;
  if (!frame.measured.contacts_known)
    return std::nullopt;
  return m.interior ? m.interior->micro.mechanical_coordination_number
                    : m.counts.mechanical.coordination_number;
}
std::optional<double> coordination(const FrameAnswer& frame) {
  const analysis::Measurement& m = frame.measured.packing;
  if (!frame.measured.contacts_known)
    return std::nullopt;
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

} // namespace

std::string series_sentence(const AnalyseAnswer& answer) {
  std::string text;
  for (const StateSeries& series : answer.series)
    if (const RungSeries* rung = shown_rung(series); rung != nullptr && rung->fit.sum) {
      const Measured& s = rung->fit.sum->exponent_sum;
      text += fmt::format("{} s = {:.3f} \u00b1 {:.3f}{}", text.empty() ? "" : ",", s.value, s.standard_error,
                          answer.series.size() > 1 ? " (" + series.name + ")" : "");
    }
  return text.empty() ? ""
                      : "Over the states that were given, G grows with the mean stress as p^s:" + text + ".";
}

std::vector<SeriesPicture> series_pictures(const AnalyseAnswer& answer) {
  if (!stress_varies(answer))
    return {};
  const auto void_ratio = [](const FrameAnswer& frame) {
    return std::optional(frame.measured.packing.interior_void_ratio());
  };
  std::vector<SeriesPicture> all{
      {modulus_chart(answer, "G", &studies::Moduli::G, true),
       "Shear modulus over mean stress, with the fitted G ~ p^s."},
      {modulus_chart(answer, "K", &studies::Moduli::K, false), "Bulk modulus over mean stress."},
      {count_chart(answer, "z*", mechanical_coordination), "Contacts of a grain that bears load."},
      {count_chart(answer, "C_n", coordination), "Contacts of a grain, rattlers counted."},
      {count_chart(answer, "e", void_ratio), "Void ratio."}};
  std::erase_if(all, [](const SeriesPicture& one) { return one.chart.series.empty(); });
  return all;
}

} // namespace granum::cli
