// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_html.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/reproduce/experiment_findings.hpp"
#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/plot/svg_text.hpp>

namespace granum::studies {

namespace {

constexpr const char* style = R"(
body { font-family: Georgia, "Times New Roman", serif; line-height: 1.45; color: #1c1c1c; background: #ffffff;
  max-width: 62rem; margin: 0 auto; padding: 0 1rem 3rem; }
h1, h2, h3, th, nav, .name, .yes, .no { font-family: Helvetica, Arial, sans-serif; }
h1 { font-size: 1.7rem; margin: 1.5rem 0 0.3rem; }
h2 { font-size: 1.3rem; border-bottom: 2px solid #444444; margin-top: 2.4rem; }
h3 { font-size: 1.05rem; margin: 1.8rem 0 0.3rem; }
nav a { margin-right: 1.1em; white-space: nowrap; }
a { color: #0b5394; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.92rem; margin: 0.4rem 0 1rem; }
th, td { padding: 0.2rem 0.7rem 0.2rem 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid #dddddd; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tr.first td { border-top: 1px solid #888888; }
.yes { color: #00664a; }
.no { color: #b03000; font-weight: bold; }
.panels { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr));
  gap: 0.6rem 1.2rem; }
.panels svg { width: 100%; max-width: 44rem; height: auto; }
.caption { font-size: 0.92rem; margin: 0.2rem 0 0.6rem; }
@media print {
  body { max-width: none; font-size: 10pt; padding: 0; }
  nav { display: none; }
  .panels { grid-template-columns: 1fr 1fr; }
  .panel, tr { break-inside: avoid; }
  h2, h3, .caption { break-after: avoid; }
}
)";

/// An element with markup inside.
std::string element(const std::string& tag, const std::string& content, const std::string& kind = "") {
  return "<" + tag + (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + content + "</" + tag + ">\n";
}

std::string escaped(std::string_view text) { return plot::svg_escaped(text); }
std::string paragraph(const std::string& text) { return element("p", escaped(text)); }

std::string row(const std::vector<std::string>& cells, const std::string& kind = "") {
  std::string content;
  for (const std::string& cell : cells)
    content += element("td", cell);
  return element("tr", content, kind);
}

std::string section(const std::string& id, const std::string& title, const std::string& content) {
  return "<section id=\"" + id + "\">\n" + element("h2", escaped(title)) + content + "</section>\n";
}

std::string yes_or_no(bool yes, const std::string& if_yes, const std::string& if_no) {
  return element("span", yes ? if_yes : if_no, yes ? "yes" : "no");
}

template <class Items, class Text>
std::string listed(const Items& items, const Text& text) {
  std::string out;
  for (const auto& item : items)
    out += (out.empty() ? "" : ", ") + std::string(text(item));
  return out;
}

std::size_t frozen_states(const Experiment& experiment) {
  std::size_t count = 0;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs)
      count += run.points.size();
  return count;
}

std::string duration(const RunTime& time) {
  const std::string text =
      time.seconds < 120 ? short_text(time.seconds, 3) + " s" : short_text(time.seconds / 60, 3) + " min";
  return text + (time.resumed ? ", since it was resumed" : "");
}

std::string what_was_run(const Experiment& experiment, const RunTime& time) {
  const Scene& scene = experiment.scene;
  const auto kilopascal = [](double pascal) { return short_text(pascal / 1e3); };
  std::string rows;
  const auto add = [&rows](const std::string& what, const std::string& value) {
    rows += row({escaped(what), escaped(value)});
  };
  add("Program", "granum " + std::string(version()) + " reproduce");
  add("Specimens",
      std::to_string(experiment.specimens.size()) + " of " + std::to_string(scene.study.grains) +
          " grains: " + listed(scene.study.contacts, [](contact::Shape s) { return name(s); }) + "; " +
          listed(scene.study.densities, [](triaxial::Density d) { return name(d); }) + "; " +
          (scene.study.seeds == 1 ? "seed " + std::to_string(scene.study.first_seed)
                                  : "seeds " + std::to_string(scene.study.first_seed) + " to " +
                                        std::to_string(scene.study.first_seed + scene.study.seeds - 1)));
  add("Boundary", scene.specimen.walls
                      ? "six rigid walls, friction " + short_text(scene.specimen.wall_friction)
                      : std::string("periodic cell"));
  add("Grains", "diameter " + short_text(2e3 * scene.grain.radius) + " mm, shear modulus " +
                    short_text(scene.grain.shear_modulus / 1e9) + " GPa, Poisson's ratio " +
                    short_text(scene.grain.poisson_ratio) + ", friction angle " +
                    short_text(scene.grain.friction_angle * 180 / std::numbers::pi) + " deg");
  add("Isotropic compression", listed(scene.study.pressures, kilopascal) + " kPa");
  add("Paths", listed(scene.shear.paths, [](stress::ShearPath p) { return stress::name(p); }) +
                   " to an axial strain of " + short_text(100 * scene.shear.largest_strain) +
                   " %, inertial number " + short_text(scene.shear.inertial_number));
  add("Frozen states", std::to_string(frozen_states(experiment)) + ", every " +
                           short_text(scene.shear.eta_step) + " of \u03b7 and every " +
                           short_text(100 * scene.shear.strain_step) + " % of axial strain");
  add("Wall time", duration(time));
  add("Complete", experiment.complete() ? "yes" : "no, see the end of this page");
  return element("table", rows);
}

std::string verdict_table(const std::vector<Verdict>& verdicts) {
  if (verdicts.empty())
    return paragraph("The run has no data for any claim of the paper.");
  const auto held = std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.holds; });
  std::string rows =
      element("tr", element("th", "Claim") + element("th", "Holds") + element("th", "Measured"));
  for (const Verdict& verdict : verdicts)
    rows += row({escaped(verdict.claim), yes_or_no(verdict.holds, "yes", "no"), escaped(verdict.measured)});
  return paragraph(std::to_string(held) + " of " + std::to_string(verdicts.size()) + " claims hold.") +
         element("div", element("table", rows), "wide");
}

/// "0.484 \u00b1 0.007": as many decimals as the two first digits of the error need, at most 4.
std::string shown(const TableValue& measured) {
  if (!measured.standard_error || !(*measured.standard_error > 0))
    return short_text(measured.value);
  const double error = *measured.standard_error;
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 4);
  const double unit = std::pow(10, -decimals);
  const auto rounded = [unit](double value) { return short_text(unit * std::round(value / unit), 12); };
  return rounded(measured.value) + " \u00b1 " + rounded(error);
}

std::string cell_row(const TableRow& specimen, const Cell& cell, bool first) {
  std::string content =
      element("td", first ? escaped(name(specimen.contact)) + ", " + escaped(name(specimen.density)) : "") +
      element("td", escaped(cell.quantity)) + element("td", shown(cell.ours), "number");
  content += element("td", cell.printed ? short_text(*cell.printed) : "", "number");
  content += element("td", cell.printed ? short_text(cell.ours.value - *cell.printed, 3) : "", "number");
  content += element("td", cell.reach ? short_text(*cell.reach) : "", "number");
  content += element("td", cell.printed && cell.reach ? yes_or_no(cell.holds(), "within", "beyond") : "");
  return element("tr", content, first ? "first" : "");
}

std::string table(const std::string& title, const std::vector<TableRow>& specimens) {
  std::string rows;
  for (const TableRow& specimen : specimens)
    for (const Cell& cell : specimen.cells)
      rows += cell_row(specimen, cell, &cell == &specimen.cells.front());
  const std::string head = element("h3", escaped(title));
  if (rows.empty())
    return head + paragraph("Nothing was measured.");
  std::string headings = element("th", "Specimen") + element("th", "Quantity");
  for (const char* heading : {"granum", "paper", "difference", "asked for"})
    headings += element("th", heading, "number");
  return head + element("div", element("table", element("tr", headings + element("th", "")) + rows), "wide");
}

/// A picture as a part of the page.
std::string inlined(const std::string& svg) { return element("div", svg.substr(svg.find("<svg")), "panel"); }

std::string figure_html(const std::string& title, const std::string& caption, const std::string& panels) {
  return element("figure", element("h3", escaped(title)) +
                               element("figcaption", escaped(caption), "caption") +
                               element("div", panels, "panels"));
}

std::string all_figures(const std::vector<Figure>& figures, const std::optional<AssemblyPicture>& assembly) {
  std::string out;
  if (assembly)
    out += figure_html("Fig. 3: packing::Assembly of particles", assembly->caption, inlined(assembly->svg));
  for (const Figure& figure : figures) {
    std::string panels;
    for (const Panel& panel : figure.panels)
      panels += inlined(plot::svg(panel.chart));
    out += figure_html(figure.name + ": " + figure.title, figure.caption, panels);
  }
  return out.empty() ? paragraph("There is nothing to draw.") : out;
}

std::string how_to_read() {
  std::string items;
  for (const char* text :
       {"Signs: compression is positive, of stress and of strain. v is the vertical axis z, h the horizontal "
        "ones. \u03b7 = q/p' with q = \u03c3_v - \u03c3_h and p' = (\u03c3_v + 2 \u03c3_h)/3: above zero in "
        "compression (TXC, "
        "RTXC), below in extension (RTXE, TXE). Strains are logarithmic, from the start of each path.",
        "Frozen states: a copy of the specimen is brought to rest in place, every contact kept from sliding. "
        "All "
        "that is measured on a state belongs to that copy.",
        "G of the network: linear answer of the frozen contacts, every grain in equilibrium. Cyclic shear: a "
        "small "
        "shear strain there and back on the frozen specimen, by the discrete element method. G_hh shears the "
        "horizontal plane, G_hv and G_vh a vertical one.",
        "Uniform strain: what G would be if every grain followed the mean strain; always stiffer. Relaxed, "
        "closed "
        "form: the same made softer by what the number of contacts says.",
        "Exponents: G = C p_a f(e) (\u03c3_i/p_a)^m (\u03c3_j/p_a)^n with f(e) = (2.17 - e)^2/(1 + e) and "
        "p_a = 100 kPa, "
        "s = m + n. The paper's C holds p_a in MPa and is not set beside ours.",
        "\u00b1 is one standard error: the larger of the scatter between seeds and the error of each, over "
        "the root of "
        "the number of seeds. With one seed it does not hold what another specimen would differ by.",
        "All numbers: states.csv, curves.csv, loops.csv, histograms.csv and the tables beside this page; the "
        "figures' "
        "own in "
        "the folder figures, each with a gnuplot script that draws it again. Figures 1, 2 and 5 of the paper "
        "are sketches."})
    items += element("li", escaped(text));
  return element("ul", items);
}

std::string left_out(const Experiment& experiment) {
  std::string items;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs) {
      const std::string where = std::string(name(specimen.contact)) + ", " +
                                std::string(name(specimen.density)) + ", seed " +
                                std::to_string(specimen.seed) + ", " + std::string(name(run.path)) + ": ";
      if (!run.failure.empty())
        items += element("li", escaped(where + "ended early: " + run.failure));
      for (const std::string& note : run.notes)
        items += element("li", escaped(where + note));
    }
  return items.empty() ? paragraph("Nothing: every path ran to its end, and every state could be frozen.")
                       : element("ul", items);
}

} // namespace

