// SPDX-License-Identifier: GPL-3.0-or-later
// How a packing changes along an axis: a table, and charts.
#include <fmt/core.h>
#include <granum/core/text.hpp>

#include "analyse_fields.hpp"
#include "cli/frame/json_members.hpp"

namespace granum::cli {

namespace {

using analysis::Microstructure;
using analysis::Slice;

/// The width of the slices in mean diameters: fields of narrow ones show single layers of grains.
std::string width_text(const FrameAnswer& frame) {
  const Slice& one = frame.profile.front();
  return fmt::format("{} slices across {}, each {} wide, {} mean diameters", frame.profile.size(),
                     "xyz"[frame.profile_axis], pretty(one.high - one.low, Dimension::length),
                     short_text((one.high - one.low) / (2 * frame.measured.packing.sizes.equivalent), 2));
}

std::optional<double> relaxed_modulus(const Slice& slice) {
  return slice.relaxed ? std::optional(slice.relaxed->stiffness.G_vh()) : std::nullopt;
}

} // namespace

const io::Columns<Slice>& profile_fields() {
  using Of = const Slice&;
  using io::ShownColumn;
  const auto micro = [](double Microstructure::*member) {
    return [member](Of slice) { return slice.part.micro.*member; };
  };
  const auto stress = [](int row, int column) {
    return [row, column](Of slice) { return slice.part.stress(row, column); };
  };
  const auto shown = [](const char* heading, std::size_t width, int digits, double unit = 1) {
    return ShownColumn{.heading = heading, .width = static_cast<int>(width), .digits = digits, .unit = unit};
  };
  static const io::Columns<Slice> fields = {
      {"low_m", "low", &Slice::low, shown("from [mm]", 10, 4, 1e-3)},
      {"high_m", "high", &Slice::high, shown("to [mm]", 9, 4, 1e-3)},
      {"grains", "grains", [](Of slice) { return slice.part.grains; }},
      {"solid_fraction", "solid_fraction", &Slice::solid_fraction, shown("solid", 7, 4)},
      {"C_n", "coordination_number", micro(&Microstructure::coordination_number), shown("C_n", 6, 3)},
      {"z_star", "mechanical_coordination_number", micro(&Microstructure::mechanical_coordination_number),
       shown("z*", 6, 3)},
      {"rattler_fraction", "rattler_fraction", micro(&Microstructure::rattler_fraction)},
      {"a", "anisotropy", micro(&Microstructure::fabric_anisotropy)},
      {"sigma_xx_Pa", "", stress(0, 0), shown("xx [kPa]", 9, 4, 1e3)},
      {"sigma_yy_Pa", "", stress(1, 1), shown("yy [kPa]", 9, 4, 1e3)},
      {"sigma_zz_Pa", "", stress(2, 2), shown("zz [kPa]", 9, 4, 1e3)},
      {"sigma_xy_Pa", "", stress(0, 1)},
      {"sigma_xz_Pa", "", stress(0, 2)},
      {"sigma_yz_Pa", "", stress(1, 2)},
      {"", "stress",
       [](Of slice) {
         const Mat3& s = slice.part.stress;
         return std::vector<double>{s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(0, 2), s(1, 2)};
       }},
      {"G_rung3_Pa", "shear_modulus", relaxed_modulus,
       ShownColumn{.heading = "G [MPa]", .width = 9, .digits = 4, .unit = 1e6, .absent = "-"}}};
  return fields;
}

void add_profile(Document& to, const FrameAnswer& frame) {
  if (frame.profile.empty())
    return;
  Table table = table_of("", "", profile_fields(), frame.profile);
  table.title = "profile: " + width_text(frame);
  table.remark = "solid: solid fraction; stress by contacts; G in a vertical plane by rung 3 of each slice";
  to.add(Seen::always, std::move(table));
}

void add_profile_charts(Document& to, const FrameAnswer& frame) {
  if (frame.profile.empty())
    return;
  const std::string axis(1, "xyz"[frame.profile_axis]);
  const auto chart = [&](const char* title, double unit) {
    return plot::Chart{.x = {.title = title, .unit = unit},
                       .y = {.title = axis + " [mm]", .unit = 1e-3},
                       .width = 230,
                       .height = 300,
                       .legend_below = true};
  };
  const auto add = [&](plot::Chart& chart_, const char* name, const auto& of) {
    plot::Series line{.name = name, .mark = plot::Mark::both, .style = chart_.series.size()};
    for (const Slice& slice : frame.profile)
      if (const std::optional<double> value = of(slice))
        line.add(*value, (slice.low + slice.high) / 2);
    if (!line.x.empty())
      chart_.series.push_back(std::move(line));
  };
  plot::Chart stress = chart("stress [kPa]", 1e3), solid = chart("solid fraction", 1),
              contacts = chart("contacts per grain", 1), modulus = chart("G by rung 3 [MPa]", 1e6);
  for (int k = 0; k < 3; ++k) {
    const char* const names[] = {"xx", "yy", "zz"};
    add(stress, names[k], [k](const Slice& slice) { return std::optional(slice.part.stress(k, k)); });
  }
  add(solid, "", [](const Slice& slice) { return std::optional(slice.solid_fraction); });
  add(contacts, "C_n",
      [](const Slice& slice) { return std::optional(slice.part.micro.coordination_number); });
  add(contacts, "z*",
      [](const Slice& slice) { return std::optional(slice.part.micro.mechanical_coordination_number); });
  add(modulus, "", relaxed_modulus);
  std::vector<plot::Chart> charts{std::move(stress), std::move(solid), std::move(contacts)};
  if (!modulus.series.empty())
    charts.push_back(std::move(modulus));
  to.add(Seen::data, Picture{std::move(charts),
                             "Profile along " + axis + ": " + width_text(frame) + ".",
                             "",
                             {"profile.csv"}});
}

} // namespace granum::cli
