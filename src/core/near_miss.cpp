// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/near_miss.hpp>

#include <algorithm>
#include <cctype>

namespace granum {

namespace {

std::string plain(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    c = c == '_' || c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

template <class Fits>
std::vector<std::string> those(std::span<const std::string> known, const Fits& fits) {
  std::vector<std::string> found;
  for (const std::string& word : known)
    if (fits(plain(word)))
      found.push_back(word);
  return found;
}

} // namespace

std::size_t slips_between(std::string_view a, std::string_view b) {
  // rows of the table of distances between the beginnings of a and of b: two back, one back, this one
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}

bool same_word(std::string_view a, std::string_view b) { return plain(a) == plain(b); }

std::vector<std::string> near_misses(std::string_view word, std::span<const std::string> known) {
  const std::string typed = plain(word);
  std::vector<std::string> found = those(known, [&](const std::string& name) { return name == typed; });
  if (found.empty() && typed.size() >= 3)
    found = those(known, [&](const std::string& name) { return name.starts_with(typed); });
  const auto begins_word = [&](const std::string& name) {
    return name.size() >= 3 && typed.starts_with(name);
  };
  if (found.empty())
    found = those(known, begins_word);
  const auto ends = [&](const std::string& name) {
    return name.ends_with("." + typed) || name.ends_with("-" + typed);
  };
  if (found.empty() && typed.size() >= 3)
    found = those(known, ends);
  for (std::size_t slips = 1; found.empty() && slips <= (typed.size() + 2) / 4; ++slips)
    found = those(known, [&](const std::string& name) { return slips_between(typed, name) == slips; });
  return found;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::vector<std::string> near = near_misses(word, known);
  if (near.empty() || near.size() > 3)
    return {};
  std::string text = "; did you mean " + near[0];
  for (std::size_t k = 1; k < near.size(); ++k)
    text += (k + 1 < near.size() ? ", " : " or ") + near[k];
  return text + "?";
}

std::string unknown_word(std::string_view kind, std::string_view word, std::span<const std::string> known) {
  std::string text = std::string(kind) + " '" + std::string(word) + "' is unknown";
  const std::string question = did_you_mean(word, known);
  if (!question.empty())
    return text + question;
  for (const std::string& name : known)
    text += (&name == known.data() ? "; known are " : ", ") + name;
  return text;
}

} // namespace granum
