// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <granum/core/text.hpp>
#include <granum/core/version.hpp>
#include <granum/estimate/inputs.hpp>
#include <granum/plot/page.hpp>
#include <granum/plot/svg_text.hpp>

#include "document.hpp"
#include "page_text.hpp"

namespace granum::cli {

namespace {

/// "sand (measured laws): G is 118 MPa (90.73 to 153.3 MPa), V_s is ...", the first numbers of an answer.
std::string sentence_of(const Ranges& ranges) {
  constexpr std::size_t most = 3;
  std::vector<std::string> parts;
  for (const RangeRow& row : ranges.rows)
    if (row.range && row.seen == Seen::always && parts.size() < most)
      parts.push_back(row.symbol + " is " + range_text(row.dimension, *row.range));
  return fmt::format("{}: {}.", ranges.title, fmt::join(parts, ", "));
}

std::string titled(const std::string& title, const std::string& content) {
  return (title.empty() ? "" : plot::html_paragraph(title)) + content;
}

std::string html_of(const Ranges& ranges) {
  std::vector<std::vector<std::string>> rows;
  for (const RangeRow& row : ranges.rows)
    if (row.range) {
      std::vector<std::string>& cells = rows.emplace_back(std::vector{row.symbol});
      for (const double number : {row.range->value, row.range->low, row.range->high})
        cells.push_back(number_text(row.dimension, number));
      cells.push_back(row.meaning);
    }
  return rows.empty()
             ? ""
             : titled(ranges.title, plot::html_table({"", "answer", "low", "high", "meaning"}, rows) +
                                        plot::html_paragraph(what_a_range_means, "soft"));
}

std::string html_of(const Items& items) {
  std::vector<std::vector<std::string>> rows;
  bool meanings = false;
  for (const io::Column<io::Only>& item : items.items)
    if (const io::Value value = item.of(io::Only{});
        item.shown && item.shown->listed && !io::is_nothing(value)) {
      rows.push_back(
          {item.shown->heading, io::shown_text(*item.shown, value, io::page_sign), item.shown->meaning});
      meanings = meanings || !item.shown->meaning.empty();
    }
  if (!meanings)
    for (std::vector<std::string>& row : rows)
      row.pop_back();
  const std::vector<std::string> headings = {"", "value", "meaning"};
  return rows.empty()
             ? ""
             : titled(items.title, plot::html_table({headings.begin(), headings.end() - !meanings}, rows));
}

/// Lists of the same labels, one after the other, as rows of one table.
std::string html_of(const std::vector<const Items*>& lists) {
  std::vector<std::string> headings = {""};
  std::vector<std::vector<std::string>> rows;
  for (const Items* list : lists) {
    std::vector<std::string>& cells = rows.emplace_back(std::vector{list->title});
    for (const io::Column<io::Only>& item : list->items)
      if (item.shown) {
        cells.push_back(io::shown_text(*item.shown, item.of(io::Only{}), io::page_sign));
        if (rows.size() == 1)
          headings.push_back(item.shown->heading);
      }
  }
  return plot::html_table(headings, rows);
}

/// The labels of a list that can be a row of a table: one with a title and without meanings; else none.
std::vector<std::string> labels_of(const Items& list) {
  std::vector<std::string> all;
  for (const io::Column<io::Only>& item : list.items)
    if (item.shown && (list.title.empty() || !item.shown->meaning.empty()))
      return {};
    else if (item.shown)
      all.push_back(item.shown->heading);
  return all;
}
bool are_alike(const Items& a, const Items& b) {
  return !labels_of(a).empty() && labels_of(a) == labels_of(b);
}

std::string html_of(const Table& table) {
  if (table.rows.empty())
    return "";
  io::Columns<Cells> columns = table.columns;
  if (table.form == Table::Form::columns) {
    columns.front() = {"", "",
                       [](const Cells& cells) { return with_blanks(std::get<std::string>(cells.front())); },
                       shown_as("")};
    for (io::Column<Cells>& column : columns)
      if (column.shown)
        column.shown->width = 1; // each is a column of the page too
  }
  for (io::Column<Cells>& column : columns)
    if (column.key == "source" && !column.shown)
      column.shown = shown_as("source", {}, 1);
  for (io::Column<Cells>& column : columns)
    column.of = [of = column.of](const Cells& cells) -> io::Value {
      io::Value value = of(cells);
      const auto* text = std::get_if<std::string>(&value);
      return text == nullptr ? value : plot::printed_signs(*text);
    };
  const std::string content =
      io::page_table(columns, table.rows) + (table.remark.empty() ? "" : plot::html_paragraph(table.remark));
  return table.folded ? plot::html_folded(table.title, content) : titled(table.title, content);
}

std::string html_of(const Prose& prose) {
  std::string text;
  for (const std::string& line : prose.lines)
    text += line.empty() ? "" : plot::html_paragraph(line);
  return text;
}

plot::PageFigure figure_of(const Picture& picture) {
  plot::PageFigure figure{.caption = picture.caption};
  for (std::size_t k = 0; k < picture.charts.size(); ++k)
    figure.pictures.push_back({.svg = plot::svg_in_page(picture.charts[k]),
                               .choice = k < picture.choices.size() ? picture.choices[k] : ""});
  if (!picture.drawn.empty())
    figure.pictures.push_back({.svg = picture.drawn});
  for (const std::string& file : picture.files)
    figure.files.push_back({file.substr(file.rfind('/') + 1), file});
  return figure;
}

std::string html_of(const Picture& /*picture*/) { return ""; }
std::string html_of(const Rows& /*rows*/) { return ""; }
std::string html_of(const Data& /*data*/) { return ""; }

/// A section, and those behind it that are rows of its table.
/// \param    k   its place; then that of the last of them
std::string html_of(const std::vector<Section>& sections, std::size_t& k) {
  const auto list_at = [&](std::size_t at) {
    return at < sections.size() ? std::get_if<Items>(&sections[at].what) : nullptr;
  };
  std::vector<const Items*> lists = {list_at(k)};
  while (lists.front() != nullptr && list_at(k + 1) != nullptr && are_alike(*lists.front(), *list_at(k + 1)))
    lists.push_back(list_at(++k));
  if (lists.size() > 1)
    return html_of(lists);
  return std::visit([](const auto& what) { return html_of(what); }, sections[k].what);
}

} // namespace

namespace {

// ---- what was asked, and what is assumed

/// The first clause of a meaning: "Void ratio" of "Void ratio, instead of --porosity"; the name of the option
/// in words where that is one of its choices.
std::string clause_of(const std::string& meaning, const std::string& option) {
  std::size_t end = meaning.size();
  for (const char* mark : {";", ":", ", instead of", ", such as", ", by default", ", separated by"})
    end = std::min(end, meaning.find(mark));
  if (meaning.find(' ') < end)
    return meaning.substr(0, end);
  std::string words = option.substr(std::min(option.find_first_not_of('-'), option.size()));
  std::replace(words.begin(), words.end(), '-', ' ');
  return words;
}

std::string html_asked(const std::vector<AskedOption>& asked) {
  std::vector<std::vector<std::string>> rows;
  for (const AskedOption& one : asked)
    rows.push_back({clause_of(one.meaning, one.option), one.value, one.option});
  return rows.empty() ? "" : plot::html_table({"what", "as given", "option"}, rows);
}

/// Rows of CSV, folded away, with four digits.
std::string html_rows(const Rows& rows, io::CsvManner manner) {
  if (rows.lines.empty())
    return "";
  const std::vector<io::CsvCell> headings(rows.headings.begin(), rows.headings.end());
  const io::CsvTable table("rows", io::csv_line(headings, manner) + rows.lines);
  std::vector<std::vector<std::string>> all;
  for (std::size_t row = 0; row < table.row_count(); ++row)
    for (std::string& cell : all.emplace_back(table.fields(row)))
      if (const std::optional<double> number = parse_number(cell))
        cell = short_text(*number, 4);
  return plot::html_folded("Every row", plot::html_table(rows.headings, all));
}

/// "29 November 2026, granum 0.2.0".
std::string dated(const Record& record) { return record.date + ", granum " + std::string(version()); }

/// A row for each assumed input; below it what else the answer rests on.
std::string html_assumptions(const std::vector<Note>& notes) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> sentences;
  for (const Note& note : notes) {
    const estimate::Note& what = note.what;
    if (note.seen == Seen::data)
      continue;
    if (what.name.empty()) {
      sentences.push_back(what.sentence());
      continue;
    }
    const estimate::InputRow* const row = estimate::find_input(input_key(what));
    rows.push_back({clause_of(row != nullptr ? row->meaning : "", what.name), what.value,
                    what.deviation > 0 ? pretty(what.deviation, what.dimension) : "-", what.reason,
                    what.name});
  }
  return (rows.empty()
              ? ""
              : plot::html_table({"assumed", "value", "one standard deviation", "why", "option that sets it"},
                                 rows)) +
         (sentences.empty() ? "" : plot::html_list(sentences));
}

} // namespace

