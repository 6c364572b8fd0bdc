// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/trade/trade_findings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::studies {

namespace {

using triaxial::Density;

std::optional<double> log_modulus(const TradeSample& sample) {
  if (sample.shear_modulus.empty())
    return std::nullopt;
  double sum = 0;
  for (const double modulus : sample.shear_modulus)
    sum += std::log(modulus);
  return sum / static_cast<double>(sample.shear_modulus.size());
}

std::optional<double> exponent(const TradeSample& sample) { return sample.exponent; }

std::optional<double> log_peak(const TradeSample& sample) {
  return sample.peak_ratio ? std::optional(std::log(*sample.peak_ratio)) : std::nullopt;
}

/// A quantity that is compared: its value in a sample, and its deviation in a row, which is in parts of the
/// reference where the value is a logarithm.
struct Figure {
  std::optional<double> (*of)(const TradeSample&);
  std::optional<Deviation> TradeRow::*deviation;
  bool logarithmic;
};
constexpr Figure figures[] = {{log_modulus, &TradeRow::shear_modulus, true},
                              {exponent, &TradeRow::exponent, false},
                              {log_peak, &TradeRow::peak_ratio, true}};

bool paired(Varied varied) { return varied != Varied::grains && varied != Varied::boundary; }

/// A row with its samples.
struct Group {
  TradeRow row;
  std::vector<const TradeSample*> samples;
};

std::vector<Group> groups_of(const std::vector<TradeSample>& samples) {
  std::vector<Group> groups;
  for (const TradeSample& s : samples) {
    auto group = std::ranges::find_if(groups, [&s](const Group& other) {
      return other.row.varied == s.varied && other.row.boundary == s.boundary && other.row.value == s.value &&
             other.row.density == s.density;
    });
    if (group == groups.end()) {
      group = groups.insert(group, Group{});
      group->row.varied = s.varied;
      group->row.boundary = s.boundary;
      group->row.value = s.value;
      group->row.density = s.density;
    }
    group->samples.push_back(&s);
  }
  return groups;
}

/// Larger is finer.
double fineness(const TradeRow& row) {
  if (row.varied == Varied::boundary && row.boundary != Boundary::periodic)
    return -1;
  return paired(row.varied) ? -row.value : row.value;
}

const Group& reference_of(const Group& group, const std::vector<Group>& groups) {
  const Group* finest = &group;
  for (const Group& other : groups)
    if (other.row.varied == group.row.varied && other.row.density == group.row.density &&
        fineness(other.row) > fineness(finest->row))
      finest = &other;
  return *finest;
}

struct ValueSpread {
  double mean = 0;
  double deviation = 0; ///< standard deviation
  double count = 0;
};

ValueSpread spread_of(const std::vector<double>& values) {
  ValueSpread out;
  out.count = static_cast<double>(values.size());
  for (const double value : values)
    out.mean += value / out.count;
  for (const double value : values)
    out.deviation += (value - out.mean) * (value - out.mean) / (out.count - 1);
  out.deviation = std::sqrt(out.deviation);
  return out;
}

ValueSpread spread_of(const Group& group, const Figure& figure) {
  std::vector<double> values;
  for (const TradeSample* sample : group.samples)
    if (const std::optional<double> value = figure.of(*sample))
      values.push_back(*value);
  return spread_of(values);
}

/// Variance times N that all sizes of one varied quantity, boundary and density agree on.
double pooled_variance(const Group& like, const std::vector<Group>& groups, const Figure& figure) {
  double sum = 0, freedom = 0;
  for (const Group& group : groups) {
    const ValueSpread spread = spread_of(group, figure);
    if (group.row.varied != like.row.varied || group.row.boundary != like.row.boundary ||
        group.row.density != like.row.density || spread.count < 2)
      continue;
    sum += (spread.count - 1) * spread.deviation * spread.deviation * group.row.value;
    freedom += spread.count - 1;
  }
  return freedom > 0 ? sum / freedom : 0;
}

std::optional<Deviation> difference_of_means(const Group& group, const Group& reference,
                                             const std::vector<Group>& groups, const Figure& figure) {
  const ValueSpread a = spread_of(group, figure), b = spread_of(reference, figure);
  if (a.count < 2 || b.count < 2)
    return std::nullopt;
  const double own = pooled_variance(group, groups, figure) / group.row.value / a.count;
  const double other = pooled_variance(reference, groups, figure) / reference.row.value / b.count;
  return &group == &reference ? Deviation{0, std::sqrt(own), a.deviation}
                              : Deviation{a.mean - b.mean, std::sqrt(own + other), a.deviation};
}

std::optional<Deviation> mean_of_differences(const Group& group, const Group& reference,
                                             const Figure& figure) {
  std::vector<double> differences;
  for (const TradeSample* sample : group.samples)
    for (const TradeSample* finest : reference.samples)
      if (const auto value = figure.of(*sample), other = figure.of(*finest);
          sample->seed == finest->seed && value && other)
        differences.push_back(*value - *other);
  if (differences.size() < 2)
    return std::nullopt;
  const ValueSpread spread = spread_of(differences);
  return Deviation{spread.mean, spread.deviation / std::sqrt(spread.count), spread.deviation};
}

TradeRow row_of(const Group& group, const std::vector<Group>& groups) {
  const Group& reference = reference_of(group, groups);
  TradeRow row = group.row;
  row.reference = &group == &reference;
  for (const Figure& figure : figures) {
    std::optional<Deviation>& deviation = row.*figure.deviation;
    deviation = paired(row.varied) ? mean_of_differences(group, reference, figure)
                                   : difference_of_means(group, reference, groups, figure);
    if (deviation && figure.logarithmic)
      deviation->bias = std::expm1(deviation->bias);
  }
  for (const TradeSample* sample : group.samples)
    if (sample->failure.empty()) {
      ++row.specimens;
      row.cpu_seconds += sample->cpu_seconds;
      row.steps += static_cast<double>(sample->steps);
    }
  if (row.specimens > 0) {
    row.cpu_seconds /= static_cast<double>(row.specimens);
    row.steps /= static_cast<double>(row.specimens);
  }
  return row;
}

} // namespace

