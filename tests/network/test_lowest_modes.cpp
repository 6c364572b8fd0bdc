// SPDX-License-Identifier: GPL-3.0-or-later
// Modes beside their equation and a lattice; 300 grains beside numpy are in python/tests/test_networks.py.
#include <granum/network/lowest_modes.hpp>

#include <granum/network/stiffness_matrix.hpp>

#include "packing/sample_packings.hpp"
#include "unit.hpp"

namespace {

constexpr double density = 2650;

double mass_of(double radius) { return density * 4 / 3 * std::numbers::pi * radius * radius * radius; }

double energy(const network::GrainMotion& motion, double mass) {
  return mass * (dot(motion.displacement, motion.displacement) + 0.4 * dot(motion.turn, motion.turn));
}

} // namespace

// A simple cubic lattice of N grains on an edge without tangential springs is N^2 chains along each axis: the
// frequencies are sqrt(k/m) sin(pi n/N)/pi, those of n = 1 and N - 1 the same, for each chain and each axis.
TEST_CASE("modes of a cubic lattice are those of its chains, as often as they occur") {
  constexpr double k_n = 3e5, radius = 0.5e-3;
  const packing::Assembly a =
      samples::lattice(samples::simple_cubic, {.radius = radius, .normal_stiffness = k_n, .repeats = 4});
  const double mass = mass_of(radius);
  const std::vector<network::Mode> modes = network::lowest_modes(a, density, 100);
  REQUIRE(modes.size() == 100);
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const double part = k < 96 ? std::sqrt(0.5) : 1; // sin of pi/4 and of 3 pi/4; 48 chains
    CHECK(modes[k].frequency ==
          doctest::Approx(std::sqrt(k_n / mass) * part / std::numbers::pi).epsilon(1e-12));
    double sum = 0;
    for (const network::GrainMotion& motion : modes[k].motion)
      sum += energy(motion, mass);
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
  }
  CHECK(network::lowest_modes(a, density, 1000).size() == 144); // all but the 48 translations of chains
}

TEST_CASE("modes solve their equation and share nothing, and their participation is that of their energies") {
  const packing::Assembly a = samples::random_network({.seed = 9, .repeats = 4, .kept = 0.5});
  const std::vector<network::Mode> modes = network::lowest_modes(a, density, 8);
  REQUIRE(modes.size() == 8);
  const network::StiffnessMatrix h = network::stiffness_matrix(a);
  std::vector<Eigen::VectorXd> shapes;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    Eigen::VectorXd shape(h.matrix.rows()), inertia(h.matrix.rows());
    double sum = 0, squares = 0;
    for (std::size_t at = 0; at < h.grain.size(); ++at) {
      const auto first = static_cast<Eigen::Index>(6 * at);
      const network::GrainMotion& motion = modes[k].motion[h.grain[at]];
      const double mass = mass_of(a.radius[h.grain[at]]);
      for (int d = 0; d < 3; ++d) {
        shape[first + d] = motion.displacement[d];
        shape[first + 3 + d] = motion.turn[d];
        inertia[first + d] = mass * motion.displacement[d];
        inertia[first + 3 + d] = 2 * mass / 5 * motion.turn[d];
      }
      sum += energy(motion, mass);
      squares += std::pow(energy(motion, mass), 2);
    }
    const double eigenvalue = std::pow(2 * std::numbers::pi * modes[k].frequency, 2);
    CHECK((h.matrix * shape - eigenvalue * inertia).norm() < 1e-5 * eigenvalue * inertia.norm());
    CHECK(modes[k].participation_ratio ==
          doctest::Approx(sum * sum / (squares * static_cast<double>(h.grain.size()))).epsilon(1e-12));
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
    for (const Eigen::VectorXd& earlier : shapes)
      CHECK(std::abs(earlier.dot(inertia)) < 1e-7);
    shapes.push_back(shape);
    CHECK((k == 0 || modes[k - 1].frequency <= modes[k].frequency));
  }
  CHECK_THROWS_AS(static_cast<void>(network::lowest_modes(a, 0, 8)), InvalidArgument);
  CHECK_THROWS_AS(static_cast<void>(network::lowest_modes(a, density, 0)), InvalidArgument);
  CHECK_THROWS_AS(
      static_cast<void>(network::lowest_modes(a, density, 8, {.stop_requested = [] { return true; }})),
      Stopped);
  packing::Assembly other = a;
  other.contacts.clear();
  CHECK(network::lowest_modes(other, density, 3).empty());
  other = a;
  for (std::uint32_t g = 0; g < a.grain_count(); ++g)
    other.body.push_back(g == 0 ? 0 : g - 1);
  CHECK_THROWS_AS(static_cast<void>(network::lowest_modes(other, density, 1)), InvalidArgument);
}

TEST_CASE(
    "a grain that hardly anything holds is left out, and the wanted number of modes is found beside it") {
  packing::Assembly held = samples::random_network({.seed = 10, .repeats = 3}), gone = held;
  for (packing::Contact& c : held.contacts)
    if (c.i == 0 || c.j == 0)
      c.normal_stiffness *= 1e-7, c.tangential_stiffness *= 1e-7;
  std::erase_if(gone.contacts, [](const packing::Contact& c) { return c.i == 0 || c.j == 0; });
  const std::vector<network::Mode> beside = network::lowest_modes(held, density, 8),
                                   without = network::lowest_modes(gone, density, 8);
  REQUIRE(beside.size() == 8);
  for (std::size_t k = 0; k < 8; ++k)
    CHECK(beside[k].frequency == doctest::Approx(without[k].frequency).epsilon(1e-5));
}
