// SPDX-License-Identifier: GPL-3.0-or-later
// Grains out of extended XYZ, as OVITO, ASE and io::grains_xyz write it.
#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <optional>

#include <granum/core/text.hpp>
#include <granum/io/packing_files.hpp>

#include "io/later_run.hpp"
#include "io/packing_builder.hpp"
#include "io/text/row.hpp"

namespace granum::io {

namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words = split_at(text, ' ');
  std::erase(words, "");
  return words;
}

/// Keys of the second line of a frame in lower case, with their values, which may be quoted.
using Keys = std::map<std::string, std::string>;

Keys keys_of(std::string_view line) {
  Keys keys;
  std::size_t at = 0;
  const auto blank = [&](std::size_t k) { return std::isspace(static_cast<unsigned char>(line[k])) != 0; };
  while (at < line.size()) {
    while (at < line.size() && blank(at))
      ++at;
    std::string key;
    for (; at < line.size() && line[at] != '=' && !blank(at); ++at)
      key += static_cast<char>(std::tolower(static_cast<unsigned char>(line[at])));
    if (at == line.size() || line[at] != '=')
      continue;
    const std::size_t begin = ++at;
    if (at < line.size() && (line[at] == '"' || line[at] == '\'')) {
      const std::size_t end = std::min(line.find(line[at], at + 1), line.size());
      keys[key] = line.substr(begin + 1, end - begin - 1);
      at = std::min(end + 1, line.size());
      continue;
    }
    while (at < line.size() && !blank(at))
      ++at;
    keys[key] = line.substr(begin, at - begin);
  }
  return keys;
}

/// Where the numbers of a grain are in its row.
struct GrainColumns {
  std::optional<std::size_t> position, radius, id, type;
  std::size_t count = 0;
  std::vector<std::string> unused;
};

/// \param    properties   "id:I:1:pos:R:3:radius:R:1"
GrainColumns columns_of(const TextSource& source, const std::string& properties) {
  GrainColumns columns;
  const std::vector<std::string> parts = split_at(properties, ':');
  constexpr double most = 1000;
  for (std::size_t k = 0; k + 2 < parts.size(); k += 3) {
    const auto width = parse_number(parts[k + 2]);
    if (!width || !(*width >= 1 && *width <= most))
      source.fail("Properties: expected a number of columns for " + shown(parts[k]) + ", found " +
                  shown(parts[k + 2]));
    std::string name = parts[k];
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool whole = parts[k + 1] == "I", one = *width == 1;
    std::optional<std::size_t>* const place = name == "pos" && *width == 3             ? &columns.position
                                              : name == "radius" && one                ? &columns.radius
                                              : name == "id" && whole && one           ? &columns.id
                                              : name.ends_with("type") && whole && one ? &columns.type
                                                                                       : nullptr;
    if (place != nullptr && !*place)
      *place = columns.count;
    else
      columns.unused.push_back(parts[k]);
    columns.count += static_cast<std::size_t>(*width);
  }
  if (!columns.position || !columns.radius)
    source.fail(std::string("Properties has no ") + (columns.position ? "radius:R:1" : "pos:R:3") +
                ": spheres have a position and a radius");
  return columns;
}

/// The cell, whose edges are the columns; empty without one.
std::optional<Mat3> cell_of(const TextSource& source, const Keys& keys) {
  const auto found = keys.find("lattice");
  if (found == keys.end())
    return std::nullopt;
  const std::vector<std::string> numbers = words_of(found->second);
  Mat3 cell;
  for (std::size_t k = 0; k < 9; ++k) {
    const auto number = k < numbers.size() && numbers.size() == 9 ? parse_number(numbers[k]) : std::nullopt;
    if (!number)
      source.fail("Lattice: expected nine numbers, found " + shown(found->second));
    cell(static_cast<int>(k % 3), static_cast<int>(k / 3)) = *number;
  }
  return cell;
}

/// Faces are periodic unless the file says otherwise.
std::array<bool, 3> periodic_of(const Keys& keys) {
  std::array<bool, 3> periodic{true, true, true};
  const auto found = keys.find("pbc");
  const std::vector<std::string> words =
      found == keys.end() ? std::vector<std::string>() : words_of(found->second);
  for (std::size_t k = 0; k < words.size() && k < 3; ++k)
    periodic[k] = words[k].starts_with('T') || words[k].starts_with('t') || words[k] == "1";
  return periodic;
}

/// The beginning of a frame.
struct FrameHead {
  std::size_t grains = 0;
  Keys keys;

  [[nodiscard]] std::optional<double> time() const {
    const auto found = keys.find("time");
    return found == keys.end() ? std::nullopt : parse_number(found->second);
  }
};

