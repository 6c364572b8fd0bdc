// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace granum {

/// Notes on a value that is possible but lies outside the range for which its formula was derived or
/// measured.
/// Empty: no notes. The program prints the notes as warnings; `--strict` makes them an error.
struct Validity {
  std::vector<std::string> notes;

  [[nodiscard]] bool ok() const { return notes.empty(); }
  void add(std::string note) { notes.push_back(std::move(note)); }
  /// Skips notes that are already present.
  void keep_each_once() {
    std::vector<std::string> once;
    for (std::string& note : notes)
      if (std::find(once.begin(), once.end(), note) == once.end())
        once.push_back(std::move(note));
    notes = std::move(once);
  }
  void merge(const Validity& other) { notes.insert(notes.end(), other.notes.begin(), other.notes.end()); }
};

} // namespace granum
