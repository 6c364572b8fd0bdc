// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/yade/files.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <granum/core/text.hpp>
#include <granum/io/packing_files.hpp>

#include "io/packing_builder.hpp"
#include "io/text/row.hpp"
#include "io/vtk/document.hpp"

namespace granum::io {

namespace {

/// Numbers of one attribute, point by point or line by line.
struct Attribute {
  std::size_t components = 0;
  std::vector<double> values;
  [[nodiscard]] Vec3 vector(std::size_t k) const {
    return {values[3 * k], values[3 * k + 1], values[3 * k + 2]};
  }
};

/// The parts of a legacy VTK file that spheres and their contacts need.
class LegacyVtk {
 public:
  explicit LegacyVtk(TextSource source) : source_(std::move(source)), row_(source_) { read(); }
  LegacyVtk(const LegacyVtk&) = delete;
  LegacyVtk& operator=(const LegacyVtk&) = delete;

  [[nodiscard]] const TextSource& source() const { return source_; }
  [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }
  [[nodiscard]] const std::vector<std::array<std::size_t, 2>>& lines() const { return lines_; }
  [[nodiscard]] const DigitWatch& digits() const { return digits_; }
  /// Of the attributes.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const auto& [name, attribute] : attributes_)
      out.push_back(name);
    return out;
  }
  /// Line of the file with point k, or line k.
  [[nodiscard]] std::size_t place_of_point(std::size_t k) const { return point_place_[k]; }
  [[nodiscard]] std::size_t place_of_line(std::size_t k) const { return line_place_[k]; }
  /// An attribute of so many values; none if it is not there.
  [[nodiscard]] const Attribute* attribute(const std::string& name, std::size_t components) const {
    const auto found = attributes_.find(name);
    return found != attributes_.end() && found->second.components == components ? &found->second : nullptr;
  }

 private:
  void read() {
    if (!source_.next() || !source_.line().starts_with("# vtk DataFile"))
      source_.fail("expected a first line '# vtk DataFile ...'");
    if (!source_.next() || !source_.next() || source_.line() != "ASCII")
      source_.fail("expected a third line 'ASCII'");
    while (next_row())
      section();
    if (points_.empty())
      source_.fail("the file ends; expected a section POINTS");
  }

  bool next_row() {
    while (source_.next()) {
      row_.split();
      at_ = 0;
      if (!row_.empty())
        return true;
    }
    return false;
  }

  void section() {
    const std::string name(row_[0]);
    if (name == "DATASET") {
      if (row_.size() < 2 || (row_[1] != "POLYDATA" && row_[1] != "UNSTRUCTURED_GRID"))
        source_.fail("expected DATASET POLYDATA or UNSTRUCTURED_GRID");
    } else if (name == "POINTS") {
      read_points(row_.count(1, "points"));
    } else if (name == "LINES") {
      read_lines(row_.count(1, "lines"));
    } else if (name == "VERTICES" || name == "CELLS") {
      skip(row_.count(2, "numbers"));
    } else if (name == "CELL_TYPES") {
      cells_ = row_.count(1, "cells");
      skip(cells_);
    } else if (name == "FIELD") {
      read_field(row_.count(2, "arrays"));
    } else if (name == "POINT_DATA" || name == "CELL_DATA") {
      size_ = row_.count(1, "values");
      if (size_ != (name == "POINT_DATA" ? points_.size() : std::max(lines_.size(), cells_)))
        source_.fail("expected as many values as there are points or lines, found " + std::to_string(size_));
    } else if (name == "VECTORS") {
      read_attribute(3);
    } else if (name == "TENSORS") {
      read_attribute(9);
    } else if (name == "SCALARS") {
      const std::size_t components = row_.size() > 3 ? row_.count(3, "components") : 1;
      if (components < 1 || components > 4)
        source_.fail("expected 1 to 4 components, found " + std::to_string(components));
      read_attribute(components);
    } else {
      source_.fail("expected a section of a VTK file, found " + shown(row_[0]));
    }
  }

  /// The next number, on this line or a later one.
  double number(const char* what) {
    if (at_ == row_.size() && !next_row())
      source_.fail(std::string("the file ends; expected ") + what);
    return row_.number(at_++, what);
  }
  void require_line_end() const {
    if (at_ != row_.size())
      source_.fail("expected the line to end, found " + shown(row_[at_]));
  }

  void read_points(std::size_t count) {
    at_ = row_.size();
    for (std::size_t k = 0; k < count; ++k) {
      Vec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = number("coordinate");
        digits_.see(row_[at_ - 1]);
      }
      points_.push_back(point);
      point_place_.push_back(source_.line_number());
    }
    require_line_end();
  }