std::vector<TradeRow> trade_rows(const std::vector<TradeSample>& samples) {
  const std::vector<Group> groups = groups_of(samples);
  std::vector<TradeRow> rows;
  for (const Group& group : groups)
    rows.push_back(row_of(group, groups));
  return rows;
}

double error_of(const TradeRow& row) {
  const Deviation& d = *row.shear_modulus;
  return paired(row.varied) ? std::abs(d.bias) : std::hypot(d.bias, d.scatter);
}

std::string failures_text(const std::vector<TradeSample>& samples) {
  const auto failed = [](const TradeSample& sample) { return !sample.failure.empty(); };
  const auto first = std::find_if(samples.begin(), samples.end(), failed);
  if (first == samples.end())
    return {};
  const std::string where =
      first->varied == Varied::boundary ? ", " + std::string(name(first->boundary)) : std::string();
  return std::to_string(std::count_if(first, samples.end(), failed)) + " of " +
         std::to_string(samples.size()) + " samples failed and are left out; the first, " +
         std::string(name(first->varied)) + " " + short_text(first->value) + where + ", " +
         std::string(name(first->density)) + ", seed " + std::to_string(first->seed) + ": " + first->failure;
}

// ---- power laws

namespace {

using Column = std::optional<Deviation> TradeRow::*;

std::vector<TradeRow> select(const std::vector<TradeRow>& rows, Varied varied, Density density) {
  std::vector<TradeRow> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), [&](const TradeRow& row) {
    return row.varied == varied && row.boundary == Boundary::periodic && row.density == density;
  });
  return chosen;
}

/// Bias against x(value), zero at the reference, weighted by the standard errors.
template <class X>
RateLaw slope_of(const std::vector<TradeRow>& rows, Column figure, const X& x) {
  const auto reference =
      std::find_if(rows.begin(), rows.end(), [](const TradeRow& row) { return row.reference; });
  if (reference == rows.end())
    return {};
  double xx = 0, xy = 0;
  for (const TradeRow& row : rows) {
    const std::optional<Deviation>& d = row.*figure;
    if (row.reference || !d || !(d->standard_error > 0))
      continue;
    const double distance = x(row.value) - x(reference->value);
    const double weight = 1 / (d->standard_error * d->standard_error);
    xx += weight * distance * distance;
    xy += weight * distance * d->bias;
  }
  return xx > 0 ? RateLaw{xy / xx, 1 / std::sqrt(xx)} : RateLaw{};
}

double scatter_of(const std::vector<TradeRow>& rows, Column figure) {
  double sum = 0, freedom = 0;
  for (const TradeRow& row : rows)
    if (const std::optional<Deviation>& d = row.*figure) {
      const double degrees = static_cast<double>(row.specimens) - 1;
      sum += degrees * d->scatter * d->scatter * row.value;
      freedom += degrees;
    }
  return freedom > 0 ? std::sqrt(sum / freedom) : 0;
}

