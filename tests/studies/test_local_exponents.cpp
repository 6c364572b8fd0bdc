// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/local_exponents.hpp"

#include <granum/effective/relaxation.hpp>
#include <granum/effective/state.hpp>

#include "synthetic_study.hpp"
#include "unit.hpp"

using namespace granum::studies;

namespace {

/// Moduli whose exponent falls from one pressure to the next, with the closed forms' state.
SpecimenResult specimen_of(const Scene& scene, std::uint64_t seed, const std::vector<double>& exponents) {
  SpecimenResult specimen{contact::Shape::rough, triaxial::Density::dense, seed, {}, {}};
  double G = 1e8;
  for (std::size_t k = 0; k < scene.study.pressures.size(); ++k) {
    const double p = scene.study.pressures[k];
    if (k > 0)
      G *= std::pow(p / scene.study.pressures[k - 1], exponents[k - 1]);
    CompressedState state = test::power_law_state(0, p);
    test::set_network(state, G, G);
    state.G_closed = 1.3 * G;
    state.probes = k == 0 ? std::nullopt : std::optional(Probes{G, G, G, 1e-6});
    state.packing.state = effective::State{.law = law(scene, contact::Shape::rough),
                                           .tangential_ratio = 0.9,
                                           .radius = scene.grain.radius,
                                           .void_ratio = 0.6,
                                           .coordination_number = 5.5,
                                           .mechanical_coordination_number = 5.7,
                                           .stress_v = p,
                                           .stress_h = p};
    specimen.states.push_back(state);
  }
  return specimen;
}

} // namespace

TEST_CASE("local exponents: slopes between neighbouring pressures, averaged over the seeds") {
  Scene scene;
  scene.study.contacts = {contact::Shape::rough, contact::Shape::sphere};
  scene.study.densities = {triaxial::Density::dense};
  scene.study.pressures = {1e3, 1e4, 1e5};
  const std::vector<SpecimenResult> specimens{specimen_of(scene, 1, {0.8, 0.5}),
                                              specimen_of(scene, 2, {0.9, 0.4})};
  const std::vector<LocalExponents> rows = local_exponents(scene, specimens);
  REQUIRE(rows.size() == 2); // spheres have none
  CHECK(rows[0].pressure == relative(std::sqrt(1e7), 1e-14));
  CHECK(rows[0].network->value == relative(0.85, 1e-12));
  CHECK(rows[0].network->standard_error.value() == relative(0.05, 1e-9));
  CHECK(rows[0].uniform_strain.value == relative(0.85, 1e-12));
  CHECK_FALSE(rows[0].probe.has_value()); // the first pressure was not probed
  CHECK(rows[1].network->value == relative(0.45, 1e-12));
  CHECK(rows[1].probe->value == relative(0.45, 1e-12));
  CHECK(rows[1].contact_law < rows[0].contact_law);
  CHECK(rows[1].transition.value() ==
        relative(effective::transition_pressure(*specimens[0].states[1].packing.state).value(), 1e-12));
  // The table of states has the same rung 3, with the forces as they are.
  CompressedState uneven = specimens[0].states[1];
  uneven.packing.state->unevenness = effective::Unevenness{.value = 0.3};
  CHECK(relaxed_modulus(uneven).value() != relaxed_modulus(specimens[0].states[1]).value());
  CHECK(relaxed_modulus(uneven).value() == effective::relaxed(*uneven.packing.state, 5.7).stiffness.G_vh());
  uneven.packing.state.reset();
  CHECK_FALSE(relaxed_modulus(uneven).has_value());
  // Rung 3 asks its own state: at fixed contacts its s lies near b.
  CHECK(std::abs(rows[1].relaxed->value - rows[1].contact_law) < 0.1);
}
