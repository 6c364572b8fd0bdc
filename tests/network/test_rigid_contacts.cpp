// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts far stiffer or softer than the others: the response is that of rigid ones, or it did not converge.
#include <granum/network/linear_response.hpp>

#include <functional>

#include "large_networks.hpp"
#include "unit.hpp"

using elastic::Matrix6;

namespace {

/// Multiplies the stiffnesses of the contacts that are chosen.
packing::Assembly stiffened(packing::Assembly a, double factor,
                            const std::function<bool(std::size_t)>& chosen) {
  for (std::size_t k = 0; k < a.contacts.size(); ++k)
    if (chosen(k)) {
      a.contacts[k].normal_stiffness *= factor;
      a.contacts[k].tangential_stiffness *= factor;
    }
  return a;
}

Matrix6 relaxed(const packing::Assembly& a) { return network::linear_response(a).relaxed().matrix; }

/// Largest difference of C_ab, over sqrt(C_aa C_bb).
double apart(const Matrix6& c, const Matrix6& exact) {
  double largest = 0;
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b < 6; ++b)
      largest = std::max(largest, std::abs(c(a, b) - exact(a, b)) / std::sqrt(exact(a, a) * exact(b, b)));
  return largest;
}

} // namespace

TEST_CASE("a contact of any stiffness above that of the others is as good as rigid") {
  for (const double kept : {1.0, 0.6})
    for (const double tangential : {1.0, 0.0}) {
      const packing::Assembly ordinary = samples::large_network(6, kept, tangential);
      for (const std::size_t every : {std::size_t{10000}, std::size_t{50}, std::size_t{10}}) {
        const auto chosen = [every](std::size_t k) { return k % every == 7; };
        const auto of = [&](double factor) { return stiffened(ordinary, factor, chosen); };
        // 1/factor is what is missing to rigid contacts: two factors extrapolate to its square
        const Matrix6 softer = relaxed(of(1e4)), stiff = relaxed(of(1e5)),
                      rigid = stiff + (stiff - softer) / 9;
        CAPTURE(kept);
        CAPTURE(tangential);
        CAPTURE(every);
        CHECK(apart(relaxed(ordinary), rigid) > 1e-3);
        for (const double factor : {1e6, 1e7, 1e8, 1e10, 1e12, 1e14, 1e20}) {
          CAPTURE(factor);
          const network::Response response = network::linear_response(of(factor));
          REQUIRE(response.converged());
          CHECK(apart(response.relaxed().matrix, rigid) < 2e-5);
          const Matrix6 affine = network::affine_all(of(factor)).matrix;
          CHECK((response.affine().matrix - affine).cwiseAbs().maxCoeff() < 1e-9 * affine.maxCoeff());
        }
      }
    }
}

TEST_CASE("stiff contacts that bear the load alone, and soft ones that do, are right or refused") {
  const int side = 6;
  const packing::Assembly ordinary = samples::large_network(side, 1);
  const auto row = [&](std::size_t k) { return std::abs(normal(ordinary.contacts[k]).x) > 0.9; };
  const auto cut = [&](std::size_t k) { // between two layers of grains
    const auto layer = [&](std::uint32_t g) { return g / (side * side); };
    const auto i = layer(ordinary.contacts[k].i), j = layer(ordinary.contacts[k].j);
    return i + j == 1 || i + j == side; // 0 and 1, and the middle two
  };
  for (const double factor : {1e3, 1e5}) {
    CHECK(network::linear_response(stiffened(ordinary, factor, row)).converged());
    CHECK(network::linear_response(stiffened(ordinary, 1 / factor, cut)).converged());
  }
  const double of_cut = relaxed(stiffened(ordinary, 1e-5, cut))(0, 0) * 1e5;
  for (const double factor : {1e8, 1e10, 1e12, 1e15}) {
    CAPTURE(factor);
    CHECK_FALSE(network::linear_response(stiffened(ordinary, factor, row)).converged());
    const network::Response soft = network::linear_response(stiffened(ordinary, 1 / factor, cut));
    if (soft.converged())
      CHECK(soft.relaxed().matrix(0, 0) * factor == doctest::Approx(of_cut).epsilon(1e-4));
  }
}
