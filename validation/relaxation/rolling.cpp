// SPDX-License-Identifier: GPL-3.0-or-later
// What rolling resistance of the contacts does to G and K: makes packings, solves their networks without and
// with it, fits the gain to half of them and judges it by the others.
//
//     relaxation_rolling make rolling.csv [threads]
//     relaxation_rolling coefficients rolling.csv > src/effective/rolling_coefficients.hpp
//     relaxation_rolling check rolling.csv
//
// Rows are appended as of relaxation_run: a run that is started again skips the states that the file holds.
// k_r is the rolling stiffness of a contact over k_n R*^2, R* = R_i R_j/(R_i + R_j), the same for all.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/packing/stiffness.hpp>
#include <granum/triaxial/probe.hpp>

#include "../claims.hpp"
#include "rolling_fits.hpp"
#include "specimens.hpp"

namespace {

using namespace relaxation;

constexpr double radius = 0.5e-3; // R, mean by number [m]
/// Seeds count shapes and preparations together: packings of even seeds are fitted, the others judge.
constexpr std::uint64_t first_seed = 71000;

/// Of grains as they are in relaxation_run.
std::vector<Preparation> preparations() {
  using enum triaxial::Density;
  const double mu = contact::Friction::from_angle(26.5 * M_PI / 180).coefficient();
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
      for (packing::Contact& contact : assembly.contacts)
        contact.tangential_stiffness = r * contact.normal_stiffness;
      assign_rolling_stiffness(assembly, {.value = k_r, .of = packing::TurningSpring::Of::normal});
      add_stiffness(row, rolling_suffix(r, k_r), network::linear_response(assembly).relaxed());
    }
  for (packing::Contact& contact : assembly.contacts)
    contact.tangential_stiffness = own_ratio * contact.normal_stiffness;
  add_stiffness(row, "affine", network::linear_response(assembly, {.iteration_limit = 1}).affine());
}

void make_specimen(const std::string& shape, const Preparation& preparation, std::uint64_t seed,
                   Record& record) {
  std::vector<Row> keys;
  bool complete = true;
  for (std::size_t k = 0; k < preparation.path.size(); ++k) {
    Row row;
    row.add("sizes", sizes_of(preparation).text());
    row.add("contact", shape);
    row.add("preparation", std::string(preparation.name));
    row.add("seed", static_cast<double>(seed));
    row.add("stage", static_cast<double>(k));
    row.add("p_Pa", preparation.path[k].pressure);
    row.add("stress_ratio", preparation.path[k].stress_ratio);
    row.add("friction_coefficient", preparation.friction_coefficient);
    complete = complete && record.has(row);
    keys.push_back(row);
  }
  if (complete)
    return;
  const triaxial::SpecimenRecipe specimen =
      recipe(relaxation::detail::law(shape, radius), radius, preparation, seed);
  Packings packings;
  dem::Specimen state = start_of_path(packings.get(shape, specimen), preparation, specimen);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    state = at_stage(std::move(state), preparation, k, specimen.material);
    const triaxial::FrozenState frozen = triaxial::freeze_in_place(state, specimen.material);
    Row row = keys[k];
    if (const std::string why = why_left_out(frozen, specimen.material); !why.empty())
      std::fprintf(stderr, "%s: %s\n", record.key_of(row.cells).c_str(), why.c_str());
    else if (!record.has(row)) {
      const packing::Assembly assembly = dem::contact_network(frozen.state(), specimen.material);
      row.add("e", dem::void_ratio(frozen.state()));
      add_assembly(row, assembly, specimen.material);
      add_sizes(row, assembly, analysis::measure(assembly, {.law = specimen.material.law}));
      add_rolling_networks(row, assembly, specimen.material.tangential_ratio);
      record.append(row);
      std::fprintf(stderr, "%s\n", record.key_of(row.cells).c_str());
    }
  }
}

