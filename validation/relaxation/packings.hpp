// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded states of validation/relaxation as the fits want them.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

namespace relaxation {

using granum::effective::State;
using granum::elastic::TransverselyIsotropic;

/// k_t/k_n of contacts that do not slip, of grains of Poisson's ratio 0.15, and all that networks are solved
/// with.
inline constexpr double no_slip_ratio = 0.918918918918919;
inline constexpr double solved_ratios[] = {0, 0.03, 0.1, 0.3, 0.6, no_slip_ratio, 1};

/// The elastic contacts of one packing at one k_t/k_n.
struct Network {
  double ratio = 0; ///< k_t/k_n
  TransverselyIsotropic stiffness;
};

/// One row of states.csv or of unequal.csv.
struct Packing {
  std::string sizes = "equal"; ///< of the grains, as sizes::parse_distribution reads it
  std::string contact = {};
  std::string preparation = {};
  std::string recipe = {};   ///< all three, however sheared; its packings differ less than recipes do
  std::string specimen = {}; ///< rows of one specimen are not independent of one another
  int seed = 0;
  double pressure = 0; ///< nominal [Pa]
  double stress_ratio = 0;
  double friction_coefficient = 0;
  State state; ///< k_t/k_n of the specimen
  double mechanical_coordination = 0;
  double rattler_fraction = 0;
  double affine_share = 0; ///< uniform strain with the network's own k_n over the closed form: <f^b>/<f>^b of
                           ///< equal grains; of unequal ones what long branches and the scatter of k_n do too
  double strain_bulk_modulus = 0; ///< K of the network under uniform strain [Pa]
  double relative_overlap = 0;    ///< of the mean force, over the diameter
  double unevenness = 0;          ///< Q of the forces: ln of that K over the one of the closed form
  std::vector<Network> networks = {};

  [[nodiscard]] double exponent() const { return state.law.constant_exponent().value(); }
  [[nodiscard]] bool isotropic() const { return stress_ratio == 0; }
};

inline double isotropic_shear_modulus(const TransverselyIsotropic& c) {
  return (2 * c.C44 + c.C66()) / 5 + (2 * c.C11 + c.C33 - c.C12 - 2 * c.C13) / 15;
}

/// A shape that the fits leave out altogether, to see how they do between the others.
inline constexpr const char* unfitted_contact = "alpha4";

/// A preparation without the path on which its specimens were sheared.
inline std::string unsheared(const std::string& preparation) {
  for (const char* path : {" txc", " txe"})
    if (preparation.ends_with(path))
      return preparation.substr(0, preparation.size() - 4);
  return preparation;
}

} // namespace relaxation
