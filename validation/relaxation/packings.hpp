// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded states of validation/relaxation as the fits want them.
#pragma once

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

namespace relaxation {

using granum::effective::State;
using granum::elastic::TransverselyIsotropic;

/// The elastic contacts of one packing at one k_t/k_n.
struct Network {
  double ratio = 0; ///< k_t/k_n
  TransverselyIsotropic stiffness;
};

/// One row of states.csv or of unequal.csv.
struct Packing {
  std::string sizes = "equal"; ///< of the grains, as sizes::parse_distribution reads it
  std::string contact;
  std::string preparation;
  std::string
      recipe; ///< all three, however the packing was sheared; its packings differ less than recipes do
  std::string specimen; ///< rows of one specimen are not independent of one another
  int seed = 0;
  double pressure = 0; ///< nominal [Pa]
  double stress_ratio = 0;
  double friction_coefficient = 0;
  State state; ///< k_t/k_n of the specimen
  double mechanical_coordination = 0;
  double rattler_fraction = 0;
  double uniformity = 1;   ///< C_u of the grains
  double affine_share = 0; ///< uniform strain with the network's own k_n over the closed form: <f^b>/<f>^b of
                           ///< equal grains; of unequal ones what long branches and the scatter of k_n do too
  double strain_bulk_modulus = 0; ///< K of the network under uniform strain [Pa]
  double relative_overlap = 0;    ///< of the mean force, over the diameter
  std::vector<Network> networks;

  [[nodiscard]] double exponent() const { return state.law.stiffness_exponent(); }
  [[nodiscard]] bool isotropic() const { return stress_ratio == 0; }
};

inline double isotropic_shear_modulus(const TransverselyIsotropic& c) {
  return (2 * c.C44 + c.C66()) / 5 + (2 * c.C11 + c.C33 - c.C12 - 2 * c.C13) / 15;
}

/// What uniform strain with the network's own stiffnesses makes too much of, times what that differs from the
/// closed form: G over that of the closed form. Of equal grains the lengths of the branches drop out.
inline double shear_factor(const Packing& p, const Network& n) {
  const double affine = 0.3 * p.strain_bulk_modulus * (2 + 3 * n.ratio);
  return p.affine_share * isotropic_shear_modulus(n.stiffness) / affine;
}
inline double bulk_factor(const Packing& p, const Network& n) {
  return p.affine_share * n.stiffness.bulk_modulus() / p.strain_bulk_modulus;
}

/// A shape that the fits leave out altogether, to see how they do between the others.
inline constexpr const char* unfitted_contact = "alpha4";

namespace detail {

inline std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',')
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

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

} // namespace detail

/// A preparation without the path on which its specimens were sheared.
inline std::string unsheared(const std::string& preparation) {
  for (const char* path : {" txc", " txe"})
    if (preparation.ends_with(path))
      return preparation.substr(0, preparation.size() - 4);
  return preparation;
}

namespace detail {

using Row = std::map<std::string, double>;

/// Numbers of a row by their headings; text is left out.
inline Row numbers(const std::vector<std::string>& headings, const std::vector<std::string>& fields) {
  static const std::set<std::string> text{"sizes", "contact", "preparation"};
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
  if (sizes != "equal")
    p.affine_share =
        p.strain_bulk_modulus / granum::effective::uniform_strain(p.state).stiffness.bulk_modulus();
  p.relative_overlap = p.state.law.overlap(granum::effective::mean_contact_force(p.state)) /
                       (2 * p.state.radius * p.state.contacts.branch);
  for (const auto& [name, ratio] : ratios)
    p.networks.push_back({ratio, stiffness(row, name)});
  return p;
}

} // namespace detail

inline std::vector<Packing> read_packings(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line))
    throw std::runtime_error("cannot read " + path);
  const std::vector<std::string> headings = detail::split(line);
  const std::size_t contact = headings.front() == "sizes" ? 1 : 0; // its column
  std::vector<Packing> packings;
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = detail::split(line);
    if (fields.size() != headings.size())
      throw std::runtime_error("row of another length: " + line.substr(0, 60));
    packings.push_back(detail::packing(detail::numbers(headings, fields), contact == 1 ? fields[0] : "equal",
                                       fields[contact], fields[contact + 1]));
  }
  return packings;
}

struct PackingsByUse {
  std::vector<Packing> fitted;
  std::vector<Packing> unfitted; ///< of the shape that is left out
};

inline PackingsByUse split_by_use(const std::vector<Packing>& packings) {
  PackingsByUse split;
  for (const Packing& p : packings)
    (p.contact == unfitted_contact ? split.unfitted : split.fitted).push_back(p);
  return split;
}

} // namespace relaxation
