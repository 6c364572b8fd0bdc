// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/packing.hpp>

#include <algorithm>
#include <cmath>
#include <span>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/packing_files.hpp>

#include "io/packing_builder.hpp"
#include "io/text/row.hpp"

namespace granum::io {

namespace {

/// Other names of quantities: of ParaView's tables, and of PFC's ends of contacts.
struct OtherName {
  std::string_view quantity, name;
};
constexpr OtherName other_names[] = {{"x", "Points:0"},
                                     {"y", "Points:1"},
                                     {"z", "Points:2"},
                                     {"x", "Points_0"},
                                     {"y", "Points_1"},
                                     {"z", "Points_2"},
                                     {"radius", "Radius"},
                                     {"radius", "RADIUS"},
                                     {"radius", "radii"},
                                     {"diameter", "Diameter"},
                                     {"diameter", "DIAMETER"},
                                     {"id1", "end1"},
                                     {"id2", "end2"},
                                     {"id", "Id"},
                                     {"id", "ID"}};
constexpr std::string_view separators = ",;\t ";

bool is_heading(std::string_view line) { return !line.empty() && line[0] != '#'; }

/// Whether blanks alone separate the words of a line.
bool by_blanks(std::string_view line) {
  return line.find_first_of(",;\t\"") == std::string_view::npos && line.find(' ') != std::string_view::npos;
}

constexpr std::string_view normal_stiffnesses[] = {"kn", "k_n", "normal_stiffness"};
constexpr std::string_view tangential_stiffnesses[] = {
    "kt", "k_t", "ks", "k_s", "tangential_stiffness", "shear_stiffness"};

/// Whether a heading is one of some names, with the unit N/m or none.
bool is_one_of(std::string_view heading, std::span<const std::string_view> names) {
  constexpr std::string_view unit = "_N/m";
  if (heading.ends_with(unit))
    heading.remove_suffix(unit.size());
  return std::ranges::find(names, heading) != names.end();
}

/// A table whose columns come in as SI, by the units of the headings or of a line "# units: SI".
class TableColumns {
 public:
  TableColumns(TextSource source, const PackingFileOptions& options)
      : TableColumns(source.name(), whole(source), options.si) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const CsvTable& table() const { return table_; }
  [[nodiscard]] bool has(const char* quantity) const { return table_.has(name_of(quantity)); }
  /// Whether ParaView wrote it, without units.
  [[nodiscard]] bool without_units() const { return paraview_; }

  [[nodiscard]] std::vector<double> numbers(const char* quantity, Dimension dimension) const {
    const std::string_view name = name_of(quantity);
    return table_.numbers(name, stated(name, dimension));
  }

  /// A stiffness [N/m] by one of its names, with the unit N/m or none; empty if there is none.
  [[nodiscard]] std::vector<double> stiffness(std::span<const std::string_view> names) const {
    const auto& headings = table_.headings();
    const auto found =
        std::ranges::find_if(headings, [&](const auto& heading) { return is_one_of(heading, names); });
    std::vector<double> out;
    for (std::size_t row = 0; found != headings.end() && row < table_.row_count(); ++row) {
      const std::string& field = table_.fields(row)[static_cast<std::size_t>(found - headings.begin())];
      const auto number = parse_number(field);
      if (!number || !(*number >= 0) || !in_range(*number))
        throw FileError(name_, table_.line(row),
                        "expected a stiffness >= 0 in column '" + *found + "', found " + shown(field));
      out.push_back(*number);
    }
    return out;
  }

  /// The headings that are of none of the quantities.
  [[nodiscard]] std::vector<std::string> unused(std::initializer_list<const char*> quantities) const {
    std::vector<std::string> out = table_.headings();
    std::erase_if(out, [&](const std::string& heading) {
      return std::ranges::any_of(quantities,
                                 [&](const char* one) { return is_column_of(heading, name_of(one)); });
    });
    return out;
  }

