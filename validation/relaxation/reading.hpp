// SPDX-License-Identifier: GPL-3.0-or-later
// Reads recorded packings: those of this folder, of validation/gradation and of `granum verify`.
#pragma once

#include <granum/contact/power_law.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>

#include "../common.hpp"
#include "effective/relaxation_kernel.hpp"
#include "effective/relaxed_constants.hpp"
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

inline TransverselyIsotropic stiffness(const Entry& row, const std::string& suffix) {
  const auto constant = [&](const std::string& name) { return row(name + "_" + suffix + "_Pa"); };
  return {.C11 = constant("C11"),
          .C33 = constant("C33"),
          .C12 = constant("C12"),
          .C13 = constant("C13"),
          .C44 = constant("C44")};
}
inline TransverselyIsotropic isotropic(double K, double G) {
  return {.C11 = K + 4 * G / 3, .C33 = K + 4 * G / 3, .C12 = K - 2 * G / 3, .C13 = K - 2 * G / 3, .C44 = G};
}

/// A record without the means over contacts has equal grains, of R = 0.5 mm.
inline State state(const Entry& row, const std::string& contact, double tangential_ratio) {
  const double radius = row.has("R_m") ? row("R_m") : 0.5e-3;
  granum::sizes::ContactMeans contacts;
  if (row.has("branch"))
    contacts = {.branch = row("branch"),
                .branch_square = row("branch_square"),
                .pair_radius = row("pair_radius"),
                .grain_volume = row("grain_volume")};
  const bool sheared = row.has("stress_v_Pa");
  return {.law = law(contact, radius * contacts.pair_radius),
          .tangential_ratio = tangential_ratio,
          .radius = radius,
          .void_ratio = row("e"),
          .coordination_number = row("C_n"),
          .fabric_anisotropy = sheared ? row("a") : 0,
          .stress_v = row(sheared ? "stress_v_Pa" : "p_contacts_Pa"),
          .stress_h = row(sheared ? "stress_h_Pa" : "p_contacts_Pa"),
          .contacts = contacts};
}

/// Of the mean force, over the diameter.
inline double relative_overlap(const State& state) {
  return state.law.overlap(granum::effective::mean_contact_force(state)) /
         (2 * state.radius * state.contacts.branch);
}

/// What the branches that overlaps leave make of a modulus of uniform strain.
inline double shortening(const Packing& p) {
  return granum::effective::kernel::shortened_branches(p.relative_overlap, p.exponent());
}

/// K of uniform strain in closed form, of the same contacts or of contacts all at the mean force [Pa].
inline double closed_strain_bulk_modulus(const Packing& p, bool at_mean_force = false) {
  State state = p.state;
  if (at_mean_force) {
    state.fabric_anisotropy = 0;
    state.stress_v = state.stress_h = state.mean_stress();
  }
  return granum::effective::uniform_strain(state).stiffness.bulk_modulus() * shortening(p);
}

/// What every record has of a packing.
inline Packing packing(const Entry& row, const std::string& contact, const std::string& preparation,
                       double tangential_ratio) {
  const std::string sizes = row.has("sizes") ? row.text("sizes") : "equal";
  const std::string recipe = contact + " " + unsheared(preparation) + " " + sizes;
  const int seed = static_cast<int>(row("seed"));
  Packing p{.sizes = sizes,
            .contact = contact,
            .preparation = preparation,
            .recipe = recipe,
            .specimen = recipe + " " + std::to_string(seed),
            .seed = seed,
            .friction_coefficient = row.has("friction_coefficient") ? row("friction_coefficient") : 0,
            .state = state(row, contact, tangential_ratio),
            .mechanical_coordination = row("z_star"),
            .rattler_fraction = row("rattler_fraction")};
  p.relative_overlap = relative_overlap(p.state);
  return p;
}

/// Of a packing that was compressed along a path, without its networks.
inline Packing packing_of_path(const Entry& row) {
  Packing p = packing(row, row.text("contact"), row.text("preparation"), no_slip_ratio);
  p.pressure = row("p_Pa");
  p.stress_ratio = row("stress_ratio");
  p.affine_share = row("force_moment_b");
  p.strain_bulk_modulus = stiffness(row, "affine").bulk_modulus();
  if (p.sizes != "equal")
    p.affine_share = p.strain_bulk_modulus / closed_strain_bulk_modulus(p);
  p.unevenness = std::log(p.strain_bulk_modulus / closed_strain_bulk_modulus(p, true));
  return p;
}

/// Networks of one k_t/k_n and isotropic moduli. Q is of G under uniform strain, recorded and in closed form.
inline void add_isotropic_network(Packing& p, const Entry& row, const char* G_of_contacts,
                                  const char* G_of_closed_form) {
  p.unevenness = std::log(row(G_of_contacts) / row(G_of_closed_form) / shortening(p));
  p.networks = {{p.state.tangential_ratio, isotropic(row("K_network_Pa"), row("G_network_Pa"))}};
}

} // namespace detail

inline std::vector<Packing> read_packings(const std::string& path) {
  std::vector<Packing> packings;
  for (const Entry& row : read_record(path)) {
    Packing& p = packings.emplace_back(detail::packing_of_path(row));
    for (const double ratio : solved_ratios)
      p.networks.push_back({ratio, detail::stiffness(row, granum::short_text(ratio, 3))});
  }
  return packings;
}

/// Spheres of six gradations, a record of gradation_run. Grains of another mean size are left out: those
/// packings are the same but for their scale.
inline std::vector<Packing> read_gradations(const std::string& path) {
  std::vector<Packing> packings;
  for (const Entry& row : read_record(path))
    if (row("mean_radius_m") == 0.5e-3) {
      Packing& p = packings.emplace_back(detail::packing(row, "sphere", row.text("preparation"),
                                                         granum::contact::mindlin_stiffness_ratio(0.15)));
      p.pressure = 100e3;
      p.affine_share = 1;
      p.strain_bulk_modulus = detail::closed_strain_bulk_modulus(p);
      detail::add_isotropic_network(p, row, "G_affine_Pa", "G_uniform_strain_Pa");
    }
  return packings;
}

/// States of `granum verify`. Dense ones were made without friction, loose ones with that of Table 1 of the
/// paper.
inline std::vector<Packing> read_verify_states(const std::string& path) {
  constexpr double friction_of_the_paper = 0.4986;
  std::vector<Packing> packings;
  for (const Entry& row : read_record(path)) {
    Packing& p =
        packings.emplace_back(detail::packing(row, row.text("contact"), row.text("density"), no_slip_ratio));
    p.pressure = row("p_Pa");
    p.friction_coefficient = p.preparation == "dense" ? 0 : friction_of_the_paper;
    detail::add_isotropic_network(p, row, "G_uniform_strain_Pa", "G_closed_Pa");
  }
  return packings;
}

} // namespace relaxation
