// SPDX-License-Identifier: GPL-3.0-or-later
#include <initializer_list>

#include <granum/core/stop.hpp>
#include <granum/network/linear_response.hpp>

#include "large_networks.hpp"
#include "network/backbone.hpp"
#include "unit.hpp"

namespace {

void check_same_bits(const packing::Assembly& a, std::size_t pieces,
                     std::initializer_list<std::size_t> team_sizes) {
  REQUIRE(network::load_bearing_network(a, {}).stages.front().size() == pieces);
  // A few iterations add up in the order that a thousand would.
  constexpr double tolerance = 1e-4;
  const network::Response alone = network::linear_response(a, {.tolerance = tolerance});
  REQUIRE(alone.converged());
  for (const std::size_t threads : team_sizes) {
    CAPTURE(threads);
    const network::Response shared =
        network::linear_response(a, {.tolerance = tolerance, .threads = threads});
    CHECK(shared.report().iterations == alone.report().iterations);
    CHECK(shared.report().residual == alone.report().residual);
    CHECK(shared.last_iterate().matrix == alone.last_iterate().matrix);
  }
}

void check_pieces(const network::Backbone& backbone) {
  REQUIRE(backbone.stages.size() == 3);
  std::vector<std::size_t> piece(backbone.grain_count, 0), stage(backbone.grain_count, 0);
  std::vector<int> seen(backbone.grain_count, 0);
  std::size_t pieces = 0;
  for (std::size_t s = 0; s < backbone.stages.size(); ++s)
    for (const network::Piece& p : backbone.stages[s]) {
      ++pieces;
      for (std::uint32_t g = p.first; g < p.last; ++g) {
        ++seen[g];
        piece[g] = pieces;
        stage[g] = s;
      }
    }
  CHECK(pieces == 7);
  CHECK(seen == std::vector<int>(backbone.grain_count, 1));
  std::vector<std::vector<std::uint32_t>> later(backbone.grain_count);
  std::size_t clashes = 0;
  const auto clash = [&](std::uint32_t g, std::uint32_t h) {
    return stage[g] == stage[h] && piece[g] != piece[h];
  };
  for (const network::Link& l : backbone.links) {
    later[l.a].push_back(l.b);
    if (clash(l.a, l.b))
      ++clashes;
  }
  for (const auto& neighbours : later)
    for (const std::uint32_t g : neighbours)
      for (const std::uint32_t h : neighbours)
        if (clash(g, h))
          ++clashes;
  CHECK(clashes == 0);
}

} // namespace

TEST_CASE("the response has the same bits for any number of threads") {
  check_same_bits(samples::large_network(19, 0.6), 2, {2, 20});
  check_same_bits(samples::large_network(19, 0.8, 0), 2, {2});
  check_same_bits(samples::large_network(28, 0.8), 4, {3});  // with a coarse grid
  check_same_bits(samples::large_network(29, 0.27), 4, {3}); // and pivots judged
}

TEST_CASE("a stop request ends the response at every stop point, on one thread and on several") {
  const packing::Assembly a = samples::large_network(28, 0.8); // with a coarse grid
  for (const std::size_t threads : {std::size_t{1}, std::size_t{3}}) {
    const network::ResponseOptions options{.tolerance = 1e-4, .threads = threads};
    std::size_t calls = 0, last = 1 << 30;
    const StopScope scope([&] { return ++calls > last; });
    (void)network::linear_response(a, options);
    const std::size_t all = calls;
    CHECK(all > 100);
    for (std::size_t part = 0; part < 4; ++part) {
      calls = 0, last = all * part / 4;
      CHECK_THROWS_AS((void)network::linear_response(a, options), Stopped);
    }
  }
}

TEST_CASE(
    "pieces contain every grain once, and touch none of their stage, also through an earlier neighbour") {
  for (const double kept : {0.6, 0.26})
    check_pieces(network::load_bearing_network(samples::large_network(28, kept), {}));
}
