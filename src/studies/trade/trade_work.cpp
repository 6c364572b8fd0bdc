// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "studies/plan/plan.hpp"

#include "trade_parts.hpp"

namespace granum::studies::trade {

namespace {

using triaxial::Density;

/// Without what a part of that kind does not depend on.
Settings settings_of(Kind kind, Settings s) {
  if (kind != Kind::probing)
    s.probe = 0;
  if (kind != Kind::shear)
    s.shear = 0;
  if (kind == Kind::packing)
    return {.boundary = s.boundary, .grains = s.grains, .seed = s.seed};
  return s;
}

class Planner {
 public:
  explicit Planner(const TradeScene& trade) : trade_(trade) {}

  PlannedWork all() {
    const std::size_t usual = trade_.scene.study.grains;
    for (const std::size_t grains : trade_.grains)
      add_specimens(Varied::grains, static_cast<double>(grains), grains);
    for (const double value : trade_.compression)
      add_specimens(Varied::compression, value, usual);
    for (const double value : trade_.shear)
      add_specimens(Varied::shear, value, usual);
    for (const double value : trade_.time_step)
      add_specimens(Varied::time_step, value, usual);
    for (const double value : trade_.probe)
      add_specimens(Varied::probe, value, usual);
    add_specimens(Varied::probe, 0, usual);
    add_boundaries();
    return std::move(planned_);
  }

 private:
  /// Walls of every size, and the periodic cell of the same size and of the largest that there is.
  void add_boundaries() {
    for (const Boundary boundary : {Boundary::periodic, Boundary::smooth_walls, Boundary::rough_walls}) {
      std::vector<std::size_t> sizes = trade_.walls;
      if (boundary == Boundary::periodic && !sizes.empty())
        sizes.push_back(*std::ranges::max_element(trade_.grains));
      std::ranges::sort(sizes);
      sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
      for (const std::size_t grains : sizes)
        add_specimens(Varied::boundary, static_cast<double>(grains), grains, boundary);
    }
  }

  /// The samples of one value of one varied quantity; all others are at their defaults.
  void add_specimens(Varied varied, double value, std::size_t grains,
                     Boundary boundary = Boundary::periodic) {
    Settings s{.boundary = boundary,
               .grains = grains,
               .compression = varied == Varied::compression ? value : trade_.compression_inertial_number,
               .time_step = varied == Varied::time_step ? value : trade_.time_step_fraction,
               .shear = varied == Varied::shear ? value : trade_.shear_inertial_number,
               .probe = varied == Varied::probe ? value : 0};
    for (const Density density : trade_.scene.study.densities)
      for (std::size_t k = 0; k < specimens_of(trade_, grains); ++k) {
        s.density = density;
        s.seed = trade_.scene.study.first_seed + k;
        if (varied != Varied::shear || density == Density::dense)
          add_sample(varied, value, s);
      }
  }

  void add_sample(Varied varied, double value, const Settings& s) {
    Source& source = planned_.sources.emplace_back();
    source.sample.varied = varied;
    source.sample.boundary = s.boundary;
    source.sample.value = value;
    source.sample.density = s.density;
    source.sample.seed = s.seed;
    source.measured = source.path = place_of(Kind::compression, s);
    source.moduli = varied == Varied::probe      ? &Part::vertical
                    : varied == Varied::boundary ? &Part::planes
                                                 : &Part::isotropic;
    if (varied == Varied::shear) {
      source.path = none;
      source.measured = place_of(Kind::shear, s);
      source.moduli = &Part::vertical;
    } else if (varied == Varied::probe && s.probe > 0)
      source.measured = place_of(Kind::probing, s);
    source.charged = {source.measured};
    if (varied == Varied::grains || varied == Varied::boundary)
      source.charged.push_back(planned_.parts[source.path].before);
    if ((varied == Varied::grains || varied == Varied::time_step) && s.density == Density::dense)
      source.charged.push_back(place_of(Kind::shear, s));
  }

  /// Index of a part, which is made with those that it starts from if there is none yet.
  std::size_t place_of(Kind kind, const Settings& all) {
    std::vector<Part>& parts = planned_.parts;
    const Settings settings = settings_of(kind, all);
    const auto found = std::ranges::find_if(
        parts, [&](const Part& part) { return part.kind == kind && part.settings == settings; });
    if (found != parts.end())
      return static_cast<std::size_t>(found - parts.begin());
    Part part{.kind = kind, .settings = settings};
    if (kind != Kind::packing) {
      part.before = place_of(kind == Kind::compression ? Kind::packing : Kind::compression, all);
      parts[part.before].sheared_later |= kind == Kind::shear;
      parts[part.before].probed_later |= kind == Kind::probing;
    }
    parts.push_back(std::move(part));
    return parts.size() - 1;
  }

  const TradeScene& trade_;
  PlannedWork planned_;
};

} // namespace

PlannedWork planned_work(const TradeScene& trade) { return Planner(trade).all(); }

double predicted_work(const TradeScene& trade, const Part& part) {
  const auto grains = static_cast<double>(part.settings.grains);
  Scene scene = trade.scene;
  scene.study.grains = part.settings.grains;
  switch (part.kind) {
  case Kind::packing:
    return preparation_work(scene);
  case Kind::compression:
    return specimen_work(scene, part.settings.density, scene.study.contacts.front());
  case Kind::shear: {
    // Spheres at 100 kPa, dense: 6,400 steps for a strain of 0.004 at 2e-4 and 0.8, of 60 grains or more.
    constexpr double steps_per_strain_and_rate = 257;
    return steps_per_strain_and_rate * trade.shear_strain / part.settings.shear / part.settings.time_step *
           grains;
  }
  case Kind::probing:
    break;
  }
  constexpr double steps = 1000; // of a probe of dense and loose specimens, about
  return steps * static_cast<double>(scene.study.pressures.size()) * grains;
}

double predicted_work(const TradeScene& trade) {
  double sum = 0;
  for (const Part& part : planned_work(trade).parts)
    sum += predicted_work(trade, part);
  return sum;
}

} // namespace granum::studies::trade
