// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/units.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/plot/chart.hpp>
#include <nlohmann/json.hpp>

#include "cli/estimate/answer_sections.hpp"
#include "cli/frame/frame.hpp"
#include "cli/options/ground.hpp"
#include "practice.hpp"

/// The computations of granum sweep, state by state, and their output: along a path, over depth, and for the
/// rows of a table.
namespace granum::cli {

struct SweepOptions {
  InputValues inputs;
  GroundOptions ground;
  bool all_columns = false;
  bool law_columns = false; ///< published laws of sands as columns
  bool si = false;          ///< CSV in exact SI, instead of units of practice
  std::string densest;      ///< "made": of the densest packing of the same grains, for z*
  OutputOptions output;
  std::vector<std::string> rungs; ///< keys
  std::string path = "iso";
  Number from{0, Dimension::pressure};
  Number to{0, Dimension::pressure};
  Number eta;
  Number friction_angle{0, Dimension::angle};
  std::size_t points = 25;
  bool points_given = false;
  std::vector<double> strains; ///< first and last of a curve; empty without one
  std::string curves_for;      ///< the form of its file: "table", "pystrata", "strata"
  std::string spacing;         ///< empty: log on the isotropic path, linear elsewhere
  std::string table;           ///< file; empty for a path
  std::string picture, report; ///< files; empty for none
  std::string picture_of;      ///< empty: by default
};

using Rungs = std::vector<const effective::Rung*>;

/// A number computed by the answer and by each rung for a state.
struct SweptQuantity {
  const char* name;
  Dimension dimension;
  estimate::Field field; ///< of the answer
  std::optional<double> (*of)(const effective::RungAnswer& answer);
};
[[nodiscard]] std::span<const SweptQuantity> swept_quantities();
/// \throws   InvalidArgument for another name
[[nodiscard]] const SweptQuantity& swept_quantity(std::string_view name);

/// A state and its results, or the error.
struct SweptState {
  std::optional<AnswerCase> answer;
  std::vector<std::optional<effective::RungAnswer>> rungs =
      {};                              ///< with the contacts of the answer, one per rung
  std::vector<std::string> notes = {}; ///< of validity, each once
  std::vector<std::string> slips = {}; ///< inputs that are likely mistakes
  std::string error = {};              ///< empty: none
};

/// The answer, as of granum estimate, and the rungs.
[[nodiscard]] SweptState swept(const InputValues& values, const Rungs& rungs);
/// A state that the options cannot produce.
[[nodiscard]] SweptState failed(const std::string& error, const Rungs& rungs);

/// Counts failed and doubtful states.
class Tally {
 public:
  /// \param    where   the state in words, "line 4"
  void count(const SweptState& state, const std::string& where);
  /// One note for all states outside a formula's validity, and one for each kind of likely mistake.
  [[nodiscard]] Validity validity() const;
  /// Reports on standard error how many states failed, if any.
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
  std::map<std::string, Slips> slips_; ///< by input
};

/// What any of the states asks for beyond the usual columns.
struct AskedOfRows {
  bool both = false;     ///< answers for sand and spheres: the kind of grains is not given
  bool strained = false; ///< G at a shear strain
};
[[nodiscard]] AskedOfRows asked_of(const InputValues& values);

/// Collects states as the rows of a CSV file or of a JSON array.
class SweptRows {
 public:
  /// \param    headings   of the first cells of each row
  /// \param    manner     of the table of the states
  SweptRows(const SweepOptions& options, Rungs rungs, std::vector<std::string> headings,
            const AskedOfRows& asked, io::CsvManner manner = {});

  /// Columns that the options have in units of practice where these are asked for.
  template <class Row>
  static io::Columns<Row> in_units(io::Columns<Row> columns, const SweepOptions& options) {
    if (!options.si && !options.output.json)
      to_practice(columns);
    return columns;
  }

  /// Headings of the cells after the first ones: answer, rungs, notes, error.
  [[nodiscard]] std::vector<std::string> result_headings() const;
  /// \param    cells   first cells of the row
  /// \param    place   first members of the object in JSON
  void add(std::vector<io::CsvCell> cells, nlohmann::ordered_json place, const SweptState& state);
  /// A document of the rungs, the states and the remarks.
  [[nodiscard]] Document document(const estimate::Notes& remarks) &&;

 private:
  const SweepOptions& options_;
  Rungs rungs_;
  io::Columns<SweptState> columns_;
  std::optional<std::size_t> shape_cell_; ///< of the kind of grains, if the table has its column
  io::CsvManner manner_;
  Rows rows_;
};

/// Where the options ask for the result of a sweep.
[[nodiscard]] Outlets outlets_of(const SweepOptions& options);
/// Prints the document, and names the files that were written.
[[nodiscard]] ExitCode deliver_sweep(const Outlets& to, const Document& document);

/// The assumptions of the answers, and whether contacts grow or are constant.
[[nodiscard]] estimate::Notes remarks_on(const SweepOptions& options, estimate::Notes assumptions);

/// Sweeps the states of options.table.
ExitCode sweep_table(const SweepOptions& options, const Rungs& rungs);
/// Sweeps a stress path.
ExitCode sweep_path(const SweepOptions& options, const Rungs& rungs);
/// Sweeps the depths of the ground.
ExitCode sweep_depth(const SweepOptions& options);

/// The answer of a state, that for spheres, and that for a sand; null where there is none.
[[nodiscard]] const estimate::Answer* answer_in(const SweptState& state);
[[nodiscard]] const estimate::Answer* beads_in(const SweptState& state);
[[nodiscard]] const estimate::Answer* sand_in(const SweptState& state);

/// A number of the answers with its range, where it exists.
using AnswerOf = const estimate::Answer* (*)(const SweptState& state);
[[nodiscard]] Band band_of(estimate::Field field, const std::vector<double>& at,
                           const std::vector<const SweptState*>& states, AnswerOf answer_of);
/// Adds the range of the published laws to the chart, with --laws.
/// \param    at   the position of each state, as for add_band
void add_law_band(plot::Chart& chart, const SweepOptions& options, const std::vector<double>& at,
                  const std::vector<const SweptState*>& states, bool sideways);

} // namespace granum::cli
