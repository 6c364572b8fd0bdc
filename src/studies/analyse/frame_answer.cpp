// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame_answer.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <granum/core/text.hpp>
#include <granum/core/units.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/elastic/isotropic.hpp>

namespace granum::studies {

namespace {

/// Why rung 3 is not evaluated for a packing that is not rigid.
std::string declined(const analysis::Measurement& packing) {
  return "not evaluated: z* = " + short_text(packing.microstructure().mechanical_coordination_number) +
         " is not above the isostatic value " +
         short_text(effective::isostatic_coordination_number(packing.state->tangential_ratio)) +
         " (network not rigid)";
}

void add_closed_forms(FrameAnswer& frame) {
  for (const analysis::ClosedForm& form : frame.measured.packing.closed_forms) {
    RungResult result{
        .name = form.rung->column, .title = effective::label(*form.rung), .error = form.refusal};
    if (form.answer && declines(*form.answer)) {
      result.error = declined(frame.measured.packing);
      frame.validity.merge(form.answer->validity);
    } else if (form.answer) {
      result.moduli = moduli_of(form.answer->stiffness);
      result.relative_error = form.answer->relative_error;
      frame.validity.merge(form.answer->validity);
    }
    frame.rungs.push_back(std::move(result));
  }
}

void add_network(FrameAnswer& frame) {
  if (!frame.measured.packing.network)
    return;
  const network::Response& response = frame.measured.packing.network->response;
  frame.rungs.push_back(
      {.name = "affine", .title = "network, affine", .moduli = moduli_of(response.affine())});
  RungResult result{.name = network_name(),
                    .title = effective::label(effective::rung(effective::RungName::network)) + ", network"};
  if (response.converged())
    result.moduli = moduli_of(response.relaxed());
  else
    result.error = "did not converge";
  frame.rungs.push_back(std::move(result));
}

void set_ratios(FrameAnswer& frame) {
  const RungResult* network = find_rung(frame, network_name());
  for (RungResult& rung : frame.rungs)
    rung.one_axis = !frame.measured.triaxial;
  for (RungResult& rung : frame.rungs)
    if (network != nullptr && rung.moduli && rung.moduli->K > 0 && rung.moduli->G > 0) {
      rung.network_over_K = network->moduli->K / rung.moduli->K;
      rung.network_over_G = network->moduli->G / rung.moduli->G;
    }
}

/// The window, and the quantities that refer to it.
std::string window_text(const analysis::Window& window, const std::array<bool, 3>& periodic) {
  std::string ranges;
  for (int axis = 0; axis < 3; ++axis)
    ranges += (axis > 0 ? "," : "") + (periodic[static_cast<std::size_t>(axis)]
                                           ? std::string("..")
                                           : pretty(window.low[axis], Dimension::length) + ".." +
                                                 pretty(window.high[axis], Dimension::length));
  ranges.erase(std::remove(ranges.begin(), ranges.end(), ' '), ranges.end());
  return "the closed forms apply to the interior, --window " + ranges +
         ", two to three grains from walls and free surfaces (--window none: to the whole packing); the "
         "network and its 6x6 stiffness apply to the whole packing with its walls";
}

} // namespace

PrintedStress printed(const packing::ContactStress& stress) {
  const Mat3& s = stress.tensor; // f_i l_j
  return {s(0, 0), s(1, 1), s(2, 2), s(1, 0), s(2, 0), s(2, 1)};
}

Moduli moduli_of(const elastic::TransverselyIsotropic& c) {
  return {.K = c.bulk_modulus(),
          .G = elastic::projected_shear_modulus(c),
          .G_hh = c.G_hh(),
          .G_vh = c.G_vh(),
          .C11 = c.C11,
          .C33 = c.C33,
          .C12 = c.C12,
          .C13 = c.C13};
}

Moduli moduli_of(const elastic::VoigtStiffness& stiffness) {
  return moduli_of(elastic::transversely_isotropic_projection(stiffness));
}

std::string network_name() { return effective::rung(effective::RungName::network).column; }
std::string relaxed_name() { return effective::rung(effective::RungName::relaxed).column; }

FrameAnswer answer_frame(const io::ImportedPacking& packing, const MeasureOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  analysis::Given given = options.given;
  analysis::Wanted wanted = options.wanted;
  given.materials = materials_of(packing, options.materials);
  const auto chosen = options.choose_window && !options.window ? interior_window(packing) : std::nullopt;
  if (options.window || chosen)
    wanted.window = window_in(packing, options.window ? *options.window : *chosen);
  FrameAnswer frame{.read = packing.notes, .measured = measure_frame(packing, given, wanted)};
  frame.window = wanted.window;
  if (chosen)
    frame.validity.add(window_text(*wanted.window, packing.periodic));
  if (options.profile) {
    frame.profile_axis = options.profile->axis;
    frame.profile = analysis::profile(packing.assembly, frame.measured.packing,
                                      options.window ? *wanted.window : window_in(packing, {}),
                                      options.profile->axis, options.profile->slices);
  }
  add_closed_forms(frame);
  add_network(frame);
  set_ratios(frame);
  if (options.modes > 0)
    frame.modes =
        network::lowest_modes(stiffened(packing, given), given.grain_density.value(), options.modes);
  for (network::Mode& mode : frame.modes)
    mode.motion = {}; // of many frames they would be much
  frame.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return frame;
}

const RungResult* find_rung(const FrameAnswer& frame, const std::string& name) {
  const auto found = std::find_if(frame.rungs.begin(), frame.rungs.end(),
                                  [&](const RungResult& rung) { return rung.name == name && rung.moduli; });
  return found == frame.rungs.end() ? nullptr : &*found;
}

std::optional<double> mean_stress(const FrameAnswer& frame) {
  const analysis::Measurement& m = frame.measured.packing;
  if (frame.window && m.interior && m.stress)
    return trace(m.interior->stress) / 3;
  return m.stress ? std::optional(m.stress->mean()) : std::nullopt;
}

std::optional<double> mean_code_stress(const FrameAnswer& frame) {
  if (!frame.code_stress)
    return std::nullopt;
  const PrintedStress& s = *frame.code_stress;
  return (s[0] + s[1] + s[2]) / 3;
}

std::array<std::optional<double>, 6> stress_differences(const FrameAnswer& frame) {
  std::array<std::optional<double>, 6> out;
  if (!frame.code_stress || !frame.measured.packing.stress)
    return out;
  const PrintedStress own = printed(*frame.measured.packing.stress), &code = *frame.code_stress;
  for (std::size_t k = 0; k < out.size(); ++k)
    if (code[k] != 0)
      out[k] = own[k] / code[k] - 1;
  return out;
}

std::optional<double> largest_stress_difference(const FrameAnswer& frame) {
  if (!frame.code_stress || !frame.measured.packing.stress)
    return std::nullopt;
  const PrintedStress own = printed(*frame.measured.packing.stress), &code = *frame.code_stress;
  double largest = 0, apart = 0;
  for (std::size_t k = 0; k < own.size(); ++k) {
    largest = std::max(largest, std::abs(code[k]));
    apart = std::max(apart, std::abs(own[k] - code[k]));
  }
  return apart == 0 ? 0 : apart / largest;
}

std::optional<double> network_over_relaxed(const FrameAnswer& frame) {
  const RungResult* relaxed = find_rung(frame, relaxed_name());
  return relaxed == nullptr ? std::nullopt : relaxed->network_over_G;
}

} // namespace granum::studies
