// SPDX-License-Identifier: GPL-3.0-or-later
// Incomplete block factorisation R^T H R ~ L L^T. Symbols:
//   H        stiffness matrix, blocks H_ij of Dof x Dof for grains i, j in the order of elimination
//   h        mean diagonal entry of H, the unit of the constants below
//   P_i      pivot: H_ii less what the elimination of grains before i subtracts
//   R_i      root of the inverse pivot, R_i R_i^T = P_i^-1
//   L        lower triangle with unit diagonal blocks; while rows are made, R^-T L is stored in its place
//   d, l     direction and eigenvalue of a pivot: P_i d = l d, |d| = 1
//   v, e     motion of a direction, v = L^-T d: grain i moves by d, grains before i follow, later ones rest;
//            its energy e = v^T H v. e = l in a complete factor; in an incomplete one l may be wrong.
// A direction is soft if l is small, lost if l is far below e, free if e is rounding error, very soft if e is
// small. A deferred direction is rigid during the elimination and gets e afterwards.
#include "elimination.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <Eigen/Cholesky>
#include <granum/core/stop.hpp>

#include "core/compiled_once.hpp"
#include "core/vector/level.hpp"
#include "local_motion.hpp"
#include "network/contact_operator.hpp"
#include "substitution.hpp"

namespace granum::network {

namespace {

// "Measured": chosen by iterations on loose packings and diluted lattices (bench/README.md, The network).
// SoftPivots::deferred: a pivot below this part of the shift is looked at. Pivots of a complete factor are
// not below the shift, because H is not negative; so this is an order of magnitude of error by dropped terms.
constexpr double safe_pivot = 0.1;
// l / h below which directions of such a pivot are deferred: softer than a mean one by an order of magnitude.
constexpr double lost_stiffness = 0.1;
// SoftPivots::stiffened: least l / h. Larger values stop some floppy networks from converging. Measured.
constexpr double least_stiffened = 1e-4;
// l / h of a soft direction. 1e-3: a packing of 1e6 grains fails; 1e-1: 2.6 times the time. Measured.
constexpr double soft = 1e-2;
// Displacements below this part of l / h move no further grains; a larger limit makes e too large. Measured.
constexpr double negligible_soft = 0.3;
// e / l from which on a soft direction is lost: an order of magnitude of error.
constexpr double far_off = 10;
// e / h of a very soft motion. 1e-2 selects so many grains that some of these lose pivots. Measured.
constexpr double very_soft = 1e-3;
// Grains of a very soft (or lost) motion are selected if their displacement is at least this fraction of the
// largest. Measured.
constexpr double moving = 0.03;
constexpr double moving_where_lost = 0.003;
// Smaller, and negative, l / h count as this with negligible_soft and far_off. Measured.
constexpr double least_compared = 1e-8;
// As negligible_soft for deferred directions, absolute: the default shift, the least stiffness that they get.
constexpr double negligible_deferred = 1e-6;
// e / (h v^T v) of a free motion: a few units of rounding (2.2e-16), which is what the terms of e cancel to.
constexpr double rounding = 1e-15;
constexpr double rigid = std::numeric_limits<double>::infinity();

/// target -= left^T right
template <int Dof>
GRANUM_INLINE void subtract_product(const Block<Dof>& left, const Block<Dof>& right, Block<Dof>& target) {
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      for (int c = 0; c < Dof; ++c)
        target.at[r][c] -= left.at[k][r] * right.at[k][c];
}

/// left^T right
template <int Dof>
GRANUM_INLINE Block<Dof> product_of_transposed(const Block<Dof>& left, const Block<Dof>& right) {
  Block<Dof> product;
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      for (int c = 0; c < Dof; ++c)
        product.at[r][c] += left.at[k][r] * right.at[k][c];
  return product;
}

template <int Dof>
Block<Dof> product(const Block<Dof>& left, const Block<Dof>& right) {
  Block<Dof> product;
  for (int r = 0; r < Dof; ++r)
    for (int k = 0; k < Dof; ++k)
      for (int c = 0; c < Dof; ++c)
        product.at[r][c] += left.at[r][k] * right.at[k][c];
  return product;
}

template <int Dof>
Block<Dof> transposed(const Block<Dof>& b) {
  Block<Dof> t;
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      t.at[r][c] = b.at[c][r];
  return t;
}

template <int Dof>
double mean_diagonal(const std::vector<Block<Dof>>& blocks) {
  double mean = 0;
  for (const Block<Dof>& b : blocks)
    for (int r = 0; r < Dof; ++r)
      mean += b.at[r][r] / static_cast<double>(blocks.size() * Dof);
  return mean > 0 ? mean : 1;
}

template <class T>
void append(const std::vector<T>& more, std::vector<T>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

template <int Dof>
class Elimination {
 public:
  Elimination(const Backbone& backbone, const Workers& workers, const FactorRule& rule,
              const FillPattern& pattern)
      : backbone_(backbone), workers_(workers), rule_(rule), pattern_(pattern), links_(backbone),
        below_(backbone.grain_count), row_(backbone.grain_count),
        soft_(backbone.grain_count), made_{.root = diagonal_blocks<Dof>(backbone)},
        mean_(mean_diagonal(made_.root)) {}

  Eliminated<Dof> run() {
    for (const std::vector<Piece>& stage : backbone_.stages) {
      const std::size_t first = made_.lower.size();
      made_.lower.resize(first + stage.size());
      std::vector<Work> works(stage.size());
      workers_.each(stage.size(),
                    [&](std::size_t k) { eliminate_piece(stage[k], works[k], made_.lower[first + k]); });
      for (const Work& of_piece : works) {
        made_.mended_pivots += of_piece.mended_pivots;
        append(of_piece.deferred, deferred_);
        append(of_piece.lost_grains, made_.lost_grains);
        append(of_piece.soft_grains, made_.soft_grains);
      }
    }
    set_deferred();
    std::size_t first = 0;
    for (const std::vector<Piece>& stage : backbone_.stages) {
      workers_.each(stage.size(), [&](std::size_t k) { scale(stage[k], made_.lower[first + k]); });
      first += stage.size();
    }
    return std::move(made_);
  }

 private:
  using PivotSystem = SymmetricEigen<Dof>;
  using Vector = Eigen::Matrix<double, Dof, 1>;
  static constexpr std::uint32_t absent = LocalMotion<Dof>::absent;

  struct DeferredDirection {
    std::uint32_t row;
    int column; ///< of R_i; zero until set_deferred
    Vector direction;
  };
  /// Forces H v / sqrt(e) of the motions of a soft pivot on a later grain.
  struct Coupling {
    std::uint32_t grain;
    Rows<Dof> force; ///< one motion in each lane; 0 if it is free
  };
  struct SoftPivot {
    int directions = 0; ///< number of soft ones: the first columns of R_i
    std::vector<Coupling> couplings;
  };
  /// A finished block of a column.
  struct Entry {
    std::uint32_t row;
    std::uint32_t place; ///< index within its row
  };
  /// Working memory and results of one piece.
  struct Work {
    std::vector<std::uint32_t> slot; ///< index in `row` of each column, or `absent`; all absent between rows
    std::vector<Link>::const_iterator link; ///< first link of the next row
    std::vector<Block<Dof>> row;            ///< blocks of H less what is eliminated, transposed
    std::vector<DeferredDirection> deferred;
    std::size_t mended_pivots = 0;
    std::vector<std::uint32_t> lost_grains, soft_grains;
  };

  [[nodiscard]] bool couples() const { return rule_.soft_pivots == SoftPivots::coupled; }
  [[nodiscard]] bool by_motion() const { return uses_motions(rule_.soft_pivots); }

  void eliminate_piece(Piece piece, Work& work, std::vector<Block<Dof>>& lower) {
    work.slot.assign(backbone_.grain_count, absent);
    work.link = std::lower_bound(backbone_.links.begin(), backbone_.links.end(), piece.first,
                                 [](const Link& l, std::uint32_t g) { return l.b < g; });
    const std::uint32_t* const start = pattern_.row_start.data();
    lower.resize(start[piece.last] - start[piece.first]);
    for (std::uint32_t i = piece.first; i < piece.last; ++i) {
      stop_point();
      Block<Dof>* const row = lower.data() + (start[i] - start[piece.first]);
      row_[i] = row;
      for (int r = 0; r < Dof && !by_motion(); ++r)
        made_.root[i].at[r][r] += rule_.shift * mean_;
      begin_row(i, work);
      at_vector_level([&](auto) __attribute__((always_inline)) { finish_row(i, work, row, made_.root[i]); });
      for (std::uint32_t e = start[i]; e < start[i + 1]; ++e) {
        below_[pattern_.column[e]].push_back({i, e - start[i]});
        work.slot[pattern_.column[e]] = absent;
      }
      if (take_root(i, work))
        ++work.mended_pivots;
    }
    std::vector<std::uint32_t>().swap(work.slot);
  }

  /// Row i of H, with zero blocks for its fill.
  void begin_row(std::uint32_t i, Work& work) const {
    const std::uint32_t first = pattern_.row_start[i], last = pattern_.row_start[i + 1];
    work.row.assign(last - first, {});
    for (std::uint32_t e = first; e < last; ++e)
      work.slot[pattern_.column[e]] = e - first;
    for (; work.link != backbone_.links.end() && work.link->b == i; ++work.link)
      add(transposed(link_blocks<Dof>(*work.link, backbone_.joint_of(*work.link)).coupling_ba),
          work.row[work.slot[work.link->a]]);
  }

  /// Row i of R^-T L, and P_i, from the finished rows.
  GRANUM_INLINE void finish_row(std::uint32_t i, Work& work, Block<Dof>* row, Block<Dof>& pivot) const {
    const std::uint32_t* const column = pattern_.column.data() + pattern_.row_start[i];
    for (std::size_t e = 0; e < work.row.size(); ++e) {
      const std::uint32_t j = column[e];
      Block<Dof> finished = product_of_transposed(made_.root[j], work.row[e]);
      if (soft_[j])
        take_couplings(*soft_[j], i, finished);
      for (const auto [k, place] : below_[j])
        if (const std::uint32_t slot = work.slot[k]; slot != absent)
          subtract_product(row_[k][place], finished, work.row[slot]);
      subtract_product(finished, finished, pivot);
      row[e] = finished;
    }
  }

  /// Replaces the columns of soft directions of an earlier pivot in a block of row i.
  static void take_couplings(const SoftPivot& pivot, std::uint32_t i, Block<Dof>& finished) {
    Rows<Dof> force = {};
    for (const Coupling& c : pivot.couplings)
      if (c.grain == i)
        force = c.force;
    for (int k = 0; k < pivot.directions; ++k)
      for (int c = 0; c < Dof; ++c)
        finished.at[k][c] = force.row[c][k];
  }

  /// Replaces P_i by R_i; returns whether the pivot had to be modified.
  bool take_root(std::uint32_t i, Work& work) {
    using Square = Eigen::Matrix<double, Dof, Dof, Eigen::RowMajor>;
    Eigen::Map<Square> map(&made_.root[i].at[0][0]);
    const Square symmetric = (map + map.transpose()) / 2;
    const double safe = by_motion() ? 2 * soft : safe_pivot * rule_.shift;
    const Eigen::LLT<Eigen::Matrix<double, Dof, Dof>> cholesky(symmetric);
    if (cholesky.info() == Eigen::Success &&
        cholesky.matrixLLT().diagonal().cwiseAbs2().minCoeff() >= safe * mean_) {
      map = cholesky.matrixU().solve(Eigen::Matrix<double, Dof, Dof>::Identity());
      return false;
    }
    const PivotSystem pivot = symmetric_eigen<Dof>(symmetric);
    const Vector found = pivot.values;
    Vector values = found;
    bool mended = true;
    if (rule_.soft_pivots == SoftPivots::stiffened)
      values = found.unaryExpr([&](double v) { return std::max(std::abs(v), least_stiffened * mean_); });
    else if (by_motion())
      mended = set_soft(i, pivot, work, values);
    else
      for (int k = 0; k < Dof && found[k] < lost_stiffness * mean_; ++k)
        defer(i, pivot, k, work, values);
    map = pivot.vectors * values.cwiseSqrt().cwiseInverse().asDiagonal();
    return mended;
  }

  /// SoftPivots::by_motion and coupled: soft directions get the energy of their motions. Free ones stay
  /// rigid: they carry no load, and rounding would drive them. Lost ones are deferred, and with by_motion all
  /// other directions of that pivot below lost_stiffness as well. Returns whether any was lost.
  bool set_soft(std::uint32_t i, const PivotSystem& pivot, Work& work, Vector& values) {
    const Vector found = pivot.values;
    double softest = 1; // least l / h
    Rows<Dof> directions = {};
    SoftPivot soft_pivot;
    int& count = soft_pivot.directions;
    for (; count < Dof && found[count] < soft * mean_; ++count) {
      softest = std::min(softest, std::max(std::abs(found[count]) / mean_, least_compared));
      for (int r = 0; r < Dof; ++r)
        directions.row[r][count] = pivot.vectors(r, count);
    }
    if (count == 0)
      return false;
    LocalMotion<Dof> motion(work.slot);
    find_motion(i, directions, negligible_soft * softest, motion);
    const PerCase energy = energies_of(motion);
    for (int k = 0; k < count; ++k) {
      const double e = energy[static_cast<std::size_t>(k)];
      values[k] = e < rule_.shift * mean_ ? rigid : e;
    }
    const bool lost = has_lost(count, found, values);
    note_movers(count, lost, values, motion, work);
    for (int k = 0; k < Dof && lost && found[k] < lost_stiffness * mean_; ++k)
      if (values[k] < rigid && (!couples() || is_lost(found[k], values[k])))
        defer(i, pivot, k, work, values);
    if (couples()) {
      soft_pivot.couplings = couplings_of(i, motion, values);
      soft_[i] = std::make_unique<SoftPivot>(std::move(soft_pivot));
    }
    return lost;
  }

  /// Whether the energy of a motion is far from the eigenvalue that was found for it.
  [[nodiscard]] bool is_lost(double found, double energy) const {
    return energy < rigid && energy > far_off * std::max(found, least_compared * mean_);
  }
  [[nodiscard]] bool has_lost(int directions, const Vector& found, const Vector& values) const {
    for (int k = 0; k < directions; ++k)
      if (is_lost(found[k], values[k]))
        return true;
    return false;
  }

  /// Adds the grains of lost and of very soft motions to those of the piece.
  void note_movers(int directions, bool lost, const Vector& values, const LocalMotion<Dof>& motion,
                   Work& work) const {
    const bool is_very_soft = values.head(directions).minCoeff() < very_soft * mean_;
    for (int k = 0; k < directions; ++k) {
      if (lost)
        motion.add_movers(k, moving_where_lost, work.lost_grains);
      if (is_very_soft)
        motion.add_movers(k, moving, work.soft_grains);
    }
  }

  /// Forces of the motions of grain i on the later grains that the pattern couples with it.
  [[nodiscard]] std::vector<Coupling> couplings_of(std::uint32_t i, const LocalMotion<Dof>& motion,
                                                   const Vector& stiffness) const {
    std::vector<Coupling> couplings;
    motion.forces_after(i, links_, [&](std::uint32_t g, const Rows<Dof>& force) {
      if (!is_coupled(g, i))
        return;
      auto of_grain =
          std::find_if(couplings.begin(), couplings.end(), [g](const Coupling& c) { return c.grain == g; });
      if (of_grain == couplings.end())
        of_grain = couplings.insert(of_grain, {g, {}});
      for (int r = 0; r < Dof; ++r)
        of_grain->force.row[r] += force.row[r];
    });
    Lanes scale = {};
    for (int k = 0; k < Dof; ++k)
      scale[k] = stiffness[k] > 0 ? 1 / std::sqrt(stiffness[k]) : 0;
    for (Coupling& c : couplings)
      for (Lanes& row : c.force.row)
        row *= scale;
    return couplings;
  }

  /// Whether the pattern keeps the block of row `later` and column `earlier`.
  [[nodiscard]] bool is_coupled(std::uint32_t later, std::uint32_t earlier) const {
    const std::uint32_t* const column = pattern_.column.data();
    return std::binary_search(column + pattern_.row_start[later], column + pattern_.row_start[later + 1],
                              earlier);
  }

  /// Motions v of directions of grain i, one in each lane. Grains whose displacements are all below
  /// `negligible` move no others.
  void find_motion(std::uint32_t i, const Rows<Dof>& directions, double negligible,
                   LocalMotion<Dof>& motion) const {
    const auto matters = [negligible](const Rows<Dof>& x) {
      for (const Lanes& row : x.row)
        for (int k = 0; k < Dof; ++k)
          if (std::abs(row[k]) >= negligible)
            return true;
      return false;
    };
    motion.of(i) = directions;
    for (std::uint32_t g = i; motion.take_latest(g);) {
      if (g != i)
        motion.of(g) = product(made_.root[g], motion.of(g));
      const Rows<Dof> here = motion.of(g);
      const std::uint32_t first = pattern_.row_start[g], last = pattern_.row_start[g + 1];
      for (std::uint32_t e = first; e < last && matters(here); ++e)
        subtract(row_[g][e - first], here, motion.of(pattern_.column[e]));
    }
  }

  /// Energies e of motions; 0 for free ones.
  [[nodiscard]] PerCase energies_of(const LocalMotion<Dof>& motion) const {
    PerCase energy = motion.energy(backbone_, links_);
    const PerCase squares = motion.squares();
    for (std::size_t k = 0; k < energy.size(); ++k)
      if (energy[k] < rounding * mean_ * squares[k])
        energy[k] = 0;
    return energy;
  }

  /// Makes a pivot rigid along its eigenvector k until set_deferred.
  static void defer(std::uint32_t i, const PivotSystem& pivot, int k, Work& work, Vector& values) {
    work.deferred.push_back({i, k, pivot.vectors.col(k)});
    values[k] = rigid;
  }

  /// Gives each deferred direction the energy of its motion, the shift at least. With motions of soft pivots
  /// free ones stay rigid instead.
  void set_deferred() {
    const double least = rule_.shift * mean_;
    std::vector<double> stiffness(deferred_.size());
    workers_.each(deferred_.size(), [&](std::size_t k) {
      stop_point();
      std::vector<std::uint32_t> slot(backbone_.grain_count, absent);
      Rows<Dof> direction = {};
      for (int r = 0; r < Dof; ++r)
        direction.row[r][0] = deferred_[k].direction[r];
      LocalMotion<Dof> motion(slot);
      find_motion(deferred_[k].row, direction, negligible_deferred, motion);
      const double energy = energies_of(motion)[0];
      stiffness[k] = by_motion() && energy < least ? rigid : std::max(energy, least);
    });
    for (std::size_t k = 0; k < deferred_.size(); ++k)
      for (int r = 0; r < Dof; ++r)
        made_.root[deferred_[k].row].at[r][deferred_[k].column] =
            deferred_[k].direction[r] / std::sqrt(stiffness[k]);
  }

  /// Makes L of R^-T L in the rows of a piece.
  void scale(Piece piece, std::vector<Block<Dof>>& lower) const {
    auto block = lower.begin();
    stop_point();
    for (std::uint32_t i = piece.first; i < piece.last; ++i)
      for (std::uint32_t e = pattern_.row_start[i]; e < pattern_.row_start[i + 1]; ++e, ++block)
        *block = product(*block, made_.root[i]);
  }

  const Backbone& backbone_;
  const Workers& workers_;
  const FactorRule& rule_;
  const FillPattern& pattern_;
  LinksOfGrains links_;
  std::vector<std::vector<Entry>> below_; ///< finished blocks of each column
  std::vector<const Block<Dof>*> row_;    ///< first block of each finished row
  std::vector<DeferredDirection> deferred_;
  std::vector<std::unique_ptr<SoftPivot>> soft_; ///< by rows; only with SoftPivots::coupled
  Eliminated<Dof> made_;                         ///< `root`: P_i until take_root; `lower`: R^-T L until scale
  double mean_;                                  ///< h
};

} // namespace

template <int Dof>
Eliminated<Dof> eliminate(const Backbone& backbone, const Workers& workers, const FactorRule& rule,
                          const FillPattern& pattern) {
  return Elimination<Dof>(backbone, workers, rule, pattern).run();
}

template Eliminated<3> eliminate(const Backbone&, const Workers&, const FactorRule&, const FillPattern&);
template Eliminated<6> eliminate(const Backbone&, const Workers&, const FactorRule&, const FillPattern&);

} // namespace granum::network
