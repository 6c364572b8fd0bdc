// SPDX-License-Identifier: GPL-3.0-or-later
#include "probes.hpp"

#include <granum/contact/grains.hpp>

namespace granum::studies {

analysis::Given known_of(const dem::Specimen& state, const dem::Material& material) {
  analysis::Given given{.law = material.law,
                        .tangential_ratio = material.tangential_ratio,
                        .void_ratio = dem::void_ratio(state)};
  if (!state.size.empty()) {
    given.law.reset();
    given.law_family = [law = material.law, unit = state.radius](const contact::GrainMaterial& grain,
                                                                 double radius) {
      return contact::of_sizes(law.of_grain(grain), radius / unit, radius / unit);
    };
    given.grain_shear_modulus = material.law.grain().shear_modulus;
    given.grain_poisson_ratio = material.law.grain().poisson_ratio;
  }
  return given;
}

Probes run_probes(const dem::Specimen& state, const dem::Material& material,
                  const triaxial::ProbeOptions& options) {
  const auto [hh, hv, vh] = triaxial::probe_all(state, material, options);
  return {.G_hh = hh.shear_modulus(),
          .G_hv = hv.shear_modulus(),
          .G_vh = vh.shear_modulus(),
          .amplitude = hh.amplitude};
}

} // namespace granum::studies
