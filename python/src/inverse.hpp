// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <granum/core/numerics.hpp>
#include <granum/inverse/sand_inference.hpp>

#include "rows.hpp"

/// What infer() of spheres and of sands have in common.
namespace granum::python {

struct MeasuredRow {
  double value = nan;
  double standard_error = nan;
};

/// Keywords of predict(), after self: the quantity, the stresses, the void ratio, the saturation.
/// \param    otherwise   the void ratio where none is given, in words
[[nodiscard]] std::vector<Keyword> predict_keywords(const std::string& otherwise);

/// Predictions for every element.
/// \param    a               the keywords of predict
/// \param    first           the state of the first measurement, whose stresses and void ratio are replaced
/// \param    void_ratio_at   that of the packing at another mean stress [Pa], where none is given
[[nodiscard]] py::object predicted_rows(
    const Arguments& a, const effective::State& first,
    const std::function<double(double mean_stress)>& void_ratio_at,
    const std::function<Measured(const effective::State& at, std::optional<double> saturation, Notes& notes)>&
        predict);

/// Each measurement as it was fitted, and how far it is off.
[[nodiscard]] std::vector<Measured> fitted_values(const std::vector<inverse::FittedObservation>& all);
[[nodiscard]] std::vector<double> deviations(const std::vector<inverse::FittedObservation>& all);

/// An Inference of Python.
/// \throws   InvalidArgument and NotConverged as inverse::infer
[[nodiscard]] py::object sphere_inference(const std::vector<inverse::Observation>& measurements,
                                          const inverse::InferenceOptions& options);
/// A SandInference of Python.
/// \throws   InvalidArgument as inverse::infer_sand
[[nodiscard]] py::object sand_inference(const std::vector<inverse::Observation>& measurements,
                                        const estimate::Question& sand, inverse::SandGrowth growth);

void bind_sand_inference(py::module_& module);
/// The function infer().
void bind_infer(py::module_& module);

} // namespace granum::python
