// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of public codes that deal with elastic and fabric tensors, and identities that every such code
// should keep. Each test shows that granum does not have the fault, or keeps the identity, that its name
// states.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/fabric/estimates.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/packing/coordination.hpp>
#include <relative.hpp>

using namespace granum;
using namespace granum::elastic;

namespace {

const TransverselyIsotropic shale{.C11 = 34.3e9, .C33 = 22.7e9, .C12 = 13.1e9, .C13 = 10.7e9, .C44 = 5.4e9};

/// C33/C11 = 1.009, C66/C44 = 1.03 at some 100 MPa: weakly, but clearly, transversely isotropic.
const TransverselyIsotropic soil{
    .C11 = 100e6, .C33 = 100.9e6, .C12 = 100e6 - 2 * 1.03 * 35e6, .C13 = 29e6, .C44 = 35e6};

/// Four grains in a bent row: three contacts, along axes 1, 3 and 2.
packing::Assembly row_of_four() {
  packing::Assembly row;
  row.cell = Mat3::diagonal(8, 8, 8);
  row.position = {{1, 1, 1}, {3, 1, 1}, {3, 1, 3}, {3, 3, 3}};
  row.radius = {1, 1, 1, 1};
  for (std::uint32_t i = 0; i < 3; ++i)
    row.contacts.push_back({.i = i, .j = i + 1, .branch = row.position[i + 1] - row.position[i]});
  return row;
}

} // namespace

TEST_CASE("fault, entries lost: the full matrix of transverse isotropy has C33 and C23 too") {
  const Matrix6 c = voigt(shale).matrix;
  CHECK(c(0, 0) == 34.3e9);
  CHECK(c(1, 1) == 34.3e9);
  CHECK(c(2, 2) == 22.7e9);
  CHECK(c(0, 1) == 13.1e9);
  CHECK(c(0, 2) == 10.7e9);
  CHECK(c(1, 2) == 10.7e9);
  CHECK(c(3, 3) == 5.4e9);
  CHECK(c(4, 4) == 5.4e9);
  CHECK(c(5, 5) == relative((34.3e9 - 13.1e9) / 2, 1e-15));
  CHECK(symmetry_residual(mandel(voigt(shale))) == 0);
  CHECK(c.bottomLeftCorner(3, 3).norm() == 0);
  const TransverselyIsotropic back = transversely_isotropic_projection(voigt(shale));
  CHECK(back.C33 == shale.C33);
  CHECK(back.C13 == shale.C13);
  CHECK(back.C44 == shale.C44);
  CHECK(back.C11 == relative(shale.C11, 1e-15));
  CHECK(back.C12 == relative(shale.C12, 1e-15));
}

TEST_CASE("fault, results permuted: Thomsen parameters go by name, and a round trip permutes none of them") {
  const ThomsenSolid solid = thomsen_solid(shale, 2400);
  // definitions, typed anew
  CHECK(solid.vertical_p_speed == relative(std::sqrt(22.7e9 / 2400), 1e-15));
  CHECK(solid.vertical_s_speed == relative(std::sqrt(5.4e9 / 2400), 1e-15));
  CHECK(solid.anisotropy.epsilon == relative((34.3 - 22.7) / (2 * 22.7), 1e-14));
  CHECK(solid.anisotropy.gamma == relative((10.6 - 5.4) / (2 * 5.4), 1e-14));
  CHECK(solid.anisotropy.delta == relative((16.1 * 16.1 - 17.3 * 17.3) / (2 * 22.7 * 17.3), 1e-13));
  const TransverselyIsotropic back = transversely_isotropic(solid);
  CHECK(back.C11 == relative(shale.C11, 1e-14));
  CHECK(back.C33 == relative(shale.C33, 1e-14));
  CHECK(back.C12 == relative(shale.C12, 1e-14));
  CHECK(back.C13 == relative(shale.C13, 1e-14));
  CHECK(back.C44 == relative(shale.C44, 1e-14));
  // and each parameter moves its own wave: epsilon the horizontal P, gamma the horizontal SH
  ThomsenSolid other = solid;
  other.anisotropy.epsilon += 0.01;
  const Vec3 horizontal{1, 0, 0};
  const auto before = plane_waves(shale, 2400, horizontal);
  const auto after = plane_waves(transversely_isotropic(other), 2400, horizontal);
  CHECK(after.quasi_p.speed > before.quasi_p.speed);
  CHECK(after.pure_s.speed == relative(before.pure_s.speed, 1e-14));
}

