// SPDX-License-Identifier: GPL-3.0-or-later
// What validation/relaxation records of a packing at rest, and the file that it goes to, which
// validation/gradation fills the same way.
#pragma once

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/analysis/parts.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/packing/forces.hpp>

#include "contact_counts.hpp"

namespace relaxation {

using namespace granum;

inline constexpr double solved_ratios[] = {0, 0.03, 0.1, 0.3, 0.6, 0.918918918918919, 1}; ///< k_t/k_n

/// b of k_n ~ f^b, and k_t/k_n, of the networks that say what b does.
inline constexpr double solved_exponents[] = {0, 1.0 / 3, 0.5, 2.0 / 3, 0.8, 1};
inline constexpr double exponent_ratios[] = {0.3, 0.6, 0.918918918918919};

/// A row in the making: headings and cells side by side.
struct Row {
  std::string headings;
  std::string cells;

  void add(const std::string& heading, const std::string& cell) {
    const char* comma = headings.empty() ? "" : ",";
    headings += comma + heading;
    cells += comma + cell;
  }
  void add(const std::string& heading, double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.7g", value);
    add(heading, std::isnan(value) ? std::string() : std::string(text));
  }
};

inline void add_stiffness(Row& row, const std::string& suffix, const elastic::VoigtStiffness& stiffness) {
  const elastic::TransverselyIsotropic c = elastic::transversely_isotropic_projection(stiffness);
  row.add("C11_" + suffix + "_Pa", c.C11);
  row.add("C33_" + suffix + "_Pa", c.C33);
  row.add("C12_" + suffix + "_Pa", c.C12);
  row.add("C13_" + suffix + "_Pa", c.C13);
  row.add("C44_" + suffix + "_Pa", c.C44);
}

inline std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// The packing stays; only the tangential stiffness of its elastic contacts is another.
inline void add_networks(Row& row, packing::Assembly assembly, double own_ratio) {
  int iterations = 0;
  double residual = 0;
  network::ResponseOptions options;
  for (const double ratio : solved_ratios) {
    for (packing::Contact& contact : assembly.contacts)
      contact.tangential_stiffness = ratio * contact.normal_stiffness;
    // Without tangential stiffness most of the packings are floppy: no use in insisting on ten digits.
    options.iteration_limit = ratio > 0 ? 20000 : 1500;
    const network::Response response = network::linear_response(assembly, options);
    if (ratio > 0 && !response.converged())
      throw std::runtime_error("a network did not converge");
    add_stiffness(row, short_number(ratio), response.last_iterate());
    if (ratio > 0) {
      iterations = std::max(iterations, response.report().iterations);
      residual = std::max(residual, response.report().residual);
    } else {
      row.add("residual_0", response.report().residual);
    }
  }
  row.add("iterations", iterations);
  row.add("residual", residual);

  for (packing::Contact& contact : assembly.contacts)
    contact.tangential_stiffness = own_ratio * contact.normal_stiffness;
  const network::Response plain = network::linear_response(assembly);
  add_stiffness(row, "affine", plain.affine());
  options.prestress = true;
  const network::Response stressed = network::linear_response(assembly, options);
  const bool definite = stressed.converged();
  const elastic::Matrix6& c = stressed.last_iterate().matrix;
  row.add("C44_prestress_Pa", definite ? (c(3, 3) + c(4, 4)) / 2 : std::numeric_limits<double>::quiet_NaN());
  row.add("C66_prestress_Pa", definite ? c(5, 5) : std::numeric_limits<double>::quiet_NaN());
}

inline double mean_normal_force(const packing::Assembly& assembly) {
  double sum = 0;
  for (const packing::Contact& contact : assembly.contacts)
    sum += contact.normal_force;
  return sum / static_cast<double>(assembly.contacts.size());
}

/// An isotropic packing, and the part of it that closed forms count: they take k_n at its mean force.
struct CountedPacking {
  const packing::Assembly& whole;
  packing::Assembly counted;
  const contact::NormalLaw& law;

