// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/table.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>
#include <granum/io/text/source.hpp>

namespace granum::io {

namespace {

/// The separator of the fields, outside of quotes in the first record.
/// \throws   FileError if commas and semicolons do
char separator_in(std::string_view text, const std::string& name, std::size_t line) {
  bool comma = false, semicolon = false, tab = false, quoted = false;
  for (const char c : text) {
    if (c == '\n' && !quoted)
      break;
    quoted = quoted != (c == '"');
    comma = comma || (c == ',' && !quoted);
    semicolon = semicolon || (c == ';' && !quoted);
    tab = tab || (c == '\t' && !quoted);
  }
  if (comma && semicolon)
    throw FileError(
        name, line,
        "the headings are separated by commas and by semicolons: put quotes around a heading that has "
        "one of them");
  if (tab && !comma && !semicolon)
    return '\t'; // as cells that are copied from a spreadsheet
  return semicolon ? ';' : ',';
}

/// "1500" of "1.500"; empty unless the point can separate thousands.
std::optional<std::string> without_thousands_point(const std::string& field) {
  const std::size_t sign = field.starts_with('-') || field.starts_with('+') ? 1 : 0;
  const std::size_t point = field.find('.');
  if (point == std::string::npos || point <= sign || point > sign + 3 || point + 4 != field.size() ||
      field[sign] == '0')
    return {};
  std::string whole = field;
  whole.erase(point, 1);
  return whole.find_first_not_of("0123456789", sign) == std::string::npos ? std::optional(whole)
                                                                          : std::nullopt;
}

/// Decimal signs of a table whose fields are separated by semicolons or tabs.
class DecimalSigns {
 public:
  /// Makes "0.65" of "0,65", and leaves any other text as it is.
  void take(std::string& field, const std::string& heading, std::size_t line) {
    const std::size_t comma = field.find(',');
    std::string number = field;
    if (comma != std::string::npos)
      number[comma] = '.';
    if (number.find('.') == std::string::npos || !parse_number(number))
      return;
    Sign &here = comma == std::string::npos ? points_ : commas_,
         &other = &here == &points_ ? commas_ : points_;
    here.found = true;
    if (const auto whole = without_thousands_point(number); whole && here.line == 0) {
      std::string as_others = number;
      as_others[number.find('.')] = other.character;
      here.line = line;
      here.doubt = "column '" + heading + "' contains '" + field + "', where other numbers have decimal " +
                   other.plural + ": write " + as_others + " for " + short_text(*parse_number(number)) +
                   ", or " + *whole;
    }
    field = number;
  }

  [[nodiscard]] bool commas_found() const { return commas_.found; }
  /// \throws   FileError for a sign that may separate thousands, where other numbers have the other sign
  void require_none_of_thousands(const std::string& name) const {
    for (const auto& [of, other] : {std::pair(&points_, &commas_), std::pair(&commas_, &points_)})
      if (of->line > 0 && other->found)
        throw FileError(name, of->line, of->doubt);
  }