  /// Index of a column, and the factor from its numbers to SI.
  [[nodiscard]] CsvTable::Place place(const char* quantity, Dimension dimension) const {
    const std::string_view name = name_of(quantity);
    return table_.column(name, stated(name, dimension));
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
  TableColumns(std::string name, const std::string& text, bool si)
      : name_(name), si_(si || states_si(name, text)), table_(name, text),
        paraview_(table_.has("Points:0") || table_.has("Points_0")) {}

  /// The text; where blanks separate the headings, a tab between the fields instead.
  static std::string whole(TextSource& source) {
    std::string text;
    bool heading = true, blanks = false;
    TextRow row(source);
    while (source.next()) {
      const std::string_view line = trimmed(source.line());
      if (heading && is_heading(line)) {
        heading = false;
        blanks = by_blanks(line);
      }
      if (blanks && is_heading(line)) {
        row.split();
        for (std::size_t k = 0; k < row.size(); ++k)
          (text += k > 0 ? "\t" : "") += row[k];
      } else {
        text += source.line();
      }
      text += '\n';
    }
    return text;
  }

  /// The name of a quantity in this table.
  [[nodiscard]] std::string_view name_of(std::string_view quantity) const {
    if (!table_.has(quantity))
      for (const OtherName& other : other_names)
        if (other.quantity == quantity && table_.has(other.name))
          return other.name;
    return quantity;
  }

  /// The dimension in the heading of a column; none if the numbers are SI.
  [[nodiscard]] Dimension stated(std::string_view quantity, Dimension dimension) const {
    const auto& headings = table_.headings();
    const bool bare =
        std::ranges::any_of(headings, [&](const auto& heading) { return same_word(heading, quantity); });
    if (bare && dimension != Dimension::dimensionless && !si_ && !paraview_)
      throw FileError(name_, table_.heading_line(),
                      "the heading '" + std::string(quantity) + "' has no unit: write '" +
                          std::string(quantity) + "_" + std::string(si_symbol(dimension)) +
                          "' or another unit, or state that the numbers are SI, by --units si or a line "
                          "'# units: SI'");
    return bare ? Dimension::dimensionless : dimension;
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
  bool paraview_;
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
                            const PackingFileOptions& options) {
  PackingBuilder builder(columns.name(), contact_file, options);
  builder.set_grains(grain_rows(columns));
  note_digits(builder, columns);
  if (!columns.has("id"))
    builder.note(Finding::ids_assumed, "grains are numbered from 0 in the order of their rows");
  builder.note(Finding::boundary_unknown, "a table does not state which faces are periodic: none is assumed");
  if (columns.without_units())
    builder.note(Finding::units_unknown, "a table of ParaView has no units: taken as SI");
  builder.note(Finding::law_unknown, "contact law and grain material are not in a table");
  builder.note_unused(columns.unused({"x", "y", "z", "radius", "diameter", "id", "type", "body"}),
                      "columns of the grains");
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
  if (!table.normal_stiffness.empty()) {
    pair.normal_stiffness = table.normal_stiffness[k];
    pair.tangential_stiffness = table.tangential_stiffness[k];
  }
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

/// Leaves out the rows that hold zeros alone.
void drop_empty_rows(ContactTable& table) {
  const auto zero = [&](std::size_t k) {
    const auto none = [&](const std::vector<double>& values) { return values.empty() || values[k] == 0; };
    const auto nowhere = [&](const std::vector<Vec3>& values) {
      return values.empty() || values[k] == Vec3{};
    };
    const bool unnamed = !table.id.empty() && table.id[k][0] == 0 && table.id[k][1] == 0;
    const bool no_line = !table.normal.empty() && table.normal[k] == Vec3{};
    return (unnamed || no_line) && none(table.normal_force) && none(table.tangential_size) &&
           none(table.overlap) && nowhere(table.force) && nowhere(table.branch);
  };
  std::vector<bool> drop(table.line.size());
  for (std::size_t k = 0; k < drop.size(); ++k)
    drop[k] = zero(k);
  table.empty_rows = static_cast<std::size_t>(std::ranges::count(drop, true));
  if (table.empty_rows == 0)
    return;
  const auto thin = [&](auto& values) {
    std::size_t k = 0;
    std::erase_if(values, [&](const auto&) { return drop[k++]; });
  };
  thin(table.normal);
  thin(table.id);
  thin(table.force);
  thin(table.branch);
  thin(table.line);
  for (auto* values : {&table.normal_force, &table.tangential_size, &table.overlap, &table.normal_stiffness,
                       &table.tangential_stiffness})
    thin(*values);
}

/// Whether a word of a heading line begins with a name.
bool names(std::string_view heading, std::string_view name) {
  for (std::size_t at = heading.find(name); at != std::string_view::npos; at = heading.find(name, at + 1))
    if (at == 0 || separators.find(heading[at - 1]) != std::string_view::npos || heading[at - 1] == '"')
      return true;
  return false;
}

/// Contacts or grains, by the heading line of a table; empty for words between blanks that name neither.
std::optional<Holds> holds_by(std::string_view heading) {
  for (const char* const column : {"nx", "id1", "end1"})
    if (names(heading, column))
      return Holds::contacts;
  const bool table = heading.find_first_of(",;\t") != std::string_view::npos;
  return table || (by_blanks(heading) && names(heading, "x")) ? std::optional(Holds::grains) : std::nullopt;
}

} // namespace

ContactTable read_contact_csv(TextSource source, const PackingFileOptions& options) {
  const TableColumns columns(std::move(source), options);
  ContactTable table;
  table.normal = columns.vectors({"nx", "ny", "nz"}, Dimension::dimensionless);
  const bool by_ids = columns.has("id1") && columns.has("id2");
  if (table.normal.empty() && !by_ids)
    throw FileError(columns.name(), 0, "expected columns nx, ny, nz");
  for (std::size_t k = 0; k < columns.table().row_count(); ++k)
    table.line.push_back(columns.table().line(k));
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
  table.unused = columns.unused(
      {"nx", "ny", "nz", "id1", "id2", "fn", "ft", "fx", "fy", "fz", "lx", "ly", "lz", "delta"});
  table.normal_stiffness = columns.stiffness(normal_stiffnesses);
  table.tangential_stiffness = columns.stiffness(tangential_stiffnesses);
  const bool both = !table.normal_stiffness.empty() && !table.tangential_stiffness.empty();
  if (!both)
    table.normal_stiffness = table.tangential_stiffness = {};
  else
    std::erase_if(table.unused, [](const std::string& heading) {
      return is_one_of(heading, normal_stiffnesses) || is_one_of(heading, tangential_stiffnesses);
    });
  drop_empty_rows(table);
  for (std::size_t k = 0; k < table.normal.size(); ++k) {
    const double length = norm(table.normal[k]);
    if (!(length > 0) || !std::isfinite(length))
      throw FileError(columns.name(), table.line[k], "expected a normal of some length");
    table.normal[k] *= 1 / length;
  }
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
                                 const PackingFileOptions& options) {
  const std::string contact_file = contacts ? contacts->name() : "";
  PackingBuilder builder = grains_built(TableColumns(std::move(grains), options), contact_file, options);
  if (!contacts) {
    builder.note(Finding::contacts_unknown, "no table of contacts was given");
    return builder.finish(0, std::nullopt);
  }
  const ContactTable table = read_contact_csv(std::move(*contacts), options);
  if (table.id.empty())
    throw FileError(contact_file, 0, "expected columns id1 and id2 to join contacts with grains");
  if (table.normal_stiffness.empty())
    builder.note(Finding::stiffness_unknown, "no columns of both stiffnesses, kn and kt");
  builder.skip_empty(table.empty_rows);
  builder.note(Finding::history_unknown, "the loading history of the contacts is not in a table");
  if (table.force.empty() && table.normal_force.empty()) {
    builder.expect_no_forces();
    builder.note(Finding::forces_unknown, "no columns fn or fx, fy, fz");
  } else if (table.force.empty()) {
    builder.note(Finding::tangential_unknown, "fn and ft do not give the direction of the tangential force");
  }
  note_digits(builder, table);
  builder.note_unused(table.unused, "columns of the contacts");
  for (std::size_t k = 0; k < table.id.size(); ++k)
    builder.add(pair_row(builder, table, k));
  return builder.finish(0, std::nullopt);
}

const PackingFormat csv_format{
    .name = "CSV",
    .sign = "headings separated by commas, semicolons, tabs or blanks; contacts if they have nx, ny, nz "
            "(without grains) or id1, id2; "
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
        holds = holds_by(line);
      }
      return holds;
    },
    .read =
        [](TextSource grains, std::optional<TextSource> contacts, const PackingFileOptions& options) {
          return one_frame(read_packing_csv(std::move(grains), std::move(contacts), options));
        },
    .read_contacts =
        [](TextSource source, const PackingFileOptions& options) {
          const std::string name = source.name();
          ContactTable table = read_contact_csv(std::move(source), options);
          if (table.normal.empty())
            throw FileError(name, 0,
                            "contacts by id1, id2 need their table of grains; alone they need nx, ny, nz");
          return table;
        }};

} // namespace granum::io
