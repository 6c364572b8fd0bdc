// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/estimates.hpp>

#include <granum/fabric/orientation.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

namespace {

/// The log-likelihood of a, by its definition.
double log_likelihood(const std::vector<Vec3>& normals, double a) {
  double sum = 0;
  for (const Vec3& n : normals)
    sum += std::log(fabric::density(std::atan2(std::hypot(n.x, n.y), n.z), a));
  return sum;
}

} // namespace

TEST_CASE("likelihood estimate: no other anisotropy makes the sample more likely") {
  std::uint64_t seed = 1;
  for (const double a : {-0.6, -0.2, 0.0, 0.6, 0.8}) {
    const auto normals = fabric::sample_normals(a, 500, seed++);
    const auto estimate = fabric::estimate_anisotropy_by_likelihood(normals);
    REQUIRE_FALSE(estimate.at_boundary);
    const double best = log_likelihood(normals, estimate.anisotropy);
    double brute = -1;
    for (double other = -0.999; other < 1; other += 0.001)
      if (log_likelihood(normals, other) > log_likelihood(normals, brute))
        brute = other;
    CHECK(std::abs(estimate.anisotropy - brute) <= 0.0011);
    CHECK(best >= log_likelihood(normals, brute));
    // the gain is that over isotropy, and the error the curvature at the top
    CHECK(estimate.log_likelihood_gain == relative(best - log_likelihood(normals, 0), 1e-9));
    constexpr double step = 1e-3;
    const double curvature = (log_likelihood(normals, estimate.anisotropy + step) - 2 * best +
                              log_likelihood(normals, estimate.anisotropy - step)) /
                             (step * step);
    CHECK(estimate.standard_error == relative(1 / std::sqrt(-curvature), 1e-3)); // step^2 and rounding
    CHECK(estimate.contacts == 500);
    CHECK(estimate.validity.ok());
  }
}

TEST_CASE("likelihood estimate: a maximum at the end of the range is reported as such") {
  const std::vector<Vec3> vertical(30, Vec3{0, 0, 1}), flat(30, Vec3{0.6, 0.8, 0});
  const auto up = fabric::estimate_anisotropy_by_likelihood(vertical);
  CHECK(up.anisotropy == 1);
  CHECK(up.at_boundary);
  CHECK_FALSE(up.validity.ok());
  CHECK(up.log_likelihood_gain == relative(30 * std::log(3), 1e-14)); // E(0) = 3/(4 pi) at a = 1
  const auto down = fabric::estimate_anisotropy_by_likelihood(flat);
  CHECK(down.anisotropy == -1);
  CHECK(down.at_boundary);
  CHECK(down.log_likelihood_gain == relative(30 * std::log(1.5), 1e-14));

  // one contact where the density of that end vanishes, and the end is impossible
  std::vector<Vec3> mixed = vertical;
  mixed.push_back({1, 0, 0});
  const auto inside = fabric::estimate_anisotropy_by_likelihood(mixed);
  CHECK_FALSE(inside.at_boundary);
  // 30 contacts of P2 = 1, one of -1/2: 30/(1+x) = (1/2)/(1-x/2) at x = 59/31
  CHECK(inside.anisotropy == relative(3 * (59. / 31) / (4 + 59. / 31), 1e-13));
}

TEST_CASE("likelihood estimate: a standard error above 1 has a note") {
  int noted = 0;
  for (std::size_t count = 2; count < 30; ++count) {
    const auto estimate = fabric::estimate_anisotropy_by_likelihood(fabric::sample_normals(0.2, count, 3));
    CHECK(estimate.validity.notes.size() ==
          (estimate.at_boundary ? 1U : 0U) + (estimate.standard_error > 1 ? 1U : 0U));
    noted += estimate.standard_error > 1;
  }
  CHECK((noted > 1 && noted < 28));
  const double height = std::sqrt((1 + 2e-2) / 3), width = std::sqrt(1 - height * height); // P2 = 0.01
  check_threshold(std::pow(12 / 16.0 / 0.01, 2), [&](double count) {
    std::vector<Vec3> normals(2 * static_cast<std::size_t>(count / 2), Vec3{width, 0, height});
    const double low = std::sqrt((1 - 2e-2) / 3);
    for (std::size_t k = 0; k < normals.size(); k += 2)
      normals[k] = {std::sqrt(1 - low * low), 0, low};
    return fabric::estimate_anisotropy_by_likelihood(normals).validity.notes.size();
  });
}

TEST_CASE("likelihood estimate: contacts along cube diagonals do not determine a, with a note") {
  const double s = std::sqrt(1.0 / 3);
  std::vector<Vec3> lattice;
  for (const double x : {-s, s})
    for (const double y : {-s, s})
      lattice.push_back({x, y, s});
  const auto estimate = fabric::estimate_anisotropy_by_likelihood(lattice);
  CHECK(estimate.anisotropy == 0);
  CHECK(std::isinf(estimate.standard_error));
  CHECK(estimate.log_likelihood_gain == 0);
  CHECK_FALSE(estimate.at_boundary);
  CHECK(estimate.validity.notes.size() == 1);
}
