// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <granum/io/imported_packing.hpp>
#include <granum/io/text/source.hpp>

namespace granum::io {

/// Packings out of MercuryDPM's .data (three dimensions, format 14) and .fstat, frame by frame; frames of
/// equal time (to six digits) belong together.
/// A row of .fstat contains the force on the first grain, normal pointing from the second to the first; each
/// pair occurs twice, and the two rows must be mirror images. Rows that the code leaves out (fixed
/// grains, ghosts behind periodic faces) make a pair one-sided, which is noted. A second index below 0 is a
/// wall; its normal points from the grain to the wall, as the code prints it,
/// and is reversed according to the contact point. `step` counts the frames of the .data file from 0.
///
/// The last column of .data, "info", which is the species unless a driver writes something else there,
/// becomes the type of the grain where it is an integer.
///
/// Not in these files, and so noted: which faces are periodic, units, contact law, stiffnesses, history.
/// Checked by tests/io/mercury/test_output.cpp
class MercuryOutput {
 public:
  explicit MercuryOutput(TextSource data, std::optional<TextSource> fstat = {},
                         PackingFileOptions options = {});
  MercuryOutput(MercuryOutput&&) noexcept;
  MercuryOutput& operator=(MercuryOutput&&) noexcept;
  ~MercuryOutput();

  /// The next state that is in all files; empty at their end.
  /// \throws   FileError with path and line for text that is no such output, frames cut off, fields that are
  ///           not numbers, a radius that is not positive, an unknown grain, a grain in contact with
  ///           itself, two rows of a pair that are no mirror images, a normal that is no unit vector or
  ///           does not fit the positions, and for files without one time in common
  [[nodiscard]] std::optional<ImportedPacking> next();

  /// Frames passed over so far because the other file has none of that time.
  [[nodiscard]] std::size_t skipped() const;
  /// Times of all frames of grains, as LammpsDump::moments().
  [[nodiscard]] const std::vector<double>& moments() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace granum::io
