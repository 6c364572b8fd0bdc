// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/number.hpp>
#include <granum/core/units.hpp>

#include "analyse_series.hpp"
#include "analyse_stiffness.hpp"
#include "cli/options/size_options.hpp"

namespace granum::cli {

namespace {

using analysis::Measurement;

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

/// Sizes of unequal grains, and what the closed forms took of them.
std::string sizes_text(const analysis::Sizes& s, bool contacts_known) {
  std::string text = item("C_u = d60/d10", fmt::format("{:.4f}", s.gradation.uniformity()),
                          "by mass; " + gradation_text(s.gradation));
  if (contacts_known)
    text += item("R of closed forms", pretty(s.equivalent, Dimension::length),
                 "and of the contacts " + means_text(s.contacts));
  return text;
}

std::string counts_text(const studies::MeasuredFrame& frame) {
  const Measurement& a = frame.packing;
  const analysis::Counts& c = a.counts;
  const bool equal = a.sizes.smallest == a.sizes.largest;
  std::string text = "\ngrains and contacts\n";
  text += item("grains", std::to_string(c.grains),
               equal ? "R = " + pretty(a.sizes.largest, Dimension::length)
                     : "R from " + pretty(a.sizes.smallest, Dimension::length) + " to " +
                           pretty(a.sizes.largest, Dimension::length));
  if (!equal)
    text += sizes_text(a.sizes, frame.contacts_known);
  text += item("void ratio e", fmt::format("{:.4f}", a.void_ratio));
  if (!frame.contacts_known)
    return text + item("C_n, z*, rattlers", "unknown", "no file holds contacts");
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

std::string window_text(const analysis::Window& window, const analysis::InteriorMeasures& inside) {
  std::string text =
      "\nwindow, whose state the closed forms take; the network is that of the whole, as the stiffness\n"
      "of a part depends on what holds the grains at its faces\n";
  for (int k = 0; k < 3; ++k)
    text += item(std::string(1, "xyz"[k]), pretty(window.low[k], Dimension::length) + " to " +
                                               pretty(window.high[k], Dimension::length));
  text += item("grains", std::to_string(inside.grains), "with their centres inside");
  text += item("void ratio e", fmt::format("{:.4f}", inside.void_ratio), "of whole and cut grains");
  text +=
      item("C_n", fmt::format("{:.4f}", inside.micro.coordination_number), "of these grains, without walls");
  text += item("z*", fmt::format("{:.4f}", inside.micro.mechanical_coordination_number),
               short_text(100 * inside.micro.rattler_fraction) + " % rattlers");
  text += item("a", with_error(inside.micro.fabric_anisotropy, inside.micro.fabric_anisotropy_error));
  const Mat3& s = inside.stress;
  return text +
         item("stress xx yy zz [kPa]", short_text(s(0, 0) / 1e3, 6) + " " + short_text(s(1, 1) / 1e3, 6) +
                                           " " + short_text(s(2, 2) / 1e3, 6));
}

std::string verdict(double p_value, const char* yes, const char* no) {
  constexpr double doubt = 0.01;
  return fmt::format("{}, p = {}", p_value < doubt ? no : yes, short_text(p_value, 2));
}

std::string fabric_text(const analysis::Fabric& f) {
  std::string text = "\nfabric\n";
  text += item("F_11 F_22 F_33",
               fmt::format("{:.5f} {:.5f} {:.5f}", f.tensor(0, 0), f.tensor(1, 1), f.tensor(2, 2)));
  text += item("F_23 F_13 F_12",
               fmt::format("{:.5f} {:.5f} {:.5f}", f.tensor(1, 2), f.tensor(0, 2), f.tensor(0, 1)));
  text += item("a", with_error(f.by_moment.anisotropy, f.by_moment.standard_error), "from F_33");
  if (f.by_likelihood)
    text +=
        item("a", with_error(f.by_likelihood->anisotropy, f.by_likelihood->standard_error), "most likely");
  if (f.isotropy)
    text += item("different from 0?", verdict(f.isotropy->p_value, "no", "yes"));
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
  const Measurement& a = frame.measured.packing;
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

std::string forces_text(const analysis::Forces& f) {
  const packing::ForceDistribution& d = f.distribution;
  std::string text = "\nforces\n";
  text += item("mean f_n", pretty(d.mean, Dimension::force),
               fmt::format("of {} pressing contacts; {} in tension, {} unloaded", d.pressing, d.in_tension,
                           d.unloaded));
  text += item("largest f_n", pretty(d.largest, Dimension::force),
               d.mean > 0 ? short_text(d.largest / d.mean) + " times the mean" : "");
  text += item("Z(2)  Z(5/3)", fmt::format("{:.4f} {:.4f}", f.Z_2, f.Z_5_3), "<f_n^x>/<f_n>^x");
  if (f.mean_tangential_over_normal)
    text += item("mean f_t/mean f_n", fmt::format("{:.4f}", *f.mean_tangential_over_normal));
  if (f.friction)
    text += item("friction coefficient", fmt::format("{:.4f}", f.friction->coefficient),
                 fmt::format("contacts pile up there, {} of them", f.friction->contacts));
  if (f.sliding_fraction)
    text += item("sliding contacts", short_text(100 * *f.sliding_fraction) + " %");
  if (!f.unbalance)
    text += item("left unbalanced", "unknown", "the tangential forces are not known");
  else if (f.unbalance->force_ratio > 0)
    text += item("left unbalanced", short_text(f.unbalance->force_ratio, 3),
                 "mean |force| on a grain over mean contact force");
  if (f.weight)
    text += item("of it weight", short_text(100 * (1 - f.weight->left_over), 4) + " %",
                 short_text(norm(f.weight->per_volume) / 1e3, 4) + " kN per m3 of solid");
  return text;
}

std::string law_text(const analysis::LawCheck& check) {
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

/// Measured over closed form, K and G.
std::string ratios(const Moduli* network, const Moduli& m) {
  if (network == nullptr || !(m.K > 0) || !(m.G > 0))
    return "";
  return fmt::format("   {:>6.3f} {:>6.3f}", network->K / m.K, network->G / m.G);
}

/// "+- 3 %" of G_vh where it is stated.
std::string stated_error(const RungResult& rung) {
  return rung.relative_error ? fmt::format("   G +- {} %", short_text(100 * rung.relative_error->G_vh, 2))
                             : "";
}

std::string moduli_text(const FrameAnswer& frame) {
  std::string text =
      "\nprojected: K and G of the nearest isotropic stiffness, the others of the nearest one that "
      "is symmetric about z\n";
  text += fmt::format("{:<24} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}   network/this: K, G\n", "moduli [MPa]",
                      "K", "G", "G_hh", "G_vh", "C11", "C33");
  const Moduli* network = network_moduli(frame);
  for (const RungResult& rung : frame.rungs) {
    text += fmt::format("  {:<22}", rung.title);
    if (!rung.moduli) {
      text += " " + rung.error + "\n";
      continue;
    }
    const Moduli& m = *rung.moduli;
    for (const double modulus : {m.K, m.G, m.G_hh, m.G_vh, m.C11, m.C33})
      text += fmt::format(" {:>9.4g}", modulus / 1e6);
    text += (rung.name == network_name ? "" : ratios(network, m)) + stated_error(rung) + "\n";
  }
  return text;
}

std::string frame_text(const FrameAnswer& frame) {
  const Measurement& a = frame.measured.packing;
  std::string text = fmt::format("frame {}, step {}", frame.number, frame.measured.step);
  if (frame.measured.time)
    text += fmt::format(", time {} s", short_text(*frame.measured.time, 6));
  text += "\n" + reading_text(frame);
  if (a.counts.grains > 0)
    text += counts_text(frame.measured);
  if (frame.window && a.interior)
    text += window_text(*frame.window, *a.interior);
  if (a.fabric)
    text += fabric_text(*a.fabric);
  if (a.stress)
    text += stress_text(frame);
  if (a.forces)
    text += forces_text(*a.forces);
  if (a.law_check && a.law_check->contacts > 0)
    text += law_text(*a.law_check);
  if (!frame.rungs.empty())
    text += moduli_text(frame) + stiffness_text(frame);
  if (!a.notes.empty())
    text += "\n";
  for (const std::string& note : a.notes)
    text += "- " + note + "\n";
  return text;
}

/// One line a frame.
std::string frames_text(const AnalyseAnswer& answer) {
  const io::Columns<FrameAnswer> columns = frame_columns(answer);
  std::string text = "\n" + io::heading_line(columns) + "\n";
  for (const FrameAnswer& frame : answer.frames)
    text += io::number_line(columns, frame) + "\n";
  return text;
}

/// The files, one a line; of many the first and the last of each kind.
std::string files_text(const AnalyseAnswer& answer) {
  constexpr std::size_t many = 8;
  std::string text;
  std::size_t alike = 0; // files before this one of its kind, behind one another
  for (std::size_t k = 0; k < answer.files.size(); ++k) {
    alike = k > 0 && answer.kinds[k] == answer.kinds[k - 1] ? alike + 1 : 0;
    const bool last = k + 1 == answer.files.size() || !(answer.kinds[k + 1] == answer.kinds[k]);
    if (answer.files.size() > many && alike > 0 && !last)
      continue;
    if (answer.files.size() > many && alike > 1)
      text += fmt::format("  ... {} more\n", alike - 1);
    text += answer.files[k] + ": " + std::string(io::description(answer.kinds[k])) + "\n";
  }
  return text;
}

} // namespace

std::string analyse_table(const AnalyseAnswer& answer) {
  std::string text = files_text(answer);
  constexpr std::size_t whole = 2; // frames that are shown with all that is known
  if (answer.frames.size() > whole)
    text += fmt::format("\nthe last of {} frames:\n", answer.frames.size());
  for (std::size_t k = answer.frames.size() > whole ? answer.frames.size() - 1 : 0; k < answer.frames.size();
       ++k)
    text += "\n" + frame_text(answer.frames[k]);
  if (answer.frames.size() > 1)
    text += frames_text(answer) + series_text(answer);
  if (answer.skipped > 0)
    text += fmt::format("\n{} frames stand in one of the files only and were passed over\n", answer.skipped);
  return text;
}

} // namespace granum::cli
