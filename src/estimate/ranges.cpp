// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

} // namespace granum::estimate
