// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/verify/tables.hpp"

namespace granum::studies {

namespace {

std::optional<double> fabric_number(const CompressedState& state, double fabric::AnisotropyEstimate::*of) {
  return state.packing.fabric ? std::optional(state.packing.fabric->by_moment.*of) : std::nullopt;
}

const network::Response::Report& report(const CompressedState& state) {
  return state.packing.network->response.report();
}

} // namespace

io::Columns<CompressedState> state_columns() {
  using State = CompressedState;
  const auto network = [](auto of) {
    return [of](const State& s) { return s.packing.network ? std::optional(of(s)) : std::nullopt; };
  };
  const auto probed = [](double Probes::*of) {
    return [of](const State& s) { return s.probes ? std::optional((*s.probes).*of) : std::nullopt; };
  };
  const auto fixed = [](std::string heading, int digits) {
    return io::ShownColumn{.heading = std::move(heading), .width = 7, .digits = digits, .fixed = true};
  };
  const auto modulus = [](std::string heading, int width = 8) {
    return io::ShownColumn{.heading = std::move(heading), .width = width, .unit = 1e6};
  };
  return {
      {"p_Pa", "pressure_Pa", &State::pressure,
       io::ShownColumn{.heading = "p [kPa]", .width = 8, .unit = 1e3}},
      {"p_contacts_Pa", "pressure_by_contacts_Pa",
       [](const State& s) {
         return s.packing.stress ? std::optional(s.packing.stress->mean()) : std::nullopt;
       }},
      {"p_work_Pa", "pressure_by_work_Pa", [](const State& s) { return s.packing.pressure_by_work; }},
      {"e", "void_ratio", [](const State& s) { return s.packing.void_ratio; }, fixed("e", 4)},
      {"C_n", "coordination_number", [](const State& s) { return s.packing.counts.coordination_number; },
       fixed("C_n", 3)},
      {"z_star", "mechanical_coordination_number",
       [](const State& s) { return s.packing.counts.mechanical.coordination_number; }, fixed("z*", 3)},
      {"rattler_fraction", "rattler_fraction",
       [](const State& s) { return s.packing.counts.mechanical.rattler_fraction; }},
      {"a", "fabric_anisotropy",
       [](const State& s) { return fabric_number(s, &fabric::AnisotropyEstimate::anisotropy); }},
      {"a_error", "fabric_anisotropy_standard_error",
       [](const State& s) { return fabric_number(s, &fabric::AnisotropyEstimate::standard_error); }},
      {"sliding_fraction", "sliding_fraction", &State::sliding_fraction},
      {"G_closed_Pa", "G_closed_Pa", &State::G_closed, modulus("G formula", 10)},
      {"K_closed_Pa", "K_closed_Pa", &State::K_closed},
      {"G_rung3_Pa", "G_rung3_Pa", relaxed_modulus},
      {"G_uniform_strain_Pa", "G_uniform_strain_Pa",
       network([](const State& s) { return s.uniform_strain().shear_modulus(); })},
      {"K_uniform_strain_Pa", "K_uniform_strain_Pa",
       network([](const State& s) { return s.uniform_strain().bulk_modulus(); })},
      {"G_network_Pa", "G_network_Pa", network([](const State& s) { return s.network().shear_modulus(); }),
       modulus("G network", 10)},
      {"", "G_network_over_uniform_strain", network([](const State& s) {
         return s.network().shear_modulus() / s.uniform_strain().shear_modulus();
       }),
       fixed("ratio*", 3)},
      {"K_network_Pa", "K_network_Pa", network([](const State& s) { return s.network().bulk_modulus(); })},
      {"G_hh_network_Pa", "G_hh_network_Pa", network(G_hh_network)},
      {"G_vh_network_Pa", "G_vh_network_Pa", network(G_vh_network)},
      {"K_lower_Pa", "K_lower_Pa",
       network([](const State& s) { return s.packing.network->bulk_bounds.lower; })},
      {"K_upper_Pa", "K_upper_Pa",
       network([](const State& s) { return s.packing.network->bulk_bounds.upper; })},
      {"G_hh_probe_Pa", "probes/G_hh_Pa", probed(&Probes::G_hh), modulus("G_hh")},
      {"G_hv_probe_Pa", "probes/G_hv_Pa", probed(&Probes::G_hv), modulus("G_hv")},
      {"G_vh_probe_Pa", "probes/G_vh_Pa", probed(&Probes::G_vh), modulus("G_vh")},
      {"probe_strain", "probes/shear_strain", probed(&Probes::amplitude)},
      {"steps", "steps", &State::steps},
      {"unbalanced_force_ratio", "unbalanced_force_ratio", &State::unbalanced_force_ratio},
      {"inertial_number", "largest_inertial_number", &State::largest_inertial_number},
      {"network_iterations", "network_iterations",
       network([](const State& s) { return report(s).iterations; })},
      {"network_residual", "network_residual", network([](const State& s) { return report(s).residual; })},
  };
}

io::Columns<ExponentRow> exponent_columns() {
  const auto route = [](std::string heading) {
    return io::ShownColumn{
        .heading = std::move(heading), .width = 13, .digits = 3, .fixed = true, .absent = "-"};
  };
  return {
      {"contact", "contact", [](const ExponentRow& row) { return name(row.contact); },
       io::ShownColumn{.heading = "contact", .width = -9}},
      {"density", "density", [](const ExponentRow& row) { return name(row.density); },
       io::ShownColumn{.heading = "density", .width = -7}},
      {"contact_law", "contact_law", &ExponentRow::contact_law,
       io::ShownColumn{.heading = "law", .width = 6, .digits = 3, .fixed = true}},
      {"closed_form", "closed_form", io::or_null(&ExponentRow::closed_form), route("formula")},
      {"network", "network", io::or_null(&ExponentRow::network), route("network")},
      {"network_with_f_e", "network_with_void_ratio_function", io::or_null(&ExponentRow::network_void),
       route("with f(e)")},
      {"probe", "probe", io::or_null(&ExponentRow::probe), route("probe")},
      {"paper", "paper", io::or_null(&ExponentRow::paper),
       io::ShownColumn{.heading = "paper", .width = 6, .digits = 3, .fixed = true, .absent = "-"}},
  };
}

io::Columns<Verdict> verdict_columns() {
  return {{"claim", "claim", &Verdict::claim},
          {"holds", "", [](const Verdict& verdict) { return verdict.holds ? "yes" : "no"; }},
          {"", "holds", &Verdict::holds},
          {"measured", "measured", &Verdict::measured},
          {"", "finding", &Verdict::finding},
          {"", "decided", &Verdict::decided}};
}

} // namespace granum::studies
