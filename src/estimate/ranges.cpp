// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/estimate/input_values.hpp>

#include "parts.hpp"

namespace granum::estimate {

namespace {

double squared(double x) { return x * x; }

} // namespace

Effect effect_of(std::string input, bool assumed, const Values& middle, const Values& a, const Values& b) {
  Effect effect{.input = std::move(input), .assumed = assumed};
  for (std::size_t k = 0; k < field_count; ++k) {
    effect.low[k] = std::min({middle[k], a[k], b[k]});
    effect.high[k] = std::max({middle[k], a[k], b[k]});
  }
  return effect;
}

Range range_of(const FieldRow& row, const Values& middle, std::span<const Effect> effects,
               std::string_view without) {
  const auto k = static_cast<std::size_t>(row.field);
  const double value = middle[k];
  const bool logarithmic = row.spreading == Spreading::logarithmic && value > 0;
  double down = 0, up = 0, least = std::min(row.least, value), most = std::max(row.most, value);
  for (const Effect& effect : effects) {
    if (!without.empty() && effect.input == without)
      continue;
    least = std::min(least, effect.low[k]);
    most = std::max(most, effect.high[k]);
    // On a logarithmic scale, a stiffness of 0 is infinitely far away: the range begins at 0.
    down +=
        squared(logarithmic ? std::log(value / std::max(effect.low[k], row.least)) : value - effect.low[k]);
    up += squared(logarithmic ? std::log(effect.high[k] / value) : effect.high[k] - value);
  }
  down = std::sqrt(down);
  up = std::sqrt(up);
  const double low = logarithmic ? value * std::exp(-down) : value - down;
  const double high = logarithmic ? value * std::exp(up) : value + up;
  return {.value = value, .low = std::max(low, least), .high = std::min(high, most)};
}

std::vector<Share> shares_of(Field field, std::span<const Effect> effects) {
  const auto k = static_cast<std::size_t>(field);
  std::vector<Share> shares;
  double sum = 0;
  for (const Effect& effect : effects) {
    const double width = squared(effect.high[k] - effect.low[k]);
    sum += width;
    const auto same = std::find_if(shares.begin(), shares.end(),
                                   [&](const Share& share) { return share.input == effect.input; });
    if (same != shares.end())
      same->share += width;
    else
      shares.push_back({effect.input, width});
  }
  if (!(sum > 0) || !std::isfinite(sum))
    return {};
  for (Share& share : shares)
    share.share /= sum;
  std::erase_if(shares, [](const Share& share) { return share.share == 0; });
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& a, const Share& b) { return a.share > b.share; });
  return shares;
}

std::span<const InputRow* const> uncertain_rows() {
  static const std::vector<const InputRow*> rows = [] {
    std::vector<const InputRow*> all;
    for (const bool of_law : {true, false})
      for (const InputRow& row : inputs())
        if ((row.law != nullptr) == of_law && row.kind == Kind::number && row.uncertain)
          all.push_back(&row);
    return all;
  }();
  return rows;
}

bool in_use(const InputValues& values, const InputRow& row) {
  const bool given = values.given(row.input);
  if (row.law != nullptr)
    return given || row.law->shape == values.contact;
  switch (row.input) {
  case Input::k0:
    return given && values[Input::stress_h].source == Source::implied; // else it changes nothing
  case Input::radius:
    return given || !(values.given(Input::d50) || (values.sizes && values.sizes->mean_radius()));
  case Input::grain_density:
    return given || !values.without_density;
  case Input::grain_poisson_ratio:
    return given || !values.given(Input::grain_bulk_modulus);
  default:
    return given || row.by_default.has_value();
  }
}

std::string key_of(const InputRow& row) { return row.option().substr(2); }

const InputRow& uncertain_row(std::string_view key) {
  for (const InputRow* const row : uncertain_rows())
    if (key_of(*row) == key || row->key == key || row->name() == key)
      return *row;
  throw InvalidArgument(std::string(key) + " is not an uncertain input");
}

