// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// States of a series from the names of files.
/// Checked by tests/io/text/test_file_names.cpp
namespace granum::io {

/// Whether one name comes before another as people count: numbers in them by their value, p50 before p100.
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

/// Which of some files belong together: those whose names, folders included, differ in numbers alone, as
/// dense_p50 and dense_p100 do, or dense/state.10 and dense/state.20.
/// \return   for each file the name of its series, the part that distinguishes it from others: "dense",
///           "loose"; where there is one series, the name of the first file without its folder
[[nodiscard]] std::vector<std::string> series_by_name(const std::vector<std::string>& files);

} // namespace granum::io
