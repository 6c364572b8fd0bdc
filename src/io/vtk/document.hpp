// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <granum/io/text/source.hpp>

#include "io/packing_builder.hpp"

namespace granum::io {

/// Finds the grain whose centre is the very point that a contact ends at: files of YADE name no grains.
class CentreIndex {
 public:
  explicit CentreIndex(const std::vector<Vec3>& centres);

  /// \return   empty if there is no centre
  /// \throws   FileError if several are
  [[nodiscard]] std::optional<std::uint32_t> look_up(const Vec3& point, const PackingBuilder& builder,
                                                     std::size_t line) const;
  /// \throws   FileError also if no centre is there
  [[nodiscard]] std::uint32_t find(const Vec3& point, const PackingBuilder& builder, std::size_t line) const;

 private:
  using Key = std::tuple<double, double, double>;
  static constexpr std::uint32_t several = 0xffffffff; ///< centres at one point
  std::map<Key, std::uint32_t> index_;
};

/// How the arrays of a file are packed where they are not text, from its first element.
struct VtkEncoding {
  bool big_endian = false;
  std::size_t header_size = 4; ///< bytes of a number in front of the data: 4 or 8
  std::string compressor;      ///< empty for none
};

/// The numbers of one array, in their order.
struct VtkNumbers {
  std::vector<double> values;
  std::size_t line = 0;          ///< of the file, where the array begins
  bool single_precision = false; ///< Float32, whatever digits it is written with
  DigitWatch digits = {};        ///< of arrays written as text
  [[nodiscard]] Vec3 vector(std::size_t k) const {
    return {values[3 * k], values[3 * k + 1], values[3 * k + 2]};
  }
};

/// The arrays of an XML file of VTK with one piece, as text, as base64 or behind the elements.
class VtkDocument {
 public:
  /// \throws   FileError for other files
  explicit VtkDocument(TextSource source);

  /// "UnstructuredGrid", "PolyData", ...
  [[nodiscard]] const std::string& type() const { return type_; }
  [[nodiscard]] const std::string& name() const { return source_.name(); }
  /// NumberOfPoints, NumberOfLines, ...; 0 if not in the piece.
  [[nodiscard]] std::size_t count(const std::string& what) const;
  /// The array of a name in "Points", "PointData", "CellData", "Lines" or "FieldData"; nothing if there is
  /// none. Case does not matter in names; an empty name is that of any array.
  /// \throws   FileError unless it is so many tuples of so many finite numbers, or NaN
  [[nodiscard]] std::optional<VtkNumbers> numbers(const std::string& section, const std::string& name,
                                                  std::size_t tuples, std::size_t components) const;
  /// The names of the arrays of a section, in small letters.
  [[nodiscard]] std::vector<std::string> names(const std::string& section) const {
    std::vector<std::string> out;
    for (const auto& [key, array] : arrays_)
      if (key.first == section)
        out.push_back(key.second);
    return out;
  }
  [[noreturn]] void fail(std::size_t line, const std::string& what) const;

 private:
  struct Parser;
  using Attributes = std::map<std::string, std::string, std::less<>>;
  struct Array {
    Attributes attributes;
    std::string text;
    std::size_t line = 0;
  };

  void read_head(const Attributes& attributes, std::size_t line);
  void read_piece(const Attributes& attributes, std::size_t line);
  Array* read_array(const std::string& section, Attributes attributes, std::size_t line);
  [[nodiscard]] const Array* find(const std::string& section, const std::string& name) const;
  void read_text(const Array& array, const std::string& what, std::size_t count, VtkNumbers& out) const;
  void read_packed(const Array& array, const std::string& what, std::size_t count, VtkNumbers& out) const;
  [[nodiscard]] std::string bytes(const Array& array, const std::string& what) const;

  TextSource source_;
  std::string type_;
  VtkEncoding encoding_;
  std::optional<std::map<std::string, std::size_t>> piece_; ///< its numbers of points, lines and so on
  std::map<std::pair<std::string, std::string>, Array> arrays_;
  std::string appended_; ///< the text after the elements and the '_'
  bool appended_base64_ = false;
};

/// Whether a file is the list of the pieces of one state (.pvtu, .pvtp). The source is then somewhere in its
/// first lines.
[[nodiscard]] bool is_parallel(TextSource& source);
/// The names of the pieces, relative to the folder of the file.
/// \throws   FileError with path and line for text that is not XML, a piece without a name, and no pieces
[[nodiscard]] std::vector<std::string> read_pieces(TextSource source);

} // namespace granum::io
