// SPDX-License-Identifier: GPL-3.0-or-later
#include "incomplete_factor.hpp"

#include <type_traits>
#include <utility>

#include "core/vector/level.hpp"
#include "substitution.hpp"

namespace granum::network {

namespace {

// Limit of memory: numbers of the factor per grain, without pivots. 16 blocks of 6 x 6; loose packings have
// 11.
constexpr int most_numbers = 16 * 36;

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

} // namespace granum::network
