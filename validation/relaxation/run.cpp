// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the packings that the relaxation factor is calibrated on, and those of a third seed to judge it by,
// and solves their contact networks.
//
//     relaxation_run equal states.csv [threads [first letters of the preparations]]
//     relaxation_run unseen third_seed.csv [threads [first letters of the preparations]]
//     relaxation_run unequal unequal.csv [threads [first letters of the preparations]]
//     relaxation_run exponents exponents.csv [threads [first letters of the preparations]]
//     relaxation_run rough rough.csv [threads [first letters of the preparations]]
//
// One row a state is appended as soon as the state is finished. A run that is started again skips the states
// that the file holds already, so it may be stopped at any time; a specimen whose path was cut is compressed
// anew, to the same bits. States that do not come to rest, or whose grains have not met, are named on the
// error stream and left out.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/contact/normal_law.hpp>
#include <granum/contact/rough_sphere.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

#include "recording.hpp"
#include "specimens.hpp"

namespace {

using namespace granum;
using relaxation::gas;
using relaxation::grain;
using relaxation::kPa;
using relaxation::MPa;
using relaxation::Packings;
using relaxation::Preparation;
using relaxation::Record;
using relaxation::Row;
using relaxation::Stage;

constexpr double radius = 0.5e-3; // R [m]

/// One kind of contact.
struct Shape {
  const char* name;
  contact::NormalLaw law;
  double pressure_limit; // [Pa]; beyond, the contact discs are no longer small
  bool fitted = true;    // else made by some preparations alone, to be compared with what the fit says
  bool exponents = true; // whether networks with other exponents on its packings are recorded
};

/// Roughness of both surfaces together: b at the mean force falls from 0.95 at 10 kPa to 0.5 at 200 kPa with
/// the larger one, from 0.7 to 0.4 with the smaller one.
const std::vector<Shape>& rough_shapes() {
  static const std::vector<Shape> all{
      {"rough50nm", contact::RoughSphere(grain, radius, 50e-9), 100 * MPa},
      {"rough200nm", contact::RoughSphere(grain, radius, 200e-9), 100 * MPa},
  };
  return all;
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{
      {"cone", contact::PowerLaw::cone(grain, 0.4), 100 * MPa},
      {"sphere", contact::PowerLaw::sphere(grain, radius), 100 * MPa},
      {"flat", contact::PowerLaw::flat(grain, 5.7e-6), 30 * MPa},
      {"alpha1.5", contact::PowerLaw::general(grain, 1.5, 180), 100 * MPa, true, false},
      {"alpha4", contact::PowerLaw::general(grain, 4, 2e12), 30 * MPa, false, false},
  };
  return all;
}

const std::vector<Preparation>& preparations() {
  using enum triaxial::Density;
  const double mu = contact::Friction::from_angle(26.5 * M_PI / 180).coefficient();
  const std::vector<Stage> low{{10 * kPa}, {30 * kPa}, {100 * kPa}};
  std::vector<Stage> wide = low;
  wide.insert(wide.end(), {{1 * MPa}, {10 * MPa}, {30 * MPa}, {100 * MPa}});
  const std::vector<Stage> decades{{10 * kPa}, {100 * kPa}, {1 * MPa}};
  const std::vector<Stage> cycle{{10 * kPa}, {3 * MPa}, {300 * kPa}, {100 * kPa}, {30 * kPa}, {10 * kPa}};
  const std::vector<Stage> compression{{100 * kPa},      {100 * kPa, 0.2}, {100 * kPa, 0.4},
                                       {100 * kPa, 0.6}, {100 * kPa, 0.7}, {100 * kPa, 0.8}};
  const std::vector<Stage> extension{{100 * kPa}, {100 * kPa, -0.25}, {100 * kPa, -0.5}, {100 * kPa, -0.6}};
  static const std::vector<Preparation> all{
      {.name = "dense", .density = dense, .friction_coefficient = mu, .path = wide, .unfitted_shapes = true},
      {.name = "loose", .friction_coefficient = mu, .path = low, .unfitted_shapes = true},
      {.name = "mu0.1", .friction_coefficient = 0.1, .path = decades},
      {.name = "mu0.2", .friction_coefficient = 0.2, .path = decades},
      {.name = "dense txc", .density = dense, .friction_coefficient = mu, .path = compression},
      {.name = "loose txc", .friction_coefficient = mu, .path = compression},
      {.name = "mu0.03", .friction_coefficient = 0.03, .path = decades},
      {.name = "mu1",
       .friction_coefficient = 1,
       .path = low,
       .opening = relaxation::slight,
       .grains = 1000,
       .max_steps = 200000},
      {.name = "dense txe", .density = dense, .friction_coefficient = mu, .path = extension},
      {.name = "cycle", .friction_coefficient = mu, .path = cycle},
      {.name = "mu0.2 txc", .friction_coefficient = 0.2, .path = compression},
      {.name = "agitated",
       .friction_coefficient = mu,
       .path = low,
       .opening = relaxation::stirred,
       .grains = 1000,
       .max_steps = 200000},
      gas("gas mu0.02", 0.02, decades),
      gas("gas mu0.1", 0.1, decades),
      gas("gas mu0.3", 0.3, decades, true),
      gas("gas", mu, decades),
      gas("gas mu1", 1, decades),
  };
  return all;
}

/// Those of them whose packings are isotropic and were loaded once.
std::vector<Preparation> isotropic_preparations() {
  std::vector<Preparation> all;
  for (const Preparation& preparation : preparations())
    if (std::ranges::all_of(preparation.path, [](const Stage& s) { return s.stress_ratio == 0; }) &&
        std::ranges::is_sorted(preparation.path, {}, &Stage::pressure))
      all.push_back(preparation);
  return all;
}

/// Of rough grains: at low pressures b is large.
std::vector<Preparation> rough_preparations() {
  const std::vector<Stage> path{{10 * kPa}, {30 * kPa}, {100 * kPa}, {300 * kPa}, {1 * MPa}};
  std::vector<Preparation> all;
  for (Preparation preparation : preparations())
    if (const std::string name = preparation.name;
        name == "dense" || name == "loose" || name == "mu0.1" || name == "gas mu0.1" || name == "gas mu0.3") {
      preparation.path = path;
      all.push_back(preparation);
    }
  // A roughness of 200 nm still touches where others are opened, by 0.3 %.
  all.push_back({.name = "opened",
                 .friction_coefficient = contact::Friction::from_angle(26.5 * M_PI / 180).coefficient(),
                 .path = path,
                 .opening = relaxation::slight,
                 .grains = 2000,
                 .max_steps = 200000});
  return all;
}

/// Small specimens of grains of many sizes, and of equal ones to compare with. C_u of 1, 1.5, 2, 3.2 and 4,
/// the last of two sizes only. All gradations of one preparation come before the next, so that a run that is
/// cut leaves a balanced table.
std::vector<Preparation> unequal_preparations() {
  using enum triaxial::Density;
  const double mu = contact::Friction::from_angle(26.5 * M_PI / 180).coefficient();
  const std::vector<Stage> path{{30 * kPa}, {300 * kPa}};
  const std::vector<Stage> cycle{{100 * kPa}, {3 * MPa}, {100 * kPa}};
  const std::vector<Stage> compression{{100 * kPa, 0.4}, {100 * kPa, 0.7}};
  const std::vector<Preparation> ways{
      {.name = "dense", .density = dense, .friction_coefficient = mu, .path = path},
      gas("gas mu0.3", 0.3, path),
      gas("gas mu0.1", 0.1, path),
      gas("gas mu1", 1, path),
      {.name = "loose", .friction_coefficient = mu, .path = path},
      {.name = "cycle", .friction_coefficient = mu, .path = cycle},
      {.name = "dense txc", .density = dense, .friction_coefficient = mu, .path = compression},
  };
  const struct {
    const char* sizes;
    std::size_t grains;
  } gradations[] = {{"", 500},
                    {"lognormal:0.25", 500},
                    {"uniformity:2:4.5", 700},
                    {"power-law:3:9", 1000},
                    {"bidisperse:4:0.03", 800}};
  std::vector<Preparation> all;
  for (Preparation way : ways)
    for (const auto& [sizes, grains] : gradations) {
      way.sizes = sizes;
      way.grains = grains;
      way.max_steps = 400000;
      all.push_back(way);
    }
  return all;
}

/// The first columns: six that name a state, after the sizes where grains may differ, and what else it was
/// made with.
Row key(const Shape& shape, const Preparation& preparation, std::uint64_t seed, const Stage& stage,
        std::size_t number, bool with_sizes) {
  Row row;
  if (with_sizes)
    row.add("sizes", relaxation::sizes_of(preparation).text());
  row.add("contact", std::string(shape.name));
  row.add("preparation", std::string(preparation.name));
  row.add("seed", static_cast<double>(seed));
  row.add("grains", static_cast<double>(preparation.grains));
  row.add("stage", static_cast<double>(number));
  row.add("p_Pa", stage.pressure);
  row.add("alpha",
          shape.law.power_law() ? shape.law.power_law()->alpha() : std::numeric_limits<double>::quiet_NaN());
  row.add("stress_ratio", stage.stress_ratio);
  row.add("friction_coefficient", preparation.friction_coefficient);
  return row;
}

/// What is recorded.
enum class Kind { equal, unequal, exponents, rough };

void run_specimen(const Shape& shape, const Preparation& preparation, std::uint64_t seed, Packings& packings,
                  Kind kind, Record& record) {
  std::vector<Row> keys;
  std::size_t last_missing = 0;
  for (std::size_t k = 0; k < preparation.path.size(); ++k) {
    keys.push_back(key(shape, preparation, seed, preparation.path[k], k, kind == Kind::unequal));
    if (preparation.path[k].pressure <= shape.pressure_limit && !record.has(keys.back()))
      last_missing = k + 1;
  }
  if (last_missing == 0)
    return;
  const triaxial::SpecimenRecipe specimen = relaxation::recipe(shape.law, radius, preparation, seed);
  dem::Specimen state = relaxation::start_of_path(packings.get(shape.name, specimen), preparation, specimen);
  for (std::size_t k = 0; k < last_missing; ++k) {
    state = relaxation::at_stage(std::move(state), preparation, k, specimen.material);
    if (record.has(keys[k]))
      continue;
    const triaxial::FrozenState frozen = triaxial::freeze_in_place(state, specimen.material);
    if (const std::string why = relaxation::why_left_out(frozen, specimen.material); !why.empty()) {
      std::fprintf(stderr, "%s: %s\n", record.key_of(keys[k].cells).c_str(), why.c_str());
      continue;
    }
    Row row = keys[k];
    if (kind == Kind::exponents || kind == Kind::rough)
      describe_stiffening(row, frozen.state(), specimen.material);
    else
      describe(row, frozen.state(), specimen.material, kind == Kind::unequal);
    record.append(row);
    std::fprintf(stderr, "%s\n", record.key_of(row.cells).c_str());
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::string asked = argc > 1 ? argv[1] : "";
  if (argc < 3 || argc > 5 ||
      (asked != "equal" && asked != "unseen" && asked != "unequal" && asked != "exponents" &&
       asked != "rough")) {
    std::fprintf(stderr,
                 "usage: %s equal|unseen|unequal|exponents|rough FILE.csv [threads [first letters of the "
                 "preparations]]\n",
                 argv[0]);
    return 2;
  }
  const bool unequal = asked == "unequal";
  const Kind kind = unequal                ? Kind::unequal
                    : asked == "exponents" ? Kind::exponents
                    : asked == "rough"     ? Kind::rough
                                           : Kind::equal;
  const std::vector<Shape>& all_shapes = kind == Kind::rough ? rough_shapes() : shapes();
  const std::string chosen = argc > 4 ? argv[4] : "";
  const std::size_t threads = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1;
  // The third seed is never fitted.
  const std::vector<std::uint64_t> rounds = asked == "unseen"         ? std::vector<std::uint64_t>{2}
                                            : kind == Kind::exponents ? std::vector<std::uint64_t>{0, 2}
                                                                      : std::vector<std::uint64_t>{0, 1};
  const std::vector<Preparation> ways = unequal                   ? unequal_preparations()
                                        : kind == Kind::rough     ? rough_preparations()
                                        : kind == Kind::exponents ? isotropic_preparations()
                                                                  : preparations();
  struct Task {
    const Shape* shape;
    const Preparation* preparation;
    std::uint64_t seed;
  };
  // Every shape and preparation once before any of them with a second seed. No two shapes share a seed.
  std::vector<Task> tasks;
  for (const std::uint64_t round : rounds)
    for (const Preparation& preparation : ways)
      if (std::string(preparation.name).starts_with(chosen))
        for (std::size_t k = 0; k < all_shapes.size(); ++k)
          if (kind == Kind::exponents ? all_shapes[k].exponents
                                      : all_shapes[k].fitted || preparation.unfitted_shapes)
            tasks.push_back({&all_shapes[k], &preparation,
                             (unequal ? 1000 : 100) * (k + 1) + (kind == Kind::rough ? 500 : 0) + round});
  Record record(argv[2], unequal ? 7 : 6);
  Packings packings;
  std::atomic<std::size_t> next = 0;
  const auto worker = [&] {
    for (std::size_t k = next++; k < tasks.size(); k = next++) {
      const Task& task = tasks[k];
      try {
        run_specimen(*task.shape, *task.preparation, task.seed, packings, kind, record);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s %s #%zu: %s\n", task.shape->name, task.preparation->name,
                     static_cast<std::size_t>(task.seed), error.what());
      }
    }
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < threads; ++t)
    others.emplace_back(worker);
  worker();
  for (std::thread& other : others)
    other.join();
}
