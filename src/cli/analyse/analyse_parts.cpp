// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_parts.hpp"

namespace granum::cli {

namespace {

using analysis::Counts;
using analysis::Fabric;
using analysis::Forces;
using io::ColumnKind;
using io::ShownColumn;
using packing::ContactStress;

} // namespace

const io::Columns<Counts>& grain_count_columns() {
  static const io::Columns<Counts> columns = {
      {"", "grains", [](const Counts& c) { return number(c.grains); }, ColumnKind::count},
      {"wall_contacts", "wall_contacts", [](const Counts& c) { return number(c.wall_contacts); },
       ColumnKind::count},
  };
  return columns;
}

const io::Columns<Counts>& contact_count_columns() {
  static const io::Columns<Counts> columns = {
      {"", "contacts", [](const Counts& c) { return number(c.contacts); }, ColumnKind::count},
      {"C_n", "coordination_number", [](const Counts& c) { return c.coordination_number; },
       ShownColumn{"C_n", 9, 4, true, 1, "-"}},
      {"z_star", "mechanical_coordination_number",
       [](const Counts& c) { return c.mechanical.coordination_number; },
       ShownColumn{"z*", 9, 4, true, 1, "-"}},
      {"rattler_fraction", "rattler_fraction", [](const Counts& c) { return c.mechanical.rattler_fraction; }},
      {"grains_without_contact", "grains_without_contact",
       [](const Counts& c) { return number(c.without_contact); }, ColumnKind::count},
      {"", "touching_coordination_number", [](const Counts& c) { return c.touching_coordination_number; }},
      {"", "coordination_number_with_walls",
       [](const Counts& c) { return c.coordination_number_with_walls; }},
      {"", "rattlers", [](const Counts& c) { return number(c.mechanical.rattler_count); }, ColumnKind::count},
  };
  return columns;
}

const io::Columns<Fabric>& fabric_columns() {
  static const io::Columns<Fabric> columns = {
      {"a", "anisotropy", [](const Fabric& f) { return f.by_moment.anisotropy; },
       ShownColumn{"a", 10, 4, true, 1, "-"}},
      {"a_error", "anisotropy_standard_error", [](const Fabric& f) { return f.by_moment.standard_error; }},
      {"", "most_likely_anisotropy",
       [](const Fabric& f) {
         return f.by_likelihood ? std::optional(f.by_likelihood->anisotropy) : std::nullopt;
       }},
      {"", "most_likely_anisotropy_standard_error",
       [](const Fabric& f) {
         return f.by_likelihood ? std::optional(f.by_likelihood->standard_error) : std::nullopt;
       }},
  };
  return columns;
}

const io::Columns<ContactStress>& stress_columns() {
  static const io::Columns<ContactStress> columns = [] {
    io::Columns<ContactStress> list = {
        {"sigma_v_Pa", "", [](const ContactStress& s) { return s.symmetric(2, 2); }},
        {"sigma_h_Pa", "",
         [](const ContactStress& s) { return (s.symmetric(0, 0) + s.symmetric(1, 1)) / 2; }},
        {"p_Pa", "mean", [](const ContactStress& s) { return s.mean(); },
         ShownColumn{"p [kPa]", 11, 5, false, 1e3, "-", true}},
        {"", "asymmetry", [](const ContactStress& s) { return s.asymmetry; }},
    };
    for (std::size_t k = 0; k < std::size(stress_names); ++k)
      list.emplace_back(std::string("stress_") + stress_names[k] + "_Pa",
                        std::string("by_contacts/") + stress_names[k],
                        [k](const ContactStress& s) { return printed(s)[k]; });
    return list;
  }();
  return columns;
}

const io::Columns<Forces>& force_columns() {
  static const io::Columns<Forces> columns = {
      {"", "pressing", [](const Forces& f) { return number(f.distribution.pressing); }, ColumnKind::count},
      {"", "in_tension", [](const Forces& f) { return number(f.distribution.in_tension); },
       ColumnKind::count},
      {"", "unloaded", [](const Forces& f) { return number(f.distribution.unloaded); }, ColumnKind::count},
      {"f_n_mean_N", "mean_normal_force", [](const Forces& f) { return f.distribution.mean; }},
      {"", "largest_normal_force", [](const Forces& f) { return f.distribution.largest; }},
      {"Z_2", "Z_2", [](const Forces& f) { return f.Z_2; }},
      {"", "Z_5_3", [](const Forces& f) { return f.Z_5_3; }},
      {"", "mean_tangential_over_normal", [](const Forces& f) { return f.mean_tangential_over_normal; }},
      {"", "friction_coefficient",
       [](const Forces& f) { return f.friction ? std::optional(f.friction->coefficient) : std::nullopt; }},
      {"sliding_fraction", "sliding_fraction", [](const Forces& f) { return f.sliding_fraction; }},
      {"unbalanced_force_ratio", "unbalanced_force_ratio",
       [](const Forces& f) { return f.unbalance ? std::optional(f.unbalance->force_ratio) : std::nullopt; }},
      {"", "unbalanced_moment_ratio",
       [](const Forces& f) { return f.unbalance ? std::optional(f.unbalance->moment_ratio) : std::nullopt; }},
  };
  return columns;
}

const io::Columns<Moduli>& modulus_columns() {
  const auto one = [](std::string heading, std::string key, double Moduli::*of) {
    return io::Column<Moduli>(std::move(heading), std::move(key), [of](const Moduli& m) { return m.*of; });
  };
  static const io::Columns<Moduli> columns = {
      one("K", "K", &Moduli::K),          one("G", "G", &Moduli::G),    one("G_hh", "G_hh", &Moduli::G_hh),
      one("G_vh", "G_vh", &Moduli::G_vh), one("", "C11", &Moduli::C11), one("", "C33", &Moduli::C33),
      one("", "C12", &Moduli::C12),       one("", "C13", &Moduli::C13),
  };
  return columns;
}

} // namespace granum::cli
