// SPDX-License-Identifier: GPL-3.0-or-later
#include "incomplete_factor.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <granum/core/stop.hpp>

#include "core/vector/level.hpp"
#include "elimination.hpp"
#include "substitution.hpp"

namespace granum::network {

namespace {

// Springs per unknown below which a network is hardly rigid (loose packings 1.1, dense 1.5). With level 1 it
// loses the sign of pivots: 400,000 loose grains take more than 1400 iterations, with level 3 102. Dense ones
// gain no time by level 3.
constexpr double hardly_rigid = 1.3;
// Springs per unknown below which a network is treated as floppy: more fill makes pivots of free modes nearly
// zero, and their inverses amplify rounding. With level 3, 16 of 368 random networks fail, with level 1 two.
constexpr double floppy = 1.08;
// Least number of grains for which a hardly rigid network gains time by SoftPivots::by_motion: soft motions
// and lost pivots grow in number with it.
constexpr std::size_t many_grains = 20000;

/// Springs per unknown. A contact is three springs, or one in networks without tangential stiffness.
double rigidity(const Backbone& backbone) {
  const auto contacts = static_cast<double>(backbone.links.size() + backbone.wall_links.size());
  return contacts * (backbone.rotations ? 3 : 1) /
         (static_cast<double>(backbone.grain_count) * (backbone.rotations ? 6 : 3));
}

std::vector<FactorRule> chosen_rules(const Backbone& backbone) {
  const double springs = rigidity(backbone);
  if (springs < floppy)
    return {{.fill_level = 1, .soft_pivots = SoftPivots::stiffened}};
  if (springs >= hardly_rigid)
    return {{.fill_level = 1}};
  if (backbone.grain_count < many_grains)
    return {{.fill_level = 3}};
  return {{.fill_level = 3, .shift = 1e-12, .soft_pivots = SoftPivots::by_motion},
          {.fill_level = 3, .shift = 1e-12, .soft_pivots = SoftPivots::coupled},
          {.fill_level = 3}};
}

// A further level has about 1.8 times as many blocks; a level that is certainly too large is not tried.
constexpr double least_growth = 1.6;

/// A grain eliminated later, and the level of its coupling.
struct Later {
  std::uint32_t grain;
  int level;
};

/// Keeps each grain once, with its least level.
void keep_least(std::vector<Later>& list) {
  std::sort(list.begin(), list.end(), [](const Later& x, const Later& y) {
    return std::pair(x.grain, x.level) < std::pair(y.grain, y.level);
  });
  list.erase(std::unique(list.begin(), list.end(),
                         [](const Later& x, const Later& y) { return x.grain == y.grain; }),
             list.end());
}

} // namespace

std::vector<FactorRule> factor_rules(const Backbone& backbone) {
  std::vector<FactorRule> rules = chosen_rules(backbone);
  for (const FactorRule& other :
       {FactorRule{.fill_level = 2}, FactorRule{.fill_level = 3, .shift = 1e-4}, FactorRule{.fill_level = 1}})
    if (std::find(rules.begin(), rules.end(), other) == rules.end())
      rules.push_back(other);
  return rules;
}

FillPattern fill_pattern(const Backbone& backbone, int most_level) {
  std::vector<std::vector<Later>> couplings(backbone.grain_count);
  std::vector<std::vector<std::uint32_t>> rows(backbone.grain_count);
  for (const Link& l : backbone.links)
    couplings[l.a].push_back({l.b, 0});
  for (std::uint32_t j = 0; j < backbone.grain_count; ++j) {
    stop_point(j);
    keep_least(couplings[j]);
    const std::vector<Later> later = std::exchange(couplings[j], {});
    for (const Later& k : later) {
      rows[k.grain].push_back(j);
      for (const Later& i : later)
        if (const int level = k.level + i.level + 1; k.grain < i.grain && level <= most_level)
          couplings[k.grain].push_back({i.grain, level});
    }
  }
  FillPattern pattern{.row_start = {0}, .column = {}};
  pattern.row_start.reserve(rows.size() + 1);
  for (auto& row : rows) {
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.row_start.push_back(static_cast<std::uint32_t>(pattern.column.size()));
    std::vector<std::uint32_t>().swap(row);
  }
  return pattern;
}

FillPattern fill_pattern_within(const Backbone& backbone, int highest_level, double most_blocks) {
  const double most = most_blocks * static_cast<double>(backbone.grain_count);
  FillPattern pattern = fill_pattern(backbone, 1);
  for (int level = 2; level <= highest_level && least_growth * static_cast<double>(pattern.size()) <= most;
       ++level) {
    FillPattern next = fill_pattern(backbone, level);
    if (static_cast<double>(next.size()) > most)
      break;
    pattern = std::move(next);
  }
  return pattern;
}

namespace {

// Limit of memory: numbers of the factor per grain, without pivots. 16 blocks of 6 x 6; loose packings have
// 11.
constexpr int most_numbers = 16 * 36;

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
IncompleteFactor<Dof>::IncompleteFactor(const Backbone& backbone, const Workers& workers,
                                        const FactorRule& rule)
    : backbone_(backbone), workers_(workers),
      pattern_(
          fill_pattern_within(backbone, rule.fill_level, static_cast<double>(most_numbers) / (Dof * Dof))) {
  Eliminated<Dof> made = eliminate<Dof>(backbone, workers, rule, pattern_);
  root_ = std::move(made.root);
  mended_pivots_ = made.mended_pivots;
  lost_grains_ = std::move(made.lost_grains);
  if (rule.soft_pivots == SoftPivots::stiffened)
    lower_ = std::move(made.lower);
  else
    round(made.lower);
}

/// Keeps L in single precision.
template <int Dof>
void IncompleteFactor<Dof>::round(Lower<double>& lower) {
  Lower<float> rounded(lower.size());
  workers_.each(lower.size(), [&](std::size_t piece) {
    rounded[piece].reserve(lower[piece].size());
    for (const Block<Dof>& b : lower[piece])
      rounded[piece].push_back(as<float>(b));
    std::vector<Block<Dof>>().swap(lower[piece]);
  });
  lower_ = std::move(rounded);
}

/// body(PieceOfL) of one piece; pieces are numbered through all stages.
template <int Dof>
template <class Body>
void IncompleteFactor<Dof>::for_piece(std::size_t piece_number, Piece piece, const Body& body) const {
  const auto run = [&](const auto& lower) {
    using Number = std::remove_cvref_t<decltype(lower[0][0].at[0][0])>;
    const PieceOfL<Dof, Number> l{piece, pattern_.row_start.data(), pattern_.column.data(),
                                  lower[piece_number].data(), root_.data()};
    at_vector_level([&](auto) __attribute__((always_inline)) { body(l); });
  };
  std::visit(run, lower_);
}

template <int Dof>
void IncompleteFactor<Dof>::solve(const Field<Dof>& r, Field<Dof>& z) const {
  z.resize(r.size());
  std::size_t first = 0; // piece of the stage
  for (const std::vector<Piece>& stage : backbone_.stages) {
    workers_.each(stage.size(), [&](std::size_t k) {
      for_piece(
          first + k, stage[k], [&](const auto& l) __attribute__((always_inline)) {
            substitute_forward(l, r.data(), z.data());
          });
    });
    first += stage.size();
  }
  for (auto stage = backbone_.stages.rbegin(); stage != backbone_.stages.rend(); ++stage) {
    first -= stage->size();
    workers_.each(stage->size(), [&](std::size_t k) {
      for_piece(
          first + k,
          (*stage)[k], [&](const auto& l) __attribute__((always_inline)) { substitute_back(l, z.data()); });
    });
  }
}

template class IncompleteFactor<3>;
template class IncompleteFactor<6>;

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
    stop_point();
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
