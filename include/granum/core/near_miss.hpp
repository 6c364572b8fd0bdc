// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Which known word was meant by one that is not known. Checked by tests/core/test_near_miss.cpp
namespace granum {

/// How many letters are wrong, missing, too many, or two neighbours the wrong way round: the least number of
/// such slips that make `a` of `b` (optimal string alignment).
[[nodiscard]] std::size_t slips_between(std::string_view a, std::string_view b);

/// Whether two words differ at most in case, and in a blank, _ or - between their parts.
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);

/// The known words that `word` may have been meant for, in their order. The first of these rules that finds
/// any: the same word; of three letters or more, those that begin with it,
/// those that it begins with, those of which it is the last part behind a point or hyphen; those with the
/// fewest slips, one for two to five letters and one more for every four.
[[nodiscard]] std::vector<std::string> near_misses(std::string_view word, std::span<const std::string> known);

/// "; did you mean sphere?" or "; did you mean stress-v or stress-h?" for error messages; empty if no known
/// word is near, or more than three are.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> known);

/// "sand 'toyura' is unknown; did you mean toyoura?", or the list of the known words where none is near.
[[nodiscard]] std::string unknown_word(std::string_view kind, std::string_view word,
                                       std::span<const std::string> known);

} // namespace granum
