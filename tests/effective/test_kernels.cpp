// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/state.hpp>

#include "support.hpp"
#include "unit.hpp"

using namespace granum::effective;

TEST_CASE("b of a state is that of its law at the mean force") {
  for (const double alpha : {1.0, 1.5, 2.0, test::infinity}) {
    State s = test::state_of(alpha, 0.2, 0.15, 1.8e5, 1e5);
    CHECK(contact_exponent(s) == s.law.exponent_at_force(mean_contact_force(s)));
    CHECK(std::abs(contact_exponent(s) - 1 / (1 + alpha)) < 1e-15);
    s.coordination_number = 0;
    CHECK(contact_exponent(s) == s.law.exponent_at_force(0));
    s.void_ratio = -1;
    CHECK_THROWS_AS((void)contact_exponent(s), InvalidArgument);
  }
}
