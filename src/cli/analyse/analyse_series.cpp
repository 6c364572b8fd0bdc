// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_series.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/number.hpp>
#include <granum/io/text/file_names.hpp>

namespace granum::cli {

namespace {

using Frames = std::vector<FrameAnswer>;

std::string relaxed_name() { return effective::rung(effective::RungName::relaxed).column; }

/// Exponents of one rung over the frames of a series.
RungSeries rung_series(const Frames& frames, const std::vector<std::size_t>& members,
                       const RungResult& rung) {
  std::vector<hardin::MeasuredModulus> mean, by_direction;
  for (const std::size_t k : members) {
    const FrameAnswer& frame = frames[k];
    const RungResult* its = find_rung(frame, rung.name);
    const auto p = mean_stress(frame);
    if (its == nullptr || !p)
      continue;
    const double e = frame.measured.packing.interior_void_ratio();
    if (its->moduli->G > 0)
      mean.push_back({its->moduli->G, {*p, *p, e}});
    if (const auto& state = frame.measured.packing.state; state && its->moduli->G_vh > 0)
      by_direction.push_back({its->moduli->G_vh, {state->stress_v, state->stress_h, e}});
  }
  return {rung.name, rung.title, studies::fit_series(mean), studies::fit_series(by_direction).separate};
}

StateSeries one_series(const Frames& frames, std::string name, std::vector<std::size_t> members) {
  StateSeries out{.name = std::move(name), .frames = std::move(members), .rungs = {}};
  const auto longest =
      std::max_element(out.frames.begin(), out.frames.end(), [&](std::size_t a, std::size_t b) {
        return frames[a].rungs.size() < frames[b].rungs.size();
      });
  for (const RungResult& rung : frames[*longest].rungs)
    out.rungs.push_back(rung_series(frames, out.frames, rung));
  return out;
}

std::string estimate_text(const Measured& e) {
  return fmt::format("{:.4f} +- {:.4f}", e.value, e.standard_error);
}

std::string rung_line(const RungSeries& rung) {
  const studies::SeriesFit& fit = rung.fit;
  std::string text = fmt::format("  {:<22}", rung.title);
  if (!fit.sum)
    return text + " " + fit.remark + "\n";
  text += fmt::format(" {:<18} {:<18}", estimate_text(fit.sum->exponent_sum),
                      fit.sum_with_void_ratio ? estimate_text(fit.sum_with_void_ratio->exponent_sum) : "-");
  if (rung.separate)
    text += fmt::format(" {:<18} {:<18}", estimate_text(*rung.separate->exponent_i),
                        estimate_text(*rung.separate->exponent_j));
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

nlohmann::ordered_json json_of(const Measured& estimate) {
  return {{"value", estimate.value}, {"standard_error", estimate.standard_error}};
}

nlohmann::ordered_json json_of(const RungSeries& rung) {
  const studies::SeriesFit& fit = rung.fit;
  nlohmann::ordered_json json = {{"states", fit.states}, {"remark", fit.remark}};
  if (fit.sum)
    json.update({{"C", json_of(fit.sum->coefficient)}, {"s", json_of(fit.sum->exponent_sum)}});
  if (fit.sum_with_void_ratio)
    json["s_with_void_ratio_function"] = json_of(fit.sum_with_void_ratio->exponent_sum);
  if (rung.separate)
    json.update({{"m", json_of(*rung.separate->exponent_i)}, {"n", json_of(*rung.separate->exponent_j)}});
  return json;
}

/// The rung whose G the pictures show: the network, else rung 3.
const RungSeries* shown_rung(const StateSeries& series) {
  for (const std::string& name : {std::string(network_name), relaxed_name()})
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
    const auto p = mean_stress(answer.frames[k]);
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

std::optional<double> modulus(const FrameAnswer& frame, const std::string& rung, double Moduli::*of) {
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
plot::Chart modulus_chart(const AnalyseAnswer& answer, const char* name, double Moduli::*of, bool with_law) {
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
      add(relaxed_name(), plot::Tone::hollow, "rung 3");
    if (!with_law || !shown->fit.sum || out.series.empty())
      continue;
    const hardin::Fit& law = *shown->fit.sum;
    plot::Series line = points(answer, series, [&](const FrameAnswer& frame) {
      const double p = mean_stress(frame).value_or(1);
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
    if (const auto p = mean_stress(frame); p && *p > 0) {
      low = low == 0 ? *p : std::min(low, *p);
      high = std::max(high, *p);
    }
  return low > 0 && high >= by_a_tenth * low;
}

} // namespace

std::optional<double> mean_stress(const FrameAnswer& frame) {
  const analysis::Measurement& m = frame.measured.packing;
  if (frame.window && m.interior && m.stress)
    return trace(m.interior->stress) / 3;
  return m.stress ? std::optional(m.stress->mean()) : std::nullopt;
}

std::vector<StateSeries> series_of(const Frames& frames, SeriesBy by) {
  std::vector<StateSeries> out;
  if (frames.size() < 2)
    return out;
  std::vector<std::string> files;
  for (const FrameAnswer& frame : frames)
    files.push_back(frame.file);
  const std::vector<std::string> names = io::series_by_name(files);
  std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto same = [&](const auto& group) { return group.first == names[k]; };
    const auto found = std::find_if(groups.begin(), groups.end(), same);
    (found == groups.end() ? groups.emplace_back(names[k], std::vector<std::size_t>{}) : *found)
        .second.push_back(k);
  }
  const bool single =
      std::all_of(groups.begin(), groups.end(), [](const auto& g) { return g.second.size() < 2; });
  if (by == SeriesBy::all || single) {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < frames.size(); ++k)
      members.push_back(k);
    groups = {{"all", std::move(members)}};
  }
  for (auto& [name, members] : groups)
    out.push_back(one_series(frames, name, std::move(members)));
  return out;
}

std::string series_text(const AnalyseAnswer& answer) {
  std::string text;
  for (const StateSeries& series : answer.series) {
    const std::string name = answer.series.size() > 1 ? series.name + ": " : "";
    const auto fitted = [](const RungSeries& rung) { return rung.fit.sum.has_value(); };
    if (std::none_of(series.rungs.begin(), series.rungs.end(), fitted)) {
      if (!series.rungs.empty())
        text += "\n" + name + series.rungs.front().fit.remark + "\n";
      continue;
    }
    if (!name.empty())
      text += fmt::format("\n{}{} states", name, series.frames.size());
    text += fmt::format("\n{:<24} {:<18} {:<18} {:<18} {:<18}\n", "G ~ p^s", "s", "s with f(e)",
                        "m (sigma_v), G_vh", "n (sigma_h), G_vh");
    for (const RungSeries& rung : series.rungs)
      text += rung_line(rung);
  }
  return text;
}

nlohmann::ordered_json series_json(const AnalyseAnswer& answer) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const StateSeries& series : answer.series) {
    nlohmann::ordered_json one = {{"name", series.name}, {"frames", nlohmann::ordered_json::array()}};
    for (const std::size_t k : series.frames)
      one["frames"].push_back(answer.frames[k].number);
    for (const RungSeries& rung : series.rungs)
      one["exponents"][rung.name] = json_of(rung);
    list.push_back(std::move(one));
  }
  return list;
}

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
      {modulus_chart(answer, "G", &Moduli::G, true),
       "Shear modulus over mean stress, with the fitted G ~ p^s."},
      {modulus_chart(answer, "K", &Moduli::K, false), "Bulk modulus over mean stress."},
      {count_chart(answer, "z*", mechanical_coordination), "Contacts of a grain that bears load."},
      {count_chart(answer, "C_n", coordination), "Contacts of a grain, rattlers counted."},
      {count_chart(answer, "e", void_ratio), "Void ratio."}};
  std::erase_if(all, [](const SeriesPicture& one) { return one.chart.series.empty(); });
  return all;
}

} // namespace granum::cli
