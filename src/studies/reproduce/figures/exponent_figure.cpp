// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "studies/paper/paper.hpp"
#include "studies/reproduce/experiment_findings.hpp"

#include "figure_parts.hpp"

namespace granum::studies {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// s of one modulus: our cell of the table, or the paper's value.
struct ShownExponent {
  const char* quantity; ///< of table_5
  const char* legend;
  double aside; ///< shift along the axis, so that equal values do not hide one another
  std::size_t style;
  plot::Colour colour;
};

constexpr ShownExponent shown_exponents[] = {{"s of G_hh", "G_hh", -0.008, 0, plot::Colour::horizontal},
                                             {"s of G_hv", "G_hv", 0.008, 1, plot::Colour::vertical}};

Panel exponent_panel(const Experiment& experiment, const std::vector<TableRow>& table,
                     triaxial::Density density) {
  Panel out = panel("fig15_" + std::string(name(density)), std::string(name(density)),
                    {"contact_exponent", {.title = "1/(1+\u03b1): flat 0, sphere 1/3, cone 1/2"}},
                    {"s", {.title = "s = m + n"}});
  for (const ShownExponent& row : shown_exponents) {
    plot::Series ours{.name = std::string(row.legend) + ", granum",
                      .mark = plot::Mark::marker,
                      .style = row.style,
                      .colour = row.colour};
    plot::Series paper = ours;
    paper.name = std::string(row.legend) + ", paper";
    paper.tone = plot::Tone::hollow;
    for (const TableRow& specimen : table)
      for (const Cell& cell : specimen.cells)
        if (specimen.density == density && cell.quantity == row.quantity) {
          const double x = contact_exponent(experiment.scene, specimen.contact) + row.aside;
          ours.add(x, cell.ours.value, cell.ours.standard_error.value_or(nothing));
          if (cell.printed)
            paper.add(x, *cell.printed);
        }
    add(out, std::move(paper), std::string(row.legend) + " paper");
    add(out, std::move(ours), std::string(row.legend) + " granum");
  }
  if (!out.chart.series.empty())
    add(out,
        {.name = "s = 1/(1+\u03b1)",
         .mark = plot::Mark::line,
         .x = {0, 0.5},
         .y = {0, 0.5},
         .style = 0,
         .tone = plot::Tone::grey},
        "contact law");
  return out;
}

} // namespace

void add_exponent_figure(std::vector<Figure>& to, const Experiment& experiment) {
  Figure out{
      .name = "Fig. 15",
      .title = "Exponents s by contact geometry and density",
      .caption =
          "s of G ~ p^s, from the fit of the paper's Eq. (1) to all states with |\u03b7| \u2264 0.6, with "
          "its standard error; hollow markers: values of the paper. The line is the exponent of the single "
          "contact. "
          "Markers of G_hh are drawn slightly to the left, those of G_hv to the right.",
      .panels = {}};
  const std::vector<TableRow> table = table_5(experiment);
  for (const triaxial::Density density : experiment.scene.study.densities)
    add(out, exponent_panel(experiment, table, density));
  to.push_back(std::move(out));
}

} // namespace granum::studies
