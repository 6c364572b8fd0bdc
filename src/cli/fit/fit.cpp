// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/state.hpp>
#include <granum/plot/svg_text.hpp>

#include "cli/document/document.hpp"

namespace granum::cli {

namespace {

/// alpha of the profile A r^alpha of a contact: with a constant number of contacts, s = 1/(1+alpha).
constexpr std::pair<const char*, double> contact_shapes[] = {{"cone", 1.0}, {"sphere", 2.0}};

/// The alpha that gives s with a constant number of contacts; empty if none does.
std::optional<double> alpha_of(const hardin::Fit& fit) {
  const double s = fit.exponent_sum.value;
  return s > 0 && s <= 0.5 ? std::optional(1 / s - 1) : std::nullopt;
}

/// Roughness over radius of quartz grains with five contacts each and this p*.
double roughness_of_quartz(double transition_pressure) {
  const effective::State quartz{.law = contact::PowerLaw::sphere(contact::mineral("quartz").material, 1),
                                .tangential_ratio = 1,
                                .radius = 1,
                                .void_ratio = 0.7,
                                .coordination_number = 5,
                                .stress_v = 0,
                                .stress_h = 0};
  return effective::roughness_of(quartz, transition_pressure);
}

/// The contacts that would give this exponent in the middle of the stresses if their number were constant.
std::string contacts_of(double s, double stress) {
  const double transition = effective::transition_pressure_of(s, stress);
  return fmt::format(" With a constant number of contacts, s = {} corresponds to tips of profile r^alpha "
                     "with alpha = {} (cone 1, sphere 2), or to rough spheres whose roughness is as stiff "
                     "as smooth spheres at a mean stress of about p* = {}: for quartz, a roughness u0 of "
                     "about {} radii (u0: "
                     "about 0.4 of the rms height).",
                     short_text(s, 3), short_text(1 / s - 1, 3), pretty(transition, Dimension::pressure),
                     short_text(roughness_of_quartz(transition), 2));
}

/// Possible causes of an exponent; see docs/theory.md for the mechanics.
std::string meaning_of(const Measured& s, double stress) {
  const double error = s.standard_error;
  const auto below = [&](double number) { return s.value + 2 * error < number; };
  const auto above = [&](double number) { return s.value - 2 * error > number; };
  const std::string text = "Measured sands have s = 0.40 C_u^0.18 +- 0.045 (C_u: uniformity coefficient), "
                           "0.43 if they are uniform. ";
  if (below(1.0 / 3))
    return text + "s below 1/3: contacts that stiffen little with stress, for instance by bonds or cement.";
  if (!above(1.0 / 3))
    return text + "s of 1/3: smooth spheres with a constant number of contacts.";
  if (above(0.5))
    return text + "s above 1/2: new contacts form as the stress grows, or f(e) does not cover the change of "
                  "void ratio.";
  return text +
         "s between 1/3 and 1/2 (within two standard errors): new contacts form as the stress grows, or "
         "grains are rough, or touch at angular tips. s alone cannot decide which; V_p and "
         "V_s together do (granum infer --contacts)." +
         contacts_of(s.value, stress);
}

/// G/f(e) of the rows over the stress of the law, the law, and the slopes of cones and spheres.
plot::Chart chart_of(const FitQuestion& question, const hardin::Fit& fit,
                     const std::vector<hardin::MeasuredModulus>& rows) {
  const hardin::VoidRatioFunction function = hardin::void_ratio_function(question.void_ratio_function);
  const double s = fit.exponent_sum.value, p_a = question.atmospheric_pressure;
  const double m = fit.equation.exponent_i, n = fit.equation.exponent_j;
  const std::string &i = question.stress_i_column, &j = question.stress_j_column;
  const bool separate = fit.exponent_i.has_value() && std::abs(s) > 1e-6;
  plot::Series data{
      .name = "measured", .mark = plot::Mark::marker, .style = 1, .colour = plot::Colour::measured};
  for (const hardin::MeasuredModulus& row : rows) {
    const double share = separate ? m / s : 0.5;
    const double log_x = share * std::log(row.state.stress_i) + (1 - share) * std::log(row.state.stress_j);
    const bool by_void_ratio = function != hardin::VoidRatioFunction::none;
    data.add(std::exp(log_x),
             row.shear_modulus /
                 (by_void_ratio ? hardin::void_ratio_value(function, row.state.void_ratio) : 1));
  }
  const double least = *std::min_element(data.x.begin(), data.x.end());
  const double most = *std::max_element(data.x.begin(), data.x.end());
  const double middle = std::sqrt(least * most);
  const auto line = [&](const std::string& name, double exponent, std::size_t style, plot::Tone tone) {
    const auto at = [&](double x) {
      return fit.coefficient.value * p_a * std::pow(middle / p_a, s) * std::pow(x / middle, exponent);
    };
    return plot::Series{.name = name,
                        .mark = plot::Mark::line,
                        .x = {least, most},
                        .y = {at(least), at(most)},
                        .style = style,
                        .tone = tone,
                        .colour = plot::Colour::closed_form};
  };
  plot::Chart chart{
      .title = fmt::format("{} of {}", modulus_name(question), question.file),
      .x = {.title =
                plot::printed_signs(i == j     ? i + " [kPa]"
                                    : separate ? fmt::format("({}^{:.3f} {}^{:.3f})^(1/s) [kPa]", i, m, j, n)
                                               : fmt::format("sqrt({} {}) [kPa]", i, j)),
            .scale = plot::Scale::logarithmic,
            .unit = 1e3},
      .y = {.title = plot::printed_signs(modulus_name(question)) + "/f(e) [MPa]",
            .scale = plot::Scale::logarithmic,
            .unit = 1e6},
      .series = {data, line(fmt::format("law, s = {:.3f} \u00b1 {:.2g}", s, fit.exponent_sum.standard_error),
                            s, 0, plot::Tone::full)}};
  std::size_t dashes = 1;
  for (const auto& [name, alpha] : contact_shapes)
    chart.series.push_back(line(fmt::format("1/(1+\u03b1) = {:.3f}, {}", 1 / (1 + alpha), name),
                                1 / (1 + alpha), dashes++, plot::Tone::grey));
  return chart;
}

// ---- the document

io::ShownColumn with_digits(std::string label, int digits, std::string meaning = "") {
  return {.heading = std::move(label), .digits = digits, .fixed = true, .meaning = std::move(meaning)};
}

/// A number of the fit, null if it is not fitted; in JSON the errors are in a separate object.
void add_number(io::Items& to, const std::string& name, const std::optional<Measured>& of,
                io::ShownColumn look) {
  io::add_item(to, name, of ? io::Value(of->value) : nullptr);
  io::add_item(to, "standard_errors/" + name, of ? io::Value(of->standard_error) : nullptr);
  to.emplace_back(
      name, "", [of](const io::Only&) { return of; }, std::move(look));
}

Items fit_items(const FitQuestion& question, const hardin::FitReport& report) {
  const hardin::Fit& fit = report.fit();
  const double c = fit.coefficient.value, c_digits = std::clamp(3 - std::floor(std::log10(c)), 0.0, 12.0);
  Items items;
  io::Items& list = items.items;
  add_number(list, "C", fit.coefficient,
             with_digits("C", static_cast<int>(c_digits),
                         "C p_a = " + pretty(c * question.atmospheric_pressure, Dimension::pressure)));
  add_number(list, "m", fit.exponent_i, with_digits("m", 4, "exponent of " + question.stress_i_column));
  add_number(list, "n", fit.exponent_j, with_digits("n", 4, "exponent of " + question.stress_j_column));
  add_number(list, "s", fit.exponent_sum,
             with_digits(fit.exponent_i ? "s = m + n" : "s", 4, "exponent of the mean stress"));
  for (const auto& [name, alpha] : contact_shapes)
    io::add_item(list, std::string("one_over_one_plus_alpha/") + name, 1 / (1 + alpha),
                 with_digits("1/(1+alpha)", 4, fmt::format("{}s, unchanged contacts", name)));
  io::add_item(list, "alpha", alpha_of(fit) ? io::Value(*alpha_of(fit)) : nullptr);
  if (fit.exponent_i)
    io::add_item(list, "", fit.correlation(), with_digits("correlation of m and n", 3));
  io::add_item(list, "covariance/parameters", fit.parameters);
  io::add_item(list, "covariance/matrix", fit.covariance);
  io::add_item(list, "R2", fit.r_squared ? io::Value(*fit.r_squared) : nullptr, with_digits("R^2", 6));
  io::add_item(list, "rms_relative_residual", fit.rms_relative_residual,
               io::ShownColumn{.heading = "rms residual of G", .digits = 2, .unit = 0.01, .symbol = " %"});
  io::add_item(list, "residuals", fit.residuals);
  io::add_item(list, "degrees_of_freedom", fit.degrees_of_freedom, with_digits("degrees of freedom", 0));
  io::add_item(list, "iterations", report.iterations(), with_digits("iterations", 0));
  io::add_item(list, "meaning", meaning_of(fit.exponent_sum, question.middle_stress));
  return items;
}

nlohmann::ordered_json inputs_json(const FitQuestion& question, std::size_t rows) {
  return {{"file", question.file},
          {"rows", rows},
          {"modulus_column", question.modulus_column},
          {"by_speed", question.by_speed},
          {"stress_i_column", question.stress_i_column},
          {"stress_j_column", question.stress_j_column},
          {"void_ratio_column", question.void_ratio_column},
          {"void_ratio_function", question.void_ratio_function},
          {"atmospheric_pressure", question.atmospheric_pressure},
          {"weights", question.weights},
          {"sum_only", question.sum_only}};
}

Document document_of(const FitQuestion& question, const hardin::FitReport& report) {
  const hardin::Fit& fit = report.fit();
  const std::string &i = question.stress_i_column, &j = question.stress_j_column;
  const std::string stresses = fit.exponent_i ? fmt::format("({}/p_a)^m ({}/p_a)^n", i, j)
                               : i == j       ? fmt::format("({}/p_a)^s", i)
                                              : fmt::format("(sqrt({} {})/p_a)^s", i, j);
  Document to{.command = "fit",
              .title = fmt::format("{} = C p_a f(e) {}\n{} rows of {}; p_a = {}, f(e) {}, {} residuals",
                                   modulus_name(question), stresses, fit.residuals.size(), question.file,
                                   pretty(question.atmospheric_pressure, Dimension::pressure),
                                   question.void_ratio_function, question.weights)};
  to.add(Seen::data, Data{"inputs", inputs_json(question, fit.residuals.size())});
  to.add(Seen::always, fit_items(question, report));
  to.add(Seen::always, Prose{{meaning_of(fit.exponent_sum, question.middle_stress)}});
  to.warnings = question.remarks;
  to.warnings.merge(fit.validity);
  to.add_notes(to.warnings.notes, Seen::data);
  return to;
}

// ---- the command

/// The fit, or advice if m and n cannot be separated.
hardin::FitReport fitted(const FitQuestion& question, const std::vector<hardin::MeasuredModulus>& rows,
                         const hardin::FitOptions& options) {
  if (question.sum_only)
    return hardin::fit_exponent_sum(rows, options);
  try {
    return hardin::fit(rows, options);
  } catch (const InvalidArgument& error) {
    if (std::string_view(error.what()).find("cannot be separated") == std::string_view::npos)
      throw;
    throw InvalidArgument(std::string(error.what()) + ". --sum-only fits s");
  }
}

double middle_stress(const std::vector<hardin::MeasuredModulus>& rows) {
  double sum = 0;
  for (const hardin::MeasuredModulus& row : rows)
    sum += std::log(row.state.stress_i) + std::log(row.state.stress_j);
  return std::exp(sum / (2 * static_cast<double>(rows.size())));
}

ExitCode run(FitQuestion question) {
  const Outlets to{.output = question.output, .picture = question.picture};
  require_free(to);
  const auto rows = read_rows(question);
  question.middle_stress = middle_stress(rows);
  const hardin::FitOptions options{
      .atmospheric_pressure = question.atmospheric_pressure,
      .void_ratio_function = hardin::void_ratio_function(question.void_ratio_function),
      .weights = question.weights == "absolute" ? hardin::Weights::absolute : hardin::Weights::relative};
  const hardin::FitReport report = fitted(question, rows, options);
  Document document = document_of(question, report);
  if (!to.picture.empty())
    document.add(Seen::data, Picture{{chart_of(question, report.fit(), rows)}});
  return deliver(to, document);
}

void add_column_options(Command& command, FitQuestion& question) {
  command.add(
      "Columns",
      {{.name = "--modulus-column",
        .value = text(question.modulus_column),
        .meaning =
            "Column of the modulus; by default the first of G, G_max, G_0, G_vh, ... in the table, or of "
            "V_s, with the density of a column or of void ratio and grains"},
       {.name = "--stress-i-column",
        .value = text(question.stress_i_column),
        .meaning = "Column of sigma_i, whose exponent is m; by default sigma_h; p in tables with only a mean "
                   "stress"},
       {.name = "--stress-j-column",
        .value = text(question.stress_j_column),
        .meaning = "Column of sigma_j, whose exponent is n; by default sigma_v; sigma_h for a column G_hh"},
       {.name = "--void-ratio-column",
        .value = text(question.void_ratio_column),
        .meaning = "Column of the void ratio; by default e or void_ratio"}});
}

void add_fit_law_options(Command& command, FitQuestion& question) {
  std::vector<std::string> functions;
  for (const hardin::VoidRatioFunction function : hardin::all_void_ratio_functions())
    functions.emplace_back(hardin::name(function));
  Value function = choice(functions, [&question](const std::string& text) {
    question.void_ratio_function = text;
    question.void_ratio_function_given = true;
  });
  function.by_default = question.void_ratio_function;
  command.add("Law",
              {{.name = "--sum-only",
                .value = flag(question.sum_only),
                .meaning = "Fit C and s = m + n only, for data of a single stress ratio"},
               {.name = "--void-ratio-function", .value = std::move(function), .meaning = "f(e)"},
               {.name = "--atmospheric-pressure",
                .value = quantity(question.atmospheric_pressure, Dimension::pressure),
                .meaning = "Reference pressure p_a of the law",
                .synonyms = {{"pa patm pref referencepressure"}}},
               {.name = "--weights",
                .value = choice({"relative", "absolute"}, question.weights),
                .meaning = "Assume the same relative error of G in all rows (residuals of ln G), or the same "
                           "absolute error"}});
}

} // namespace

Command make_fit() {
  auto question = std::make_shared<FitQuestion>();
  Command command{.name = "fit",
                  .meaning =
                      "Fit G = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n to a CSV file (e: void ratio, p_a: "
                      "atmospheric pressure)",
                  .notes = "Examples:\n"
                           "  granum fit moduli.csv --picture moduli.svg\n"
                           "  granum fit isotropic.csv --sum-only",
                  .run = [question] { return run(*question); }};
  command.add({.name = "file",
               .value = text(question->file, "data.csv"),
               .meaning =
                   "CSV file with a modulus or V_s, two stresses or one mean stress, and e; headings such as "
                   "G_MPa,sigma_v_kPa,sigma_h_kPa,e or p_kPa,V_s_m/s,e",
               .required = true});
  add_column_options(command, *question);
  add_fit_law_options(command, *question);
  add_output_options(command, question->output);
  add_picture(command, question->picture,
              "Draw data and law, with the slopes 1/(1+alpha) of cones and spheres");
  return command;
}

} // namespace granum::cli