  CountedPacking(const packing::Assembly& assembly, const contact::NormalLaw& own_law)
      : whole(assembly), counted(analysis::counted_part(assembly, own_law)), law(own_law) {}
  [[nodiscard]] double mean_force() const { return mean_normal_force(counted); }
};

template <class StiffnessOfForce>
packing::Assembly stiffened(packing::Assembly assembly, const StiffnessOfForce& stiffness, double ratio) {
  for (packing::Contact& contact : assembly.contacts) {
    contact.normal_stiffness = stiffness(contact.normal_force);
    contact.tangential_stiffness = ratio * contact.normal_stiffness;
  }
  return assembly;
}

/// K and G of the whole network, in which k_n of a contact follows from its force, over those of uniform
/// strain as in closed forms: of the counted contacts, each with `at_mean`.
/// \param    suffix   of the headings, before the ratio k_t/k_n
template <class StiffnessOfForce>
void add_moduli(Row& row, const CountedPacking& packing, const StiffnessOfForce& stiffness, double at_mean,
                double ratio, const std::string& suffix) {
  const packing::Assembly alike = stiffened(
      packing.counted, [=](double) { return at_mean; }, ratio);
  const elastic::Isotropic strained =
      elastic::isotropic_projection(network::linear_response(alike, {.iteration_limit = 1}).affine());
  const network::Response response =
      network::linear_response(stiffened(packing.whole, stiffness, ratio), {.iteration_limit = 20000});
  if (!response.converged())
    throw std::runtime_error("a network did not converge");
  const elastic::Isotropic relaxed = elastic::isotropic_projection(response.last_iterate());
  const std::string name = "_" + suffix + "_" + short_number(ratio);
  row.add("K" + name, relaxed.bulk_modulus() / strained.bulk_modulus());
  row.add("G" + name, relaxed.shear_modulus() / strained.shear_modulus());
}

/// The same with k_n ~ f^b in place of the packing's own law: packing and forces stay, and so does the
/// stiffness at the mean force.
inline void add_exponents(Row& row, const CountedPacking& packing) {
  const double mean = packing.mean_force(), at_mean = packing.law.stiffness_at_force(mean);
  for (const double ratio : exponent_ratios)
    for (const double b : solved_exponents)
      add_moduli(
          row, packing, [=](double force) { return at_mean * std::pow(force / mean, b); }, at_mean, ratio,
          short_number(b));
}

/// b at the mean force, and the same with the packing's own law.
inline void add_own_law(Row& row, const CountedPacking& packing) {
  const double mean = packing.mean_force();
  row.add("b", packing.law.exponent_at_force(mean));
  for (const double ratio : exponent_ratios)
    add_moduli(
        row, packing, [&](double force) { return packing.law.stiffness_at_force(force); },
        packing.law.stiffness_at_force(mean), ratio, "own");
}

inline void add_assembly(Row& row, const packing::Assembly& assembly, const dem::Material& material) {
  const analysis::Measurement measured =
      analysis::measure(assembly, {.law = material.law, .tangential_ratio = material.tangential_ratio});
  const analysis::Microstructure micro = measured.microstructure();
  const packing::MechanicalCoordination frictionless =
      mechanical_coordination(assembly, packing::ContactKind::frictionless);
  const Mat3& stress = measured.stress.value().symmetric;
  const packing::BulkModulusBounds bounds = bulk_modulus_bounds(assembly);
  const double b = material.law.constant_exponent().value();
  row.add("C_n", micro.coordination_number);
  row.add("z_star", micro.mechanical_coordination_number);
  row.add("rattler_fraction", micro.rattler_fraction);
  row.add("z_star_frictionless", frictionless.coordination_number);
  row.add("rattler_fraction_frictionless", frictionless.rattler_fraction);
  row.add("a", micro.fabric_anisotropy);
  row.add("stress_v_Pa", stress(2, 2));
  row.add("stress_h_Pa", (stress(0, 0) + stress(1, 1)) / 2);
  row.add("force_moment_b", normal_force_moment(assembly, b));
  row.add("force_moment_2", normal_force_moment(assembly, 2));
  row.add("force_moment_2_minus_b", normal_force_moment(assembly, 2 - b));
  row.add("tangential_share", mean_tangential_share(assembly));
  row.add("K_lower_Pa", bounds.lower);
  row.add("K_upper_Pa", bounds.upper);
}

/// Sizes of the grains, the means over contacts that closed forms take of them, and what sizes do to forces
/// and contacts.
inline void add_sizes(Row& row, const packing::Assembly& assembly, const analysis::Measurement& measured) {
  const analysis::Sizes& sizes = measured.sizes;
  row.add("C_u", sizes.gradation.uniformity());
  row.add("R_m", sizes.equivalent);
  row.add("branch", sizes.contacts.branch);
  row.add("branch_square", sizes.contacts.branch_square);
  row.add("pair_radius", sizes.contacts.pair_radius);
  row.add("grain_volume", sizes.contacts.grain_volume);
  row.add("two_contact_share", two_contact_share(assembly, measured.counts.mechanical.rattler));
  row.add("force_by_branch", force_by_branch(assembly));
}

/// What one row of exponents.csv, or of rough.csv, says of a frozen isotropic state.
inline void describe_stiffening(Row& row, const dem::Specimen& frozen, const dem::Material& material) {
  const packing::Assembly assembly = dem::contact_network(frozen, material);
  const analysis::Measurement measured =
      analysis::measure(assembly, {.law = material.law, .tangential_ratio = material.tangential_ratio});
  const analysis::Microstructure micro = measured.microstructure();
  const Mat3& stress = measured.stress.value().symmetric;
  row.add("e", dem::void_ratio(frozen));
  row.add("C_n", micro.coordination_number);
  row.add("z_star", micro.mechanical_coordination_number);
  row.add("rattler_fraction", micro.rattler_fraction);
  row.add("a", micro.fabric_anisotropy);
  row.add("stress_v_Pa", stress(2, 2));
  row.add("stress_h_Pa", (stress(0, 0) + stress(1, 1)) / 2);
  const CountedPacking packing(assembly, material.law);
  row.add("force_moment_2", normal_force_moment(packing.counted, 2));
  if (material.law.constant_exponent())
    add_exponents(row, packing);
  else
    add_own_law(row, packing);
}

/// What one row says of a frozen state.
inline void describe(Row& row, const dem::Specimen& frozen, const dem::Material& material, bool with_sizes) {
  const packing::Assembly assembly = dem::contact_network(frozen, material);
  row.add("e", dem::void_ratio(frozen));
  add_assembly(row, assembly, material);
  add_networks(row, assembly, material.tangential_ratio);
  if (with_sizes)
    add_sizes(
        row, assembly,
        analysis::measure(assembly, {.law = material.law, .tangential_ratio = material.tangential_ratio}));
}

/// The output file: which states it holds, and how another is added.
class Record {
 public:
  /// \param    key_columns   so many of the first name a state
  Record(const std::filesystem::path& path, int key_columns) : path_(path), key_columns_(key_columns) {
    std::ifstream in(path);
    std::string line, whole;
    while (std::getline(in, line) && !in.eof()) { // a last line without its end was cut: it is done again
      whole += line + "\n";
      done_.insert(key_of(line));
    }
    in.close();
    std::ofstream(path) << whole;
  }
  [[nodiscard]] std::string key_of(const std::string& line) const {
    std::size_t end = 0;
    for (int field = 0; field < key_columns_ && end != std::string::npos; ++field)
      end = line.find(',', end + 1);
    return line.substr(0, end);
  }
  [[nodiscard]] bool has(const Row& row) {
    const std::lock_guard lock(mutex_);
    return done_.count(key_of(row.cells)) > 0;
  }
  void append(const Row& row) {
    const std::lock_guard lock(mutex_);
    std::ofstream out(path_, std::ios::app);
    if (done_.empty())
      out << row.headings << "\n";
    out << row.cells << "\n";
    done_.insert(key_of(row.cells));
  }

 private:
  std::filesystem::path path_;
  int key_columns_;
  std::set<std::string> done_;
  std::mutex mutex_;
};

} // namespace relaxation
