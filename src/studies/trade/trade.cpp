// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/trade/trade.hpp"

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/triaxial/shear_test.hpp>

#include "trade_parts.hpp"

namespace granum::studies {

namespace {

/// The name of the value of an enumeration.
template <std::size_t count, class Value>
std::string_view name_in(const std::array<std::string_view, count>& names, Value value, const char* what) {
  const auto place = static_cast<std::size_t>(value);
  if (place >= count)
    throw InvalidArgument(std::string(what) + " is not one of the known ones");
  return names[place];
}

} // namespace

std::string_view name(Varied varied) {
  static constexpr std::array<std::string_view, 6> names{"grains",    "compression", "shear",
                                                         "time-step", "probe",       "boundary"};
  return name_in(names, varied, "varied quantity");
}

std::string_view name(Boundary boundary) {
  static constexpr std::array<std::string_view, 3> names{"periodic", "smooth-walls", "rough-walls"};
  return name_in(names, boundary, "boundary");
}

TradeScene default_trade() {
  TradeScene trade;
  trade.scene.study.contacts = {contact::Shape::sphere};
  trade.scene.study.pressures = {10e3, 20e3, 50e3, 100e3};
  trade.scene.study.probe_pressures = {};
  trade.scene.study.grains = 500;
  trade.scene.study.seeds = 4;
  trade.compression_inertial_number = triaxial::compression_options().inertial_number;
  trade.shear_inertial_number = triaxial::ShearOptions{}.inertial_number;
  return trade;
}

TradeScene quick_trade() {
  TradeScene trade = default_trade();
  trade.scene.study.grains = 250;
  trade.scene.study.seeds = 2;
  trade.grains = {125, 250, 500};
  trade.compression = {2e-3, 1e-3, 5e-4};
  trade.shear = {2e-3, 5e-4, 2e-4};
  trade.time_step = {1.0, 0.8, 0.4};
  trade.probe = {1e-5, 1e-4, 1e-2};
  trade.walls = {125};
  return trade;
}

TradeScene full_trade() {
  TradeScene trade = default_trade();
  trade.scene.study.grains = 1000;
  trade.scene.study.seeds = 8;
  trade.grains = {250, 500, 1000, 2000, 4000, 8000, 16000};
  trade.compression = {8e-3, 4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4, 1.25e-4};
  trade.shear = {1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5};
  trade.time_step = {1.0, 0.8, 0.4, 0.2};
  trade.probe = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
  trade.walls = {250, 1000, 4000};
  return trade;
}

namespace {

/// The values of a varied quantity: at least one, each once.
template <class Value>
void require_ladder(const std::string& name, const std::vector<Value>& values) {
  if (values.empty())
    throw InvalidArgument(name + ": at least one value is needed");
  for (auto value = values.begin(); value != values.end(); ++value)
    if (std::find(values.begin(), value, *value) != value)
      throw InvalidArgument(name + " is given twice", static_cast<double>(*value), "", "values that differ");
}

} // namespace

void require_valid(const TradeScene& trade) {
  require_valid(trade.scene);
  require_periodic_cell(trade.scene);
  if (trade.scene.study.contacts.size() != 1)
    throw InvalidArgument("study.contacts: trade measures one contact shape at a time");
  require_closed("study.seeds", static_cast<double>(trade.scene.study.seeds), 2, 1000);
  require_open("inertial number of compression", trade.compression_inertial_number, 0, 0.1);
  require_open("inertial number of shear", trade.shear_inertial_number, 0, 0.1);
  require_open("shear_strain", trade.shear_strain, 0, 1);
  require_ladder("grains", trade.grains);
  require_ladder("compression", trade.compression);
  require_ladder("shear", trade.shear);
  require_ladder("time_step", trade.time_step);
  require_ladder("probe", trade.probe);
  const double least = static_cast<double>(triaxial::least_grains(trade.scene.grain.sizes));
  for (const std::vector<std::size_t>* list : {&trade.grains, &trade.walls})
    for (const std::size_t grains : *list)
      require_closed("grains", static_cast<double>(grains), least, 1e6);
  for (const std::vector<double>* list : {&trade.compression, &trade.shear})
    for (const double value : *list)
      require_open("inertial number", value, 0, 0.1);
  for (const double value : trade.time_step)
    require_closed("time_step", require_positive("time_step", value), 0, 1);
  for (const double value : trade.probe)
    require_open("probe", value, 0, 1);
}

TradeScene with_enough_grains(TradeScene trade) {
  const std::size_t least = triaxial::least_grains(trade.scene.grain.sizes);
  for (std::vector<std::size_t>* list : {&trade.grains, &trade.walls}) {
    for (std::size_t& grains : *list)
      grains = std::max(grains, least);
    std::ranges::sort(*list);
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return trade;
}

std::size_t specimens_of(const TradeScene& trade, std::size_t grains) {
  const double all = static_cast<double>(trade.scene.study.seeds * trade.scene.study.grains);
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(all / static_cast<double>(grains))));
}

TradeScene within_budget(TradeScene trade, double seconds, double seconds_per_grain_step) {
  require_positive("budget", seconds, "s");
  require_valid(trade);
  require_positive("seconds_per_grain_step", seconds_per_grain_step, "s");
  const double speed = seconds_per_grain_step / static_cast<double>(thread_count(trade.scene));
  std::ranges::sort(trade.grains);
  const auto predicted = [&] { return trade::predicted_work(trade) * speed; };
  while (predicted() > seconds && trade.grains.size() > 2)
    trade.grains.pop_back();
  if (predicted() > seconds)
    throw InvalidArgument("budget", seconds, "s", "times of at least " + short_text(predicted(), 2) + " s");
  return trade;
}

} // namespace granum::studies
