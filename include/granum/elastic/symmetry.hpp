// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/stiffness.hpp>

/// How far a stiffness is from the classes of symmetry: pure numbers, so that soil in Pa and quartz in GPa
/// are treated alike. The caller decides which distance still counts as symmetric: rounding is 1e-15, a
/// measured or simulated stiffness carries its own error.
/// Checked by tests/elastic/test_symmetry.cpp
namespace granum::elastic {

/// |C - P(C)|/|C| in the Mandel norm, in [0, 1], with P(C) the nearest stiffness of the class. [Moakher2006]
/// The classes lie within one another: isotropic >= transversely_isotropic >= orthotropic and isotropic >=
/// cubic >= orthotropic, but for rounding.
struct SymmetryDistances {
  double isotropic = 0;              ///< the same for every choice of axes
  double cubic = 0;                  ///< cube edges along the coordinate axes
  double transversely_isotropic = 0; ///< axis of symmetry 3
  double orthotropic = 0;            ///< planes of symmetry across the coordinate axes
};

/// \throws   InvalidArgument if the stiffness is zero, not symmetric (mandel.hpp) or not finite
/// Accuracy  1e-15 absolute.
[[nodiscard]] SymmetryDistances symmetry_distances(const VoigtStiffness& stiffness);

} // namespace granum::elastic
