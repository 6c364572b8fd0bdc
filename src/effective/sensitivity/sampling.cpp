// SPDX-License-Identifier: GPL-3.0-or-later
// The draws of an uncertainty: the one source of this library that catches exceptions, kept apart for
// targets that cannot.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/effective/sensitivity/uncertainty.hpp>

namespace granum::effective {

namespace {

/// FNV-1a, the same on every machine.
std::uint64_t hash(std::string_view text, std::uint64_t start) {
  std::uint64_t h = start;
  for (const char c : text)
    h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return h;
}

/// The normally distributed numbers that one uncertain number draws.
class Stream {
 public:
  Stream(std::string_view key, std::uint64_t seed)
      : generator_(hash(key, 0xcbf29ce484222325U) ^ (seed * 0x9e3779b97f4a7c15U)) {}
  double next() { return normal_(generator_); }

 private:
  boost::random::mt19937_64 generator_;
  boost::random::normal_distribution<double> normal_;
};

std::vector<Stream> streams_of(std::span<const UncertainNumber> numbers, std::uint64_t seed) {
  std::set<std::string> keys;
  std::vector<Stream> streams;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::string key = numbers[k].key.empty() ? "number " + std::to_string(k) : numbers[k].key;
    if (!keys.insert(key).second)
      throw InvalidArgument("two uncertain numbers have the key " + key + " and would draw the same");
    streams.emplace_back(key, seed);
  }
  return streams;
}

/// Between the sorted values, linearly.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - std::floor(place));
}

Band band_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  Band band;
  band.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  const double squares = std::accumulate(values.begin(), values.end(), 0.0, [&](double sum, double value) {
    return sum + (value - band.mean) * (value - band.mean);
  });
  band.deviation = std::sqrt(squares / (count - 1));
  band.low = quantile(values, 0.16);
  band.median = quantile(values, 0.5);
  band.high = quantile(values, 0.84);
  return band;
}

} // namespace

Sample sample(std::span<const UncertainNumber> numbers, const Evaluate& evaluate, const Sampling& sampling) {
  for (const UncertainNumber& number : numbers)
    require_non_negative("deviation", number.deviation);
  std::vector<Stream> streams = streams_of(numbers, sampling.seed);
  std::vector<double> drawn(numbers.size());
  std::vector<std::vector<double>> values; // of each result
  Sample result;
  for (std::size_t draw = 0; draw < sampling.draws; ++draw) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
      drawn[k] = numbers[k].value + numbers[k].deviation * streams[k].next();
    try {
      const std::vector<double> results = evaluate(drawn);
      values.resize(results.size());
      for (std::size_t k = 0; k < results.size(); ++k)
        values[k].push_back(results[k]);
    } catch (const InvalidArgument&) {
      ++result.rejected;
    }
  }
  if (sampling.draws < result.rejected + 2)
    throw InvalidArgument(
        "fewer than two draws are packings that can be: the deviations are too large, or the "
        "values too near the end of their range");
  for (std::vector<double>& of_result : values)
    result.bands.push_back(band_of(std::move(of_result)));
  return result;
}

} // namespace granum::effective
