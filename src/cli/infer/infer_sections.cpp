// SPDX-License-Identifier: GPL-3.0-or-later
// What was inferred of a sand and of spheres, as sections of a document.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <granum/core/text.hpp>

#include "cli/estimate/answer_sections.hpp"
#include "infer.hpp"

namespace granum::cli {

namespace {

using effective::State;
using estimate::GrainShape;
using inverse::AskedPacking;
using inverse::Inference;
using inverse::InferredPacking;
using inverse::Observation;
using inverse::Quantity;
using inverse::QuantityRow;
using inverse::SandInference;

/// The quantities that can be predicted.
std::vector<const QuantityRow*> predictable(const InferCase& question) {
  std::vector<const QuantityRow*> rows;
  for (const QuantityRow& row : inverse::quantities())
    if (is_told(question, row))
      rows.push_back(&row);
  return rows;
}

std::string error_in_percent(const Measured& number) {
  return number.value != 0 ? percent_text(number.standard_error / std::abs(number.value)) : "0 %";
}
std::string quantity_text(const QuantityRow& row, double value) { return pretty(value, dimension_of(row)); }

/// "p' = 100 kPa, e = 0.6".
std::string place_text(const State& s) {
  std::string text = s.stress_v == s.stress_h
                         ? "p' = " + pretty(s.stress_v, Dimension::pressure)
                         : fmt::format("sigma_v = {}, sigma_h = {}", pretty(s.stress_v, Dimension::pressure),
                                       pretty(s.stress_h, Dimension::pressure));
  return text + ", e = " + short_text(s.void_ratio);
}

/// How well all measurements agree.
template <class Fit>
void add_agreement(Items& to, const Fit& fit) {
  io::add_item(to.items, "chi_square", fit.chi_square());
  io::add_item(to.items, "degrees_of_freedom", fit.degrees_of_freedom());
  io::add_item(to.items, "probability", fit.probability());
  if (fit.degrees_of_freedom() > 0)
    add_line(to, "chi^2", short_text(fit.chi_square(), 3),
             fmt::format("of the measurements, {} degrees of freedom; probability of as much or more: {}",
                         fit.degrees_of_freedom(), short_text(fit.probability(), 2)));
}

// ---- measurements

/// A measurement beside its fit, and with spheres what it says alone.
struct MeasuredRow {
  const Observation* measured;
  const inverse::FittedObservation* fitted; ///< null where no contacts explain the measurements
  const inverse::AloneAnswer* alone;        ///< null for a sand
  std::optional<double> depth;              ///< in a borehole [m]

