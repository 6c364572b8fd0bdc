// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "studies/verify/seed_mean.hpp"
#include "studies/verify/study.hpp"
#include <granum/io/csv/columns.hpp>

namespace granum::studies {

/// Local exponents d ln G/d ln p between two neighbouring pressures, by every method, for contact laws with a
/// scale of force: the mean over the seeds, with the standard error from their scatter.
struct LocalExponents {
  contact::Shape contact = contact::Shape::rough;
  triaxial::Density density = triaxial::Density::dense;
  double pressure = 0;               ///< the geometric mean of both [Pa]
  std::optional<double> transition;  ///< p* from rough to smooth contact [Pa]
  double contact_law = 0;            ///< b at the mean force
  TableValue uniform_strain;         ///< closed form with the measured C_n and e
  std::optional<TableValue> relaxed; ///< rung 3 with z* as well; where z* permits one
  std::optional<TableValue> network;
  std::optional<TableValue> probe; ///< where both pressures were probed
};

/// Rows in the order contact, density, pressure; none for laws with a constant b.
/// Checked by tests/studies/test_local_exponents.cpp
[[nodiscard]] std::vector<LocalExponents> local_exponents(const Scene& scene,
                                                          const std::vector<SpecimenResult>& specimens);

/// Their columns, from which CSV, JSON and screen are written.
[[nodiscard]] io::Columns<LocalExponents> local_exponent_columns();

} // namespace granum::studies
