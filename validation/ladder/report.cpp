// SPDX-License-Identifier: GPL-3.0-or-later
// What the recorded table says.
//
//     ladder_report check table.csv ../relaxation/states.csv
//     ladder_report lines table.csv       errors and costs by rung, as the table of README.md
//     ladder_report picture table.csv     error against cost, SVG
//     ladder_report restate table.csv     the table again, with what rungs 0 to 3 say of it now
//
// check: exit code 0 if the library still says what was recorded, and stated errors cover actual ones.

#include <granum/plot/chart.hpp>

#include "../common.hpp"
#include "table.hpp"

namespace {

using namespace granum;
using ladder::Moduli;
using ladder::Row;

// ---- rows that belong together ----

template <class Filter>
std::vector<Row> select(const std::vector<Row>& rows, const Filter& filter) {
  std::vector<Row> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), filter);
  return chosen;
}

std::vector<Row> of_rung(const std::vector<Row>& rows, double rung, const std::string& known) {
  return select(rows, [&](const Row& r) { return r.rung == rung && r.known == known; });
}

/// Errors against rung 4 of the same packing.
Moduli errors(const std::vector<Row>& rows, const Row& row) {
  const auto network = std::ranges::find_if(
      rows, [&](const Row& r) { return r.rung == 4 && r.specimen.name() == row.specimen.name(); });
  return ladder::errors(row.value, network->value);
}

