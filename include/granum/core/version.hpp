// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace granum {

/// Version of the library, "major.minor.patch", as in CMakeLists.txt.
[[nodiscard]] std::string_view version();
/// Compiler that built it, name and version.
[[nodiscard]] std::string_view compiler();

} // namespace granum
