// SPDX-License-Identifier: GPL-3.0-or-later
#include "stored_packing.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <granum/core/text.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/io/output_file.hpp>

namespace granum::bench {

std::size_t count_of(const std::string& text) {
  const double value = parse_number(text).value_or(0);
  if (!(value >= 1 && value <= 1e9) || value != std::floor(value))
    throw std::invalid_argument("'" + text + "' is no positive whole number");
  return static_cast<std::size_t>(value);
}

dem::Specimen load_packing(const std::filesystem::path& path) {
  const packing::Assembly grains = io::read_lammps_data(io::TextSource(path)).assembly;
  dem::Specimen state;
  state.cell = grains.cell;
  state.radius = radius;
  state.position = grains.position;
  return side_by_side(state, 1, 1, 1);
}

void save_packing(const dem::Specimen& state, const std::filesystem::path& path) {
  const dem::Material of = material(friction);
  io::write_file(path, io::lammps_data(dem::contact_network(state, of), of.density), io::Existing::replace);
}

packing::Assembly network_of(const dem::Specimen& state, bool copies) {
  packing::Assembly assembly = dem::contact_network(state, material(friction));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> factor(0.5, 1.5);
  if (copies)
    for (packing::Contact& c : assembly.contacts) {
      const double by = factor(random);
      c.normal_stiffness *= by;
      c.tangential_stiffness *= by;
    }
  return assembly;
}

} // namespace granum::bench
