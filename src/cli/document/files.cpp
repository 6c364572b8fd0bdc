// SPDX-License-Identifier: GPL-3.0-or-later
// A document as JSON, CSV and SVG, and its way to the files that are asked for.
#include <algorithm>
#include <array>
#include <chrono>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/references.hpp>
#include <granum/core/version.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/command_line.hpp"
#include "cli/frame/json_members.hpp"
#include "document.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;

// ---- JSON

/// The member at a key, "answer/shares".
ordered_json& member_at(ordered_json& out, const std::string& key) {
  return key.empty() ? out : out[ordered_json::json_pointer("/" + key)];
}
/// That member as an object, empty where it was missing.
ordered_json& object_at(ordered_json& out, const std::string& key) {
  ordered_json& object = member_at(out, key);
  if (object.is_null())
    object = ordered_json::object();
  return object;
}

ordered_json json_of(const std::optional<estimate::Range>& range) {
  return range ? ordered_json{{"value", range->value}, {"low", range->low}, {"high", range->high}}
               : ordered_json();
}

/// An assumed input.
ordered_json json_of(const estimate::Note& note) {
  ordered_json out;
  if (note.number)
    out["value"] = *note.number;
  else
    out["value"] = note.value;
  if (note.deviation > 0)
    out["deviation"] = note.deviation;
  if (!note.reason.empty())
    out["reason"] = note.reason;
  return out;
}

void put(ordered_json& out, const Items& items) {
  put_members(object_at(out, items.key), items.items, io::Only{});
}

void put(ordered_json& out, const Ranges& ranges) {
  if (ranges.rows.empty())
    member_at(out, ranges.key) = nullptr;
  for (const RangeRow& row : ranges.rows)
    object_at(out, ranges.key)[row.key] = json_of(row.range);
}

void put(ordered_json& out, const Table& table) {
  if (table.form != Table::Form::list)
    for (const Cells& row : table.rows)
      object_at(out, table.key)[std::get<std::string>(row.front())] = members(table.columns, row);
  else if (!table.key.empty())
    member_at(out, table.key) = members_of_all(table.columns, table.rows);
}

void put(ordered_json& out, const Rows& rows) { member_at(out, rows.key) = rows.elements; }

void put(ordered_json& out, const Data& data) {
  ordered_json& member = member_at(out, data.key);
  if (member.is_object() && data.value.is_object())
    member.update(data.value);
  else
    member = data.value;
}

void put(ordered_json& /*out*/, const Picture& /*picture*/) {}
void put(ordered_json& /*out*/, const Prose& /*prose*/) {}

// ---- CSV

/// The one row of all values.
void add_row(io::CsvContent& to, const Document& document) {
  std::vector<io::CsvCell>& cells = to.rows.emplace_back();
  for (const Section& section : document.sections)
    if (const auto* items = std::get_if<Items>(&section.what)) {
      io::add_headings(to, items->items);
      io::add_cells(cells, items->items, io::Only{});
    }
  const auto add = [&](const Ranges& ranges, const RangeRow& row) {
    const std::string unit(si_symbol(row.dimension));
    for (const auto& [name, part] : {std::pair{"answer", &estimate::Range::value},
                                     {"low", &estimate::Range::low},
                                     {"high", &estimate::Range::high}}) {
      to.headings.push_back(
          fmt::format("{}{}_{}{}{}", ranges.before, row.heading, name, unit.empty() ? "" : "_", unit));
      cells.emplace_back(row.range ? (*row.range).*part : io::empty_cell);
    }
  };
  for (const bool with_prefix : {false, true})
    for (const Section& section : document.sections)
      if (const auto* ranges = std::get_if<Ranges>(&section.what);
          ranges != nullptr && ranges->before.empty() != with_prefix)
        for (const RangeRow& row : ranges->rows)
          add(*ranges, row);
}

/// A comment for each key of data.
void add_data(io::CsvContent& to, const Document& document) {
  const ordered_json all = members_of(document.sections);
  std::vector<std::string> keys;
  for (const Section& section : document.sections)
    if (const auto* data = std::get_if<Data>(&section.what);
        data != nullptr && !data->value.is_null() && std::ranges::find(keys, data->key) == keys.end()) {
      keys.push_back(data->key);
      const ordered_json& member = all.at(data->key);
      to.notes.emplace_back(data->key,
                            member.is_string() ? member.get<std::string>() : json_text(member, -1));
    }
}

const Table* table_with_headings(const Document& document) {
  for (const Section& section : document.sections)
    if (const auto* table = std::get_if<Table>(&section.what))
      if (std::ranges::any_of(table->columns, [](const auto& column) { return !column.heading.empty(); }))
        return table;
  return nullptr;
}

} // namespace

