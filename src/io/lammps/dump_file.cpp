// SPDX-License-Identifier: GPL-3.0-or-later
#include "dump_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <granum/core/text.hpp>

namespace granum::io {

namespace {

constexpr std::string_view item = "ITEM:";
constexpr double most_rows = 1e15;

/// Box and periodicity flags "pp ff ss"; any other letters mean a box that ends there.
void set_boundary(DumpBox& box, const std::vector<std::string_view>& words, std::size_t first) {
  if (words.size() < first + 3)
    return;
  box.boundary_known = true;
  for (std::size_t k = 0; k < 3; ++k)
    box.periodic[k] = words[first + k] == "pp";
}

double number_or(std::string_view text, double other) {
  const auto number = parse_number(text);
  return number ? *number : other;
}

/// The box whose corner and far corner a dump gives as bounds of the tilted box.
DumpBox tilted_box(const Vec3& low_bound, const Vec3& high_bound, double xy, double xz, double yz) {
  DumpBox box;
  const Vec3 low{low_bound.x - std::min({0.0, xy, xz, xy + xz}), low_bound.y - std::min(0.0, yz),
                 low_bound.z};
  const Vec3 high{high_bound.x - std::max({0.0, xy, xz, xy + xz}), high_bound.y - std::max(0.0, yz),
                  high_bound.z};
  box.origin = low;
  box.edges = {{{high.x - low.x, xy, xz}, {0, high.y - low.y, yz}, {0, 0, high.z - low.z}}};
  return box;
}

} // namespace

std::optional<std::size_t> find_column(const std::vector<std::string>& columns, std::string_view name) {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

std::optional<DumpUnits> dump_units(std::string_view style) {
  if (style == "si")
    return DumpUnits{1, 1, 1, true};
  if (style == "cgs")
    return DumpUnits{1e-2, 1e-5, 1, true};
  if (style == "micro")
    return DumpUnits{1e-6, 1e-9, 1e-6, true};
  if (style == "nano")
    return DumpUnits{1e-9, 1e-12, 1e-9, true};
  return std::nullopt;
}

bool DumpFile::at_item() const { return source_.line().starts_with(item); }

void DumpFile::read_value(const char* what, TextRow& row) {
  if (!source_.next())
    source_.fail(std::string("the file ends; expected ") + what);
  row.split();
  row.require_size(1, what);
}

/// Labels are the user's (dump_modify label); they are the same word in the two sections that belong
/// together.
bool DumpFile::is_table(std::string_view name, const std::string& label) const {
  if (!label.empty())
    return name == label;
  return name == "ATOMS" || name == "ENTRIES" || name == "CONTACTS";
}

DumpBox DumpFile::read_box(const std::vector<std::string_view>& words) {
  const bool general = words.size() > 4 && words[3] == "abc" && words[4] == "origin";
  const bool tilted = words.size() > 5 && words[3] == "xy" && words[4] == "xz" && words[5] == "yz";
  std::vector<std::string> flags(words.begin() + (general ? 5 : tilted ? 6 : 3), words.end());
  const std::size_t line = source_.line_number();
  const std::size_t width = general ? 4 : tilted ? 3 : 2;
  double number[3][4] = {};
  TextRow row(source_);
  for (auto& numbers : number) {
    if (!source_.next() || at_item())
      source_.fail("expected three lines of box bounds");
    row.split();
    row.require_size(width, "numbers of the box");
    for (std::size_t k = 0; k < width; ++k)
      numbers[k] = row.number(k, "box bound");
  }
  DumpBox box;
  if (general) {
    for (int edge = 0; edge < 3; ++edge)
      for (int k = 0; k < 3; ++k)
        box.edges(k, edge) = number[edge][k];
    box.origin = {number[0][3], number[1][3], number[2][3]};
  } else {
    box = tilted_box({number[0][0], number[1][0], number[2][0]}, {number[0][1], number[1][1], number[2][1]},
                     number[0][2], number[1][2], number[2][2]);
  }
  set_boundary(box, {flags.begin(), flags.end()}, 0);
  box.line = line;
  return box;
}

void DumpFile::read_units() {
  TextRow row(source_);
  read_value("a unit style", row);
  const std::optional<DumpUnits> units = dump_units(row[0]);
  if (!units)
    source_.fail("units " + shown(row[0]) + " are not supported; expected " + known_dump_units);
  units_ = *units;
}

/// Memory is reserved for at most so many rows: the number that a file states may be false.
constexpr std::size_t most_room = 1'000'000;

std::size_t DumpFile::read_table(const DumpFrame& frame, const TableSink& sink) {
  TextRow row(source_);
  row.split();
  const std::vector<std::string> columns(row.fields().begin() + 2, row.fields().end());
  if (columns.empty())
    source_.fail("expected the names of the columns behind " + shown(source_.line()));
  sink.heading(columns, std::min(frame.count.value_or(0), most_room));
  std::size_t rows = 0;
  const auto wanted = [&] { return frame.count ? std::to_string(*frame.count) + " rows" : "rows"; };
  while (!frame.count || rows < *frame.count) {
    const bool more = source_.next();
    if (!more || at_item()) {
      if (frame.count)
        source_.fail("expected " + wanted() + ", found " + std::to_string(rows));
      if (more)
        source_.hold();
      break;
    }
    row.split();
    row.require_size(columns.size(), "fields, as many as the heading names");
    sink.row(row, source_.line_number());
    ++rows;
  }
  return rows;
}

void DumpFile::skip_section() {
  while (source_.next())
    if (at_item())
      return source_.hold();
}

std::optional<double> DumpFile::skip() {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double step = unknown;
  std::size_t wanted = 0, rows = 0;
  std::string label, value_of; // of the table; the section whose value comes next
  bool begun = false, in_table = false, step_comes = false, appended = false;
  while (source_.next()) {
    // A run that appends to what a killed job left begins within the last line.
    if (const std::size_t place = source_.line().find(item, 1); place != std::string_view::npos) {
      source_.hold(place);
      appended = begun = true;
      break;
    }
    if (!at_item()) {
      if (value_of == "TIMESTEP")
        step = number_or(trimmed(source_.line()), unknown);
      else if (value_of == "NUMBER")
        wanted = static_cast<std::size_t>(std::clamp(number_or(trimmed(source_.line()), 0), 0.0, most_rows));
      rows += in_table ? 1 : 0;
      value_of.clear();
      continue;
    }
    TextRow row(source_);
    row.split();
    const std::string name(row.fields().size() > 1 ? row.fields()[1] : "");
    if (in_table || (step_comes && name == "TIMESTEP")) {
      appended = !in_table && std::isnan(step);
      source_.hold();
      break;
    }
    begun = true;
    value_of = name;
    step_comes = step_comes || name == "TIMESTEP";
    if (name == "UNITS")
      read_units();
    else if (name == "NUMBER" && row.fields().size() == 4)
      label = row.fields()[3];
    else
      in_table = is_table(name, label);
  }
  if (!begun)
    return std::nullopt;
  if (std::isnan(step))
    return appended ? no_moment : unknown;
  return in_table && rows >= wanted ? step : ends_early(step);
}

std::optional<DumpFrame> DumpFile::next(const TableSink& sink) {
  DumpFrame frame;
  std::string label;
  std::optional<std::size_t> rows;
  bool begun = false;
  TextRow row(source_);
  while (!(frame.step && frame.count && frame.box && rows)) {
    if (!source_.next()) {
      if (!begun)
        return std::nullopt;
      source_.fail(std::string("the file ends within a frame; expected ITEM: ") + (!frame.step ? "TIMESTEP"
                                                                                   : !frame.count
                                                                                       ? "NUMBER OF ..."
                                                                                   : !frame.box ? "BOX BOUNDS"
                                                                                                : "a table"));
    }
    if (!at_item()) {
      if (trimmed(source_.line()).empty())
        continue;
      source_.fail("expected a line that begins with ITEM:, found " + shown(source_.line()));
    }
    begun = true;
    row.split();
    const auto& words = row.fields();
    const std::string_view name = words.size() > 1 ? words[1] : "";
    if (name == "TIMESTEP" && !frame.step) {
      read_value("a time step", row);
      frame.step = row.integer(0, "time step");
    } else if (name == "TIME" && !frame.time) {
      read_value("a time", row);
      frame.time = row.number(0, "time");
    } else if (name == "UNITS") {
      read_units();
    } else if (name == "NUMBER" && words.size() == 4 && words[2] == "OF" && !frame.count) {
      label = words[3];
      read_value("a number of rows", row);
      frame.count = row.count(0, "rows");
      if (rows && *rows != *frame.count)
        source_.fail("expected " + std::to_string(*frame.count) + " rows, found " + std::to_string(*rows));
    } else if (name == "BOX" && words.size() > 2 && words[2] == "BOUNDS" && !frame.box) {
      frame.box = read_box(words);
    } else if (is_table(name, label) && !rows) {
      rows = read_table(frame, sink);
    } else if (name == "TIMESTEP" || name == "BOX" || name == "NUMBER") {
      source_.fail("the previous frame is not complete, but " + shown(source_.line()) + " comes again");
    } else {
      skip_section();
    }
  }
  if (source_.next()) {
    const std::size_t place = source_.line().rfind(item); // behind what a killed job left
    if (place == std::string_view::npos && !trimmed(source_.line()).empty())
      source_.fail("expected " + std::to_string(*frame.count) + " rows and then ITEM:, found " +
                   shown(source_.line()));
    source_.hold(place == std::string_view::npos ? 0 : place);
  }
  return frame;
}

} // namespace granum::io
