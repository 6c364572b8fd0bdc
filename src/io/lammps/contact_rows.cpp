// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_rows.hpp"

#include <algorithm>
#include <cmath>

#include <granum/core/text.hpp>

namespace granum::io {

namespace {

template <class Row>
Vec3 vector(const Row& row, const ColumnTriple& at, const char* what) {
  return {row.number(at[0], what), row.number(at[1], what), row.number(at[2], what)};
}

/// A row of an unnamed table, read as a TextRow is.
class NumberRow {
 public:
  NumberRow(const UnnamedTable& table, std::size_t row, const PackingBuilder& builder)
      : table_(table), row_(row), builder_(builder) {}

  [[nodiscard]] double number(std::size_t column, const char*) const { return table_.at(row_, column); }
  [[nodiscard]] long integer(std::size_t column, const char* what) const {
    constexpr double largest = 1e15;
    const double value = number(column, what);
    if (!(std::abs(value) <= largest) || value != std::floor(value))
      builder_.fail_contact(table_.lines[row_], "expected an integer as " + std::string(what) + ", found " +
                                                    short_text(value, 17));
    return static_cast<long>(value);
  }

 private:
  const UnnamedTable& table_;
  std::size_t row_;
  const PackingBuilder& builder_;
};

template <class Row>
LocalRow local_row(const Row& row, std::size_t line, const ContactLayout& layout) {
  LocalRow local;
  local.line = line;
  local.id1 = row.integer(layout.id1, "id of grain 1");
  local.id2 = row.integer(layout.id2, "id of grain 2");
  if (layout.difference)
    local.difference = vector(row, *layout.difference, "branch");
  else if (layout.first)
    local.difference = vector(row, *layout.first, "position") - vector(row, *layout.second, "position");
  if (layout.periodic)
    local.through = row.integer(*layout.periodic, "periodic flag") != 0;
  if (layout.overlap)
    local.overlap = row.number(*layout.overlap, "overlap");
  for (const auto& size : {layout.rolling, layout.twisting})
    if (size)
      local.turns = local.turns || row.number(*size, "resistance to turning") != 0;
  if (layout.force)
    local.force = row.number(*layout.force, "force");
  if (layout.normal)
    local.normal = vector(row, *layout.normal, "normal force");
  else if (layout.whole)
    local.normal = vector(row, *layout.whole, "force");
  if (layout.tangential)
    local.tangential = vector(row, *layout.tangential, "tangential force");
  if (layout.has_stiffness()) {
    local.normal_stiffness = row.number(*layout.normal_stiffness, "kn");
    local.tangential_stiffness = row.number(*layout.tangential_stiffness, "kt");
  }
  return local;
}

void to_si(std::vector<LocalRow>& rows, const DumpUnits& units) {
  for (LocalRow& row : rows) {
    row.difference *= units.length;
    row.overlap *= units.length;
    row.force *= units.force;
    row.normal *= units.force;
    row.tangential *= units.force;
    row.normal_stiffness *= units.force / units.length;
    row.tangential_stiffness *= units.force / units.length;
  }
}

/// Appends a row, as numbers.
void add_unnamed(UnnamedTable& table, const TextRow& row, std::size_t line) {
  const std::size_t from = table.numbers.size();
  table.numbers.resize(from + table.columns.size());
  for (const ColumnGroup& compute : table.computes)
    for (const std::size_t k : compute)
      table.numbers[from + k] = row.number(k, "value of " + table.columns[k]);
  table.lines.push_back(line);
}

/// Distance of two vectors of every row from being the normal force: in the order of the layout, and swapped;
/// and the sum of forces to compare with.
struct NormalMisfit {
  double stated = 0, swapped = 0, stated_sum = 0, swapped_sum = 0;
  static constexpr double tolerance = 1e-2; ///< six-digit positions in a box of a thousand grain diameters

  void add(const Vec3& direction, const Vec3& stated_force, const Vec3& other, std::optional<double> force) {
    const auto off = [&](const Vec3& f) {
      return norm(f + (force ? *force : -dot(f, direction)) * direction);
    };
    stated += off(stated_force);
    swapped += off(other);
    stated_sum += norm(stated_force);
    swapped_sum += norm(other);
  }
  [[nodiscard]] bool as_stated() const { return stated <= tolerance * stated_sum; }
  [[nodiscard]] bool is_swapped() const { return swapped_sum > 0 && swapped <= tolerance * swapped_sum; }
};

/// Joins the rows of one frame with its grains.
class LocalJoin {
 public:
  LocalJoin(PackingBuilder& builder, const LocalFrame& locals) : builder_(builder), locals_(locals) {}

