// SPDX-License-Identifier: GPL-3.0-or-later
// Random states at the extremes of what the closed forms take, held against what must be true of any state:
//   attack_random_states <states> <seed>
// Exit code 1, with the first states that broke a promise, if any did.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/effective/batch.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>

#include "questions.hpp"
#include "samples.hpp"

namespace {

using namespace granum;
using attack::Random;
using attack::Sample;
using elastic::TransverselyIsotropic;

std::array<double, 5> constants(const TransverselyIsotropic& c) {
  return {c.C11, c.C33, c.C12, c.C13, c.C44};
}

double largest(const TransverselyIsotropic& c) {
  double most = 0;
  for (const double value : constants(c))
    most = std::max(most, std::abs(value));
  return most;
}

/// All constants within `relative` of the largest one.
bool near(const TransverselyIsotropic& a, const TransverselyIsotropic& b, double factor, double relative) {
  const double scale = relative * std::max(largest(a), factor * largest(b));
  const auto x = constants(a), y = constants(b);
  for (std::size_t k = 0; k < x.size(); ++k)
    if (!(std::abs(x[k] - factor * y[k]) <= scale))
      return false;
  return true;
}

bool finite(const TransverselyIsotropic& c) {
  const auto values = constants(c);
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Whether no strain costs more energy in `soft` than in `stiff`, but for rounding.
bool not_stiffer(const TransverselyIsotropic& soft, const TransverselyIsotropic& stiff, double relative) {
  const double slack = relative * largest(stiff);
  const double c11 = stiff.C11 - soft.C11, c12 = stiff.C12 - soft.C12, c13 = stiff.C13 - soft.C13,
               c33 = stiff.C33 - soft.C33;
  // Of the strains (u, u, 0)/sqrt(2) and (0, 0, y): (c11 + c12) u^2 + 2 sqrt(2) c13 u y + c33 y^2.
  const double a = c11 + c12, b = std::sqrt(2.0) * c13, d = c33;
  const double lowest = (a + d) / 2 - std::hypot((a - d) / 2, b);
  return stiff.C44 - soft.C44 >= -slack && (c11 - c12) / 2 >= -slack && lowest >= -slack;
}

bool is_density(const effective::State& state) { return std::abs(state.fabric_anisotropy) <= 1; }

class Attack {
 public:
  explicit Attack(std::uint64_t seed) : random_(seed), questions_(~seed) {}

  void one() {
    const Sample s = attack::sample(random_);
    ++states_;
    here_ = &s;
    asked_.clear();
    try {
      (void)effective::require_valid(s.state);
    } catch (const InvalidArgument&) {
      ++refused_;
      return;
    }
    guarded("closed forms", [&] { check(s); });
    guarded("exponents", [&] { check_exponents(s); });
    guarded("relaxed", [&] { check_relaxed(s); });
    ask(s);
  }

  /// A batch at the extremes; that its rows are those of single states: tests/effective/test_batch.cpp.
  void batch() {
    const double radius = random_.decades(-9, 3);
    const contact::PowerLaw law = contact::PowerLaw::sphere({random_.decades(3, 13), 0.2}, radius);
    const std::size_t rows = 1 + random_.below(70);
    std::vector<double> p, c, n, moduli(2 * rows);
    for (std::size_t k = 0; k < rows; ++k) {
      p.push_back(random_.one_in(9) ? -1 : random_.decades(-20, 20));
      c.push_back(random_.decades(-3, 3));
      n.push_back(random_.between(0, 1));
    }
    const std::span all(moduli);
    (void)effective::uniform_strain({law, 0.9, radius, p, c, n}, {all.first(rows), all.last(rows)});
    here_ = nullptr;
    for (const double value : moduli)
      demand(std::isfinite(value) && value >= 0, "a batch holds what is no modulus");
  }

  [[nodiscard]] int report() const {
    std::printf("%zu states, %zu of them refused; %zu questions answered, %zu refused\n", states_, refused_,
                answered_, asked_in_vain_);
    const bool enough = 2 * refused_ < states_ && asked_in_vain_ < answered_;
    return promises_.report() && enough ? 0 : 1;
  }

 private:
  void check(const Sample& s) {
    const effective::State& state = s.state;
    const TransverselyIsotropic strain = effective::uniform_strain(state).stiffness;
    const TransverselyIsotropic spin = effective::free_spin(state).stiffness;
    const TransverselyIsotropic stress = effective::uniform_stress(state).stiffness;
    const double b = state.law.constant_exponent().value();
    demand(finite(strain) && finite(spin) && finite(stress), "a constant is not finite");
    if (is_density(state))
      demand(not_stiffer({}, strain, 1e-11), "a strain under uniform strain gives work back");
    demand(not_stiffer(spin, strain, 1e-11), "free spin is stiffer than none");
    // The forces of the static hypothesis are admissible, those of free spin the best of these, where the
    // fabric is a density. Digits that cancel at small k_t/k_n are not what is asked for here.
    if (is_density(state) && (state.tangential_ratio == 0 || state.tangential_ratio > 1e-4))
      demand(not_stiffer(stress, spin, 1e-9), "uniform stress is stiffer than uniform strain");

    constexpr double length = 1e-7, pressure = 3e5;
    effective::State other = state;
    other.law = s.law.in_units(state.radius, length, pressure);
    other.radius *= length;
    other.stress_v *= pressure;
    other.stress_h *= pressure;
    demand(near(effective::uniform_strain(other).stiffness, strain, pressure, 1e-10), "other units, strain");
    demand(near(effective::free_spin(other).stiffness, spin, pressure, 1e-10), "other units, free spin");
    if (state.tangential_ratio == 0 || state.tangential_ratio > 1e-4)
      demand(near(effective::uniform_stress(other).stiffness, stress, pressure, 1e-9), "other units, stress");

    other = state;
    other.stress_v *= 0x1p20;
    other.stress_h *= 0x1p20;
    demand(near(effective::uniform_strain(other).stiffness, strain, std::exp2(20 * b), 1e-11),
           "moduli are no power of the stresses");

    other = state;
    *other.coordination_number *= 2;
    demand(near(effective::uniform_strain(other).stiffness, strain, std::exp2(1 - b), 1e-11),
           "twice the contacts do not stiffen as they must");

    if (state.fabric_anisotropy == 0 && state.stress_v == state.stress_h)
      for (const TransverselyIsotropic& c : {strain, spin, stress}) {
        const TransverselyIsotropic turned{
            .C11 = c.C33, .C33 = c.C11, .C12 = c.C13, .C13 = c.C12, .C44 = c.C66()};
        demand(near(turned, c, 1, 1e-11), "axes that are alike differ");
      }
  }

  void check_exponents(const Sample& s) {
    using enum effective::Modulus;
    if (s.state.stress_v == 0 || s.state.coordination_number == 0)
      return;
    const double b = s.state.law.constant_exponent().value();
    for (const effective::Modulus which : {K, G_hh, G_vh, C11, C33}) {
      const double sum = effective::uniform_strain_exponents(s.state, which).sum();
      demand(std::abs(sum - b) <= 1e-10, "exponents do not add up to s");
    }
  }

  void check_relaxed(const Sample& s) {
    const TransverselyIsotropic strain = effective::uniform_strain(s.state).stiffness;
    const effective::RelaxedEstimate relaxed = effective::relaxed(s.state, s.mechanical);
    const effective::RelaxedEstimate more = effective::relaxed(s.state, 1.25 * s.mechanical);
    demand(finite(relaxed.stiffness) && finite(more.stiffness), "a relaxed constant is not finite");
    demand(relaxed.stiffness.bulk_modulus() >= 0 && relaxed.stiffness.C44 >= 0,
           "a relaxed modulus is negative");
    const effective::Relaxation h = effective::relaxation(s.mechanical, s.state.tangential_ratio,
                                                          s.state.law.constant_exponent().value());
    const effective::Relaxation h_more = effective::relaxation(1.25 * s.mechanical, s.state.tangential_ratio,
                                                               s.state.law.constant_exponent().value());
    demand(h.shear.value >= 0 && h.shear.value <= 1 + 1e-13, "a factor of G is outside [0, 1]");
    demand(h.bulk.value >= 0 && h.bulk.value <= 1 + 1e-13, "a factor of K is outside [0, 1]");
    demand(h_more.shear.value >= h.shear.value * (1 - 1e-13), "more contacts relax G further");
    if (is_density(s.state))
      demand(relaxed.stiffness.bulk_modulus() <= strain.bulk_modulus() * (1 + 1e-11),
             "relaxed K is above uniform strain");
    if (s.state.fabric_anisotropy == 0 && s.state.stress_v == s.state.stress_h)
      demand(not_stiffer(relaxed.stiffness, strain, 1e-11), "relaxed is stiffer than uniform strain");
  }

  /// A question that begins with this state; what no packing can have may be refused.
  void ask(const Sample& s) {
    const attack::RandomQuestion asked = attack::random_question(questions_, s);
    asked_ = asked.text;
    try {
      attack::check_answer(asked, [&](bool holds, const std::string& promise) { demand(holds, promise); });
      ++answered_;
    } catch (const InvalidArgument&) {
      ++asked_in_vain_;
    } catch (const std::exception& error) {
      demand(false, "a question ends in: " + std::string(error.what()).substr(0, 60));
    }
  }

  template <class Work>
  void guarded(const std::string& what, const Work& work) {
    try {
      work();
    } catch (const std::exception& error) {
      demand(false, what + ": refused a valid state: " + std::string(error.what()).substr(0, 60));
    }
  }

  void demand(bool holds, const std::string& relation) { promises_.demand(holds, relation); }

  [[nodiscard]] std::string here() const {
    if (here_ == nullptr)
      return {};
    const effective::State& s = here_->state;
    const std::pair<const char*, double> numbers[] = {{"G", here_->law.grain.shear_modulus},
                                                      {"nu", here_->law.grain.poisson_ratio},
                                                      {"shape", here_->law.shape},
                                                      {"alpha", here_->law.alpha},
                                                      {"number", here_->law.number},
                                                      {"k_t/k_n", s.tangential_ratio},
                                                      {"R", s.radius},
                                                      {"e", s.void_ratio},
                                                      {"C_n", *s.coordination_number},
                                                      {"a", s.fabric_anisotropy},
                                                      {"stress_v", s.stress_v},
                                                      {"stress_h", s.stress_h},
                                                      {"z*", here_->mechanical}};
    std::string text;
    for (const auto& [name, value] : numbers)
      text += std::string(name) + " " + exact_text(value) + " ";
    return text + asked_;
  }

  Random random_, questions_;
  const Sample* here_ = nullptr;
  std::string asked_; ///< of the question that is checked
  std::size_t states_ = 0, refused_ = 0, answered_ = 0, asked_in_vain_ = 0;
  attack::Promises promises_{stdout, [this] { return here(); }};
};

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s <states> <seed>\n", argv[0]);
    return 2;
  }
  Attack attack(std::strtoull(argv[2], nullptr, 10));
  const std::uint64_t states = std::strtoull(argv[1], nullptr, 10);
  for (std::uint64_t k = 0; k < states; ++k) {
    attack.one();
    if (k % 50 == 0)
      attack.batch();
  }
  return attack.report();
}
