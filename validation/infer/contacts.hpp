// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts implied by V_s and V_p at four pressures, compared with those of own packings.
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <granum/core/error.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/inverse/inference.hpp>

#include "../common.hpp"
#include "packings.hpp"

namespace implied {

using namespace infer_packings;
using granum::Measured;
using granum::inverse::Observation;
using granum::inverse::Quantity;

constexpr double reading_error = 0.015; ///< of a speed
constexpr int draws = 6;                ///< of noise for each specimen
constexpr double first_pressure = 50e3; ///< [Pa]: the packings just made at 10 kPa are not used

/// Errors of one number of many specimens, and how often it is determined.
struct Judged {
  Errors error;
  int determined = 0;

  void add(const Judged& more) {
    error.add(more.error);
    determined += more.determined;
  }
};
inline Judged judged(double off, double stated, bool is_determined) {
  Judged one{.error = {}, .determined = is_determined};
  one.error.add(off, stated);
  return one;
}

/// z*, ln k_n at the true mean force of the first pressure, and alpha or u0 [nm].
struct Numbers {
  Judged z = {}, stiffness = {}, shape = {};
  int refused = 0; ///< least squares that did not converge

  void add(const Numbers& more) {
    refused += more.refused;
    z.add(more.z);
    stiffness.add(more.stiffness);
    shape.add(more.shape);
  }
};

/// V_s, and V_p if wanted, of a specimen at its pressures from first_pressure on, each off by noise.
/// \param    error   relative standard deviation
inline std::vector<Observation> speeds(const std::vector<const Packing*>& specimen, bool both, double error,
                                       boost::random::mt19937& random) {
  boost::random::normal_distribution<double> noise(0, error);
  std::vector<Observation> all;
  for (const Packing* p : specimen) {
    State state = p->state;
    state.law = law_of("sphere");
    state.coordination_number.reset();
    const double density = grain_density / (1 + state.void_ratio);
    const auto add = [&](Quantity quantity, double modulus) {
      const double speed = std::sqrt(modulus / density) * (1 + noise(random));
      all.push_back({quantity, {speed, reading_error * speed}, state});
    };
    add(Quantity::V_s, p->shear_modulus);
    if (both)
      add(Quantity::V_p, p->bulk_modulus + 4 * p->shear_modulus / 3);
  }
  return all;
}

/// Empty where the least squares do not converge.
inline std::optional<granum::inverse::ImpliedContacts> ask(const std::vector<Observation>& known,
                                                           const char* contacts) {
  try {
    const auto answer = granum::inverse::infer(
        known, {.grain_density = grain_density, .contacts = granum::inverse::unknown_contacts(contacts)});
    return answer.together.value().contacts();
  } catch (const granum::NotConverged&) {
    return std::nullopt;
  }
}

/// The standard error of ln k_n at a force, by that of the roughness alone.
inline double stiffness_error(const granum::inverse::ImpliedNumber& roughness, double force) {
  const auto log_stiffness = [force](double u) {
    return std::log(granum::contact::RoughSphere(quartz, radius, u).stiffness_at_force(force));
  };
  const double u = roughness.value.value, step = 0.01;
  const double slope = (log_stiffness(u * (1 + step)) - log_stiffness(u * (1 - step))) / (2 * step);
  return std::abs(slope) * roughness.value.standard_error / u;
}

/// \param    first   the packing at the first pressure
inline Numbers judged(const Packing& first, const granum::inverse::ImpliedContacts& found, bool rough) {
  const auto &z = found.numbers[0], &shape = found.numbers.back();
  const auto& stiffness = found.numbers[1]; // u0, or softness
  const double force = granum::effective::mean_contact_force(first.state), unit = rough ? 1e9 : 1;
  const double true_shape =
      rough ? (first.contact == "rough" ? roughness : 0) : (first.contact == "sphere" ? 2 : alpha);
  return {
      .z = judged(z.value.value - first.mechanical_coordination, z.value.standard_error, z.determined()),
      .stiffness = judged(
          std::log(found.law->stiffness_at_force(force) / first.state.law.stiffness_at_force(force)),
          rough ? stiffness_error(stiffness, force) : stiffness.value.standard_error / stiffness.value.value,
          stiffness.determined()),
      .shape = judged((shape.value.value - true_shape) * unit, shape.value.standard_error * unit,
                      shape.determined())};
}

inline void print(const std::string& name, const Numbers& n) {
  std::printf("  %-30s %4d", name.c_str(), n.z.error.count());
  for (const Judged* one : {&n.z, &n.stiffness, &n.shape})
    std::printf(" | %5.3f %+6.3f %3.0f %3.0f %% %3.0f %%", one->error.rms(), one->error.mean(),
                100 * one->error.one(), 100 * one->error.two(),
                100.0 * one->determined / std::max(1, one->error.count()));
  if (n.refused > 0)
    std::printf(" | %d did not converge", n.refused);
  std::printf("\n");
}

/// The pressures of each specimen from the first one on.
inline std::map<std::string, std::vector<const Packing*>> specimens_of(const std::vector<Packing>& all,
                                                                       const std::string& contact) {
  std::map<std::string, std::vector<const Packing*>> specimens;
  for (const Packing& p : all)
    if (p.contact == contact && p.state.mean_stress() >= first_pressure)
      specimens[p.specimen()].push_back(&p);
  return specimens;
}

/// All specimens of one kind of contacts, by recipe and together.
inline Numbers try_out(const std::vector<Packing>& all, const std::string& contact, const char* asked,
                       bool both) {
  boost::random::mt19937 random(1);
  std::map<std::string, Numbers> by_recipe;
  Numbers together;
  for (const auto& [name, specimen] : specimens_of(all, contact))
    for (int draw = 0; draw < draws; ++draw) {
      const auto found = ask(speeds(specimen, both, reading_error, random), asked);
      const Numbers one =
          found ? judged(*specimen.front(), *found, asked == std::string("rough")) : Numbers{.refused = 1};
      by_recipe[specimen.front()->recipe].add(one);
      together.add(one);
    }
  const std::string title = contact + " as " + asked + (both ? "" : ", V_s alone");
  print(title, together);
  for (const auto& [recipe, numbers] : by_recipe)
    print("- " + recipe, numbers);
  return together;
}

inline void judge(const std::string& path, Claims& claims) {
  const std::vector<Packing> all = read(path);
  std::printf("contacts by V_s and V_p at 50, 100, 200 and 400 kPa, each speed off by 1.5 %%:\n"
              "rms, mean, within one stated error, within two, determined\n"
              "  contacts, as what              number | z* | ln k_n | alpha, or u0 [nm]\n");
  const Numbers sphere = try_out(all, "sphere", "power-law", true),
                power_law = try_out(all, "power-law", "power-law", true),
                rough = try_out(all, "rough", "rough", true);
  (void)try_out(all, "sphere", "rough", true); // u0 of smooth spheres: the prior allows no 0
  const Numbers alone = try_out(all, "power-law", "power-law", false);
  Numbers laws = sphere;
  laws.add(power_law);
  print("both as power-law", laws);
  const auto covered = [](const Judged& one) {
    return one.error.one() >= 0.6 && one.error.one() <= 0.75 && one.error.two() >= 0.92;
  };
  const std::string coverage = ": 60 to 75 % within one stated error, 92 % within two";
  claims.require(covered(laws.z), "z* of power laws" + coverage);
  Claims::aim(covered(laws.stiffness), "k_n of power laws" + coverage);
  Claims::aim(covered(laws.shape), "alpha" + coverage); // loose spheres gain contacts faster than the law
  claims.require(covered(rough.z), "z* of rough spheres" + coverage);
  claims.require(covered(rough.stiffness), "k_n of rough spheres" + coverage);
  claims.require(covered(rough.shape), "u0" + coverage);
  Claims::aim(laws.z.error.rms() < 0.15, "z* of power laws: rms 0.15"); // dense: K/G hardly depends on z*
  claims.require(rough.z.error.rms() < 0.15, "z* of rough spheres: rms 0.15");
  claims.require(laws.stiffness.error.rms() < 0.08 && rough.stiffness.error.rms() < 0.08, "k_n: rms 8 %");
  Claims::aim(laws.shape.error.rms() < 0.2, "alpha: rms 0.2");
  claims.require(alone.shape.determined == 0, "V_s alone determines no alpha");
  claims.require(laws.refused + rough.refused <= 0.01 * (laws.z.error.count() + rough.z.error.count()),
                 "99 % of the fits converge");
}

} // namespace implied
