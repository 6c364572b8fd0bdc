// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include <granum/contact/normal_law.hpp>
#include <granum/core/numerics.hpp>
#include <granum/packing/assembly.hpp>

/// The contact law that a DEM code has used, as its forces and overlaps show it.
/// Checked by tests/analysis/test_law_check.cpp
namespace granum::analysis {

/// The contact law of two equal grains of a material and a radius [m]; contact::PowerLaw::sphere is one.
using LawFamily = std::function<contact::NormalLaw(const contact::GrainMaterial& grain, double radius)>;

/// f_n against the overlap d of all contacts that press. Contacts of two sizes count as the contact of equal
/// spheres with the same 1/R_i + 1/R_j, and f_n/R^2 goes as (d/R)^(1+1/alpha): all of similar grains lie on
/// one line.
struct LawCheck {
  std::size_t contacts = 0; ///< compared
  std::size_t left_out = 0; ///< without overlap or force, or with less than 1e-3 of the mean force
  /// 1 + 1/alpha, the slope of ln f_n over ln d by least squares, twice: the second time without the contacts
  /// that lie further from the first line than ten times the median; empty if the overlaps are all equal or
  /// there are fewer than 3.
  std::optional<Measured> force_exponent = {};
  /// alpha = 1/(slope - 1); empty unless the slope is above 1 by more than its error: punches have 1.
  std::optional<Measured> alpha = {};
  /// Median of f_n over the law's force at the overlap [1]; empty if the grains' modulus is not known.
  std::optional<double> coefficient_ratio = {};
  /// |f_n/(median ratio * force) - 1|, the part not explained by the law's shape [1]
  double median_misfit = 0;
  double misfit_90 = 0; ///< of 90 % of the contacts
  double worst_misfit = 0;
};

/// Compares the forces with a law.
/// \param    family   contact law of two grains
/// \param    grain    their material
/// \return   contacts = 0 if none has both force and overlap; the other numbers are then meaningless
/// \throws   InvalidArgument for an assembly that require_valid rejects or a material that the law refuses
/// Accuracy  the slope of forces that obey a power law: 1e-9 for overlaps of 17 digits over a decade.
[[nodiscard]] LawCheck check_law(const packing::Assembly& assembly, const LawFamily& family,
                                 const contact::GrainMaterial& grain);

/// The same for grains of several materials, each contact by the law of contact::pair_material of its grains.
/// \param    materials  one for each grain
[[nodiscard]] LawCheck check_law(const packing::Assembly& assembly, const LawFamily& family,
                                 std::span<const contact::GrainMaterial> materials);

/// The exponent x of f_n ~ d^x whatever the factor: contacts between grains of the same two types are
/// compared with each other alone, as each pair of materials has a factor of its own.
/// \param    type   of each grain; empty: all contacts are compared with each other
/// \return   with its standard error; empty for fewer than 10 contacts, or for nearly equal overlaps
/// \throws   InvalidArgument for an assembly that require_valid rejects, or unless there is one type a grain
/// Checked by tests/analysis/test_law_check.cpp
[[nodiscard]] std::optional<Measured> common_exponent(const packing::Assembly& assembly,
                                                      std::span<const long> type = {});

/// The one material whose k_n of spheres is, in the mean over the contacts, that of contacts with k_n = 1.5
/// f/d: (G/(1-nu))^(2/3) is the mean over the contacts, from force and overlap.
/// \return   empty if no contact has both force and overlap
/// \throws   InvalidArgument for an assembly that require_valid rejects or a Poisson's ratio out of range
[[nodiscard]] std::optional<contact::GrainMaterial> mean_material_of_forces(const packing::Assembly& assembly,
                                                                            double poisson_ratio);

/// How far overlaps are rounded, as a part of their median.
/// \param    rounding   of each overlap [m]
/// \return   0 for no rounding, or where no contact has force and overlap
[[nodiscard]] double rounded_share(const packing::Assembly& assembly, double rounding);

/// The spring that all contacts have in common, where forces are linear in the overlaps.
/// \return   k_n, the median of f_n/d [N/m]; empty unless nine of ten contacts are within 1e-3 of it, and
///           for overlaps that hardly differ: every law is linear there
/// Checked by tests/studies/test_materials.cpp
[[nodiscard]] std::optional<double> linear_spring(const packing::Assembly& assembly);

} // namespace granum::analysis