  void read_lines(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      if (!next_row())
        source_.fail("the file ends; expected " + std::to_string(count) + " lines, found " +
                     std::to_string(k));
      row_.require_size(3, "integers: 2 and two points");
      const std::array<std::size_t, 2> ends{row_.count(1, "point"), row_.count(2, "point")};
      if (row_[0] != "2" || ends[0] >= points_.size() || ends[1] >= points_.size())
        source_.fail("expected 2 and two numbers of points, found " + shown(source_.line()));
      lines_.push_back(ends);
      line_place_.push_back(source_.line_number());
    }
    at_ = row_.size();
  }

  /// Numbers without information: each point is a vertex.
  void skip(std::size_t count) {
    at_ = row_.size();
    for (std::size_t k = 0; k < count; ++k)
      (void)number("number of a point");
    require_line_end();
  }

  /// Arrays "name components tuples type" with their values, as LIGGGHTS' dump custom/vtk writes them.
  void read_field(std::size_t arrays) {
    constexpr std::size_t most_components = 16;
    for (std::size_t k = 0; k < arrays; ++k) {
      if (!next_row())
        source_.fail("the file ends; expected " + std::to_string(arrays) + " arrays of a FIELD");
      row_.require_size(4, "fields: name components tuples type");
      const std::string name(row_[0]);
      const std::size_t components = row_.count(1, "components"), tuples = row_.count(2, "tuples");
      if (components < 1 || components > most_components || tuples != size_)
        source_.fail("expected as many tuples of 1 to 16 components as there are points or lines");
      at_ = row_.size();
      read_values(name, components);
    }
  }

  void read_attribute(std::size_t components) {
    if (row_.size() < 3)
      source_.fail("expected the name and the type of an attribute");
    const std::string name(row_[1]);
    const bool scalars = row_[0] == "SCALARS";
    if (scalars && (!next_row() || row_[0] != "LOOKUP_TABLE"))
      source_.fail("expected LOOKUP_TABLE");
    at_ = row_.size();
    read_values(name, components);
  }

  void read_values(const std::string& name, std::size_t components) {
    Attribute attribute;
    attribute.components = components;
    for (std::size_t k = 0; k < size_ * components; ++k)
      attribute.values.push_back(number("value"));
    require_line_end();
    attributes_[name] = std::move(attribute);
  }

  TextSource source_;
  TextRow row_;
  std::size_t at_ = 0;   ///< next field of the row
  std::size_t size_ = 0; ///< values of each attribute from here on
  std::size_t cells_ = 0;
  std::vector<Vec3> points_;
  std::vector<std::size_t> point_place_;
  std::vector<std::array<std::size_t, 2>> lines_;
  std::vector<std::size_t> line_place_;
  std::map<std::string, Attribute> attributes_;
  DigitWatch digits_;
};

long integer(const LegacyVtk& file, double value, const char* what) {
  constexpr double largest = 9e15;
  if (!(std::abs(value) <= largest) || value != std::floor(value))
    file.source().fail("expected integers as " + std::string(what) + ", found " + short_text(value, 17));
  return static_cast<long>(value);
}

PackingBuilder grains_built(const LegacyVtk& spheres, const std::string& contact_file,
                            const PackingFileOptions& options) {
  const Attribute* radius = nullptr;
  std::string size_name;
  for (const char* const name : {"radius", "RADIUS", "Radius", "radii", "diameter", "DIAMETER", "Diameter"})
    if (const Attribute* found = spheres.attribute(name, 1); found != nullptr && radius == nullptr) {
      radius = found;
      size_name = name;
    }
  if (!radius || radius->values.size() != spheres.points().size())
    spheres.source().fail("expected point data SCALARS radius or diameter, one for each point");
  const double factor = size_name.ends_with("eter") || size_name.ends_with("ETER") ? 0.5 : 1;
  const auto integers = [&](const char* name) {
    const Attribute* found = spheres.attribute(name, 1);
    return found && found->values.size() == spheres.points().size() ? found : nullptr;
  };
  const Attribute *id = integers("id"), *type = integers("type");
  std::vector<GrainRow> rows;
  for (std::size_t k = 0; k < spheres.points().size(); ++k)
    rows.push_back({id ? integer(spheres, id->values[k], "id") : static_cast<long>(k), spheres.points()[k],
                    factor * radius->values[k], spheres.place_of_point(k),
                    type ? std::optional(integer(spheres, type->values[k], "type")) : std::nullopt});
  PackingBuilder builder(spheres.source().name(), contact_file, options);
  builder.set_grains(std::move(rows));
  builder.note_digits(spheres.digits(), "coordinates");
  if (!id)
    builder.note(Finding::ids_assumed, "grains are numbered from 0 in the order of their points");
  builder.note(Finding::boundary_unknown,
               "a VTK file does not state which faces are periodic: none is assumed");
  builder.note(Finding::units_unknown, "a VTK file has no units: taken as SI");
  builder.note(Finding::law_unknown, "contact law and grain material are not in the files");
  std::vector<std::string> unused = spheres.names();
  std::erase_if(unused, [&](const std::string& name) {
    return name == size_name || (id && name == "id") || (type && name == "type");
  });
  builder.note_unused(unused, "arrays of the grains");
  return builder;
}

