// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/sizes/contact_means.hpp>

/// Moduli of many packings in one call.
namespace granum::effective {

/// One input of a batch: the same value for every row, or one for each row. Refers to the caller's values.
class BatchInput {
 public:
  BatchInput(double value) : value_(value) {}                                   // NOLINT: meant to convert
  BatchInput(std::span<const double> values) : values_(values) {}               // NOLINT: meant to convert
  BatchInput(const std::vector<double>& values) : values_(std::span(values)) {} // NOLINT: meant to convert

  [[nodiscard]] bool varies() const { return values_.has_value(); }
  /// Number of rows of a column that varies.
  [[nodiscard]] std::size_t size() const { return values_ ? values_->size() : 0; }
  [[nodiscard]] double operator[](std::size_t row) const { return values_ ? (*values_)[row] : value_; }
  /// The values of a column that varies.
  [[nodiscard]] std::span<const double> values() const { return values_.value_or(std::span<const double>{}); }

 private:
  double value_ = 0;
  std::optional<std::span<const double>> values_;
};

/// Isotropic packings that share their contact law and the sizes of their grains.
struct PackingBatch {
  contact::NormalLaw law;            ///< normal contact of two grains, of the mean pair
  double tangential_ratio;           ///< k_t/k_n >= 0
  double radius;                     ///< R > 0 of a grain, or the radius that `contacts` refer to [m]
  BatchInput pressure;               ///< p in [0, 1e200] [Pa]
  BatchInput coordination_number;    ///< C_n in [0, 1e6], over all grains
  BatchInput porosity;               ///< voids in the volume, in (0, 1); e/(1+e)
  sizes::ContactMeans contacts = {}; ///< default: equal grains
};

/// Memory for the results of a batch, one element per row. It may be the memory of an input, from its first
/// row on, but no shifted part of it.
struct ModuliColumns {
  std::span<double> bulk_modulus;  ///< K [Pa]
  std::span<double> shear_modulus; ///< G [Pa]
};

/// A row that was refused.
struct RowError {
  std::size_t row = 0;
  std::string message;
};

/// Summary of a batch.
struct [[nodiscard]] BatchReport {
  static constexpr std::size_t most_errors = 1000;

  std::size_t failed = 0;       ///< rows without a result: their moduli are set to 0
  std::vector<RowError> errors; ///< of the first most_errors of them

  [[nodiscard]] bool ok() const { return failed == 0; }
};

/// K and G under uniform strain of isotropic packings at isotropic stress, as uniform_strain(State): K =
/// C_n k_n/(6 pi R (1+e)) at the mean contact force (equal grains), G = 3 (2 + 3 k_t/k_n)/10 K. [Walton1987]
/// A row with impossible numbers is refused and reported; the others are computed. Zero pressure gives 0
/// (the flat punch keeps its stiffness), as does a coordination number of 0.
/// \param    packings   columns that vary must have the length of the results
/// \param    moduli     both of one length
/// \throws   InvalidArgument for lengths that differ, and for a ratio or radius out of range
/// Accuracy  relative 1e-14 of uniform_strain(State), from C_n (1 - porosity) = 1e-15 on. The vector level
///           (AVX-512, AVX2 with FMA, or none) is chosen when the program starts; all give the same bits.
/// Checked by tests/effective/test_batch.cpp, tests/core/vector/test_cube_root.cpp and test_power.cpp; timed
/// by bench/
BatchReport uniform_strain(const PackingBatch& packings, const ModuliColumns& moduli);

} // namespace granum::effective
