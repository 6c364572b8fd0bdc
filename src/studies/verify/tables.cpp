// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/tables.hpp"

#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/io/csv/table.hpp>

namespace granum::studies {

namespace {

std::string words(std::string_view view) { return std::string(view); }

std::optional<double> fabric_number(const CompressedState& state, double fabric::AnisotropyEstimate::*of) {
  return state.packing.fabric ? std::optional(state.packing.fabric->by_moment.*of) : std::nullopt;
}

const network::Response::Report& report(const CompressedState& state) {
  return state.packing.network->response.report();
}

std::string shown(const std::optional<Measured>& exponent) {
  return exponent ? detail::formatted("%6.3f +- %.3f", exponent->value, exponent->standard_error)
                  : "       -       ";
}

} // namespace

io::Columns<CompressedState> state_columns() {
  using State = CompressedState;
  const auto network = [](double (*of)(const State&)) {
    return [of](const State& s) { return s.packing.network ? std::optional(of(s)) : std::nullopt; };
  };
  const auto probed = [](double Probes::*of) {
    return [of](const State& s) { return s.probes ? std::optional((*s.probes).*of) : std::nullopt; };
  };
  constexpr double kPa = 1e3, MPa = 1e6;
  return {
      {"p_Pa", "pressure_Pa", [](const State& s) { return s.pressure; },
       io::ShownColumn{"p [kPa]", 9, 4, false, kPa, "", true}},
      {"p_contacts_Pa", "pressure_by_contacts_Pa",
       [](const State& s) {
         return s.packing.stress ? std::optional(s.packing.stress->mean()) : std::nullopt;
       }},
      {"p_work_Pa", "pressure_by_work_Pa", [](const State& s) { return s.packing.pressure_by_work; }},
      {"e", "void_ratio", [](const State& s) { return s.packing.void_ratio; },
       io::ShownColumn{"e", 8, 4, true}},
      {"C_n", "coordination_number", [](const State& s) { return s.packing.counts.coordination_number; },
       io::ShownColumn{"C_n", 7, 3, true, 1, "", true}},
      {"z_star", "mechanical_coordination_number",
       [](const State& s) { return s.packing.counts.mechanical.coordination_number; },
       io::ShownColumn{"z*", 7, 3, true, 1, "", true}},
      {"rattler_fraction", "rattler_fraction",
       [](const State& s) { return s.packing.counts.mechanical.rattler_fraction; }},
      {"a", "fabric_anisotropy",
       [](const State& s) { return fabric_number(s, &fabric::AnisotropyEstimate::anisotropy); }},
      {"a_error", "fabric_anisotropy_standard_error",
       [](const State& s) { return fabric_number(s, &fabric::AnisotropyEstimate::standard_error); }},
      {"sliding_fraction", "sliding_fraction", [](const State& s) { return s.sliding_fraction; }},
      {"G_closed_Pa", "G_closed_Pa", [](const State& s) { return s.G_closed; },
       io::ShownColumn{"G closed", 11, 4, false, MPa}},
      {"K_closed_Pa", "K_closed_Pa", [](const State& s) { return s.K_closed; }},
      {"G_uniform_strain_Pa", "G_uniform_strain_Pa",
       network([](const State& s) { return s.uniform_strain().shear_modulus(); })},
      {"K_uniform_strain_Pa", "K_uniform_strain_Pa",
       network([](const State& s) { return s.uniform_strain().bulk_modulus(); })},
      {"G_network_Pa", "G_network_Pa", network([](const State& s) { return s.network().shear_modulus(); }),
       io::ShownColumn{"G network", 12, 4, false, MPa}},
      {"", "", network([](const State& s) {
         return s.network().shear_modulus() / s.uniform_strain().shear_modulus();
       }),
       io::ShownColumn{"ratio*", 9, 3, true}},
      {"K_network_Pa", "K_network_Pa", network([](const State& s) { return s.network().bulk_modulus(); })},
      {"G_hh_network_Pa", "G_hh_network_Pa", network(G_hh_network)},
      {"G_vh_network_Pa", "G_vh_network_Pa", network(G_vh_network)},
      {"K_lower_Pa", "K_lower_Pa",
       network([](const State& s) { return s.packing.network->bulk_bounds.lower; })},
      {"K_upper_Pa", "K_upper_Pa",
       network([](const State& s) { return s.packing.network->bulk_bounds.upper; })},
      {"G_hh_probe_Pa", "probes/G_hh_Pa", probed(&Probes::G_hh),
       io::ShownColumn{"G_hh probe", 13, 4, false, MPa}},
      {"G_hv_probe_Pa", "probes/G_hv_Pa", probed(&Probes::G_hv),
       io::ShownColumn{"G_hv probe", 12, 4, false, MPa}},
      {"G_vh_probe_Pa", "probes/G_vh_Pa", probed(&Probes::G_vh),
       io::ShownColumn{"  G_vh probe [MPa]", 12, 4, false, MPa}},
      {"probe_strain", "probes/shear_strain", probed(&Probes::amplitude)},
      {"steps", "steps", [](const State& s) { return static_cast<double>(s.steps); }, io::ColumnKind::count},
      {"unbalanced_force_ratio", "unbalanced_force_ratio",
       [](const State& s) { return s.unbalanced_force_ratio; }},
      {"inertial_number", "largest_inertial_number",
       [](const State& s) { return s.largest_inertial_number; }},
      {"network_iterations", "network_iterations",
       network([](const State& s) { return static_cast<double>(report(s).iterations); }),
       io::ColumnKind::count},
      {"network_residual", "network_residual", network([](const State& s) { return report(s).residual; })},
  };
}

std::string states_csv(const Scene& scene, const std::vector<SpecimenResult>& specimens) {
  const io::Columns<CompressedState> columns = state_columns();
  io::CsvContent csv;
  csv.notes = {{"program", "granum " + words(version()) + " verify"},
               {"grains", std::to_string(scene.study.grains)},
               {"signs", "compression positive; z is the vertical axis v"}};
  csv.headings = {"contact", "density", "seed"};
  io::add_headings(csv, columns);
  for (const SpecimenResult& specimen : specimens)
    for (const CompressedState& state : specimen.states) {
      std::vector<io::CsvCell> row{words(name(specimen.contact)), words(name(specimen.density)),
                                   static_cast<double>(specimen.seed)};
      io::add_cells(row, columns, state);
      csv.rows.push_back(std::move(row));
    }
  return io::csv_text(csv);
}

std::string exponents_csv(const std::vector<ExponentRow>& rows) {
  io::Columns<ExponentRow> columns = {
      {"contact", [](const ExponentRow& row) { return words(name(row.contact)); }},
      {"density", [](const ExponentRow& row) { return words(name(row.density)); }},
      {"contact_law", "", [](const ExponentRow& row) { return row.contact_law; }}};
  const auto add = [&](const std::string& heading, std::optional<Measured> ExponentRow::*route) {
    for (const auto& [suffix, part] :
         {std::pair{"", &Measured::value}, {"_error", &Measured::standard_error}})
      columns.emplace_back(heading + suffix, "", [route, part = part](const ExponentRow& row) {
        return row.*route ? std::optional((*(row.*route)).*part) : std::nullopt;
      });
  };
  add("closed_form", &ExponentRow::closed_form);
  add("network", &ExponentRow::network);
  add("network_with_f_e", &ExponentRow::network_void);
  add("probe", &ExponentRow::probe);
  columns.emplace_back("paper", "", [](const ExponentRow& row) { return row.paper; });
  return io::csv_text(columns, rows,
                      {{"program", "granum " + words(version()) + " verify"},
                       {"meaning", "s of G ~ p^s by Levenberg-Marquardt on G; paper: Table 5, G_hv"}});
}

std::string states_table(const std::vector<SpecimenResult>& specimens) {
  const io::Columns<CompressedState> columns = state_columns();
  std::string out;
  for (const SpecimenResult& specimen : specimens) {
    out += detail::formatted("\n%s, %s, seed %llu\n", words(name(specimen.contact)).c_str(),
                             words(name(specimen.density)).c_str(),
                             static_cast<unsigned long long>(specimen.seed));
    out += io::heading_line(columns) + "\n";
    for (const CompressedState& state : specimen.states)
      out += io::number_line(columns, state) + "\n";
    for (const std::string& why : specimen.left_out)
      out += "  left out: at " + why + "\n";
    if (!specimen.failure.empty())
      out += "  ended early: " + specimen.failure + "\n";
  }
  return out + "\n  * G network / G of the same network under uniform strain\n";
}

std::string exponents_table(const std::vector<ExponentRow>& rows) {
  std::string out = "s of G ~ p^s\n  contact    density  1/(1+alpha)   closed form       network           "
                    "with f(e)         probe             paper\n";
  for (const ExponentRow& row : rows)
    out += detail::formatted("  %-9s  %-7s  %9.3f   %s   %s   %s   %s   %s\n",
                             words(name(row.contact)).c_str(), words(name(row.density)).c_str(),
                             row.contact_law, shown(row.closed_form).c_str(), shown(row.network).c_str(),
                             shown(row.network_void).c_str(), shown(row.probe).c_str(),
                             row.paper ? detail::formatted("%5.3f", *row.paper).c_str() : "    -");
  return out;
}

std::string verdicts_table(const std::vector<Verdict>& verdicts) {
  std::string out;
  for (const Verdict& verdict : verdicts)
    out += std::string(verdict.holds     ? "  holds   "
                       : verdict.finding ? "  differs "
                                         : "  FAILS   ") +
           verdict.claim + ": " + verdict.measured + "\n";
  return out;
}

} // namespace granum::studies
