// SPDX-License-Identifier: GPL-3.0-or-later
#include "site.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/core/text.hpp>

namespace granum::cli {

namespace {

using estimate::Field;
using estimate::Range;

/// V_s at a depth, small strain, above 0 in its whole range.
Range shear_speed(const std::vector<Layer>& layers, double depth) {
  InputValues values = values_at(layers, depth);
  values.grain_shape = known_shape(values); // also where a strain implies it
  values.leave_out(Input::shear_strain);
  const Range speed = bare_answer(values).answer[Field::shear_wave_speed];
  if (!(speed.low > 0))
    throw InvalidArgument(fmt::format("V_s may be 0 at {} m", short_text(depth)));
  return speed;
}

/// Where V_s jumps or has a kink, with both ends.
std::vector<double> bounds_of(const std::vector<Layer>& layers, double base) {
  std::vector<double> bounds{0, base};
  const auto add = [&](double depth) {
    if (depth > 0 && depth < base)
      bounds.push_back(depth);
  };
  add(code_depth);
  if (const auto& table = layers.front().ground.ground.water_table)
    add(*table);
  for (const Layer& layer : layers)
    add(layer.top);
  std::ranges::sort(bounds);
  bounds.erase(std::unique(bounds.begin(), bounds.end()), bounds.end());
  return bounds;
}

/// Time of a shear wave between two depths [s]; it is longest where V_s is low.
Range time_between(const std::vector<Layer>& layers, double top, double bottom) {
  constexpr int nodes = 8;
  static const std::vector<QuadratureNode> rule = gauss_legendre(nodes);
  Range time;
  for (const QuadratureNode& node : rule) {
    // V_s grows as a root of the depth below the surface: nodes are dense there.
    const double t = (1 + node.abscissa) / 2, depth = top + (bottom - top) * t * t * t;
    const double weight = node.weight / 2 * (bottom - top) * 3 * t * t;
    const Range speed = shear_speed(layers, depth);
    time.value += weight / speed.value;
    time.low += weight / speed.high;
    time.high += weight / speed.low;
  }
  return time;
}

Range times(double factor, const Range& of) { return {factor * of.value, factor * of.low, factor * of.high}; }

/// "V_s30", "V_s of 20 m".
std::string speed_label(const SiteResponse& site) {
  return site.averaged_to == code_depth ? "V_s30" : fmt::format("V_s to {} m", short_text(site.averaged_to));
}

std::string speed_meaning(const SiteResponse& site) {
  return site.averaged_to == code_depth
             ? "time average of V_s to 30 m"
             : fmt::format("time average of V_s to {} m: no V_s30, the profile is not so deep",
                           short_text(site.averaged_to));
}

} // namespace

SiteResponse site_response(const std::vector<Layer>& layers, double base) {
  SiteResponse site{.base = base, .averaged_to = std::min(base, code_depth)};
  Range to_average;
  const std::vector<double> bounds = bounds_of(layers, base);
  for (std::size_t k = 1; k < bounds.size(); ++k) {
    const Range part = time_between(layers, bounds[k - 1], bounds[k]);
    for (Range* sum : {&site.travel_time, bounds[k] <= site.averaged_to ? &to_average : nullptr})
      if (sum != nullptr) {
        sum->value += part.value;
        sum->low += part.low;
        sum->high += part.high;
      }
  }
  site.speed = {site.averaged_to / to_average.value, site.averaged_to / to_average.high,
                site.averaged_to / to_average.low};
  site.period = times(4, site.travel_time);
  return site;
}

Items site_items(const SiteResponse& site) {
  Items to{.key = "site"};
  io::add_item(to.items, "base", site.base);
  io::add_item(to.items, "averaged_to", site.averaged_to);
  const auto add = [&](const char* key, const std::string& label, Dimension dimension, const Range& range,
                       const std::string& meaning) {
    add_range(to.items, key, range);
    io::ShownColumn look = shown_as(label);
    look.meaning = meaning;
    io::add_item(to.items, "", range_text(dimension, range), std::move(look));
  };
  const std::string base = short_text(site.base);
  add("average_shear_wave_speed", speed_label(site), Dimension::speed, site.speed, speed_meaning(site));
  add("travel_time", "travel time", Dimension::time, site.travel_time,
      fmt::format("of a shear wave from {} m to the surface", base));
  add("period", "period", Dimension::time, site.period,
      fmt::format("4 H/V_s of the ground above {} m", base));
  return to;
}

std::string site_text(const SiteResponse& site) {
  return fmt::format("{} = {}; travel time of a shear wave from {} m {}; period 4 H/V_s = {}",
                     speed_label(site), range_text(Dimension::speed, site.speed), short_text(site.base),
                     range_text(Dimension::time, site.travel_time), range_text(Dimension::time, site.period));
}

} // namespace granum::cli
