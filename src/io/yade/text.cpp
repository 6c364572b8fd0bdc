// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/yade/files.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <granum/core/text.hpp>
#include <granum/io/packing_files.hpp>

#include "io/lammps/dump_file.hpp"
#include "io/packing_builder.hpp"
#include "io/text/row.hpp"

namespace granum::io {

namespace {

std::size_t needed(const TextSource& source, const std::vector<std::string>& columns, const char* name) {
  const auto column = find_column(columns, name);
  if (!column)
    source.fail(std::string("expected a column '") + name + "' in the heading");
  return *column;
}

/// The text above the rows of grains, and the rows.
class GrainFile {
 public:
  explicit GrainFile(TextSource source) : source_(std::move(source)), row_(source_) {}
  GrainFile(const GrainFile&) = delete;
  GrainFile& operator=(const GrainFile&) = delete;

  void read() {
    while (source_.next()) {
      row_.split();
      if (row_.empty())
        continue;
      if (row_[0].starts_with('#'))
        read_comment();
      else
        read_grain();
    }
  }

  /// A builder with the grains; errors of contacts name `contact_file`.
  PackingBuilder builder(const std::string& contact_file, const PackingFileOptions& options) {
    PackingBuilder result(source_.name(), contact_file, options);
    if (cell_)
      result.set_cell(*cell_, {true, true, true}, cell_line_);
    result.set_grains(std::move(grains_));
    result.note_digits(digits_, "coordinates");
    if (numbered_)
      result.note(Finding::ids_assumed, "grains are numbered from 0 in the order of their rows");
    result.note(Finding::units_unknown, "YADE's files have no units: taken as SI");
    result.note(Finding::law_unknown, "contact law and grain material are not in the files");
    std::vector<std::string> unused = columns_;
    const auto used = {"id", "x", "y", "z", "r", "clumpId", type_name_.c_str()};
    std::erase_if(unused,
                  [&](const std::string& name) { return std::ranges::find(used, name) != used.end(); });
    result.note_unused(unused, "columns of the grains");
    return result;
  }

  [[nodiscard]] const std::optional<Mat3>& cell() const { return cell_; }
  [[nodiscard]] long step() const { return step_; }
  [[nodiscard]] std::optional<double> time() const { return time_; }

 private:
  void read_comment() {
    const auto names = [&](std::size_t first) {
      return std::vector<std::string>(row_.fields().begin() + static_cast<std::ptrdiff_t>(first),
                                      row_.fields().end());
    };
    if (row_[0] == "#format" && row_.size() > 1) {
      columns_ = split_at(row_[1], '_');
    } else if (row_[0] == "#" && row_.size() > 1) {
      if (row_[1] == "step")
        step_ = row_.integer(2, "step");
      else if (row_[1] == "time")
        time_ = row_.number(2, "time");
      else if (row_[1] == "cell")
        read_cell();
      else if (row_[1] == "id" || row_[1] == "x")
        columns_ = names(1);
    }
  }

  void read_cell() {
    row_.require_size(11, "fields: # cell and nine numbers, row by row");
    Mat3 cell;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        cell(i, j) = row_.number(static_cast<std::size_t>(2 + 3 * i + j), "cell");
    cell_ = cell;
    cell_line_ = source_.line_number();
  }

  void read_grain() {
    if (columns_.empty())
      source_.fail("expected a heading such as '#format x_y_z_r' or '# id x y z r' above the rows");
    row_.require_size(columns_.size(), "fields, as many as the heading names");
    const std::size_t at[3] = {needed(source_, columns_, "x"), needed(source_, columns_, "y"),
                               needed(source_, columns_, "z")};
    const std::size_t radius = needed(source_, columns_, "r");
    const auto id = find_column(columns_, "id");
    numbered_ = numbered_ || !id;
    const auto type = type_column();
    for (const std::size_t k : at)
      digits_.see(row_[k]);
    grains_.push_back({id ? row_.integer(*id, "id") : static_cast<long>(grains_.size()),
                       {row_.number(at[0], "coordinate"), row_.number(at[1], "coordinate"),
                        row_.number(at[2], "coordinate")},
                       row_.number(radius, "radius"),
                       source_.line_number(),
                       type ? std::optional(row_.integer(*type, "type")) : std::nullopt});
    if (const auto clump = find_column(columns_, "clumpId")) // -1: of none; numbers from 0 on
      grains_.back().body = row_.integer(*clump, "clumpId") + 1;
  }