TEST_CASE("fault, wrong contact removed: leaving one out keeps the sums of the others") {
  for (std::size_t left_out = 0; left_out < 3; ++left_out) {
    packing::Assembly row = row_of_four();
    row.contacts.erase(row.contacts.begin() + static_cast<std::ptrdiff_t>(left_out));
    const Mat3 F = packing::fabric_tensor(row);
    CHECK(trace(F) == relative(1, 1e-15));
    // the three contacts run along axes 1, 3 and 2
    CHECK(F(0, 0) == (left_out == 0 ? 0 : 0.5));
    CHECK(F(2, 2) == (left_out == 1 ? 0 : 0.5));
    CHECK(F(1, 1) == (left_out == 2 ? 0 : 0.5));
  }
  // and the contact tensor is 15/2 (F - 1/3): traceless, zero for an isotropic fabric
  const Mat3 A = fabric::contact_tensor(packing::fabric_tensor(row_of_four()));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(std::abs(A(i, j)) < 1e-15);
}

TEST_CASE("fault, absolute tolerance: a soil at 100 MPa gives the same result in Pa and in GPa") {
  const SymmetryDistances in_Pa = symmetry_distances(voigt(soil));
  CHECK(in_Pa.transversely_isotropic < 1e-15);
  CHECK(in_Pa.cubic > 5e-3); // not cubic: an absolute 1e-3 GPa would have called it so
  CHECK(in_Pa.isotropic > 5e-3);
  for (const double unit : {1e-9, 1e-6, 1e3}) {
    const SymmetryDistances scaled = symmetry_distances({unit * voigt(soil).matrix});
    CHECK(scaled.cubic == relative(in_Pa.cubic, 1e-13));
    CHECK(scaled.isotropic == relative(in_Pa.isotropic, 1e-13));
    CHECK(scaled.transversely_isotropic < 1e-15);
  }
}

TEST_CASE("fault, absolute tolerance: isotropic data in Pa are isotropic in spite of their rounding") {
  for (const double size : {1e-3, 1e5, 1e11}) {
    const SymmetryDistances d = symmetry_distances(voigt(Isotropic::from_young_and_poisson(size, 0.217)));
    CHECK(d.isotropic < 1e-15);
    CHECK(d.cubic < 1e-15);
  }
}

TEST_CASE("fault, Voigt eigenvalues: they are those of the tensor, not of the Voigt matrix") {
  const double K = 60e6, G = 40e6;
  const MandelStiffness c = mandel(voigt(Isotropic::from_bulk_and_shear(K, G)));
  CHECK(relative_smallest_eigenvalue(c) == relative(2 * G / (3 * K), 1e-14)); // Voigt: G/(3K)
}

TEST_CASE("fault, program ended: a bad stiffness is an error that the caller can catch") {
  VoigtStiffness broken = voigt(soil);
  broken.matrix(2, 2) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)symmetry_distances(broken), InvalidArgument);
  broken.matrix(2, 2) = -1e6;
  CHECK_THROWS_AS((void)plane_waves(broken, 1600, {0, 0, 1}), InvalidArgument);
}

TEST_CASE("identity: the density of contact normals integrates to one, and is none beyond |a| = 1") {
  for (double a = -1; a <= 1; a += 0.0625) {
    double whole = 0, least = 1;
    for (const auto& [x, w] : gauss_legendre(12)) {
      const double E = fabric::density(std::acos(x), a);
      whole += 2 * std::numbers::pi * w * E;
      least = std::min(least, E);
    }
    CHECK(whole == relative(1, 1e-14));
    CHECK(least >= 0);
  }
  CHECK_THROWS_AS((void)fabric::density(0, -1.01), InvalidArgument);
}

