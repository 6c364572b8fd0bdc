// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/verify/tables.hpp>

#include <cstdarg>
#include <cstdio>
#include <limits>

#include <granum/io/csv.hpp>
#include <granum/verify/version.hpp>

namespace granum::verify {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN(); // an empty cell

std::string words(std::string_view view) { return std::string(view); }

[[gnu::format(printf, 1, 2)]] std::string line(const char* format, ...) {
  char buffer[256];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

io::CsvCell value(const std::optional<Measured>& exponent) { return exponent ? exponent->value : nothing; }
io::CsvCell error(const std::optional<Measured>& exponent) {
  return exponent ? exponent->standard_error : nothing;
}

std::string shown(const std::optional<Measured>& exponent) {
  return exponent ? line("%6.3f +- %.3f", exponent->value, exponent->standard_error) : "       -       ";
}

} // namespace

std::string states_csv(const Scene& scene, const std::vector<SpecimenResult>& specimens) {
  io::CsvContent csv;
  csv.notes = {{"program", "granum " + words(version()) + " verify"},
               {"grains", std::to_string(scene.study.grains)},
               {"signs", "compression positive; z is the vertical axis v"}};
  csv.headings = {"contact",
                  "density",
                  "seed",
                  "p_Pa",
                  "p_contacts_Pa",
                  "p_work_Pa",
                  "e",
                  "C_n",
                  "z_star",
                  "rattler_fraction",
                  "a",
                  "a_error",
                  "sliding_fraction",
                  "G_closed_Pa",
                  "K_closed_Pa",
                  "G_uniform_strain_Pa",
                  "K_uniform_strain_Pa",
                  "G_network_Pa",
                  "K_network_Pa",
                  "G_hh_network_Pa",
                  "G_vh_network_Pa",
                  "K_lower_Pa",
                  "K_upper_Pa",
                  "G_hh_probe_Pa",
                  "G_hv_probe_Pa",
                  "G_vh_probe_Pa",
                  "probe_strain",
                  "steps",
                  "unbalanced_force_ratio",
                  "inertial_number",
                  "network_iterations",
                  "network_residual"};
  for (const SpecimenResult& specimen : specimens)
    for (const StateResult& s : specimen.states) {
      const Probes probes = s.probes.value_or(Probes{nothing, nothing, nothing, nothing});
      csv.rows.push_back({words(name(specimen.contact)),
                          words(name(specimen.density)),
                          static_cast<double>(specimen.seed),
                          s.pressure,
                          s.pressure_by_contacts,
                          s.pressure_by_work,
                          s.void_ratio,
                          s.coordination_number,
                          s.mechanical_coordination_number,
                          s.rattler_fraction,
                          s.fabric_anisotropy,
                          s.fabric_anisotropy_error,
                          s.sliding_fraction,
                          s.G_closed,
                          s.K_closed,
                          s.G_uniform_strain,
                          s.K_uniform_strain,
                          s.G_network,
                          s.K_network,
                          s.G_hh_network,
                          s.G_vh_network,
                          s.K_lower,
                          s.K_upper,
                          probes.G_hh,
                          probes.G_hv,
                          probes.G_vh,
                          probes.amplitude,
                          static_cast<double>(s.steps),
                          s.unbalanced_force_ratio,
                          s.largest_inertial_number,
                          static_cast<double>(s.network_iterations),
                          s.network_residual});
    }
  return io::csv_text(csv);
}

std::string exponents_csv(const std::vector<ExponentRow>& rows) {
  io::CsvContent csv;
  csv.notes = {{"program", "granum " + words(version()) + " verify"},
               {"meaning", "s of G ~ p^s by Levenberg-Marquardt on G; paper: Table 5, G_hv"}};
  csv.headings = {"contact",       "density",           "contact_law",
                  "closed_form",   "closed_form_error", "network",
                  "network_error", "network_with_f_e",  "network_with_f_e_error",
                  "probe",         "probe_error",       "paper"};
  for (const ExponentRow& row : rows)
    csv.rows.push_back({words(name(row.contact)), words(name(row.density)), row.contact_law,
                        value(row.closed_form), error(row.closed_form), value(row.network),
                        error(row.network), value(row.network_void), error(row.network_void),
                        value(row.probe), error(row.probe), row.paper.value_or(nothing)});
  return io::csv_text(csv);
}

std::string states_table(const std::vector<SpecimenResult>& specimens) {
  std::string out;
  for (const SpecimenResult& specimen : specimens) {
    out += line("\n%s, %s, seed %llu\n", words(name(specimen.contact)).c_str(),
                words(name(specimen.density)).c_str(), static_cast<unsigned long long>(specimen.seed));
    out += "  p [kPa]    C_n     z*       e   G closed   G network   ratio*   G_hh probe  G_hv probe  G_vh "
           "probe [MPa]\n";
    for (const StateResult& s : specimen.states) {
      out += line("  %7.4g  %5.3f  %5.3f  %6.4f  %9.4g   %9.4g   %6.3f", s.pressure / 1e3,
                  s.coordination_number, s.mechanical_coordination_number, s.void_ratio, s.G_closed / 1e6,
                  s.G_network / 1e6, s.G_network / s.G_uniform_strain);
      if (s.probes)
        out += line("    %9.4g   %9.4g   %9.4g", s.probes->G_hh / 1e6, s.probes->G_hv / 1e6,
                    s.probes->G_vh / 1e6);
      out += "\n";
    }
    if (!specimen.failure.empty())
      out += "  ended early: " + specimen.failure + "\n";
  }
  return out + "\n  * G network / G of the same network under uniform strain\n";
}

std::string exponents_table(const std::vector<ExponentRow>& rows) {
  std::string out = "s of G ~ p^s\n  contact    density  1/(1+alpha)   closed form       network           "
                    "with f(e)         probe             paper\n";
  for (const ExponentRow& row : rows)
    out += line("  %-9s  %-7s  %9.3f   %s   %s   %s   %s   %s\n", words(name(row.contact)).c_str(),
                words(name(row.density)).c_str(), row.contact_law, shown(row.closed_form).c_str(),
                shown(row.network).c_str(), shown(row.network_void).c_str(), shown(row.probe).c_str(),
                row.paper ? line("%5.3f", *row.paper).c_str() : "    -");
  return out;
}

std::string verdicts_table(const std::vector<Verdict>& verdicts) {
  std::string out;
  for (const Verdict& verdict : verdicts)
    out += std::string(verdict.holds ? "  holds  " : "  FAILS  ") + verdict.claim + ": " + verdict.measured +
           "\n";
  return out;
}

} // namespace granum::verify