/// A contact with a wall across an axis: the line ends at the wall's centre, anywhere in its plane.
/// \param    force   on the wall; its direction gives the axis, otherwise the plane that the grain reaches
/// \return   whether there is such a wall
bool add_wall(PackingBuilder& builder, std::uint32_t grain, const Vec3& centre, const Vec3& force,
              const double* size, std::size_t line) {
  const Vec3 apart = centre - builder.position(grain);
  constexpr double reached = 1.01, along = 0.9;
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    const bool pushed = std::abs(force[k]) > along * norm(force);
    if (std::abs(apart[k]) <= reached * builder.radius(grain) && apart[k] != 0 &&
        (norm(force) > 0 ? pushed : axis < 0 || std::abs(apart[k]) > std::abs(apart[axis])))
      axis = k;
  }
  if (axis < 0)
    return false;
  PairRow row{.a = grain, .line = line};
  row.branch[axis] = apart[axis];
  row.overlap = builder.radius(grain) - std::abs(apart[axis]);
  const double sign = apart[axis] > 0 ? 1 : -1;
  row.normal_force = size != nullptr ? *size : sign * force[axis];
  builder.add_wall(row, 2 * axis + (sign > 0 ? 1 : 0));
  return true;
}

} // namespace

ImportedPacking read_yade_vtk(TextSource spheres, std::optional<TextSource> interactions,
                              const PackingFileOptions& options) {
  const LegacyVtk grains(std::move(spheres));
  if (!interactions) {
    PackingBuilder builder = grains_built(grains, "", options);
    builder.note(Finding::contacts_unknown, "no file of interactions was given");
    return builder.finish(0, std::nullopt);
  }
  const LegacyVtk pairs(std::move(*interactions));
  PackingBuilder builder = grains_built(grains, pairs.source().name(), options);
  const Attribute *normal = pairs.attribute("fn", 3), *sizes = pairs.attribute("fn", 1),
                  *shear = pairs.attribute("ft", 3);
  const std::size_t count = pairs.lines().size();
  if ((normal && normal->values.size() != 3 * count) || (shear && shear->values.size() != 3 * count))
    pairs.source().fail("expected fn and ft as cell data, one for each line");
  builder.note(Finding::stiffness_unknown, "stiffnesses are not in the files");
  builder.note(Finding::history_unknown, "the loading history of the contacts is not in the files");
  if (sizes && sizes->values.size() != count)
    pairs.source().fail("expected fn as cell data, one for each line");
  if (!normal && sizes) {
    builder.note(Finding::tangential_unknown, "fn is a number, and no vectors ft");
  } else if (!normal) {
    builder.expect_no_forces();
    builder.note(Finding::forces_unknown, "no vectors fn");
  } else if (!shear) {
    builder.note(Finding::tangential_unknown, "no vectors ft");
  }
  std::vector<std::string> unused = pairs.names();
  std::erase_if(unused, [&](const std::string& name) {
    return ((normal || sizes) && name == "fn") || (normal && shear && name == "ft");
  });
  builder.note_unused(unused, "arrays of the contacts");
  const CentreIndex centres(grains.points());
  for (std::size_t k = 0; k < count; ++k) {
    PairRow pair;
    pair.line = pairs.place_of_line(k);
    const Vec3 &from = pairs.points()[pairs.lines()[k][0]], &to = pairs.points()[pairs.lines()[k][1]];
    const auto a = centres.look_up(from, builder, pair.line), b = centres.look_up(to, builder, pair.line);
    if (!a || !b) {
      const Vec3 f = normal ? normal->vector(k) : Vec3{};
      const double* size = sizes ? &sizes->values[k] : nullptr;
      if (!(a || b) || !add_wall(builder, a ? *a : *b, a ? to : from, a ? f : -f, size, pair.line))
        builder.fail_contact(pair.line,
                             "the contact ends at no centre of a sphere, nor at a wall across an axis "
                             "that the grain reaches; facets, and pairs through periodic faces, need "
                             "share/yade/granum_export.py");
      continue;
    }
    pair.a = *a;
    pair.b = *b;
    pair.branch = builder.straight(pair.a, pair.b);
    const double length = norm(pair.branch);
    if (length > 0) {
      pair.overlap = builder.radius_sum(pair.a, pair.b) - length;
      if (normal)
        pair.normal_force = dot(normal->vector(k), (1 / length) * pair.branch);
      if (!normal && sizes)
        pair.normal_force = sizes->values[k];
      if (normal && shear)
        pair.tangential_force = shear->vector(k);
    }
    builder.add(pair);
  }
  return builder.finish(0, std::nullopt);
}

const PackingFormat yade_vtk_format{
    .name = "VTK of YADE and LIGGGHTS",
    .sign = "a first line # vtk DataFile: export.VTKExporter, dump custom/vtk",
    .grains = "grains as legacy VTK",
    .contacts = "contacts of YADE as VTK",
    .recognise = [](TextSource& source) -> std::optional<Holds> {
      if (!source.next() || !source.line().starts_with("# vtk DataFile"))
        return std::nullopt;
      while (source.next())
        if (source.line().starts_with("LINES"))
          return Holds::contacts;
      return Holds::grains;
    },
    .read =
        [](TextSource grains, std::optional<TextSource> contacts, const PackingFileOptions& options) {
          return one_frame(read_yade_vtk(std::move(grains), std::move(contacts), options));
        }};

} // namespace granum::io
