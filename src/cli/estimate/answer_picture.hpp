// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/plot/chart.hpp>
#include <granum/stress/axial_stress.hpp>

#include "answer_report.hpp"

/// Answers with their ranges as pictures.
namespace granum::cli {

/// Values with the stresses replaced by those of a state.
[[nodiscard]] InputValues at_stress(InputValues values, const stress::AxialStress& stress);

/// n values from first to last, with exact ends.
[[nodiscard]] std::vector<double> spread(double first, double last, std::size_t n, bool logarithmic);

/// A line in the middle of its band.
struct Band {
  std::vector<double> at;
  std::vector<estimate::Range> ranges;
};
/// \param    sideways   values to the right, positions downwards, as for depth
/// \param    name       of the line in the legend
void add_band(plot::Chart& chart, const Band& band, bool sideways, const std::string& name = "answer",
              plot::Colour colour = plot::Colour::closed_form);

/// G and its range around the state of the answer: over the shear strain with each published law, if a strain
/// is given; else over the mean stress, from a tenth to tenfold.
/// \throws   InvalidArgument without stress
[[nodiscard]] plot::Chart answer_chart(const InputValues& values,
                                       const std::vector<std::string>& uncertainties, const AnswerCase& here);

} // namespace granum::cli
