// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include <granum/io/csv/table.hpp>
#include <granum/sizes/distribution.hpp>

namespace granum::io {

/// The sieve curve in a table: a column d with its unit (d_mm) and one of the passing mass, as passing_%
/// or, from 0 to 1, as passing. Rows ascend in d or descend, from or to 0 % and 100 %. Further columns are
/// left alone.
/// \return   points of ascending d, without a fault of sizes::find_fault
/// \throws   FileError naming the line of the point that is at fault, or as CsvTable
/// Checked by tests/io/csv/test_sieve.cpp, tests/fuzz/sieve.cpp
[[nodiscard]] std::vector<sizes::SievePoint> sieve_curve(const CsvTable& table);

/// The same of a file.
/// \throws   FileError also if it cannot be read
[[nodiscard]] std::vector<sizes::SievePoint> read_sieve_curve(const std::filesystem::path& path);

} // namespace granum::io
