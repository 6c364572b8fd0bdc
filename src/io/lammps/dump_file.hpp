// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <granum/core/vec3.hpp>
#include <granum/io/text/source.hpp>

#include "io/later_run.hpp"
#include "io/text/row.hpp"

namespace granum::io {

/// The simulation box of a dump.
struct DumpBox {
  Mat3 edges; ///< columns are the edge vectors
  Vec3 origin;
  std::array<bool, 3> periodic{true, true, true};
  bool boundary_known = false;
  std::size_t line = 0;
};

/// Factors from the units of a dump to SI.
struct DumpUnits {
  double length = 1, force = 1, time = 1;
  bool stated = false;
};

/// Factors of a unit style of LAMMPS; empty unless its units are SI units times powers of ten.
[[nodiscard]] std::optional<DumpUnits> dump_units(std::string_view style);
/// The styles that have them, for messages.
inline constexpr const char* known_dump_units = "si, cgs, micro or nano";

/// The sections of one frame, except the table.
struct DumpFrame {
  std::optional<long> step;
  std::optional<double> time; ///< in the dump's unit
  std::optional<std::size_t> count;
  std::optional<DumpBox> box; ///< in the dump's unit
};

/// Receives the rows of a frame as they are read.
struct TableSink {
  /// \param    rows  to make room for: those that the frame states, a million at most; 0 if it states none
  std::function<void(const std::vector<std::string>& columns, std::size_t rows)> heading;
  std::function<void(const TextRow& row, std::size_t line)> row;
};

/// Reads the frames of dumps of LAMMPS and LIGGGHTS: sections that begin with "ITEM:", in any order, unknown
/// ones skipped. A frame ends when step, number of rows, box and table have been read.
class DumpFile {
 public:
  explicit DumpFile(TextSource source) : source_(std::move(source)) {}

  /// The next frame; the sink receives its rows one by one. Nothing at the end of the file.
  /// \throws   FileError for a file that is not a dump, a truncated frame, or a table of another number of
  ///           rows than stated
  [[nodiscard]] std::optional<DumpFrame> next(const TableSink& sink);
  /// Passes over a frame, complete or not.
  /// \return   its step, as LaterRun asks for it; nothing at the end of the file
  [[nodiscard]] std::optional<double> skip();

  [[nodiscard]] const DumpUnits& units() const { return units_; }
  [[nodiscard]] const TextSource& source() const { return source_; }

 private:
  void read_value(const char* what, TextRow& row);
  DumpBox read_box(const std::vector<std::string_view>& flags);
  void read_units();
  std::size_t read_table(const DumpFrame& frame, const TableSink& sink);
  void skip_section();
  [[nodiscard]] bool at_item() const;
  [[nodiscard]] bool is_table(std::string_view name, const std::string& label) const;

  TextSource source_;
  DumpUnits units_;
};

/// Position of a column of a given name.
[[nodiscard]] std::optional<std::size_t> find_column(const std::vector<std::string>& columns,
                                                     std::string_view name);

} // namespace granum::io
