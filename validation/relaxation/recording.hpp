// SPDX-License-Identifier: GPL-3.0-or-later
// What validation/relaxation records of a packing at rest, and the file that it goes to, which
// validation/gradation and validation/mixtures fill the same way.
#pragma once

#include <filesystem>
#include <fstream>
#include <mutex>

#include <granum/analysis/measure.hpp>
#include <granum/analysis/parts.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/packing/forces.hpp>

#include "../common.hpp"
#include "contact_counts.hpp"
#include "packings.hpp"

namespace relaxation {

using namespace granum;

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
    add(heading, std::isnan(value) ? std::string() : short_text(value, 7));
  }
  void add(std::initializer_list<std::pair<std::string, double>> numbers) {
    for (const auto& [heading, value] : numbers)
      add(heading, value);
  }
};

inline std::string short_number(double value) { return short_text(value, 3); }

inline void add_stiffness(Row& row, const std::string& suffix, const elastic::VoigtStiffness& stiffness) {
  const elastic::TransverselyIsotropic c = elastic::transversely_isotropic_projection(stiffness);
  row.add({{"C11_" + suffix + "_Pa", c.C11},
           {"C33_" + suffix + "_Pa", c.C33},
           {"C12_" + suffix + "_Pa", c.C12},
           {"C13_" + suffix + "_Pa", c.C13},
           {"C44_" + suffix + "_Pa", c.C44}});
}

inline void set_tangential_ratio(packing::Assembly& assembly, double ratio) {
  for (packing::Contact& contact : assembly.contacts)
    contact.tangential_stiffness = ratio * contact.normal_stiffness;
}

