// SPDX-License-Identifier: GPL-3.0-or-later
#include "specimens.hpp"

#include <cstdint>

#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::bench {

namespace {

constexpr double radius = 5e-4;
constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};

} // namespace

dem::Material material(double friction) {
  return {.law = contact::PowerLaw::sphere(quartz, radius),
          .tangential_stiffness_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
          .friction_coefficient = friction};
}

dem::State thousand_grains() {
  const triaxial::SpecimenRecipe recipe{.material = material(0.5), .radius = radius};
  dem::Engine engine(triaxial::frictionless_specimen(recipe).state, recipe.material);
  (void)dem::equilibrate(engine, {pressure, pressure, pressure}, triaxial::compression_options());
  dem::State state = engine.state();
  state.history.clear();
  return state;
}

dem::State repeated(const dem::State& one, int nx, int ny, int nz) {
  dem::State all = one;
  all.cell = one.cell * Mat3::diagonal(nx, ny, nz);
  all.position.clear();
  std::uint64_t random = 1;
  const auto next = [&random] {
    random = random * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(random >> 11) * 0x1p-53 - 0.5;
  };
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z)
        for (const Vec3& at : one.position) {
          const Vec3 shift{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          all.position.push_back(at + one.cell * shift);
        }
  all.velocity.clear();
  for (std::size_t g = 0; g < all.position.size(); ++g)
    all.velocity.push_back(2e-3 * Vec3{next(), next(), next()});
  all.angular_velocity.assign(all.position.size(), Vec3{});
  return all;
}

} // namespace granum::bench
