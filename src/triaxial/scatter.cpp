// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/scatter.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <boost/random/uniform_real_distribution.hpp>

#include <granum/core/error.hpp>

namespace granum::triaxial {

namespace {

/// A cube of periodic faces in boxes, each wide enough that grains touch those of the next boxes only, and so
/// narrow that few grains fit in.
class Boxes {
 public:
  /// \param    diameter   of the largest grain
  Boxes(double edge, double diameter)
      : edge_(edge), along_(static_cast<std::size_t>(edge / diameter)),
        first_(along_ * along_ * along_, none) {}

  [[nodiscard]] bool is_free(const Vec3& x, double radius, const dem::Specimen& state) const {
    std::array<std::array<std::size_t, 3>, 3> near{};
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t k = index(x[axis]);
      near[static_cast<std::size_t>(axis)] = {k == 0 ? along_ - 1 : k - 1, k, k + 1 == along_ ? 0 : k + 1};
    }
    for (const std::size_t i : near[0])
      for (const std::size_t j : near[1])
        for (const std::size_t k : near[2])
          for (std::uint32_t g = first_[(i * along_ + j) * along_ + k]; g != none; g = next_[g])
            if (distance(x, state.position[g]) <= radius + state.radius_of(g))
              return false;
    return true;
  }

  void add(const Vec3& x) {
    std::uint32_t& first = first_[(index(x.x) * along_ + index(x.y)) * along_ + index(x.z)];
    next_.push_back(first);
    first = static_cast<std::uint32_t>(next_.size() - 1);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] std::size_t index(double x) const {
    return std::min(along_ - 1, static_cast<std::size_t>(x / edge_ * static_cast<double>(along_)));
  }
  [[nodiscard]] double distance(const Vec3& a, const Vec3& b) const {
    Vec3 d = a - b;
    for (int axis = 0; axis < 3; ++axis)
      d[axis] -= edge_ * std::round(d[axis] / edge_);
    return norm(d);
  }

  double edge_;
  std::size_t along_;
  std::vector<std::uint32_t> first_; ///< grain of each box, or none
  std::vector<std::uint32_t> next_;  ///< grain in the same box as this one, or none
};

} // namespace

dem::Specimen scattered_specimen(const SpecimenRecipe& recipe, double solid_fraction) {
  require_valid(recipe);
  if (!(solid_fraction > 0 && solid_fraction <= 0.3))
    throw InvalidArgument("solid_fraction", solid_fraction, "", "(0, 0.3]");
  dem::Specimen state;
  state.radius = recipe.radius;
  state.size = drawn_sizes(recipe);
  // Large grains come first, while there is room for them.
  std::sort(state.size.begin(), state.size.end(), std::greater<>());
  state.position.resize(recipe.grains);
  const double edge = std::cbrt(grain_volume(state) / solid_fraction);
  state.position.clear();
  state.cell = Mat3::diagonal(edge, edge, edge);
  Boxes boxes(edge, 2 * recipe.radius * largest_size(state));
  std::mt19937_64 random(recipe.seed);
  boost::random::uniform_real_distribution<double> along(0, edge);
  while (state.grain_count() < recipe.grains) {
    Vec3 x;
    for (int axis = 0; axis < 3; ++axis)
      x[axis] = along(random);
    if (!boxes.is_free(x, state.radius_of(state.grain_count()), state))
      continue;
    boxes.add(x);
    state.position.push_back(x);
  }
  return state;
}

} // namespace granum::triaxial
