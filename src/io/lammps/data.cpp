// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include <algorithm>
#include <cctype>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/packing_files.hpp>

#include "io/packing_builder.hpp"
#include "io/text/row.hpp"

namespace granum::io {

namespace {

struct Bounds {
  double low = 0, high = 0;
};

class DataFile {
 public:
  DataFile(TextSource source, const PackingFileOptions& options)
      : source_(std::move(source)), row_(source_), options_(options) {}
  DataFile(const DataFile&) = delete;
  DataFile& operator=(const DataFile&) = delete;

  ImportedPacking read() {
    if (!source_.next())
      source_.fail("is empty; expected a LAMMPS data file");
    const long step = title_step(source_.line());
    read_header();
    find_atoms();
    PackingBuilder builder(source_.name(), source_.name(), options_);
    builder.set_cell(cell(), {true, true, true}, 0);
    builder.set_grains(read_atoms());
    builder.note_digits(digits_, "coordinates");
    builder.note_unused(unused_, "columns and sections of the grains");
    builder.note(Finding::contacts_unknown, "a data file contains no contacts");
    builder.note(Finding::boundary_unknown,
                 "a data file does not state which faces are periodic: all are assumed");
    builder.note(Finding::units_unknown, "a data file has no units: taken as SI");
    builder.note(Finding::law_unknown, "contact law and grain material are not in a data file");
    return builder.finish(step, std::nullopt);
  }

 private:
  static constexpr std::string_view step_mark = "timestep = ";

  long title_step(std::string_view title) const {
    const std::size_t at = title.find(step_mark);
    if (at == std::string_view::npos)
      return 0;
    const auto number = leading_number(title.substr(at + step_mark.size()));
    return number && number->value >= 0 && number->value < 9e15 ? static_cast<long>(number->value) : 0;
  }

  /// Goes to the next line with more than a comment, and splits it; false at the end.
  bool next_row() {
    while (source_.next()) {
      row_.split();
      if (!row_.empty() && !row_[0].starts_with('#'))
        return true;
    }
    return false;
  }

  [[nodiscard]] bool at_section() const { return std::isalpha(static_cast<unsigned char>(row_[0][0])) != 0; }
  [[nodiscard]] bool has_word(std::size_t k, std::string_view word) const {
    return row_.size() > k && row_[k] == word;
  }

  void read_header() {
    constexpr const char* axes[3][2] = {{"xlo", "xhi"}, {"ylo", "yhi"}, {"zlo", "zhi"}};
    while (next_row()) {
      if (at_section())
        return source_.hold();
      if (has_word(1, "atoms"))
        count_ = row_.count(0, "atoms");
      for (std::size_t k = 0; k < 3; ++k)
        if (has_word(2, axes[k][0]) && has_word(3, axes[k][1]))
          bounds_[k] = Bounds{row_.number(0, axes[k][0]), row_.number(1, axes[k][1])};
      if (has_word(3, "xy") && has_word(4, "xz") && has_word(5, "yz"))
        tilt_ = row_.vector(0, "tilt");
      if (has_word(3, "avec") || has_word(3, "bvec") || has_word(3, "cvec"))
        source_.fail(
            "boxes of three given edges are not read from data files; expected xlo xhi, ylo yhi, zlo zhi");
    }
  }

  void find_atoms() {
    while (next_row())
      if (at_section() && row_[0] == "Atoms") {
        if (has_word(1, "#") && row_.size() > 2 && row_[2] != "sphere")
          source_.fail("expected atom style sphere, found " + shown(row_[2]));
        return;
      }
    source_.fail("the file ends; expected a section Atoms");
  }

  Mat3 cell() const {
    for (const auto& bounds : bounds_)
      if (!bounds)
        source_.fail("expected lines xlo xhi, ylo yhi and zlo zhi above the sections");
    const auto edge = [&](std::size_t k) { return bounds_[k]->high - bounds_[k]->low; };
    return {{{edge(0), tilt_.x, tilt_.y}, {0, edge(1), tilt_.z}, {0, 0, edge(2)}}};
  }

