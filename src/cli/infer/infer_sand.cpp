// SPDX-License-Identifier: GPL-3.0-or-later
// The result for a sand, as text and as JSON.
#include <cmath>

#include <fmt/core.h>
#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/io/csv/table.hpp>

#include "infer.hpp"

namespace granum::cli {

namespace {

using estimate::Field;
using inverse::Quantity;
using inverse::SandInference;
using nlohmann::ordered_json;

constexpr Quantity foretold[] = {Quantity::G_vh, Quantity::V_s, Quantity::V_p, Quantity::K};

std::string number_line(const char* name, const Measured& number, const char* meaning) {
  return fmt::format("  {:<6} {:>11} +- {:<7} {}\n", name, short_text(number.value, 3),
                     short_text(number.standard_error, 2), meaning);
}

ordered_json range_json(const estimate::Range& range) {
  return {{"value", range.value}, {"low", range.low}, {"high", range.high}};
}

/// Why contacts are not determined: "" if they are.
const char* contacts_missing(const InferCase& question, const SandInference& sand) {
  if (sand.tells_contacts())
    return "";
  bool shear = false, compression = false;
  for (const inverse::Observation& m : question.measurements) {
    const effective::Modulus of = inverse::row_of(m.quantity).modulus;
    const bool shears = of == effective::Modulus::G_vh || of == effective::Modulus::G_hh;
    shear = shear || shears;
    compression = compression || !shears;
  }
  return shear && compression ? ";\n            few contacts and soft ones cannot be distinguished by these\n"
                                "            measurements: their errors are too large"
                              : ";\n            few contacts and soft ones cannot be distinguished by these\n"
                                "            measurements; V_p and V_s together would";
}

std::string contacts_text(const InferCase& question, const SandInference& sand, const effective::State& at) {
  const auto range = [&](Field field) {
    const estimate::Range r = sand.contacts(field, at);
    return fmt::format("{} ({} to {})", short_text(r.value, 3), short_text(r.low, 3), short_text(r.high, 3));
  };
  return fmt::format("  contacts  z* {}, k/k_H {}: inferred{}\n",
                     range(Field::mechanical_coordination_number), range(Field::contact_softness),
                     contacts_missing(question, sand));
}

} // namespace

std::string sand_inference_text(const InferCase& question, const SandInference& sand) {
  const effective::State& first = question.measurements.front().state;
  std::string text = fmt::format("sand (measured laws)\n\nmeasured; together: by the fit to all\n");
  for (std::size_t k = 0; k < question.measurements.size(); ++k) {
    const inverse::Observation& m = question.measurements[k];
    const inverse::QuantityRow& row = inverse::row_of(m.quantity);
    const inverse::FittedObservation& fitted = sand.measurements()[k];
    text += fmt::format(
        "  {:<6} {:>11} +- {:<6} at {}\n         together: {}, off by {:+.1f} standard errors\n", row.key,
        pretty(m.value.value, dimension_of(row)), percent_text(m.value.standard_error / m.value.value),
        place_text(m.state), pretty(fitted.value.value, dimension_of(row)),
        std::round(10 * fitted.deviation) / 10 + 0.0);
  }
  text +=
      "\nthis sand\n" + number_line("level", sand.level(), "G relative to sands of this density and stress");
  text += number_line("s", sand.exponent(), "exponent of p' in G");
  text += number_line("nu", sand.poisson_ratio(), "Poisson's ratio, drained");
  if (sand.degrees_of_freedom() > 0)
    text += fmt::format("  chi^2 {} with {} degrees of freedom; probability of as much or more: {}\n",
                        short_text(sand.chi_square(), 3), sand.degrees_of_freedom(),
                        short_text(sand.probability(), 2));
  text += contacts_text(question, sand, first);
  for (const auto& [state, specimen] : question.predicted) {
    text += fmt::format("\npredicted at {}\n", place_text(state));
    for (const Quantity quantity : foretold) {
      const inverse::QuantityRow& row = inverse::row_of(quantity);
      if (!is_told(question, row))
        continue;
      const Measured value = sand.predict(quantity, state);
      text += fmt::format("  {:<6} {:>11} +- {}\n", row.key, pretty(value.value, dimension_of(row)),
                          percent_text(value.standard_error / value.value));
    }
  }
  return text;
}

ordered_json sand_inference_json(const InferCase& question, const SandInference& sand) {
  const effective::State& first = question.measurements.front().state;
  ordered_json json = {{"level", measured_json(sand.level())},
                       {"stress_exponent", measured_json(sand.exponent())},
                       {"poisson_ratio", measured_json(sand.poisson_ratio())}};
  for (const Field field : {Field::mechanical_coordination_number, Field::contact_softness})
    json[estimate::row_of(field).key] = range_json(sand.contacts(field, first));
  json.update({{"tells_contacts", sand.tells_contacts()},
               {"chi_square", sand.chi_square()},
               {"degrees_of_freedom", sand.degrees_of_freedom()},
               {"probability", sand.probability()},
               {"widening", sand.widening()}});
  json["measurements"] = ordered_json::array();
  for (std::size_t k = 0; k < question.measurements.size(); ++k)
    json["measurements"].push_back({{"quantity", inverse::row_of(question.measurements[k].quantity).key},
                                    {"fitted", measured_json(sand.measurements()[k].value)},
                                    {"deviation", sand.measurements()[k].deviation}});
  json["predictions"] = ordered_json::array();
  for (const auto& [state, specimen] : question.predicted) {
    ordered_json one = state_json(state);
    for (const inverse::QuantityRow& row : inverse::quantities())
      if (is_told(question, row))
        one[row.key] = measured_json(sand.predict(row.quantity, state));
    json["predictions"].push_back(std::move(one));
  }
  return json;
}

} // namespace granum::cli
