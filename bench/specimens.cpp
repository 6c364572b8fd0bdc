// SPDX-License-Identifier: GPL-3.0-or-later
#include "specimens.hpp"

#include <cstdint>
#include <utility>

#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::bench {

dem::Material material(double friction) {
  return {.law = contact::PowerLaw::sphere(quartz, radius),
          .tangential_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
          .friction_coefficient = friction};
}

dem::Specimen thousand_grains(std::optional<double> wall_friction, sizes::Distribution sizes) {
  const triaxial::SpecimenRecipe recipe{
      .material = material(0.5), .radius = radius, .sizes = std::move(sizes), .wall_friction = wall_friction};
  dem::Engine engine(triaxial::frictionless_specimen(recipe).state, recipe.material);
  (void)dem::equilibrate(engine, {pressure, pressure, pressure}, triaxial::compression_options());
  dem::Specimen state = engine.state();
  state.history.clear();
  return state;
}

dem::Specimen side_by_side(const dem::Specimen& one, std::size_t nx, std::size_t ny, std::size_t nz) {
  const auto steps = [](std::size_t x, std::size_t y, std::size_t z) {
    return Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  };
  const Vec3 copies = steps(nx, ny, nz);
  dem::Specimen all;
  all.cell = one.cell * Mat3::diagonal(copies.x, copies.y, copies.z);
  all.radius = one.radius;
  for (std::size_t x = 0; x < nx; ++x)
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t z = 0; z < nz; ++z)
        for (std::size_t g = 0; g < one.grain_count(); ++g) {
          all.position.push_back(one.position[g] + one.cell * steps(x, y, z));
          if (!one.size.empty())
            all.size.push_back(one.size[g]);
        }
  all.velocity.assign(all.position.size(), Vec3{});
  all.angular_velocity.assign(all.position.size(), Vec3{});
  return all;
}

dem::Specimen repeated(const dem::Specimen& one, std::size_t nx, std::size_t ny, std::size_t nz) {
  dem::Specimen all = side_by_side(one, nx, ny, nz);
  std::uint64_t random = 1;
  const auto next = [&random] {
    random = random * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(random >> 11) * 0x1p-53 - 0.5;
  };
  for (Vec3& velocity : all.velocity)
    velocity = 2e-3 * Vec3{next(), next(), next()};
  return all;
}

} // namespace granum::bench
