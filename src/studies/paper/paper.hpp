// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <granum/contact/laws.hpp>
#include <granum/stress/stress.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::studies {

/// A row of the paper's Table 5: G_ij = C p_a f(e) (s_i/p_a)^m (s_j/p_a)^n fitted over -0.6 <= eta <= 0.6.
struct PrintedFit {
  std::optional<double> m; ///< none for G_hh, which depends on one stress
  std::optional<double> n;
  double s = 0;
  double C = 0; ///< for p_a in MPa: see validation/paper_constants
};

/// Values of the paper for one of its six specimens.                            [Chung2014, Tables 2, 4, 5]
struct PrintedSpecimen {
  double coordination_number = 0;         ///< at 10 kPa
  double void_ratio = 0;                  ///< at 10 kPa
  std::array<double, 4> friction_angle{}; ///< at the peak, in the order of stress::all_shear_paths [deg]
  PrintedFit hh, hv, vh;
};

/// \return   empty for a contact shape that is not in the paper
/// Checked by tests/studies/test_paper.cpp
[[nodiscard]] std::optional<PrintedSpecimen> printed(contact::Shape contact, triaxial::Density density);

} // namespace granum::studies
