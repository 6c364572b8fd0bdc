// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/packing_builder.hpp"

namespace granum::io {

namespace {

/// Six-digit positions in a box of a thousand grain diameters.
constexpr double tolerance = 1e-2;
/// Rows that are looked at.
constexpr std::size_t enough_rows = 5000;

/// Possible values of a pair, in this order.
struct Terms {
  bool dist = false, difference = false, energy = false, force = false, vector = false;
  std::size_t extra = 0; ///< p1 to p<extra>
  bool swapped = false;  ///< p1 p2 p3 before fx fy fz

  [[nodiscard]] std::size_t count() const {
    const auto size = [](bool there, std::size_t values) { return there ? values : 0; };
    return size(dist, 1) + size(difference, 3) + size(energy, 1) + size(force, 1) + size(vector, 3) + extra;
  }
  [[nodiscard]] std::string words() const {
    std::string text;
    const auto add = [&](bool there, const std::string& words) {
      if (there)
        text += (text.empty() ? "" : " ") + words;
    };
    const std::string last = extra > 3 ? "p1 to p" + std::to_string(extra) : "p1 p2 p3";
    add(dist, "dist");
    add(difference, "dx dy dz");
    add(energy, "eng");
    add(force, "force");
    add(vector && !swapped, "fx fy fz");
    add(extra > 0, last);
    add(swapped, "fx fy fz");
    return text;
  }
};

/// Numbers of p1 p2 ... of a granular pair style that do not cut a vector in two.
constexpr std::array<std::size_t, 8> extra_counts{0, 3, 4, 7, 8, 9, 10, 12};

/// Every order of so many values that begins with a quantity that geometry can identify: a distance or a
/// force.
std::vector<Terms> orders_of(std::size_t count) {
  std::vector<Terms> out;
  const auto add = [&](const Terms& terms) {
    if (terms.count() == count && (terms.force || terms.vector || terms.dist))
      out.push_back(terms);
  };
  for (const std::size_t extra : extra_counts)
    for (int bits = 0; bits < 32; ++bits) {
      Terms terms{.dist = (bits & 1) != 0,
                  .difference = (bits & 2) != 0,
                  .energy = (bits & 4) != 0,
                  .force = (bits & 8) != 0,
                  .vector = (bits & 16) != 0,
                  .extra = extra};
      if (!terms.force && !terms.vector && (terms.energy || extra > 0))
        continue;
      add(terms);
      terms.swapped = terms.vector && extra == 3;
      if (terms.swapped) // as granum itself has read eight values from its first version on
        add(terms);
    }
  return out;
}

/// Indices of the values of an order.
ContactLayout layout_of(const Terms& terms, std::size_t id1, std::size_t id2, const ColumnGroup& values) {
  ContactLayout layout;
  layout.id1 = id1;
  layout.id2 = id2;
  std::size_t next = 0;
  const auto one = [&] { return values[next++]; };
  const auto three = [&] {
    next += 3;
    return ColumnTriple{values[next - 3], values[next - 2], values[next - 1]};
  };
  if (terms.dist)
    one();
  if (terms.difference)
    three(); // its sign depends on the version of LAMMPS; the positions give the same
  if (terms.energy)
    one();
  if (terms.force)
    layout.force = one();
  std::size_t extra_at = next;
  if (terms.vector && !terms.swapped) {
    layout.normal = three();
    extra_at = next;
  }
  if (terms.extra >= 3)
    layout.tangential = three();
  if (terms.swapped)
    layout.normal = three();
  if (terms.extra >= 8)
    layout.rolling = values[extra_at + 7];
  if (terms.extra >= 9)
    layout.twisting = values[extra_at + 8];
  if (terms.extra == 12)
    layout.difference = {values[extra_at + 9], values[extra_at + 10], values[extra_at + 11]};
  return layout;
}

/// Deviation of a quantity from its expected magnitude, summed over rows.
class Misfit {
 public:
  void add(double off, double size) {
    off_ += off;
    size_ += size;
  }
  [[nodiscard]] bool none() const { return off_ <= tolerance * size_; }
  [[nodiscard]] bool is_zero() const { return size_ == 0; }

 private:
  double off_ = 0, size_ = 0;
};

/// A table whose ids are known, and the lines of centres of its pairs.
class Pairs {
 public:
  Pairs(const UnnamedTable& table, double length) : table_(table), length_(length) {}

