// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "sweep.hpp"

namespace granum::cli {

namespace {

using io::CsvTable;
using nlohmann::ordered_json;

/// "--void-ratio" as the heading void_ratio.
std::string heading_of(const Number& number) {
  std::string name = number.name.substr(2);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// The inputs that a table holds, and the packing of each of its rows.
class RowReader {
 public:
  /// \throws   FileError for an input without its unit or with two; InvalidArgument for one that stands under
  ///           both of its names, or that an option gives too
  RowReader(const CsvTable& table, const PackingOptions& options)
      : table_(table), row_(options), read_(table.headings().size(), false) {
    const auto& headings = table.headings();
    for (Number* number : numbers(row_))
      for (const std::string& name : {heading_of(*number), number->symbol})
        if (!name.empty() && table.has(name))
          bind(*number, table.column(name, number->dimension));
    const auto contact = std::find(headings.begin(), headings.end(), "contact");
    if (contact != headings.end()) {
      contact_ = static_cast<std::size_t>(contact - headings.begin());
      refuse_twice(row_.contact_given(), "--contact", "contact");
      read_[*contact_] = true;
      row_.contact_in_table = true;
    }
  }

  RowReader(const RowReader&) = delete; // holds places within itself
  RowReader& operator=(const RowReader&) = delete;

  /// The packing of a row, with the options for what the table does not hold.
  /// \throws   InvalidArgument
  const PackingOptions& packing(std::size_t row) {
    const auto& fields = table_.fields(row);
    for (const Input& input : inputs_)
      take(input, fields[input.column.index]);
    if (contact_) {
      const std::string& text = fields[*contact_];
      const std::optional<contact::Shape> shape = contact::find_shape(text);
      if (!shape)
        throw InvalidArgument(fmt::format("contact '{}' is not one of {}", text, contact::shape_names()));
      row_.contact = *shape;
    }
    return row_;
  }

  /// Headings of the columns that say nothing to this program.
  [[nodiscard]] std::vector<std::string> unread() const {
    std::vector<std::string> headings;
    for (std::size_t k = 0; k < read_.size(); ++k)
      if (!read_[k])
        headings.push_back(table_.headings()[k]);
    return headings;
  }

 private:
  struct Input {
    Number* number;
    CsvTable::Column column;
  };

  static void refuse_twice(bool option_given, const std::string& option, const std::string& heading) {
    if (option_given)
      throw InvalidArgument(fmt::format("{} is an option and the column '{}' too", option, heading));
  }

  void bind(Number& number, const CsvTable::Column& column) {
    const std::string& heading = table_.headings()[column.index];
    refuse_twice(number.given(), number.name, heading);
    for (const Input& input : inputs_)
      if (input.number == &number)
        throw InvalidArgument(fmt::format("both '{}' and '{}' hold {}", table_.headings()[input.column.index],
                                          heading, heading_of(number)));
    inputs_.push_back({&number, column});
    read_[column.index] = true;
  }

  /// Whether every packing has this number, whatever its contact and however its density is given.
  [[nodiscard]] bool always_needed(const Number& number) const {
    const Number* needed[] = {&row_.grain_shear_modulus, &row_.grain_poisson_ratio, &row_.radius,
                              &row_.coordination_number, &row_.fabric};
    return std::find(std::begin(needed), std::end(needed), &number) != std::end(needed);
  }

  /// An empty field is an input that the row does not give; no default stands in for it.
  void take(const Input& input, const std::string& field) const {
    Number& number = *input.number;
    number.in_table = !trimmed(field).empty();
    number.value = std::numeric_limits<double>::quiet_NaN();
    if (!number.in_table && always_needed(number))
      throw InvalidArgument(fmt::format("column '{}' is empty", table_.headings()[input.column.index]));
    if (!number.in_table)
      return;
    const auto value = parse_number(field);
    if (!value || !std::isfinite(*value * input.column.factor))
      throw InvalidArgument(fmt::format("expected a finite number in column '{}', found '{}'",
                                        table_.headings()[input.column.index], field));
    number.value = *value * input.column.factor;
  }

  const CsvTable& table_;
  PackingOptions row_;
  std::vector<Input> inputs_;
  std::optional<std::size_t> contact_;
  std::vector<bool> read_;
};

/// Inputs that all rows share, from the options; what is a column is left out.
std::vector<std::string> remarks_on(const PackingOptions& packing, const effective::State& state) {
  std::vector<std::string> remarks = assumed_inputs(packing, state);
  if (!packing.contact_in_table)
    for (const std::string& remark : loose_packing_remark(packing, state))
      remarks.push_back(remark);
  return remarks;
}

/// Collects the rows of the answer as CSV or JSON.
class TableSweep {
 public:
  TableSweep(const SweepOptions& options, const Rungs& rungs)
      : options_(options), rungs_(rungs), table_(io::read_csv(options.table)),
        reader_(table_, options.packing) {
    for (const std::string& heading : result_headings(rungs))
      if (std::find(table_.headings().begin(), table_.headings().end(), heading) != table_.headings().end())
        throw FileError(options.table, 0, "has a column '" + heading + "' already, a name of the results");
    for (std::size_t row = 0; row < table_.row_count(); ++row)
      add(row);
  }

  [[nodiscard]] std::string csv() const {
    std::vector<std::string> headings = table_.headings();
    for (const std::string& heading : result_headings(rungs_))
      headings.push_back(heading);
    return io::csv_text({.notes = csv_notes(inputs(), rungs_, remarks()), .headings = headings, .rows = {}}) +
           rows_;
  }

  [[nodiscard]] ordered_json json() const {
    ordered_json json = sweep_json_head(inputs(), rungs_);
    json["states"] = states_;
    json["notes"] = remarks();
    for (const std::string& note : tally_.validity().notes)
      json["notes"].push_back(note);
    return json;
  }

  [[nodiscard]] const Tally& tally() const { return tally_; }

 private:
  StateResult result_of(std::size_t row) {
    try {
      const PackingOptions& packing = reader_.packing(row);
      const effective::State state = resolve_state(packing, resolve_stresses(packing));
      if (!remarks_)
        remarks_ = remarks_on(packing, state);
      return evaluate({state, resolve_mechanical_coordination_number(packing)}, rungs_);
    } catch (const Error& error) {
      return failed(error.what(), rungs_);
    }
  }

  void add(std::size_t row) {
    const StateResult result = result_of(row);
    tally_.count(result, fmt::format("line {}", table_.line(row)));
    if (options_.output.json) {
      ordered_json state = {{"line", table_.line(row)}};
      add_result(state, result, rungs_);
      states_.push_back(std::move(state));
      return;
    }
    std::vector<io::CsvCell> cells(table_.fields(row).begin(), table_.fields(row).end());
    append_cells(cells, result);
    rows_ += io::csv_line(cells);
  }

  [[nodiscard]] ordered_json inputs() const {
    return {{"table", options_.table}, {"rows", table_.row_count()}};
  }

  [[nodiscard]] std::vector<std::string> remarks() const {
    std::vector<std::string> remarks = remarks_.value_or(std::vector<std::string>());
    const std::vector<std::string> unread = reader_.unread();
    if (!unread.empty())
      remarks.push_back(fmt::format("columns that are no inputs: {}", fmt::join(unread, ", ")));
    return remarks;
  }

  const SweepOptions& options_;
  const Rungs& rungs_;
  CsvTable table_;
  RowReader reader_;
  std::string rows_;
  ordered_json states_ = ordered_json::array();
  std::optional<std::vector<std::string>> remarks_; ///< from the first row that is a packing
  Tally tally_;
};

} // namespace

ExitCode sweep_table(const SweepOptions& o, const Rungs& rungs) {
  require_free(o.output, {o.output.out});
  const TableSweep sweep(o, rungs);
  const ExitCode code = deliver(o.output, o.output.json ? "" : sweep.csv(),
                                o.output.json ? sweep.json() : ordered_json(), sweep.tally().validity());
  return sweep.tally().conclude(code);
}

} // namespace granum::cli
