// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <granum/contact/laws.hpp>
#include <granum/triaxial/specimen.hpp>

#include "studies/verify/seed_mean.hpp"

namespace granum::studies {

enum class ExponentRoute { closed_form, network, probe };

/// How much s of G ~ p^s differs from one specimen of N grains to another of the same kind, by 16 seeds of
/// 1,000 grains at ten pressures from 10 to 100 kPa (probed at three), times (1000/N)^(1/2). A regression
/// along one path does not know of it: for loose specimens its own error is a third of this. Power-law
/// contacts are treated as flat ones, which scatter most.
/// Source    validation/verify_default/scatter.csv
/// Checked by tests/studies/test_exponent_scatter.cpp
[[nodiscard]] KnownScatter exponent_scatter(contact::Shape contact, triaxial::Density density,
                                            ExponentRoute route, std::size_t grains);

} // namespace granum::studies