namespace {

std::string listed(std::span<const InputRow* const> rows) {
  std::string text;
  for (const InputRow* const row : rows)
    text += (text.empty() ? "" : ", ") + key_of(*row);
  return text;
}

double deviation_of(const InputRow& row, const std::string& text, const InputValues& values) {
  const std::string name = "--uncertainty " + key_of(row);
  if (!trimmed(text).ends_with('%'))
    return require_non_negative(name, parse_quantity(name, text, row.dimension),
                                std::string(si_symbol(row.dimension)));
  const double share = require_non_negative(name, parse_quantity(name, text, Dimension::dimensionless)),
               number = values.number(row.input);
  if (number == 0)
    throw InvalidArgument(name + "=" + text + ": a percentage of " + values.name(row.input) +
                          " = 0 is 0; give an absolute deviation");
  return share * std::abs(number);
}

} // namespace

Deviations deviations_of(std::span<const std::string> texts, const InputValues& values,
                         std::span<const InputRow* const> rows, std::string_view other) {
  Deviations stated;
  for (const std::string& text : texts) {
    const std::size_t split = text.find('=');
    if (split == std::string::npos)
      throw InvalidArgument("--uncertainty " + text + ": write key=sd, as in void-ratio=0.02");
    const std::string key(trimmed(std::string_view(text).substr(0, split)));
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const InputRow* const one) { return key_of(*one) == key; });
    if (row == rows.end())
      throw InvalidArgument("--uncertainty " + key + ": " + std::string(other) + " " + listed(rows));
    if (stated.contains((*row)->input))
      throw InvalidArgument("--uncertainty " + key + " is given twice");
    stated[(*row)->input] = deviation_of(**row, text.substr(split + 1), values);
  }
  return stated;
}

Deviations deviations_of(std::span<const std::string> texts, const InputValues& values) {
  std::vector<const InputRow*> used;
  for (const InputRow* const row : uncertain_rows())
    if (in_use(values, *row))
      used.push_back(row);
  return deviations_of(texts, values, used, "not an input of this packing; its inputs are");
}

namespace {

double assumed_deviation(const InputValues& values, const InputRow& row) {
  const InputValue& value = values[row.input];
  if (value.given())
    return value.deviation;
  return row.deviation != nullptr && in_use(values, row) ? row.deviation(values) : 0;
}

/// With the values that follow from the moved one.
InputValues moved(InputValues values, Input input, double change) {
  values.set(input, values.number(input) + change);
  if (values.given(Input::relative_density) &&
      (input == Input::relative_density || input == Input::least_void_ratio ||
       input == Input::largest_void_ratio)) { // it may lead beyond what sands have
    const auto [least, largest] = void_ratio_limits(values);
    values.imply(Input::void_ratio, largest - values.number(Input::relative_density) * (largest - least));
  }
  if (values.given(Input::k0))
    values.imply(Input::stress_h, values.number(Input::k0) * values.number(Input::stress_v));
  return values;
}

} // namespace

std::vector<UncertainInput> uncertain_inputs(const InputValues& values, const Deviations& stated) {
  std::vector<UncertainInput> all;
  for (const InputRow* const row : uncertain_rows()) {
    const auto found = stated.find(row->input);
    const bool assumed = found == stated.end();
    const double deviation = assumed ? assumed_deviation(values, *row) : found->second;
    if (deviation > 0)
      all.push_back({.input = values.by_keywords ? row->key : key_of(*row),
                     .deviation = deviation,
                     .assumed = assumed,
                     .moved = [values, input = row->input](double change) {
                       return question_of(moved(values, input, change));
                     }});
  }
  return all;
}

std::vector<UncertainInput> uncertain_inputs(const InputValues& values, std::span<const std::string> texts) {
  return uncertain_inputs(values, deviations_of(texts, values));
}

} // namespace granum::estimate
