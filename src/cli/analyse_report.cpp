// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/core.h>
#include <granum/core/number.hpp>
#include <granum/core/units.hpp>

#include "analyse.hpp"

namespace granum::cli {

namespace {

using verify::Analysis;

/// "number what", on a line of its own.
std::string item(const std::string& label, const std::string& value, const std::string& meaning = "") {
  std::string line = fmt::format("  {:<24} {:<28} {}", label, value, meaning);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string with_error(double value, double error) { return fmt::format("{:.4f} +- {:.4f}", value, error); }

std::string reading_text(const FrameAnswer& frame) {
  std::string text;
  for (const bool missing : {false, true}) {
    std::string list;
    for (const io::ImportNote& note : frame.read)
      if (says_what_is_missing(note.finding) == missing)
        list += "    - " + note.text + "\n";
    if (!list.empty())
      text += (missing ? "  the files do not tell\n" : "  found while reading\n") + list;
  }
  return text;
}

std::string counts_text(const Analysis& a) {
  const verify::CountAnalysis& c = a.counts;
  const bool equal = a.smallest_radius == a.largest_radius;
  std::string text = "\ngrains and contacts\n";
  text += item("grains", std::to_string(c.grains),
               equal ? "R = " + pretty(a.largest_radius, Dimension::length)
                     : "R from " + pretty(a.smallest_radius, Dimension::length) + " to " +
                           pretty(a.largest_radius, Dimension::length) + ", closed forms with " +
                           pretty(a.equivalent_radius, Dimension::length));
  text += item("void ratio e", fmt::format("{:.4f}", a.void_ratio));
  text += item("C_n", fmt::format("{:.4f}", c.coordination_number),
               fmt::format("2 N_c/N, all grains; {} contacts", c.contacts));
  text += item("z*", fmt::format("{:.4f}", c.mechanical.coordination_number),
               fmt::format("without {} rattlers, {} % of the grains", c.mechanical.rattler_count,
                           short_text(100 * c.mechanical.rattler_fraction)));
  text += item("grains without contact", std::to_string(c.without_contact),
               fmt::format("C_n of the others {:.4f}", c.touching_coordination_number));
  text +=
      item("contacts with walls", std::to_string(c.wall_contacts),
           c.wall_contacts == 0 ? "" : fmt::format("C_n with them {:.4f}", c.coordination_number_with_walls));
  return text;
}

std::string verdict(double p_value, const char* yes, const char* no) {
  constexpr double doubt = 0.01;
  return fmt::format("{}, p = {}", p_value < doubt ? no : yes, short_text(p_value, 2));
}

std::string fabric_text(const verify::FabricAnalysis& f) {
  std::string text = "\nfabric\n";
  text += item("F_11 F_22 F_33",
               fmt::format("{:.5f} {:.5f} {:.5f}", f.tensor(0, 0), f.tensor(1, 1), f.tensor(2, 2)));
  text += item("F_23 F_13 F_12",
               fmt::format("{:.5f} {:.5f} {:.5f}", f.tensor(1, 2), f.tensor(0, 2), f.tensor(0, 1)));
  text += item("a", with_error(f.by_moment.anisotropy, f.by_moment.standard_error), "from F_33");
  text += item("a", with_error(f.by_likelihood.anisotropy, f.by_likelihood.standard_error), "most likely");
  text += item("different from 0?", verdict(f.isotropy.p_value, "no", "yes"));
  if (f.density)
    text +=
        item("E(gamma; a) fits?", verdict(f.density->chi_square.p_value, "yes", "no"),
             fmt::format("chi^2 = {} of {} degrees of freedom", short_text(f.density->chi_square.statistic),
                         f.density->chi_square.degrees_of_freedom));
  if (f.axisymmetry)
    text += item("symmetric about z?", verdict(f.axisymmetry->both.p_value, "yes", "no"));
  return text;
}

std::string stress_text(const FrameAnswer& frame) {
  const Analysis& a = frame.analysis;
  const PrintedStress stress = printed(*a.stress);
  std::string text = "\nstress [kPa], by contacts";
  text += frame.code_stress ? " against the code's own\n" : "\n";
  double size = 0;
  for (const double s : stress)
    size = std::max(size, std::abs(s));
  for (std::size_t k = 0; k < stress.size(); ++k) {
    text += fmt::format("  {:<4} {:>18.10f}", stress_names[k], stress[k] / 1e3);
    if (frame.code_stress) {
      const double other = (*frame.code_stress)[k];
      text += fmt::format(" {:>18.10f}   relative difference {}", other / 1e3,
                          other == 0 ? "-" : short_text(stress[k] / other - 1, 2));
    }
    text += "\n";
  }
  text += fmt::format("  mean {} kPa; asymmetry {}\n", short_text(a.stress->mean() / 1e3, 10),
                      short_text(a.stress->asymmetry, 2));
  return text;
}

std::string forces_text(const verify::ForceAnalysis& f) {
  const ForceDistribution& d = f.distribution;
  std::string text = "\nforces\n";
  text += item("mean f_n", pretty(d.mean, Dimension::force),
               fmt::format("of {} pressing contacts; {} in tension, {} unloaded", d.pressing, d.in_tension,
                           d.unloaded));
  text += item("largest f_n", pretty(d.largest, Dimension::force),
               d.mean > 0 ? short_text(d.largest / d.mean) + " times the mean" : "");
  text += item("Z(2)  Z(5/3)", fmt::format("{:.4f} {:.4f}", f.Z_2, f.Z_5_3), "<f_n^x>/<f_n>^x");
  text += item("mean f_t/mean f_n", fmt::format("{:.4f}", f.mean_tangential_over_normal));
  if (f.friction)
    text += item("friction coefficient", fmt::format("{:.4f}", f.friction->coefficient),
                 fmt::format("contacts pile up there, {} of them", f.friction->contacts));
  if (f.sliding_fraction)
    text += item("sliding contacts", short_text(100 * *f.sliding_fraction) + " %");
  text += item("left unbalanced", short_text(f.unbalance.force_ratio, 3),
               "mean |force| on a grain over mean contact force");
  return text;
}

std::string law_text(const verify::LawCheck& check) {
  std::string text = "\ncontact law, from forces against overlaps\n";
  if (check.force_exponent)
    text += item(
        "f_n ~ d^x, x",
        fmt::format("{:.6f} +- {:.2g}", check.force_exponent->value, check.force_exponent->standard_error),
        fmt::format("{} contacts, {} left out", check.contacts, check.left_out));
  if (check.alpha)
    text += item("alpha", fmt::format("{:.6f} +- {:.2g}", check.alpha->value, check.alpha->standard_error),
                 "cone 1, sphere 2");
  text += item("force over that law's", short_text(check.coefficient_ratio, 8), "median");
  text += item("misfit",
               fmt::format("{} {} {}", short_text(check.median_misfit, 2), short_text(check.misfit_90, 2),
                           short_text(check.worst_misfit, 2)),
               "median, 90 %, worst");
  return text;
}

std::string moduli_row(const std::string& title, const Moduli& m) {
  return fmt::format("  {:<24} {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g} {:>9.4g}", title, m.K / 1e6,
                     m.G / 1e6, m.G_hh / 1e6, m.G_vh / 1e6, m.C11 / 1e6, m.C33 / 1e6);
}

/// Measured over closed form, K and G.
std::string ratios(const std::optional<Moduli>& measured, const Moduli& m) {
  if (!measured || !(m.K > 0) || !(m.G > 0))
    return "\n";
  return fmt::format("   {:>6.3f} {:>6.3f}\n", measured->K / m.K, measured->G / m.G);
}

std::string moduli_text(const FrameAnswer& frame) {
  const Analysis& a = frame.analysis;
  std::string text = "\nmoduli [MPa]                      K         G      G_hh      G_vh       C11       C33"
                     "   network/this: K, G\n";
  std::optional<Moduli> measured;
  if (a.network && a.network->report.status == network::Status::converged)
    measured = moduli_of(a.network->relaxed);
  for (const ClosedForm& form : frame.closed) {
    const std::string title = std::string(form.rung->key).size() == 1 ? std::string("rung ") + form.rung->key
                                                                      : std::string(form.rung->key);
    if (form.answer) {
      const Moduli m = moduli_of(form.answer->stiffness);
      text += moduli_row(title, m) + ratios(measured, m);
    } else {
      text += fmt::format("  {:<24} {}\n", title, form.error);
    }
  }
  if (a.network) {
    const Moduli affine = moduli_of(a.network->affine);
    text += moduli_row("this network, affine", affine) + ratios(measured, affine);
    if (measured)
      text += moduli_row("rung 4, this network", *measured) + "\n";
    else
      text += "  rung 4, this network     did not converge\n";
  }
  return text;
}

std::string frame_text(const FrameAnswer& frame) {
  const Analysis& a = frame.analysis;
  std::string text = fmt::format("frame {}, step {}", frame.number, a.step);
  if (a.time)
    text += fmt::format(", time {} s", short_text(*a.time, 6));
  text += "\n" + reading_text(frame) + counts_text(a);
  if (a.fabric)
    text += fabric_text(*a.fabric);
  if (a.stress)
    text += stress_text(frame);
  if (a.forces)
    text += forces_text(*a.forces);
  if (a.law_check && a.law_check->contacts > 0)
    text += law_text(*a.law_check);
  if (!frame.closed.empty() || a.network)
    text += moduli_text(frame);
  if (!a.notes.empty())
    text += "\n";
  for (const std::string& note : a.notes)
    text += "- " + note + "\n";
  return text;
}

} // namespace

std::string analyse_table(const AnalyseAnswer& answer) {
  std::string text;
  for (std::size_t k = 0; k < answer.files.size(); ++k)
    text += answer.files[k] + ": " + std::string(io::description(answer.kinds[k])) + "\n";
  for (const FrameAnswer& frame : answer.frames)
    text += "\n" + frame_text(frame);
  if (answer.skipped > 0)
    text += fmt::format("\n{} frames stand in one of the files only and were passed over\n", answer.skipped);
  return text;
}

} // namespace granum::cli
