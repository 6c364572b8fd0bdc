// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded states of validation/relaxation as the fits want them.
#pragma once

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

namespace relaxation {

using granum::effective::State;
using granum::elastic::TransverselyIsotropic;

/// The elastic contacts of one packing at one k_t/k_n.
struct Network {
  double ratio = 0; ///< k_t/k_n
  TransverselyIsotropic stiffness;
};

/// One row of states.csv.
struct Packing {
  std::string contact;
  std::string preparation;
  std::string recipe;   ///< both, however the packing was sheared; its packings differ less than recipes do
  std::string specimen; ///< rows of one specimen are not independent of one another
  int seed = 0;
  double pressure = 0; ///< nominal [Pa]
  double stress_ratio = 0;
  double friction_coefficient = 0;
  State state; ///< k_t/k_n of the specimen
  double mechanical_coordination = 0;
  double rattler_fraction = 0;
  double force_moment = 0;        ///< <f^b>/<f>^b
  double strain_bulk_modulus = 0; ///< K of the network under uniform strain [Pa]
  double relative_overlap = 0;    ///< of the mean force, over the diameter
  std::vector<Network> networks;

  [[nodiscard]] double exponent() const { return state.law.stiffness_exponent(); }
  [[nodiscard]] bool isotropic() const { return stress_ratio == 0; }
};

inline double isotropic_shear_modulus(const TransverselyIsotropic& c) {
  return (2 * c.C44 + c.C66()) / 5 + (2 * c.C11 + c.C33 - c.C12 - 2 * c.C13) / 15;
}

/// What uniform strain with the network's own stiffnesses makes too much of, times what the mean of f^b
/// differs from <f>^b: G over that of the closed form. The lengths of the branches drop out.
inline double shear_factor(const Packing& p, const Network& n) {
  const double affine = 0.3 * p.strain_bulk_modulus * (2 + 3 * n.ratio);
  return p.force_moment * isotropic_shear_modulus(n.stiffness) / affine;
}
inline double bulk_factor(const Packing& p, const Network& n) {
  return p.force_moment * n.stiffness.bulk_modulus() / p.strain_bulk_modulus;
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

inline granum::contact::PowerLaw law(const std::string& contact) {
  using granum::contact::PowerLaw;
  constexpr granum::contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  if (contact == "cone")
    return PowerLaw::cone(grain, 0.4);
  if (contact == "sphere")
    return PowerLaw::sphere(grain, 0.5e-3);
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

inline std::vector<Packing> read_packings(const std::string& path) {
  static const std::map<std::string, double> ratios{
      {"0", 0}, {"0.03", 0.03}, {"0.1", 0.1}, {"0.3", 0.3}, {"0.6", 0.6}, {"0.919", 0.918918918918919},
      {"1", 1}};
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line))
    throw std::runtime_error("cannot read " + path);
  const std::vector<std::string> headings = detail::split(line);
  std::vector<Packing> packings;
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = detail::split(line);
    if (fields.size() != headings.size())
      throw std::runtime_error("row of another length: " + line.substr(0, 60));
    std::map<std::string, double> row;
    for (std::size_t k = 2; k < fields.size(); ++k)
      row[headings[k]] = fields[k].empty() ? State::unset : std::stod(fields[k]);
    Packing p{.contact = fields[0],
              .preparation = fields[1],
              .recipe = fields[0] + " " + unsheared(fields[1]),
              .specimen = fields[0] + " " + unsheared(fields[1]) + " " + fields[2],
              .seed = static_cast<int>(row.at("seed")),
              .pressure = row.at("p_Pa"),
              .stress_ratio = row.at("stress_ratio"),
              .friction_coefficient = row.at("friction_coefficient"),
              .state = {.law = detail::law(fields[0]),
                        .tangential_ratio = ratios.at("0.919"),
                        .radius = 0.5e-3,
                        .void_ratio = row.at("e"),
                        .coordination_number = row.at("C_n"),
                        .fabric_anisotropy = row.at("a"),
                        .stress_v = row.at("stress_v_Pa"),
                        .stress_h = row.at("stress_h_Pa")},
              .mechanical_coordination = row.at("z_star"),
              .rattler_fraction = row.at("rattler_fraction"),
              .force_moment = row.at("force_moment_b"),
              .strain_bulk_modulus = detail::stiffness(row, "affine").bulk_modulus(),
              .networks = {}};
    p.relative_overlap = p.state.law.overlap(granum::effective::mean_contact_force(p.state)) / 1e-3;
    for (const auto& [name, ratio] : ratios)
      p.networks.push_back({ratio, detail::stiffness(row, name)});
    packings.push_back(std::move(p));
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
