// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "backbone.hpp"
#include "coarse_factor.hpp"
#include "lanes.hpp"
#include "workers.hpp"

namespace granum::network {

/// Rigid motions P of aggregates of neighbouring grains, six each, and the stiffness P^T H P among them
/// [Nicolaides1987]. They take out of a residual the long waves, for which the incomplete factor alone takes
/// the more iterations the larger the network.
template <int Dof>
class CoarseCorrection {
 public:
  /// \param    most_grains   in an aggregate. With 200 instead, 100,000 grains take 43 iterations for 47, and
  ///           are solved no sooner
  CoarseCorrection(const Backbone& backbone, const Workers& workers, std::size_t most_grains = 500);

  /// Whether the network is large enough to gain by it.
  [[nodiscard]] static bool pays(const Backbone& backbone);

  /// z += P (P^T H P)^+ P^T (r - H z)
  void correct(const Field<Dof>& r, Field<Dof>& z) const;
  /// q += P (P^T H P)^+ P^T r
  void add_lifted(const Field<Dof>& r, Field<Dof>& q) const;

  /// Numbers that the factor of P^T H P holds.
  [[nodiscard]] std::size_t nonzeros() const { return factor_->nonzeros(); }

 private:
  /// A link that the motions strain, as one of its two aggregates sees it.
  struct End {
    std::uint32_t link = 0;
    bool at_a = false;
  };

  void gather(std::size_t most_grains);
  [[nodiscard]] bool is_strained(const Link& link) const;
  void list_ends();
  void factorise();
  [[nodiscard]] Rows<6> restricted(std::size_t aggregate, const Field<Dof>& r) const;
  [[nodiscard]] Rows<6> restricted_answer(std::size_t aggregate, const Field<Dof>& z) const;
  void add_motions(const Field<6>& motion, Field<Dof>& z) const;
  [[nodiscard]] std::size_t size() const { return grains_start_.size() - 1; }

  const Backbone& backbone_;
  const Workers& workers_;
  std::vector<std::uint32_t> grains_; ///< aggregate after aggregate
  std::vector<std::uint32_t> grains_start_;
  std::vector<std::uint32_t> aggregate_; ///< of each grain
  std::vector<Vec3> arm_;                ///< of each grain, from the middle of its aggregate
  std::vector<End> ends_;                ///< aggregate after aggregate
  std::vector<std::uint32_t> ends_start_;
  std::vector<End> wall_ends_; ///< the same
  std::vector<std::uint32_t> wall_ends_start_;
  std::optional<CoarseFactor> factor_;
};

} // namespace granum::network
