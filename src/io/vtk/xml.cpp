// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/vtk/xml.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/packing_files.hpp>

#include "document.hpp"
#include "io/packing_builder.hpp"
#include "io/text/row.hpp"

namespace granum::io {

namespace {

constexpr double largest_id = 9e15; // integers up to there are exact

long integer(const VtkDocument& file, const VtkNumbers& numbers, std::size_t k, const char* what) {
  const double value = numbers.values[k];
  if (!(std::abs(value) <= largest_id) || value != std::floor(value))
    file.fail(numbers.line, "expected an integer as " + std::string(what) + " " + std::to_string(k));
  return static_cast<long>(value);
}

VtkNumbers points_of(const VtkDocument& file) {
  auto points = file.numbers("Points", "", file.count("NumberOfPoints"), 3);
  if (!points)
    file.fail(0, "expected an element Points");
  return *std::move(points);
}

void set_cell(const VtkDocument& file, PackingBuilder& builder) {
  const auto edges = file.numbers("FieldData", "cell", 1, 9);
  if (!edges) {
    builder.note(Finding::boundary_unknown,
                 "a VTK file does not state which faces are periodic: none is assumed");
    return;
  }
  Mat3 cell;
  for (int k = 0; k < 9; ++k)
    cell(k % 3, k / 3) = edges->values[static_cast<std::size_t>(k)];
  builder.set_cell(cell, {true, true, true}, edges->line);
  builder.note(Finding::boundary_unknown,
               "a VTK file does not state which faces are periodic: all are assumed");
}

/// Numbers of materials, as LIGGGHTS, YADE and others call them.
std::optional<VtkNumbers> types_of(const VtkDocument& file) {
  for (const char* const name : {"type", "materialid", "material"})
    if (auto types = file.numbers("PointData", name, file.count("NumberOfPoints"), 1))
      return types;
  return std::nullopt;
}

/// Radii or diameters, and the factor from them to radii.
std::pair<VtkNumbers, double> sizes_of(const VtkDocument& file) {
  for (const auto& [name, factor] :
       {std::pair("radius", 1.0), std::pair("radii", 1.0), std::pair("diameter", 0.5)})
    if (auto sizes = file.numbers("PointData", name, file.count("NumberOfPoints"), 1))
      return {*std::move(sizes), factor};
  file.fail(0, "expected point data radius, radii or diameter");
}

/// Notes the arrays of a section that no reader here knows.
void note_unused(const VtkDocument& file, const std::string& section, PackingBuilder& builder) {
  constexpr std::string_view known[] = {"radius",
                                        "radii",
                                        "diameter",
                                        "id",
                                        "type",
                                        "materialid",
                                        "material",
                                        "grains",
                                        "forcen",
                                        "normal_force",
                                        "wall",
                                        "tangential_force",
                                        "overlap",
                                        "sliding",
                                        "normal_stiffness",
                                        "through_face",
                                        "tangential_stiffness"};
  std::vector<std::string> unused = file.names(section);
  std::erase_if(unused,
                [&](const std::string& name) { return std::ranges::find(known, name) != std::end(known); });
  builder.note_unused(unused, section == "PointData" ? "arrays of the grains" : "arrays of the contacts");
}

/// Appends the grains of a piece.
/// \return   whether they have ids
bool add_grains(const VtkDocument& file, std::vector<GrainRow>& rows) {
  const std::size_t count = file.count("NumberOfPoints"), before = rows.size();
  const VtkNumbers points = points_of(file);
  const auto [radius, factor] = sizes_of(file);
  const auto id = file.numbers("PointData", "id", count, 1);
  const auto type = types_of(file);
  const auto ghost = file.numbers("PointData", "vtkghosttype", count, 1);
  for (std::size_t k = 0; k < count; ++k) {
    if (ghost && ghost->values[k] != 0)
      continue; // the grain of another piece
    rows.push_back({.id = id ? integer(file, *id, k, "id") : static_cast<long>(before + k),
                    .position = points.vector(k),
                    .radius = factor * radius.values[k],
                    .line = points.line,
                    .type = type ? std::optional(integer(file, *type, k, "type")) : std::nullopt});
  }
  return id.has_value();
}

/// \param    pieces   at least one
void set_grains(const std::vector<VtkDocument>& pieces, PackingBuilder& builder) {
  std::vector<GrainRow> rows;
  bool numbered = false;
  for (const VtkDocument& piece : pieces)
    numbered = !add_grains(piece, rows) || numbered;
  builder.set_grains(std::move(rows));
  const VtkDocument& file = pieces.front();
  const VtkNumbers points = points_of(file);
  if (points.single_precision)
    builder.note_single_precision("coordinates are of single precision, 7 significant digits");
  else
    builder.note_digits(points.digits, "coordinates");
  if (numbered)
    builder.note(Finding::ids_assumed, "grains are numbered from 0 in the order of their points");
  note_unused(file, "PointData", builder);
}

PackingBuilder grains_built(const std::vector<VtkDocument>& pieces, const std::string& contact_file,
                            const PackingFileOptions& options) {
  PackingBuilder builder(pieces.front().name(), contact_file, options);
  set_cell(pieces.front(), builder);
  set_grains(pieces, builder);
  builder.note(Finding::units_unknown, "a VTK file has no units: taken as SI");
  builder.note(Finding::law_unknown, "contact law and grain material are not in the files");
  return builder;
}

std::optional<double> time_of(const VtkDocument& file) {
  const auto time = file.numbers("FieldData", "timevalue", 1, 1);
  return time && std::isfinite(time->values[0]) ? std::optional(time->values[0]) : std::nullopt;
}

/// The lines of a file and their data.
class ContactLines {
 public:
  explicit ContactLines(const VtkDocument& file)
      : file_(file), count_(file.count("NumberOfLines")), points_(points_of(file)),
        grains_(data("grains", 2)), normal_(data("normal_force", 1)),
        tangential_(data("tangential_force", 3)), overlap_(data("overlap", 1)),
        normal_stiffness_(data("normal_stiffness", 1)),
        tangential_stiffness_(data("tangential_stiffness", 1)), sliding_(data("sliding", 1)),
        wall_(grains_ ? data("wall", 1) : std::nullopt) {
    if (!normal_)
      normal_ = data("forcen", 1);
    read_ends();
  }

