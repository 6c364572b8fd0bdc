// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/network/linear_response.hpp>

#include "dense_twin.hpp"
#include "packing/sample_packings.hpp"
#include "unit.hpp"

using elastic::Matrix6;

namespace {

Matrix6 cubic(double c11, double c12, double c44) {
  Matrix6 c = Matrix6::Zero();
  c.topLeftCorner<3, 3>().setConstant(c12);
  for (int k = 0; k < 3; ++k) {
    c(k, k) = c11;
    c(k + 3, k + 3) = c44;
  }
  return c;
}

constexpr double kn = 1.3e6, kt = 0.9e6, radius = 0.5e-3;
const samples::LatticeState state{.radius = radius, .normal_stiffness = kn, .tangential_stiffness = kt};

void check_exact(const samples::Lattice& kind, const Matrix6& closed_form) {
  const packing::Assembly a = samples::lattice(kind, state);
  const auto response = network::linear_response(a);
  // The forces on every grain cancel: nothing is left but rounding.
  CHECK(twin::distance(twin::contact_sum(a), closed_form) < 1e-13);
  CHECK(twin::distance(response.affine().matrix, closed_form) < 1e-13);
  CHECK(twin::distance(response.relaxed().matrix, closed_form) < 1e-13);
}

/// Grains overlap at places that are rounded, and k_n is taken of these: forces cancel to rounding over
/// overlap.
packing::Assembly pressed_lattice(const samples::Lattice& kind, int repeats, double overlap, double ratio) {
  packing::Assembly a =
      samples::lattice({(1 - overlap) * kind.edges, kind.sites}, {.radius = radius, .repeats = repeats});
  for (packing::Contact& c : a.contacts) {
    c.normal_stiffness = kn * std::sqrt(c.overlap / (2 * radius * overlap));
    c.tangential_stiffness = ratio * c.normal_stiffness;
  }
  return a;
}

/// Of a contact's stiffness: places of the size of the cell are rounded, and overlaps are their differences.
double rounding(int repeats, double overlap) { return 1e-13 + 2e-15 * repeats / overlap; }

Matrix6 cubic_of(const samples::Lattice& kind, double k_t, double half_branch) {
  if (kind.sites.size() == 1)
    return cubic(kn / (2 * half_branch), 0, k_t / (4 * half_branch));
  const double r2 = std::sqrt(2);
  return cubic((kn + k_t) / (r2 * half_branch), (kn - k_t) / (2 * r2 * half_branch),
               (kn + k_t) / (2 * r2 * half_branch));
}

} // namespace

TEST_CASE("lattices of any size are solved at overlaps from 1e-6 to 1e-1, with and without friction") {
  for (const samples::Lattice* kind : {&samples::simple_cubic, &samples::face_centred})
    for (const int repeats : {3, 5})
      for (const double overlap : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1})
        for (const double ratio : {0.8, 0.0}) {
          CAPTURE(kind->sites.size());
          CAPTURE(repeats);
          CAPTURE(overlap);
          CAPTURE(ratio);
          const auto response = network::linear_response(pressed_lattice(*kind, repeats, overlap, ratio));
          CHECK(response.converged());
          CHECK(response.report().iterations <= 60);
          CHECK(
              twin::distance(response.relaxed().matrix, cubic_of(*kind, ratio * kn, radius * (1 - overlap))) <
              rounding(repeats, overlap));
        }
}

TEST_CASE("Bravais lattices: closed form = sum over contacts = network") { // [DuffyMindlin1957]
  const double r3 = std::sqrt(3);
  check_exact(samples::simple_cubic, cubic_of(samples::simple_cubic, kt, radius));
  check_exact(samples::body_centred, cubic((kn + 2 * kt) / (2 * r3 * radius), (kn - kt) / (2 * r3 * radius),
                                           (2 * kn + kt) / (4 * r3 * radius)));
  check_exact(samples::face_centred, cubic_of(samples::face_centred, kt, radius));
}

TEST_CASE("the hexagonal close packing relaxes") { // known to five decimals
  const packing::Assembly a = samples::lattice(samples::hexagonal, {.tangential_stiffness = 0.9189});
  const auto response = network::linear_response(a);
  const Matrix6& c = response.affine().matrix;
  const Matrix6& d = response.relaxed().matrix;
  const struct {
    int row, column;
    double affine, relaxed;
  } all[] = {{0, 0, 2.74241, 2.74234}, {0, 1, 0.04779, 0.04786}, {5, 5, 1.34731, 1.34724},
             {2, 2, 2.75197, 2.75197}, {0, 2, 0.03823, 0.03823}, {3, 3, 1.33775, 1.33775}};
  for (const auto& of : all) {
    CHECK(std::abs(c(of.row, of.column) - of.affine) < 0.6e-5);
    CHECK(std::abs(d(of.row, of.column) - of.relaxed) < 0.6e-5);
  }
  const packing::Assembly small =
      samples::lattice(samples::hexagonal, {.tangential_stiffness = 0.9189, .repeats = 2});
  CHECK(twin::distance(d, twin::response(small, false).relaxed) < 1e-12);
}
