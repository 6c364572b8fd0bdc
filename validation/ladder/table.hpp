// SPDX-License-Identifier: GPL-3.0-or-later
// The table of validation/ladder: one row an assembly, rung and set of known inputs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/core/text.hpp>
#include <granum/estimate/ladder.hpp>
#include <granum/io/csv/table.hpp>

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
  std::string contact;
  std::string preparation; ///< dense or loose
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
  Specimen specimen;
  std::string known; ///< "all", or "C_n": neither rattlers nor fabric were measured
  double rung = 0;
  Moduli value = unknown;
  Moduli error = unknown;     ///< against the network [1]
  Moduli stated = unknown;    ///< stated errors, rungs 0 to 3
  double cost = State::unset; ///< processor time of one evaluation, median [s]
};

inline constexpr double tangential_ratio = 0.918918918918919;

/// The packing as it was measured.
inline State state_of(const Specimen& s) {
  return {.law = relaxation::detail::law(s.contact, grain_radius),
          .tangential_ratio = tangential_ratio,
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

inline const std::vector<std::string>& headings() {
  static const std::vector<std::string> names{
      "contact",    "preparation", "seed",     "grains",      "p_Pa",        "stress_ratio",
      "e",          "C_n",         "z_star",   "a",           "stress_v_Pa", "stress_h_Pa",
      "known",      "rung",        "K_Pa",     "G_hh_Pa",     "G_vh_Pa",     "error_K",
      "error_G_hh", "error_G_vh",  "stated_K", "stated_G_hh", "stated_G_vh", "cost_s"};
  return names;
}

/// Seven digits: packings are given to no more by their own scatter.
inline std::string digits(double value) {
  return std::isnan(value) ? std::string() : granum::short_text(value, 7);
}

inline std::string csv_line(const Row& row) {
  const Specimen& s = row.specimen;
  std::vector<granum::io::CsvCell> cells{s.contact, s.preparation};
  for (const double value : {s.seed, s.grains, s.pressure, s.stress_ratio, s.void_ratio, s.C_n, s.z_star, s.a,
                             s.stress_v, s.stress_h})
    cells.emplace_back(digits(value));
  cells.emplace_back(row.known);
  cells.emplace_back(digits(row.rung));
  for (const Moduli& three : {row.value, row.error, row.stated})
    for (const double value : three)
      cells.emplace_back(digits(value));
  cells.emplace_back(granum::short_text(row.cost, 3));
  return granum::io::csv_line(cells);
}

inline std::vector<Row> read(const std::filesystem::path& path) {
  const granum::io::CsvTable table = granum::io::read_csv(path);
  if (table.headings() != headings())
    throw std::runtime_error(path.string() + ": other columns than this program writes");
  std::vector<Row> rows;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::vector<std::string>& f = table.fields(k);
    const auto number = [&f](std::size_t column) {
      return granum::parse_number(f[column]).value_or(State::unset);
    };
    const auto three = [&number](std::size_t column) -> Moduli {
      return {number(column), number(column + 1), number(column + 2)};
    };
    rows.push_back({.specimen = {f[0], f[1], number(2), number(3), number(4), number(5), number(6), number(7),
                                 number(8), number(9), number(10), number(11)},
                    .known = f[12],
                    .rung = number(13),
                    .value = three(14),
                    .error = three(17),
                    .stated = three(20),
                    .cost = number(23)});
  }
  return rows;
}

} // namespace ladder
