// SPDX-License-Identifier: GPL-3.0-or-later
// The table of validation/ladder: one row an assembly, rung and set of known inputs.
#pragma once

#include <granum/estimate/ladder.hpp>
#include <granum/io/csv/table.hpp>

#include "../common.hpp"
#include "../relaxation/reading.hpp"

namespace ladder {

inline constexpr double grain_radius = 0.5e-3; ///< [m]

using granum::effective::State;

/// K, G_hh, G_vh, or what belongs to them; NaN: not measured.
using Moduli = std::array<double, 3>;
inline constexpr Moduli unknown{State::unset, State::unset, State::unset};

inline Moduli moduli(const granum::elastic::TransverselyIsotropic& c) {
  return {c.bulk_modulus(), c.G_hh(), c.G_vh()};
}
inline Moduli triple(const granum::effective::ModulusErrors& e) { return {e.bulk_modulus, e.G_hh, e.G_vh}; }

/// One frozen packing.
struct Specimen {
  std::string contact = {};
  std::string preparation = {}; ///< dense or loose
  double seed = 0;
  double grains = 0;
  double pressure = 0;     ///< nominal mean stress [Pa]
  double stress_ratio = 0; ///< nominal (stress_v - stress_h)/p
  double void_ratio = 0;
  double C_n = 0;
  double z_star = 0;
  double a = 0;
  double stress_v = 0; ///< measured on the contacts [Pa]
  double stress_h = 0;

  /// Every packing has a name of its own.
  [[nodiscard]] std::string name() const {
    const auto text = [](double value) { return granum::short_text(value); };
    return contact + " " + preparation + ", " + text(pressure / 1e3) + " kPa, q/p " + text(stress_ratio) +
           " #" + text(seed);
  }
};

struct Row {
  Specimen specimen = {};
  std::string known = {}; ///< "all", or "C_n": neither rattlers nor fabric were measured
  double rung = 0;
  Moduli value = unknown;
  Moduli error = unknown;     ///< against the network [1]
  Moduli stated = unknown;    ///< stated errors, rungs 0 to 3
  double cost = State::unset; ///< processor time of one evaluation, median [s]
};

/// The packing as it was measured.
inline State state_of(const Specimen& s) {
  return {.law = relaxation::detail::law(s.contact, grain_radius),

          .tangential_ratio = relaxation::no_slip_ratio,
          .radius = grain_radius,
          .void_ratio = s.void_ratio,
          .coordination_number = s.C_n,
          .mechanical_coordination_number = s.z_star,
          .fabric_anisotropy = s.a,
          .stress_v = s.stress_v,
          .stress_h = s.stress_h};
}

/// What the ladder makes of it where all was measured; or of "C_n" alone: the fabric is an assumption then.
inline granum::estimate::Answer answer_of(const State& measured, const std::string& known) {
  using granum::estimate::Question;
  Question question{.state = measured};
  if (known == "all")
    return granum::estimate::answer(question);
  question.state.mechanical_coordination_number.reset();
  question.state.fabric_anisotropy = 0;
  const granum::estimate::UncertainInput fabric{
      .input = std::string(granum::estimate::fabric_input),
      .deviation = granum::estimate::assumed_fabric_deviation(measured.stress_v, measured.stress_h),
      .assumed = true,
      .moved = [question](double change) {
        Question moved = question;
        moved.state.fabric_anisotropy += change;
        return moved;
      }};
  return granum::estimate::answer(question, std::span(&fabric, 1));
}

/// Its rungs 0 to 3, at the tolerance that the program takes.
inline granum::estimate::Ladder ladder_of(const State& measured, const std::string& known) {
  return granum::estimate::choose(answer_of(measured, known), 0.05);
}

/// The three errors against a reference; NaN where a modulus was not measured.
inline Moduli errors(const Moduli& value, const Moduli& reference) {
  Moduli e{};
  for (std::size_t k = 0; k < e.size(); ++k)
    e[k] = value[k] / reference[k] - 1;
  return e;
}

/// Largest magnitude among those that are known.
inline double largest(const Moduli& values) {
  double most = 0;
  for (const double value : values)
    if (!std::isnan(value))
      most = std::max(most, std::abs(value));
  return most;
}

// ---- the file ----

inline constexpr std::pair<const char*, double Specimen::*> numbers_of_specimen[] = {
    {"seed", &Specimen::seed},
    {"grains", &Specimen::grains},
    {"p_Pa", &Specimen::pressure},
    {"stress_ratio", &Specimen::stress_ratio},
    {"e", &Specimen::void_ratio},
    {"C_n", &Specimen::C_n},
    {"z_star", &Specimen::z_star},
    {"a", &Specimen::a},
    {"stress_v_Pa", &Specimen::stress_v},
    {"stress_h_Pa", &Specimen::stress_h}};
inline constexpr std::pair<std::array<const char*, 3>, Moduli Row::*> moduli_of_row[] = {
    {{"K_Pa", "G_hh_Pa", "G_vh_Pa"}, &Row::value},
    {{"error_K", "error_G_hh", "error_G_vh"}, &Row::error},
    {{"stated_K", "stated_G_hh", "stated_G_vh"}, &Row::stated}};

/// Headings and cells of a row. Seven digits: packings are given to no more by their own scatter.
inline std::vector<std::pair<std::string, std::string>> cells_of(const Row& row) {
  const auto digits = [](double value) {
    return std::isnan(value) ? std::string() : granum::short_text(value, 7);
  };
  std::vector<std::pair<std::string, std::string>> cells{{"contact", row.specimen.contact},
                                                         {"preparation", row.specimen.preparation}};
  for (const auto& [heading, of] : numbers_of_specimen)
    cells.emplace_back(heading, digits(row.specimen.*of));
  cells.emplace_back("known", row.known);
  cells.emplace_back("rung", digits(row.rung));
  for (const auto& [names, of] : moduli_of_row)
    for (std::size_t k = 0; k < names.size(); ++k)
      cells.emplace_back(names[k], digits((row.*of)[k]));
  cells.emplace_back("cost_s", granum::short_text(row.cost, 3));
  return cells;
}
inline std::string csv_headings() {
  std::vector<granum::io::CsvCell> line;
  for (const auto& [heading, cell] : cells_of({}))
    line.emplace_back(heading);
  return granum::io::csv_line(line);
}
inline std::string csv_line(const Row& row) {
  std::vector<granum::io::CsvCell> line;
  for (const auto& [heading, cell] : cells_of(row))
    line.emplace_back(cell);
  return granum::io::csv_line(line);
}

inline std::vector<Row> read(const std::string& path) {
  std::vector<Row> rows;
  for (const Entry& entry : read_record(path)) {
    Row& row = rows.emplace_back();
    row.specimen.contact = entry.text("contact");
    row.specimen.preparation = entry.text("preparation");
    for (const auto& [heading, of] : numbers_of_specimen)
      row.specimen.*of = entry(heading);
    row.known = entry.text("known");
    row.rung = entry("rung");
    for (const auto& [names, of] : moduli_of_row)
      for (std::size_t k = 0; k < names.size(); ++k)
        (row.*of)[k] = entry(names[k]);
    row.cost = entry("cost_s");
  }
  return rows;
}

} // namespace ladder
