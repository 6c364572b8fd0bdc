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
#include <granum/plot/chart.hpp>
#include <nlohmann/json.hpp>

#include "cli/estimate/answer_options.hpp"
#include "cli/frame/frame.hpp"
#include "cli/options/packing_options.hpp"

/// What granum infer works out, and how it is put into words.
namespace granum::cli {

/// A quantity as an option and as a column of a table.
struct MeasuredOption {
  inverse::Quantity quantity;
  const char* option;                 ///< "--shear-wave-speed,--vs"
  std::array<const char*, 2> columns; ///< names of the column, besides the unit
  const char* help;
  const char* synonyms = "";
  [[nodiscard]] Dimension dimension() const;
};
[[nodiscard]] std::span<const MeasuredOption> measured_options();

struct InferOptions {
  PackingOptions packing;
  OutputOptions output;
  std::array<std::string, 7> measured; ///< as given, in the order of measured_options(); empty: not given
  Number measurement_error;            ///< relative, of those that state none
  AnswerOptions grains;                ///< mineral, sand, densities, water
  std::string table;
  std::string growth;                        ///< empty: of measured sands for a sand, of packings for spheres
  std::string contacts = "given";            ///< which are asked for
  std::vector<std::string> uncertain;        ///< key=sd
  std::vector<std::string> predict_pressure; ///< with unit
  Number predict_stress_ratio;
  Number predict_void_ratio;
  std::string picture; ///< file; empty for none
  std::string picture_of;
};

/// A state to predict for.
struct PredictedState {
  effective::State state;
  inverse::AskedPacking specimen = inverse::AskedPacking::same;
};

/// The question: measurements, what they share, and where something is to be predicted.
struct InferCase {
  std::vector<inverse::Observation> measurements;
  inverse::InferenceOptions options;
  /// The sand, and how it grows with stress, unless the grains are told to be spheres.
  std::optional<estimate::Question> sand = {};
  inverse::SandGrowth sand_growth = inverse::SandGrowth::measured;
  bool of_spheres = true; ///< unless the grains are told to be a sand
  std::vector<PredictedState> predicted;
  nlohmann::ordered_json packing;       ///< contact, grains and packing, SI
  std::vector<std::string> assumptions; ///< what was not given, one sentence each
  io::CsvManner manner = {};            ///< of the table of measurements
};

/// \throws   InvalidArgument or FileError for options and tables that cannot be understood
[[nodiscard]] InferCase infer_case(const InferOptions& options);

/// A number with its error, "587m/s+-5m/s", "587+-5m/s" or "587m/s+-1%"; without one, a relative error that
/// stands in.
/// \throws   InvalidArgument
[[nodiscard]] Measured parse_measured(const std::string& name, const std::string& text, Dimension dimension,
                                      double relative_error);

/// Whether the quantity can be told: compression waves in wet pores cannot.
[[nodiscard]] bool is_told(const InferCase& question, const inverse::QuantityRow& row);

/// Fills in the void ratio of the measured packing at the stresses to predict for, where no other is asked
/// for.
/// \return   what makes the predictions doubtful, as the answer to each state has it
/// \throws   InvalidArgument where growing contacts would leave no pores, and as estimate::answer()
/// Checked by tests/cli/infer.cmake
[[nodiscard]] Validity complete_predictions(InferCase& question, const inverse::Inference& fit);

/// What --growth calls that of measured sands.
inline constexpr std::string_view sand_growth_name = "sand";

/// What the measurements say of a sand, in words and in JSON.
[[nodiscard]] std::string sand_inference_text(const InferCase& question, const inverse::SandInference& sand);
[[nodiscard]] nlohmann::ordered_json sand_inference_json(const InferCase& question,
                                                         const inverse::SandInference& sand);
/// "p = 100 kPa, e = 0.6".
[[nodiscard]] std::string place_text(const effective::State& state);

[[nodiscard]] std::string infer_table(const InferCase& question, const inverse::InferenceAnswer& answer);
[[nodiscard]] std::string infer_csv(const InferCase& question, const inverse::InferenceAnswer& answer);
[[nodiscard]] nlohmann::ordered_json infer_json(const InferCase& question,
                                                const inverse::InferenceAnswer& answer);
[[nodiscard]] std::string sand_inference_csv(const InferCase& question, const inverse::SandInference& sand);
/// What is foretold of a state, whoever does it.
using Forecast = std::function<Measured(const effective::State& state, inverse::AskedPacking specimen)>;
/// Data, fit and its band over the mean stress.
/// \param    void_ratio_at   of the measured packing at another mean stress
[[nodiscard]] plot::Chart infer_chart(const InferCase& question, inverse::Quantity quantity,
                                      const Forecast& forecast,
                                      const std::function<double(double mean_stress)>& void_ratio_at);

} // namespace granum::cli
