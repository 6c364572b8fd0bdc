// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_by_values.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "io/packing_builder.hpp"

namespace granum::io {

namespace {

constexpr double within = 1e-2; // six-digit positions
constexpr std::size_t rows_asked = 5000;

/// A pair of the table, and the line of centres of its grains.
struct Pair {
  std::size_t row;
  Vec3 normal;        ///< from grain 1 to grain 2, of unit length
  double overlap = 0; ///< by the positions
};

class Values {
 public:
  Values(const UnnamedTable& table, const PackingBuilder& grains)
      : table_(table), columns_(table.computes.front()), grains_(grains) {}

  [[nodiscard]] std::size_t size() const { return columns_.size(); }
  [[nodiscard]] std::size_t column(std::size_t value) const { return columns_[value]; }
  [[nodiscard]] ColumnTriple triple(std::size_t first) const {
    return {columns_[first], columns_[first + 1], columns_[first + 2]};
  }
  [[nodiscard]] std::string span(std::size_t first, std::size_t last) const {
    return table_.columns[columns_[first]] + " to " + table_.columns[columns_[last]];
  }

  /// Whether the columns are two ids and the flag of a periodic face; stores the pairs if so.
  bool take_pairs(std::size_t first) {
    pairs_.clear();
    const std::size_t step = std::max<std::size_t>(1, table_.rows() / rows_asked);
    for (std::size_t row = 0; row < table_.rows(); row += step) {
      const auto a = grain(row, first), b = grain(row, first + 1);
      const double flag = at(row, first + 2);
      if (!a || !b || *a == *b || (flag != 0 && flag != 1))
        return false;
      if (grains_.ambiguous(*a, *b))
        continue;
      const Vec3 branch = grains_.nearest(grains_.straight(*a, *b));
      if (norm(branch) > 0)
        pairs_.push_back({row, (1 / norm(branch)) * branch, grains_.radius_sum(*a, *b) - norm(branch)});
    }
    return true;
  }

  [[nodiscard]] Vec3 vector(const Pair& pair, std::size_t first) const {
    return {at(pair.row, first), at(pair.row, first + 1), at(pair.row, first + 2)};
  }
  /// Push on grain 1 in the mean, against the normal.
  [[nodiscard]] bool pushes(std::size_t first) const {
    double along = 0, size = 0;
    for (const Pair& pair : pairs_) {
      along -= dot(vector(pair, first), pair.normal);
      size += norm(vector(pair, first));
    }
    return along >= 0 && (size == 0 || along > within * size);
  }
  /// How large the part of a vector across the normals is, or along them, over the whole.
  [[nodiscard]] double share(std::size_t first, bool across) const {
    double part = 0, size = 0;
    for (const Pair& pair : pairs_) {
      const Vec3 f = vector(pair, first);
      const double along = dot(f, pair.normal);
      part += across ? norm(f - along * pair.normal) : std::abs(along);
      size += norm(f);
    }
    return size > 0 ? part / size : 0;
  }
  [[nodiscard]] bool is_normal(std::size_t first) const {
    return pushes(first) && share(first, true) <= within;
  }
  [[nodiscard]] bool is_tangential(std::size_t first) const { return share(first, false) <= within; }
  /// Whether one vector is the sum of two others, or of one where the other is not there.
  [[nodiscard]] bool is_sum(std::size_t whole, std::size_t normal, std::size_t tangential) const {
    double off = 0, size = 0;
    for (const Pair& pair : pairs_) {
      off += norm(vector(pair, whole) - vector(pair, normal) - vector(pair, tangential));
      size += norm(vector(pair, whole));
    }
    return off <= within * size;
  }
  /// The column after `first` with the overlaps.
  [[nodiscard]] std::optional<std::size_t> overlap_from(std::size_t first) const {
    for (std::size_t value = first; value < size(); ++value) {
      double off = 0, sum = 0;
      for (const Pair& pair : pairs_) {
        off += std::abs(at(pair.row, value) - pair.overlap);
        sum += std::abs(pair.overlap);
      }
      if (sum > 0 && off <= within * sum)
        return value;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] double at(std::size_t row, std::size_t value) const {
    return table_.at(row, columns_[value]);
  }
  [[nodiscard]] std::optional<std::uint32_t> grain(std::size_t row, std::size_t value) const {
    constexpr double largest = 1e15;
    const double id = at(row, value);
    if (!(std::abs(id) <= largest) || id != std::floor(id))
      return std::nullopt;
    return grains_.find(static_cast<long>(id));
  }

  const UnnamedTable& table_;
  const ColumnGroup& columns_;
  const PackingBuilder& grains_;
  std::vector<Pair> pairs_;
};

/// Sets the forces in the columns from `first` on.
/// \return   their description; empty if there are none
std::string take_forces(const Values& values, std::size_t first, ContactLayout& layout) {
  const std::size_t second = first + 3, third = first + 6;
  const auto there = [&](std::size_t at) { return at + 3 <= values.size(); };
  if (there(third) && values.is_normal(second) && values.is_tangential(third) &&
      values.is_sum(first, second, third)) {
    layout.normal = values.triple(second);
    layout.tangential = values.triple(third);
    return " force force_normal force_tangential";
  }
  if (there(second) && values.is_normal(first) && values.is_tangential(second)) {
    layout.normal = values.triple(first);
    layout.tangential = values.triple(second);
    return " force_normal force_tangential";
  }
  if (!there(first) || !values.pushes(first))
    return "";
  if (values.is_normal(first)) {
    layout.normal = values.triple(first);
    return " force_normal";
  }
  layout.whole = values.triple(first);
  return " force";
}

} // namespace

IdentifiedLayout liggghts_by_values(const UnnamedTable& table, const PackingBuilder& grains) {
  Values values(table, grains);
  for (const std::size_t first : {std::size_t{0}, std::size_t{6}, std::size_t{12}}) {
    constexpr std::size_t ids = 3;
    if (first + ids > values.size() || !values.take_pairs(first))
      continue;
    ContactLayout layout;
    layout.id1 = values.column(first);
    layout.id2 = values.column(first + 1);
    layout.periodic = values.column(first + 2);
    if (first > 0) {
      layout.first = values.triple(0);
      layout.second = values.triple(3);
    }
    const std::string forces = take_forces(values, first + ids, layout);
    if (forces.empty())
      continue;
    if (const auto overlap = values.overlap_from(first + ids + 3))
      layout.overlap = values.column(*overlap);
    return {layout,
            values.span(0, values.size() - 1) + " as " + (first > 0 ? "pos " : "") +
                (first > 6 ? "vel " : "") + "id" + forces + (layout.overlap ? " ... delta" : "") +
                " of LIGGGHTS' compute pair/gran/local",
            false};
  }
  grains.fail_contact(
      table.lines.front(),
      "no columns of ids and forces as in LIGGGHTS' compute pair/gran/local (pos vel id force "
      "force_normal force_tangential ...) agree with the positions of the grains; name the columns "
      "with a column map, such as " +
          example_map(table.columns));
}

} // namespace granum::io
