// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.hpp"

#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <granum/plot/page.hpp>

namespace granum::cli {

namespace {

using estimate::Field;
using Named = std::pair<std::string, const estimate::Answer*>;

/// The answers with their names; if there are two, that of a sand first.
std::vector<Named> answers_of(const AnswerCase& c) {
  std::vector<Named> all;
  if (c.sand_answer)
    all.emplace_back(title_of(estimate::GrainShape::sand), &*c.sand_answer);
  all.emplace_back(title_of(c.question.grain_shape), &c.answer);
  return all;
}

std::string sentence(const Named& named) {
  const auto& [title, answer] = named;
  std::string text = title + ": ";
  for (const Field field : {Field::shear_modulus, Field::shear_wave_speed, Field::modulus_ratio}) {
    const estimate::FieldRow& row = estimate::row_of(field);
    if (const std::optional<estimate::Range>& range = answer->find(field))
      text += fmt::format("{}{} is {} ({} to {})", text.ends_with(": ") ? "" : ", ", row.symbol,
                          field_text(row, range->value), field_text(row, range->low),
                          field_text(row, range->high));
  }
  return text + "; in brackets one standard deviation to each side.";
}

std::string numbers(const Named& named) {
  std::vector<std::vector<std::string>> rows;
  for (const estimate::FieldRow& row : estimate::fields())
    if (const std::optional<estimate::Range>& range = named.second->find(row.field))
      rows.push_back({row.symbol, field_text(row, range->value), field_text(row, range->low),
                      field_text(row, range->high), row.meaning});
  return plot::html_paragraph(named.first) + plot::html_table({"", "answer", "low", "high", "meaning"}, rows);
}

struct Source {
  std::string_view key, text;
};
constexpr Source bibliography[] = {
#include "sources_table.inc"
};

/// The entries of validation/references.bib whose keys occur in a text, in the order of the bibliography:
/// "Menq2003: Menq, F. Y. (2003): ...".
std::vector<std::string> sources_in(std::string_view text) {
  std::vector<std::string> all;
  for (const Source& source : bibliography)
    if (text.find(source.key) != std::string_view::npos)
      all.push_back(std::string(source.key) + ": " + std::string(source.text));
  return all;
}

/// Keys of the sources of all numbers.
std::string keys_of(const AnswerCase& c, const std::string& table) {
  std::string keys = table;
  for (const std::string& note : c.assumptions)
    keys += note + "\n";
  for (const SandAnswer& sand : c.sands)
    keys += std::string(sand.law->source) + "\n";
  return keys;
}

} // namespace

std::string answer_page(const AnswerCase& c, const plot::Chart& picture, const std::string& table,
                        const Validity& validity) {
  std::vector<std::string> sentences;
  std::string all_numbers;
  for (const Named& named : answers_of(c)) {
    sentences.push_back(sentence(named));
    all_numbers += numbers(named);
  }
  const plot::PageFigure figure{.caption = "The shear modulus around this state, with its range.",
                                .pictures = {{.svg = plot::svg_in_page(picture)}}};
  std::string body =
      plot::html_first_screen("How stiff is it, and how well is that known?", sentences, figure) +
      plot::html_section("numbers", "Every number", all_numbers) +
      plot::html_section("assumptions", "Assumptions and sources", plot::html_list(c.assumptions)) +
      plot::html_section("sources", "Sources", plot::html_list(sources_in(keys_of(c, table))));
  if (!validity.ok())
    body += plot::html_section("warnings", "Warnings", plot::html_list(validity.notes));
  body += plot::html_section("all", "All results",
                             plot::html_folded("Output on the terminal", plot::html_preformatted(table)));
  return plot::html_page("granum estimate", body);
}

} // namespace granum::cli
