// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/law_check.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/packing/forces.hpp>

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
    stop_point(points.size());
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

/// Least squares; empty for fewer than 3 points or one overlap.
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
  const double median = quantile(ratios, 0.5);
  out.coefficient_ratio = median;
  for (double& ratio : ratios)
    ratio = std::abs(ratio / median - 1);
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

namespace {

/// A contact that is compared, and the types of its grains.
struct TypedPoint {
  std::pair<long, long> types;
  double overlap = 0, force = 0; ///< logarithms, without the means of their group
};

/// Takes the mean of its group from each point.
/// \return   how many groups there are
std::size_t centre(std::vector<TypedPoint>& points) {
  struct Sum {
    double count = 0, overlap = 0, force = 0;
  };
  std::map<std::pair<long, long>, Sum> sums;
  for (const TypedPoint& p : points) {
    Sum& sum = sums[p.types];
    sum.count += 1;
    sum.overlap += p.overlap;
    sum.force += p.force;
  }
  for (TypedPoint& p : points) {
    const Sum& sum = sums[p.types];
    p.overlap -= sum.overlap / sum.count;
    p.force -= sum.force / sum.count;
  }
  return sums.size();
}

/// Slope of force over overlap within the groups.
std::optional<Measured> slope_within(const std::vector<TypedPoint>& points, std::size_t groups) {
  constexpr double no_range = 1e-6;
  const double freedom = static_cast<double>(points.size()) - static_cast<double>(groups) - 1;
  double xx = 0, xy = 0, squares = 0;
  for (const TypedPoint& p : points) {
    xx += p.overlap * p.overlap;
    xy += p.overlap * p.force;
  }
  if (!(freedom > 0) || !(xx > no_range * static_cast<double>(points.size())))
    return std::nullopt;
  const double slope = xy / xx;
  for (const TypedPoint& p : points)
    squares += (p.force - slope * p.overlap) * (p.force - slope * p.overlap);
  return Measured{slope, std::sqrt(squares / freedom / xx)};
}

} // namespace

std::optional<Measured> common_exponent(const packing::Assembly& assembly, std::span<const long> type) {
  constexpr std::size_t fewest = 10;
  constexpr double far = 10; // times the median misfit
  require_valid(assembly);
  if (!type.empty() && type.size() != assembly.grain_count())
    throw InvalidArgument(std::to_string(type.size()) + " types do not go with " +
                          std::to_string(assembly.grain_count()) + " grains");
  std::vector<TypedPoint> points;
  for (const packing::Contact& c : compared(assembly)) {
    const double radius = contact::pair_radius(assembly.radius[c.i], assembly.radius[c.j]);
    const auto types = type.empty() ? std::pair(0L, 0L) : std::minmax({type[c.i], type[c.j]});
    points.push_back({types, std::log(c.overlap / radius), std::log(c.normal_force / radius / radius)});
  }
  if (points.size() < fewest)
    return std::nullopt;
  const auto first = slope_within(points, centre(points));
  if (!first)
    return std::nullopt;
  std::vector<double> misfits;
  for (const TypedPoint& p : points)
    misfits.push_back(std::abs(p.force - first->value * p.overlap));
  const double limit = far * quantile(misfits, 0.5);
  std::erase_if(points,
                [&](const TypedPoint& p) { return std::abs(p.force - first->value * p.overlap) > limit; });
  const std::size_t groups = centre(points);
  const auto second = slope_within(points, groups);
  return second ? second : first;
}

std::optional<contact::GrainMaterial> mean_material_of_forces(const packing::Assembly& assembly,
                                                              double poisson_ratio) {
  constexpr double any_modulus = 1e9; // forces are proportional to it
  require_valid(assembly);
  double sum = 0;
  const std::vector<packing::Contact> contacts = compared(assembly);
  for (const packing::Contact& c : contacts) {
    const double radius = contact::pair_radius(assembly.radius[c.i], assembly.radius[c.j]);
    const auto law = contact::PowerLaw::sphere({any_modulus, poisson_ratio}, radius);
    sum += std::pow(c.normal_force / law.force(c.overlap), 2.0 / 3);
  }
  if (contacts.empty())
    return std::nullopt;
  return contact::GrainMaterial{any_modulus * std::pow(sum / static_cast<double>(contacts.size()), 1.5),
                                poisson_ratio};
}

double rounded_share(const packing::Assembly& assembly, double rounding) {
  std::vector<double> overlaps;
  for (const packing::Contact& c : assembly.contacts)
    if (c.overlap > 0)
      overlaps.push_back(c.overlap);
  return overlaps.empty() ? 0 : rounding / quantile(std::move(overlaps), 0.5);
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
