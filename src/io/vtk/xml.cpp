// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/vtk/xml.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string_view>

#include <expat.h>

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

void set_grains(const VtkDocument& file, PackingBuilder& builder) {
  const std::size_t count = file.count("NumberOfPoints");
  const VtkNumbers points = points_of(file);
  auto radius = file.numbers("PointData", "radius", count, 1);
  if (!radius)
    radius = file.numbers("PointData", "radii", count, 1);
  if (!radius)
    file.fail(0, "expected point data radius or radii");
  const auto id = file.numbers("PointData", "id", count, 1);
  const auto type = types_of(file);
  std::vector<GrainRow> rows;
  for (std::size_t k = 0; k < count; ++k)
    rows.push_back({.id = id ? integer(file, *id, k, "id") : static_cast<long>(k),
                    .position = points.vector(k),
                    .radius = radius->values[k],
                    .line = points.line,
                    .type = type ? std::optional(integer(file, *type, k, "type")) : std::nullopt});
  builder.set_grains(std::move(rows));
  if (points.single_precision)
    builder.note_single_precision("coordinates are of single precision, 7 significant digits");
  else
    builder.note_digits(points.digits, "coordinates");
  if (!id)
    builder.note(Finding::ids_assumed, "grains are numbered from 0 in the order of their points");
}

PackingBuilder grains_built(const VtkDocument& file, const std::string& contact_file) {
  PackingBuilder builder(file.name(), contact_file);
  set_cell(file, builder);
  set_grains(file, builder);
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

} // namespace

ImportedPacking read_vtk_xml(TextSource grains, std::optional<TextSource> contacts) {
  const VtkDocument file(std::move(grains));
  if (!contacts) {
    PackingBuilder builder = grains_built(file, "");
    builder.note(Finding::contacts_unknown, "no file of contacts was given");
    return builder.finish(0, time_of(file));
  }
  const VtkDocument lines(std::move(*contacts));
  require_type(lines, "PolyData");
  PackingBuilder builder = grains_built(file, lines.name());
  ContactLines(lines).add_to(builder);
  return builder.finish(0, time_of(file));
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
        const bool lines =
            attribute(line, "NumberOfLines=\"") != "0" || attribute(line, "NumberOfPoints=\"") == "0";
        return poly_data && lines ? Holds::contacts : Holds::grains;
      }
      source.fail("an XML file without an element Piece; expected .vtu or .vtp");
    },
    .read =
        [](TextSource grains, std::optional<TextSource> contacts, const PackingFileOptions&) {
          return one_frame(read_vtk_xml(std::move(grains), std::move(contacts)));
        }};

namespace {

/// The data sets of a series, as expat finds them.
class Collection {
 public:
  explicit Collection(TextSource source)
      : source_(std::move(source)), expat_(XML_ParserCreate(nullptr), &XML_ParserFree) {
    if (!expat_)
      throw std::bad_alloc();
    XML_SetUserData(expat_.get(), this);
    XML_SetStartElementHandler(expat_.get(), on_begin);
    XML_SetStartDoctypeDeclHandler(expat_.get(), on_doctype);
  }
  Collection(const Collection&) = delete;
  Collection& operator=(const Collection&) = delete;

  std::vector<SeriesEntry> read() {
    constexpr std::size_t most = 1 << 20; // expat takes an int
    for (std::string_view bytes = source_.next_bytes(); !bytes.empty(); bytes = source_.next_bytes())
      for (; !bytes.empty(); bytes.remove_prefix(std::min(most, bytes.size())))
        take(bytes.substr(0, most), false);
    take({}, true);
    if (entries_.empty())
      fail(0, "expected elements DataSet, found none");
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const SeriesEntry& a, const SeriesEntry& b) { return a.time < b.time; });
    for (std::size_t k = 1; k < entries_.size(); ++k)
      if (entries_[k].time == entries_[k - 1].time)
        fail(0, "expected one data set for each time, found several of timestep " +
                    short_text(entries_[k].time, 17) + ": write the state of a time in one part");
    return std::move(entries_);
  }

 private:
  /// expat is C, through which no exception may pass.
  template <class Action>
  static void guard(void* self, Action action) {
    auto& collection = *static_cast<Collection*>(self);
    if (collection.failure_)
      return;
    try {
      action(collection);
    } catch (...) {
      collection.failure_ = std::current_exception();
      XML_StopParser(collection.expat_.get(), XML_FALSE);
    }
  }
  static void on_begin(void* self, const char* element, const char** attributes) {
    guard(self, [&](Collection& collection) { collection.begin(element, attributes); });
  }
  static void on_doctype(void* self, const char*, const char*, const char*, int) {
    guard(self, [](Collection& collection) {
      collection.fail(collection.line(), "expected an element VTKFile, found a document type");
    });
  }

  [[nodiscard]] std::size_t line() const { return XML_GetCurrentLineNumber(expat_.get()); }
  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw FileError(source_.name(), line, what);
  }

  void take(std::string_view bytes, bool last) {
    const XML_Status status =
        XML_Parse(expat_.get(), bytes.data(), static_cast<int>(bytes.size()), last ? 1 : 0);
    if (failure_)
      std::rethrow_exception(failure_);
    if (status == XML_STATUS_ERROR)
      fail(line(), std::string("is no XML: ") + XML_ErrorString(XML_GetErrorCode(expat_.get())));
  }

  void begin(std::string_view element, const char** attribute) {
    std::string_view type, file, time;
    for (; *attribute; attribute += 2) {
      const std::string_view name = attribute[0];
      (name == "type" ? type : name == "file" ? file : name == "timestep" ? time : ignored_) = attribute[1];
    }
    if (!begun_ && (element != "VTKFile" || type != "Collection"))
      fail(line(), "expected an element VTKFile of type Collection, found " + shown(element));
    begun_ = true;
    if (element != "DataSet")
      return;
    const auto number = parse_number(time);
    if (!number || !std::isfinite(*number))
      fail(line(), "expected a number as timestep of a DataSet, found " + shown(time));
    if (file.empty())
      fail(line(), "expected the name of a file in a DataSet");
    entries_.push_back({*number, std::string(file)});
  }

  TextSource source_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> expat_;
  std::vector<SeriesEntry> entries_;
  std::string_view ignored_;
  bool begun_ = false;
  std::exception_ptr failure_;
};

} // namespace

bool is_collection(TextSource& source) {
  for (int k = 0; k < lines_looked_at && source.next(); ++k) {
    const std::string_view line = trimmed(source.line());
    if (k == 0 && !line.starts_with("<?xml") && !line.starts_with("<VTKFile"))
      return false;
    if (const std::size_t at = line.find("<VTKFile"); at != std::string_view::npos)
      return line.substr(at).find("Collection") != std::string_view::npos;
  }
  return false;
}

std::vector<SeriesEntry> read_collection(TextSource source) { return Collection(std::move(source)).read(); }

} // namespace granum::io
