// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sizes/sampling.hpp>

#include <utility>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <granum/core/stop.hpp>

namespace granum::sizes {

std::vector<double> sample_radii(const Distribution& sizes, std::size_t count, std::uint64_t seed,
                                 Drawing drawing) {
  boost::random::mt19937_64 bits(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> radii(count);
  if (drawing == Drawing::plain) {
    for (std::size_t k = 0; k < count; ++k) {
      stop_point(k);
      radii[k] = sizes.quantile(unit(bits));
    }
    return radii;
  }
  for (std::size_t k = 0; k < count; ++k) {
    stop_point(k);
    radii[k] = sizes.quantile((static_cast<double>(k) + unit(bits)) / static_cast<double>(count));
  }
  for (std::size_t k = count; k > 1; --k) // the standard library's shuffle differs between vendors
    std::swap(radii[k - 1], radii[boost::random::uniform_int_distribution<std::size_t>(0, k - 1)(bits)]);
  return radii;
}

} // namespace granum::sizes
