// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_html.hpp"

#include <numbers>

#include "studies/report/verdict_lists.hpp"
#include "studies/reproduce/experiment_findings.hpp"
#include "studies/reproduce/experiment_tables.hpp"
#include "studies/reproduce/figures/figure_parts.hpp"
#include <granum/core/text.hpp>
#include <granum/core/version.hpp>
#include <granum/plot/svg_text.hpp>

namespace granum::studies {

namespace {

template <class Items, class Text>
std::string listed(const Items& items, const Text& text) {
  std::string out;
  for (const auto& item : items)
    out += (out.empty() ? "" : ", ") + std::string(text(item));
  return out;
}

constexpr const char* paper_text =
    "The experiment of Chung, Jang, Baek and Jung, \u201cHow contact stiffness and density determine "
    "stress-dependent elastic moduli\u201d, Granular Matter 16 (2014) 23-39.";

/// A state of isotropic compression as the report's first pictures show it.
RouteState route_state(const StateRecord& point) {
  RouteState out{.pressure = point.at.stress.mean(),
                 .mechanical_coordination_number = point.micro.mechanical_coordination_number,
                 .network = {point.G_vh(), point.G_vh(), point.G_hh()},
                 .softening = network_over_uniform_strain(point)};
  if (point.closed)
    out.relaxed = {point.closed->relaxed.G_vh(), point.closed->relaxed.G_vh(), point.closed->relaxed.G_hh()};
  if (point.probes)
    out.probe = {point.probes->G_hv, point.probes->G_vh, point.probes->G_hh};
  return out;
}

std::string duration(const RunTime& time) {
  const std::string text =
      time.seconds < 120 ? short_text(time.seconds, 3) + " s" : short_text(time.seconds / 60, 3) + " min";
  return text + (time.resumed ? ", since it was resumed" : "");
}

std::string what_was_run(const Experiment& experiment, const RunTime& time) {
  const Scene& scene = experiment.scene;
  const auto kilopascal = [](double pascal) { return short_text(pascal / 1e3); };
  std::vector<std::vector<std::string>> rows;
  const auto add = [&rows](const std::string& what, const std::string& value) {
    rows.push_back({what, value});
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
  return plot::html_table({"", ""}, rows);
}

std::string table(const std::string& title, const std::vector<TableRow>& specimens) {
  const std::vector<CellRow> cells = cell_rows(specimens);
  return plot::html_folded(title, cells.empty() ? plot::html_paragraph("Nothing was measured.")
                                                : io::page_table(cell_columns(), cells));
}

/// Which of the three moduli a panel shows, if its figure has them all.
std::string choice_of(const Panel& panel) {
  for (const char* modulus : shear_modulus_names)
    if (panel.y_heading == std::string(modulus) + "_Pa")
      return modulus;
  return {};
}

std::string folded_figure(const Figure& figure) {
  plot::PageFigure out{.caption = figure.caption};
  for (const Panel& panel : figure.panels) {
    out.pictures.push_back({.svg = plot::svg_in_page(panel.chart), .choice = choice_of(panel)});
    out.files.push_back(file_of(panel, figures_folder));
  }
  return plot::html_folded(figure.name + ": " + figure.title, plot::html_figure(out));
}

std::string all_figures(const std::vector<Figure>& figures, const std::optional<AssemblyPicture>& assembly) {
  std::string out;
  if (assembly)
    out += plot::html_folded(
        "Fig. 3: the assembly of particles",
        plot::html_figure(
            {.caption = assembly->caption, .pictures = {{.svg = assembly->in_page}}, .files = {}}));
  for (const Figure& figure : figures)
    out += folded_figure(figure);
  return out.empty() ? plot::html_paragraph("No figures.") : out;
}

std::string how_to_read() {
  return plot::html_list(
      {"Signs: compression is positive, of stress and of strain. v is the vertical axis z, h are the "
       "horizontal axes. \u03b7 = q/p' with q = \u03c3_v - \u03c3_h and p' = (\u03c3_v + 2 \u03c3_h)/3: "
       "above zero in compression (TXC, RTXC), below zero in extension (RTXE, TXE). Strains are logarithmic, "
       "from the start of each path.",
       "Symbols: e void ratio, C_n mean number of contacts of a grain, z* the same without rattlers (grains "
       "that carry no load), a anisotropy of the contact directions (above zero: more near the vertical).",
       "Frozen states: a copy of the specimen is brought to rest with sliding prevented at all contacts. "
       "All measurements of a state are made on this copy.",
       "G of the network: linear response of the frozen contacts, every grain in equilibrium. Cyclic shear: "
       "a small shear strain back and forth on the frozen specimen, by the discrete element method (DEM). "
       "G_hh is the shear modulus of the horizontal plane, G_hv and G_vh that of a vertical plane.",
       "Uniform strain: G if every grain followed the mean strain; it exceeds G of the network. Relaxed "
       "closed form: the same times a reduction factor that depends on the number of contacts.",
       "Exponents: G = C p_a f(e) (\u03c3_i/p_a)^m (\u03c3_j/p_a)^n, the paper's Eq. (1), with f(e) = "
       "(2.17 - e)^2/(1 + e), p_a = 100 kPa and s = m + n. For G_hv \u03c3_i is \u03c3_h and \u03c3_j is "
       "\u03c3_v; G_hh is fitted with \u03c3_h alone. The paper's C is for p_a in MPa and is not compared.",
       "\u00b1 is one standard error: the larger of the scatter between seeds and the error of each seed, "
       "divided by the root of the number of seeds. With one seed, the scatter between specimens is not "
       "included. Within: whether the difference from the paper is within the limit (column reach of the "
       "CSV files); undecided if the standard error is larger than the limit.",
       "All numbers: states.csv, curves.csv, loops.csv, histograms.csv and the tables next to this page; the "
       "data of figures in the folder figures. Figures 1, 2 and 5 of the paper are sketches."});
}

std::string left_out(const Experiment& experiment) {
  std::vector<std::string> items;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs) {
      const std::string where = std::string(name(specimen.contact)) + ", " +
                                std::string(name(specimen.density)) + ", seed " +
                                std::to_string(specimen.seed) + ", " + std::string(name(run.path)) + ": ";
      if (!run.failure.empty())
        items.push_back(where + "ended early: " + run.failure);
      for (const std::string& note : run.notes)
        items.push_back(where + note);
    }
  return items.empty()
             ? plot::html_paragraph("Nothing: every path ran to its end, and every state could be frozen.")
             : plot::html_list(items);
}

std::string report_body(const Experiment& experiment, const CompressionStory& story,
                        const std::vector<Verdict>& verdicts, const std::vector<Figure>& figures,
                        const std::optional<AssemblyPicture>& assembly, const RunTime& time) {
  const std::string tables =
      table("Table 2: start of isotropic compression", table_2(experiment)) +
      table("Table 4: friction angle at the peak", table_4(experiment)) +
      table("Table 5: exponents and C of the networks' moduli for |\u03b7| \u2264 0.6 (equation: see "
            "\u201cHow to read this\u201d)",
            table_5(experiment)) +
      table("Further exponents", further_exponents(experiment));
  return story.first_screen + story.why +
         plot::html_section("verdicts", "Agreement and differences with the paper",
                            plot::html_paragraph(paper_text, "soft") + verdict_lists(verdicts)) +
         plot::html_section("tables", "Tables compared with the paper's", tables) +
         plot::html_section("figures", "Figures", all_figures(figures, assembly)) +
         plot::html_section("run", "The run",
                            plot::html_folded("What was run", what_was_run(experiment, time)) +
                                plot::html_folded("How to read this", how_to_read()) +
                                plot::html_folded("Left out", left_out(experiment)));
}

} // namespace

std::size_t frozen_states(const Experiment& experiment) {
  std::size_t count = 0;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs)
      count += run.points.size();
  return count;
}

