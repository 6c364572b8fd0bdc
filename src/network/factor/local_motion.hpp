// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "network/backbone.hpp"
#include "network/lanes.hpp"
#include "network/link_forces.hpp"

namespace granum::network {

/// The contacts of each grain. Backbone::links are sorted by the later of their two grains; this also finds
/// the links of the earlier one.
class LinksOfGrains {
 public:
  explicit LinksOfGrains(const Backbone& backbone);

  /// visit(link) for each contact of grain g with an earlier grain.
  template <class Visit>
  void with_earlier(std::uint32_t g, const Visit& visit) const {
    for (std::uint32_t k = later_start_[g]; k < later_start_[g + 1]; ++k)
      visit(links_[k]);
  }
  /// visit(link) for each contact of grain g with a later grain.
  template <class Visit>
  void with_later(std::uint32_t g, const Visit& visit) const {
    for (std::uint32_t k = earlier_start_[g]; k < earlier_start_[g + 1]; ++k)
      visit(links_[earlier_[k]]);
  }

  [[nodiscard]] const Joint* joint_of(const Link& link) const { return backbone_.joint_of(link); }

 private:
  const Backbone& backbone_;
  const std::vector<Link>& links_;
  std::vector<std::uint32_t> later_start_, earlier_start_;
  std::vector<std::uint32_t> earlier_; ///< links, sorted by their earlier grain
};

/// Displacements of a few grains, one motion in each lane; the other grains rest.
template <int Dof>
class LocalMotion {
 public:
  static constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();

  /// \param    place   working memory, `absent` for every grain of the network, also afterwards
  explicit LocalMotion(std::vector<std::uint32_t>& place) : place_(place) {}
  LocalMotion(const LocalMotion&) = delete;
  LocalMotion& operator=(const LocalMotion&) = delete;
  ~LocalMotion() {
    for (const std::uint32_t g : grains_)
      place_[g] = absent;
  }

  /// Displacement of a grain; zero if it was at rest so far. The next call may invalidate the reference.
  Rows<Dof>& of(std::uint32_t grain);
  /// Returns each moving grain once, the latest first; false if none is left.
  bool take_latest(std::uint32_t& grain);
  /// add(grain, force) for each contact between a moving grain and one after `last`, which all rest: the
  /// force H x of the contact on the latter in each motion.
  template <class Add>
  void forces_after(std::uint32_t last, const LinksOfGrains& links, const Add& add) const {
    const Rows<Dof> still = {};
    for (std::size_t k = 0; k < grains_.size(); ++k)
      links.with_later(grains_[k], [&](const Link& l) {
        if (l.b <= last)
          return;
        Rows<Dof> on_earlier = {}, on_later = {};
        add_link_forces<Dof>(l, links.joint_of(l), rows_[k], still, on_earlier, on_later);
        add(l.b, on_later);
      });
  }
  /// x^T H x of each motion.
  [[nodiscard]] PerCase energy(const Backbone& backbone, const LinksOfGrains& links) const;
  /// Sum of the squares of all displacements of each motion.
  [[nodiscard]] PerCase squares() const;
  /// Appends the grains whose displacement in the motion of a lane is at least this part of the largest.
  void add_movers(int lane, double part, std::vector<std::uint32_t>& grains) const;

 private:
  [[nodiscard]] bool moves(std::uint32_t grain) const { return place_[grain] != absent; }

  std::vector<std::uint32_t>& place_; ///< in `rows_`
  std::vector<std::uint32_t> grains_;
  std::vector<Rows<Dof>> rows_;
  std::vector<std::uint32_t> untaken_; ///< a heap
};

} // namespace granum::network
