// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <granum/core/error.hpp>

#include "cli/options/packing_rows.hpp"
#include "sweep.hpp"

namespace granum::cli {

namespace {

using io::CsvTable;
using nlohmann::ordered_json;

/// Inputs that all rows share, from the options; what is a column is left out.
std::vector<std::string> remarks_on(const PackingOptions& packing, const effective::State& state) {
  std::vector<std::string> remarks = assumed_inputs(packing, state);
  if (!packing.contact_in_table)
    for (const std::string& remark : assumed_coordination(packing, state))
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
  PackingRows reader_;
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