int make(const std::string& path, std::size_t threads) {
  struct Task {
    std::string shape;
    Preparation preparation;
    std::uint64_t seed;
  };
  std::vector<Task> tasks;
  const char* const shapes[] = {"sphere", "cone", "flat", "alpha1.5"};
  const std::vector<Preparation> ways = preparations();
  for (std::size_t way = 0; way < ways.size(); ++way)
    for (std::size_t k = 0; k < std::size(shapes); ++k)
      if (ways[way].sizes.empty() || k == 0)
        tasks.push_back({shapes[k], ways[way], first_seed + 101 * k + way});
  Record record(path, 5);
  std::atomic<std::size_t> next = 0;
  const auto worker = [&] {
    for (std::size_t k = next++; k < tasks.size(); k = next++)
      try {
        make_specimen(tasks[k].shape, tasks[k].preparation, tasks[k].seed, record);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s %s: %s\n", tasks[k].shape.c_str(), tasks[k].preparation.name, error.what());
      }
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < threads; ++t)
    others.emplace_back(worker);
  worker();
  for (std::thread& other : others)
    other.join();
  return 0;
}

// ---- the fit

void print_numbers(const char* name, const char* type, const double* values, std::size_t count) {
  std::printf("inline constexpr %s %s{\n    ", type, name);
  for (std::size_t k = 0; k < count; ++k)
    std::printf("%s%.9g", k > 0 ? ", " : "", values[k]);
  std::printf("};\n");
}

int print_coefficients(const std::string& path) {
  const std::vector<Rolled> all = read_rolled(path);
  const RollingFit fit = fit_rolling(all);
  const std::array<double, 2> errors = rolling_errors(all, fit);
  std::printf(
      "// SPDX-License-Identifier: GPL-3.0-or-later\n"
      "// Written by `relaxation_rolling coefficients rolling.csv` in validation/relaxation; the test "
      "\"validation:\n"
      "// relaxation rolling\" fits them again and compares. Not to be edited by hand.\n"
      "// clang-format off\n#pragma once\n\n#include <array>\n\n"
      "namespace granum::effective::kernel {\n\n"
      "template <class T>\nusing RollingShear = std::array<T, 5>;\n"
      "template <class T>\nusing RollingBulk = std::array<T, 3>;\n\n"
      "/// Coefficients of rolled_coupling and of left_of_bulk_loss.\n");
  print_numbers("rolling_shear", "RollingShear<double>", fit.shear.coefficients.data(), 5);
  print_numbers("rolling_bulk", "RollingBulk<double>", fit.bulk.coefficients.data(), 3);
  std::printf(
      "/// Errors of G and K of packings left out of the fit, over the root of the share of the modulus\n"
      "/// that rolling resistance makes.\n");
  print_numbers("rolling_errors", "std::array<double, 2>", errors.data(), 2);
  std::printf("\n} // namespace granum::effective::kernel\n");
  for (int k = 0; k < 8; ++k)
    std::fprintf(stderr, "standard error %.2g\n",
                 std::sqrt(k < 5 ? fit.shear.covariance(k, k) : fit.bulk.covariance(k - 5, k - 5)));
  return 0;
}

/// Gains of relaxed() beside those of the networks, and its stated errors of the moduli themselves.
struct RollingErrors {
  Errors G, K, G_vh, G_hh, gain;
  Coverage of_G, of_K;
};

template <class Choice>
RollingErrors rolling_errors_of_library(const std::vector<Rolled>& all, const Choice& chosen) {
  RollingErrors errors;
  for (const Rolled& one : all) {
    if (!chosen(one))
      continue;
    const auto before = effective::relaxed(one.state, one.z()),
               after = effective::relaxed(one.rolled(), one.z());
    const TransverselyIsotropic &c = after.stiffness, &c0 = before.stiffness;
    const double G = isotropic_shear_modulus(c), K = c.bulk_modulus();
    errors.G.add(std::log(G / isotropic_shear_modulus(c0)) - one.shear_gain());
    errors.K.add(std::log(K / c0.bulk_modulus()) - one.bulk_gain());
    errors.G_vh.add(std::log(c.G_vh() / c0.G_vh()) - std::log(one.with.G_vh() / one.without.G_vh()));
    errors.G_hh.add(std::log(c.G_hh() / c0.G_hh()) - std::log(one.with.G_hh() / one.without.G_hh()));
    errors.gain.add(one.shear_gain());
    errors.of_G.add(G / isotropic_shear_modulus(one.with) - 1, after.relative_error.G_vh);
    errors.of_K.add(K / one.with.bulk_modulus() - 1, after.relative_error.bulk_modulus);
  }
  return errors;
}