  void run() {
    const bool swapped = swapped_forces();
    for (const LocalRow& row : locals_.rows) {
      if (is_empty(row)) {
        builder_.skip_empty();
        continue;
      }
      PairRow pair = geometry(row, swapped);
      set_forces(pair, row, swapped);
      pair.normal_stiffness = row.normal_stiffness;
      pair.tangential_stiffness = row.tangential_stiffness;
      builder_.add(pair);
    }
  }

 private:
  /// No ids, or no line of centres, and no force.
  [[nodiscard]] bool is_empty(const LocalRow& row) const {
    const bool nowhere = locals_.layout->difference && row.difference == Vec3{};
    return ((row.id1 == 0 && row.id2 == 0) || nowhere) && row.force == 0 && row.normal == Vec3{} &&
           row.tangential == Vec3{};
  }

  PairRow geometry(const LocalRow& row, bool swapped) {
    const ContactLayout& layout = *locals_.layout;
    PairRow pair = grains_of(row);
    if (layout.difference || layout.first) {
      pair.branch = row.through ? builder_.nearest(-row.difference) : -row.difference;
      builder_.require_agreement(pair);
    }
    if (!layout.difference && (row.through || !layout.first) && pair.a != pair.b)
      pair.branch = builder_.touching_image(pair.a, pair.b, -(swapped ? row.tangential : row.normal),
                                            distance(pair, row));
    pair.overlap = layout.overlap ? row.overlap : builder_.radius_sum(pair.a, pair.b) - norm(pair.branch);
    return pair;
  }

  PairRow grains_of(const LocalRow& row) const {
    return {.a = builder_.index(row.id1, row.line), .b = builder_.index(row.id2, row.line), .line = row.line};
  }

  /// Distance of the centres, if in the row.
  std::optional<double> distance(const PairRow& pair, const LocalRow& row) const {
    if (!locals_.layout->overlap)
      return std::nullopt;
    return builder_.radius_sum(pair.a, pair.b) - row.overlap;
  }

  static Vec3 direction(const PairRow& pair) { return (1 / norm(pair.branch)) * pair.branch; }

  bool swapped_forces() {
    const ContactLayout& layout = *locals_.layout;
    if (!layout.normal || !layout.tangential)
      return false;
    NormalMisfit misfit;
    for (const LocalRow& row : locals_.rows) {
      if (is_empty(row))
        continue;
      const PairRow ends = grains_of(row);
      if (!layout.difference && ends.a != ends.b && builder_.ambiguous(ends.a, ends.b))
        continue; // the vectors determine the image, once normal and tangential force are identified
      const PairRow pair = geometry(row, false);
      if (norm(pair.branch) > 0)
        misfit.add(direction(pair), row.normal, row.tangential,
                   layout.force ? std::optional(row.force) : std::nullopt);
    }
    if (misfit.as_stated())
      return false;
    if (!misfit.is_swapped())
      builder_.fail_contact(
          locals_.rows.front().line,
          "neither force vector of this frame lies along the lines of centres as a force on "
          "grain 1 does; name the columns with a column map");
    builder_.note(Finding::forces_swapped,
                  "the first force vector is the tangential one, the second the normal");
    return true;
  }

  void set_forces(PairRow& pair, const LocalRow& row, bool swapped) const {
    const ContactLayout& layout = *locals_.layout;
    if (!layout.has_forces() || !(norm(pair.branch) > 0))
      return;
    const Vec3 n = direction(pair);
    const Vec3& along = swapped ? row.tangential : row.normal;
    const Vec3& across = swapped ? row.normal : row.tangential;
    pair.normal_force = layout.force ? row.force : -dot(along, n);
    if (layout.tangential)
      pair.tangential_force = -across;
    else if (layout.whole)
      pair.tangential_force = -(row.normal + -dot(row.normal, n) * n);
  }