ErrorLaw law_of(const std::vector<TradeRow>& rows, Density density, Column figure, Varied rate_kind) {
  const std::vector<TradeRow> sizes = select(rows, Varied::grains, density);
  const std::vector<TradeRow> rates = select(rows, rate_kind, density);
  const RateLaw size = slope_of(sizes, figure, [](double grains) { return 1 / grains; });
  const auto [smallest, largest] = std::minmax_element(
      sizes.begin(), sizes.end(), [](const TradeRow& a, const TradeRow& b) { return a.value < b.value; });
  return {.size = {.scatter = scatter_of(sizes, figure),
                   .bias = size.bias,
                   .bias_error = size.bias_error,
                   .smallest = sizes.empty() ? 0 : smallest->value,
                   .largest = sizes.empty() ? 0 : largest->value},
          .rate = slope_of(rates, figure, [](double inertial_number) { return inertial_number; })};
}

/// Two significant digits, upwards.
std::size_t rounded_up(double value) {
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(value)) - 1));
  return static_cast<std::size_t>(std::ceil(value / unit) * unit);
}

} // namespace

TradeLaws laws_of(const std::vector<TradeRow>& rows) {
  const auto law = [&](Density density, Column figure, Varied rate) {
    return law_of(rows, density, figure, rate);
  };
  return {.dense_modulus = law(Density::dense, &TradeRow::shear_modulus, Varied::compression),
          .dense_exponent = law(Density::dense, &TradeRow::exponent, Varied::compression),
          .loose_modulus = law(Density::loose, &TradeRow::shear_modulus, Varied::compression),
          .loose_exponent = law(Density::loose, &TradeRow::exponent, Varied::compression),
          .dense_peak = law(Density::dense, &TradeRow::peak_ratio, Varied::shear)};
}

const TradeLaws& recorded_laws() {
  static const TradeLaws laws{
      .dense_modulus = {.size = {0.2817, -2.548, 0.7801, 250, 16000}, .rate = {0.007396, 0.001287}},
      .dense_exponent = {.size = {0.06387, -0.2971, 0.1769, 250, 16000}, .rate = {0.0007718, 0.0003914}},
      .loose_modulus = {.size = {1.328, 1.146, 3.679, 250, 16000}, .rate = {2.147, 1.155}},
      .loose_exponent = {.size = {0.544, -6.011, 1.507, 250, 16000}, .rate = {-2.255, 0.5819}},
      .dense_peak = {.size = {1.198, 6.263, 3.319, 250, 16000}, .rate = {9.555, 0.3031}},
  };
  return laws;
}

double scatter_of(const ErrorLaw& law, double grains) { return law.size.scatter / std::sqrt(grains); }
double size_bias_of(const ErrorLaw& law, double grains) { return law.size.bias / grains; }
double rate_bias_of(const ErrorLaw& law, double inertial_number) { return law.rate.bias * inertial_number; }

double expected_error(const ErrorLaw& law, std::size_t grains, std::size_t specimens,
                      double inertial_number) {
  const double count = require_positive("grains", static_cast<double>(grains));
  const double number = require_positive("specimens", static_cast<double>(specimens));
  require_non_negative("inertial_number", inertial_number);
  const double variance = law.size.scatter * law.size.scatter / count / number;
  return std::sqrt(variance + std::pow(size_bias_of(law, count) + rate_bias_of(law, inertial_number), 2));
}

Recipe recipe_for(const ErrorLaw& law, double error, std::size_t specimens) {
  require_positive("error", error);
  const double number = require_positive("specimens", static_cast<double>(specimens));
  constexpr double fastest = 1e-2, share = 1.0 / 3;
  const double rate = std::abs(law.rate.bias);
  const double inertial_number = rate * fastest > share * error ? share * error / rate : fastest;
  // c^2/(n N) + b^2/N^2 = e^2, in which the bias of the rate adds a tenth to e^2 at most.
  const double c = law.size.scatter * law.size.scatter / number, b = law.size.bias;
  const double grains = (c + std::sqrt(c * c + 4 * b * b * error * error)) / (2 * error * error);
  return {.grains = rounded_up(std::max(40.0, grains)), .inertial_number = inertial_number};
}

} // namespace granum::studies
