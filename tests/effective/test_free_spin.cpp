// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/uniform_field.hpp>

#include <granum/network/linear_response.hpp>

#include "packing/sample_packings.hpp"
#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::UniformContacts;

namespace {

/// Energy of a unit shear 2 e13 = 1 of contacts in the given directions, all grains spinning by w about
/// axis 2: the displacement of a contact is (e - w x) n.
double shear_energy(const std::vector<Direction>& directions, double w) {
  double energy = 0;
  for (const Direction& d : directions) {
    const Eigen::Vector3d u{(0.5 - w) * d.normal.z(), 0, (0.5 + w) * d.normal.x()};
    const double normal = u.dot(d.normal);
    energy += d.share * (d.k_n * normal * normal + d.k_t * (u.squaredNorm() - normal * normal));
  }
  return energy;
}

/// The least energy over the spin, found on the parabola through three of its values.
double least_shear_energy(const std::vector<Direction>& directions) {
  const double low = shear_energy(directions, -1), middle = shear_energy(directions, 0),
               high = shear_energy(directions, 1);
  const double slope = (high - low) / 2, curvature = high + low - 2 * middle;
  // Without k_t a spin costs nothing.
  const double best = shear_energy(directions, curvature > 1e-12 * middle ? -slope / curvature : 0);
  for (const double w : {-0.4, -0.1, 0.05, 0.3}) // it is the least
    CHECK(best <= shear_energy(directions, w) * (1 + 1e-14));
  return best;
}

} // namespace

TEST_CASE("free spin: the least energy over the spin, by sums over directions") {
  for (const double alpha : {1.0, 1.7, 2.0, infinity})
    for (const double a : {-1.0, -0.3, 0.0, 0.6, 1.0})
      for (const double ratio : {0.2, 1.0, 3.0})
        for (const double r : {0.0, 0.5, 0.919, 2.0}) {
          State s = state_of(alpha, a, 0.15, ratio * 1e5, 1e5);
          s.tangential_ratio = r;
          const auto directions = directions_of(s, 100);
          const double P = contact_density(s);
          const auto stiffness = effective::free_spin(s).stiffness;
          const auto fixed = effective::uniform_strain(s).stiffness;
          CHECK(close(stiffness.C44, P * least_shear_energy(directions), 1e-12));
          CHECK(close(fixed.C44, P * shear_energy(directions, 0), 1e-12));
          CHECK(stiffness.C44 <= fixed.C44);
          elastic::TransverselyIsotropic same = fixed;
          same.C44 = stiffness.C44;
          CHECK(stiffness == same);
        }
}

TEST_CASE("free spin: closed form in the fabric") {
  const double P = 2.5, k_n = 3;
  for (const double a : {-1.0, -0.4, 0.0, 0.3, 1.0})
    for (const double r : {0.0, 0.4, 1.0, 2.0}) {
      const UniformContacts c{
          .prefactor = P, .normal_stiffness = k_n, .tangential_stiffness = r * k_n, .fabric_anisotropy = a};
      const double F11 = (5 - 3 * a) / (5 * (3 - a)), F33 = (5 + a) / (5 * (3 - a));
      const double n1133 = (7 - a) / (35 * (3 - a));
      const double expected = P * k_n * ((1 - r) * n1133 + r * F11 * F33 / (F11 + F33));
      CHECK(close(effective::free_spin_stiffness(c).C44, expected, 1e-14));
      const double above = effective::uniform_strain_stiffness(c).C44 - effective::free_spin_stiffness(c).C44;
      // Arithmetic less harmonic mean: (A_1 - A_3)^2/(4 (A_1 + A_3)), nothing where they are equal.
      const double gap = P * r * k_n * (F11 - F33) * (F11 - F33) / (4 * (F11 + F33));
      CHECK(std::abs(above - gap) < 1e-15 * P * k_n);
    }
}

TEST_CASE("free spin: networks are not above it, and equal to it with one grain in a cell") {
  // Lattices whose steep contacts are of another stiffness. In the simple cubic one a strain moves no grain
  // out of its place, but the grains spin; in the hexagonal one they move as well.
  const double R = 0.5e-3, k_n = 1.3e6, k_t = 0.9e6;
  for (const auto* kind : {&samples::simple_cubic, &samples::hexagonal})
    for (const double factor : {0.2, 1.0, 5.0}) {
      CAPTURE(factor);
      packing::Assembly lattice =
          samples::lattice(*kind, {.radius = R, .normal_stiffness = k_n, .tangential_stiffness = k_t});
      std::vector<Direction> directions;
      double sum = 0;
      for (packing::Contact& c : lattice.contacts) {
        const Eigen::Vector3d branch(c.branch[0], c.branch[1], c.branch[2]);
        const Eigen::Vector3d n = branch.normalized();
        const double stiffer = std::abs(n.z()) > 0.7 ? factor : 1;
        c.normal_stiffness *= stiffer;
        c.tangential_stiffness *= stiffer;
        sum += branch.squaredNorm();
        directions.push_back(
            {n, 1 / double(lattice.contacts.size()), c.normal_stiffness, c.tangential_stiffness});
      }
      const auto response = network::linear_response(lattice);
      const double bound = sum / lattice.volume() * least_shear_energy(directions);
      const double relaxed = response.relaxed().matrix(4, 4);
      CHECK(relaxed <= bound * (1 + 1e-12));
      if (factor != 1)
        CHECK(bound < response.affine().matrix(4, 4) * (1 - 1e-3));
      if (kind == &samples::simple_cubic)
        CHECK(close(relaxed, k_t * factor / (2 * R * (1 + factor)), 1e-12));
    }
}