  std::vector<GrainRow> read_atoms() {
    if (!count_)
      source_.fail("expected a line with the number of atoms above the sections");
    std::vector<GrainRow> grains;
    while (next_row() && !at_section()) {
      if (row_.size() != 7 && row_.size() != 10)
        source_.fail("expected id type diameter density x y z and perhaps three image flags, found " +
                     std::to_string(row_.size()) + " fields");
      if (grains.size() == *count_)
        source_.fail("expected " + std::to_string(*count_) + " atoms, found more");
      for (std::size_t k = 4; k < 7; ++k)
        digits_.see(row_[k]);
      grains.push_back({row_.integer(0, "id"), row_.vector(4, "coordinate"), row_.number(2, "diameter") / 2,
                        source_.line_number(), row_.integer(1, "type")});
    }
    if (grains.size() != *count_)
      source_.fail("expected " + std::to_string(*count_) + " atoms, found " + std::to_string(grains.size()));
    for (bool more = !row_.empty() && at_section(); more; more = next_row())
      if (at_section())
        unused_.push_back("section " + std::string(row_[0]));
    return grains;
  }

  TextSource source_;
  TextRow row_;
  const PackingFileOptions& options_;
  std::optional<std::size_t> count_;
  std::array<std::optional<Bounds>, 3> bounds_;
  Vec3 tilt_{}; ///< xy, xz, yz
  DigitWatch digits_;
  std::vector<std::string> unused_{"density"};
};

} // namespace

ImportedPacking read_lammps_data(TextSource source, const PackingFileOptions& options) {
  return DataFile(std::move(source), options).read();
}

std::string lammps_data(const packing::Assembly& assembly, double density, std::span<const long> id) {
  require_valid(assembly);
  require_positive("density", density, "kg/m^3");
  const std::size_t count = assembly.grain_count();
  if (!id.empty() && id.size() != count)
    throw InvalidArgument("id has " + std::to_string(id.size()) + " numbers for " + std::to_string(count) +
                          " grains");
  const Mat3& cell = assembly.cell;
  if (cell(1, 0) != 0 || cell(2, 0) != 0 || cell(2, 1) != 0)
    throw InvalidArgument(
        "the first edge of the cell must lie along x and the second in the xy plane: LAMMPS "
        "supports no other boxes");

  std::string text = "LAMMPS data file written by granum: grains at rest, SI units\n\n" +
                     std::to_string(count) + " atoms\n1 atom types\n\n";
  constexpr const char* axes = "xyz";
  for (int k = 0; k < 3; ++k)
    text += "0 " + exact_text(cell(k, k)) + ' ' + axes[k] + "lo " + axes[k] + "hi\n";
  if (cell(0, 1) != 0 || cell(0, 2) != 0 || cell(1, 2) != 0)
    text +=
        exact_text(cell(0, 1)) + ' ' + exact_text(cell(0, 2)) + ' ' + exact_text(cell(1, 2)) + " xy xz yz\n";
  text += "\nAtoms # sphere\n\n";
  const std::string density_text = exact_text(density);
  for (std::size_t g = 0; g < count; ++g) {
    const long number = id.empty() ? static_cast<long>(g) + 1 : id[g];
    if (number < 1)
      throw InvalidArgument("id " + std::to_string(number) +
                            " is not positive; LAMMPS requires positive ids");
    const Vec3& x = assembly.position[g];
    text += std::to_string(number) + " 1 " + exact_text(2 * assembly.radius[g]) + ' ' + density_text + ' ' +
            exact_text(x.x) + ' ' + exact_text(x.y) + ' ' + exact_text(x.z) + '\n';
  }
  return text;
}

const PackingFormat lammps_data_format{
    .name = "LAMMPS data",
    .sign = "a line such as 1000 atoms below the first line",
    .grains = "a LAMMPS data file",
    .contacts = "",
    .recognise = [](TextSource& source) -> std::optional<Holds> {
      for (int k = 0; k < lines_looked_at && source.next(); ++k) // the first line is arbitrary
        if (const auto count = leading_number(trimmed(source.line()));
            count && trimmed(count->rest) == "atoms")
          return Holds::grains;
      return std::nullopt;
    },
    .read =
        [](TextSource grains, std::optional<TextSource>, const PackingFileOptions& options) {
          return one_frame(read_lammps_data(std::move(grains), options));
        }};

} // namespace granum::io
