// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_picture.hpp"

#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/sands/strain.hpp>

#include "cli/frame/frame.hpp"

namespace granum::cli {

InputValues at_stress(InputValues values, const stress::AxialStress& stress) {
  values.set_stresses(stress);
  return values;
}

std::vector<double> spread(double first, double last, std::size_t n, bool logarithmic) {
  std::vector<double> values;
  for (std::size_t k = 0; k < n; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(n - 1);
    values.push_back(logarithmic ? first * std::pow(last / first, share) : first + (last - first) * share);
  }
  values.back() = last;
  return values;
}

void add_band(plot::Chart& chart, const Band& band, bool sideways, const std::string& name,
              plot::Colour colour) {
  plot::Series line{.name = name, .mark = plot::Mark::line, .style = 0, .colour = colour};
  plot::Series area{.name = name == "answer" ? "range" : name + ", range",
                    .mark = plot::Mark::area,
                    .style = 0,
                    .colour = colour};
  const auto put = [sideways](plot::Series& series, double at, double number) {
    series.add(sideways ? number : at, sideways ? at : number);
  };
  for (std::size_t k = 0; k < band.at.size(); ++k) {
    put(line, band.at[k], band.ranges[k].value);
    put(area, band.at[k], band.ranges[k].low);
  }
  for (std::size_t k = band.at.size(); k-- > 0;)
    put(area, band.at[k], band.ranges[k].high);
  chart.series.push_back(std::move(area));
  chart.series.push_back(std::move(line));
}

namespace {

using estimate::Field;
using estimate::Range;

constexpr std::size_t points_of_a_curve = 61;

plot::Chart chart_of(std::string title, plot::Axis x) {
  x.scale = plot::Scale::logarithmic;
  return {.title = std::move(title), .x = std::move(x), .y = {.title = "G [MPa]", .unit = 1e6}};
}

/// The requested answers, on their curves.
void mark(plot::Chart& chart, std::vector<double> at, std::vector<double> answers) {
  chart.series.push_back({.name = "given strain",
                          .mark = plot::Mark::marker,
                          .x = std::move(at),
                          .y = std::move(answers),
                          .style = 0,
                          .colour = plot::Colour::closed_form});
}

plot::Chart over_strain(InputValues values, const std::vector<std::string>& uncertainties,
                        const AnswerCase& here) {
  constexpr double least = 1e-6, most = 5e-3; // range of the laws of strain
  plot::Chart chart = chart_of("shear modulus over strain", {.title = "shear strain [%]", .unit = 0.01});
  const double asked = *here.question.shear_strain, G0 = here.answer[Field::shear_modulus].value;
  Band band;
  for (const double strain : spread(least, std::max(most, asked), points_of_a_curve, true)) {
    values.set(Input::shear_strain, strain);
    band.at.push_back(strain);
    band.ranges.push_back(bare_answer(values, uncertainties).answer[Field::strained_shear_modulus]);
  }
  for (const sands::StrainLaw& law : sands::strain_laws()) {
    plot::Series line{.name = law.key,
                      .mark = plot::Mark::line,
                      .x = band.at,
                      .style = chart.series.size() + 1,
                      .tone = plot::Tone::grey};
    for (const double strain : band.at)
      line.y.push_back(G0 * law.ratio({.strain = strain,
                                       .void_ratio = here.question.state.void_ratio,
                                       .mean_stress = here.question.state.mean_stress(),
                                       .sand = here.question.sand}));
    chart.series.push_back(std::move(line));
  }
  add_band(chart, band, false);
  mark(chart, {asked}, {here.answer[Field::strained_shear_modulus].value});
  return chart;
}

/// The given stresses stay the given ones, for they may be uncertain.
InputValues with_stresses_times(double factor, InputValues values) {
  for (const Input stress : {Input::pressure, Input::stress_v, Input::stress_h})
    if (values.given(stress))
      values.set(stress, values.number(stress) * factor);
  return values;
}

plot::Chart over_stress(const InputValues& values, const std::vector<std::string>& uncertainties,
                        const AnswerCase& here) {
  const auto& s = here.question.state;
  plot::Chart chart = chart_of("shear modulus over stress", {.title = "p' [kPa]", .unit = 1e3});
  Band answers, of_sand;
  for (const double factor : spread(0.1, 10, points_of_a_curve, true)) {
    const AnswerCase there = bare_answer(with_stresses_times(factor, values), uncertainties);
    answers.at.push_back(factor * s.mean_stress());
    answers.ranges.push_back(there.answer[Field::shear_modulus]);
    if (there.sand_answer) {
      of_sand.at.push_back(answers.at.back());
      of_sand.ranges.push_back((*there.sand_answer)[Field::shear_modulus]);
    }
  }
  if (!of_sand.at.empty())
    add_band(chart, of_sand, false, title_of(estimate::GrainShape::sand), plot::Colour::measured);
  add_band(chart, answers, false, of_sand.at.empty() ? "answer" : title_of(here.question.grain_shape));
  const double p = s.mean_stress(), G = here.answer[Field::shear_modulus].value;
  if (here.sand_answer)
    mark(chart, {p, p}, {G, (*here.sand_answer)[Field::shear_modulus].value});
  else
    mark(chart, {p}, {G});
  return chart;
}

} // namespace

plot::Chart answer_chart(const InputValues& values, const std::vector<std::string>& uncertainties,
                         const AnswerCase& here) {
  if (!(here.question.state.mean_stress() > 0))
    throw InvalidArgument("a picture of G needs a state under stress; the mean stress is 0");
  return here.question.shear_strain ? over_strain(values, uncertainties, here)
                                    : over_stress(values, uncertainties, here);
}

} // namespace granum::cli
