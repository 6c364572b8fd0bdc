// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/waves.hpp>

#include <random>

#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

constexpr double density = 1650; // of a dry sand [kg/m3]
using test::rounding;

/// The Christoffel matrix from the fourth-rank tensor, by the four-fold sum of its definition.
Mat3 christoffel_matrix(const VoigtStiffness& c, const Vec3& n) {
  const int index[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
  Mat3 gamma;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          gamma(i, k) += c.matrix(index[i][j], index[k][l]) * n[j] * n[l];
  return gamma;
}

/// Axes, planes of symmetry, nearly these, and random ones.
std::vector<Vec3> directions() {
  std::vector<Vec3> list{{1, 0, 0}, {0, 1, 0}, {0, 0, 1},        {0, 0, -1},     {1, 1, 0},
                         {1, 0, 1}, {0, 1, 1}, {1e-9, 2e-9, -1}, {-3, 4, 1e-12}, {1, 1, 1}};
  std::mt19937_64 random(11);
  for (int i = 0; i < 100; ++i)
    list.push_back(random_vector(random));
  return list;
}

void check_orthonormal(const std::array<PlaneWave, 3>& waves, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(std::abs(dot(waves[i].polarisation, waves[j].polarisation) - (i == j ? 1 : 0)) < tolerance);
}

std::array<PlaneWave, 3> all(const TransverselyIsotropicWaves& w) { return {w.quasi_p, w.quasi_s, w.pure_s}; }
std::array<PlaneWave, 3> all(const PlaneWaves& w) { return {w.fastest, w.middle, w.slowest}; }

std::array<double, 3> squares(const std::array<PlaneWave, 3>& waves) {
  std::array<double, 3> list{};
  std::transform(waves.begin(), waves.end(), list.begin(),
                 [](const PlaneWave& w) { return w.speed * w.speed; });
  std::sort(list.rbegin(), list.rend());
  return list;
}

/// Gamma p = density v^2 p, relative to the largest eigenvalue.
void check_eigenpair(const Mat3& gamma, const PlaneWave& wave) {
  const Vec3 residual = gamma * wave.polarisation - density * wave.speed * wave.speed * wave.polarisation;
  CHECK(norm(residual) < rounding * trace(gamma));
}

} // namespace

TEST_CASE("plane waves: every wave of a triclinic solid is an eigenpair of the Christoffel matrix") {
  for (Vec3 n : directions()) {
    const PlaneWaves waves = plane_waves(triclinic_sample(), density, n);
    n *= 1 / norm(n);
    const Mat3 gamma = christoffel_matrix(triclinic_sample(), n);
    for (const PlaneWave& wave : all(waves))
      check_eigenpair(gamma, wave);
    check_orthonormal(all(waves), 4e-15);
    CHECK(waves.fastest.speed >= waves.middle.speed);
    CHECK(waves.middle.speed >= waves.slowest.speed);
    CHECK(dot(waves.fastest.polarisation, n) > 0);
    // sum rule: V_p^2 + V_s1^2 + V_s2^2 = trace/density
    const auto v2 = squares(all(waves));
    CHECK(v2[0] + v2[1] + v2[2] == relative(trace(gamma) / density, rounding));
  }
}

TEST_CASE("plane waves: the closed form of transverse isotropy is that of the full matrix") {
  std::mt19937_64 random(5);
  for (const Vec3& n : directions()) {
    const TransverselyIsotropic c = random_layered(random, -0.9, 0.999);
    const TransverselyIsotropicWaves closed = plane_waves(c, density, n);
    const PlaneWaves full = plane_waves(voigt(c), density, n);
    const auto one = squares(all(closed)), other = squares(all(full));
    for (std::size_t k = 0; k < 3; ++k) // to the rounding of the largest
      CHECK(std::abs(one[k] - other[k]) < rounding * other[0]);
    const Mat3 gamma = christoffel_matrix(voigt(c), 1 / norm(n) * n);
    for (const PlaneWave& wave : all(closed))
      check_eigenpair(gamma, wave);
    check_orthonormal(all(closed), 1e-15);
    CHECK(closed.quasi_p.speed >= closed.quasi_s.speed);
    CHECK(dot(closed.quasi_p.polarisation, n) >= 0);
    CHECK(closed.pure_s.polarisation.z == 0);
  }
}

