// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/io/text/source.hpp>

namespace granum::io {

/// A piece of a file fit for a message: at most 40 characters, those that do not print as '?'.
[[nodiscard]] std::string shown(std::string_view text);

/// The significant digits that a number is written with: 3 for -0.00120e-7.
[[nodiscard]] int significant_digits(std::string_view number);

/// The parts of a text between separators, empty ones too.
[[nodiscard]] std::vector<std::string> split_at(std::string_view text, char separator);

/// The fields of the line that a source is at, separated by blanks. Valid until the source moves.
class TextRow {
 public:
  explicit TextRow(const TextSource& source) : source_(&source) {}

  /// Splits the line that the source is at now.
  void split();
  /// \throws   FileError unless there are `count` fields, "expected <count> <what>, found ..."
  void require_size(std::size_t count, std::string_view what) const;

  [[nodiscard]] std::size_t size() const { return fields_.size(); }
  [[nodiscard]] bool empty() const { return fields_.empty(); }
  [[nodiscard]] std::string_view operator[](std::size_t k) const { return fields_[k]; }
  [[nodiscard]] const std::vector<std::string_view>& fields() const { return fields_; }

  /// Field k as a finite number; `what` names it in errors.
  /// \throws   FileError if there is no field k or it is no finite number
  [[nodiscard]] double number(std::size_t k, std::string_view what) const;
  /// Three fields from k on.
  [[nodiscard]] Vec3 vector(std::size_t k, std::string_view what) const;
  /// Field k as an integer, also where it is written as 12.0 or 1e+05 with all its digits.
  /// \throws   FileError if it is none, or if digits are lost (1.23457e+06)
  [[nodiscard]] long integer(std::size_t k, std::string_view what) const;
  /// An integer that counts something.
  /// \throws   FileError also if it is negative
  [[nodiscard]] std::size_t count(std::size_t k, std::string_view what) const;

 private:
  [[nodiscard]] std::string_view field(std::size_t k, std::string_view what) const;

  const TextSource* source_;
  std::vector<std::string_view> fields_;
};

} // namespace granum::io
