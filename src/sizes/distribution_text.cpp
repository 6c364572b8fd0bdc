// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sizes/distribution_text.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

namespace granum::sizes {

namespace {

using Numbers = std::span<const double>;

std::optional<double> second(Numbers numbers) {
  return numbers.size() > 1 ? std::optional(numbers[1]) : std::nullopt;
}

/// A form whose parameters are pure numbers.
struct Form {
  std::string_view name;
  std::string_view written; ///< for messages
  std::size_t fewest;
  std::size_t most;
  Distribution (*make)(Numbers numbers);
};

constexpr Form forms[] = {
    {"equal", "equal", 0, 0, [](Numbers) { return Distribution::equal(); }},
    {"bidisperse", "bidisperse:RATIO[:SHARE]", 1, 2,
     [](Numbers n) { return Distribution::bidisperse(n[0], second(n).value_or(0.5)); }},
    {"uniform", "uniform:SMALLEST:LARGEST", 2, 2,
     [](Numbers n) { return Distribution::uniform(n[0], n[1]); }},
    {"lognormal", "lognormal:SIGMA[:SIZE_RATIO]", 1, 2,
     [](Numbers n) { return Distribution::lognormal(n[0], second(n)); }},
    {"power-law", "power-law:EXPONENT:SIZE_RATIO", 2, 2,
     [](Numbers n) { return Distribution::power_law(n[0], n[1]); }},
    {"uniformity", "uniformity:C_U[:SIZE_RATIO]", 1, 2,
     [](Numbers n) { return Distribution::uniformity(n[0], second(n)); }},
};
constexpr std::string_view sieve_form = "sieve:D=PASSING:D=PASSING...";

[[noreturn]] void refuse(std::string_view text) {
  throw InvalidArgument("sizes '" + std::string(text) + "' are not one of " + distribution_forms());
}

/// The parts between the colons.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t colon = text.find(':');
    parts.push_back(trimmed(text.substr(0, colon)));
    if (colon == std::string_view::npos)
      return parts;
    text.remove_prefix(colon + 1);
  }
}

Distribution parse_sieve(std::string_view text, std::span<const std::string_view> points) {
  std::vector<SievePoint> curve;
  for (const std::string_view point : points) {
    const std::size_t equals = point.find('=');
    if (equals == std::string_view::npos)
      refuse(text);
    curve.push_back(
        {.diameter = parse_quantity("sieve d", trimmed(point.substr(0, equals)), Dimension::length),
         .passing =
             parse_quantity("sieve passing", trimmed(point.substr(equals + 1)), Dimension::dimensionless)});
  }
  return Distribution::sieve(curve);
}

} // namespace

Distribution parse_distribution(std::string_view text) {
  const std::vector<std::string_view> parts = split(text);
  const std::span<const std::string_view> parameters(parts.begin() + 1, parts.end());
  if (parts.front() == "sieve")
    return parse_sieve(text, parameters);
  const auto* const form = std::find_if(std::begin(forms), std::end(forms),
                                        [&](const Form& f) { return f.name == parts.front(); });
  if (form == std::end(forms) || parameters.size() < form->fewest || parameters.size() > form->most)
    refuse(text);
  std::vector<double> numbers;
  for (const std::string_view parameter : parameters) {
    const std::optional<double> number = parse_number(parameter);
    if (!number)
      refuse(text);
    numbers.push_back(*number);
  }
  return form->make(numbers);
}

std::string distribution_forms() {
  std::string all;
  for (const Form& form : forms)
    all += std::string(form.written) + ", ";
  return all + std::string(sieve_form);
}

} // namespace granum::sizes
