// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/text/file_names.hpp>

#include <algorithm>
#include <cstddef>

namespace granum::io {

namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

/// A letter or digit; parts of letters beyond ASCII count as such.
bool in_word(char c) {
  return digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Takes the digits off the front of a text, without zeros in front.
std::string_view leading_digits(std::string_view& text) {
  const auto end = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), digit) - text.begin());
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

/// The name with every number, decimal ones too, as one '#'.
std::string without_numbers(std::string_view name) {
  std::string out;
  for (std::size_t k = 0; k < name.size(); ++k) {
    if (!digit(name[k])) {
      out += name[k];
      continue;
    }
    out += '#';
    while (k + 1 < name.size() &&
           (digit(name[k + 1]) || (name[k + 1] == '.' && k + 2 < name.size() && digit(name[k + 2]))))
      ++k;
  }
  return out;
}

/// How many characters all names begin with, up to the end of a word.
template <class Characters>
std::size_t common_words(const std::vector<std::string>& names, const Characters& characters) {
  const std::string first = characters(names.front());
  std::size_t common = first.size();
  for (const std::string& name : names) {
    const std::string other = characters(name);
    const auto end = std::mismatch(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(common),
                                   other.begin(), other.end());
    common = static_cast<std::size_t>(end.first - first.begin());
  }
  while (common > 0 && in_word(first[common - 1]))
    --common;
  return common;
}

} // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (digit(a.front()) && digit(b.front())) {
      const std::string_view x = leading_digits(a), y = leading_digits(b);
      if (x != y)
        return x.size() != y.size() ? x.size() < y.size() : x < y;
      continue;
    }
    if (a.front() != b.front())
      return a.front() < b.front();
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty())
    return a.empty();
  return whole_a < whole_b; // 7 and 007
}

std::vector<std::string> series_by_name(const std::vector<std::string>& files) {
  std::vector<std::string> keys;
  for (const std::string& file : files)
    keys.push_back(without_numbers(file));
  if (std::all_of(keys.begin(), keys.end(), [&](const std::string& key) { return key == keys.front(); })) {
    const std::string name = files.empty() ? "" : files.front().substr(files.front().find_last_of('/') + 1);
    return std::vector<std::string>(files.size(), name);
  }
  const std::size_t front = common_words(keys, [](const std::string& key) { return key; });
  const std::size_t back =
      common_words(keys, [](const std::string& key) { return std::string(key.rbegin(), key.rend()); });
  std::vector<std::string> out;
  for (const std::string& key : keys)
    out.push_back(front + back < key.size() ? key.substr(front, key.size() - front - back) : key);
  return out;
}

} // namespace granum::io
