// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the head of every page.
#pragma once

namespace granum::plot {

[[nodiscard]] const char* page_style();
[[nodiscard]] const char* page_script();

} // namespace granum::plot
