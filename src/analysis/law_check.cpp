// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/law_check.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <granum/contact/pair.hpp>
#include <granum/core/error.hpp>
#include <granum/packing/force_distribution.hpp>

namespace granum::analysis {

namespace {

/// One contact: ln(d/R), ln(f_n/R^2), and f_n over the force of the law.
struct Point {
  double overlap = 0;
  double force = 0;
  double ratio = 0;
};

/// The contacts that are compared: those that press, and not hardly.
std::vector<packing::Contact> compared(const packing::Assembly& assembly) {
  constexpr double hardly = 1e-3;
  const double mean = packing::force_distribution(normal_forces(assembly), 1).mean;
  std::vector<packing::Contact> contacts = assembly.contacts;
  std::erase_if(contacts, [&](const packing::Contact& c) {
    return !(c.overlap > 0) || !(c.normal_force > 0) || !(c.normal_force >= hardly * mean);
  });
  return contacts;
}

/// \param    material  of a contact
template <class Material>
std::vector<Point> points_of(const packing::Assembly& assembly, const LawFamily& family,
                             const Material& material) {
  std::vector<Point> points;
  for (const packing::Contact& c : compared(assembly)) {
    const double radius = contact::pair_radius(assembly.radius[c.i], assembly.radius[c.j]);
    points.push_back({std::log(c.overlap / radius), std::log(c.normal_force / radius / radius),
                      c.normal_force / family(material(c), radius).force(c.overlap)});
  }
  return points;
}

/// The value below which a share of a list lies, between neighbours in proportion; the list is not empty.
double quantile(std::vector<double> values, double share) {
  const double place = share * static_cast<double>(values.size() - 1);
  const auto at = static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  const double low = values[static_cast<std::size_t>(at)];
  const auto above = values.begin() + at + 1;
  if (above == values.end())
    return low;
  return low + (place - static_cast<double>(at)) * (*std::min_element(above, values.end()) - low);
}

struct Line {
  double slope = 0;
  double offset = 0;
  double slope_error = 0;

  [[nodiscard]] double misfit(const Point& p) const { return std::abs(p.force - offset - slope * p.overlap); }
};

/// Least squares; nothing for fewer than 3 points or one overlap.
std::optional<Line> line_through(const std::vector<Point>& points) {
  const double count = static_cast<double>(points.size());
  if (count < 3)
    return std::nullopt;
  double x = 0, y = 0;
  for (const Point& p : points) {
    x += p.overlap / count;
    y += p.force / count;
  }
  double xx = 0, xy = 0;
  for (const Point& p : points) {
    xx += (p.overlap - x) * (p.overlap - x);
    xy += (p.overlap - x) * (p.force - y);
  }
  constexpr double no_range = 1e-12;
  if (!(xx > no_range * count))
    return std::nullopt;
  Line line{.slope = xy / xx, .offset = y - xy / xx * x};
  double squares = 0;
  for (const Point& p : points)
    squares += line.misfit(p) * line.misfit(p);
  line.slope_error = std::sqrt(squares / (count - 2) / xx);
  return line;
}

/// The line again without the points that lie far off.
std::optional<Line> robust_line(const std::vector<Point>& points) {
  constexpr double far = 10;
  const auto first = line_through(points);
  if (!first)
    return first;
  std::vector<double> misfits;
  for (const Point& p : points)
    misfits.push_back(first->misfit(p));
  const double limit = far * quantile(misfits, 0.5);
  std::vector<Point> near;
  for (const Point& p : points)
    if (first->misfit(p) <= limit)
      near.push_back(p);
  const auto second = line_through(near);
  return second ? second : first;
}

std::optional<Measured> alpha_of(const Measured& slope) {
  const double excess = slope.value - 1;
  if (!(excess > slope.standard_error))
    return std::nullopt;
  return Measured{1 / excess, slope.standard_error / (excess * excess)};
}

void measure_misfit(const std::vector<Point>& points, LawCheck& out) {
  std::vector<double> ratios;
  for (const Point& p : points)
    ratios.push_back(p.ratio);
  out.coefficient_ratio = quantile(ratios, 0.5);
  for (double& ratio : ratios)
    ratio = std::abs(ratio / out.coefficient_ratio - 1);
  out.median_misfit = quantile(ratios, 0.5);
  out.misfit_90 = quantile(ratios, 0.9);
  out.worst_misfit = quantile(ratios, 1);
}

template <class Material>
LawCheck check(const packing::Assembly& assembly, const LawFamily& family, const Material& material) {
  require_valid(assembly);
  const std::vector<Point> points = points_of(assembly, family, material);
  LawCheck out;
  out.contacts = points.size();
  out.left_out = assembly.contacts.size() - points.size();
  if (points.empty())
    return out;
  measure_misfit(points, out);
  if (const auto line = robust_line(points)) {
    out.force_exponent = Measured{line->slope, line->slope_error};
    out.alpha = alpha_of(*out.force_exponent);
  }
  return out;
}

} // namespace

LawCheck check_law(const packing::Assembly& assembly, const LawFamily& family,
                   const contact::GrainMaterial& grain) {
  return check(assembly, family, [&](const packing::Contact&) { return grain; });
}

LawCheck check_law(const packing::Assembly& assembly, const LawFamily& family,
                   std::span<const contact::GrainMaterial> materials) {
  if (materials.size() != assembly.grain_count())
    throw InvalidArgument(std::to_string(materials.size()) + " materials do not go with " +
                          std::to_string(assembly.grain_count()) + " grains");
  return check(assembly, family, [&](const packing::Contact& c) {
    return contact::pair_material(materials[c.i], materials[c.j]);
  });
}

std::optional<double> linear_spring(const packing::Assembly& assembly) {
  constexpr std::size_t fewest = 10;
  constexpr double same = 1e-3, apart = 1.05;
  std::vector<double> springs, overlaps;
  for (const packing::Contact& c : compared(assembly)) {
    springs.push_back(c.normal_force / c.overlap);
    overlaps.push_back(c.overlap);
  }
  if (springs.size() < fewest || quantile(overlaps, 0.9) < apart * quantile(overlaps, 0.1))
    return std::nullopt;
  const double middle = quantile(springs, 0.5);
  for (double& spring : springs)
    spring = std::abs(spring / middle - 1);
  return quantile(springs, 0.9) <= same ? std::optional(middle) : std::nullopt;
}

} // namespace granum::analysis
