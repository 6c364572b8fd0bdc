// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_packing.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <granum/core/number.hpp>
#include <granum/io/lammps_data.hpp>
#include <granum/io/output_file.hpp>

namespace granum::bench {

namespace {

dem::State at_rest(const Mat3& cell, std::vector<Vec3> position) {
  dem::State state;
  state.cell = cell;
  state.radius = radius;
  state.position = std::move(position);
  state.velocity.assign(state.position.size(), Vec3{});
  state.angular_velocity.assign(state.position.size(), Vec3{});
  return state;
}

} // namespace

dem::Material sphere_material() {
  return {.law = contact::PowerLaw::sphere(quartz, radius),
          .tangential_stiffness_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
          .friction_coefficient = friction};
}

std::size_t count_of(const std::string& text) {
  const double value = parse_number(text).value_or(0);
  if (!(value >= 1 && value <= 1e9) || value != std::floor(value))
    throw std::invalid_argument("'" + text + "' is no positive whole number");
  return static_cast<std::size_t>(value);
}

dem::State load_packing(const std::filesystem::path& path) {
  const Assembly grains = io::read_lammps_data(io::TextSource(path)).assembly;
  return at_rest(grains.cell, grains.position);
}

void save_packing(const dem::State& state, const std::filesystem::path& path) {
  const dem::Material of = sphere_material();
  io::write_file(path, io::lammps_data(dem::freeze(state, of), of.density), io::Existing::replace);
}

dem::State side_by_side(const dem::State& one, std::size_t nx, std::size_t ny, std::size_t nz) {
  const auto steps = [](std::size_t x, std::size_t y, std::size_t z) {
    return Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  };
  std::vector<Vec3> position;
  for (std::size_t x = 0; x < nx; ++x)
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t z = 0; z < nz; ++z)
        for (const Vec3& at : one.position)
          position.push_back(at + one.cell * steps(x, y, z));
  const Vec3 copies = steps(nx, ny, nz);
  return at_rest(one.cell * Mat3::diagonal(copies.x, copies.y, copies.z), std::move(position));
}

} // namespace granum::bench
