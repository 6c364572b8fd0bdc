// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts that resist turning, and rigid bodies of several grains.
#include <granum/network/linear_response.hpp>

#include "dense_twin.hpp"
#include "packing/sample_packings.hpp"
#include "unit.hpp"

using elastic::Matrix6;

namespace {

constexpr double alike = 1e-9; // as in test_linear_response.cpp

/// Grains of many sizes, with springs of many stiffnesses against rolling and twisting.
packing::Assembly rolling_network(std::uint64_t seed, double kept, double tangential_ratio) {
  packing::Assembly a = samples::random_network(
      {.seed = seed, .repeats = 2, .kept = kept, .tangential_ratio = tangential_ratio});
  for (std::size_t g = 0; g < a.grain_count(); ++g)
    a.radius[g] *= 0.7 + 0.05 * static_cast<double>(g % 13);
  for (std::size_t k = 0; k < a.contacts.size(); ++k) {
    a.contacts[k].rolling_stiffness = 0.02 * static_cast<double>(1 + k % 7) * a.contacts[k].normal_stiffness;
    a.contacts[k].twisting_stiffness = 0.01 * static_cast<double>(k % 5) * a.contacts[k].normal_stiffness;
  }
  return a;
}

/// Each contact that does not reach out of a pair of grains joins them to a dimer, if both are free.
packing::Assembly dimers(packing::Assembly a, std::size_t every) {
  std::vector<std::uint32_t> partner(a.grain_count(), ~0U);
  for (std::size_t k = 0; k < a.contacts.size(); k += every) {
    const packing::Contact& c = a.contacts[k];
    if (partner[c.i] == ~0U && partner[c.j] == ~0U && c.i != c.j) {
      partner[c.i] = c.j;
      partner[c.j] = c.i;
    }
  }
  a.body.assign(a.grain_count(), 0);
  std::uint32_t bodies = 0;
  for (std::uint32_t g = 0; g < a.grain_count(); ++g)
    a.body[g] = partner[g] != ~0U && partner[g] < g ? a.body[partner[g]] : bodies++;
  return a;
}

void check_against_twin(const packing::Assembly& a) {
  const network::Response response = network::linear_response(a);
  const Matrix6 dense = twin::response(a, false).relaxed;
  const double scale = response.affine().matrix.cwiseAbs().maxCoeff();
  CHECK((response.relaxed().matrix - dense).cwiseAbs().maxCoeff() < alike * scale);
}

} // namespace

TEST_CASE("contacts that resist rolling and twisting answer as their dense twin") {
  for (const double ratio : {0.8, 0.0})
    for (const double kept : {1.0, 0.5, 0.3})
      for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        CAPTURE(kept);
        CAPTURE(seed);
        check_against_twin(rolling_network(seed, kept, ratio));
      }
}

TEST_CASE("resistance to turning stiffens, and adds nothing under uniform strain") {
  const packing::Assembly with = rolling_network(3, 0.5, 0.8);
  packing::Assembly without = with;
  for (packing::Contact& c : without.contacts)
    c.rolling_stiffness = c.twisting_stiffness = 0;
  const network::Response stiff = network::linear_response(with), soft = network::linear_response(without);
  CHECK(twin::distance(stiff.affine().matrix, soft.affine().matrix) < 1e-14);
  CHECK(twin::smallest_eigenvalue(stiff.relaxed().matrix - soft.relaxed().matrix) > 0);
}

TEST_CASE("grains of one body move as one, as in their dense twin") {
  for (const double kept : {1.0, 0.5})
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const packing::Assembly a =
          dimers(samples::random_network({.seed = seed, .repeats = 2, .kept = kept}), 3);
      const auto bodies = *std::max_element(a.body.begin(), a.body.end()) + 1;
      REQUIRE(bodies < a.grain_count());
      CHECK(network::linear_response(a).report().grains <= bodies);
      check_against_twin(a);
      check_against_twin(dimers(rolling_network(seed, kept, 0.8), 2));
    }
}

TEST_CASE("bodies of one grain each change nothing, and unsupported inputs of bodies are refused") {
  packing::Assembly a = samples::random_network({.seed = 4, .repeats = 2, .kept = 0.6});
  const Matrix6 grains = network::linear_response(a).relaxed().matrix;
  a.body.resize(a.grain_count());
  for (std::uint32_t g = 0; g < a.grain_count(); ++g)
    a.body[g] = static_cast<std::uint32_t>(a.grain_count()) - 1 - g;
  CHECK(twin::distance(network::linear_response(a).relaxed().matrix, grains) < 1e-9);
  CHECK_THROWS_AS(static_cast<void>(network::linear_response(a, {.prestress = true})), InvalidArgument);
  CHECK_THROWS_AS(static_cast<void>(network::linear_response(a, {.force_terms = true})), InvalidArgument);
  CHECK_THROWS_AS(
      static_cast<void>(network::linear_response(rolling_network(1, 1, 0.8), {.force_terms = true})),
      InvalidArgument);
  a.contacts[0].rolling_stiffness = -1;
  CHECK_THROWS_AS(static_cast<void>(network::linear_response(a)), InvalidArgument);
}
