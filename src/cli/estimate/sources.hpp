// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace granum::cli {

/// The entries of validation/references.bib whose keys occur in a text, in the order of the bibliography:
/// "Menq2003: Menq, F. Y. (2003): ...".
[[nodiscard]] std::vector<std::string> sources_in(std::string_view text);

} // namespace granum::cli
