// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/packing.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/packing_files.hpp>

#include "io/packing_builder.hpp"
#include "io/text/row.hpp"

namespace granum::io {

namespace {

/// A table whose columns come in as SI, by the units of the headings or of a line "# units: SI".
class TableColumns {
 public:
  explicit TableColumns(TextSource source) : TableColumns(source.name(), whole(source)) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const CsvTable& table() const { return table_; }
  [[nodiscard]] bool has(const char* quantity) const { return table_.has(quantity); }

  [[nodiscard]] std::vector<double> numbers(const char* quantity, Dimension dimension) const {
    return table_.numbers(quantity, stated(quantity, dimension));
  }

  /// Index of a column, and the factor from its numbers to SI.
  [[nodiscard]] CsvTable::Place place(const char* quantity, Dimension dimension) const {
    return table_.column(quantity, stated(quantity, dimension));
  }

  /// Integers, such as ids.
  [[nodiscard]] std::vector<long> integers(const char* quantity) const {
    const std::vector<double> values = numbers(quantity, Dimension::dimensionless);
    std::vector<long> result;
    result.reserve(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (values[k] != std::floor(values[k]) || std::abs(values[k]) > 9e15)
        throw FileError(name_, table_.line(k),
                        std::string("expected an integer as ") + quantity + ", found " +
                            short_text(values[k], 17));
      result.push_back(static_cast<long>(values[k]));
    }
    return result;
  }

  /// Three columns, all or none of them.
  [[nodiscard]] std::vector<Vec3> vectors(const std::array<const char*, 3>& names,
                                          Dimension dimension) const {
    if (!has(names[0]) && !has(names[1]) && !has(names[2]))
      return {};
    const auto x = numbers(names[0], dimension), y = numbers(names[1], dimension),
               z = numbers(names[2], dimension);
    std::vector<Vec3> result;
    result.reserve(x.size());
    for (std::size_t k = 0; k < x.size(); ++k)
      result.push_back({x[k], y[k], z[k]});
    return result;
  }

 private:
  TableColumns(std::string name, const std::string& text)
      : name_(name), si_(states_si(name, text)), table_(name, text) {}

  static std::string whole(TextSource& source) {
    std::string text;
    while (source.next()) {
      text += source.line();
      text += '\n';
    }
    return text;
  }

  /// The dimension in the heading of a column; none if a line above declares SI.
  [[nodiscard]] Dimension stated(const char* quantity, Dimension dimension) const {
    const auto& headings = table_.headings();
    const bool bare = std::find(headings.begin(), headings.end(), quantity) != headings.end();
    return bare && si_ ? Dimension::dimensionless : dimension;
  }

  static bool states_si(const std::string& name, const std::string& text) {
    constexpr std::string_view mark = "# units:";
    TextSource source = TextSource::of_text(name, text);
    while (source.next() && (source.line().starts_with('#') || trimmed(source.line()).empty()))
      if (source.line().starts_with(mark)) {
        const std::string_view units = trimmed(source.line().substr(mark.size()));
        if (units != "SI")
          source.fail("expected '# units: SI', found " + shown(units) +
                      "; write other units into the headings");
        return true;
      }
    return false;
  }

