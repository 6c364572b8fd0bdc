// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/sampling.hpp>

#include <cmath>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/fabric/polar_distribution.hpp>

namespace granum::fabric {

std::vector<Vec3> sample_normals(double anisotropy, std::size_t count, std::uint64_t seed) {
  require_closed("fabric_anisotropy", anisotropy, -1, 1);
  boost::random::mt19937_64 bits(seed);
  boost::random::uniform_real_distribution<double> signed_unit(-1, 1);

  std::vector<Vec3> normals;
  normals.reserve(count);
  while (normals.size() < count) {
    stop_point(normals.size());
    const double height = signed_unit(bits);
    const double z = std::copysign(polar_cosine_quantile(std::abs(height), anisotropy), height);
    double x = 0, y = 0, square = 0;
    do {
      x = signed_unit(bits);
      y = signed_unit(bits);
      square = x * x + y * y;
    } while (square > 1 || square < 1e-20); // too near the centre the direction would lose digits
    const double stretch = std::sqrt((1 - z) * (1 + z) / square);
    normals.push_back({stretch * x, stretch * y, z});
  }
  return normals;
}

} // namespace granum::fabric