/// A file as LaterRun asks for it.
class XyzFile {
 public:
  explicit XyzFile(TextSource source) : source_(std::move(source)) {}
  [[nodiscard]] TextSource& source() { return source_; }
  [[nodiscard]] const TextSource& source() const { return source_; }

  /// The next frame up to its rows; nothing at the end.
  std::optional<FrameHead> head() {
    TextRow row(source_);
    do {
      if (!source_.next())
        return std::nullopt;
      row.split();
    } while (row.empty());
    row.require_size(1, "number: that of the grains");
    const std::size_t count = row.count(0, "grains");
    if (!source_.next())
      source_.fail("the file ends behind the number of grains");
    return FrameHead{count, keys_of(source_.line())};
  }
  /// Passes over a frame; its time, NaN where it has none.
  std::optional<double> skip() {
    const auto frame = head();
    if (!frame)
      return std::nullopt;
    const double time = frame->time().value_or(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < frame->grains; ++k)
      if (!source_.next())
        return ends_early(time);
    return time;
  }

 private:
  TextSource source_;
};

/// Frame by frame.
class ExtendedXyz {
 public:
  ExtendedXyz(TextSource source, PackingFileOptions options)
      : run_(std::move(source)), options_(std::move(options)) {}

  [[nodiscard]] static std::size_t skipped() { return 0; }
  [[nodiscard]] const std::vector<double>& moments() const { return run_.moments(); }

  /// \throws   FileError for text that is no extended XYZ, a frame that is cut off, fields that are no
  ///           numbers, a radius that is not positive, or an id that occurs twice
  [[nodiscard]] std::optional<ImportedPacking> next() {
    XyzFile& file = run_.next();
    const auto head = file.head();
    if (!head && run_.number() == 0)
      file.source().fail("contains no frame; expected the number of grains");
    return head ? std::optional(frame(file.source(), *head)) : std::nullopt;
  }

 private:
  ImportedPacking frame(TextSource& source, const FrameHead& head) {
    const auto properties = head.keys.find("properties");
    if (properties == head.keys.end())
      source.fail("expected Properties=...:pos:R:3:radius:R:1");
    const GrainColumns columns = columns_of(source, properties->second);
    PackingBuilder builder(source.name(), "", options_);
    if (const auto cell = cell_of(source, head.keys))
      builder.set_cell(*cell, periodic_of(head.keys), source.line_number());
    DigitWatch digits;
    builder.set_grains(grains_of(source, head.grains, columns, digits));
    builder.note_digits(digits, "coordinates");
    if (!columns.id)
      builder.note(Finding::ids_assumed, "no ids in the file: grains are numbered from 1");
    builder.note(Finding::units_unknown, "no units in the file: taken as SI");
    builder.note(Finding::law_unknown, "contact law and grain material are not in the file");
    builder.note(Finding::contacts_unknown, "extended XYZ holds grains alone");
    builder.note_unused(columns.unused, "columns of the grains");
    return builder.finish(run_.number(), head.time());
  }

  static std::vector<GrainRow> grains_of(TextSource& source, std::size_t count, const GrainColumns& columns,
                                         DigitWatch& digits) {
    std::vector<GrainRow> rows;
    TextRow row(source);
    for (std::size_t k = 0; k < count; ++k) {
      if (!source.next())
        source.fail("expected " + many(count, "grains") + ", found " + std::to_string(k));
      row.split();
      row.require_size(columns.count, "columns, as Properties lists them");
      for (std::size_t axis = 0; axis < 3; ++axis)
        digits.see(row[*columns.position + axis]);
      rows.push_back({.id = columns.id ? row.integer(*columns.id, "id") : static_cast<long>(k + 1),
                      .position = row.vector(*columns.position, "position"),
                      .radius = row.number(*columns.radius, "radius"),
                      .line = source.line_number()});
      if (columns.type)
        rows.back().type = row.integer(*columns.type, "type");
    }
    return rows;
  }

  LaterRun<XyzFile> run_;
  PackingFileOptions options_;
};

} // namespace

const PackingFormat extended_xyz_format{
    .name = "extended XYZ of OVITO or ASE",
    .sign = "a number alone, then Properties=",
    .grains = "extended XYZ",
    .contacts = "",
    .recognise = [](TextSource& source) -> std::optional<Holds> {
      if (!source.next() || !parse_number(trimmed(source.line())) || !source.next())
        return std::nullopt;
      return keys_of(source.line()).contains("properties") ? std::optional(Holds::grains) : std::nullopt;
    },
    .read =
        [](TextSource grains, std::optional<TextSource>, const PackingFileOptions& options) {
          return frames_of(ExtendedXyz(std::move(grains), options));
        }};

} // namespace granum::io
