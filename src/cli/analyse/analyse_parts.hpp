// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a measurement as lists of columns: JSON has all of their numbers, the table of frames those
// with a heading.
#pragma once

#include "analyse.hpp"

namespace granum::cli {

/// What is counted without knowing the contacts, and what needs them.
[[nodiscard]] const io::Columns<analysis::Counts>& grain_count_columns();
[[nodiscard]] const io::Columns<analysis::Counts>& contact_count_columns();
[[nodiscard]] const io::Columns<analysis::Fabric>& fabric_columns();
[[nodiscard]] const io::Columns<packing::ContactStress>& stress_columns();
[[nodiscard]] const io::Columns<analysis::Forces>& force_columns();
/// Headings are beginnings, which the name of a rung ends.
[[nodiscard]] const io::Columns<Moduli>& modulus_columns();

} // namespace granum::cli