  void add_to(PackingBuilder& builder) const {
    note_missing(builder);
    const CentreIndex index(grains_ ? std::vector<Vec3>{} : builder.positions());
    for (std::size_t k = 0; k < count_; ++k) {
      const long wall = wall_ ? integer(file_, *wall_, k, "wall") : -1;
      if (wall >= 0)
        add_wall(k, wall, builder);
      else if (grains_)
        add_pair(grain(2 * k, builder), grain(2 * k + 1, builder), k, builder);
      else
        add_pair(index.find(from(k), builder, line_), index.find(to(k), builder, line_), k, builder);
    }
  }

 private:
  [[nodiscard]] std::optional<VtkNumbers> data(const char* name, std::size_t components) const {
    return file_.numbers("CellData", name, count_, components);
  }

  void read_ends() {
    if (count_ == 0)
      return;
    const auto connectivity = file_.numbers("Lines", "connectivity", 2 * count_, 1);
    const auto offsets = file_.numbers("Lines", "offsets", count_, 1);
    if (!connectivity || !offsets)
      file_.fail(0, "expected connectivity and offsets in Lines");
    line_ = connectivity->line;
    for (std::size_t k = 0; k < count_; ++k)
      if (offsets->values[k] != 2 * static_cast<double>(k + 1))
        file_.fail(offsets->line, "expected lines of two points, found another in line " + std::to_string(k));
    const auto known = static_cast<long>(file_.count("NumberOfPoints"));
    for (std::size_t k = 0; k < 2 * count_; ++k) {
      const long end = integer(file_, *connectivity, k, "point");
      if (end < 0 || end >= known)
        file_.fail(line_, "expected points 0 to " + std::to_string(known - 1) + " in Lines, found " +
                              std::to_string(end));
      ends_.push_back(static_cast<std::size_t>(end));
    }
  }

  void note_missing(PackingBuilder& builder) const {
    const auto known = [](double stiffness) { return stiffness != 0; };
    if (!normal_stiffness_ || std::ranges::none_of(normal_stiffness_->values, known))
      builder.note(Finding::stiffness_unknown, "stiffnesses are not in the files");
    builder.note(Finding::history_unknown, "the loading history of the contacts is not in the files");
    if (!normal_) {
      builder.expect_no_forces();
      builder.note(Finding::forces_unknown, "no cell data normal_force or forceN");
    } else if (!tangential_) {
      builder.note(Finding::tangential_unknown, "no cell data tangential_force");
    }
  }

  [[nodiscard]] Vec3 from(std::size_t k) const { return points_.vector(ends_[2 * k]); }
  [[nodiscard]] Vec3 to(std::size_t k) const { return points_.vector(ends_[2 * k + 1]); }
  [[nodiscard]] double scalar(const std::optional<VtkNumbers>& numbers, std::size_t k) const {
    return numbers ? numbers->values[k] : 0;
  }

  /// Of all numbers in "grains".
  [[nodiscard]] std::uint32_t grain(std::size_t k, const PackingBuilder& builder) const {
    return builder.index(integer(file_, *grains_, k, "grain"), grains_->line);
  }

