// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include <granum/analysis/measure.hpp>

#include "functions.hpp"
#include "packing.hpp"

/// What the functions of packings and their contact networks share.
namespace granum::python {

/// The packing, and what may be given of its contacts.
[[nodiscard]] std::vector<Keyword> given_keywords();
/// The latter, of a call with these keywords.
[[nodiscard]] analysis::Given given_of(const Arguments& a, const Packing& packing);

/// The class Network of a measurement.
void bind_network(py::module_& module);

/// Motions of all grains as an array, (number of motions, N, 6).
[[nodiscard]] inline py::array array_of_motions(std::span<const std::vector<network::GrainMotion>> motions) {
  static_assert(sizeof(network::GrainMotion) == 6 * sizeof(double));
  const std::size_t grains = motions.empty() ? 0 : motions[0].size();
  py::array_t<double> out(std::vector<std::size_t>{motions.size(), grains, 6});
  for (std::size_t k = 0; k < motions.size() && grains > 0; ++k)
    std::memcpy(out.mutable_data(static_cast<py::ssize_t>(k), 0, 0), motions[k].data(),
                grains * sizeof(network::GrainMotion));
  return out;
}

} // namespace granum::python
