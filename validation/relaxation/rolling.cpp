// SPDX-License-Identifier: GPL-3.0-or-later
// What rolling resistance of the contacts does to G and K: makes packings, solves their networks without and
// with it, fits the gain to half of them and judges it by the others.
//
//     relaxation_rolling make rolling.csv [threads]
//     relaxation_rolling coefficients rolling.csv      writes the numbers of
//     src/effective/rolling_coefficients.hpp relaxation_rolling check rolling.csv
//
// Rows are appended as of relaxation_run: a run that is started again skips the states that the file holds.
// k_r is the rolling stiffness of a contact over k_n R*^2, R* = R_i R_j/(R_i + R_j), the same for all.
#include <granum/packing/stiffness.hpp>

#include "../common.hpp"
#include "../constants.hpp"
#include "making.hpp"
#include "rolling_fits.hpp"

namespace {

using namespace relaxation;

constexpr double radius = 0.5e-3; // R, mean by number [m]
/// Seeds count shapes and preparations together: packings of even seeds are fitted, the others judge.
constexpr std::uint64_t first_seed = 71000;

/// Of grains as they are in relaxation_run.
std::vector<Preparation> preparations() {
  using enum triaxial::Density;
  const double mu = usual_friction();
  const auto path = [](double low, double high) { return std::vector<Stage>{{low}, {high}}; };
  const std::vector<Stage> shear{{100 * kPa}, {100 * kPa, 0.4}, {100 * kPa, 0.75}};
  std::vector<Preparation> all{
      {.name = "dense", .density = dense, .friction_coefficient = mu, .path = path(30 * kPa, 3 * MPa)},
      {.name = "loose", .friction_coefficient = mu, .path = path(20 * kPa, 500 * kPa)},
      {.name = "dense txc", .density = dense, .friction_coefficient = mu, .path = shear},
      gas("gas mu0.3", 0.3, path(50 * kPa, 1 * MPa)),
      {.name = "loose txc", .friction_coefficient = mu, .path = shear},
      {.name = "mu0.1", .friction_coefficient = 0.1, .path = path(20 * kPa, 500 * kPa)},
      {.name = "mu1", .friction_coefficient = 1, .path = path(50 * kPa, 1 * MPa), .opening = slight},
  };
  for (Preparation& preparation : all) {
    preparation.grains = 1000;
    preparation.max_steps = 200000;
  }
  const std::vector<Preparation> equal = all;
  for (const char* sizes : {"lognormal:0.25", "uniformity:2:4.5"})
    for (Preparation preparation : {equal[0], equal[1], equal[3]}) {
      preparation.sizes = sizes;
      all.push_back(preparation);
    }
  return all;
}

void add_rolling_networks(Row& row, packing::Assembly assembly, double own_ratio) {
  for (const double r : rolled_tangential_ratios)
    for (const double k_r : rolling_ratios) {
      set_tangential_ratio(assembly, r);
      assign_rolling_stiffness(assembly, {.value = k_r, .of = packing::TurningSpring::Of::normal});
      add_stiffness(row, rolling_suffix(r, k_r), network::linear_response(assembly).relaxed());
    }
  set_tangential_ratio(assembly, own_ratio);
  add_stiffness(row, "affine", network::linear_response(assembly, {.iteration_limit = 1}).affine());
}

std::vector<Task> tasks() {
  std::vector<Task> all;
  const char* const shapes[] = {"sphere", "cone", "flat", "alpha1.5"};
  const std::vector<Preparation> ways = preparations();
  for (std::size_t way = 0; way < ways.size(); ++way)
    for (std::size_t k = 0; k < std::size(shapes); ++k) {
      if (!ways[way].sizes.empty() && k > 0)
        continue;
      const std::uint64_t seed = first_seed + 101 * k + way;
      all.push_back({.shape = shapes[k],
                     .preparation = ways[way],
                     .recipe = recipe(relaxation::detail::law(shapes[k], radius), radius, ways[way], seed),
                     .keys = {}});
      for (std::size_t stage = 0; stage < ways[way].path.size(); ++stage) {
        Row row;
        row.add("sizes", sizes_of(ways[way]).text());
        row.add("contact", shapes[k]);
        row.add("preparation", ways[way].name);
        row.add({{"seed", static_cast<double>(seed)},
                 {"stage", static_cast<double>(stage)},
                 {"p_Pa", ways[way].path[stage].pressure},
                 {"stress_ratio", ways[way].path[stage].stress_ratio},
                 {"friction_coefficient", ways[way].friction_coefficient}});
        all.back().keys.push_back(row);
      }
    }
  return all;
}

void describe(Row& row, const dem::Specimen& frozen, const Task& task) {
  const dem::Material& material = task.recipe.material;
  const packing::Assembly assembly = dem::contact_network(frozen, material);
  row.add("e", dem::void_ratio(frozen));
  add_assembly(row, assembly, material);
  add_sizes(row, assembly, analysis::measure(assembly, {.law = material.law}));
  add_rolling_networks(row, assembly, material.tangential_ratio);
}

// ---- the fit

const std::string header = HEADERS "/rolling_coefficients.hpp"; // of the library

std::vector<Constant> constants_of(const std::vector<Rolled>& all) {
  const RollingFit fit = fit_rolling(all);
  for (std::size_t k = 0; k < 8; ++k)
    std::fprintf(stderr, "standard error %.2g\n", k < 5 ? fit.shear.error(k) : fit.bulk.error(k - 5));
  return {{"rolling_shear{", joined(fit.shear.coefficients)},
          {"rolling_bulk{", joined(fit.bulk.coefficients)},
          {"rolling_errors{", joined(rolling_errors(all, fit))}};
}

/// Gains of relaxed() beside those of the networks, and its stated errors of the moduli themselves; printed.
struct RollingErrors {
  Errors G, K, G_vh, G_hh, gain, of_G, of_K;
};

template <class Choice>
RollingErrors errors_of_library(const std::string& what, const std::vector<Rolled>& all,
                                const Choice& chosen) {
  RollingErrors e;
  for (const Rolled& one : all) {
    if (!chosen(one))
      continue;
    const auto before = effective::relaxed(one.state, one.z()),
               after = effective::relaxed(one.rolled(), one.z());
    const TransverselyIsotropic &c = after.stiffness, &c0 = before.stiffness;
    const double G = isotropic_shear_modulus(c), K = c.bulk_modulus();
    e.G.add(std::log(G / isotropic_shear_modulus(c0)) - one.shear_gain());
    e.K.add(std::log(K / c0.bulk_modulus()) - one.bulk_gain());
    e.G_vh.add(std::log(c.G_vh() / c0.G_vh()) - std::log(one.with.G_vh() / one.without.G_vh()));
    e.G_hh.add(std::log(c.G_hh() / c0.G_hh()) - std::log(one.with.G_hh() / one.without.G_hh()));
    e.gain.add(one.shear_gain());
    e.of_G.add(G / isotropic_shear_modulus(one.with) - 1, after.relative_error.G_vh);
    e.of_K.add(K / one.with.bulk_modulus() - 1, after.relative_error.bulk_modulus);
  }
  std::printf(
      "%-34s %4d | gain of G %5.1f %% | error %% rms, worst: G %.1f, %.1f  K %.1f, %.1f  G_vh %.1f, %.1f  "
      "G_hh %.1f, %.1f | within one, two: G %3.0f, %3.0f %%  K %3.0f, %3.0f %%\n",
      what.c_str(), e.G.count(), 100 * std::expm1(e.gain.mean()), 100 * e.G.rms(), 100 * e.G.worst(),
      100 * e.K.rms(), 100 * e.K.worst(), 100 * e.G_vh.rms(), 100 * e.G_vh.worst(), 100 * e.G_hh.rms(),
      100 * e.G_hh.worst(), 100 * e.of_G.one(), 100 * e.of_G.two(), 100 * e.of_K.one(), 100 * e.of_K.two());
  return e;
}

int check(const std::vector<Rolled>& all) {
  Claims claims;
  claims.require(first_other(header, constants_of(all), 1e-5).empty(),
                 "the library's coefficients are those of the record");
  RollingErrors left;
  for (const double r : rolled_tangential_ratios)
    for (const bool fitted : {true, false})
      left =
          errors_of_library(std::string(fitted ? "fitted" : "left out") + ", k_t/k_n " + short_number(r), all,
                            [&](const Rolled& one) {
                              return one.fitted == fitted && one.isotropic && one.state.tangential_ratio == r;
                            });
  const auto usual = [](const Rolled& one) {
    return one.state.tangential_ratio == rolled_tangential_ratios[2];
  };
  const auto usual_left = [&](const Rolled& one) { return !one.fitted && one.isotropic && usual(one); };
  for (const double k_r : rolling_ratios)
    if (k_r > 0)
      errors_of_library("  left out, k_r " + short_number(k_r), all,
                        [&](const Rolled& one) { return usual_left(one) && one.k_r == k_r; });
  errors_of_library("  left out, unequal grains", all,
                    [&](const Rolled& one) { return usual_left(one) && one.state.contacts.branch != 1; });
  errors_of_library("  loose (z* < 4.7), k_r 0.1", all, [&](const Rolled& one) {
    return one.isotropic && usual(one) && one.z() < 4.7 && one.k_r == 0.1;
  });
  const RollingErrors sheared = errors_of_library(
      "sheared, never fitted", all, [&](const Rolled& one) { return !one.isotropic && usual(one); });
  claims.require(left.G.rms() < 0.02 && left.G.worst() < 0.06,
                 "left out: gain of G within 2 % rms, 6 % at worst");
  claims.require(left.K.rms() < 0.02, "left out: gain of K within 2 % rms");
  claims.require(sheared.G_vh.rms() < 0.02 && sheared.G_hh.rms() < 0.02,
                 "sheared: gains of G_vh and G_hh within 2 % rms");
  claims.require_covered(left.of_G, "left out, G", 0.6, 0.92);
  claims.require_covered(left.of_K, "left out, K", 0.6, 0.92);
  return claims.exit_code();
}

} // namespace

int main(int argc, char** argv) {
  return program(
      argc, argv,
      {
          {"make", "rolling.csv [threads]",
           [](const Arguments& arguments) {
             Record record(arguments[0], 5);
             record_all(tasks(), arguments.size() > 1 ? std::stoul(arguments[1]) : 1, record, describe);
           }},
          {"check", "rolling.csv", [](const Arguments& files) { return check(read_rolled(files[0])); }},
          {"coefficients", "rolling.csv",
           [](const Arguments& files) { write_header(header, constants_of(read_rolled(files[0]))); }},
      });
}
