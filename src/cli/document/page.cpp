// SPDX-License-Identifier: GPL-3.0-or-later
#include <string_view>

#include <fmt/format.h>
#include <granum/plot/page.hpp>
#include <granum/plot/svg_text.hpp>

#include "document.hpp"

namespace granum::cli {

namespace {

struct BibliographyRow {
  std::string_view key, text;
};
constexpr BibliographyRow bibliography[] = {
#include "sources_table.inc"
};

/// The entries of validation/references.bib whose keys occur in a text, in the order of the bibliography:
/// "Menq2003: Menq, F. Y. (2003): ...".
std::vector<std::string> sources_in(std::string_view text) {
  std::vector<std::string> all;
  for (const BibliographyRow& row : bibliography)
    if (text.find(row.key) != std::string_view::npos)
      all.push_back(std::string(row.key) + ": " + std::string(row.text));
  return all;
}

/// "sand (measured laws): G is 118 MPa (90.73 to 153.3 MPa), V_s is ...", the first numbers of an answer.
std::string sentence_of(const Ranges& ranges) {
  constexpr std::size_t most = 3;
  std::vector<std::string> parts;
  for (const RangeRow& row : ranges.rows)
    if (row.range && row.seen == Seen::always && parts.size() < most)
      parts.push_back(row.symbol + " is " + range_text(row.dimension, *row.range));
  return fmt::format("{}: {}; in brackets one standard deviation to each side.", ranges.title,
                     fmt::join(parts, ", "));
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
             : titled(ranges.title, plot::html_table({"", "answer", "low", "high", "meaning"}, rows));
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

} // namespace

std::string page(const Document& document) {
  std::vector<std::string> sentences = document.sentences, notes;
  std::vector<plot::PageFigure> figures;
  std::string numbers, pictures, folded;
  for (const Section& section : document.sections) {
    if (const auto* ranges = std::get_if<Ranges>(&section.what); ranges != nullptr && !ranges->rows.empty())
      sentences.push_back(sentence_of(*ranges));
    if (const auto* of = std::get_if<Picture>(&section.what)) {
      if (of->folded.empty())
        figures.push_back(figure_of(*of));
      else
        folded += plot::html_folded(of->folded, plot::html_figure(figure_of(*of)));
    }
    if (section.seen == Seen::always || section.seen == Seen::full)
      numbers += std::visit([](const auto& what) { return html_of(what); }, section.what);
  }
  for (const Note& note : document.notes)
    if (note.seen != Seen::data)
      notes.push_back(note.what.sentence());
  if (figures.empty())
    figures.emplace_back();
  for (std::size_t k = 1; k < figures.size(); ++k)
    pictures += plot::html_figure(figures[k]);
  if (!pictures.empty())
    pictures = plot::html_element("div", pictures, "trio");
  if (!pictures.empty() || !folded.empty())
    pictures = plot::html_section("pictures", "Pictures", pictures + folded);
  const std::string text = screen(document, true);
  std::string body = plot::html_first_screen(document.question, sentences, figures.front()) + pictures +
                     plot::html_section("numbers", "Every number", numbers) +
                     plot::html_section("assumptions", "Assumptions and sources", plot::html_list(notes)) +
                     plot::html_section("sources", "Sources",
                                        plot::html_list(sources_in(text + json_text(json(document), -1))));
  if (!document.warnings.ok())
    body += plot::html_section("warnings", "Warnings", plot::html_list(document.warnings.notes));
  body += plot::html_section("all", "All results",
                             plot::html_folded("Output on the terminal", plot::html_preformatted(text)));
  return plot::html_page("granum " + document.command, body);
}

} // namespace granum::cli