 private:
  struct Sign {
    char character;
    const char* plural;
    bool found = false;
    std::size_t line = 0; ///< of the first number in doubt; 0 for none
    std::string doubt = {};
  };
  Sign points_{.character = '.', .plural = "points"};
  Sign commas_{.character = ',', .plural = "commas"};
};

/// Whether a text would be a formula for a spreadsheet, behind any number of apostrophes.
bool is_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  return text.size() > 1 && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos &&
         !parse_number(text);
}

/// Whether there are too many fields, and no number with a point among them.
bool may_hold_decimal_commas(const std::vector<std::string>& fields, std::size_t expected) {
  return fields.size() > expected && std::none_of(fields.begin(), fields.end(), [](const std::string& field) {
           return field.find('.') != std::string::npos;
         });
}

/// Walks over the text of a file, record by record.
class Cursor {
 public:
  Cursor(const std::string& name, std::string_view text) : name_(name), text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) // byte order mark that spreadsheets write
      text_.remove_prefix(3);
  }

  [[nodiscard]] std::size_t line() const { return line_; }

  /// Goes to the next record that is neither blank nor a comment; false at the end of the text.
  bool seek_record() {
    while (!text_.empty()) {
      const std::string_view here = text_.substr(0, text_.find('\n'));
      if (!trimmed(here).empty() && here[0] != '#')
        return true;
      text_.remove_prefix(std::min(here.size() + 1, text_.size()));
      ++line_;
    }
    return false;
  }

  /// Sets the separator of the fields from the current record.
  char find_separator() { return separator_ = separator_in(text_, name_, line_); }

  /// The fields of the record here, and the cursor after its end. The apostrophe that keeps a text from being
  /// a formula is none of it.
  std::vector<std::string> record() {
    std::vector<std::string> fields;
    do {
      fields.push_back(field());
      if (fields.back().starts_with('\'') && is_formula(fields.back()))
        fields.back().erase(0, 1);
    } while (next_is(separator_));
    ++line_;
    return fields;
  }

 private:
  /// Consumes the separator that ends a field; true if it is `separator`, false at the end of the record.
  bool next_is(char separator) {
    if (text_.empty())
      return false;
    const bool same = text_[0] == separator;
    text_.remove_prefix(1);
    return same;
  }

  [[nodiscard]] std::size_t end_of_field() const {
    const char ends[] = {separator_, '\n'};
    return std::min(text_.find_first_of(std::string_view(ends, 2)), text_.size());
  }

  std::string field() {
    const std::size_t start = text_.find_first_not_of(" \t");
    if (start != std::string_view::npos && text_[start] == '"') {
      text_.remove_prefix(start + 1);
      return quoted();
    }
    const std::string_view content = text_.substr(0, end_of_field());
    text_.remove_prefix(content.size());
    return std::string(trimmed(content));
  }

  /// The rest of a field whose opening quote has been read; "" inside means one quote.
  std::string quoted() {
    const std::size_t first_line = line_;
    std::string content;
    for (;;) {
      const std::size_t end = text_.find('"');
      if (end == std::string_view::npos)
        throw FileError(name_, first_line, "a quoted field begins here and is never closed");
      content += text_.substr(0, end);
      line_ +=
          static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + static_cast<long>(end), '\n'));
      text_.remove_prefix(end + 1);
      if (!text_.starts_with('"'))
        break;
      content += '"';
      text_.remove_prefix(1);
    }
    const std::string_view after = text_.substr(0, end_of_field());
    if (!trimmed(after).empty())
      throw FileError(name_, line_,
                      separator_ == ';' ? "expected a semicolon after the closing quote"
                                        : "expected a comma after the closing quote");
    text_.remove_prefix(after.size());
    return content;
  }

  const std::string& name_;
  std::string_view text_;
  std::size_t line_ = 1;
  char separator_ = ',';
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// Of a number as the library writes it.
std::string with_decimal_sign(std::string number, CsvManner manner) {
  std::replace(number.begin(), number.end(), '.', manner.decimal_sign);
  return number;
}

std::string field_text(const CsvCell& cell, CsvManner manner) {
  if (const double* number = std::get_if<double>(&cell))
    return std::isnan(*number) ? "" : with_decimal_sign(exact_text(*number), manner);
  std::string text = std::get<std::string>(cell);
  if (manner.decimal_sign != '.' && parse_number(text))
    return with_decimal_sign(std::move(text), manner);
  if (is_formula(text))
    text.insert(0, 1, '\'');
  const std::string special = std::string(",\"\r\n") + manner.separator;
  if (text.find_first_of(special) == std::string::npos && trimmed(text) == text && !text.starts_with('#'))
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

} // namespace

CsvTable::CsvTable(std::string name, std::string_view text) : name_(std::move(name)) {
  if (text.find('\0') != std::string_view::npos)
    throw FileError(name_, 0, "is not a text file; expected comma-separated values");
  std::string lines; // of a text that CR ends
  if (text.substr(0, text.size() - 1).find('\n') == std::string_view::npos &&
      text.find('\r') < text.size() - 1) {
    lines = text;
    std::replace(lines.begin(), lines.end(), '\r', '\n');
    text = lines;
  }
  Cursor cursor(name_, text);
  if (!cursor.seek_record())
    throw FileError(name_, 0, "is empty; expected a heading line such as G_MPa,sigma_v_kPa,sigma_h_kPa,e");
  heading_line_ = cursor.line();
  const char separator = cursor.find_separator();
  const bool decimal_commas = separator != ',';
  headings_ = cursor.record();
  for (auto heading = headings_.begin(); heading != headings_.end(); ++heading)
    if (std::find(headings_.begin(), heading, *heading) != heading)
      throw FileError(name_, heading_line_, "the heading '" + *heading + "' occurs twice");
  DecimalSigns signs;
  while (cursor.seek_record()) {
    stop_point(rows_.size());
    const std::size_t line = cursor.line();
    std::vector<std::string> record = cursor.record();
    if (std::all_of(record.begin(), record.end(),
                    [](const std::string& field) { return trimmed(field).empty(); }))
      continue; // spreadsheets end tables with rows of separators
    rows_.push_back({line, std::move(record)});
    const std::size_t count = rows_.back().fields.size();
    if (count != headings_.size())
      throw FileError(name_, line,
                      "expected " + std::to_string(headings_.size()) + " fields (" + joined(headings_) +
                          "), found " + std::to_string(count) +
                          (!decimal_commas && may_hold_decimal_commas(rows_.back().fields, headings_.size())
                               ? "; with decimal commas, separate the fields by semicolons"
                               : ""));
    if (decimal_commas)
      for (std::size_t k = 0; k < count; ++k)
        signs.take(rows_.back().fields[k], headings_[k], line);
  }
  signs.require_none_of_thousands(name_);
  manner_ = {.separator = separator, .decimal_sign = signs.commas_found() ? ',' : '.'};
  if (rows_.empty())
    throw FileError(name_, heading_line_, "there are no rows below the heading line");
}

