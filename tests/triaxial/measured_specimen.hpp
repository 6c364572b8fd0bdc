// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/analysis/measure.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

#include "dem/lattice_state.hpp"
#include "unit.hpp"

namespace granum::test {

/// A specimen as it stands, measured.
inline analysis::Measurement measured(const dem::Specimen& state, const dem::Material& material,
                                      const analysis::Wanted& wanted = {}) {
  return analysis::measure(dem::contact_network(state, material),
                           {.law = material.law, .tangential_ratio = material.tangential_ratio}, wanted);
}

/// The network of the specimen frozen in place.
inline analysis::Network frozen_network(const dem::Specimen& state, const dem::Material& material) {
  const triaxial::FrozenState frozen = triaxial::freeze_in_place(state, material);
  return measured(frozen.state(), material, {.network = network::ResponseOptions{}}).solved_network();
}

/// Dense or loose, at rest under the last of the pressures.
inline dem::Specimen compressed(const triaxial::SpecimenRecipe& recipe, triaxial::Density density,
                                const std::vector<double>& pressures) {
  dem::Specimen state = start_of_compression(frictionless_specimen(recipe).state, density, recipe);
  const auto keep = [&](const triaxial::Snapshot& snapshot) {
    state = snapshot.state;
    return true;
  };
  REQUIRE(triaxial::isotropic_path(state, recipe.material, pressures, triaxial::compression_options(), keep));
  return state;
}

/// Of specimens between walls.
constexpr double pressure = 100e3;
inline const dem::Material material = quartz(radius, 0.4986);

} // namespace granum::test
