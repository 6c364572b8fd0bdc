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
#include <granum/contact/normal_law.hpp>
#include <granum/contact/rough_sphere.hpp>

#include "../common.hpp"
#include "making.hpp"
#include "reading.hpp"

namespace {

using namespace relaxation;

constexpr double radius = 0.5e-3; // R [m]

/// One kind of contact.
struct Shape {
  const char* name;
  contact::NormalLaw law;
  double pressure_limit; // [Pa]; beyond, the contact discs are no longer small
  bool fitted = true;    // else made by some preparations alone, to be compared with what the fit says
  bool exponents = true; // whether networks with other exponents on its packings are recorded
};

std::vector<Shape> shapes(bool rough) {
  // Roughness of both surfaces together: b at the mean force falls from 0.95 at 10 kPa to 0.5 at 200 kPa with
  // the larger one, from 0.7 to 0.4 with the smaller one.
  if (rough)
    return {{"rough50nm", contact::RoughSphere(grain, radius, 50e-9), 100 * MPa},
            {"rough200nm", contact::RoughSphere(grain, radius, 200e-9), 100 * MPa}};
  return {{"cone", relaxation::detail::law("cone", radius), 100 * MPa},
          {"sphere", relaxation::detail::law("sphere", radius), 100 * MPa},
          {"flat", relaxation::detail::law("flat", radius), 30 * MPa},
          {"alpha1.5", relaxation::detail::law("alpha1.5", radius), 100 * MPa, true, false},
          {unfitted_contact, relaxation::detail::law(unfitted_contact, radius), 30 * MPa, false, false}};
}

std::vector<Preparation> preparations() {
  using enum triaxial::Density;
  const double mu = usual_friction();
  const std::vector<Stage> low{{10 * kPa}, {30 * kPa}, {100 * kPa}};
  std::vector<Stage> wide = low;
  wide.insert(wide.end(), {{1 * MPa}, {10 * MPa}, {30 * MPa}, {100 * MPa}});
  const std::vector<Stage> decades{{10 * kPa}, {100 * kPa}, {1 * MPa}};
  const std::vector<Stage> cycle{{10 * kPa}, {3 * MPa}, {300 * kPa}, {100 * kPa}, {30 * kPa}, {10 * kPa}};
  const std::vector<Stage> compression{{100 * kPa},      {100 * kPa, 0.2}, {100 * kPa, 0.4},
                                       {100 * kPa, 0.6}, {100 * kPa, 0.7}, {100 * kPa, 0.8}};
  const std::vector<Stage> extension{{100 * kPa}, {100 * kPa, -0.25}, {100 * kPa, -0.5}, {100 * kPa, -0.6}};
  return {
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
       .opening = slight,
       .grains = 1000,
       .max_steps = 200000},
      {.name = "dense txe", .density = dense, .friction_coefficient = mu, .path = extension},
      {.name = "cycle", .friction_coefficient = mu, .path = cycle},
      {.name = "mu0.2 txc", .friction_coefficient = 0.2, .path = compression},
      {.name = "agitated",
       .friction_coefficient = mu,
       .path = low,
       .opening = stirred,
       .grains = 1000,
       .max_steps = 200000},
      gas("gas mu0.02", 0.02, decades),
      gas("gas mu0.1", 0.1, decades),
      gas("gas mu0.3", 0.3, decades, true),
      gas("gas", mu, decades),
      gas("gas mu1", 1, decades),
  };
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
                 .friction_coefficient = usual_friction(),
                 .path = path,
                 .opening = slight,
                 .grains = 2000,
                 .max_steps = 200000});
  return all;
}