TEST_CASE("plane waves: closed speeds are right to 4 ulp, a slow quasi-S too") {
  std::mt19937_64 random(7);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const TransverselyIsotropic c = random_layered(random, -0.99, 0.99);
    const Vec3 n = random_vector(random);
    const auto waves = plane_waves(c, density, n);
    // the textbook roots with the eleven more bits of long double, of which mean - root loses at most seven
    using Long = long double;
    const Long x = n.x, y = n.y, z = n.z, square = x * x + y * y + z * z;
    const Long s2 = (x * x + y * y) / square, c2 = z * z / square;
    const Long C11 = c.C11, C33 = c.C33, C13 = c.C13, C44 = c.C44, C12 = c.C12;
    const Long g11 = C11 * s2 + C44 * c2, g33 = C44 * s2 + C33 * c2, g13 = (C13 + C44) * std::sqrt(s2 * c2);
    const Long root = std::sqrt((g11 - g33) * (g11 - g33) / 4 + g13 * g13), mean = (g11 + g33) / 2;
    worst = std::max({worst, ulps(waves.quasi_p.speed, std::sqrt((mean + root) / density)),
                      ulps(waves.quasi_s.speed, std::sqrt((mean - root) / density)),
                      ulps(waves.pure_s.speed, std::sqrt(((C11 - C12) / 2 * s2 + C44 * c2) / density))});
  }
  CHECK(worst < 4);
}

TEST_CASE("plane waves: a nearly fluid solid keeps the digits of its shear waves") {
  // lambda + 2 mu and lambda of an isotropic solid with mu = 2^-30 lambda: mean - root would keep 8 digits
  const double lambda = 2e9, mu = 2e9 * 0x1p-30;
  const TransverselyIsotropic c{
      .C11 = lambda + 2 * mu, .C33 = lambda + 2 * mu, .C12 = lambda, .C13 = lambda, .C44 = mu};
  for (const Vec3& n : directions())
    CHECK(plane_waves(c, density, n).quasi_s.speed == relative(std::sqrt(mu / density), 4e-15));
}

TEST_CASE("plane waves: degenerate speeds have orthonormal polarisations") {
  const Isotropic sand = Isotropic::from_bulk_and_shear(190e6, 140e6);
  const double V_p = std::sqrt((190e6 + 4 * 140e6 / 3) / density), V_s = std::sqrt(140e6 / density);
  for (Vec3 n : directions()) {
    const PlaneWaves full = plane_waves(voigt(sand), density, n);
    const TransverselyIsotropicWaves closed = plane_waves(transversely_isotropic(sand), density, n);
    n *= 1 / norm(n);
    const double V[] = {V_p, V_s, V_s};
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(all(full)[k].speed == relative(V[k], rounding));
      CHECK(all(closed)[k].speed == relative(V[k], rounding));
    }
    CHECK(norm(full.fastest.polarisation - n) < rounding);
    CHECK(norm(closed.quasi_p.polarisation - n) < rounding);
    check_orthonormal(all(full), 4e-15);
    check_orthonormal(all(closed), 1e-15);
  }
  // on the axis of symmetry both shear waves run at sqrt(C44/density)
  const auto vertical = plane_waves(layered_sample(), density, {0, 0, 2});
  CHECK(vertical.quasi_s.speed == relative(std::sqrt(121e6 / density), 1e-15));
  CHECK(vertical.pure_s.speed == vertical.quasi_s.speed);
  const TransverselyIsotropic equal{.C11 = 1e8, .C33 = 1e8, .C12 = 0, .C13 = 0, .C44 = 1e8};
  const auto waves = plane_waves(equal, density, {0, 0, 1});
  CHECK(waves.quasi_p.speed == waves.quasi_s.speed);
  CHECK(waves.quasi_p.polarisation == Vec3{0, 0, 1});
  check_orthonormal(all(waves), 1e-15);
}

TEST_CASE("plane waves: group velocity is the gradient of the frequency and projects on the phase speed") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 50; ++i) {
    Vec3 n = random_vector(random);
    n *= 1 / norm(n);
    const PlaneWaves waves = plane_waves(triclinic_sample(), density, n);
    for (const auto which : {&PlaneWaves::fastest, &PlaneWaves::middle, &PlaneWaves::slowest}) {
      const Vec3 velocity = group_velocity(triclinic_sample(), density, n, waves.*which);
      CHECK(dot(velocity, n) == relative((waves.*which).speed, rounding));
      if (waves.middle.speed - waves.slowest.speed < 0.02 * waves.middle.speed)
        continue;                   // curvature of the slowness sheets grows without bound where they meet
      constexpr double step = 1e-4; // frequency is |k| v(k): central difference, error step^2 over the gap^2
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 ahead = n, behind = n;
        ahead[axis] += step, behind[axis] -= step;
        const double slope =
            (norm(ahead) * (plane_waves(triclinic_sample(), density, ahead).*which).speed -
             norm(behind) * (plane_waves(triclinic_sample(), density, behind).*which).speed) /
            (2 * step);
        CHECK(std::abs(velocity[axis] - slope) < 1e-4 * waves.fastest.speed);
      }
    }
  }
}

