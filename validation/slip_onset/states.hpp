// SPDX-License-Identifier: GPL-3.0-or-later
// The grains of the record.
#pragma once

#include <granum/contact/power_law.hpp>

namespace slip_onset {

constexpr double radius = 0.5e-3; ///< [m]
constexpr double friction = 0.5;
inline const granum::contact::GrainMaterial quartz{.shear_modulus = 44e9, .poisson_ratio = 0.074};

inline double tangential_ratio() { return granum::contact::mindlin_stiffness_ratio(quartz.poisson_ratio); }

} // namespace slip_onset
