// SPDX-License-Identifier: GPL-3.0-or-later
#include "soft_first.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "elimination.hpp"
#include "fill_pattern.hpp"

namespace granum::network {

namespace {

// Level of fill of the factor that finds soft motions. They depend little on it, and 1 takes a fifth of the
// time of 3.
constexpr int level_of_search = 1;
// Renumberings with grains of lost pivots first: packings of a million grains need one or two.
constexpr int most_tries = 3;
// Lost pivots that are accepted: one or two cost hardly an iteration, with 30 a packing was not solved.
constexpr std::size_t few = 5;

template <int Dof>
std::vector<std::uint32_t> soft_grains(const Backbone& backbone, FactorRule rule, const Workers& workers) {
  rule.fill_level = level_of_search;
  return eliminate<Dof>(backbone, workers, rule, fill_pattern(backbone, rule.fill_level)).soft_grains;
}

} // namespace

template <int Dof>
IncompleteFactor<Dof> factor_with_soft_first(const packing::Assembly& assembly,
                                             const ResponseOptions& options, FactorRule rule,
                                             const Workers& workers, Backbone& backbone) {
  std::vector<bool> first(assembly.grain_count());
  const auto add = [&](const std::vector<std::uint32_t>& grains) {
    bool more = false;
    for (const std::uint32_t g : grains)
      if (const std::uint32_t of_assembly = backbone.grain[g]; !first[of_assembly])
        first[of_assembly] = more = true;
    return more;
  };
  if (add(soft_grains<Dof>(backbone, rule, workers)))
    backbone = load_bearing_network(assembly, options, first);
  for (int tries = 0;; ++tries) {
    bool more = false;
    {
      IncompleteFactor<Dof> factor(backbone, workers, rule);
      more = tries < most_tries && add(factor.lost_grains());
      const bool good = factor.mended_pivots() <= few || rule.soft_pivots == SoftPivots::coupled;
      if ((!more && good) || is_stopped(options.stop_requested))
        return factor;
    } // frees the memory of the factor
    if (more) {
      backbone = load_bearing_network(assembly, options, first);
    } else {
      rule.soft_pivots = SoftPivots::coupled;
      tries = 0;
    }
  }
}

template IncompleteFactor<3> factor_with_soft_first(const packing::Assembly&, const ResponseOptions&,
                                                    FactorRule, const Workers&, Backbone&);
template IncompleteFactor<6> factor_with_soft_first(const packing::Assembly&, const ResponseOptions&,
                                                    FactorRule, const Workers&, Backbone&);

} // namespace granum::network
