// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/io/csv/table.hpp>

#include "infer.hpp"

namespace granum::cli {

namespace {

using effective::State;
using inverse::Inference;
using inverse::InferenceAnswer;
using inverse::QuantityRow;
using nlohmann::ordered_json;

/// The quantities that can be predicted.
std::vector<const QuantityRow*> predictable(const InferCase& question) {
  std::vector<const QuantityRow*> rows;
  for (const QuantityRow& row : inverse::quantities())
    if (is_told(question, row))
      rows.push_back(&row);
  return rows;
}

/// The different quantities: in an isotropic packing all directions agree.
std::vector<const QuantityRow*> told_apart(const InferCase& question) {
  using inverse::Quantity;
  std::vector<const QuantityRow*> rows = predictable(question);
  const bool isotropic =
      std::all_of(question.predicted.begin(), question.predicted.end(), [](const PredictedState& predicted) {
        const State& s = predicted.state;
        return s.fabric_anisotropy == 0 && std::abs(s.stress_v - s.stress_h) <= 1e-12 * s.stress_v;
      });
  if (isotropic)
    std::erase_if(rows, [](const QuantityRow* row) {
      return row->quantity == Quantity::G_hh || row->quantity == Quantity::V_s_hh ||
             row->quantity == Quantity::V_p_h;
    });
  return rows;
}

std::string percent(const Measured& number) {
  return number.value != 0 ? percent_text(number.standard_error / std::abs(number.value)) : "0 %";
}
std::string with_error(const Measured& number, int digits) {
  return fmt::format("{} +- {}", short_text(number.value, digits), short_text(number.standard_error, 2));
}

// ---- screen

std::string head_text(const InferCase& question) {
  const State& s = question.measurements.front().state;
  std::string text = "Contacts implied by measured stiffness, by the relaxed closed form (rung 3)\n\n";
  text += fmt::format("  contact   {}; k_t/k_n = {}\n", question.packing.at("contact").get<std::string>(),
                      short_text(s.tangential_ratio));
  text += fmt::format("  grains    R = {}, G_g = {}, nu_g = {}{}\n", pretty(s.radius, Dimension::length),
                      pretty(s.law.grain().shear_modulus, Dimension::pressure),
                      short_text(s.law.grain().poisson_ratio),
                      ", density " + pretty(*question.options.grain_density, Dimension::density));
  return text;
}

std::string measurement_lines(const InferCase& question, const InferenceAnswer& answer) {
  std::string text = "\nmeasured; alone: z* by this measurement; together: by the fit to all\n";
  for (std::size_t k = 0; k < question.measurements.size(); ++k) {
    const inverse::Observation& m = question.measurements[k];
    const QuantityRow& row = inverse::row_of(m.quantity);
    const auto& z = answer.alone[k].mechanical_coordination_number;
    text += fmt::format("  {:<6} {:>11} +- {:<7} at {}\n", row.key, pretty(m.value.value, dimension_of(row)),
                        percent(m.value), place_text(m.state));
    text += fmt::format("         alone: z* {}", z ? with_error(*z, 3) : "none");
    if (answer.together) {
      const inverse::FittedObservation& fitted = answer.together->measurements()[k];
      text += fmt::format("; together: {}, off by {:+.1f} standard errors",
                          pretty(fitted.value.value, dimension_of(row)),
                          std::round(10 * fitted.deviation) / 10 + 0.0); // no -0.0
    }
    text += "\n";
  }
  return text;
}

std::string shares_text(const Inference& fit) {
  std::vector<inverse::ErrorShare> shares = fit.error_shares();
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
  std::vector<std::string> parts;
  for (const inverse::ErrorShare& share : shares)
    if (share.share > 0)
      parts.push_back(share.source + " " + percent_text(share.share));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string contact_lines(const InferCase& question, const Inference& fit) {
  const inverse::InferredPacking packing = fit.packing(question.measurements.front().state);
  std::string text = fmt::format("\ncontacts at {}\n", place_text(question.measurements.front().state));
  text += fmt::format("  {:<9} {:>16}   contacts per grain, without rattlers\n", "z*",
                      with_error(packing.mechanical_coordination_number, 4));
  text += fmt::format("  {:<9} {:>16}   grains without load\n", "rattlers",
                      fmt::format("{} +- {}", percent_text(packing.rattler_fraction.value),
                                  percent_text(packing.rattler_fraction.standard_error)));
  text += fmt::format("  {:<9} {:>16}   contacts per grain, of all grains\n", "C_n",
                      with_error(packing.coordination_number, 4));
  if (fit.growth_exponent())
    text += fmt::format("  {:<9} {:>16}   exponent of p' in z* - its isostatic value\n", "g",
                        with_error(*fit.growth_exponent(), 3));
  text += "  shares in the variance of z*: " + shares_text(fit) + "\n";
  if (fit.degrees_of_freedom() > 0)
    text += fmt::format(
        "  chi^2 of the measurements {} with {} degrees of freedom; probability of as much or more: {}\n",
        short_text(fit.chi_square(), 3), fit.degrees_of_freedom(), short_text(fit.probability(), 2));
  return text;
}

std::string number_text(const inverse::ImpliedNumber& number) {
  if (number.unit.empty())
    return with_error(number.value, 3);
  return fmt::format("{} +- {}", pretty(number.value.value, Dimension::length),
                     pretty(number.value.standard_error, Dimension::length));
}

/// Numbers not determined by the data, and a quantity that would determine them.
std::string open_question(const inverse::ImpliedContacts& contacts) {
  std::vector<std::string> open;
  for (const inverse::ImpliedNumber& number : contacts.numbers)
    if (!number.determined())
      open.push_back(number.key);
  if (open.empty())
    return {};
  std::string text = fmt::format("  not determined by these data: {}\n", fmt::join(open, ", "));
  text += contacts.would_determine ? fmt::format("  {} at the same states, within 2 %, would determine all\n",
                                                 inverse::row_of(*contacts.would_determine).key)
                                   : "  no further quantity at the same states would determine them: measure "
                                     "over a wider range of pressures\n";
  return text;
}

std::string implied_lines(const InferCase& question, const Inference& fit) {
  if (!fit.contacts())
    return {};
  const inverse::ImpliedContacts& contacts = *fit.contacts();
  std::string text = fmt::format("\ninferred contact law: {}\n", question.options.contacts.name);
  for (const inverse::ImpliedNumber& number : contacts.numbers)
    text += fmt::format("  {:<9} {:>16}\n", number.key, number_text(number));
  text += fmt::format("  {:<9} {:>16}   k_n ~ f^b at the mean contact force f of the first measurement\n",
                      "b", short_text(contacts.local_exponent, 3));
  text += fmt::format("  {:<9} {:>16}   of k_n by Hertz' law at this f\n", "k_n",
                      percent_text(contacts.softness));
  const std::size_t size = contacts.numbers.size();
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = i + 1; k < size; ++k)
      text += fmt::format("  correlation of ln {} and ln {}: {:.2f}\n", contacts.numbers[i].key,
                          contacts.numbers[k].key, contacts.correlation[i * size + k]);
  return text + open_question(contacts);
}

std::string prediction_lines(const InferCase& question, const Inference& fit) {
  std::string text;
  for (const auto& [state, specimen] : question.predicted) {
    text += fmt::format("\npredicted at {}\n", place_text(state));
    const auto line = [&text](const char* key, const std::string& value, const Measured& number) {
      text += fmt::format("  {:<6} {:>11} +- {}\n", key, value, percent(number));
    };
    const Measured z = fit.packing(state, specimen).mechanical_coordination_number;
    line("z*", short_text(z.value, 3), z);
    for (const QuantityRow* row : told_apart(question)) {
      const Measured value = fit.predict(row->quantity, state, specimen);
      line(row->key, pretty(value.value, dimension_of(*row)), value);
    }
  }
  return text;
}

// ---- JSON

ordered_json json_of(const inverse::InferredPacking& packing) {
  return {{"mechanical_coordination_number", measured_json(packing.mechanical_coordination_number)},
          {"rattler_fraction", measured_json(packing.rattler_fraction)},
          {"coordination_number", measured_json(packing.coordination_number)}};
}

ordered_json json_of(const inverse::ImpliedContacts& contacts, const std::string& name) {
  ordered_json json = {{"kind", name}, {"numbers", ordered_json::array()}};
  for (const inverse::ImpliedNumber& number : contacts.numbers)
    json["numbers"].push_back({{"key", number.key},
                               {"value", number.value.value},
                               {"standard_error", number.value.standard_error},
                               {"determined", number.determined()}});
  json["correlation"] = contacts.correlation;
  json["exponent"] = contacts.local_exponent;
  json["softness"] = contacts.softness;
  json["would_determine"] = contacts.would_determine
                                ? ordered_json(inverse::row_of(*contacts.would_determine).key)
                                : ordered_json();
  return json;
}

const char* name_of(effective::Explained explained) {
  switch (explained) {
  case effective::Explained::yes:
    return "yes";
  case effective::Explained::too_soft:
    return "too soft";
  case effective::Explained::too_stiff:
    return "too stiff";
  }
  return "";
}

ordered_json measurements_json(const InferCase& question, const InferenceAnswer& answer) {
  ordered_json list = ordered_json::array();
  for (std::size_t k = 0; k < question.measurements.size(); ++k) {
    const inverse::Observation& m = question.measurements[k];
    const inverse::AloneAnswer& alone = answer.alone[k];
    ordered_json json = {{"quantity", inverse::row_of(m.quantity).key}};
    json.update(measured_json(m.value));
    json.update(state_json(m.state));
    json["explained"] = name_of(alone.implied.explained);
    json["softest"] = alone.implied.softest;
    json["stiffest"] = alone.implied.stiffest;
    const auto& z = alone.mechanical_coordination_number;
    json["mechanical_coordination_number"] = z ? measured_json(*z) : ordered_json();
    if (answer.together) {
      json["fitted"] = measured_json(answer.together->measurements()[k].value);
      json["deviation"] = answer.together->measurements()[k].deviation;
    }
    list.push_back(std::move(json));
  }
  return list;
}

ordered_json predictions_json(const InferCase& question, const Inference& fit) {
  ordered_json list = ordered_json::array();
  for (const auto& [state, specimen] : question.predicted) {
    ordered_json json = state_json(state);
    json.update(json_of(fit.packing(state, specimen)));
    for (const QuantityRow* row : predictable(question))
      json[row->key] = measured_json(fit.predict(row->quantity, state, specimen));
    list.push_back(std::move(json));
  }
  return list;
}

// ---- picture

constexpr std::size_t curve_points = 60;

} // namespace

Dimension dimension_of(const QuantityRow& row) { return row.speed ? Dimension::speed : Dimension::pressure; }

ordered_json measured_json(const Measured& number) {
  return {{"value", number.value}, {"standard_error", number.standard_error}};
}

ordered_json state_json(const State& s) {
  return {{"stress_v", s.stress_v}, {"stress_h", s.stress_h}, {"void_ratio", s.void_ratio}};
}

std::string place_text(const State& s) {
  std::string text = s.stress_v == s.stress_h
                         ? "p' = " + pretty(s.stress_v, Dimension::pressure)
                         : fmt::format("sigma_v = {}, sigma_h = {}", pretty(s.stress_v, Dimension::pressure),
                                       pretty(s.stress_h, Dimension::pressure));
  return text + ", e = " + short_text(s.void_ratio);
}

bool is_told(const InferCase& question, const QuantityRow& row) {
  const bool compression = row.quantity == inverse::Quantity::V_p || row.quantity == inverse::Quantity::V_p_h;
  return !compression || question.options.pore_density == 0;
}

std::string infer_table(const InferCase& question, const InferenceAnswer& answer) {
  std::string text = head_text(question) + measurement_lines(question, answer);
  if (answer.together)
    text += contact_lines(question, *answer.together) + implied_lines(question, *answer.together) +
            prediction_lines(question, *answer.together);
  text += "\n";
  for (const std::string& note : question.assumptions)
    text += "note: " + note + "\n";
  return text;
}

ordered_json infer_json(const InferCase& question, const InferenceAnswer& answer) {
  ordered_json json = json_head("infer");
  if (answer.together) {
    const Inference& fit = *answer.together;
    json["answer"] = json_of(fit.packing(question.measurements.front().state));
    json["reference_stress"] = fit.reference_stress();
    json["growth_exponent"] = fit.growth_exponent() ? measured_json(*fit.growth_exponent()) : ordered_json();
    if (fit.contacts())
      json["contacts"] = json_of(*fit.contacts(), question.options.contacts.name);
    for (const inverse::ErrorShare& share : fit.error_shares())
      json["error_shares"][share.source] = share.share;
    json["chi_square"] = fit.chi_square();
    json["degrees_of_freedom"] = fit.degrees_of_freedom();
    json["probability"] = fit.probability();
    json["predictions"] = predictions_json(question, fit);
  } else {
    json["answer"] = nullptr;
  }
  json["measurements"] = measurements_json(question, answer);
  json["inputs"] = question.packing;
  json["inputs"]["grain_density"] = *question.options.grain_density;
  json["inputs"]["pore_density"] = question.options.pore_density;
  json["notes"] = question.assumptions;
  return json;
}

std::string infer_csv(const InferCase& of_sand, const inverse::SandInference* sand, const InferCase& of_beads,
                      const InferenceAnswer* beads) {
  io::CsvContent csv;
  csv.manner = of_beads.manner;
  csv.notes = {{"program", fmt::format("granum {} infer", version())},
               {"inputs", json_text(of_beads.packing, -1)},
               {"signs", "compression positive; z is the vertical axis v"}};
  for (const std::string& note : of_beads.assumptions)
    csv.notes.emplace_back("note", note);
  csv.headings = {"kind",   "p_Pa",         "sigma_v_Pa",       "sigma_h_Pa", "e",
                  "z_star", "z_star_error", "rattler_fraction", "C_n"};
  const std::vector<const QuantityRow*> rows = predictable(of_beads);
  for (const QuantityRow* row : rows)
    for (const char* what : {"_measured", "_measured_error", "", "_error"})
      csv.headings.push_back(fmt::format("{}{}_{}", row->key, what, si_symbol(dimension_of(*row))));
  csv.headings.emplace_back("grain_shape");

  const inverse::Inference* const fit = beads != nullptr && beads->together ? &*beads->together : nullptr;
  const auto add = [&](const char* kind, const PredictedState& at, estimate::GrainShape shape,
                       const inverse::Observation* m) {
    const bool of_sphere = shape == estimate::GrainShape::sphere;
    const auto& [s, specimen] = at;
    auto& cells = csv.rows.emplace_back();
    cells = {std::string(kind), s.mean_stress(), s.stress_v, s.stress_h, s.void_ratio};
    const auto packing =
        of_sphere && fit != nullptr ? std::optional(fit->packing(s, specimen)) : std::nullopt;
    cells.emplace_back(packing ? packing->mechanical_coordination_number.value : nothing);
    cells.emplace_back(packing ? packing->mechanical_coordination_number.standard_error : nothing);
    cells.emplace_back(packing ? packing->rattler_fraction.value : nothing);
    cells.emplace_back(packing ? packing->coordination_number.value : nothing);
    for (const QuantityRow* row : rows) {
      const bool here = m != nullptr && m->quantity == row->quantity;
      const Measured value = !of_sphere       ? sand->predict(row->quantity, s)
                             : fit != nullptr ? fit->predict(row->quantity, s, specimen)
                                              : Measured{nothing, nothing};
      for (const double number : {here ? m->value.value : nothing, here ? m->value.standard_error : nothing,
                                  value.value, value.standard_error})
        cells.emplace_back(number);
    }
    cells.emplace_back(std::string(name(shape)));
  };
  const auto add_all = [&](const InferCase& question, estimate::GrainShape shape, bool predicts) {
    for (const inverse::Observation& m : question.measurements)
      add("measured", {m.state, inverse::AskedPacking::same}, shape, &m);
    if (predicts)
      for (const PredictedState& at : question.predicted)
        add("predicted", at, shape, nullptr);
  };
  if (sand != nullptr)
    add_all(of_sand, estimate::GrainShape::sand, true);
  if (beads != nullptr)
    add_all(of_beads, estimate::GrainShape::sphere, fit != nullptr);
  return io::csv_text(csv);
}

plot::Chart infer_chart(const InferCase& question, inverse::Quantity quantity, estimate::GrainShape shape,
                        const Forecast& forecast, const std::function<double(double)>& void_ratio_at) {
  const QuantityRow& row = inverse::row_of(quantity);
  plot::Chart chart{.title = std::string(row.meaning) +
                             (shape == estimate::GrainShape::sand ? ", sand" : ", beads (spheres)"),
                    .x = {.title = "p' [kPa]", .scale = plot::Scale::logarithmic, .unit = 1e3},
                    .y = {.title = std::string(row.key) + (row.speed ? " [m/s]" : " [MPa]"),
                          .scale = plot::Scale::logarithmic,
                          .unit = row.speed ? 1 : 1e6}};
  plot::Series data{
      .name = "measured", .mark = plot::Mark::marker, .style = 1, .colour = plot::Colour::measured};
  plot::Series points{.name = "predicted",
                      .mark = plot::Mark::marker,
                      .style = 1,
                      .tone = plot::Tone::hollow,
                      .colour = plot::Colour::closed_form};
  double least = question.measurements.front().state.mean_stress(), most = least;
  for (const inverse::Observation& m : question.measurements) {
    least = std::min(least, m.state.mean_stress());
    most = std::max(most, m.state.mean_stress());
    if (m.quantity != quantity)
      continue;
    data.add(m.state.mean_stress(), m.value.value, m.value.standard_error);
  }
  for (const auto& [state, specimen] : question.predicted) {
    const Measured value = forecast(state, specimen);
    least = std::min(least, state.mean_stress());
    most = std::max(most, state.mean_stress());
    points.add(state.mean_stress(), value.value, value.standard_error);
  }
  if (least == most) {
    least /= 3;
    most *= 3;
  }
  if (least >= 1e6)
    chart.x = {.title = "p' [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6};
  plot::Series curve{
      .name = "fit", .mark = plot::Mark::line, .style = 0, .colour = plot::Colour::closed_form};
  plot::Series low{.name = "its standard error",
                   .mark = plot::Mark::line,
                   .style = 0,
                   .tone = plot::Tone::faint,
                   .colour = plot::Colour::closed_form};
  plot::Series high = low;
  high.name.clear();
  const State& first = question.measurements.front().state;
  for (std::size_t k = 0; k < curve_points; ++k) {
    const double share = static_cast<double>(k) / (curve_points - 1);
    const double p = least * std::pow(most / least, share);
    State state = first;
    state.stress_v *= p / first.mean_stress();
    state.stress_h *= p / first.mean_stress();
    state.void_ratio = void_ratio_at(p);
    const Measured value = forecast(state, inverse::AskedPacking::same);
    curve.add(p, value.value);
    low.add(p, value.value - value.standard_error);
    high.add(p, value.value + value.standard_error);
  }
  chart.x.asked = points.x;
  chart.x.asked.insert(chart.x.asked.end(), data.x.begin(), data.x.end());
  for (plot::Series* series : {&curve, &low, &high, &data, &points})
    if (!series->x.empty())
      chart.series.push_back(std::move(*series));
  return chart;
}

} // namespace granum::cli
