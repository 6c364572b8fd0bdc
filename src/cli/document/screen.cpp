// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <granum/core/text.hpp>

#include "cli/frame/help.hpp"
#include "document.hpp"

namespace granum::cli {

std::string number_text(Dimension dimension, double value) {
  switch (dimension) {
  case Dimension::pressure:
    return pretty(value, dimension);
  case Dimension::dimensionless:
    return short_text(value, 3);
  default:
    return short_text(value, 4) + " " + std::string(si_symbol(dimension));
  }
}

std::string range_text(Dimension dimension, const estimate::Range& range) {
  const std::string low = number_text(dimension, range.low), high = number_text(dimension, range.high);
  const std::size_t blank = low.find(' ');
  const bool one_unit = blank != std::string::npos && high.ends_with(low.substr(blank));
  return fmt::format("{} ({} to {})", number_text(dimension, range.value),
                     one_unit ? low.substr(0, blank) : low, high);
}

std::string with_blanks(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

namespace {

std::string without_blanks_at_end(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

// ---- first screen

std::vector<const Ranges*> answers_in(const Document& document) {
  std::vector<const Ranges*> all;
  for (const Section& section : document.sections)
    if (const auto* ranges = std::get_if<Ranges>(&section.what); ranges != nullptr && !ranges->rows.empty())
      all.push_back(ranges);
  return all;
}

/// "118 MPa (90.73 to 153.3 MPa)", or nothing where an answer does not have the number.
std::string cell_of(const Ranges& answer, const RangeRow& row) {
  const auto same = std::ranges::find(answer.rows, row.key, &RangeRow::key);
  return same != answer.rows.end() && same->range ? range_text(row.dimension, *same->range) : "";
}

/// A line for each row that is always seen, and a column for each answer; for one answer also the meanings.
std::string side_by_side(const std::vector<const Ranges*>& answers) {
  constexpr std::size_t wide = 35;
  if (answers.empty())
    return "";
  std::string head = fmt::format("  {:6}", ""), text;
  for (const Ranges* answer : answers)
    head += fmt::format("{:<{}}", answer->title, wide);
  for (const RangeRow& row : answers.front()->rows) {
    std::string cells;
    for (const Ranges* answer : answers) {
      const std::string cell = cell_of(*answer, row);
      cells += fmt::format("{:<{}}", cell, std::max<std::size_t>(wide, cell.size() + 2));
    }
    if (row.seen == Seen::always && cells.find_first_not_of(' ') != std::string::npos)
      text += without_blanks_at_end(fmt::format("  {:<6}", row.symbol) + cells +
                                    (answers.size() == 1 ? row.meaning : ""));
  }
  return without_blanks_at_end(head) + text;
}

// ---- sections

std::string text_of(const Items& items) {
  std::size_t label_width = 0;
  for (const io::Column<io::Only>& item : items.items)
    if (item.shown)
      label_width = std::max(label_width, item.shown->heading.size() + 1);
  const std::string lines = io::list_text(items.items, io::Only{}, static_cast<int>(label_width));
  return lines.empty() || items.title.empty() ? lines : items.title + "\n" + lines;
}

std::string text_of(const Ranges& ranges) {
  if (ranges.rows.empty())
    return "";
  std::string text =
      ranges.title + fmt::format("\n  {:<7}{:>11} {:>11} {:>11}\n", "", "answer", "low", "high");
  for (const RangeRow& row : ranges.rows)
    if (row.range && row.seen != Seen::data) {
      const auto number = [&row](double value) { return number_text(row.dimension, value); };
      text += fmt::format("  {:<7}{:>11} {:>11} {:>11}  {}\n", row.symbol, number(row.range->value),
                          number(row.range->low), number(row.range->high), row.meaning);
    }
  return text;
}

/// A line for each column, and a column for each row, headed by its name.
std::string columns_text(const Table& table) {
  const auto width_of = [&table](const Cells& row) {
    std::size_t width = std::get<std::string>(row.front()).size();
    for (std::size_t k = 1; k < table.columns.size(); ++k)
      if (const auto& look = table.columns[k].shown)
        width = std::max(width, io::shown_text(*look, row[k], io::screen_sign).size());
    return width + 2;
  };
  std::string head = fmt::format("  {:<12}", "");
  for (const Cells& row : table.rows)
    head += fmt::format("{:>{}}", with_blanks(std::get<std::string>(row.front())), width_of(row));
  std::string text = without_blanks_at_end(head);
  for (std::size_t k = 1; k < table.columns.size(); ++k)
    if (const auto& look = table.columns[k].shown) {
      std::string line = fmt::format("  {:<12}", look->heading);
      for (const Cells& row : table.rows)
        line += fmt::format("{:>{}}", io::shown_text(*look, row[k], io::screen_sign), width_of(row));
      text += without_blanks_at_end(line);
    }
  return text;
}

std::string text_of(const Table& table) {
  const bool any =
      std::ranges::any_of(table.columns, [](const auto& column) { return column.shown.has_value(); });
  if (table.rows.empty() || !any)
    return "";
  std::string text = table.title.empty() ? "" : table.title + "\n";
  if (table.form == Table::Form::columns)
    text += columns_text(table);
  else {
    constexpr std::size_t most = 78;
    const std::string head = io::heading_line(table.columns);
    const std::string indent = head.size() > most ? "" : "  ";
    if (!head.empty())
      text += indent + head + "\n";
    for (const Cells& row : table.rows)
      text += indent + io::row_line(table.columns, row) + "\n";
  }
  return text + (table.remark.empty() ? "" : "  " + table.remark + "\n");
}

std::string text_of(const Prose& prose) {
  std::string text;
  for (const std::string& line : prose.lines)
    text += (line.empty() ? "" : "  ") + line + "\n";
  return text;
}

std::string text_of(const Picture& /*picture*/) { return ""; }
std::string text_of(const Rows& /*rows*/) { return ""; }
std::string text_of(const Data& /*data*/) { return ""; }

} // namespace

std::string screen(const Document& document, bool full) {
  std::string text = document.title + "\n" + (full ? "" : side_by_side(answers_in(document)));
  for (const Section& section : document.sections) {
    const bool answer = std::holds_alternative<Ranges>(section.what);
    const bool seen = full ? section.seen == Seen::always || section.seen == Seen::full
                           : !answer && (section.seen == Seen::always || section.seen == Seen::first);
    if (const std::string lines =
            seen ? std::visit([](const auto& what) { return text_of(what); }, section.what) : "";
        !lines.empty())
      text += (text.empty() ? "" : "\n") + lines;
  }
  std::string notes;
  for (const Note& note : document.notes)
    if (note.seen == Seen::always || (full && note.seen == Seen::full))
      notes += "- " + note.what.sentence() + "\n";
  return within_width(text + (notes.empty() ? "" : "\n") + notes);
}

} // namespace granum::cli