/// Small specimens of grains of many sizes, and of equal ones to compare with. C_u of 1, 1.5, 2, 3.2 and 4,
/// the last of two sizes only. All gradations of one preparation come before the next, so that a run that is
/// cut leaves a balanced table.
std::vector<Preparation> unequal_preparations() {
  using enum triaxial::Density;
  const double mu = usual_friction();
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
Row key(const Shape& shape, const Preparation& preparation, std::uint64_t seed, std::size_t stage,
        bool with_sizes) {
  const auto& [pressure, stress_ratio] = preparation.path[stage];
  Row row;
  if (with_sizes)
    row.add("sizes", sizes_of(preparation).text());
  row.add("contact", shape.name);
  row.add("preparation", preparation.name);
  row.add({{"seed", static_cast<double>(seed)},
           {"grains", static_cast<double>(preparation.grains)},
           {"stage", static_cast<double>(stage)},
           {"p_Pa", pressure},
           {"alpha", shape.law.power_law() ? shape.law.power_law()->alpha() : State::unset},
           {"stress_ratio", stress_ratio},
           {"friction_coefficient", preparation.friction_coefficient}});
  return row;
}

/// What is recorded, by preparation and seed.
struct Kind {
  std::vector<Preparation> (*preparations)();
  std::vector<std::uint64_t> rounds; // the third seed is never fitted
  std::uint64_t first_seed, seeds_of_a_shape;
};
const std::map<std::string, Kind> kinds{{"equal", {preparations, {0, 1}, 0, 100}},
                                        {"unseen", {preparations, {2}, 0, 100}},
                                        {"unequal", {unequal_preparations, {0, 1}, 0, 1000}},
                                        {"exponents", {isotropic_preparations, {0, 2}, 0, 100}},
                                        {"rough", {rough_preparations, {0, 1}, 500, 100}}};

/// Every shape and preparation once before any of them with a second seed. No two shapes share a seed.
std::vector<Task> tasks_of(const std::string& asked, const std::string& first_letters) {
  const Kind& kind = kinds.at(asked);
  const std::vector<Shape> all = shapes(asked == "rough");
  std::vector<Task> tasks;
  for (const std::uint64_t round : kind.rounds)
    for (const Preparation& preparation : kind.preparations())
      for (std::size_t k = 0; k < all.size(); ++k) {
        const bool wanted =
            asked == "exponents" ? all[k].exponents : all[k].fitted || preparation.unfitted_shapes;
        if (!wanted || !std::string(preparation.name).starts_with(first_letters))
          continue;
        const std::uint64_t seed = kind.seeds_of_a_shape * (k + 1) + kind.first_seed + round;
        tasks.push_back({.shape = all[k].name,
                         .preparation = preparation,
                         .recipe = recipe(all[k].law, radius, preparation, seed),
                         .keys = {},
                         .pressure_limit = all[k].pressure_limit});
        for (std::size_t stage = 0; stage < preparation.path.size(); ++stage)
          tasks.back().keys.push_back(key(all[k], preparation, seed, stage, asked == "unequal"));
      }
  return tasks;
}

void describe(const std::string& asked, Row& row, const dem::Specimen& frozen,
              const dem::Material& material) {
  const packing::Assembly assembly = dem::contact_network(frozen, material);
  row.add("e", dem::void_ratio(frozen));
  if (asked == "exponents" || asked == "rough") {
    add_counts(row, assembly, material, false);
    CountedPacking(assembly, material.law).add_to(row);
    return;
  }
  add_assembly(row, assembly, material);
  add_networks(row, assembly, material.tangential_ratio);
  if (asked == "unequal")
    add_sizes(row, assembly, measured(assembly, material));
}

} // namespace

int main(int argc, char** argv) {
  std::vector<Command> commands;
  for (const auto& [asked, kind] : kinds)
    commands.emplace_back(asked, "FILE.csv [threads] [first-letters-of-the-preparations]",
                          [asked = asked](const Arguments& arguments) {
                            Record record(arguments[0], asked == "unequal" ? 7 : 6);
                            record_all(tasks_of(asked, arguments.size() > 2 ? arguments[2] : ""),
                                       arguments.size() > 1 ? std::stoul(arguments[1]) : 1, record,
                                       [&](Row& row, const dem::Specimen& frozen, const Task& task) {
                                         describe(asked, row, frozen, task.recipe.material);
                                       });
                          });
  return program(argc, argv, commands);
}