std::string page(const Document& document, const Record& record) {
  std::vector<std::string> sentences = document.sentences;
  std::vector<plot::PageFigure> figures;
  std::string numbers, every_row, pictures, folded;
  bool ranges_above = false;
  for (std::size_t k = 0; k < document.sections.size(); ++k) {
    const Section& section = document.sections[k];
    if (const auto* ranges = std::get_if<Ranges>(&section.what); ranges != nullptr && !ranges->rows.empty()) {
      sentences.push_back(sentence_of(*ranges));
      ranges_above = true;
    }
    if (const auto* of = std::get_if<Picture>(&section.what)) {
      if (of->folded.empty())
        figures.push_back(figure_of(*of));
      else
        folded += plot::html_folded(of->folded, plot::html_figure(figure_of(*of)));
    }
    if (const auto* rows = std::get_if<Rows>(&section.what))
      every_row += html_rows(*rows, document.manner);
    if (section.seen == Seen::always || section.seen == Seen::full)
      numbers += html_of(document.sections, k);
  }
  if (ranges_above)
    sentences.push_back(std::string("In brackets: low to high. ") + what_a_range_means);
  sentences.insert(sentences.end(), document.sentences_after.begin(), document.sentences_after.end());
  if (!record.date.empty())
    sentences.push_back(dated(record));
  const bool in_a_row = figures.size() == 1 && figures.front().pictures.size() > 2 &&
                        figures.front().pictures.front().choice.empty();
  std::string row;
  if (in_a_row)
    row = plot::html_element("div", plot::html_figure(std::exchange(figures.front(), {})), "row");
  if (figures.empty())
    figures.emplace_back();
  for (std::size_t k = 1; k < figures.size(); ++k)
    pictures += plot::html_figure(figures[k]);
  if (!pictures.empty())
    pictures = plot::html_element("div", pictures, "trio");
  if (!pictures.empty() || !folded.empty())
    pictures = plot::html_section("pictures", "Pictures", pictures + folded);
  const std::string text = screen(document, true);
  const std::vector<Reference> sources = references_in(text + json_text(json(document), -1));
  const auto worded = [&](const std::string& html) {
    return with_source_links(document.manner.decimal_sign == ',' ? with_decimal_commas(html) : html, sources);
  };
  const auto section_of = [](const char* id, const char* title, const std::string& content) {
    return content.empty() ? "" : plot::html_section(id, title, content);
  };
  const std::string& question = document.question.empty() ? document.title : document.question;
  std::string body = worded(plot::html_first_screen(question, sentences, figures.front()) + row);
  body += section_of("asked", "What was asked", html_asked(record.asked));
  body += worded(pictures + section_of("numbers", "Every number", numbers + every_row));
  if (!document.warnings.ok())
    body += worded(plot::html_section("warnings", "Warnings", plot::html_list(document.warnings.notes)));
  body += worded(section_of("assumptions", "Assumptions", html_assumptions(document.notes)));
  body += section_of("sources", "Sources", html_sources(sources));
  body += worded(plot::html_section(
      "all", "All results", plot::html_folded("Output on the terminal", plot::html_preformatted(text))));
  return plot::html_page("granum " + document.command, body);
}

} // namespace granum::cli
