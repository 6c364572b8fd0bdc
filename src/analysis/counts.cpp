// SPDX-License-Identifier: GPL-3.0-or-later
#include "counts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace granum::analysis {

Sizes sizes_of(const packing::Assembly& assembly) {
  const std::vector<double>& radii = assembly.radius;
  const auto [smallest, largest] = std::minmax_element(radii.begin(), radii.end());
  double squares = 0, cubes = 0;
  for (const double radius : radii) {
    const double relative = radius / *largest;
    squares += relative * relative;
    cubes += relative * relative * relative;
  }
  Sizes out{.smallest = *smallest,
            .largest = *largest,
            .equivalent = *smallest == *largest ? *largest : *largest * (cubes / squares),
            .gradation = sizes::gradation(radii)};
  std::vector<sizes::TouchingPair> pairs;
  pairs.reserve(assembly.contacts.size());
  for (const packing::Contact& c : assembly.contacts)
    pairs.push_back({radii[c.i], radii[c.j]});
  if (!pairs.empty())
    out.contacts = sizes::counted_contact_means(radii, pairs, out.equivalent);
  return out;
}

namespace {

/// Standard error of the mean of numbers; 0 for one.
double error_of_mean(const std::vector<double>& values) {
  const double count = static_cast<double>(values.size());
  if (values.size() < 2)
    return 0;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values)
    squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (count - 1) / count);
}

} // namespace

Counts counts_of(const packing::Assembly& assembly, std::size_t grains) {
  std::vector<double> contacts_of(assembly.grain_count());
  for (const packing::Contact& c : assembly.contacts) {
    contacts_of[c.i] += 1;
    contacts_of[c.j] += 1;
  }
  Counts out{.grains = grains,
             .bodies = assembly.grain_count(),
             .contacts = assembly.contacts.size(),
             .wall_contacts = assembly.wall_contacts.size(),
             .coordination_number = coordination_number(assembly),
             .coordination_error = error_of_mean(contacts_of),
             .sliding_fraction = sliding_fraction(assembly),
             .mechanical = mechanical_coordination(assembly, packing::ContactKind::frictional)};
  out.without_contact = static_cast<std::size_t>(std::count(contacts_of.begin(), contacts_of.end(), 0.0));
  const double bodies = static_cast<double>(out.bodies);
  const double touching = bodies - static_cast<double>(out.without_contact);
  if (touching > 0)
    out.touching_coordination_number = out.coordination_number * (bodies / touching);
  out.coordination_number_with_walls =
      out.coordination_number + static_cast<double>(out.wall_contacts) / bodies;
  return out;
}

} // namespace granum::analysis
