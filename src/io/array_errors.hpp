// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <granum/core/error.hpp>

namespace granum::io {

/// The message of PackingBuilder, which names a line of a file, with the name of an array's element in its
/// place.
[[nodiscard]] inline InvalidArgument in_arrays(const FileError& error) {
  const bool numbered = error.line() > 0;
  const std::string place = error.path() + (numbered ? ":" + std::to_string(error.line()) : "") + ": ";
  const std::string element = numbered ? "[" + std::to_string(error.line() - 1) + "]" : "";
  return InvalidArgument(error.path() + element + ": " + std::string(error.what()).substr(place.size()));
}

} // namespace granum::io