  /// Whether two columns contain ids of pairs of grains.
  bool take_ids(std::size_t id1, std::size_t id2, const PackingBuilder& grains) {
    const std::size_t step = std::max<std::size_t>(1, table_.rows() / enough_rows);
    for (std::size_t row = 0; row < table_.rows(); row += step) {
      const auto a = grain(row, id1, grains), b = grain(row, id2, grains);
      if (!a || !b || *a == *b)
        return false;
      if (grains.ambiguous(*a, *b))
        continue; // it is not known which image the values are of
      const Vec3 branch = grains.nearest(grains.straight(*a, *b));
      if (norm(branch) > 0) {
        row_.push_back(row);
        branch_.push_back(branch);
      }
    }
    return true;
  }

  [[nodiscard]] bool bears_out(const Terms& terms, const ColumnGroup& values) const {
    std::size_t next = 0;
    bool good = true;
    if (terms.dist)
      good = good && is_distance(values[next++]);
    if (terms.difference) {
      good = good && is_difference(triple(values, next), false);
      next += 3;
    }
    if (terms.energy)
      good = good && is_zero(values[next++]);
    const std::size_t force = next;
    next += terms.force ? 1 : 0;
    const std::size_t vector = terms.swapped ? next + 3 : next,
                      extra = terms.vector && !terms.swapped ? next + 3 : next;
    if (terms.vector)
      good = good && is_normal_force(triple(values, vector), terms.force ? &values[force] : nullptr);
    else if (terms.force)
      good = good && is_repulsion(values[force]);
    if (terms.extra >= 3)
      good = good && is_across(triple(values, extra), terms.extra >= 4 ? &values[extra + 3] : nullptr);
    if (terms.extra == 12)
      good = good && is_difference(triple(values, extra + 9), true);
    return good;
  }

  /// Whether two layouts give the same forces.
  [[nodiscard]] bool same_forces(const ContactLayout& one, const ContactLayout& other) const {
    for (std::size_t k = 0; k < row_.size(); ++k)
      if (norm(whole_force(one, k) - whole_force(other, k)) > tolerance * norm(whole_force(one, k)))
        return false;
    return true;
  }

 private:
  static ColumnTriple triple(const ColumnGroup& values, std::size_t first) {
    return {values[first], values[first + 1], values[first + 2]};
  }
  [[nodiscard]] double value(std::size_t k, std::size_t column) const { return table_.at(row_[k], column); }
  [[nodiscard]] Vec3 vector(std::size_t k, const ColumnTriple& at) const {
    return {value(k, at[0]), value(k, at[1]), value(k, at[2])};
  }
  [[nodiscard]] Vec3 direction(std::size_t k) const { return (1 / norm(branch_[k])) * branch_[k]; }

  /// The grain with this id; empty if there is none.
  [[nodiscard]] std::optional<std::uint32_t> grain(std::size_t row, std::size_t column,
                                                   const PackingBuilder& grains) const {
    constexpr double largest = 1e15;
    const double id = table_.at(row, column);
    if (!(std::abs(id) <= largest) || id != std::floor(id))
      return std::nullopt;
    return grains.find(static_cast<long>(id));
  }

  /// Force on grain 1 [the table's unit].
  [[nodiscard]] Vec3 whole_force(const ContactLayout& layout, std::size_t k) const {
    Vec3 force{};
    if (layout.force)
      force = -value(k, *layout.force) * direction(k);
    else if (layout.normal)
      force = vector(k, *layout.normal);
    if (layout.tangential)
      force += vector(k, *layout.tangential);
    return force;
  }

  [[nodiscard]] bool is_distance(std::size_t column) const {
    Misfit misfit;
    for (std::size_t k = 0; k < row_.size(); ++k)
      misfit.add(std::abs(length_ * value(k, column) - norm(branch_[k])), norm(branch_[k]));
    return misfit.none();
  }
  [[nodiscard]] bool is_zero(std::size_t column) const {
    for (std::size_t k = 0; k < row_.size(); ++k)
      if (value(k, column) != 0)
        return false;
    return true;
  }
  /// x1 - x2, or, where the sign is free, x2 - x1.
  [[nodiscard]] bool is_difference(const ColumnTriple& at, bool signed_) const {
    Misfit misfit;
    for (std::size_t k = 0; k < row_.size(); ++k) {
      const Vec3 d = length_ * vector(k, at);
      const double off = norm(d + branch_[k]);
      misfit.add(signed_ ? off : std::min(off, norm(d - branch_[k])), norm(branch_[k]));
    }
    return misfit.none();
  }
  [[nodiscard]] bool is_repulsion(std::size_t column) const {
    double sum = 0;
    for (std::size_t k = 0; k < row_.size(); ++k)
      sum += value(k, column);
    return sum >= 0 && !is_distance(column);
  }
  /// Along the line of centres, repulsion in the mean, as long as the scalar where there is one.
  [[nodiscard]] bool is_normal_force(const ColumnTriple& at, const std::size_t* scalar) const {
    Misfit misfit;
    double sum = 0;
    for (std::size_t k = 0; k < row_.size(); ++k) {
      const Vec3 f = vector(k, at), n = direction(k);
      const double along = scalar != nullptr ? value(k, *scalar) : -dot(f, n);
      misfit.add(norm(f + along * n), std::max(norm(f), std::abs(along)));
      sum += along;
    }
    return misfit.none() && sum >= 0 && !is_difference(at, false);
  }
  /// Across the line of centres, as long as the scalar where there is one.
  [[nodiscard]] bool is_across(const ColumnTriple& at, const std::size_t* scalar) const {
    Misfit direction_misfit, size_misfit;
    for (std::size_t k = 0; k < row_.size(); ++k) {
      const Vec3 t = vector(k, at);
      direction_misfit.add(std::abs(dot(t, direction(k))), norm(t));
      if (scalar != nullptr)
        size_misfit.add(std::abs(norm(t) - value(k, *scalar)),
                        std::max(norm(t), std::abs(value(k, *scalar))));
    }
    return direction_misfit.none() && size_misfit.none();
  }