std::string input_key(const estimate::Note& note) {
  std::string key = note.name.substr(std::min(note.name.find_first_not_of('-'), note.name.size()));
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

void add_range(io::Items& to, const std::string& key, const estimate::Range& range) {
  for (const auto& [name, part] : {std::pair{"/value", &estimate::Range::value},
                                   {"/low", &estimate::Range::low},
                                   {"/high", &estimate::Range::high}})
    io::add_item(to, key + name, range.*part);
}

ordered_json members_of(const std::vector<Section>& sections) {
  ordered_json out = ordered_json::object();
  for (const Section& section : sections)
    std::visit([&out](const auto& what) { put(out, what); }, section.what);
  return out;
}

ordered_json json(const Document& document) {
  ordered_json out = json_head(document.command);
  out.update(members_of(document.sections));
  ordered_json notes = ordered_json::array();
  for (const Note& note : document.notes) {
    if (!note.what.name.empty())
      out["assumed"][input_key(note.what)] = json_of(note.what);
    notes.push_back(note.what.sentence());
  }
  out["notes"] = std::move(notes);
  return out;
}

void add_sources(Document& to) {
  std::vector<Section> small; // without rows: there may be millions
  for (const Section& section : to.sections)
    if (!std::holds_alternative<Rows>(section.what))
      small.push_back(section);
  std::string text = json_text(members_of(small), -1);
  for (const Note& note : to.notes)
    text += note.what.sentence() + " " + note.what.source + " ";
  const auto part = [](std::string_view Reference::*of) {
    return [of](const Reference& one) {
      return (one.*of).empty() ? std::optional<std::string>() : std::string(one.*of);
    };
  };
  const io::Columns<Reference> columns = {{"", "", [](const Reference& one) { return std::string(one.key); }},
                                          {"", "reference", part(&Reference::text)},
                                          {"", "link", part(&Reference::link)},
                                          {"", "not_checked", part(&Reference::remark)}};
  to.add(Seen::data, table_of("sources", "", columns, references_in(text), Table::Form::named));
}

std::string csv(const Document& document) {
  if (!document.own_text.empty())
    return document.own_text;
  io::CsvContent out{.notes = {{"program", fmt::format("granum {} {}", version(), document.command)}},
                     .headings = {},
                     .rows = {},
                     .manner = document.manner};
  add_data(out, document);
  if (!document.signs.empty())
    out.notes.emplace_back("signs", document.signs);
  out.notes.insert(out.notes.end(), document.comments.begin(), document.comments.end());
  for (const Note& note : document.notes)
    if (note.seen != Seen::data)
      out.notes.emplace_back("note", note.what.sentence());
  for (const Section& section : document.sections)
    if (const auto* rows = std::get_if<Rows>(&section.what)) {
      out.headings = rows->headings;
      return io::csv_text(out) + rows->lines;
    }
  if (const Table* table = table_with_headings(document)) {
    io::add_headings(out, table->columns);
    for (const Cells& row : table->rows)
      io::add_cells(out.rows.emplace_back(), table->columns, row);
  } else
    add_row(out, document);
  return io::csv_text(out);
}

namespace {

/// "29 November 2026", in UTC.
std::string today() {
  constexpr const char* months[] = {"January", "February", "March",     "April",   "May",      "June",
                                    "July",    "August",   "September", "October", "November", "December"};
  const std::chrono::year_month_day day(
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return fmt::format("{} {} {}", static_cast<unsigned>(day.day()),
                     months[static_cast<unsigned>(day.month()) - 1], static_cast<int>(day.year()));
}

} // namespace

std::string picture(const Document& document) {
  for (const Section& section : document.sections)
    if (const auto* of = std::get_if<Picture>(&section.what))
      return plot::svg(of->charts, of->in_a_row);
  throw InvalidArgument("there is no picture of this result");
}

void add_outlets(Command& command, Outlets& outlets, const std::string& picture_help) {
  add_output_options(command, outlets.output);
  command.add(output_group, {{.name = "--full",
                              .value = flag(outlets.full),
                              .meaning = "Show every number, the inputs and all notes on the screen"}});
  add_picture(command, outlets.picture, picture_help);
  add_report(command, outlets.report);
}

void add_report(Command& command, std::string& target) {
  command.add(output_group,
              {{.name = "--report",
                .value = path(target, "FILE.html"),
                .meaning = "Write the result as a page with ranges, notes, full references, and "
                           "the picture"}});
  OptionRow& force = command.row("--force");
  force.needs = {{"--out --picture --report", "--out, --picture or --report"}};
  force.meaning = "Let --out, --picture and --report replace existing files";
}

void require_free(const Outlets& outlets) {
  const std::array<std::pair<const char*, const std::string*>, 3> files = {
      {{"--out", &outlets.output.out}, {"--picture", &outlets.picture}, {"--report", &outlets.report}}};
  for (std::size_t k = 0; k < files.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      if (!files[k].second->empty() && !files[other].second->empty() &&
          io::is_one_file(*files[k].second, *files[other].second))
        throw InvalidArgument(fmt::format("{} and {} name one file, '{}': give each its own",
                                          files[other].first, files[k].first, *files[k].second));
  require_free(outlets.output, outlets.picture);
  require_free({.json = false, .strict = false, .force = outlets.output.force, .out = outlets.report}, "");
  if (!outlets.report.empty() && !outlets.report.ends_with(".html"))
    throw InvalidArgument("--report = '" + outlets.report + "' must end in .html");
}

ExitCode deliver(const Outlets& to, const Document& document) {
  const OutputOptions& output = to.output;
  const bool as_csv = output.out.empty() ? to.csv_on_screen : to.always_csv || output.out.ends_with(".csv");
  const ExitCode code = deliver(output,
                                output.json ? ""
                                : as_csv    ? csv(document)
                                            : screen(document, to.full || !output.out.empty()),
                                output.json ? json(document) : ordered_json(), document.warnings);
  if (!to.picture.empty())
    io::write_file(to.picture, picture(document), existing(output.force));
  if (!to.report.empty())
    io::write_file(to.report, page(document, {.date = today(), .asked = asked_options()}),
                   existing(output.force));
  return code;
}

} // namespace granum::cli
