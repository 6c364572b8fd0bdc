// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/mixture.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>

#include "core/root.hpp"
#include "mixture_kernel.hpp"

namespace granum::effective {

namespace {

constexpr double rounding = 1e-6; // of shares that add up to 1

void require_sum_of_one(const char* name, double sum) {
  if (!(std::abs(sum - 1) <= rounding))
    throw InvalidArgument(name, sum, "", "1 +- 1e-6");
}

/// Pairs of the same material are one.
std::vector<MaterialPair> gathered(std::span<const MaterialPair> pairs) {
  struct Sum {
    double weight = 0, force = 0;
  };
  std::map<std::pair<double, double>, Sum> sums;
  for (const MaterialPair& pair : pairs) {
    const double weight = require_non_negative("weight", pair.weight);
    if (weight == 0)
      continue;
    Sum& sum = sums[{pair.material.shear_modulus, pair.material.poisson_ratio}];
    sum.weight += weight;
    sum.force += weight * require_non_negative("force", pair.force);
  }
  if (sums.empty())
    throw InvalidArgument("mixed_contacts: there are no contacts");
  std::vector<MaterialPair> kinds;
  for (const auto& [material, sum] : sums)
    kinds.push_back({.material = {.shear_modulus = material.first, .poisson_ratio = material.second},
                     .weight = sum.weight,
                     .force = sum.force / sum.weight});
  return kinds;
}

} // namespace

double relative_stiffness(const contact::GrainMaterial& pair, const contact::GrainMaterial& over,
                          double stiffness_exponent) {
  const double moduli =
      pair.shear_modulus / over.shear_modulus * ((1 - over.poisson_ratio) / (1 - pair.poisson_ratio));
  return std::pow(moduli, 1 - stiffness_exponent);
}

MixedContacts mixed_contacts(std::span<const MaterialPair> pairs, double stiffness_exponent) {
  const double power = 1 - require_closed("stiffness_exponent", stiffness_exponent, 0, 1);
  require_positive("1 - stiffness_exponent", power);
  const std::vector<MaterialPair> kinds = gathered(pairs);
  if (kinds.size() == 1)
    return {.mean = kinds.front().material, .pair_shares = {}};
  const contact::GrainMaterial& first = kinds.front().material;
  double weight = 0, force = 0, stiffness = 0, ratio = 0;
  for (const MaterialPair& kind : kinds) {
    require_positive("grain_shear_modulus", kind.material.shear_modulus, "Pa");
    weight += kind.weight;
    force += kind.weight * kind.force;
    stiffness += kind.weight * relative_stiffness(kind.material, first, stiffness_exponent);
    ratio += kind.weight * contact::mindlin_stiffness_ratio(kind.material.poisson_ratio);
  }
  force /= weight;
  stiffness /= weight;
  const double r = ratio / weight, nu = (2 - 2 * r) / (2 - r); // k_t/k_n = 2(1-nu)/(2-nu)
  const double modulus = first.shear_modulus * (1 - nu) / (1 - first.poisson_ratio);
  MixedContacts mixed{
      .mean = {.shear_modulus = modulus * std::pow(stiffness, 1 / power), .poisson_ratio = nu},
      .pair_shares = {}};
  for (const MaterialPair& kind : kinds)
    mixed.pair_shares.push_back(
        {.share = kind.weight / weight,
         .stiffness = relative_stiffness(kind.material, first, stiffness_exponent) / stiffness,
         .force = force > 0 ? kind.force / force : 1});
  return mixed;
}

MixedContacts mixed_contacts(std::span<const contact::GrainMaterial> materials,
                             std::span<const double> shares, double stiffness_exponent) {
  if (materials.size() != shares.size())
    throw InvalidArgument("mixed_contacts: there must be one share for each material");
  require_sum_of_one("sum of the shares", std::accumulate(shares.begin(), shares.end(), 0.0));
  std::vector<MaterialPair> pairs;
  for (std::size_t i = 0; i < materials.size(); ++i)
    for (std::size_t j = 0; j < materials.size(); ++j)
      pairs.push_back({.material = contact::pair_material(materials[i], materials[j]),
                       .weight = require_non_negative("share", shares[i]) * shares[j]});
  return mixed_contacts(pairs, stiffness_exponent);
}

void require_valid(std::span<const PairShare> kinds) {
  if (kinds.empty())
    return;
  double shares = 0;
  for (const PairShare& kind : kinds) {
    shares += require_non_negative("share of the contacts", kind.share);
    require_positive("stiffness of a kind of contacts", kind.stiffness);
    require_non_negative("force of a kind of contacts", kind.force);
  }
  require_sum_of_one("sum of the shares of the contacts", shares);
}

double effective_stiffness(std::span<const PairShare> kinds, double exchange) {
  require_valid(kinds);
  return kernel::medium_of(kinds, require_closed("exchange", exchange, 0, 1)).stiffness;
}

namespace kernel {

void require_relative(std::span<const PairShare> kinds) {
  require_valid(kinds);
  double mean = 0;
  for (const PairShare& kind : kinds)
    mean += kind.share * kind.stiffness;
  require_sum_of_one("mean stiffness of the kinds of contacts", mean);
}

Medium medium_of(std::span<const PairShare> kinds, double exchange) {
  if (kinds.empty())
    return {.stiffness = 1, .by_exchange = 0};
  const auto [softest, stiffest] =
      std::minmax_element(kinds.begin(), kinds.end(),
                          [](const PairShare& a, const PairShare& b) { return a.stiffness < b.stiffness; });
  const auto excess = [&](double k) {
    double sum = 0;
    for (const PairShare& kind : kinds)
      sum += kind.share * (kind.stiffness - k) / ((1 - exchange) * k + exchange * kind.stiffness);
    return sum;
  };
  const double low = softest->stiffness, high = stiffest->stiffness;
  if (!(low < high))
    return {.stiffness = low, .by_exchange = 0};
  const double k = middle(root_between(excess, low, high, within_bits(52)));
  double by_stiffness = 0, by_exchange = 0; // of the sum
  for (const PairShare& kind : kinds) {
    const double below = (1 - exchange) * k + exchange * kind.stiffness, difference = kind.stiffness - k,
                 scaled = kind.share / (below * below);
    by_stiffness -= scaled * kind.stiffness;
    by_exchange -= scaled * difference * difference;
  }
  return {.stiffness = k, .by_exchange = -by_exchange / by_stiffness};
}

double stiffness_of_forces(std::span<const PairShare> kinds) {
  double work = 0, compliance = 0;
  for (const PairShare& kind : kinds) {
    work += kind.share * kind.force;
    compliance += kind.share * (kind.force * kind.force / kind.stiffness);
  }
  return compliance > 0 ? work * work / compliance : 0;
}

Mixed left_by_mixing(std::span<const PairShare> kinds, double z, const Mixing& mixing) {
  if (kinds.empty())
    return {};
  const double exchange = exchange_at(z, mixing), slope = exchange < 1 ? -mixing.power * exchange / z : 0;
  const Medium medium = medium_of(kinds, exchange);
  const double bound = mixing.by_forces ? stiffness_of_forces(kinds) : 0;
  if (bound > medium.stiffness)
    return {.left = bound, .by_coordination = 0};
  return {.left = medium.stiffness, .by_coordination = medium.by_exchange * slope};
}

} // namespace kernel

} // namespace granum::effective
