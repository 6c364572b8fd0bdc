// SPDX-License-Identifier: GPL-3.0-or-later
// What the library states of z* above the densest packing of the same grains, on packings that were not
// fitted.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <granum/effective/contact_prior.hpp>

#include "../relaxation/gradations.hpp"
#include "densest.hpp"
#include "unfitted.hpp"

namespace contact_prior::densest {

struct Judged {
  Errors z, without; ///< with the densest packing known, and without
  Coverage of_z, of_without;
};

inline Judged judge(const std::vector<Packing>& all,
                    const std::function<bool(const relaxation::Packing&)>& chosen) {
  Judged judged;
  for (const Packing& a : all) {
    if (!chosen(a.packing))
      continue;
    granum::effective::State state = a.packing.state;
    state.coordination_number.reset();
    granum::effective::Preparation preparation{.kind = granum::effective::Preparation::Kind::friction,
                                               .friction_coefficient = a.packing.friction_coefficient};
    const auto z_at = [&](double densest_void_ratio) {
      preparation.densest_void_ratio = densest_void_ratio;
      return granum::effective::contact_prior(state, preparation);
    };
    const auto add = [&](double e, Errors& errors, Coverage& coverage) {
      const auto prior = z_at(e);
      const double off = prior.middle.mechanical_coordination_number - a.packing.mechanical_coordination;
      const double d = e > 0 ? a.densest_deviation : 0; // felt as an uncertain input is
      const double felt = (z_at(e + d).middle.mechanical_coordination_number -
                           z_at(e - d).middle.mechanical_coordination_number) /
                          2;
      errors.add(off);
      coverage.add(off, std::hypot(prior.coordination_error, felt));
    };
    add(0, judged.without, judged.of_without);
    preparation.pressure = std::min(a.densest.state.mean_stress(), state.mean_stress());
    add(a.densest.state.void_ratio, judged.z, judged.of_z);
  }
  return judged;
}

/// A line for each kind, and one for all.
inline std::map<std::string, Judged>
judge_each(const std::string& what, const std::vector<Packing>& all,
           const std::function<std::string(const relaxation::Packing&)>& kind_of) {
  std::map<std::string, Judged> kinds;
  for (const Packing& a : all)
    kinds[kind_of(a.packing)];
  for (auto& [kind, judged] : kinds)
    judged = judge(all, [&, name = kind](const relaxation::Packing& p) { return kind_of(p) == name; });
  kinds["together"] = judge(all, [](const relaxation::Packing&) { return true; });
  for (const auto& [kind, j] : kinds)
    std::printf("  %-34s %4d | z* rms %.3f mean %+.3f, within one %3.0f %% two %3.0f %% | by e alone rms "
                "%.3f, %3.0f %% %3.0f %%\n",
                (what + ", " + kind).c_str(), j.z.count(), j.z.rms(), j.z.mean(), 100 * j.of_z.one(),
                100 * j.of_z.two(), j.without.rms(), 100 * j.of_without.one(), 100 * j.of_without.two());
  return kinds;
}

/// Loose packings of verify with the mean void ratio of the densest ones of their shape, as if their own were
/// not known, and how far those differ.
inline std::vector<Packing> above_mean(const std::vector<relaxation::Packing>& packings) {
  std::map<std::string, std::vector<const relaxation::Packing*>> densest;
  for (const relaxation::Packing& p : packings)
    if (without_friction(p) && p.pressure == 10e3)
      densest[p.contact].push_back(&p);
  std::vector<Packing> all;
  for (const relaxation::Packing& p : packings) {
    if (without_friction(p) || !usable(p))
      continue;
    const auto& of_shape = densest.at(p.contact);
    const double n = static_cast<double>(of_shape.size());
    double sum = 0, squares = 0;
    for (const relaxation::Packing* d : of_shape)
      sum += d->state.void_ratio;
    for (const relaxation::Packing* d : of_shape)
      squares += std::pow(d->state.void_ratio - sum / n, 2);
    all.push_back(
        {.packing = p, .densest = *of_shape.front(), .densest_deviation = std::sqrt(squares / (n - 1))});
    all.back().densest.state.void_ratio = sum / n;
  }
  return all;
}

struct Unfitted {
  std::string third_seed, gradations;
  std::array<std::string, 2> verify;
};

inline void check(const Files& files, const Unfitted& unfitted, Claims& claims) {
  const auto shape = [](const relaxation::Packing& p) {
    return p.contact + (from_gas(p) ? ", from a gas" : ", opened");
  };
  const auto sizes = [](const relaxation::Packing& p) { return p.sizes; };
  const auto code = [](const relaxation::Packing& p) { return code_of(p) + " " + p.sizes; };
  std::printf("above the densest packing of the same grains: fitted ones\n");
  judge_each("states", files.equal, shape);
  judge_each("unequal", files.unequal, sizes);
  judge_each("codes", files.codes, code);
  std::printf("ones that were not fitted\n");
  judge_each("second seed", files.codes_left, code);
  for (const auto& [what, all, kind] :
       {std::tuple{"third seed", above_densest(relaxation::read_packings(unfitted.third_seed)), +shape},
        std::tuple{"gradations", above_densest(relaxation::read_gradations(unfitted.gradations)), +sizes}}) {
    const Judged together = judge_each(what, all, kind).at("together");
    claims.require(together.of_z.one() >= 0.55 && together.of_z.two() >= 0.9,
                   std::string(what) + ", above the densest packing: 55 % within one, 90 % within two");
  }
  for (const std::string& path : unfitted.verify) {
    const std::vector<relaxation::Packing> packings = relaxation::read_verify_states(path);
    const auto contact = [](const relaxation::Packing& p) { return p.contact; };
    for (const auto& [what, all] : {std::pair{"verify", above_densest(packings)},
                                    std::pair{"verify, mean densest", above_mean(packings)}})
      for (const auto& [kind, j] : judge_each(what, all, contact))
        claims.require(j.of_z.one() >= 0.5 && j.of_z.two() >= 0.88,
                       std::string(what) + ", " + kind + ": 50 % within one stated error, 88 % within two");
  }
}

} // namespace contact_prior::densest
