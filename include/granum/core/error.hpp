// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace granum {

/// Root of every exception that the library throws. A NUL in its text would end what(), and is escaped there.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& text);
};

/// A number that was refused.
struct RefusedNumber {
  std::string name;  ///< of the argument, as the user knows it
  double value = 0;  ///< [unit]
  std::string unit;  ///< "" for a pure number
  std::string range; ///< allowed values, "(0, 1)"
};

/// An argument that no physical state can have (porosity 38, Poisson's ratio 0.6, NaN).
/// The text of a refused number reads "<name> = <value> [<unit>] is outside <range>".
/// Checked by tests/core/test_check.cpp
class InvalidArgument : public Error {
 public:
  using Error::Error;
  InvalidArgument(const std::string& name, double value, const std::string& unit, const std::string& range);

  /// The number, where it is one number that was refused.
  [[nodiscard]] const std::optional<RefusedNumber>& refused() const { return refused_; }

 private:
  std::optional<RefusedNumber> refused_;
};

/// A file that cannot be read or written. The text begins with "<path>:<line>: " (line 0: no line
/// is meant).
class FileError : public Error {
 public:
  FileError(const std::string& path, std::size_t line, const std::string& what);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::size_t line() const { return line_; } ///< counted from 1; 0: no line is meant

 private:
  std::string path_;
  std::size_t line_;
};

/// A result was requested from a calculation that did not converge.
class NotConverged : public Error {
 public:
  using Error::Error;
};

/// Long work was stopped (core/stop_request.hpp) before it had a result.
class Stopped : public Error {
 public:
  Stopped() : Error("stopped on request") {}
};

} // namespace granum