double median(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> each(const std::vector<Row>& rows, double (*of)(const Row&)) {
  std::vector<double> values;
  for (const Row& row : rows)
    values.push_back(of(row));
  return values;
}

double actual_error(const Row& row) { return ladder::largest(row.error); }
double stated_error(const Row& row) { return ladder::largest(row.stated); }
double cost(const Row& row) { return row.cost; }

double rms(const std::vector<Row>& rows, double (*of)(const Row&)) {
  Errors all;
  for (const Row& row : rows)
    all.add(of(row));
  return all.rms();
}

// ---- the lines of README.md ----

struct Rung {
  double number;
  const char* known;
  const char* title;
  const char* inputs;
};

constexpr Rung rungs[] = {
    {0, "all", "0, uniform strain, isotropic", "law, e, C_n, p"},
    {1, "all", "1, with fabric", "+ a"},
    {2, "all", "2, contact stiffness by direction", "+ both stresses"},
    {3, "C_n", "3, relaxed, z* estimated from C_n", "law, e, C_n, both stresses"},
    {3, "all", "3, relaxed", "law, e, C_n, a, both stresses, z*"},
    {4, "packing", "4, contact network", "a packing"},
    {5, "packing", "5, probe by DEM", "a packing"},
};

struct Kind {
  const char* name;
  bool (*has)(const Row&);
};
constexpr Kind kinds[] = {
    {"dense", [](const Row& r) { return r.specimen.preparation == "dense"; }},
    {"loose", [](const Row& r) { return r.specimen.preparation == "loose" && r.specimen.stress_ratio == 0; }},
    {"loose, sheared", [](const Row& r) { return r.specimen.stress_ratio != 0; }},
};

std::string error_cell(const std::vector<Row>& rows) {
  if (rows.empty())
    return "";
  std::string text = percent_text(rms(rows, actual_error));
  if (rows.front().rung <= 3)
    text += ", stated " + percent_text(rms(rows, stated_error));
  return text;
}

std::string time_text(double seconds) {
  const auto [unit, symbol] = seconds < 1e-6   ? std::pair{1e-9, " ns"}
                              : seconds < 1e-3 ? std::pair{1e-6, " µs"}
                                               : std::pair{1.0, " s"};
  const double value = seconds / unit;
  return short_text(value < 100 ? value : 10 * std::round(value / 10), value < 100 ? 2 : 4) + symbol;
}

void print_summary(const std::vector<Row>& rows) {
  std::printf("| rung | knows | dense | loose | loose, sheared | one evaluation |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  for (const Rung& rung : rungs) {
    const std::vector<Row> own = of_rung(rows, rung.number, rung.known);
    std::printf("| %s | %s", rung.title, rung.inputs);
    for (const Kind& kind : kinds)
      std::printf(" | %s", rung.number == 4 ? "reference" : error_cell(select(own, kind.has)).c_str());
    std::printf(" | %s |\n", time_text(median(each(own, cost))).c_str());
  }
}

// ---- the picture ----

plot::Series points(const std::string& name, const std::vector<Row>& own, std::size_t style,
                    plot::Colour colour) {
  return {.name = name,
          .mark = plot::Mark::marker,
          .x = each(own, cost),
          .y = each(own, actual_error),
          .style = style,
          .colour = colour};
}

plot::Chart panel(const std::string& title) {
  return {.title = title,
          .x = {"processor time of one evaluation [s]", plot::Scale::logarithmic, 1},
          .y = {"error, largest of K, G_hh, G_vh [%]", plot::Scale::logarithmic, 0.01},
          .width = 330,
          .height = 340,
          .legend_below = true};
}

plot::Chart closed_forms(const std::vector<Row>& rows) {
  plot::Chart picture = panel("Closed forms");
  for (const Kind& kind : {kinds[0], kinds[1]}) {
    plot::Series line{.name = std::string("stated error, ") + kind.name,
                      .mark = plot::Mark::line,
                      .style = picture.series.size(),
                      .tone = plot::Tone::grey};
    for (const double rung : {0.0, 1.0, 2.0, 3.0}) {
      const std::vector<Row> own = select(of_rung(rows, rung, "all"), kind.has);
      line.add(median(each(own, cost)), rms(own, stated_error));
    }
    picture.series.push_back(line);
  }
  for (const std::size_t rung : {0U, 1U, 2U})
    picture.series.push_back(points("rung " + std::to_string(rung),
                                    of_rung(rows, static_cast<double>(rung), "all"), rung,
                                    plot::Colour::uniform_strain));
  picture.series.push_back(points("rung 3, z* known", of_rung(rows, 3, "all"), 3, plot::Colour::closed_form));
  picture.series.push_back(
      points("rung 3, z* from C_n", of_rung(rows, 3, "C_n"), 0, plot::Colour::closed_form));
  picture.finding =
      "Closed forms: rungs 0 to 2 are off by 40 to 400 % and cost 20 to 400 ns; rung 3 is off by some "
      "4 % and costs 1 microsecond.";
  return picture;
}

/// The network is what the others are measured against: here against the probe, each at its own cost.
plot::Chart of_packings(const std::vector<Row>& rows) {
  plot::Chart picture = panel("With a packing: one against the other");
  const std::vector<Row> probes = of_rung(rows, 5, "packing");
  std::map<std::string, double> network_cost;
  for (const Row& row : of_rung(rows, 4, "packing"))
    network_cost[row.specimen.name()] = row.cost;
  plot::Series network = points("rung 4: network", probes, 1, plot::Colour::measured);
  for (std::size_t k = 0; k < probes.size(); ++k)
    network.x[k] = network_cost.at(probes[k].specimen.name());
  picture.series = {network, points("rung 5: DEM probe", probes, 2, plot::Colour::measured)};
  picture.finding = "Network and probe differ by less than 0.5 % and cost hundredths to tenths of a second.";
  return picture;
}

// ---- the questions ----

void add(Errors& errors, const Moduli& error, const Moduli& stated) {
  for (std::size_t k = 0; k < error.size(); ++k)
    errors.add(error[k], stated[k]);
}

/// A standard error: of normal errors 32 % would lie beyond one and 5 % beyond two.
void require_coverage(Claims& claims, const std::string& what, const Errors& e) {
  claims.require(e.two() >= 0.9 && e.three() >= 0.98,
                 what + ": " + std::to_string(e.count()) + " values, " + percent_text(1 - e.one()) +
                     " beyond the stated error, " + percent_text(1 - e.two()) + " beyond twice, " +
                     percent_text(1 - e.three()) + " beyond three times");
}

bool same(const Moduli& first, const Moduli& second) {
  constexpr double recorded_digits = 1e-5; // seven digits, and the slopes of what they are put into
  for (std::size_t k = 0; k < first.size(); ++k)
    if (!(std::abs(first[k] - second[k]) <= recorded_digits * std::abs(second[k])))
      return false;
  return true;
}

/// The rung's answer today.
Row restated(Row row) {
  const auto assessed = ladder::ladder_of(ladder::state_of(row.specimen), row.known);
  const auto& rung = assessed.rungs[static_cast<std::size_t>(row.rung)];
  row.value = ladder::moduli(rung.stiffness.value());
  row.stated = ladder::triple(rung.relative_error.value());
  return row;
}

std::string restated_table(const std::vector<Row>& rows) {
  std::string text = ladder::csv_headings();
  for (Row row : rows) {
    if (row.rung <= 3) {
      row = restated(row);
      row.error = errors(rows, row);
    }
    text += ladder::csv_line(row);
  }
  return text;
}

void check_library(Claims& claims, const std::vector<Row>& rows) {
  std::string other;
  for (const Row& row : rows) {
    if (row.rung > 3)
      continue;
    const Row now = restated(row);
    if (!same(now.value, row.value) || !same(now.stated, row.stated))
      other = row.specimen.name();
  }
  claims.require(other.empty(), "the library says of each packing what was recorded" +
                                    (other.empty() ? "" : "; not of " + other));
  for (const effective::Rung& rung : effective::rungs()) {
    if (!rung.number)
      continue;
    const auto own = select(rows, [&rung](const Row& r) { return r.rung == *rung.number; });
    const double ratio = rung.typical_time / median(each(own, cost));
    claims.require(ratio > 1 / 3.0 && ratio < 3,
                   "time stated for " + effective::label(rung) +
                       " over the median of the table: " + short_text(ratio, 2));
  }
}

void check_table(Claims& claims, const std::vector<Row>& rows) {
  bool errors_follow = true;
  for (const Row& row : rows)
    if (row.rung < 4)
      for (std::size_t k = 0; k < row.error.size(); ++k)
        errors_follow = errors_follow &&
                        std::abs(errors(rows, row)[k] - row.error[k]) < 1e-5 * (1 + std::abs(row.error[k]));
  claims.require(errors_follow, "the errors are those of the moduli");
  for (const char* known : {"all", "C_n"})
    for (const double rung : {0.0, 1.0, 2.0, 3.0}) {
      Errors coverage;
      for (const Row& row : of_rung(rows, rung, known))
        add(coverage, row.error, row.stated);
      if (coverage.count() > 0)
        require_coverage(claims, "rung " + short_text(rung) + ", known: " + known, coverage);
    }
  const auto worst_probe = each(of_rung(rows, 5, "packing"), actual_error);
  claims.require(*std::max_element(worst_probe.begin(), worst_probe.end()) < 0.01,
                 "probe within 1 % of network");
  const double relaxed = rms(of_rung(rows, 3, "all"), actual_error),
               strained = rms(of_rung(rows, 2, "all"), actual_error);
  claims.require(relaxed < strained / 10, "rung 3 has a tenth of the error of rung 2 at most: " +
                                              percent_text(relaxed) + " and " + percent_text(strained));
  double last = 0;
  for (const double rung : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    const double now = median(each(select(rows, [rung](const Row& r) { return r.rung == rung; }), cost));
    claims.require(now > last,
                   "rung " + short_text(rung) + " costs more than those below: " + time_text(now));
    last = now;
  }
}

/// The packings that rung 3 is calibrated on, at the k_t/k_n that they were made with.
void check_calibration_packings(Claims& claims, const std::string& path) {
  std::map<std::string, Errors> coverage;
  const auto packings = relaxation::read_packings(path);
  for (const relaxation::Packing& p : packings) {
    const auto own = std::ranges::find(p.networks, relaxation::no_slip_ratio, &relaxation::Network::ratio);
    for (const std::string known : {"all", "C_n"}) {
      effective::State measured = p.state;
      measured.mechanical_coordination_number = p.mechanical_coordination;
      const auto assessed = ladder::ladder_of(measured, known);
      for (const std::size_t k : {0u, 1u, 2u, 3u})
        if (const auto& rung = assessed.rungs[k]; rung.stiffness)
          add(coverage["rung " + std::to_string(k) + ", known: " + known],
              ladder::errors(ladder::moduli(*rung.stiffness), ladder::moduli(own->stiffness)),
              ladder::triple(*rung.relative_error));
    }
  }
  claims.require(packings.size() > 300, "packings of the calibration: " + std::to_string(packings.size()));
  for (const auto& [what, errors] : coverage)
    require_coverage(claims, "calibration packings, " + what, errors);
}

} // namespace

int main(int argc, char** argv) {
  return program(
      argc, argv,
      {
          {"check", "table.csv states.csv",
           [](const Arguments& files) {
             const std::vector<Row> rows = ladder::read(files[0]);
             Claims claims;
             check_library(claims, rows);
             check_table(claims, rows);
             check_calibration_packings(claims, files[1]);
             return claims.exit_code();
           }},
          {"lines", "table.csv", [](const Arguments& files) { print_summary(ladder::read(files[0])); }},
          {"picture", "table.csv",
           [](const Arguments& files) {
             // Two panels: between a microsecond and a hundredth of a second there is nothing.
             const std::vector<Row> rows = ladder::read(files[0]);
             const plot::Chart both[] = {closed_forms(rows), of_packings(rows)};
             std::printf("%s", plot::svg(both).c_str());
           }},
          {"restate", "table.csv",
           [](const Arguments& files) { std::printf("%s", restated_table(ladder::read(files[0])).c_str()); }},
      });
}
