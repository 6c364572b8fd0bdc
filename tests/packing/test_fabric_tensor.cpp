// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/coordination.hpp>

#include "sample_packings.hpp"
#include "sphere_chain.hpp"
#include "unit.hpp"

TEST_CASE("cubic lattices are isotropic, the chain is not") {
  const Mat3 cubic = packing::fabric_tensor(samples::lattice(samples::face_centred, {}));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(std::abs(cubic(i, j) - (i == j ? 1.0 / 3 : 0)) < 1e-14);
  const Mat3 chain = packing::fabric_tensor(samples::sphere_chain());
  CHECK(chain == Mat3{{{0.5, 0, 0}, {0, 0, 0}, {0, 0, 0.5}}});
}

TEST_CASE("normals are unit vectors from i to j in the order of the contacts") {
  const auto normals = contact_normals(samples::sphere_chain());
  REQUIRE(normals.size() == 2);
  CHECK(normals[0] == Vec3{1, 0, 0});
  CHECK(normals[1] == Vec3{0, 0, 1});
  const Mat3 f = packing::fabric_tensor(samples::random_network({.seed = 3}));
  CHECK(trace(f) == doctest::Approx(1).epsilon(1e-13));
}

TEST_CASE("without contacts there is no fabric") {
  packing::Assembly a = samples::sphere_chain();
  a.contacts.clear();
  CHECK(contact_normals(a).empty());
  CHECK_THROWS_AS(static_cast<void>(packing::fabric_tensor(a)), InvalidArgument);
}
