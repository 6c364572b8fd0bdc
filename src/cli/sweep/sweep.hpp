// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/core/units.hpp>
#include <granum/core/validity.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/elastic/saturation.hpp>
#include <granum/io/csv/table.hpp>
#include <nlohmann/json.hpp>

#include "cli/estimate/answer_options.hpp"
#include "cli/frame/frame.hpp"
#include "cli/options/packing_options.hpp"

/// What granum sweep works out, state by state, and how it leaves the program.
namespace granum::cli {

/// Level ground, for a sweep over depth.
struct GroundOptions {
  std::string depth; ///< "0m..30m"; empty for another sweep
  Number unit_weight{0, Dimension::unit_weight};
  Number saturated_unit_weight{0, Dimension::unit_weight};
  Number water_table{0, Dimension::length};
  Number water_unit_weight{elastic::water_density * standard_gravity, Dimension::unit_weight};
  Number earth_pressure_at_rest{0.5};
  Number surcharge{0, Dimension::pressure};
};

struct SweepOptions {
  PackingOptions packing;
  AnswerOptions answer;
  GroundOptions ground;
  bool all_columns = false;
  OutputOptions output;
  std::vector<std::string> rungs; ///< keys
  std::string path = "iso";
  Number from{0, Dimension::pressure};
  Number to{0, Dimension::pressure};
  Number eta;
  Number friction_angle{0, Dimension::angle};
  std::size_t points = 25;
  std::string spacing;    ///< empty: log on the isotropic path, linear elsewhere
  std::string table;      ///< file; empty for a path
  std::string picture;    ///< file; empty for none
  std::string picture_of; ///< empty: by default
};

using effective::Rung;
using Rungs = std::vector<const Rung*>;

/// A number that each rung gives for a state.
struct SweptQuantity {
  const char* name;
  Dimension dimension;
  std::optional<double> (*of)(const effective::RungAnswer& answer);
};
[[nodiscard]] std::span<const SweptQuantity> swept_quantities();
[[nodiscard]] const SweptQuantity& swept_quantity(std::string_view name);

/// What the rungs say of one state, or why they cannot.
struct StateResult {
  std::vector<std::optional<effective::RungAnswer>> answers; ///< one a rung
  std::vector<std::string> notes;                            ///< of validity, each once
  std::vector<std::string> slips;                            ///< inputs that are likely mistakes
  std::string error;                                         ///< empty: none
};

/// \param    needed   whether a rung that lacks an input is an error; else it says nothing
[[nodiscard]] StateResult evaluate(const effective::RungInputs& packing, const Rungs& rungs,
                                   bool needed = true);
/// Of a state that is none.
[[nodiscard]] StateResult failed(const std::string& error, const Rungs& rungs);

/// Heading of the column of a quantity: G_hv_rung2_Pa.
[[nodiscard]] std::string heading(const SweptQuantity& quantity, const Rung& rung);
/// Headings and cells of a result: the rungs' numbers, notes, error.
[[nodiscard]] std::vector<std::string> result_headings(const Rungs& rungs);
void append_cells(std::vector<io::CsvCell>& row, const StateResult& result);
/// Their two parts by themselves.
[[nodiscard]] std::vector<std::string> rung_headings(const Rungs& rungs);
void append_rung_cells(std::vector<io::CsvCell>& row, const StateResult& result);
void append_remark_cells(std::vector<io::CsvCell>& row, const StateResult& result);
/// Adds rungs, notes and error to the JSON of a state.
void add_result(nlohmann::ordered_json& json, const StateResult& result, const Rungs& rungs);

/// Counts what went wrong.
class Tally {
 public:
  /// \param    where   the state in words, "line 4"
  void count(const StateResult& result, const std::string& where);
  /// One note for all states outside a formula's validity, and one for each kind of likely mistake.
  [[nodiscard]] Validity validity() const;
  /// Says on standard error how many states failed, if any.
  /// \return   code, or fell_short if it is ok and states failed
  [[nodiscard]] ExitCode conclude(ExitCode code) const;

 private:
  std::size_t states_ = 0;
  std::size_t failed_ = 0;
  std::size_t noted_ = 0;
  std::string first_failure_;
  std::string first_note_;
  struct Slips {
    std::size_t states = 0;
    std::string first;
  };
  std::map<std::string, Slips> slips_; ///< by the input
};

using Notes = std::vector<std::pair<std::string, std::string>>;

/// Lines above the headings: program, inputs, rungs, remarks.
[[nodiscard]] Notes csv_notes(const nlohmann::ordered_json& inputs, const Rungs& rungs,
                              const std::vector<std::string>& remarks);
/// Beginning of the JSON: program, inputs, rungs.
[[nodiscard]] nlohmann::ordered_json sweep_json_head(const nlohmann::ordered_json& inputs,
                                                     const Rungs& rungs);

/// \throws   FileError if a file exists and --force is not given: before any work is done
void require_free(const OutputOptions& output, const std::vector<std::string>& files);

/// Sweeps the states of options.table.
ExitCode sweep_table(const SweepOptions& options, const Rungs& rungs);
/// Sweeps a stress path.
ExitCode sweep_path(const SweepOptions& options, const Rungs& rungs);
/// Goes down into the ground.
ExitCode sweep_depth(const SweepOptions& options);

/// n values from first to last, both to the bit.
[[nodiscard]] std::vector<double> spread(double first, double last, std::size_t n, bool logarithmic);

/// \throws   InvalidArgument if the picture's name does not end in .svg
void require_svg(const std::string& picture);

} // namespace granum::cli
