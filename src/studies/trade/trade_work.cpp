// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "studies/plan/plan.hpp"

#include "trade_parts.hpp"

namespace granum::studies::trade {

namespace {

using triaxial::Density;

/// Index of the part for which `same` is true; it is made if there is none yet.
template <class Kind, class Same>
std::size_t place_of(std::vector<Kind>& parts, const Kind& wanted, const Same& same) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const Kind& part) { return same(part, wanted); });
  if (found != parts.end())
    return static_cast<std::size_t>(found - parts.begin());
  parts.push_back(wanted);
  return parts.size() - 1;
}

/// Settings of one specimen; the defaults except for the varied quantity.
struct Specimen {
  Boundary boundary = Boundary::periodic;
  std::size_t grains = 0;
  std::uint64_t seed = 0;
  Density density = Density::dense;
  double compression = 0;
  double time_step = 0;
};

class Planner {
 public:
  explicit Planner(const TradeScene& trade) : trade_(trade) {}

  PlannedWork all() {
    for (const std::size_t grains : trade_.grains)
      each_specimen(grains, [&](Specimen s) { grains_sample(s); });
    for (const double value : trade_.compression)
      each_specimen(trade_.scene.study.grains, [&](Specimen s) {
        s.compression = value;
        add(Varied::compression, value, s, {.compression = compression(s)});
      });
    for (const double value : trade_.shear)
      each_specimen(trade_.scene.study.grains, [&](const Specimen& s) {
        if (s.density == Density::dense)
          add(Varied::shear, value, s, {.shear = shear(compression(s), value, s.time_step)});
      });
    for (const double value : trade_.time_step)
      each_specimen(trade_.scene.study.grains, [&](Specimen s) {
        s.time_step = value;
        time_step_sample(s);
      });
    std::vector<double> amplitudes = trade_.probe;
    amplitudes.push_back(0);
    for (const double value : amplitudes)
      each_specimen(trade_.scene.study.grains, [&](const Specimen& s) { probe_sample(s, value); });
    boundaries();
    return std::move(planned_);
  }

 private:
  template <class Take>
  void each_specimen(std::size_t grains, const Take& take) const {
    for (const Density density : trade_.scene.study.densities)
      for (std::size_t k = 0; k < specimens_of(trade_, grains); ++k)
        take({.boundary = Boundary::periodic,
              .grains = grains,
              .seed = trade_.scene.study.first_seed + k,
              .density = density,
              .compression = trade_.compression_inertial_number,
              .time_step = trade_.time_step_fraction});
  }

  std::size_t compression(const Specimen& s) {
    const std::size_t packing =
        place_of(planned_.work.packings, Packing{{}, s.boundary, s.grains, s.seed, {}},
                 [](const Packing& a, const Packing& b) {
                   return a.boundary == b.boundary && a.grains == b.grains && a.seed == b.seed;
                 });
    Compression part;
    part.packing = packing;
    part.density = s.density;
    part.inertial_number = s.compression;
    part.time_step_fraction = s.time_step;
    return place_of(planned_.work.compressions, part, [](const Compression& a, const Compression& b) {
      return a.packing == b.packing && a.density == b.density && a.inertial_number == b.inertial_number &&
             a.time_step_fraction == b.time_step_fraction;
    });
  }

  std::size_t shear(std::size_t compression, double inertial_number, double time_step) {
    planned_.work.compressions[compression].sheared_later = true;
    Shear part;
    part.compression = compression;
    part.inertial_number = inertial_number;
    part.time_step_fraction = time_step;
    return place_of(planned_.work.shears, part, [](const Shear& a, const Shear& b) {
      return a.compression == b.compression && a.inertial_number == b.inertial_number &&
             a.time_step_fraction == b.time_step_fraction;
    });
  }

  /// Sources of a sample; `none` for parts that it does not need.
  struct Places {
    std::size_t compression = none;
    std::size_t shear = none;
    std::size_t probing = none;
  };

  void add(Varied varied, double value, const Specimen& s, const Places& places) {
    TradeSample sample;
    sample.varied = varied;
    sample.boundary = s.boundary;
    sample.value = value;
    sample.density = s.density;
    sample.seed = s.seed;
    planned_.sources.push_back({sample, places.compression, places.shear, places.probing});
  }

