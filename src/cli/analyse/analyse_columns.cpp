// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "analyse_stiffness.hpp"

namespace granum::cli {

namespace {

using FrameColumns = io::Columns<FrameAnswer>;

/// Rung 3 in the list of a frame's rungs.
std::string relaxed_column() { return effective::rung(effective::RungName::relaxed).column; }

/// The number of a part of the measurement; nothing for frames without this part.
template <class Part, class Of>
auto part(std::optional<Part> analysis::Measurement::*member, Of of) {
  return [member, of](const FrameAnswer& f) -> std::optional<double> {
    const std::optional<Part>& value = f.measured.packing.*member;
    if (!value)
      return std::nullopt;
    return of(*value);
  };
}

/// What is counted on the contacts; nothing where they are not known.
template <class Of>
auto counted(Of of) {
  return [of](const FrameAnswer& f) -> std::optional<double> {
    if (!f.measured.contacts_known)
      return std::nullopt;
    return of(f.measured.packing.counts);
  };
}

FrameColumns state_columns() {
  using analysis::Counts;
  using analysis::Fabric;
  using analysis::Forces;
  using analysis::Measurement;
  using io::ShownColumn;
  return {
      {"frame", "", [](const FrameAnswer& f) { return number(f.number); },
       ShownColumn{.heading = "frame", .width = 6, .digits = 10, .ahead = true}},
      {"step", "", [](const FrameAnswer& f) { return static_cast<double>(f.measured.step); },
       ShownColumn{.heading = "step", .width = 11, .digits = 10, .ahead = true}},
      {"time_s", "", [](const FrameAnswer& f) { return f.measured.time; }},
      {"e", "", [](const FrameAnswer& f) { return f.measured.packing.void_ratio; },
       ShownColumn{"e", 9, 4, true}},
      {"C_n", "", counted([](const Counts& c) { return c.coordination_number; }),
       ShownColumn{"C_n", 9, 4, true, 1, "-"}},
      {"z_star", "", counted([](const Counts& c) { return c.mechanical.coordination_number; }),
       ShownColumn{"z*", 9, 4, true, 1, "-"}},
      {"rattler_fraction", "", counted([](const Counts& c) { return c.mechanical.rattler_fraction; })},
      {"grains_without_contact", "", counted([](const Counts& c) { return number(c.without_contact); })},
      {"wall_contacts", "",
       [](const FrameAnswer& f) { return number(f.measured.packing.counts.wall_contacts); }},
      {"a", "", part(&Measurement::fabric, [](const Fabric& x) { return x.by_moment.anisotropy; }),
       ShownColumn{"a", 10, 4, true, 1, "-"}},
      {"a_error", "", part(&Measurement::fabric, [](const Fabric& x) { return x.by_moment.standard_error; })},
      {"sigma_v_Pa", "",
       part(&Measurement::stress, [](const packing::ContactStress& x) { return x.symmetric(2, 2); })},
      {"sigma_h_Pa", "",
       part(&Measurement::stress,
            [](const packing::ContactStress& x) { return (x.symmetric(0, 0) + x.symmetric(1, 1)) / 2; })},
      {"p_Pa", "", part(&Measurement::stress, [](const packing::ContactStress& x) { return x.mean(); }),
       ShownColumn{"p [kPa]", 11, 5, false, 1e3, "-", true}},
      {"p_by_code_Pa", "",
       [](const FrameAnswer& f) -> std::optional<double> {
         if (!f.code_stress)
           return std::nullopt;
         const PrintedStress& s = *f.code_stress;
         return (s[0] + s[1] + s[2]) / 3;
       }},
      {"f_n_mean_N", "", part(&Measurement::forces, [](const Forces& x) { return x.distribution.mean; })},
      {"Z_2", "", part(&Measurement::forces, [](const Forces& x) { return x.Z_2; })},
      {"sliding_fraction", "",
       [](const FrameAnswer& f) {
         const std::optional<Forces>& forces = f.measured.packing.forces;
         return forces ? forces->sliding_fraction : std::nullopt;
       }},
      {"unbalanced_force_ratio", "",
       part(&Measurement::forces,
            [](const Forces& x) -> std::optional<double> {
              if (!x.unbalance)
                return std::nullopt;
              return x.unbalance->force_ratio;
            })},
  };
}

void add_stress_columns(FrameColumns& to) {
  for (std::size_t k = 0; k < std::size(stress_names); ++k)
    to.emplace_back(
        std::string("stress_") + stress_names[k] + "_Pa", "",
        part(&analysis::Measurement::stress, [k](const packing::ContactStress& x) { return printed(x)[k]; }));
}

/// A modulus of the k-th rung of a frame.
auto modulus(std::size_t k, double Moduli::*of) {
  return [k, of](const FrameAnswer& f) -> std::optional<double> {
    if (k >= f.rungs.size() || !f.rungs[k].moduli)
      return std::nullopt;
    return (*f.rungs[k].moduli).*of;
  };
}

void add_rung_columns(FrameColumns& to, const std::vector<RungResult>& rungs) {
  constexpr double MPa = 1e6;
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    const std::string end = "_" + rungs[k].name + "_Pa";
    to.emplace_back("K" + end, "", modulus(k, &Moduli::K));
    to.emplace_back("G" + end, "", modulus(k, &Moduli::G));
    if (rungs[k].name == relaxed_column())
      to.back().shown = io::ShownColumn{"G rung 3 [MPa]", 15, 4, false, MPa, "-"};
    if (rungs[k].name == network_name)
      to.back().shown = io::ShownColumn{"G network", 15, 4, false, MPa, "-"};
    to.emplace_back("G_hh" + end, "", modulus(k, &Moduli::G_hh));
    to.emplace_back("G_vh" + end, "", modulus(k, &Moduli::G_vh));
  }
}

/// What is read off both matrices of the network, "relaxed_E_1_Pa" and so on.
void add_matrix_columns(FrameColumns& to, const FrameAnswer& first) {
  const std::vector<NamedMatrix> matrices = network_matrices(first);
  for (std::size_t k = 0; k < matrices.size(); ++k)
    for (const io::Column<analysis::NetworkMatrix>& column : matrix_columns())
      to.emplace_back(std::string(matrices[k].name) + "_" + column.heading, "",
                      [k, of = column.of](const FrameAnswer& frame) -> std::optional<double> {
                        const std::vector<NamedMatrix> its = network_matrices(frame);
                        return k < its.size() ? of(*its[k].matrix) : std::nullopt;
                      });
}

/// G of the network over that of rung 3.
std::optional<double> network_over_relaxed(const FrameAnswer& frame) {
  const Moduli* network = network_moduli(frame);
  const auto relaxed = std::find_if(frame.rungs.begin(), frame.rungs.end(), [](const RungResult& r) {
    return r.name == relaxed_column() && r.moduli && r.moduli->G > 0;
  });
  if (network == nullptr || relaxed == frame.rungs.end())
    return std::nullopt;
  return network->G / relaxed->moduli->G;
}

} // namespace

io::Columns<FrameAnswer> frame_columns(const AnalyseAnswer& answer) {
  FrameColumns columns = state_columns();
  add_stress_columns(columns);
  add_rung_columns(columns, answer.frames.front().rungs);
  add_matrix_columns(columns, answer.frames.front());
  columns.emplace_back("", "", network_over_relaxed, io::ShownColumn{"ratio", 9, 3, true, 1, "-"});
  return columns;
}

} // namespace granum::cli