void print(const char* what, const RollingErrors& e) {
  std::printf(
      "%-34s %4d | gain of G %5.1f %% | error %% rms, worst: G %.1f, %.1f  K %.1f, %.1f  G_vh %.1f, %.1f  "
      "G_hh %.1f, %.1f | within one, two: G %3.0f, %3.0f %%  K %3.0f, %3.0f %%\n",
      what, e.G.count(), 100 * std::expm1(e.gain.mean()), 100 * e.G.rms(), 100 * e.G.worst(), 100 * e.K.rms(),
      100 * e.K.worst(), 100 * e.G_vh.rms(), 100 * e.G_vh.worst(), 100 * e.G_hh.rms(), 100 * e.G_hh.worst(),
      100 * e.of_G.one(), 100 * e.of_G.two(), 100 * e.of_K.one(), 100 * e.of_K.two());
}

int check(const std::string& path) {
  namespace kernel = effective::kernel;
  const std::vector<Rolled> all = read_rolled(path);
  const RollingFit fit = fit_rolling(all);
  const std::array<double, 2> stated = rolling_errors(all, fit);
  Claims claims;
  const auto same = [](const auto& a, const auto& b) {
    return std::equal(a.begin(), a.end(), b.begin(),
                      [](double x, double y) { return std::abs(x / y - 1) < 1e-5; });
  };
  claims.require(same(fit.shear.coefficients, kernel::rolling_shear) &&
                     same(fit.bulk.coefficients, kernel::rolling_bulk) &&
                     same(stated, kernel::rolling_errors),
                 "the library's coefficients are those of the record");
  const auto print_of = [&](const char* what, const auto& chosen) {
    const RollingErrors errors = rolling_errors_of_library(all, chosen);
    print(what, errors);
    return errors;
  };
  const auto ratio = [](const Rolled& one, double r) {
    return short_number(one.state.tangential_ratio) == short_number(r);
  };
  RollingErrors left;
  for (const double r : rolled_tangential_ratios) {
    const std::string at = ", k_t/k_n " + short_number(r);
    print_of(("fitted" + at).c_str(),
             [&](const Rolled& one) { return one.fitted && one.isotropic && ratio(one, r); });
    left = print_of(("left out" + at).c_str(),
                    [&](const Rolled& one) { return !one.fitted && one.isotropic && ratio(one, r); });
  }
  const double usual = rolled_tangential_ratios[2];
  for (const double k_r : rolling_ratios)
    if (k_r > 0)
      print_of(("  left out, k_r " + short_number(k_r)).c_str(), [&](const Rolled& one) {
        return !one.fitted && one.isotropic && ratio(one, usual) && one.k_r == k_r;
      });
  print_of("  left out, unequal grains", [&](const Rolled& one) {
    return !one.fitted && one.isotropic && ratio(one, usual) && one.state.contacts.branch != 1;
  });
  print_of("  loose (z* < 4.7), k_r 0.1", [&](const Rolled& one) {
    return one.isotropic && ratio(one, usual) && one.z() < 4.7 && one.k_r == 0.1;
  });
  const RollingErrors sheared = print_of(
      "sheared, never fitted", [&](const Rolled& one) { return !one.isotropic && ratio(one, usual); });
  claims.require(left.G.rms() < 0.02 && left.G.worst() < 0.06,
                 "left out: gain of G within 2 % rms, 6 % at worst");
  claims.require(left.K.rms() < 0.02, "left out: gain of K within 2 % rms");
  claims.require(sheared.G_vh.rms() < 0.02 && sheared.G_hh.rms() < 0.02,
                 "sheared: gains of G_vh and G_hh within 2 % rms");
  claims.require(left.of_G.one() >= 0.6 && left.of_G.two() >= 0.92, "left out: stated errors of G cover");
  claims.require(left.of_K.one() >= 0.6 && left.of_K.two() >= 0.92, "left out: stated errors of K cover");
  return claims.failed() == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  const std::string asked = argc >= 3 ? argv[1] : "";
  try {
    if (asked == "make")
      return make(argv[2], argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1);
    if (asked == "coefficients")
      return print_coefficients(argv[2]);
    if (asked == "check")
      return check(argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::fprintf(stderr, "usage: %s make rolling.csv [threads], or coefficients|check rolling.csv\n", argv[0]);
  return 2;
}
