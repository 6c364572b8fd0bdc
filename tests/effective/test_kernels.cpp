// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas for laws whose b changes with the force, at laws whose b does not: there closed forms say
// the same.
#include "effective/kernels.hpp"

#include "effective/stress_derivatives.hpp"
#include "support.hpp"
#include "unit.hpp"

using namespace granum::effective;
using kernel::AxialMoments;

namespace {

using kernel::Dual;

double mean_load(const kernel::CheckedState& checked) {
  return std::sqrt(checked.loads.horizontal * checked.loads.vertical);
}

} // namespace

TEST_CASE("moments of the stiffness over the directions are those of the power of the force") {
  for (const double alpha : {1.0, 1.5, 2.0, test::infinity})
    for (const double ratio : {0.3, 1.8, 40.0})
      for (const double sign : {1.0, -1.0}) {
        CAPTURE(alpha);
        CAPTURE(ratio);
        CAPTURE(sign);
        const State s = test::state_of(alpha, 0.2, 0.15, ratio * 1e5, 1e5);
        const kernel::CheckedState checked = kernel::checked(s);
        const double root = std::sqrt(checked.loads.horizontal / checked.loads.vertical);
        const double b = s.law.constant_exponent().value();
        const auto moments = [&](const auto& weight) {
          return kernel::direction_moments(s.fabric_anisotropy, root, 1 / root, root, weight,
                                           kernel::rule_for(root * root));
        };
        const AxialMoments<double> closed = moments([&](double f) { return std::pow(f, sign * b); });
        const AxialMoments<double> by_law = moments(
            kernel::StiffnessRatio<double>{.law = s.law,
                                           .reference = checked.geometry.force_area * mean_load(checked),
                                           .stiffness = checked.stiffness,
                                           .inverse = sign < 0});
        CHECK(by_law.s4 == relative(closed.s4, 1e-13));
        CHECK(by_law.s2c2 == relative(closed.s2c2, 1e-13));
        CHECK(by_law.c4 == relative(closed.c4, 1e-13));
      }
}

TEST_CASE("so are their derivatives by the stresses") {
  for (const double alpha : {1.0, 1.5, 2.0})
    for (const bool inverse : {false, true}) {
      CAPTURE(alpha);
      CAPTURE(inverse);
      const State s = test::state_of(alpha, 0.2, 0.15, 1.8e5, 1e5);
      const double b = s.law.constant_exponent().value();
      const Dual v(s.stress_v, s.stress_v * Eigen::Vector2d::UnitX());
      const Dual h(s.stress_h, s.stress_h * Eigen::Vector2d::UnitY());
      const kernel::NormalLoads<Dual> loads = kernel::static_loads(Dual(s.fabric_anisotropy), v, h);
      const Dual root = sqrt(Dual(loads.horizontal / loads.vertical)), load = root * loads.vertical;
      const Dual reference = kernel::geometry(s).force_area * load;
      const double c2 = root.value();
      const auto moments = [&](const auto& weight) {
        return kernel::direction_moments(Dual(s.fabric_anisotropy), root, Dual(1 / root), c2, weight,
                                         kernel::rule_for(c2 * c2));
      };
      const auto closed = moments([&](const Dual& f) { return kernel::power(f, inverse ? -b : b); });
      const auto by_law =
          moments(kernel::StiffnessRatio<Dual>{.law = s.law,
                                               .reference = reference,
                                               .stiffness = kernel::stiffness_at(s.law, reference),
                                               .inverse = inverse});
      for (const auto member :
           {&AxialMoments<Dual>::s4, &AxialMoments<Dual>::s2c2, &AxialMoments<Dual>::c4}) {
        CHECK((by_law.*member).value() == relative((closed.*member).value(), 1e-13));
        for (const int seed : {0, 1})
          CHECK(std::abs((by_law.*member).derivatives()[seed] - (closed.*member).derivatives()[seed]) <
                1e-13);
      }
    }
}

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
