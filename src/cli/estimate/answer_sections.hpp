// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/plot/chart.hpp>

#include "answer_case.hpp"
#include "cli/document/document.hpp"

/// Sections, columns and curves of an answer, for every command that has one.
namespace granum::cli {

/// "sand (measured laws)" or "beads (spheres of the model)".
[[nodiscard]] const char* title_of(estimate::GrainShape shape);

/// The inputs of the answer, "inputs", and of an answer for a sand beside it, "sand_inputs", without the
/// stress.
void add_packing(Document& to, const InputValues& values, const effective::State& state, bool sand_beside);
/// The answer, or both, with what their ranges are made of: "answer" and "sand_answer" in JSON, the latter
/// null where one kind of grains is asked for.
void add_answers(Document& to, const AnswerCase& c);
/// Laws measured on sands at this state, "measured_sands".
[[nodiscard]] Table measured_laws_table(const AnswerCase& c);
/// G/G0 by published laws, "strain_laws"; without rows unless a strain of a sand is given.
[[nodiscard]] Table strain_laws_table(const AnswerCase& c);

/// "contacts 81 %, grain-shear-modulus 12 %": contributions to the range of G, largest first, without those
/// that round to 0; empty if there are none.
[[nodiscard]] std::string shares_text(const estimate::Answer& answer);
/// The largest of them, and options that reduce it: "contacts 87 %: --preparation, --rattler-fraction".
[[nodiscard]] std::string largest_share(const estimate::Answer& answer, const estimate::Question& question);
/// What is known of the contacts; empty for a sand and for given contacts.
[[nodiscard]] std::string preparation_remark(const estimate::Question& question);

/// Columns of a table, each number with the ends of its range.
/// \param    before   prefix of the headings: "sand_" for the answer for a sand next to that for spheres
/// \param    all        every number; else only G, V_s, V_p, z* and s
/// \param    strained   besides these G, G/G0 and damping at a shear strain
[[nodiscard]] io::Columns<estimate::Answer> answer_columns(bool all, bool strained,
                                                           const std::string& before = "");

// ---- pictures

/// n values from first to last, with exact ends.
[[nodiscard]] std::vector<double> spread(double first, double last, std::size_t n, bool logarithmic);

/// A line in the middle of its band.
struct Band {
  std::vector<double> at;
  std::vector<estimate::Range> ranges;

  void add(double x, const estimate::Range& range) {
    at.push_back(x);
    ranges.push_back(range);
  }
};
/// \param    sideways   values to the right, positions downwards, as for depth
/// \param    name       of the line in the legend
void add_band(plot::Chart& chart, const Band& band, bool sideways, const std::string& name = "answer",
              plot::Colour colour = plot::Colour::closed_form);

} // namespace granum::cli
