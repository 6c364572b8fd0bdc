// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/core/vec3.hpp>

namespace granum::fabric {

/// Unit vectors drawn independently from E(gamma; a): n3 by the inverse of its distribution, the azimuth by a
/// point in the unit disc [Marsaglia1972]. Random bits by Boost, then sums, products, quotients and square
/// roots only: the same seed gives the same bits on every machine. A longer sample begins with the shorter.
/// \param    anisotropy   a in [-1, 1]
/// \param    count        number of vectors, 0 allowed
/// \param    seed         any number; one seed, one sample
/// \throws   InvalidArgument if a is outside [-1, 1]
/// Accuracy  of unit length to 4 ulp.  Checked by tests/fabric/test_sampling.cpp
[[nodiscard]] std::vector<Vec3> sample_normals(double anisotropy, std::size_t count, std::uint64_t seed);

} // namespace granum::fabric
