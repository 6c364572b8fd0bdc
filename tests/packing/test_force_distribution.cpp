// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/forces.hpp>

#include "sample_packings.hpp"
#include "sphere_chain.hpp"
#include "unit.hpp"

TEST_CASE(
    "force distribution: every contact is counted once, in its bin, beyond the last or as not pressing") {
  // mean of the pressing ones 2, so 0.5, 1, 1.5 and 1: 0.5 lies at the lower end of its bin
  const std::vector<double> forces{1, 2, 3, 2, 0, -1, 0};
  const packing::ForceDistribution d = packing::force_distribution(forces, 4, 1.2);
  CHECK(d.pressing == 4);
  CHECK(d.unloaded == 2);
  CHECK(d.in_tension == 1);
  CHECK(d.mean == relative(2, 1e-15));
  CHECK(d.largest == 3);
  REQUIRE(d.bins.size() == 4);
  CHECK(d.bins[1].low == relative(0.3, 1e-15));
  CHECK(d.bins[3].high == relative(1.2, 1e-15));
  CHECK((d.bins[0].count == 0 && d.bins[1].count == 1 && d.bins[2].count == 0 && d.bins[3].count == 2));
  CHECK(d.beyond == 1);
  CHECK(d.bins[3].density == relative(2 / (4 * 0.3), 1e-14));
  CHECK(d.bins[3].density_error == relative(std::sqrt(2.0) / (4 * 0.3), 1e-14));
}

TEST_CASE(
    "force distribution: without a pressing contact the bins are empty, and bad arguments are refused") {
  CHECK(packing::force_distribution(std::vector<double>{}).mean == 0);
  const packing::ForceDistribution none = packing::force_distribution(std::vector<double>{-1, 0}, 2);
  CHECK((none.pressing == 0 && none.mean == 0 && none.largest == 0 && none.bins[0].density == 0));
  const std::vector<double> one{1};
  CHECK_THROWS_AS((void)packing::force_distribution(one, 0), InvalidArgument);
  CHECK_THROWS_AS((void)packing::force_distribution(one, 1001), InvalidArgument);
  CHECK_THROWS_AS((void)packing::force_distribution(one, 4, 0), InvalidArgument);
  CHECK_THROWS_AS(
      (void)packing::force_distribution(std::vector<double>{std::numeric_limits<double>::infinity()}),
      InvalidArgument);
  CHECK(normal_forces(samples::sphere_chain()) ==
        std::vector<double>{samples::chain_force_ab, samples::chain_force_bc});
}