TEST_CASE("plane waves: neither the length of the direction nor the size of the moduli matters") {
  const TransverselyIsotropic c = layered_sample();
  const Vec3 n{0.3, -0.5, 0.7};
  const auto waves = plane_waves(c, density, n);
  for (const double length : {1e-300, 1e-3, 1e300}) {
    CHECK(plane_waves(c, density, length * n).quasi_s.speed == relative(waves.quasi_s.speed, 1e-15));
    CHECK(plane_waves(voigt(c), density, length * n).fastest.speed ==
          relative(waves.quasi_p.speed, rounding));
  }
  for (const int power : {-800, 800}) { // of two: the bits are to be the same
    const double f = std::ldexp(1, power);
    const TransverselyIsotropic scaled{
        .C11 = f * c.C11, .C33 = f * c.C33, .C12 = f * c.C12, .C13 = f * c.C13, .C44 = f * c.C44};
    CHECK(plane_waves(scaled, density, n).quasi_s.speed == std::ldexp(waves.quasi_s.speed, power / 2));
    CHECK(plane_waves(scaled, density, n).quasi_p.speed == std::ldexp(waves.quasi_p.speed, power / 2));
  }
}

TEST_CASE("plane waves: a semidefinite stiffness has speeds of zero, an indefinite one is refused") {
  const TransverselyIsotropic water{.C11 = 2.2e9, .C33 = 2.2e9, .C12 = 2.2e9, .C13 = 2.2e9, .C44 = 0};
  for (const Vec3& n : directions()) {
    const auto waves = plane_waves(water, 1000, n);
    CHECK(waves.quasi_p.speed == relative(std::sqrt(2.2e6), rounding));
    CHECK(waves.quasi_s.speed < 1e-7 * waves.quasi_p.speed); // the root of a rounded zero
    CHECK(waves.pure_s.speed == 0);
    check_orthonormal(all(waves), 1e-15);
  }
  TransverselyIsotropic rounded = water; // a shear modulus of zero, as a simulation would give it
  rounded.C44 = -1e-15 * water.C33;
  CHECK(plane_waves(rounded, 1000, {1, 2, 3}).pure_s.speed >= 0);
  CHECK(plane_waves(rounded, 1000, {1, 2, 3}).quasi_s.speed >= 0);
  CHECK(plane_waves(TransverselyIsotropic{}, density, {1, 2, 3}).quasi_p.speed == 0);
  CHECK(plane_waves(VoigtStiffness{}, density, {1, 2, 3}).fastest.speed == 0);

  const double infinity = std::numeric_limits<double>::infinity();
  TransverselyIsotropic broken = layered_sample(), undefined = broken, infinite = broken;
  TransverselyIsotropic sheared = broken, plane = broken;
  broken.C13 = 300e6, undefined.C13 = std::nan(""), infinite.C11 = infinity;
  sheared.C44 *= -1, plane.C12 = 1.01 * plane.C11;
  for (const TransverselyIsotropic& bad : {broken, undefined, infinite, sheared, plane})
    CHECK_THROWS_AS((void)plane_waves(bad, density, {0, 0, 1}), InvalidArgument);
  CHECK_THROWS_AS((void)plane_waves(voigt(broken), density, {0, 0, 1}), InvalidArgument);
}

TEST_CASE("plane waves: bad densities, directions and waves are refused") {
  const TransverselyIsotropic c = layered_sample();
  const Vec3 up{0, 0, 1}, none{0, 0, 0}, undefined{0, std::nan(""), 1};
  for (const auto& [rho, n] : {std::pair(0.0, up), {-1.0, up}, {density, none}, {density, undefined}}) {
    CHECK_THROWS_AS((void)plane_waves(c, rho, n), InvalidArgument);
    CHECK_THROWS_AS((void)plane_waves(voigt(c), rho, n), InvalidArgument);
  }
  CHECK_THROWS_AS((void)group_velocity(voigt(c), density, up, {}), InvalidArgument);
  CHECK_THROWS_AS((void)group_velocity(voigt(c), density, none, {.speed = 1, .polarisation = {1, 0, 0}}),
                  InvalidArgument);
}
