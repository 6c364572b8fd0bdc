// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/inverse/sand_inference.hpp>
#include <granum/io/csv/table.hpp>
#include <nlohmann/json.hpp>

#include "cli/document/document.hpp"
#include "cli/frame/frame.hpp"
#include "cli/options/ground.hpp"
#include "cli/options/input_options.hpp"
#include "cli/options/packing_json.hpp"

/// The computations of granum infer, and their presentation.
namespace granum::cli {

/// A quantity as an option and as a column of a table.
struct MeasuredOption {
  inverse::Quantity quantity;
  const char* option;       ///< "--shear-wave-speed,--vs"
  std::string_view columns; ///< names of the column, without the unit, separated by blanks
  const char* help;
  const char* synonyms = "";
  [[nodiscard]] Dimension dimension() const;
};
[[nodiscard]] std::span<const MeasuredOption> measured_options();
/// Of the values of a quantity.
[[nodiscard]] Dimension dimension_of(const inverse::QuantityRow& row);

struct InferOptions {
  InputValues inputs;
  OutputOptions output;
  std::array<std::string, 7> measured; ///< as given, in the order of measured_options(); empty: not given
  Number measurement_error;            ///< relative, for measurements without an error
  std::string table;
  GroundOptions ground;                      ///< of a table with depths
  std::string growth;                        ///< empty: "sand" for a sand, "packings" for spheres
  std::string contacts = "given";            ///< family of contact laws to infer
  std::vector<std::string> uncertain;        ///< key=sd
  std::vector<std::string> predict_pressure; ///< with unit
  Number predict_stress_ratio;
  Number predict_void_ratio;
  std::string picture, report; ///< files; empty for none
  std::string picture_of;
};

/// A state of a prediction.
struct PredictedState {
  effective::State state;
  inverse::AskedPacking specimen = inverse::AskedPacking::same;
};

/// The question: measurements, their common inputs, and the states of the predictions.
struct InferCase {
  std::vector<inverse::Observation> measurements;
  inverse::InferenceOptions options;
  /// The sand and its growth with stress, unless the grains are given as spheres.
  std::optional<estimate::Question> sand = {};
  inverse::SandGrowth sand_growth = inverse::SandGrowth::measured;
  bool of_spheres = true; ///< unless the grains are given as sand
  std::vector<PredictedState> predicted;
  nlohmann::ordered_json packing, sand_packing; ///< inputs of spheres, or of a sand; of a sand beside them
  estimate::Notes assumptions;                  ///< inputs that were not given
  std::vector<double> depths = {};              ///< of the measurements in a borehole; else empty [m]
  Validity ground = {};                         ///< what contradicts each other in its ground
  io::CsvManner manner = {};                    ///< of the table of measurements
};

/// \throws   InvalidArgument or FileError for invalid options and tables
[[nodiscard]] InferCase infer_case(const InferOptions& options);

/// A number with its error, "587m/s+-5m/s", "587+-5m/s" or "587m/s+-1%"; without an error, a default relative
/// error.
/// \throws   InvalidArgument
[[nodiscard]] Measured parse_measured(const std::string& name, const std::string& text, Dimension dimension,
                                      double relative_error);

/// The relative error of a measurement without an error of its own.
[[nodiscard]] double share_of(const Number& error, Dimension dimension);
/// The assumption for measurements without an error, noted once.
void note_assumed_error(const InferOptions& options, InferCase& question, bool stated);

/// Fills in the measurements of the table, whose rows may be depths in the ground.
/// \return   what the first row knows of its packing, without its contacts; the material and the water are
///           the same in all rows
/// \throws   FileError, also for a material that is not the same in all rows
[[nodiscard]] InputValues read_table(const InferOptions& options, InferCase& question);

/// Whether the quantity can be used and predicted: compression waves in wet pores of any measurement cannot.
[[nodiscard]] bool is_told(const InferCase& question, const inverse::QuantityRow& row);

/// The notes of `doubts` on a prediction, with its stress.
/// \throws   InvalidArgument for what `doubts` refuses, by the option of the prediction
[[nodiscard]] Validity doubts_of(const PredictedState& predicted, const std::function<Validity()>& doubts);
/// Fills in the void ratio of the measured packing at the stresses of the predictions, unless another one is
/// given.
/// \return   notes on the validity of the predictions, from the answer for each state
/// \throws   InvalidArgument if growing overlaps would leave no pores, and as estimate::answer()
/// Checked by tests/cli/rows/infer.txt
[[nodiscard]] Validity complete_predictions(InferCase& question, const inverse::Inference& fit);

/// The value of --growth for measured sands.
inline constexpr std::string_view sand_growth_name = "sand";

/// What was inferred of a sand, of spheres, or of both.
struct Inferred {
  InferCase of_sand, of_beads; ///< the predictions of the latter are of spheres that are compressed
  std::optional<inverse::SandInference> sand;
  std::optional<inverse::InferenceAnswer> beads;
  Validity validity;

  [[nodiscard]] bool both() const { return sand && beads; }
};

/// The inferred contact law, its correlations, and what would determine the rest.
void add_contact_law(Document& to, const std::string& kind, const inverse::ImpliedContacts& contacts);
/// "5.12 +- 0.08".
[[nodiscard]] std::string with_error(const Measured& number, int digits);
/// A line for a screen.
void add_line(Items& to, const char* label, std::string text, std::string meaning = "");

/// Measurements, what was inferred and predictions for each kind of grains; and as CSV all states.
void add_inferred(Document& to, const Inferred& all);

} // namespace granum::cli