  const UnnamedTable& table_;
  double length_;
  std::vector<std::size_t> row_; ///< that is looked at
  std::vector<Vec3> branch_;     ///< from grain 1 to grain 2 [m]
};

/// The columns of all computes but one, in their order.
ColumnGroup others(const std::vector<ColumnGroup>& computes, std::size_t left_out) {
  ColumnGroup out;
  for (std::size_t k = 0; k < computes.size(); ++k)
    if (k != left_out)
      out.insert(out.end(), computes[k].begin(), computes[k].end());
  return out;
}

/// The column map of a layout.
std::string map_of(const ContactLayout& layout, const std::vector<std::string>& columns) {
  std::string text = "id1=" + columns[layout.id1] + ",id2=" + columns[layout.id2];
  if (layout.force)
    text += ",force=" + columns[*layout.force];
  const auto three = [&](const std::optional<ColumnTriple>& at, const char* stem) {
    for (int k = 0; at && k < 3; ++k)
      text += std::string(",") + stem + "xyz"[k] + "=" + columns[(*at)[static_cast<std::size_t>(k)]];
  };
  three(layout.force ? std::nullopt : layout.normal, "fn");
  three(layout.tangential, "ft");
  return text;
}

/// "c_cp[1] to c_cp[5]"
std::string span_text(const ColumnGroup& values, const std::vector<std::string>& columns) {
  return columns[values.front()] + (values.size() > 1 ? " to " + columns[values.back()] : "");
}

} // namespace

IdentifiedLayout layout_by_values(const UnnamedTable& table, const PackingBuilder& grains, double length) {
  if (table.rows() == 0)
    return {};
  if (table.computes.size() == 1)
    return liggghts_by_values(table, grains);
  std::vector<IdentifiedLayout> fits;
  std::string tried, maps;
  for (std::size_t ids = 0; ids < table.computes.size(); ++ids) {
    const ColumnGroup& atoms = table.computes[ids];
    Pairs pairs(table, length);
    if (!can_hold_ids(atoms) || !pairs.take_ids(atoms[0], atoms[1], grains))
      continue;
    const ColumnGroup values = others(table.computes, ids);
    for (const Terms& terms : orders_of(values.size())) {
      tried += (tried.empty() ? "" : "; ") + terms.words();
      if (!pairs.bears_out(terms, values))
        continue;
      const ContactLayout layout = layout_of(terms, atoms[0], atoms[1], values);
      if (!fits.empty() && pairs.same_forces(layout, fits.front().layout))
        continue;
      fits.push_back({layout,
                      span_text(values, table.columns) + " as " + terms.words() + " of compute pair/local",
                      terms.swapped});
      maps += (maps.empty() ? "" : " or ") + terms.words() + " with " + map_of(layout, table.columns);
    }
  }
  if (fits.size() == 1)
    return fits.front();
  if (fits.empty())
    grains.fail_contact(table.lines.front(),
                        "no columns agree with the positions of the grains" +
                            (tried.empty() ? std::string(": no column has ids of pairs of grains")
                                           : " (tried: " + tried + ")") +
                            "; name the columns with a column map, such as " + example_map(table.columns));
  grains.fail_contact(table.lines.front(),
                      "the columns can be read in " + std::to_string(fits.size()) +
                          " ways that give different forces; choose one by a column map: " + maps);
}

} // namespace granum::io
