// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace granum {

/// Notes on a value that is possible but lies outside the range for which its formula was derived or
/// measured.
/// Empty: nothing to say. The program prints the notes as warnings; `--strict` makes them an error.
struct Validity {
  std::vector<std::string> notes;

  [[nodiscard]] bool ok() const { return notes.empty(); }
  void add(std::string note) { notes.push_back(std::move(note)); }
  void merge(const Validity& other) { notes.insert(notes.end(), other.notes.begin(), other.notes.end()); }
};

} // namespace granum