bool CsvTable::has(std::string_view quantity) const {
  return std::any_of(headings_.begin(), headings_.end(),
                     [&](const std::string& heading) { return is_column_of(heading, quantity); });
}

std::size_t CsvTable::find(std::string_view quantity, Dimension dimension) const {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < headings_.size(); ++k) {
    if (!is_column_of(headings_[k], quantity))
      continue;
    if (found)
      throw FileError(name_, heading_line_,
                      "both '" + headings_[*found] + "' and '" + headings_[k] + "' contain " +
                          std::string(quantity));
    found = k;
  }
  if (found)
    return *found;
  const std::string unit =
      dimension == Dimension::dimensionless ? "" : "_" + std::string(si_symbol(dimension));
  throw FileError(name_, heading_line_,
                  "expected a column '" + std::string(quantity) + unit + "'" +
                      (unit.empty() ? "" : " (or another unit)") + ", found " + joined(headings_));
}

CsvTable::Place CsvTable::column(std::string_view quantity, Dimension dimension) const {
  const std::size_t index = find(quantity, dimension);
  try {
    return {index, column_factor(headings_[index], quantity, dimension)};
  } catch (const InvalidArgument& error) {
    throw FileError(name_, heading_line_, error.what());
  }
}

std::vector<double> CsvTable::numbers(std::string_view quantity, Dimension dimension) const {
  const auto [index, factor] = column(quantity, dimension);
  std::vector<double> values;
  values.reserve(rows_.size());
  for (const Row& row : rows_) {
    stop_point(values.size());
    const auto number = parse_number(row.fields[index]);
    if (!number || !std::isfinite(factor * *number))
      throw FileError(name_, row.line,
                      "expected a finite number in column '" + headings_[index] + "', found '" +
                          row.fields[index] + "'");
    values.push_back(factor * *number);
  }
  return values;
}

CsvTable read_csv(const std::filesystem::path& path) { return CsvTable(path.string(), file_content(path)); }

std::string csv_line(const std::vector<CsvCell>& cells, CsvManner manner) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k)
    line += (k > 0 ? std::string(1, manner.separator) : "") + field_text(cells[k], manner);
  return line + '\n';
}

std::string csv_text(const CsvContent& content) {
  std::string text;
  for (const auto& [key, value] : content.notes) {
    std::string line = "# " + key + ": " + value;
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    text += line + '\n';
  }
  text += csv_line({content.headings.begin(), content.headings.end()}, {content.manner.separator});
  for (const auto& row : content.rows) {
    if (row.size() != content.headings.size())
      throw InvalidArgument("a CSV row has " + std::to_string(row.size()) + " cells for " +
                            std::to_string(content.headings.size()) + " headings");
    text += csv_line(row, content.manner);
  }
  return text;
}

std::vector<sizes::SievePoint> sieve_curve(const CsvTable& table) {
  const std::vector<double> diameters = table.numbers("d", Dimension::length);
  const std::vector<double> passing = table.numbers("passing", Dimension::dimensionless);
  std::vector<sizes::SievePoint> curve;
  for (std::size_t row = 0; row < diameters.size(); ++row)
    curve.push_back({.diameter = diameters[row], .passing = passing[row]});
  const bool descends = curve.front().diameter > curve.back().diameter;
  if (descends)
    std::reverse(curve.begin(), curve.end());
  if (const auto fault = sizes::find_fault(curve)) {
    const std::size_t row = descends ? curve.size() - 1 - fault->point : fault->point;
    throw FileError(table.name(), table.line(row), "sieve curve: " + fault->what);
  }
  return curve;
}

std::vector<sizes::SievePoint> read_sieve_curve(const std::filesystem::path& path) {
  return sieve_curve(read_csv(path));
}

} // namespace granum::io