  [[nodiscard]] std::size_t default_shear(const Specimen& s, std::size_t compression) {
    return s.density == Density::dense ? shear(compression, trade_.shear_inertial_number, s.time_step) : none;
  }

  void grains_sample(const Specimen& s) {
    const std::size_t place = compression(s);
    add(Varied::grains, static_cast<double>(s.grains), s,
        {.compression = place, .shear = default_shear(s, place)});
  }

  void time_step_sample(const Specimen& s) {
    const std::size_t place = compression(s);
    add(Varied::time_step, s.time_step, s, {.compression = place, .shear = default_shear(s, place)});
  }

  void probe_sample(const Specimen& s, double amplitude) {
    const std::size_t place = compression(s);
    if (amplitude == 0)
      return add(Varied::probe, amplitude, s, {.compression = place});
    planned_.work.compressions[place].probed_later = true;
    Probing part;
    part.compression = place;
    part.amplitude = amplitude;
    planned_.work.probings.push_back(part);
    add(Varied::probe, amplitude, s, {.compression = place, .probing = planned_.work.probings.size() - 1});
  }

  /// Walls of every size, and the periodic cell of the same size and of the largest that there is.
  void boundaries() {
    const std::size_t largest = *std::max_element(trade_.grains.begin(), trade_.grains.end());
    for (const Boundary boundary : {Boundary::periodic, Boundary::smooth_walls, Boundary::rough_walls}) {
      std::vector<std::size_t> sizes = trade_.walls;
      if (boundary == Boundary::periodic && !sizes.empty())
        sizes.push_back(largest);
      std::sort(sizes.begin(), sizes.end());
      sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
      for (const std::size_t grains : sizes)
        each_specimen(grains, [&](Specimen s) {
          s.boundary = boundary;
          add(Varied::boundary, static_cast<double>(grains), s, {.compression = compression(s)});
        });
    }
  }

  const TradeScene& trade_;
  PlannedWork planned_;
};

/// A scene with another number of grains, for the predictions of verify/plan.hpp.
Scene resized(const TradeScene& trade, std::size_t grains) {
  Scene scene = trade.scene;
  scene.study.grains = grains;
  return scene;
}

double count(std::size_t grains) { return static_cast<double>(grains); }

} // namespace

PlannedWork planned_work(const TradeScene& trade) { return Planner(trade).all(); }

double predicted_work(const TradeScene& trade, const Work& /*work*/, const Packing& part) {
  return preparation_work(resized(trade, part.grains));
}

double predicted_work(const TradeScene& trade, const Work& work, const Compression& part) {
  const std::size_t grains = work.packings[part.packing].grains;
  const double usual =
      specimen_work(resized(trade, grains), part.density, trade.scene.study.contacts.front());
  return usual;
}

double predicted_work(const TradeScene& trade, const Work& work, const Shear& part) {
  // Spheres at 100 kPa, dense: 6,400 steps for a strain of 0.004 at 2e-4 and 0.8, of 60 grains or more.
  constexpr double steps_per_strain_and_rate = 257;
  const std::size_t grains = work.packings[work.compressions[part.compression].packing].grains;
  return steps_per_strain_and_rate * trade.shear_strain / part.inertial_number / part.time_step_fraction *
         count(grains);
}

double predicted_work(const TradeScene& trade, const Work& work, const Probing& part) {
  constexpr double steps = 1000; // of a probe of dense and loose specimens, about
  const std::size_t grains = work.packings[work.compressions[part.compression].packing].grains;
  return steps * count(trade.scene.study.pressures.size()) * count(grains);
}

double predicted_work(const TradeScene& trade, const Work& work) {
  double sum = 0;
  for (const Packing& part : work.packings)
    sum += predicted_work(trade, work, part);
  for (const Compression& part : work.compressions)
    sum += predicted_work(trade, work, part);
  for (const Shear& part : work.shears)
    sum += predicted_work(trade, work, part);
  for (const Probing& part : work.probings)
    sum += predicted_work(trade, work, part);
  return sum;
}

} // namespace granum::studies::trade
