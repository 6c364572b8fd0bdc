// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/vtk/paraview.hpp>

#include <charconv>

#include <granum/core/text.hpp>
#include <granum/plot/svg_text.hpp>

#include "io/grain_numbers.hpp"

namespace granum::io {

namespace {

/// One file of VTK's XML, piece by piece.
class VtkText {
 public:
  explicit VtkText(const char* type) : type_(type) {
    text_ = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + std::string(type) +
            "\" version=\"1.0\" byte_order=\"LittleEndian\">\n<" + type_ + ">\n";
  }

  void open(const std::string& element) { text_ += '<' + element + ">\n"; }
  void close(const char* element) { text_ += std::string("</") + element + ">\n"; }

  /// An array of `count` tuples of `components` numbers; value(k) is the k-th number of all.
  template <class Value>
  void array(const char* type, std::string_view name, std::size_t count, std::size_t components,
             Value value) {
    text_ += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + plot::svg_escaped(name) +
             "\" NumberOfComponents=\"" + std::to_string(components) + "\" NumberOfTuples=\"" +
             std::to_string(count) + "\" format=\"ascii\">\n";
    for (std::size_t k = 0; k < count * components; ++k) {
      append(value(k));
      text_ += (k + 1) % components == 0 ? '\n' : ' ';
    }
    text_ += "</DataArray>\n";
  }

  std::string finish() { return std::move(text_) + "</" + type_ + ">\n</VTKFile>\n"; }

 private:
  template <class Number>
  void append(Number number) {
    char buffer[64];
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
  }

  std::string type_;
  std::string text_;
};

/// The k-th number of vectors in a row.
double component(const Vec3& v, std::size_t k) { return v[static_cast<int>(k % 3)]; }

std::string counted(const char* name, std::size_t count) {
  return std::string(name) + "=\"" + std::to_string(count) + '"';
}

/// The three edges of the cell, one after the other, and the time.
void add_field_data(VtkText& text, const Mat3& cell, std::optional<double> time) {
  text.open("FieldData");
  if (time)
    text.array("Float64", "TimeValue", 1, 1, [&](std::size_t) { return *time; });
  text.array("Float64", "cell", 1, 9,
             [&](std::size_t k) { return cell(static_cast<int>(k % 3), static_cast<int>(k / 3)); });
  text.close("FieldData");
}

void add_points(VtkText& text, const std::vector<Vec3>& points) {
  text.open("Points");
  text.array("Float64", "Points", points.size(), 3,
             [&](std::size_t k) { return component(points[k / 3], k); });
  text.close("Points");
}

/// Whether the line from i to j meets another image of j than the one in the cell.
bool through_face(const packing::Assembly& assembly, const packing::Contact& c) {
  const Vec3 direct = assembly.position[c.j] - assembly.position[c.i];
  return norm(direct - c.branch) > 0.5 * norm(c.branch);
}

} // namespace

std::string grains_vtu(const packing::Assembly& assembly, std::span<const long> id,
                       std::optional<double> time, std::span<const GrainField> fields) {
  require_numbers(assembly, id, fields);
  const std::size_t count = assembly.grain_count();
  VtkText text("UnstructuredGrid");
  add_field_data(text, assembly.cell, time);
  text.open("Piece " + counted("NumberOfPoints", count) + ' ' + counted("NumberOfCells", count));
  add_points(text, assembly.position);
  text.open("PointData Scalars=\"radius\"");
  text.array("Int64", "id", count, 1, [&](std::size_t k) { return id_of(id, k); });
  for (const GrainField& field : fields)
    if (field.whole)
      text.array("Int64", field.name, count, field.components,
                 [&](std::size_t k) { return static_cast<long>(field.values[k]); });
    else
      text.array("Float64", field.name, count, field.components,
                 [&](std::size_t k) { return field.values[k]; });
  text.close("PointData");
  text.open("Cells");
  text.array("Int64", "connectivity", count, 1, [](std::size_t k) { return k; });
  text.array("Int64", "offsets", count, 1, [](std::size_t k) { return k + 1; });
  text.array("UInt8", "types", count, 1, [](std::size_t) { return 1; }); // a vertex
  text.close("Cells");
  text.close("Piece");
  return text.finish();
}

std::string grains_vtu(const packing::Assembly& assembly, std::span<const long> id,
                       std::optional<double> time) {
  return grains_vtu(assembly, id, time, grain_fields(assembly));
}

std::string contacts_vtp(const packing::Assembly& assembly, std::span<const long> id, KnownForces known) {
  require_numbers(assembly, id);
  const std::size_t between = assembly.contacts.size();
  std::vector<packing::Contact> contacts = assembly.contacts;
  contacts.insert(contacts.end(), assembly.wall_contacts.begin(), assembly.wall_contacts.end());
  const std::size_t count = contacts.size();
  std::vector<Vec3> ends;
  for (const packing::Contact& c : contacts) {
    ends.push_back(assembly.position[c.i]);
    ends.push_back(assembly.position[c.i] + c.branch);
  }

  VtkText text("PolyData");
  text.open("Piece " + counted("NumberOfPoints", 2 * count) + ' ' + counted("NumberOfLines", count));
  add_points(text, ends);
  text.open(known == KnownForces::none ? "CellData" : "CellData Scalars=\"normal_force\"");
  if (known != KnownForces::none)
    text.array("Float64", "normal_force", count, 1, [&](std::size_t k) { return contacts[k].normal_force; });
  if (known == KnownForces::all)
    text.array("Float64", "tangential_force", count, 3,
               [&](std::size_t k) { return component(contacts[k / 3].tangential_force, k); });
  text.array("Float64", "overlap", count, 1, [&](std::size_t k) { return contacts[k].overlap; });
  text.array("UInt8", "sliding", count, 1, [&](std::size_t k) { return contacts[k].sliding ? 1 : 0; });
  text.array("UInt8", "through_face", count, 1,
             [&](std::size_t k) { return k < between && through_face(assembly, contacts[k]) ? 1 : 0; });
  text.array("Int64", "grains", count, 2, [&](std::size_t k) {
    const packing::Contact& c = contacts[k / 2];
    return id_of(id, k % 2 == 0 || k / 2 >= between ? c.i : c.j);
  });
  text.array("Int64", "wall", count, 1,
             [&](std::size_t k) { return k < between ? -1L : static_cast<long>(contacts[k].j); });
  text.array("Float64", "normal_stiffness", count, 1,
             [&](std::size_t k) { return contacts[k].normal_stiffness; });
  text.array("Float64", "tangential_stiffness", count, 1,
             [&](std::size_t k) { return contacts[k].tangential_stiffness; });
  text.close("CellData");
  text.open("Lines");
  text.array("Int64", "connectivity", 2 * count, 1, [](std::size_t k) { return k; });
  text.array("Int64", "offsets", count, 1, [](std::size_t k) { return 2 * (k + 1); });
  text.close("Lines");
  text.close("Piece");
  return text.finish();
}

std::string pvd(std::span<const SeriesEntry> series) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
                     "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const SeriesEntry& entry : series)
    text += "<DataSet timestep=\"" + exact_text(entry.time) + "\" part=\"0\" file=\"" +
            plot::svg_escaped(entry.file) + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

} // namespace granum::io
