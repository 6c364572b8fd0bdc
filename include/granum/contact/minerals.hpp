// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include <granum/contact/power_law.hpp>

/// Minerals of grains.
namespace granum::contact {

/// A solid that grains are often made of.
struct Mineral {
  const char* key;    ///< on a command line
  const char* name;   ///< for people
  const char* source; ///< entry of validation/references.bib
  GrainMaterial material;
  double density = 0; ///< [kg/m3]
  /// Standard deviation of G_g over G_g [1]: how far pieces of that name differ, a judgement.
  double modulus_spread = 0;
};

/// Quartz, feldspar, calcite, dolomite, glass and steel. Of minerals the averages over all directions of a
/// crystal.                                                        [Mavko2009; Makse2004; BudynasNisbett2011]
[[nodiscard]] std::span<const Mineral> minerals();
/// The one of that key.
/// \throws   InvalidArgument for an unknown key; the text lists the known ones
/// Checked by tests/contact/test_minerals.cpp
[[nodiscard]] const Mineral& mineral(std::string_view key);

/// K_s = 2 G_g (1 + nu_g)/(3 (1 - 2 nu_g)) of a grain's solid [Pa]; the largest number for nu_g = 0.5.
/// \throws   InvalidArgument if the material is out of range
/// Accuracy  4 ulp over 1 - 2 nu_g.  Checked by tests/contact/test_minerals.cpp
[[nodiscard]] double bulk_modulus(const GrainMaterial& grain);

} // namespace granum::contact