  [[nodiscard]] const QuantityRow& row() const { return inverse::row_of(measured->quantity); }
};

std::optional<double> depth_of(const InferCase& question, std::size_t measurement) {
  return question.depths.empty() ? std::nullopt : std::optional(question.depths[measurement]);
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

/// What JSON has of measurements that spheres explain, or do not.
io::Columns<MeasuredRow> explained_columns() {
  using Of = const MeasuredRow&;
  return {{"", "explained", [](Of of) { return name_of(of.alone->implied.explained); }},
          {"", "softest", [](Of of) { return of.alone->implied.softest; }},
          {"", "stiffest", [](Of of) { return of.alone->implied.stiffest; }},
          {"", "mechanical_coordination_number",
           io::or_null([](Of of) { return of.alone->mechanical_coordination_number; })},
          {"", "",
           [](Of of) {
             const auto& z = of.alone->mechanical_coordination_number;
             return z ? with_error(*z, 3) : "none";
           },
           shown_as("z* alone", {}, 14)}};
}

Table measured_table(const std::string& key, const std::vector<MeasuredRow>& rows) {
  using Of = const MeasuredRow&;
  io::Columns<MeasuredRow> columns = {
      {"", "quantity", [](Of of) { return of.row().key; }, shown_as("", {}, -7)},
      {"", "", [](Of of) { return quantity_text(of.row(), of.measured->value.value); },
       shown_as("measured", {}, 10)},
      {"", "", [](Of of) { return " +- " + error_in_percent(of.measured->value); }, shown_as("", {}, -9)},
      {"", "value", [](Of of) { return of.measured->value.value; }},
      {"", "standard_error", [](Of of) { return of.measured->value.standard_error; }},
      {"", "stress_v", [](Of of) { return of.measured->state.stress_v; }},
      {"", "stress_h", [](Of of) { return of.measured->state.stress_h; }},
      {"", "void_ratio", [](Of of) { return of.measured->state.void_ratio; }}};
  if (rows.front().alone != nullptr)
    for (io::Column<MeasuredRow>& column : explained_columns())
      columns.push_back(std::move(column));
  columns.emplace_back("", "fitted", [](Of of) {
    return of.fitted != nullptr ? std::optional(of.fitted->value) : std::nullopt;
  });
  const bool several = rows.size() > 1 && rows.front().fitted != nullptr;
  columns.emplace_back(
      "", "",
      [](Of of) { return of.fitted != nullptr ? quantity_text(of.row(), of.fitted->value.value) : ""; },
      several ? std::optional(shown_as("together", {}, 10)) : std::nullopt);
  io::ShownColumn off{.heading = "off", .width = 5, .digits = 1, .fixed = true, .sign = true};
  columns.emplace_back(
      "", "deviation",
      [](Of of) { return of.fitted != nullptr ? std::optional(of.fitted->deviation) : std::nullopt; },
      several ? std::optional(off) : std::nullopt);
  if (rows.front().depth)
    columns.emplace_back("", "depth", &MeasuredRow::depth);
  columns.emplace_back(
      "", "",
      [](Of of) {
        const State& at = of.measured->state;
        return of.depth
                   ? fmt::format("  {} m, p' = {}, e = {}", short_text(*of.depth),
                                 pretty(at.mean_stress(), Dimension::pressure), short_text(at.void_ratio))
                   : "  " + place_text(at);
      },
      shown_as("  at", {}, -1));
  Table table = table_of(key, "", columns, rows);
  if (several)
    table.remark = "together: by the fit to all measurements; off: from it, in standard errors";
  return table;
}

// ---- predictions

/// A measured or predicted state with all that is forecast there.
struct StateRow {
  const char* kind; ///< "measured" or "predicted"
  GrainShape shape;
  State state;
  std::optional<InferredPacking> packing; ///< of spheres
  const Observation* measured;            ///< null for a prediction
  std::optional<double> depth;            ///< of a measurement in a borehole [m]
  std::vector<Measured> forecasts;        ///< in the order of predictable(); empty without a fit
};

io::Columns<StateRow> state_columns(const InferCase& question) {
  using Of = const StateRow&;
  const auto of_packing = [](Measured InferredPacking::*part) {
    return [part](Of of) { return of.packing ? std::optional((*of.packing).*part) : std::nullopt; };
  };
  const auto value_of_packing = [](Measured InferredPacking::*part) {
    return [part](Of of) { return of.packing ? std::optional(((*of.packing).*part).value) : std::nullopt; };
  };
  io::Columns<StateRow> columns = {{"kind", "", &StateRow::kind}};
  if (!question.depths.empty())
    columns.emplace_back("depth_m", "", &StateRow::depth);
  for (io::Column<StateRow>& column :
       io::Columns<StateRow>{{"p_Pa", "", [](Of of) { return of.state.mean_stress(); }},
                             {"sigma_v_Pa", "stress_v", [](Of of) { return of.state.stress_v; }},
                             {"sigma_h_Pa", "stress_h", [](Of of) { return of.state.stress_h; }},
                             {"e", "void_ratio", [](Of of) { return of.state.void_ratio; }},
                             {"z_star", "mechanical_coordination_number",
                              of_packing(&InferredPacking::mechanical_coordination_number)},
                             {"", "rattler_fraction", of_packing(&InferredPacking::rattler_fraction)},
                             {"rattler_fraction", "", value_of_packing(&InferredPacking::rattler_fraction)},
                             {"", "coordination_number", of_packing(&InferredPacking::coordination_number)},
                             {"C_n", "", value_of_packing(&InferredPacking::coordination_number)}})
    columns.push_back(std::move(column));
  const std::vector<const QuantityRow*> rows = predictable(question);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const QuantityRow& row = *rows[k];
    const std::string unit(si_symbol(dimension_of(row)));
    const auto forecast = [k](Of of) {
      return of.forecasts.empty() ? std::nullopt : std::optional(of.forecasts[k]);
    };
    for (const auto& [what, part] :
         {std::pair{"_measured_", &Measured::value}, {"_measured_error_", &Measured::standard_error}})
      columns.emplace_back(row.key + (what + unit), "", [quantity = row.quantity, part = part](Of of) {
        return of.measured != nullptr && of.measured->quantity == quantity
                   ? std::optional(of.measured->value.*part)
                   : std::nullopt;
      });
    for (const auto& [what, part] :
         {std::pair{"_", &Measured::value}, {"_error_", &Measured::standard_error}})
      columns.emplace_back(row.key + (what + unit), "", [forecast, part = part](Of of) {
        const std::optional<Measured> number = forecast(of);
        return number ? std::optional((*number).*part) : std::nullopt;
      });
    columns.emplace_back("", row.key, forecast);
  }
  columns.emplace_back("grain_shape", "", [](Of of) { return name(of.shape); });
  return columns;
}

std::vector<StateRow> states_of(const InferCase& question, GrainShape shape, const SandInference* sand,
                                const Inference* beads) {
  const std::vector<const QuantityRow*> quantities = predictable(question);
  std::vector<StateRow> rows;
  const auto add = [&](const char* kind, const State& state, AskedPacking specimen, const Observation* m) {
    StateRow& row = rows.emplace_back(StateRow{kind, shape, state, {}, m, {}, {}});
    const std::optional<double> water = m != nullptr ? m->saturation : std::nullopt;
    if (beads != nullptr)
      row.packing = beads->packing(state, specimen);
    for (const QuantityRow* quantity : quantities)
      if (sand != nullptr)
        row.forecasts.push_back(sand->predict(quantity->quantity, state, water));
      else if (beads != nullptr)
        row.forecasts.push_back(beads->predict(quantity->quantity, state, specimen, water));
  };
  for (std::size_t k = 0; k < question.measurements.size(); ++k) {
    const Observation& m = question.measurements[k];
    add("measured", m.state, AskedPacking::same, &m);
    rows.back().depth = depth_of(question, k);
  }
  if (sand != nullptr || beads != nullptr)
    for (const auto& [state, specimen] : question.predicted)
      add("predicted", state, specimen, nullptr);
  return rows;
}

bool is_isotropic(const InferCase& question) {
  return std::ranges::all_of(question.predicted, [](const PredictedState& predicted) {
    const State& s = predicted.state;
    return s.fabric_anisotropy == 0 && std::abs(s.stress_v - s.stress_h) <= 1e-12 * s.stress_v;
  });
}

/// Whether a forecast is on the screen: in an isotropic packing all directions agree, and a sand has no
/// others.
bool is_listed(Quantity quantity, bool one_direction) {
  return !one_direction ||
         (quantity != Quantity::G_hh && quantity != Quantity::V_s_hh && quantity != Quantity::V_p_h);
}

/// "sand (measured laws), forecast at p' = 50 kPa, e = 0.72: G 63.8 MPa +- 4.5 %, V_s 203.5 m/s +- 2.2 %."
std::string sentence_of(const StateRow& row, const std::vector<const QuantityRow*>& quantities) {
  std::vector<std::string> numbers;
  for (std::size_t k = 0; k < row.forecasts.size(); ++k)
    if (quantities[k]->quantity == Quantity::G_vh || quantities[k]->quantity == Quantity::V_s)
      numbers.push_back(fmt::format("{} {} +- {}", quantities[k]->key,
                                    quantity_text(*quantities[k], row.forecasts[k].value),
                                    error_in_percent(row.forecasts[k])));
  return fmt::format("{}, forecast at {}: {}.", title_of(row.shape), place_text(row.state),
                     fmt::join(numbers, ", "));
}
constexpr std::size_t most_in_words = 3; ///< forecasts of one kind of grains

/// The predictions as lists on the screen, and as an array in JSON.
void add_predictions(Document& to, const std::string& key, const InferCase& question,
                     const std::vector<StateRow>& rows) {
  const std::vector<const QuantityRow*> quantities = predictable(question);
  std::vector<StateRow> predicted;
  for (const StateRow& row : rows) {
    if (row.measured != nullptr)
      continue;
    predicted.push_back(row);
    if (predicted.size() <= most_in_words)
      to.sentences.push_back(sentence_of(row, quantities));
    Items lines{.title = "predicted at " + place_text(row.state)};
    const auto add = [&lines](const char* label, const std::string& value, const Measured& number) {
      add_line(lines, label, fmt::format("{} +- {}", value, error_in_percent(number)));
    };
    if (row.packing)
      add("z*", short_text(row.packing->mechanical_coordination_number.value, 3),
          row.packing->mechanical_coordination_number);
    const bool one_direction = row.shape == GrainShape::sand || is_isotropic(question);
    for (std::size_t k = 0; k < quantities.size(); ++k)
      if (is_listed(quantities[k]->quantity, one_direction))
        add(quantities[k]->key, quantity_text(*quantities[k], row.forecasts[k].value), row.forecasts[k]);
    to.add(Seen::always, std::move(lines));
  }
  io::Columns<StateRow> columns = state_columns(question);
  for (io::Column<StateRow>& column : columns)
    column.heading.clear();
  to.add(Seen::data, table_of(key, "", columns, predicted));
}

// ---- a sand

/// Why contacts are not determined; empty if they are.
std::string contacts_missing(const InferCase& question, const SandInference& sand) {
  if (sand.tells_contacts())
    return "";
  bool shear = false, compression = false;
  for (const Observation& m : question.measurements) {
    const effective::Modulus of = inverse::row_of(m.quantity).modulus;
    const bool shears = of == effective::Modulus::G_vh || of == effective::Modulus::G_hh;
    shear = shear || shears;
    compression = compression || !shears;
  }
  return std::string("These measurements fit few stiff contacts as well as many soft ones; ") +
         (shear && compression ? "their errors are too large to decide." : "V_p and V_s together decide.");
}

void add_measured_number(Items& to, const char* key, const Measured& number, const char* label,
                         const char* meaning) {
  io::add_item(to.items, key, number,
               io::ShownColumn{.heading = label, .digits = 3, .fixed = true, .meaning = meaning});
}

void add_sand(Document& to, const InferCase& question, const SandInference& sand,
              const std::vector<StateRow>& states) {
  std::vector<MeasuredRow> measured;
  for (std::size_t k = 0; k < question.measurements.size(); ++k)
    measured.push_back({&question.measurements[k], &sand.measurements()[k], nullptr, depth_of(question, k)});
  Table table = measured_table("sand/measurements", measured);
  table.title = title_of(GrainShape::sand);
  to.add(Seen::always, std::move(table));
  Items of_sand{.key = "sand", .title = "this sand"};
  add_measured_number(of_sand, "level", sand.level(), "level",
                      "G over that of average sands of this density and stress");
  add_measured_number(of_sand, "stress_exponent", sand.exponent(), "s", "exponent of p' in G");
  add_measured_number(of_sand, "poisson_ratio", sand.poisson_ratio(), "nu", "Poisson's ratio, drained");
  for (const estimate::Field field :
       {estimate::Field::mechanical_coordination_number, estimate::Field::contact_softness}) {
    const estimate::FieldRow& row = estimate::row_of(field);
    const estimate::Range range = sand.contacts(field, question.measurements.front().state);
    add_range(of_sand.items, row.key, range);
    add_line(of_sand, row.symbol, range_text(Dimension::dimensionless, range), "inferred");
  }
  io::add_item(of_sand.items, "tells_contacts", sand.tells_contacts());
  add_agreement(of_sand, sand);
  io::add_item(of_sand.items, "widening", sand.widening());
  to.add(Seen::always, std::move(of_sand));
  if (const std::string missing = contacts_missing(question, sand); !missing.empty())
    to.add(Seen::always, Prose{{missing}});
  add_predictions(to, "sand/predictions", question, states);
}

// ---- spheres

std::string shares_of(const Inference& fit) {
  std::vector<inverse::ErrorShare> shares = fit.error_shares();
  std::ranges::stable_sort(shares, [](const auto& a, const auto& b) { return a.share > b.share; });
  std::vector<std::string> parts;
  for (const inverse::ErrorShare& share : shares)
    if (share.share > 0)
      parts.push_back(share.source + " " + percent_text(share.share));
  return fmt::format("shares in the variance of z*: {}", fmt::join(parts, ", "));
}

void add_contacts(Document& to, const InferCase& question, const Inference& fit) {
  const State& first = question.measurements.front().state;
  const InferredPacking packing = fit.packing(first);
  Items answer{.key = "answer", .title = "contacts at " + place_text(first)}, about,
      shares{.key = "error_shares"};
  io::add_item(answer.items, "mechanical_coordination_number", packing.mechanical_coordination_number);
  io::add_item(answer.items, "rattler_fraction", packing.rattler_fraction);
  io::add_item(answer.items, "coordination_number", packing.coordination_number);
  add_line(answer, "z*", with_error(packing.mechanical_coordination_number, 4),
           "contacts per grain, without rattlers");
  add_line(answer, "rattlers",
           fmt::format("{} +- {}", percent_text(packing.rattler_fraction.value),
                       percent_text(packing.rattler_fraction.standard_error)),
           "grains without load");
  add_line(answer, "C_n", with_error(packing.coordination_number, 4), "contacts per grain, of all grains");
  if (const std::optional<Measured>& growth = fit.growth_exponent())
    add_line(answer, "g", with_error(*growth, 3), "exponent of p' in z* - its isostatic value");
  io::add_item(about.items, "reference_stress", fit.reference_stress());
  io::add_item(about.items, "growth_exponent", io::or_null([&](int) { return fit.growth_exponent(); })(0));
  add_agreement(about, fit);
  for (const inverse::ErrorShare& share : fit.error_shares())
    io::add_item(shares.items, share.source, share.share);
  to.add(Seen::always, std::move(answer));
  to.add(Seen::always, std::move(about));
  to.add(Seen::always, Prose{{shares_of(fit)}});
  to.add(Seen::data, std::move(shares));
}

void add_beads(Document& to, const InferCase& question, const inverse::InferenceAnswer& answer,
               const std::vector<StateRow>& states) {
  const Inference* const fit = answer.together ? &*answer.together : nullptr;
  const State& s = question.measurements.front().state;
  Items packing{.title = title_of(GrainShape::sphere) + std::string(", by the relaxed closed form (rung 3)")};
  add_line(packing, "contact",
           fmt::format("{}; k_t/k_n = {}{}", question.packing.at("contact").get<std::string>(),
                       short_text(s.tangential_ratio),
                       s.rolling > 0 ? ", k_r = " + short_text(s.rolling) : ""));
  add_line(packing, "grains",
           fmt::format("R = {}, G_g = {}, nu_g = {}, density {}", pretty(s.radius, Dimension::length),
                       pretty(s.law.grain().shear_modulus, Dimension::pressure),
                       short_text(s.law.grain().poisson_ratio),
                       pretty(*question.options.grain_density, Dimension::density)));
  to.add(Seen::always, std::move(packing));
  std::vector<MeasuredRow> measured;
  for (std::size_t k = 0; k < question.measurements.size(); ++k)
    measured.push_back({&question.measurements[k], fit != nullptr ? &fit->measurements()[k] : nullptr,
                        &answer.alone[k], depth_of(question, k)});
  to.add(Seen::always, measured_table("measurements", measured));
  if (fit == nullptr)
    to.add(Seen::data, Data{"answer", nullptr});
  else {
    add_contacts(to, question, *fit);
    if (fit->contacts())
      add_contact_law(to, question.options.contacts.name, *fit->contacts());
    add_predictions(to, "predictions", question, states);
  }
  to.add(Seen::data, Data{"inputs",
                          {{"grain_density", *question.options.grain_density},
                           {"pore_density", question.options.pore_density}}});
}

} // namespace

std::string with_error(const Measured& number, int digits) {
  return fmt::format("{} +- {}", short_text(number.value, digits), short_text(number.standard_error, 2));
}

void add_line(Items& to, const char* label, std::string text, std::string meaning) {
  io::ShownColumn look = shown_as(label);
  look.meaning = std::move(meaning);
  io::add_item(to.items, "", std::move(text), std::move(look));
}

Dimension dimension_of(const QuantityRow& row) { return row.speed ? Dimension::speed : Dimension::pressure; }

bool is_told(const InferCase& question, const QuantityRow& row) {
  const bool compression = row.quantity == Quantity::V_p || row.quantity == Quantity::V_p_h;
  return !compression || (question.options.pore_density == 0 &&
                          std::ranges::all_of(question.measurements, [](const Observation& m) {
                            return m.saturation.value_or(0) == 0;
                          }));
}

void add_inferred(Document& to, const Inferred& all) {
  const InferCase& question = all.of_beads;
  const Inference* const fit = all.beads && all.beads->together ? &*all.beads->together : nullptr;
  std::vector<StateRow> of_sand, of_beads;
  to.add(Seen::data, Data{"inputs", question.packing});
  if (all.both())
    to.add(Seen::data, Data{"sand_inputs", question.sand_packing});
  if (all.sand) {
    of_sand = states_of(all.of_sand, GrainShape::sand, &*all.sand, nullptr);
    add_sand(to, all.of_sand, *all.sand, of_sand);
  } else
    to.add(Seen::data, Data{"sand", nullptr});
  if (all.beads) {
    of_beads = states_of(question, GrainShape::sphere, nullptr, fit);
    add_beads(to, question, *all.beads, of_beads);
  }
  Items about;
  io::add_item(about.items, "grain_shape", name(all.beads ? GrainShape::sphere : GrainShape::sand));
  to.add(Seen::data, std::move(about));
  of_sand.insert(of_sand.end(), of_beads.begin(), of_beads.end());
  io::Columns<StateRow> columns = state_columns(question);
  for (io::Column<StateRow>& column : columns)
    column.key.clear();
  to.add(Seen::data, table_of("", "", columns, of_sand));
  to.add_notes(question.assumptions);
  to.manner = question.manner;
}

} // namespace granum::cli
