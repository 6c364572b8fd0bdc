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
  packing::Assembly chain = samples::sphere_chain();
  CHECK(packing::fabric_tensor(chain) == Mat3{{{0.5, 0, 0}, {0, 0, 0}, {0, 0, 0.5}}});
  CHECK(contact_normals(chain) == std::vector<Vec3>{{1, 0, 0}, {0, 0, 1}});
  chain.contacts.clear();
  CHECK(contact_normals(chain).empty());
  CHECK_THROWS_AS(static_cast<void>(packing::fabric_tensor(chain)), InvalidArgument);
}
