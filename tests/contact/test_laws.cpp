// SPDX-License-Identifier: GPL-3.0-or-later
// Every test runs over the table of laws, so that a new row is tested by being there.
#include <granum/contact/laws.hpp>

#include <set>

#include <granum/contact/grains.hpp>
#include <granum/core/numerics.hpp>

#include "unit.hpp"

using namespace granum::contact;

namespace {

constexpr GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
constexpr double radius = 0.5e-3;
/// From loose contacts at 1 kPa to chains at 10 MPa [N].
constexpr double forces[] = {1e-4, 1e-3, 1e-2, 0.1, 1, 10};

NormalLaw law_of_row(const LawRow& row) { return law_of(row.shape, grain, radius); }

template <class Test>
void each_law(const Test& test) {
  for (const LawRow& row : laws()) {
    CAPTURE(name(row.shape));
    test(row, law_of_row(row));
  }
}

/// Integral of g over [0, x], of a g that goes as a power or an exponential below x.
template <class Function>
double integral(Function g, double x) {
  static const std::vector<QuadratureNode> rule = gauss_legendre(256);
  double sum = 0;
  for (const auto& [t, w] : rule) {
    const double u = (1 + t) / 2; // at u^4 x: smooth there
    sum += w / 2 * g(x * u * u * u * u) * 4 * u * u * u * x;
  }
  return sum;
}

} // namespace

TEST_CASE("laws: force and overlap are inverses of each other, and no force has no overlap") {
  each_law([](const LawRow&, const NormalLaw& law) {
    CHECK(law.force(0) == 0);
    CHECK(law.overlap(0) == 0);
    for (const double f : forces) {
      CHECK(law.force(law.overlap(f)) == relative(f, 1e-12));
      CHECK(law.overlap(f) > law.overlap(0.9 * f));
    }
  });
}

TEST_CASE("laws: k_n is the derivative of the force, at an overlap and at a force") {
  each_law([](const LawRow&, const NormalLaw& law) {
    for (const double f : forces) {
      CAPTURE(f);
      const double d = law.overlap(f), h = 1e-4 * d;
      CHECK(law.stiffness_at_overlap(d) == relative((law.force(d - 2 * h) - 8 * law.force(d - h) +
                                                     8 * law.force(d + h) - law.force(d + 2 * h)) /
                                                        (12 * h),
                                                    1e-9));
      CHECK(law.stiffness_at_force(f) == relative(law.stiffness_at_overlap(d), 1e-11));
    }
  });
}

TEST_CASE("laws: b is d ln k_n/d ln f, and constant where stated") {
  each_law([](const LawRow&, const NormalLaw& law) {
    const auto log_stiffness = [&](double f) { return std::log(law.stiffness_at_force(f)); };
    double least = 1, most = 0;
    for (const double f : forces) {
      CAPTURE(f);
      const double h = 1e-3, b = law.exponent_at_force(f);
      const double near = (log_stiffness(f * std::exp(h)) - log_stiffness(f * std::exp(-h))) / (2 * h);
      CHECK(std::abs(b - near) < 1e-6);
      CHECK(b >= 0);
      CHECK(b <= 1);
      least = std::min(least, b);
      most = std::max(most, b);
    }
    CHECK(law.constant_exponent().has_value() == (least == most));
    if (law.constant_exponent())
      CHECK(*law.constant_exponent() == most);
  });
}

TEST_CASE("laws: what the surfaces mean for a packing") {
  each_law([](const LawRow&, const NormalLaw& law) {
    const Surface surface = law.surface();
    const bool one_exponent = law.constant_exponent().has_value();
    if (one_exponent) {
      CHECK(surface.stiffening == Stiffening::power_law);
      CHECK(surface.begins_at_touch);
    }
    CHECK(surface.transition_force.value_or(0) >= 0);
    CHECK((law.closing_law() == law) == surface.begins_at_touch);
    CHECK(law.closing_law().surface().begins_at_touch);
    // A first contact that would pass unnoticed in a time step of loaded ones is resolved.
    const double f = surface.transition_force.value_or(1), first = law.stiffness_at_force(f / 1024);
    CHECK(law.first_stiffness() == (surface.begins_at_touch ? 0 : first));
  });
  const Surface rough = law_of(Shape::rough, grain, radius).surface();
  CHECK(rough.stiffening == Stiffening::rough);
  CHECK(!rough.begins_at_touch);
  const NormalLaw smooth = RoughSphere(grain, radius, 0); // the smooth sphere, to the bit
  CHECK(smooth.surface().begins_at_touch);
  CHECK(smooth.surface().stiffening == Stiffening::power_law);
  CHECK(smooth.first_stiffness() == 0);
}

TEST_CASE("laws: energy is the integral of the force") {
  each_law([](const LawRow&, const NormalLaw& law) {
    for (const double f : forces) {
      const double d = law.overlap(f);
      CHECK(law.energy(d) == relative(integral([&](double x) { return law.force(x); }, d), 1e-8));
    }
  });
}

TEST_CASE(
    "laws: the kernel for sweeps has the law's force and stiffness, alone and for pairs of other sizes") {
  each_law([](const LawRow&, const NormalLaw& law) {
    for (const auto& [i, j] : {std::pair(1.0, 1.0), {0.5, 2.0}, {3.0, 0.7}})
      for (const double f : forces) {
        const NormalLaw of_pair = of_sizes(law, i, j);
        const double d = of_pair.overlap(f);
        const NormalResponse response = std::visit(
            [d, a = i, b = j](const auto& kernel) { return of_sizes(kernel, a, b)(d); }, law.kernel());
        CHECK(response.force == relative(f, 1e-8));
        CHECK(response.stiffness == relative(of_pair.stiffness_at_overlap(d), 1e-6));
      }
  });
}