std::vector<Compression> compressions(const Experiment& experiment) {
  const std::vector<TableRow> exponents = table_5(experiment);
  std::vector<Compression> out;
  for (const Kind& kind : kinds(experiment)) {
    Compression one{.contact = kind.contact,
                    .density = kind.density,
                    .contact_exponent = studies::contact_exponent(experiment.scene, kind.contact)};
    for (const TableRow& row : exponents)
      for (const Cell& cell : row.cells)
        if (row.contact == kind.contact && row.density == kind.density && cell.quantity == "s of G_hv") {
          one.exponent = Measured{cell.ours.value, cell.ours.standard_error.value_or(0)};
          one.paper_exponent = cell.printed;
        }
    const PathRun* run = find_run(*kind.specimen, std::nullopt);
    for (std::size_t k = 0; run != nullptr && k < run->points.size(); ++k)
      one.states.push_back(route_state(run->points[k]));
    out.push_back(std::move(one));
  }
  return out;
}

ExperimentReport experiment_report(const Experiment& experiment, const std::vector<Verdict>& verdicts,
                                   const std::vector<Figure>& figures,
                                   const std::optional<AssemblyPicture>& assembly, const RunTime& time) {
  CompressionStory story = compression_story(experiment.scene, compressions(experiment), figures_folder);
  return {.html = plot::html_page("granum reproduce: why G grows as p^s",
                                  report_body(experiment, story, verdicts, figures, assembly, time)),
          .panels = std::move(story.panels)};
}

} // namespace granum::studies