  PackingBuilder& builder_;
  const LocalFrame& locals_;
};

/// The layout found from the values of the frame.
void name_columns(PackingBuilder& builder, LocalFrame& locals, const DumpUnits& units) {
  const IdentifiedLayout identified = layout_by_values(locals.unnamed, builder, units.length);
  locals.layout = identified.layout;
  if (!identified.words.empty())
    builder.note(Finding::columns_told, "columns identified by their values: " + identified.words);
  if (identified.swapped)
    builder.note(Finding::forces_swapped,
                 "the first force vector is the tangential one, the second the normal");
}

/// Makes rows of the unnamed table.
void take_unnamed(PackingBuilder& builder, LocalFrame& locals) {
  for (std::size_t row = 0; row < locals.unnamed.rows(); ++row)
    locals.rows.push_back(
        local_row(NumberRow(locals.unnamed, row, builder), locals.unnamed.lines[row], *locals.layout));
  locals.unnamed = {};
}

} // namespace

std::optional<LocalFrame> read_locals(DumpFile& file, const ColumnMap& map) {
  LocalFrame locals;
  TableSink sink;
  sink.heading = [&](const std::vector<std::string>& columns, std::size_t rows) {
    locals.columns = columns;
    locals.layout = contact_layout(columns, map, file.source());
    if (locals.layout)
      locals.rows.reserve(rows);
    else
      locals.unnamed = {
          .columns = columns, .computes = column_groups(columns, "c_"), .numbers = {}, .lines = {}};
  };
  sink.row = [&](const TextRow& row, std::size_t line) {
    if (!locals.layout)
      return add_unnamed(locals.unnamed, row, line);
    const ContactLayout& layout = *locals.layout;
    if (layout.overlap)
      locals.digits.see(row[*layout.overlap]);
    if (layout.difference)
      for (const std::size_t k : *layout.difference)
        locals.digits.see(row[k]);
    if (layout.force)
      locals.force_digits.see(row[*layout.force]);
    else if (layout.normal || layout.whole)
      locals.force_digits.see(row[(layout.normal ? *layout.normal : *layout.whole)[0]]);
    locals.rows.push_back(local_row(row, line, layout));
  };
  auto frame = file.next(sink);
  if (!frame)
    return std::nullopt;
  locals.frame = *frame;
  return locals;
}

namespace {

/// The columns that no layout uses, in the order of the file.
std::vector<std::string> unused_columns(const LocalFrame& locals) {
  const ContactLayout& layout = *locals.layout;
  std::vector<std::size_t> used{layout.id1, layout.id2};
  for (const auto& one : {layout.periodic, layout.overlap, layout.force, layout.rolling, layout.twisting,
                          layout.normal_stiffness, layout.tangential_stiffness})
    if (one)
      used.push_back(*one);
  for (const auto& three :
       {layout.difference, layout.first, layout.second, layout.normal, layout.tangential, layout.whole})
    if (three)
      used.insert(used.end(), three->begin(), three->end());
  std::vector<std::string> out;
  for (std::size_t k = 0; k < locals.columns.size(); ++k)
    if (std::ranges::find(used, k) == used.end())
      out.push_back(locals.columns[k]);
  return out;
}

} // namespace

void join(PackingBuilder& builder, LocalFrame& locals, const DumpUnits& units) {
  builder.note_overlap_digits(locals.digits, "overlaps or lines of centres", units.length);
  builder.note_force_digits(locals.force_digits);
  if (!locals.layout)
    name_columns(builder, locals, units);
  take_unnamed(builder, locals);
  to_si(locals.rows, units);
  if (!locals.layout->has_forces())
    builder.expect_no_forces();
  const auto turning =
      std::count_if(locals.rows.begin(), locals.rows.end(), [](const LocalRow& row) { return row.turns; });
  if (turning > 0)
    builder.note(Finding::contact_moments,
                 std::to_string(turning) +
                     " contacts resist rolling or twisting: their columns are not zero");
  builder.expect_contacts(locals.rows.size());
  LocalJoin(builder, locals).run();
  builder.note_unused(unused_columns(locals), "columns of the contacts");
  locals.rows = {};
}

void note_unknown_contacts(PackingBuilder& builder, const LocalFrame* contacts, const std::string& where) {
  builder.note(Finding::law_unknown, "contact law and grain material are not " + where);
  if (contacts == nullptr) {
    builder.note(Finding::contacts_unknown,
                 where == "in a dump" ? "no dump of contacts was given" : "no contacts were given");
    return;
  }
  if (!contacts->layout->has_stiffness())
    builder.note(Finding::stiffness_unknown, "stiffnesses are not " + where);
  builder.note(Finding::history_unknown, "the loading history of the contacts is not " + where);
  if (!contacts->layout->has_forces())
    builder.note(Finding::forces_unknown, "no column of forces");
  else if (!contacts->layout->has_tangential())
    builder.note(Finding::tangential_unknown, "no columns of tangential forces");
  if (contacts->layout->has_forces())
    builder.note(Finding::viscous_forces, "forces include viscous damping where grains move");
}

} // namespace granum::io
