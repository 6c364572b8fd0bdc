// SPDX-License-Identifier: GPL-3.0-or-later
// How many iterations networks take that are large or hardly rigid.
#include <initializer_list>

#include <granum/network/linear_response.hpp>

#include "large_networks.hpp"
#include "unit.hpp"

// The preset sanitize leaves out this test: it takes minutes there, on code that the others run as well.
TEST_CASE("large networks take few iterations, also where hardly rigid, with soft motions and lost pivots") {
  struct Row {
    int side;
    double kept;
    std::uint64_t seed;
    int iterations;
    std::size_t lost_at_least, lost_at_most;
  };
  constexpr std::size_t any = 1U << 31U;
  for (const Row& of : {Row{28, 0.35, 31, 34, 0, any}, // measured 31; 45 with rigid motions of aggregates
                        Row{24, 0.26, 31, 85, 1, any}, // measured 67; 140 with one level of fill
                        Row{29, 0.255, 31, 52, 0, 5},  // soft motions are as soft as they are
                        Row{29, 0.28, 31, 26, 0, 5},
                        // measured 66; 224 without the grains of soft motions first
                        Row{28, 0.23909, 5001, 73, 0, any}}) {
    CAPTURE(of.side);
    CAPTURE(of.kept);
    const network::Response response = network::linear_response(
        samples::large_network(of.side, of.kept, 1, of.seed), {.iteration_limit = 300});
    REQUIRE(response.converged());
    CHECK(response.report().grains >= (of.side > 24 && of.kept > 0.25 ? 20000 : 5000));
    CHECK(response.report().iterations <= of.iterations);
    CHECK(response.report().mended_pivots >= of.lost_at_least);
    CHECK(response.report().mended_pivots <= of.lost_at_most);
  }
}

TEST_CASE("networks that lose many pivots are solved") {
  // With a small stiffness for each at once, these lose ever more and are not solved in 500 iterations.
  for (const std::uint64_t seed : {2U, 35U, 48U, 54U}) {
    CAPTURE(seed);
    const network::Response response =
        network::linear_response(samples::large_network(14, 0.24, 1, seed), {.iteration_limit = 200});
    REQUIRE(response.converged());
    CHECK(response.report().mended_pivots > 0); // or nothing is tested
  }
}

// The preset sanitize leaves this one out as well: 27 s there, on code that the tests around it run.
TEST_CASE("a network is not called unstable where rounding makes an energy negative") {
  // The first factor comes to a negative energy after 108 iterations.
  packing::Assembly lattice = samples::large_network(28, 0.24727, 1, 7003);
  CHECK(network::linear_response(lattice, {.iteration_limit = 120}).report().status !=
        network::Status::not_positive_definite);
  for (packing::Contact& c : lattice.contacts)
    c.normal_force = 1e-18 * c.normal_stiffness * norm(c.branch);
  CHECK(network::linear_response(lattice, {.prestress = true, .iteration_limit = 120}).report().status !=
        network::Status::not_positive_definite);
}

TEST_CASE("where one factor loses too many pivots, another is tried") {
  struct Lattice {
    double kept;
    std::uint64_t seed;
  };
  for (const Lattice& of : {Lattice{0.2414, 1209}, Lattice{0.2355, 8001}}) {
    CAPTURE(of.seed);
    const packing::Assembly lattice = samples::large_network(14, of.kept, 1, of.seed);
    const network::Response response = network::linear_response(lattice, {.iteration_limit = 600});
    REQUIRE(response.converged());             // the first factor alone: not in 20,000 iterations
    CHECK(response.report().iterations > 150); // or nothing is tested
    const network::Response cut_short = network::linear_response(lattice, {.iteration_limit = 160});
    CHECK(cut_short.report().status == network::Status::iteration_limit);
    CHECK(cut_short.report().iterations == 160);
  }
}
