// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include <granum/core/references.hpp>

/// Changes of the words of a page, never of its markup, its style or its script, and its table of sources.
/// Checked by tests/cli/test_page_text.cpp
namespace granum::cli {

/// Each key of a source as a link to its row of html_sources.
[[nodiscard]] std::string with_source_links(const std::string& html, std::span<const Reference> sources);

/// "0,7" for "0.7": the decimal sign of tables with decimal commas. Names with several points, as versions
/// and files are, stay.
[[nodiscard]] std::string with_decimal_commas(const std::string& html);

/// A row for each source: key, reference with its address as a link, and what of it was not checked.
[[nodiscard]] std::string html_sources(std::span<const Reference> sources);

/// Plain text with each address, "https://...", as a link.
[[nodiscard]] std::string html_linked(std::string_view text);

} // namespace granum::cli
