// SPDX-License-Identifier: GPL-3.0-or-later
#include <contact_counts.hpp>

#include "packing/sample_packings.hpp"
#include "unit.hpp"

TEST_CASE("contact counts: grains that support each other are jammed, touching pairs are not") {
  packing::Assembly grains = samples::lattice(samples::simple_cubic, {});
  CHECK(relaxation::is_jammed(grains));
  grains.contacts.resize(1);
  CHECK_FALSE(relaxation::is_jammed(grains));
  grains.contacts.clear();
  CHECK_FALSE(relaxation::is_jammed(grains));
}
