// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace granum {

/// Root of every exception that the library throws.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An argument that no physical state can have (porosity 38, Poisson's ratio 0.6, NaN).
/// The text reads "<name> = <value> [<unit>] is outside <range>".
class InvalidArgument : public Error {
 public:
  using Error::Error;
  InvalidArgument(const std::string& name, double value, const std::string& unit, const std::string& range);
};

/// A file that cannot be read or written as asked. The text begins with "<path>:<line>: " (line 0: no line
/// is meant).
class FileError : public Error {
 public:
  FileError(const std::string& path, std::size_t line, const std::string& what);
};

/// The result of a calculation that did not converge was asked for.
class NotConverged : public Error {
 public:
  using Error::Error;
};

/// Long work was asked to stop (core/stop_request.hpp) before it had a result.
class Stopped : public Error {
 public:
  Stopped() : Error("stopped on request") {}
};

} // namespace granum