  std::string name_;
  bool si_;
  CsvTable table_;
};

std::vector<double> optional_numbers(const TableColumns& columns, const char* quantity, Dimension dimension) {
  return columns.has(quantity) ? columns.numbers(quantity, dimension) : std::vector<double>{};
}

std::vector<GrainRow> grain_rows(const TableColumns& columns) {
  const auto place = columns.vectors({"x", "y", "z"}, Dimension::length);
  if (place.empty())
    throw FileError(columns.name(), 0, "expected columns x, y, z with a unit of length");
  const bool diameters = !columns.has("radius") && columns.has("diameter");
  const auto size = columns.numbers(diameters ? "diameter" : "radius", Dimension::length);
  const auto ids = columns.has("id") ? columns.integers("id") : std::vector<long>{};
  const auto types = columns.has("type") ? columns.integers("type") : std::vector<long>{};
  std::vector<GrainRow> rows;
  rows.reserve(place.size());
  const auto bodies = columns.has("body") ? columns.integers("body") : std::vector<long>{};
  for (std::size_t k = 0; k < place.size(); ++k) {
    rows.push_back({ids.empty() ? static_cast<long>(k) : ids[k], place[k], diameters ? size[k] / 2 : size[k],
                    columns.table().line(k), types.empty() ? std::nullopt : std::optional(types[k])});
    if (!bodies.empty())
      rows.back().body = bodies[k];
  }
  return rows;
}

/// Notes how many digits the coordinates are written with.
void note_digits(PackingBuilder& builder, const TableColumns& columns) {
  DigitWatch watch;
  double unit = 1;
  for (const char* const axis : {"x", "y", "z"}) {
    const CsvTable::Place column = columns.place(axis, Dimension::length);
    unit = column.factor;
    for (std::size_t row = 0; row < columns.table().row_count(); ++row)
      watch.see(columns.table().fields(row)[column.index]);
  }
  builder.note_digits(watch, "coordinates", unit);
}

/// The same of the overlaps and forces that a table of contacts states.
void note_digits(PackingBuilder& builder, const ContactTable& table) {
  DigitWatch overlaps, forces;
  for (const double overlap : table.overlap)
    overlaps.see(exact_text(overlap));
  for (const double force : table.normal_force)
    forces.see(exact_text(force));
  for (const Vec3& force : table.force)
    forces.see(exact_text(force.x));
  builder.note_overlap_digits(overlaps, "overlaps");
  builder.note_force_digits(forces);
}

PackingBuilder grains_built(const TableColumns& columns, const std::string& contact_file,
                            const std::optional<CsvBox>& box) {
  PackingBuilder builder(columns.name(), contact_file);
  if (box)
    builder.set_cell(box->cell, box->periodic, 0);
  builder.set_grains(grain_rows(columns));
  note_digits(builder, columns);
  if (!columns.has("id"))
    builder.note(Finding::ids_assumed, "grains are numbered from 0 in the order of their rows");
  if (!box)
    builder.note(Finding::boundary_unknown,
                 "a table does not state which faces are periodic: none is assumed");
  builder.note(Finding::law_unknown, "contact law and grain material are not in a table");
  return builder;
}

PairRow pair_row(PackingBuilder& builder, const ContactTable& table, std::size_t k) {
  PairRow pair;
  pair.line = table.line[k];
  pair.a = builder.index(table.id[k][0], pair.line);
  pair.b = builder.index(table.id[k][1], pair.line);
  pair.branch =
      table.branch.empty()
          ? builder.touching_image(pair.a, pair.b, table.normal.empty() ? Vec3{} : table.normal[k],
                                   table.overlap.empty()
                                       ? std::nullopt
                                       : std::optional(builder.radius_sum(pair.a, pair.b) - table.overlap[k]))
          : table.branch[k];
  const double length = norm(pair.branch);
  if (pair.a == pair.b || !(length > 0))
    return pair;
  builder.require_agreement(pair);
  const Vec3 n = (1 / length) * pair.branch;
  if (!table.normal.empty() && norm(table.normal[k] - n) > 1e-2)
    builder.fail_contact(pair.line, "the normal does not point from the first grain to the second");
  pair.overlap = table.overlap.empty() ? builder.radius_sum(pair.a, pair.b) - length : table.overlap[k];
  if (!table.force.empty()) {
    pair.normal_force = dot(table.force[k], n);
    pair.tangential_force = table.force[k] - pair.normal_force * n;
  } else if (!table.normal_force.empty()) {
    pair.normal_force = table.normal_force[k];
  }
  return pair;
}

bool names(std::string_view heading, const std::string& column) {
  return heading.starts_with(column) || heading.find("," + column) != std::string_view::npos ||
         heading.find(", " + column) != std::string_view::npos;
}

} // namespace

ContactTable read_contact_csv(TextSource source) {
  const TableColumns columns(std::move(source));
  ContactTable table;
  table.normal = columns.vectors({"nx", "ny", "nz"}, Dimension::dimensionless);
  const bool by_ids = columns.has("id1") && columns.has("id2");
  if (table.normal.empty() && !by_ids)
    throw FileError(columns.name(), 0, "expected columns nx, ny, nz");
  for (std::size_t k = 0; table.normal.empty() && k < columns.table().row_count(); ++k)
    table.line.push_back(columns.table().line(k));
  for (std::size_t k = 0; k < table.normal.size(); ++k) {
    const double length = norm(table.normal[k]);
    table.line.push_back(columns.table().line(k));
    if (!(length > 0) || !std::isfinite(length))
      throw FileError(columns.name(), table.line[k], "expected a normal of some length");
    table.normal[k] *= 1 / length;
  }
  if (columns.has("id1") || columns.has("id2")) {
    const auto first = columns.integers("id1"), second = columns.integers("id2");
    for (std::size_t k = 0; k < first.size(); ++k)
      table.id.push_back({first[k], second[k]});
  }
  table.normal_force = optional_numbers(columns, "fn", Dimension::force);
  table.tangential_size = optional_numbers(columns, "ft", Dimension::force);
  table.force = columns.vectors({"fx", "fy", "fz"}, Dimension::force);
  table.branch = columns.vectors({"lx", "ly", "lz"}, Dimension::length);
  table.overlap = optional_numbers(columns, "delta", Dimension::length);
  for (const auto* numbers : {&table.normal_force, &table.tangential_size, &table.overlap})
    for (std::size_t k = 0; k < numbers->size(); ++k)
      if (!in_range((*numbers)[k]))
        throw FileError(columns.name(), table.line[k], "a force or overlap is beyond all range");
  for (const auto* vectors : {&table.force, &table.branch})
    for (std::size_t k = 0; k < vectors->size(); ++k)
      if (!in_range((*vectors)[k]))
        throw FileError(columns.name(), table.line[k], "a force or line of centres is beyond all range");
  return table;
}

ImportedPacking read_packing_csv(TextSource grains, std::optional<TextSource> contacts,
                                 const std::optional<CsvBox>& box) {
  const std::string contact_file = contacts ? contacts->name() : "";
  PackingBuilder builder = grains_built(TableColumns(std::move(grains)), contact_file, box);
  if (!contacts) {
    builder.note(Finding::contacts_unknown, "no table of contacts was given");
    return builder.finish(0, std::nullopt);
  }
  const ContactTable table = read_contact_csv(std::move(*contacts));
  if (table.id.empty())
    throw FileError(contact_file, 0, "expected columns id1 and id2 to join contacts with grains");
  builder.note(Finding::stiffness_unknown, "stiffnesses are not in a table");
  builder.note(Finding::history_unknown, "the loading history of the contacts is not in a table");
  if (table.force.empty() && table.normal_force.empty()) {
    builder.expect_no_forces();
    builder.note(Finding::forces_unknown, "no columns fn or fx, fy, fz");
  } else if (table.force.empty()) {
    builder.note(Finding::tangential_unknown, "fn and ft do not give the direction of the tangential force");
  }
  note_digits(builder, table);
  for (std::size_t k = 0; k < table.id.size(); ++k)
    builder.add(pair_row(builder, table, k));
  return builder.finish(0, std::nullopt);
}

const PackingFormat csv_format{
    .name = "CSV",
    .sign = "headings separated by commas; contacts if they have nx, ny, nz (without grains) or id1, id2; "
            "else grains",
    .grains = "a CSV table of grains",
    .contacts = "a CSV table of contacts",
    .recognise = [](TextSource& source) -> std::optional<Holds> {
      std::optional<Holds> holds;
      bool heading_seen = false;
      for (int k = 0; k < lines_looked_at && source.next(); ++k) {
        const std::string_view line = trimmed(source.line());
        if (heading_seen || line.empty() || line.starts_with('#'))
          continue;
        heading_seen = true;
        if (line.find(',') != std::string_view::npos)
          holds = names(line, "nx") || names(line, "id1") ? Holds::contacts : Holds::grains;
      }
      return holds;
    },
    .read =
        [](TextSource grains, std::optional<TextSource> contacts, const PackingFileOptions& options) {
          return one_frame(read_packing_csv(std::move(grains), std::move(contacts), options.box));
        },
    .read_contacts =
        [](TextSource source) {
          const std::string name = source.name();
          ContactTable table = read_contact_csv(std::move(source));
          if (table.normal.empty())
            throw FileError(name, 0,
                            "contacts by id1, id2 need their table of grains; alone they need nx, ny, nz");
          return table;
        }};

} // namespace granum::io