/// The packing stays; only the tangential stiffness of its elastic contacts is another.
inline void add_networks(Row& row, packing::Assembly assembly, double own_ratio) {
  int iterations = 0;
  double residual = 0;
  network::ResponseOptions options;
  for (const double ratio : solved_ratios) {
    set_tangential_ratio(assembly, ratio);
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
  row.add({{"iterations", iterations}, {"residual", residual}});

  set_tangential_ratio(assembly, own_ratio);
  add_stiffness(row, "affine", network::linear_response(assembly).affine());
  options.prestress = true;
  const network::Response stressed = network::linear_response(assembly, options);
  const double known = stressed.converged() ? 1 : std::numeric_limits<double>::quiet_NaN();
  const elastic::Matrix6& c = stressed.last_iterate().matrix;
  row.add({{"C44_prestress_Pa", known * (c(3, 3) + c(4, 4)) / 2}, {"C66_prestress_Pa", known * c(5, 5)}});
}

/// K and G of whole networks over those of uniform strain as in closed forms, which count some of the
/// contacts and take k_n at their mean force.
class CountedPacking {
 public:
  CountedPacking(const packing::Assembly& assembly, const contact::NormalLaw& law)
      : whole_(assembly), counted_(analysis::counted_part(assembly, law)), law_(law) {
    for (const packing::Contact& contact : counted_.contacts)
      mean_force_ += contact.normal_force / static_cast<double>(counted_.contacts.size());
    at_mean_ = law.stiffness_at_force(mean_force_);
  }
  void add_to(Row& row) const {
    constexpr double ratios[] = {0.3, 0.6, no_slip_ratio};
    row.add("force_moment_2", normal_force_moment(counted_, 2));
    if (!law_.constant_exponent())
      row.add("b", law_.exponent_at_force(mean_force_));
    for (const double ratio : ratios)
      if (law_.constant_exponent()) // k_n ~ f^b: the stiffness at the mean force stays
        for (const double b : {0.0, 1.0 / 3, 0.5, 2.0 / 3, 0.8, 1.0})
          add_moduli(row, short_number(b), ratio,
                     [&](double force) { return at_mean_ * std::pow(force / mean_force_, b); });
      else
        add_moduli(row, "own", ratio, [&](double force) { return law_.stiffness_at_force(force); });
  }

 private:
  template <class StiffnessOfForce>
  void add_moduli(Row& row, const std::string& suffix, double ratio,
                  const StiffnessOfForce& stiffness) const {
    packing::Assembly alike = counted_, own = whole_;
    for (packing::Contact& contact : alike.contacts)
      contact.normal_stiffness = at_mean_;
    for (packing::Contact& contact : own.contacts)
      contact.normal_stiffness = stiffness(contact.normal_force);
    set_tangential_ratio(alike, ratio);
    set_tangential_ratio(own, ratio);
    const elastic::Isotropic strained =
        elastic::isotropic_projection(network::linear_response(alike, {.iteration_limit = 1}).affine());
    const network::Response response = network::linear_response(own, {.iteration_limit = 20000});
    if (!response.converged())
      throw std::runtime_error("a network did not converge");
    const elastic::Isotropic relaxed = elastic::isotropic_projection(response.last_iterate());
    const std::string name = "_" + suffix + "_" + short_number(ratio);
    row.add({{"K" + name, relaxed.bulk_modulus() / strained.bulk_modulus()},
             {"G" + name, relaxed.shear_modulus() / strained.shear_modulus()}});
  }

  const packing::Assembly& whole_;
  packing::Assembly counted_;
  const contact::NormalLaw& law_;
  double mean_force_ = 0, at_mean_ = 0;
};

inline analysis::Measurement measured(const packing::Assembly& assembly, const dem::Material& material) {
  return analysis::measure(assembly, {.law = material.law, .tangential_ratio = material.tangential_ratio});
}

/// \param    frictionless   whether the counts of contacts without friction are added
inline void add_counts(Row& row, const packing::Assembly& assembly, const dem::Material& material,
                       bool frictionless) {
  const analysis::Measurement all = measured(assembly, material);
  const analysis::Microstructure micro = all.microstructure();
  row.add({{"C_n", micro.coordination_number},
           {"z_star", micro.mechanical_coordination_number},
           {"rattler_fraction", micro.rattler_fraction}});
  if (frictionless) {
    const auto counts = mechanical_coordination(assembly, packing::ContactKind::frictionless);
    row.add({{"z_star_frictionless", counts.coordination_number},
             {"rattler_fraction_frictionless", counts.rattler_fraction}});
  }
  const Mat3& stress = all.stress.value().symmetric;
  row.add({{"a", micro.fabric_anisotropy},
           {"stress_v_Pa", stress(2, 2)},
           {"stress_h_Pa", (stress(0, 0) + stress(1, 1)) / 2}});
}

inline void add_assembly(Row& row, const packing::Assembly& assembly, const dem::Material& material) {
  const packing::BulkModulusBounds bounds = bulk_modulus_bounds(assembly);
  const double b = material.law.constant_exponent().value();
  add_counts(row, assembly, material, true);
  row.add({{"force_moment_b", normal_force_moment(assembly, b)},
           {"force_moment_2", normal_force_moment(assembly, 2)},
           {"force_moment_2_minus_b", normal_force_moment(assembly, 2 - b)},
           {"tangential_share", mean_tangential_share(assembly)},
           {"K_lower_Pa", bounds.lower},
           {"K_upper_Pa", bounds.upper}});
}

/// Sizes of the grains, the means over contacts that closed forms take of them, and what sizes do to forces
/// and contacts.
inline void add_sizes(Row& row, const packing::Assembly& assembly, const analysis::Measurement& measured) {
  const analysis::Sizes& sizes = measured.sizes;
  row.add({{"C_u", sizes.gradation.uniformity()},
           {"R_m", sizes.equivalent},
           {"branch", sizes.contacts.branch},
           {"branch_square", sizes.contacts.branch_square},
           {"pair_radius", sizes.contacts.pair_radius},
           {"grain_volume", sizes.contacts.grain_volume},
           {"two_contact_share", two_contact_share(assembly, measured.counts.mechanical.rattler)},
           {"force_by_branch", force_by_branch(assembly)}});
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
