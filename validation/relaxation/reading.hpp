// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the recorded states of validation/relaxation; validation/gradation reads its own with parts of it.
#pragma once

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/io/csv/table.hpp>

#include "effective/relaxation_kernel.hpp"
#include "effective/relaxed_constants.hpp"
#include "effective/unevenness_kernel.hpp"
#include "packings.hpp"

namespace relaxation {

namespace detail {

/// \param    radius   of the pair, for spheres [m]
inline granum::contact::PowerLaw law(const std::string& contact, double radius) {
  using granum::contact::PowerLaw;
  constexpr granum::contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  if (contact == "cone")
    return PowerLaw::cone(grain, 0.4);
  if (contact == "sphere")
    return PowerLaw::sphere(grain, radius);
  if (contact == "flat")
    return PowerLaw::flat(grain, 5.7e-6);
  if (contact == "alpha1.5")
    return PowerLaw::general(grain, 1.5, 180);
  if (contact == unfitted_contact)
    return PowerLaw::general(grain, 4, 2e12);
  throw std::runtime_error("unknown contact " + contact);
}

inline TransverselyIsotropic stiffness(const std::map<std::string, double>& row, const std::string& suffix) {
  const auto constant = [&](const std::string& name) { return row.at(name + "_" + suffix + "_Pa"); };
  return {.C11 = constant("C11"),
          .C33 = constant("C33"),
          .C12 = constant("C12"),
          .C13 = constant("C13"),
          .C44 = constant("C44")};
}

using Row = std::map<std::string, double>;

/// Numbers of a row by their headings; text is left out.
inline Row numbers(const std::vector<std::string>& headings, const std::vector<std::string>& fields) {
  static const std::set<std::string> text{"sizes", "contact", "preparation", "density"};
  Row row;
  for (std::size_t k = 0; k < fields.size(); ++k)
    if (text.count(headings[k]) == 0)
      row[headings[k]] = fields[k].empty() ? State::unset : std::stod(fields[k]);
  return row;
}

/// A file without these columns has equal grains.
inline granum::sizes::ContactMeans contact_means(const Row& row) {
  if (row.count("branch") == 0)
    return {};
  return {.branch = row.at("branch"),
          .branch_square = row.at("branch_square"),
          .pair_radius = row.at("pair_radius"),
          .grain_volume = row.at("grain_volume")};
}

inline State state(const Row& row, const std::string& contact, double tangential_ratio) {
  const double radius = row.count("R_m") > 0 ? row.at("R_m") : 0.5e-3;
  const granum::sizes::ContactMeans contacts = contact_means(row);
  return {.law = law(contact, radius * contacts.pair_radius),
          .tangential_ratio = tangential_ratio,
          .radius = radius,
          .void_ratio = row.at("e"),
          .coordination_number = row.at("C_n"),
          .fabric_anisotropy = row.at("a"),
          .stress_v = row.at("stress_v_Pa"),
          .stress_h = row.at("stress_h_Pa"),
          .contacts = contacts};
}

/// Of the mean force, over the diameter.
inline double relative_overlap(const State& state) {
  return state.law.overlap(granum::effective::mean_contact_force(state)) /
         (2 * state.radius * state.contacts.branch);
}

/// K of uniform strain in closed form, of the branches that overlaps leave [Pa].
inline double closed_strain_bulk_modulus(const Packing& p) {
  return granum::effective::uniform_strain(p.state).stiffness.bulk_modulus() *
         granum::effective::kernel::shortened_branches(p.relative_overlap, p.exponent());
}

/// The same contacts, all of them at the mean force.
inline State at_mean_force(State state) {
  state.fabric_anisotropy = 0;
  state.stress_v = state.stress_h = state.mean_stress();
  return state;
}

/// Q of a packing, from its recorded G under uniform strain and that of the closed form.
inline double unevenness(const Packing& p, double G_of_contacts, double G_of_closed_form) {
  return std::log(G_of_contacts / G_of_closed_form /
                  granum::effective::kernel::shortened_branches(p.relative_overlap, p.exponent()));
}

inline Packing packing(const Row& row, const std::string& sizes, const std::string& contact,
                       const std::string& preparation) {
  static const std::map<std::string, double> ratios{
      {"0", 0}, {"0.03", 0.03}, {"0.1", 0.1}, {"0.3", 0.3}, {"0.6", 0.6}, {"0.919", 0.918918918918919},
      {"1", 1}};
  const int seed = static_cast<int>(row.at("seed"));
  Packing p{.sizes = sizes,
            .contact = contact,
            .preparation = preparation,
            .recipe = contact + " " + unsheared(preparation) + " " + sizes,
            .specimen = contact + " " + unsheared(preparation) + " " + sizes + " " + std::to_string(seed),
            .seed = seed,
            .pressure = row.at("p_Pa"),
            .stress_ratio = row.at("stress_ratio"),
            .friction_coefficient = row.at("friction_coefficient"),
            .state = state(row, contact, ratios.at("0.919")),
            .mechanical_coordination = row.at("z_star"),
            .rattler_fraction = row.at("rattler_fraction"),
            .uniformity = row.count("C_u") > 0 ? row.at("C_u") : 1,
            .affine_share = row.at("force_moment_b"),
            .strain_bulk_modulus = stiffness(row, "affine").bulk_modulus(),
            .networks = {}};
  p.relative_overlap = relative_overlap(p.state);
  if (sizes != "equal")
    p.affine_share = p.strain_bulk_modulus / closed_strain_bulk_modulus(p);
  Packing even = p;
  even.state = at_mean_force(p.state);
  p.unevenness = std::log(p.strain_bulk_modulus / closed_strain_bulk_modulus(even));
  for (const auto& [name, ratio] : ratios)
    p.networks.push_back({ratio, stiffness(row, name)});
  return p;
}

} // namespace detail

inline std::vector<Packing> read_packings(const std::string& path) {
  const granum::io::CsvTable table = granum::io::read_csv(path);
  const std::size_t contact = table.headings().front() == "sizes" ? 1 : 0; // its column
  std::vector<Packing> packings;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::vector<std::string>& fields = table.fields(k);
    packings.push_back(detail::packing(detail::numbers(table.headings(), fields),
                                       contact == 1 ? fields[0] : "equal", fields[contact],
                                       fields[contact + 1]));
  }
  return packings;
}

} // namespace relaxation
