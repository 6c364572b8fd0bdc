// SPDX-License-Identifier: GPL-3.0-or-later
// How the coefficients of the contact prior follow from the recorded packings of validation/relaxation.
#pragma once

#include "../common.hpp"
#include "../relaxation/least_squares.hpp"
#include "../relaxation/reading.hpp"
#include "effective/contact_prior_kernel.hpp"

namespace contact_prior {

namespace kernel = granum::effective::kernel;
using relaxation::Dual;
using relaxation::Fit;
using relaxation::Numbers;
using relaxation::Observation;
using relaxation::Packing;

constexpr int size = 10;      ///< of the coefficients of contacts
constexpr int rattlers_n = 3; ///< of those of rattlers

/// Isotropic, never loaded more, overlaps as the half-space allows.
inline bool usable(const Packing& p) {
  return p.isotropic() && p.preparation == relaxation::unsheared(p.preparation) && p.preparation != "cycle" &&
         p.relative_overlap < kernel::largest_overlap;
}
inline bool from_gas(const Packing& p) { return p.preparation.starts_with("gas"); }
/// Without friction, or as loose as its friction allows.
inline bool on_densest_line(const Packing& p) { return from_gas(p) || p.preparation == "dense"; }

template <class T>
T rigid(const Packing& p, const kernel::ContactCoefficients<T>& c) {
  return kernel::rigid_void_ratio<T>(p.state.void_ratio, p.relative_overlap, c);
}

/// z* by void ratio alone, for packings of the densest line.
template <class T>
T by_line(const Packing& p, const kernel::ContactCoefficients<T>& c) {
  return kernel::densest_contacts<T>(rigid(p, c), p.relative_overlap, c);
}
/// z* by friction, of packings from a gas, whatever their void ratio.
template <class T>
T by_friction_alone(const Packing& p, const kernel::ContactCoefficients<T>& c) {
  const T z = kernel::rigid_contacts_of_friction<T>(p.friction_coefficient, c);
  return z + kernel::contacts_of_overlap<T>(z, p.relative_overlap, c);
}
/// z* by friction and void ratio.
template <class T>
T by_friction(const Packing& p, const kernel::ContactCoefficients<T>& c) {
  return kernel::contacts_of_friction<T>(p.friction_coefficient, rigid(p, c), p.relative_overlap, c);
}
/// z* of `later` from that of `first`, the same specimen at another pressure.
template <class T>
T by_carrying(const Packing& first, const Packing& later, const kernel::ContactCoefficients<T>& c) {
  return kernel::carried_contacts<T>(first.mechanical_coordination, rigid(first, c), first.relative_overlap,
                                     later.relative_overlap, c);
}

/// What a recipe tells of its packing: the line, or friction.
template <class T>
T by_recipe(const Packing& p, const kernel::ContactCoefficients<T>& c) {
  return on_densest_line(p) ? by_line(p, c) : by_friction(p, c);
}

struct Step {
  const Packing* first;
  const Packing* later;
};

/// Neighbouring pressures of each specimen.
inline std::vector<Step> steps_of(const std::vector<Packing>& packings) {
  std::map<std::string, std::vector<const Packing*>> specimens;
  for (const Packing& p : packings)
    specimens[p.specimen].push_back(&p);
  std::vector<Step> steps;
  for (auto& [name, path] : specimens) {
    std::ranges::sort(path, {}, &Packing::pressure);
    for (std::size_t k = 1; k < path.size(); ++k)
      steps.push_back({path[k - 1], path[k]});
  }
  return steps;
}

/// All pairs of pressures of each specimen, the smaller one first.
inline std::vector<Step> ways_of(const std::vector<Packing>& packings) {
  std::vector<Step> ways;
  for (const Packing& first : packings)
    for (const Packing& later : packings)
      if (first.specimen == later.specimen && first.pressure < later.pressure)
        ways.push_back({&first, &later});
  return ways;
}

inline double carrying_error(const Step& way, const Numbers<double, size>& c) {
  return by_carrying(*way.first, *way.later, c) - way.later->mechanical_coordination;
}
inline double root_of(const Step& way) {
  return kernel::root_of_way(way.first->relative_overlap, way.later->relative_overlap);
}

/// What contact_prior_coefficients.hpp holds, but for packings above a densest one.
struct Result {
  Fit<size> contacts;
  Fit<rattlers_n> rattlers;
  double line_scatter = 0, friction_scatter = 0, carried_scatter = 0, rattler_scatter = 0;
  std::map<std::string, Numbers<double, size>> without = {}; ///< fits that leave a preparation out
};

/// Carried z* count twice: they are known better, since specimens of one recipe differ.
constexpr double weight_of_steps = 2;
/// Fewer rattlers than this tell more about counting than about the law.
constexpr double countable_rattlers = 0.004;

inline Fit<size> fit_contacts(const std::vector<Packing>& packings) {
  using D = Dual<size>;
  using C = kernel::ContactCoefficients<D>;
  std::vector<Observation<size>> rows;
  for (const Packing& p : packings) {
    rows.push_back(
        {[&p](const C& c) { return by_recipe<D>(p, c); }, p.mechanical_coordination, 1, p.specimen});
    if (from_gas(p))
      rows.push_back({[&p](const C& c) { return by_friction_alone<D>(p, c); }, p.mechanical_coordination, 1,
                      p.specimen});
  }
  for (const Step& s : steps_of(packings))
    rows.push_back({[s](const C& c) { return by_carrying<D>(*s.first, *s.later, c); },
                    s.later->mechanical_coordination, weight_of_steps, s.later->specimen});
  return relaxation::least_squares<size>(std::move(rows), {0.57, 0.745, 1.2, 4, 9, 2, 0.2, 1, 13, 0.014});
}

/// Roots of shares: counts scatter as their roots.
inline Fit<rattlers_n> fit_rattlers(const std::vector<Packing>& packings) {
  using D = Dual<rattlers_n>;
  std::vector<Observation<rattlers_n>> rows;
  for (const Packing& p : packings)
    rows.push_back({[&p](const kernel::RattlerCoefficients<D>& c) {
                      return sqrt(
                          kernel::rattlers_of_contacts<D>(p.mechanical_coordination, p.relative_overlap, c));
                    },
                    std::sqrt(p.rattler_fraction), 1, p.specimen});
  return relaxation::least_squares<rattlers_n>(std::move(rows), {0.15, 1.2, 10});
}

using Label = std::function<std::string(const Packing&)>;
inline std::string preparation_of(const Packing& p) { return p.preparation; }

/// Takes each value of a label, the packings that have it, and the coefficients fitted to all others.
template <class Take>
void each_left_out(const std::vector<Packing>& packings, const Label& label, const Take& take) {
  std::set<std::string> values;
  for (const Packing& p : packings)
    values.insert(label(p));
  for (const std::string& value : values) {
    std::vector<Packing> kept, left;
    for (const Packing& p : packings)
      (label(p) == value ? left : kept).push_back(p);
    take(value, left, fit_contacts(kept).coefficients);
  }
}

/// Judges the packings of each kind, and all together.
template <class Packing, class Kind, class Judge>
auto judge_each(const std::string& what, const std::vector<Packing>& all, const Kind& kind_of,
                const Judge& judge) {
  std::map<std::string, std::vector<Packing>> kinds{{"together", all}};
  for (const Packing& p : all)
    kinds[kind_of(p)].push_back(p);
  std::map<std::string, decltype(judge(what, all))> judged;
  for (const auto& [kind, packings] : kinds)
    judged.emplace(kind, judge(what + kind, packings));
  return judged;
}

/// Scatters are errors of packings of which the fit has seen no other of the same preparation.
inline Result fit_everything(const std::vector<Packing>& packings) {
  Result result{.contacts = fit_contacts(packings), .rattlers = fit_rattlers(packings)};
  Errors line, friction, carried, rattlers;
  each_left_out(packings, preparation_of,
                [&](const std::string& preparation, const auto& left, const auto& c) {
                  result.without.emplace(preparation, c);
                  for (const Packing& p : left)
                    (on_densest_line(p) ? line : friction).add(by_recipe(p, c) - p.mechanical_coordination);
                  for (const Step& way : ways_of(left))
                    carried.add(carrying_error(way, c) / root_of(way));
                });
  for (const Packing& p : packings)
    if (p.rattler_fraction > countable_rattlers)
      rattlers.add(std::log(kernel::rattlers_of_contacts<double>(
                                p.mechanical_coordination, p.relative_overlap, result.rattlers.coefficients) /
                            p.rattler_fraction));
  result.line_scatter = line.rms();
  result.friction_scatter = friction.rms();
  result.carried_scatter = carried.rms();
  result.rattler_scatter = rattlers.rms();
  return result;
}

} // namespace contact_prior
