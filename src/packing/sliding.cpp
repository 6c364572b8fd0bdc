// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/sliding.hpp>

#include <algorithm>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/packing/force_distribution.hpp>

namespace granum::packing {

namespace {

/// f_t/f_n of the contacts that press, ascending.
std::vector<double> force_ratios(const Assembly& assembly) {
  require_valid(assembly);
  constexpr double hardly = 1e-3;
  const double mean = force_distribution(normal_forces(assembly), 1).mean;
  std::vector<double> ratios;
  for (const Contact& c : assembly.contacts)
    if (c.normal_force > 0 && c.normal_force >= hardly * mean)
      ratios.push_back(norm(c.tangential_force) / c.normal_force);
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

/// How many values of an ascending list lie in [low, high].
double count_within(const std::vector<double>& sorted, double low, double high) {
  const auto begin = std::lower_bound(sorted.begin(), sorted.end(), low);
  return static_cast<double>(std::upper_bound(begin, sorted.end(), high) - begin);
}

} // namespace

std::optional<FrictionEstimate> estimate_friction(const Assembly& assembly) {
  constexpr double window = 1e-4; // relative, below the limit; 0.9 to 0.99 of it gives the usual density
  constexpr double fewest = 5, excess = 10;
  const std::vector<double> ratios = force_ratios(assembly);
  std::optional<FrictionEstimate> found;
  for (std::size_t above = 0; above <= ratios.size() / 1000 && above < ratios.size(); ++above) {
    const double limit = ratios[ratios.size() - 1 - above];
    const double at_limit = count_within(ratios, (1 - window) * limit, limit);
    const double usual = count_within(ratios, 0.9 * limit, 0.99 * limit) * window / 0.09;
    const auto contacts = static_cast<std::size_t>(at_limit);
    if (limit > 0 && at_limit >= fewest && at_limit > excess * usual &&
        (!found || contacts > found->contacts))
      found = FrictionEstimate{limit, contacts};
  }
  return found;
}

double sliding_fraction(const Assembly& assembly, double friction_coefficient) {
  constexpr double tolerance = 1e-3;
  require_non_negative("friction_coefficient", friction_coefficient);
  const std::vector<double> ratios = force_ratios(assembly);
  if (ratios.empty() || friction_coefficient == 0)
    return 0;
  const auto first = std::lower_bound(ratios.begin(), ratios.end(), (1 - tolerance) * friction_coefficient);
  return static_cast<double>(ratios.end() - first) / static_cast<double>(ratios.size());
}

double sliding_fraction(const Assembly& assembly) {
  if (assembly.contacts.empty())
    return 0;
  const auto sliding = std::count_if(assembly.contacts.begin(), assembly.contacts.end(),
                                     [](const Contact& c) { return c.sliding; });
  return static_cast<double>(sliding) / static_cast<double>(assembly.contacts.size());
}

} // namespace granum::packing
