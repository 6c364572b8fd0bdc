// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of an analysis as files for ParaView.
#pragma once

#include <filesystem>
#include <vector>

#include <granum/io/imported_packing.hpp>
#include <granum/io/output_file.hpp>
#include <granum/io/vtk/paraview.hpp>

namespace granum::cli {

/// grains-N.vtu and contacts-N.vtp for each frame N, and grains.pvd and contacts.pvd that hold them together.
class ParaviewFrames {
 public:
  ParaviewFrames(std::filesystem::path folder, io::Existing existing);

  /// \throws   FileError if a file cannot be written, or exists and is to be kept
  void add(const io::ImportedPacking& packing, std::size_t number);
  void finish() const;

 private:
  std::filesystem::path folder_;
  io::Existing existing_;
  std::vector<io::SeriesEntry> grains_;
  std::vector<io::SeriesEntry> contacts_;
};

} // namespace granum::cli