TEST_CASE("laws: other grains, other sizes, and whether a size matters") {
  each_law([](const LawRow& row, const NormalLaw& law) {
    const double d = law.overlap(0.1);
    CHECK(law.grain() == grain);
    CHECK(law.depends_on_size() == row.depends_on_size);
    CHECK(law.of(grain, radius) == law);
    CHECK(law.of_grain(grain) == law);
    CHECK(law.of_pair_radius(1) == law);
    CHECK(law.of_pair_radius(2).force(d) == relative(law.of(grain, 2 * radius).force(d), 1e-13));
    CHECK((law.of_pair_radius(2) == law) != law.depends_on_size());
    const NormalLaw stiffer = law.of_grain({.shear_modulus = 60e9, .poisson_ratio = 0.15});
    CHECK(stiffer.force(d) > law.force(d));
    CHECK(stiffer != law);
    CHECK(stiffer == law_of(row.shape, {.shear_modulus = 60e9, .poisson_ratio = 0.15}, radius));
    CHECK(stiffer.numbers() != law.numbers());
    CHECK(NormalLaw::of_numbers(law.kind(), law.grain(), law.numbers()) == law);
    CHECK_THROWS_AS((void)NormalLaw::of_numbers(law.kind(), law.grain(), {}), InvalidArgument);
    CHECK_THROWS_AS((void)NormalLaw::of_numbers(std::variant_size_v<AnyLaw>, grain, law.numbers()),
                    InvalidArgument);
    CHECK(stiffer.text() != law.text());
    CHECK_FALSE(law.text().empty());
  });
}

TEST_CASE("laws: impossible values are refused") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  each_law([](const LawRow& row, const NormalLaw& law) {
    for (const double wrong : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
      CHECK_THROWS_AS((void)law.force(wrong), InvalidArgument);
      CHECK_THROWS_AS((void)law.overlap(wrong), InvalidArgument);
      CHECK_THROWS_AS((void)law.stiffness_at_overlap(wrong), InvalidArgument);
      CHECK_THROWS_AS((void)law.stiffness_at_force(wrong), InvalidArgument);
      CHECK_THROWS_AS((void)law.energy(wrong), InvalidArgument);
      CHECK_THROWS_AS((void)law.of_pair_radius(wrong), InvalidArgument);
      for (const LawParameter& parameter : row.parameters)
        CHECK_THROWS_AS((void)law_of(row.shape, grain, radius, {{parameter.key, wrong}}), InvalidArgument);
      if (row.depends_on_size)
        CHECK_THROWS_AS((void)law_of(row.shape, grain, wrong), InvalidArgument);
      else
        CHECK(law_of(row.shape, grain, wrong) == law); // it reads its own numbers alone
    }
    CHECK_THROWS_AS((void)law_of(row.shape, {.shear_modulus = -1, .poisson_ratio = 0.1}, radius),
                    InvalidArgument);
    for (const LawParameter& parameter : row.parameters)
      if (const double r = 0.9 * parameter.value; parameter.within_grain)
        CHECK_THROWS_AS((void)law_of(row.shape, grain, r), InvalidArgument);
      else
        CHECK_NOTHROW((void)law_of(row.shape, grain, r));
  });
  CHECK_THROWS_AS((void)law_of(Shape::cone, grain, radius, {{"slope", 0.3}}), InvalidArgument);
}

TEST_CASE("the table of laws: names and keys are unique, and its values lie in their ranges") {
  std::set<std::string> shapes, keys, plurals;
  for (const LawRow& row : laws()) {
    CAPTURE(name(row.shape));
    CHECK(shapes.insert(std::string(name(row.shape))).second);
    CHECK(plurals.insert(row.plural).second);
    CHECK(find_shape(name(row.shape)) == row.shape);
    CHECK(&row_of(row.shape) == &row);
    CHECK(shape_names().find(name(row.shape)) != std::string::npos);
    for (const LawParameter& parameter : row.parameters) {
      CHECK(keys.insert(parameter.key).second);
      if (parameter.key == "cone_slope" || parameter.key == "profile_constant") // as near to a plane as
        CHECK(parameter.low * parameter.high == relative(1, 1e-12));            // to a needle
      if (parameter.dimension == Dimension::length)
        CHECK(parameter.high == (parameter.key == "roughness" ? 10e-6 : 1000));
      CHECK(parameter.low <= parameter.value);
      CHECK(parameter.value <= parameter.high);
      CHECK(value_of(parameter, {}) == parameter.value);
      CHECK(value_of(parameter, {{parameter.key, 7}}) == 7);
    }
    CHECK(row.parameters.size() <= 2); // the page has room for two (web/src/exports.hpp)
  }
  for (const char* text : {"", "Cone", "cone ", "power_law", "cube", "con"})
    CHECK_FALSE(find_shape(text).has_value());
}

TEST_CASE("each shape of the paper has the law of its profile and parameters") {
  CHECK(law_of(Shape::cone, grain, radius, {{"cone_slope", 0.3}}) == NormalLaw(PowerLaw::cone(grain, 0.3)));
  CHECK(law_of(Shape::sphere, grain, 0.4e-3) == NormalLaw(PowerLaw::sphere(grain, 0.4e-3)));
  CHECK(law_of(Shape::flat, grain, radius, {{"punch_radius", 6e-6}}) ==
        NormalLaw(PowerLaw::flat(grain, 6e-6)));
  CHECK(law_of(Shape::power_law, grain, radius, {{"alpha", 3}, {"profile_constant", 5e6}}) ==
        NormalLaw(PowerLaw::general(grain, 3, 5e6)));
}
