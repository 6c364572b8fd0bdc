// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/network/linear_response.hpp>

#include "large_networks.hpp"
#include "packing/sample_packings.hpp"
#include "unit.hpp"
#include "vector_levels.hpp"

TEST_CASE("the response of a network has the same bits at every vector level") {
  if (test::levels_beyond_baseline().empty())
    MESSAGE("NOT COMPARED: this machine or build has the plain level only");
  const packing::Assembly rough = samples::random_network({.seed = 21, .repeats = 2, .kept = 0.5});
  const packing::Assembly smooth =
      samples::random_network({.seed = 22, .repeats = 2, .kept = 0.7, .tangential_ratio = 0});
  const packing::Assembly large = samples::large_network(28, 0.8); // with a coarse grid
  for (const packing::Assembly& assembly : {rough, smooth, large}) {
    const auto response = [&](VectorLevel level) {
      const test::LevelSet at(level);
      return network::linear_response(assembly, {.tolerance = 1e-4}); // enough iterations to differ in
    };
    const network::Response plain = response(VectorLevel::baseline);
    CHECK(plain.report().iterations > 0);
    for (const VectorLevel level : test::levels_beyond_baseline()) {
      CAPTURE(static_cast<int>(level));
      const network::Response other = response(level);
      CHECK(other.report().iterations == plain.report().iterations);
      CHECK(other.relaxed().matrix == plain.relaxed().matrix);
    }
  }
}