  /// Numbers of materials, as the script writes them or an attribute of textExt may be called.
  [[nodiscard]] std::optional<std::size_t> type_column() {
    for (const char* const name : {"material", "mat", "materialId", "type"})
      if (const auto column = find_column(columns_, name)) {
        type_name_ = name;
        return column;
      }
    return std::nullopt;
  }

  TextSource source_;
  TextRow row_;
  std::vector<std::string> columns_;
  std::vector<GrainRow> grains_;
  DigitWatch digits_;
  std::optional<Mat3> cell_;
  std::size_t cell_line_ = 0;
  long step_ = 0;
  std::optional<double> time_;
  bool numbered_ = false;
  std::string type_name_; ///< of the column
};

/// The rows of contacts, put into a packing one by one.
class ContactFile {
 public:
  ContactFile(TextSource source, PackingBuilder& builder, const std::optional<Mat3>& cell)
      : source_(std::move(source)), row_(source_), builder_(builder), cell_(cell) {}
  ContactFile(const ContactFile&) = delete;
  ContactFile& operator=(const ContactFile&) = delete;

  void read() {
    while (source_.next()) {
      row_.split();
      if (row_.empty())
        continue;
      if (row_[0] == "#")
        read_heading();
      else
        read_contact();
    }
    if (columns_.empty())
      source_.fail("contains no contacts; expected a heading '# id1 id2 ...'");
    std::vector<std::string> unused = columns_;
    constexpr std::string_view used[] = {"id1", "id2", "nx",        "ny",        "nz",       "pd",
                                         "fnx", "fny", "fnz",       "fsx",       "fsy",      "fsz",
                                         "kr",  "ktw", "cellDistX", "cellDistY", "cellDistZ"};
    std::erase_if(unused, [&](const std::string& name) {
      return std::ranges::find(used, name) != std::end(used) ||
             (stiffness_ && (name == "kn" || name == "ks"));
    });
    builder_.note_unused(unused, "columns of the contacts");
    builder_.note_overlap_digits(digits_, "overlaps");
    builder_.note_force_digits(force_digits_);
    if (left_out_ > 0)
      builder_.note(Finding::walls_unknown,
                    std::to_string(left_out_) +
                        " contacts with bodies that are neither spheres nor walls were not exported");
    if (!stiffness_)
      builder_.note(Finding::stiffness_unknown, "no columns kn, ks");
    builder_.note(Finding::history_unknown, "the loading history of the contacts is not in the files");
    builder_.note(Finding::viscous_forces,
                  "forces include viscous damping where the law has it and grains move");
  }

 private:
  void read_heading() {
    if (row_.size() > 2 && row_[1] == "left_out")
      left_out_ = row_.count(2, "contacts with other bodies");
    if (row_.size() < 2 || row_[1] != "id1")
      return;
    columns_.assign(row_.fields().begin() + 1, row_.fields().end());
    const auto three = [&](const char* x, const char* y, const char* z) {
      return std::array<std::size_t, 3>{needed(source_, columns_, x), needed(source_, columns_, y),
                                        needed(source_, columns_, z)};
    };
    id1_ = needed(source_, columns_, "id1");
    id2_ = needed(source_, columns_, "id2");
    normal_ = three("nx", "ny", "nz");
    overlap_ = needed(source_, columns_, "pd");
    normal_force_ = three("fnx", "fny", "fnz");
    shear_force_ = three("fsx", "fsy", "fsz");
    shift_.reset();
    if (find_column(columns_, "cellDistX"))
      shift_ = three("cellDistX", "cellDistY", "cellDistZ");
    const auto kn = find_column(columns_, "kn"), ks = find_column(columns_, "ks");
    stiffness_.reset();
    if (kn && ks)
      stiffness_ = {*kn, *ks};
    rolling_ = find_column(columns_, "kr");
    twisting_ = find_column(columns_, "ktw");
  }

  [[nodiscard]] Vec3 vector(const std::array<std::size_t, 3>& at, const char* what) const {
    return {row_.number(at[0], what), row_.number(at[1], what), row_.number(at[2], what)};
  }

  [[nodiscard]] double stiffness(std::size_t column, const char* what) const {
    const double value = row_.number(column, what);
    if (value < 0)
      source_.fail(std::string("expected ") + what + " >= 0, found " + short_text(value));
    return value;
  }

