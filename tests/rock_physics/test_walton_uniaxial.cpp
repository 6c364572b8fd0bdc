// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sphere_packs.hpp>

#include "effective/support.hpp"
#include "states.hpp"
#include "unit.hpp"

using namespace granum::test;
using rock_physics::UniaxialPacking;
using rock_physics::walton_uniaxial;
using rock_physics::walton_uniaxial_stress;

namespace {

/// Bulk modulus 36 and shear modulus 45 GPa.
constexpr UniaxialPacking example{.shear_modulus = 45e9,
                                  .poisson_ratio = (3 * 36.0 - 2 * 45) / (2 * (3 * 36.0 + 45)),
                                  .porosity = 0.38,
                                  .coordination_number = 8,
                                  .uniaxial_strain = 0.01};

} // namespace

TEST_CASE("walton uniaxial: a state summed over its contacts elsewhere") {
  const auto c = walton_uniaxial(example).stiffness;
  // Printed with 8 digits, C12 and C13 with 6.
  CHECK(c.C11 == relative(2.7878792e9, 1e-7));
  CHECK(c.C12 == relative(0.0142968e9, 1e-5));
  CHECK(c.C13 == relative(0.0285936e9, 1e-5));
  CHECK(c.C33 == relative(5.6043520e9, 1e-7));
  CHECK(c.C66() == relative(1.3867912e9, 1e-7));
  CHECK(c.C44 == relative(2.0873352e9, 1e-7));
  const auto stress = walton_uniaxial_stress(example);
  CHECK(stress.v == relative(37.362346e6, 1e-7));
  CHECK(stress.h == relative(0.190624e6, 1e-5));
  CHECK(walton_uniaxial(example).validity.ok());
}

TEST_CASE("walton uniaxial: is Norris-Johnson without hydrostatic strain, smooth to rough") {
  for (const double nu : {-0.99, 0.0, 0.2, 0.5})
    for (const double slip : {0.0, 0.5, 1.0}) {
      auto p = example;
      p.poisson_ratio = nu;
      p.no_slip_fraction = slip;
      const rock_physics::StrainedPacking general{
          p.shear_modulus, nu, p.porosity, p.coordination_number, 0, p.uniaxial_strain, slip};
      CHECK(difference(walton_uniaxial(p).stiffness, norris_johnson(general).stiffness) < 2e-15);
      const auto stress = walton_uniaxial_stress(p);
      for (const auto path :
           {rock_physics::StrainPath::hydrostatic_first, rock_physics::StrainPath::uniaxial_first,
            rock_physics::StrainPath::simultaneous}) {
        const auto same = norris_johnson_stress(general, path);
        CHECK(stress.v == relative(same.v, 2e-15));
        CHECK(std::abs(stress.h - same.h) < 2e-15 * same.v);
      }
      if (slip == 0)
        CHECK(stress.h == relative(stress.v / 4, 4e-16));
    }
}

TEST_CASE("walton uniaxial: limits and bad input") {
  for (const auto member : {&UniaxialPacking::uniaxial_strain, &UniaxialPacking::coordination_number}) {
    CHECK(walton_uniaxial(with(example, member, 0)).stiffness == elastic::TransverselyIsotropic{});
    CHECK(walton_uniaxial_stress(with(example, member, 0)).v == 0);
  }
  check_refused(example,
                {&UniaxialPacking::shear_modulus, &UniaxialPacking::poisson_ratio, &UniaxialPacking::porosity,
                 &UniaxialPacking::coordination_number, &UniaxialPacking::uniaxial_strain,
                 &UniaxialPacking::no_slip_fraction},
                [](const UniaxialPacking& p) {
                  CHECK_THROWS_AS((void)walton_uniaxial_stress(p), InvalidArgument);
                  return walton_uniaxial(p);
                });
}
