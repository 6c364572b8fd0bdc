// SPDX-License-Identifier: GPL-3.0-or-later
// Engineering constants by elimination in the 3 x 3 block of normal stresses.
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

#include "matrices.hpp"

namespace accuracy {

namespace {

/// Strains of a unit stress along one axis of the normal block, by Cramer's rule.
struct NormalBlock {
  Real C11, C12, C13, C33;

  [[nodiscard]] Real determinant() const { return (C11 - C12) * ((C11 + C12) * C33 - 2 * C13 * C13); }
  [[nodiscard]] Real S11() const { return (C11 * C33 - C13 * C13) / determinant(); }
  [[nodiscard]] Real S12() const { return -(C12 * C33 - C13 * C13) / determinant(); }
  [[nodiscard]] Real S13() const { return -(C11 - C12) * C13 / determinant(); }
  [[nodiscard]] Real S33() const { return (C11 * C11 - C12 * C12) / determinant(); }
};

void check_transversely_isotropic(Table& table, Draw& draw) {
  const auto c = draw_stiffness(draw);
  const NormalBlock block{c.C11, c.C12, c.C13, c.C33};
  const std::string domain = "C12, C13 from -0.3 to 0.5 C11";
  const std::string at = said({{"C11", c.C11}, {"C33", c.C33}, {"C12", c.C12}, {"C13", c.C13}});
  const Real one = 1;
  table.take("elastic: E_v", domain, closed_form, c.E_v(), 1 / block.S33(), at);
  table.take("elastic: E_h", domain, closed_form, c.E_h(), 1 / block.S11(), at);
  table.take_against("elastic: nu_vh, nu_hv, nu_hh", domain + ", of 1", closed_form, c.nu_vh(),
                     -block.S13() / block.S33(), one, at);
  table.take_against("elastic: nu_vh, nu_hv, nu_hh", domain + ", of 1", closed_form, c.nu_hv(),
                     -block.S13() / block.S11(), one, at);
  table.take_against("elastic: nu_vh, nu_hv, nu_hh", domain + ", of 1", closed_form, c.nu_hh(),
                     -block.S12() / block.S11(), one, at);
  const Real K = (2 * Real(c.C11) + c.C33 + 2 * Real(c.C12) + 4 * Real(c.C13)) / 9;
  table.take("elastic: bulk_modulus", domain, closed_form, c.bulk_modulus(), K, at);
}

void check_isotropic(Table& table, Draw& draw) {
  const double G = draw.log_uniform(1e-3, 1e12), nu = draw.poisson_ratio();
  const auto solid = granum::elastic::Isotropic::from_shear_and_poisson(G, nu);
  const std::string at = said({{"G", G}, {"nu", nu}});
  const std::string domain = "nu in [-0.999999, 0.5]";
  if (nu < 0.5)
    table.take("elastic: K from G and nu", domain, closed_form, solid.bulk_modulus(),
               2 * Real(G) * (1 + Real(nu)) / (3 * (1 - 2 * Real(nu))), at);
  const double K = draw.log_uniform(1e-3, 1e3) * G;
  const auto other = granum::elastic::Isotropic::from_bulk_and_shear(K, G);
  const Real k = K, g = G;
  const std::string pair = said({{"K", K}, {"G", G}});
  table.take("elastic: E from K and G", "K/G from 1e-3 to 1e3", closed_form, other.young_modulus(),
             9 * k * g / (3 * k + g), pair);
  table.take_against("elastic: nu from K and G", "K/G from 1e-3 to 1e3, of 1", closed_form,
                     other.poisson_ratio(), (3 * k - 2 * g) / (2 * (3 * k + g)), Real(1), pair);
}

} // namespace

void check_elastic(Table& table, std::size_t samples) {
  Draw draw(3);
  for (std::size_t k = 0; k < samples; ++k) {
    check_transversely_isotropic(table, draw);
    check_isotropic(table, draw);
  }
}

} // namespace accuracy