  void read_contact() {
    if (columns_.empty())
      source_.fail("expected a heading '# id1 id2 ...' above the rows");
    row_.require_size(columns_.size(), "fields, as many as the heading names");
    const std::size_t line = source_.line_number();
    PairRow pair;
    pair.line = line;
    pair.a = builder_.index(row_.integer(id1_, "id1"), line);
    const long second = row_.integer(id2_, "id2");
    const bool wall = second < 0;
    if (!wall)
      pair.b = builder_.index(second, line);
    digits_.see(row_[overlap_]);
    for (const std::size_t k : normal_force_)
      force_digits_.see(row_[k]);
    pair.overlap = row_.number(overlap_, "overlap pd");
    const Vec3 direction = vector(normal_, "normal");
    if (direction == Vec3{} && vector(normal_force_, "normal force") == Vec3{} &&
        vector(shear_force_, "shear force") == Vec3{})
      return builder_.skip_empty();
    if (!(std::abs(norm(direction) - 1) <= 1e-3))
      source_.fail("expected a unit vector as normal, found one of length " + short_text(norm(direction)));
    const Vec3 n = (1 / norm(direction)) * direction;
    const double radii = wall ? builder_.radius(pair.a) : builder_.radius_sum(pair.a, pair.b);
    pair.branch = (radii - pair.overlap) * n;
    if (!wall && pair.a != pair.b)
      require_place(pair);
    pair.normal_force = dot(vector(normal_force_, "normal force"), n);
    pair.tangential_force = vector(shear_force_, "shear force");
    if (stiffness_) {
      pair.normal_stiffness = stiffness(stiffness_->first, "kn");
      pair.tangential_stiffness = stiffness(stiffness_->second, "ks");
    }
    if (rolling_)
      pair.rolling_stiffness = stiffness(*rolling_, "kr");
    if (twisting_)
      pair.twisting_stiffness = stiffness(*twisting_, "ktw");
    if (wall)
      builder_.add_wall(pair, -(second + 1));
    else
      builder_.add(pair);
  }

  /// The line of centres fits the positions, with the shift that the row states.
  void require_place(const PairRow& pair) const {
    const Vec3 shift = shift_ ? vector(*shift_, "cellDist") : Vec3{};
    if (!(shift == Vec3{}) && !cell_)
      source_.fail("the pair reaches through a periodic face, but the file of grains has no line '# cell'");
    builder_.require_agreement(pair);
    if (shift_ && cell_) {
      const Vec3 expected = builder_.straight(pair.a, pair.b) + *cell_ * shift;
      if (!(norm(pair.branch - expected) <= 1e-2 * builder_.radius_sum(pair.a, pair.b)))
        source_.fail("the line of centres does not fit the positions and cellDist");
    }
  }

  TextSource source_;
  TextRow row_;
  PackingBuilder& builder_;
  const std::optional<Mat3>& cell_;
  std::vector<std::string> columns_;
  std::size_t id1_ = 0, id2_ = 0, overlap_ = 0;
  std::array<std::size_t, 3> normal_{}, normal_force_{}, shear_force_{};
  std::optional<std::array<std::size_t, 3>> shift_;
  std::optional<std::pair<std::size_t, std::size_t>> stiffness_;
  std::optional<std::size_t> rolling_, twisting_;
  std::size_t left_out_ = 0;
  DigitWatch digits_, force_digits_;
};

} // namespace

ImportedPacking read_yade(TextSource grains, std::optional<TextSource> contacts,
                          const PackingFileOptions& options) {
  GrainFile file(std::move(grains));
  file.read();
  PackingBuilder builder = file.builder(contacts ? contacts->name() : "", options);
  if (contacts)
    ContactFile(std::move(*contacts), builder, file.cell()).read();
  else
    builder.note(Finding::contacts_unknown, "no file of contacts was given");
  return builder.finish(file.step(), file.time());
}

const PackingFormat yade_text_format{
    .name = "YADE's text",
    .sign = "a first line as share/yade/granum_export.py or export.text writes it",
    .grains = "grains of YADE as text",
    .contacts = "contacts of YADE as text",
    .recognise = [](TextSource& source) -> std::optional<Holds> {
      if (!source.next())
        return std::nullopt;
      const std::string_view line = source.line();
      if (line.starts_with("#format") || line.starts_with("# granum: grains of a YADE"))
        return Holds::grains;
      if (line.starts_with("# granum: contacts of a YADE") || line.starts_with("# id1 id2 "))
        return Holds::contacts;
      return std::nullopt;
    },
    .read =
        [](TextSource grains, std::optional<TextSource> contacts, const PackingFileOptions& options) {
          return one_frame(read_yade(std::move(grains), std::move(contacts), options));
        }};

} // namespace granum::io