std::string experiment_html(const Experiment& experiment, const std::vector<Verdict>& verdicts,
                            const std::vector<Figure>& figures,
                            const std::optional<AssemblyPicture>& assembly, const RunTime& time) {
  const std::string title = "Elastic moduli along stress paths";
  std::string links;
  for (const auto& [id, text] : {std::pair{"run", "What was run"}, std::pair{"verdicts", "Verdicts"},
                                 std::pair{"tables", "Tables"}, std::pair{"figures", "Figures"},
                                 std::pair{"reading", "How to read this"}, std::pair{"left-out", "Left out"}})
    links += "<a href=\"#" + std::string(id) + "\">" + text + "</a>\n";
  const std::string tables =
      table("Table 2: start of isotropic compression", table_2(experiment)) +
      table("Table 4: friction angle at the peak", table_4(experiment)) +
      table("Table 5: fit of Eq. (1) to the network's moduli for |\u03b7| \u2264 0.6", table_5(experiment)) +
      table("Further exponents", further_exponents(experiment));
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
         element("title", escaped("granum reproduce: " + title)) + element("style", style) +
         "</head>\n<body>\n" + element("h1", escaped(title)) +
         paragraph("The experiment of Chung, Jang, Baek and Jung, \u201cHow contact stiffness and density "
                   "determine "
                   "stress-dependent elastic moduli\u201d, Granular Matter 16 (2014) 23-39, run by granum, "
                   "its numbers "
                   "beside the printed ones.") +
         element("nav", links) + section("run", "What was run", what_was_run(experiment, time)) +
         section("verdicts", "Verdicts", verdict_table(verdicts)) + section("tables", "Tables", tables) +
         section("figures", "Figures", all_figures(figures, assembly)) +
         section("reading", "How to read this", how_to_read()) +
         section("left-out", "Left out", left_out(experiment)) + "</body>\n</html>\n";
}

} // namespace granum::studies