  [[nodiscard]] PairRow row(std::size_t k) const {
    return {.branch = to(k) - from(k),
            .normal_force = scalar(normal_, k),
            .tangential_force = tangential_ ? tangential_->vector(k) : Vec3{},
            .normal_stiffness = scalar(normal_stiffness_, k),
            .tangential_stiffness = scalar(tangential_stiffness_, k),
            .sliding = scalar(sliding_, k) != 0,
            .line = line_};
  }

  void add_pair(std::uint32_t a, std::uint32_t b, std::size_t k, PackingBuilder& builder) const {
    PairRow pair = row(k);
    pair.a = a;
    pair.b = b;
    pair.overlap = overlap_ ? overlap_->values[k] : builder.radius_sum(a, b) - norm(pair.branch);
    if (a != b)
      builder.require_agreement(pair);
    builder.add(pair);
  }

  void add_wall(std::size_t k, long wall, PackingBuilder& builder) const {
    PairRow pair = row(k);
    pair.a = grain(2 * k, builder);
    pair.overlap = overlap_ ? overlap_->values[k] : builder.radius(pair.a) - norm(pair.branch);
    builder.add_wall(pair, wall);
  }

  const VtkDocument& file_;
  std::size_t count_;
  VtkNumbers points_;
  std::optional<VtkNumbers> grains_, normal_, tangential_, overlap_, normal_stiffness_, tangential_stiffness_,
      sliding_, wall_;
  std::size_t line_ = 0; ///< of the file, where the lines begin
  std::vector<std::size_t> ends_;
};

/// The attribute of an element, with its line.
std::string_view attribute(std::string_view line, std::string_view name) {
  const std::size_t at = line.find(name);
  if (at == std::string_view::npos)
    return {};
  const std::string_view value = line.substr(at + name.size());
  return value.substr(0, value.find_first_of("\"'"));
}

void require_type(const VtkDocument& file, const char* type) {
  if (file.type() != type)
    file.fail(0, "expected a VTKFile of type " + std::string(type) + ", found " + shown(file.type()));
}

/// A file, or the pieces that a parallel file (.pvtu, .pvtp) names.
std::vector<VtkDocument> pieces_of(TextSource source) {
  std::vector<VtkDocument> out;
  source.keep_from_start();
  if (!is_parallel(source)) {
    source.back_to_start();
    source.stop_keeping();
    out.emplace_back(std::move(source));
    return out;
  }
  source.back_to_start();
  source.stop_keeping();
  const std::filesystem::path folder = std::filesystem::path(source.name()).parent_path();
  for (const std::string& piece : read_pieces(std::move(source)))
    out.emplace_back(TextSource(folder / piece));
  return out;
}

} // namespace

ImportedPacking read_vtk_xml(TextSource grains, std::optional<TextSource> contacts,
                             const PackingFileOptions& options) {
  const std::vector<VtkDocument> pieces = pieces_of(std::move(grains));
  const std::optional<double> time = time_of(pieces.front());
  if (!contacts) {
    PackingBuilder builder = grains_built(pieces, "", options);
    builder.note(Finding::contacts_unknown, "no file of contacts was given");
    return builder.finish(0, time);
  }
  const std::vector<VtkDocument> lines = pieces_of(std::move(*contacts));
  PackingBuilder builder = grains_built(pieces, lines.front().name(), options);
  for (const VtkDocument& piece : lines) {
    require_type(piece, "PolyData");
    ContactLines(piece).add_to(builder);
  }
  note_unused(lines.front(), "CellData", builder);
  return builder.finish(0, time);
}

const PackingFormat vtk_xml_format{
    .name = ".vtu and .vtp",
    .sign = "XML with an element Piece; contacts if it has lines, grains if only points",
    .grains = "grains as VTK XML",
    .contacts = "contacts as VTK XML",
    .recognise = [](TextSource& source) -> std::optional<Holds> {
      if (!source.next() || !(source.line().starts_with("<?xml") || source.line().starts_with("<VTKFile")))
        return std::nullopt;
      source.hold();
      bool poly_data = false;
      for (int k = 0; k < lines_looked_at && source.next(); ++k) {
        const std::string_view line = source.line();
        poly_data = poly_data || line.find("PolyData") != std::string_view::npos;
        if (line.find("<Piece") == std::string_view::npos)
          continue;
        if (line.find("Source=") != std::string_view::npos) // of .pvtu, .pvtp
          return poly_data ? Holds::contacts : Holds::grains;
        const bool lines =
            attribute(line, "NumberOfLines=\"") != "0" || attribute(line, "NumberOfPoints=\"") == "0";
        return poly_data && lines ? Holds::contacts : Holds::grains;
      }
      source.fail("an XML file without an element Piece; expected .vtu or .vtp");
    },
    .read =
        [](TextSource grains, std::optional<TextSource> contacts, const PackingFileOptions& options) {
          return one_frame(read_vtk_xml(std::move(grains), std::move(contacts), options));
        }};

} // namespace granum::io