TEST_CASE("identity: a, F33 and the contact tensor of LAMMPS map into one another exactly") {
  for (const double a : {-1.0, -0.4, 1e-12, 0.3, 1.0}) {
    const auto m = fabric::measures_from_anisotropy(a);
    CHECK(m.F33 == relative((5 + a) / (5 * (3 - a)), 1e-15));
    CHECK(m.P2_coefficient == relative(4 * a / (3 - a), 1e-15));
    CHECK(std::abs(7.5 * (m.F33 - 1.0 / 3) - m.P2_coefficient) < 2e-15);
    CHECK(fabric::measures_from_P2_coefficient(m.P2_coefficient).anisotropy == relative(a, 1e-15));
  }
}

TEST_CASE("fault, silent clipping: a fabric beyond the density is reported and not clipped") {
  for (const double F33 : {0.0, 0.1, 0.65, 1.0}) {
    const auto m = fabric::measures_from_F33(F33);
    CHECK(m.anisotropy == relative((15 * F33 - 5) / (1 + 5 * F33), 1e-14));
    CHECK(std::abs(m.anisotropy) > 1);
    CHECK(m.validity.notes.size() == 1);
  }
  for (const double F33 : {0.2001, 0.4, 0.5999})
    CHECK(fabric::measures_from_F33(F33).validity.ok());
  CHECK_THROWS_AS((void)fabric::measures_from_F33(1.01), InvalidArgument);
}

TEST_CASE("identity: isotropic contacts scatter a by 1.677/sqrt(N_c)") {
  CHECK(fabric::isotropic_standard_error(29500) == relative(1.677 / std::sqrt(29500), 1e-3));
  std::uint64_t seed = 1;
  for (const std::size_t contacts : {200UL, 1000UL, 5000UL}) {
    constexpr int repeats = 500;
    double squares = 0;
    for (int i = 0; i < repeats; ++i)
      squares +=
          std::pow(fabric::estimate_anisotropy(fabric::sample_normals(0, contacts, seed++)).anisotropy, 2);
    const double scatter = std::sqrt(squares / repeats);
    // four standard errors of a scatter
    CHECK(std::abs(scatter / fabric::isotropic_standard_error(contacts) - 1) < 4 / std::sqrt(2.0 * repeats));
  }
}

TEST_CASE("identity: the average over contacts is the scalar formula of Hertz and Mindlin") {
  const double K = 36.6e9, G = 45e9, nu = (3 * K - 2 * G) / (2 * (3 * K + G));
  for (const double radius : {1.0, 0.5e-3}) {
    effective::State state{.law = contact::PowerLaw::sphere({G, nu}, radius),
                           .tangential_ratio = contact::mindlin_stiffness_ratio(nu),
                           .radius = radius,
                           .void_ratio = 0.4 / 0.6,
                           .coordination_number = 8.6,
                           .stress_v = 20e6,
                           .stress_h = 20e6};
    const Isotropic rough = isotropic_projection(voigt(effective::uniform_strain(state).stiffness));
    CHECK(rough.bulk_modulus() == relative(1.906319860921191e9, 1e-14));
    CHECK(rough.shear_modulus() == relative(2.802805417138183e9, 1e-14));
    state.tangential_ratio = 0;
    const Isotropic smooth = isotropic_projection(voigt(effective::uniform_strain(state).stiffness));
    CHECK(smooth.bulk_modulus() == relative(1.906319860921191e9, 1e-14));
    CHECK(smooth.shear_modulus() == relative(1.143791916552714e9, 1e-14));
  }
}

TEST_CASE("fault, NaN without contacts: each coordination number has its own name, and none is NaN") {
  const packing::Assembly row = row_of_four();
  CHECK(coordination_number(row) == 1.5); // 2 N_c over all grains
  const auto mechanical = mechanical_coordination(row, packing::ContactKind::frictional);
  CHECK(mechanical.rattler_count == 4); // an open row bears nothing
  CHECK(mechanical.coordination_number == 0);
  packing::Assembly empty = row;
  empty.contacts.clear();
  CHECK(coordination_number(empty) == 0);
  CHECK_THROWS_AS((void)packing::fabric_tensor(empty), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::estimate_anisotropy({}), InvalidArgument);
}
