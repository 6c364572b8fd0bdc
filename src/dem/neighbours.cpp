// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: s fractional coordinates, x = cell s; bins are slices of s.
#include <granum/dem/neighbours.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/packing/assembly.hpp>

#include "dem/sweep/verlet_list.hpp"

namespace granum::dem {

namespace {

/// Image of a pair inside the cell.
constexpr std::uint32_t no_shift = 13;

struct Bins {
  std::array<int, 3> count{};
  std::vector<std::uint32_t> start; ///< first entry of a bin in grain
  std::vector<std::uint32_t> grain;

  [[nodiscard]] std::size_t index(int bx, int by, int bz) const {
    return static_cast<std::size_t>((bx * count[1] + by) * count[2] + bz);
  }
};

/// The integer part of a coordinate within two bounds; infinity and NaN, from absurd speeds, give a bound.
int whole_within(double place, int low, int high) {
  return place > low ? static_cast<int>(std::min(std::floor(place), static_cast<double>(high))) : low;
}

std::array<int, 3> bin_of(const Bins& bins, const Vec3& s) {
  std::array<int, 3> b{};
  for (int k = 0; k < 3; ++k) {
    const int count = bins.count[static_cast<std::size_t>(k)];
    b[static_cast<std::size_t>(k)] = whole_within(s[k] * count, 0, count - 1);
  }
  return b;
}

/// Bins on each axis, none narrower than the cutoff. Of a nearly empty cell the bins are wider, so that their
/// number stays in proportion to that of the grains: dense packings have less than one bin per grain.
std::array<int, 3> bin_counts(const Mat3& cell, std::size_t grains, double cutoff) {
  const Vec3 widths = packing::cell_widths(cell);
  std::array<int, 3> count{};
  for (int k = 0; k < 3; ++k)
    count[static_cast<std::size_t>(k)] = whole_within(widths[k] / cutoff, 1, 512);
  const double most = 64 + 8 * static_cast<double>(grains);
  while (static_cast<double>(count[0]) * count[1] * count[2] > most) {
    int& finest = *std::max_element(count.begin(), count.end());
    finest = (finest + 1) / 2;
  }
  return count;
}

Bins fill_bins(const Mat3& cell, std::span<const Vec3> position, double cutoff) {
  Bins bins;
  bins.count = bin_counts(cell, position.size(), cutoff);
  const auto total = static_cast<std::size_t>(bins.count[0]) * static_cast<std::size_t>(bins.count[1]) *
                     static_cast<std::size_t>(bins.count[2]);
  const Mat3 to_fraction = inverse_of(cell);
  std::vector<std::uint32_t> bin(position.size());
  bins.start.assign(total + 1, 0);
  for (std::size_t g = 0; g < position.size(); ++g) {
    const auto [bx, by, bz] = bin_of(bins, to_fraction * position[g]);
    bin[g] = static_cast<std::uint32_t>(bins.index(bx, by, bz));
    ++bins.start[bin[g] + 1];
  }
  for (std::size_t b = 0; b < total; ++b)
    bins.start[b + 1] += bins.start[b];
  bins.grain.resize(position.size());
  std::vector<std::uint32_t> next(bins.start.begin(), bins.start.end() - 1);
  for (std::size_t g = 0; g < position.size(); ++g)
    bins.grain[next[bin[g]]++] = static_cast<std::uint32_t>(g);
  return bins;
}

/// Neighbour bin of b at offset d on an axis of count bins, and the whole cells crossed.
struct Neighbour {
  int bin;
  int shift;
};
Neighbour neighbour(int b, int d, int count) {
  const int raw = b + d;
  if (raw < 0)
    return {raw + count, -1};
  if (raw >= count)
    return {raw - count, 1};
  return {raw, 0};
}

/// Bins on an axis around a bin, itself included.
struct Offsets {
  int first = -1;
  int last = 1;
};

/// Calls visit(first, last, image) for the bin at an offset from a home, with its range in Bins::grain.
template <class Visit>
void visit_bin(const Bins& bins, const std::array<int, 3>& home, const std::array<int, 3>& offset,
               Images images, const Visit& visit) {
  const Neighbour nx = neighbour(home[0], offset[0], bins.count[0]);
  const Neighbour ny = neighbour(home[1], offset[1], bins.count[1]);
  const Neighbour nz = neighbour(home[2], offset[2], bins.count[2]);
  const auto image = static_cast<std::uint32_t>(image_index(nx.shift, ny.shift, nz.shift));
  if (images == Images::none && image != no_shift)
    return;
  const std::size_t b = bins.index(nx.bin, ny.bin, nz.bin);
  visit(bins.start[b], bins.start[b + 1], image);
}

/// The same for all bins around a bin. With few bins the outer offsets repeat bins, but with other shifts.
template <class Visit>
void each_near(const Bins& bins, const std::array<int, 3>& home, const std::array<Offsets, 3>& around,
               Images images, const Visit& visit) {
  for (int dx = around[0].first; dx <= around[0].last; ++dx)
    for (int dy = around[1].first; dy <= around[1].last; ++dy)
      for (int dz = around[2].first; dz <= around[2].last; ++dz)
        visit_bin(bins, home, {dx, dy, dz}, images, visit);
}

/// The same for one half of the bins next to a bin; the other half finds this one. Consecutive bins form one
/// range.
template <class Visit>
void each_ahead(const Bins& bins, const std::array<int, 3>& home, Images images, const Visit& visit) {
  std::uint32_t begin = 0, end = 0, shift = no_shift;
  const auto join = [&](std::uint32_t first, std::uint32_t last, std::uint32_t image) {
    if (first != end || image != shift) {
      visit(begin, end, shift);
      begin = first;
      shift = image;
    }
    end = last;
  };
  for (int dx = 0; dx <= 1; ++dx)
    for (int dy = dx == 0 ? 0 : -1; dy <= 1; ++dy)
      for (int dz = dx == 0 && dy == 0 ? 1 : -1; dz <= 1; ++dz)
        visit_bin(bins, home, {dx, dy, dz}, images, join);
  visit(begin, end, shift);
}

/// The bins within a distance of s; at most half of the cell, so that no bin occurs twice.
std::array<Offsets, 3> bins_within(const Bins& bins, const Vec3& s, const std::array<int, 3>& home,
                                   const Vec3& widths, double distance) {
  std::array<Offsets, 3> around;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    const int count = bins.count[axis];
    const double place = s[k] * count, reach = distance / widths[k] * count;
    around[axis] = {whole_within(place - reach, home[axis] - count, home[axis]) - home[axis],
                    whole_within(place + reach, home[axis], home[axis] + count) - home[axis]};
  }
  return around;
}

void require_cutoff(const Mat3& cell, double cutoff, Images images) {
  const Vec3 widths = packing::cell_widths(cell);
  const double narrowest = images == Images::periodic ? std::min({widths.x, widths.y, widths.z})
                                                      : std::numeric_limits<double>::infinity();
  if (!(cutoff > 0) || !(2 * cutoff <= narrowest))
    throw InvalidArgument("neighbour cutoff", cutoff, "m",
                          "(0, half of the smallest cell width " + std::to_string(narrowest) +
                              " m]; the specimen has too few grains");
}

/// Sorts by one of both grains; pairs of the same grain keep their order.
template <class GrainOf>
void sort_by(std::vector<Pair>& pairs, std::size_t grains, std::vector<Pair>& spare, const GrainOf& grain) {
  std::vector<std::uint32_t> next(grains + 1, 0);
  for (const Pair& pair : pairs)
    ++next[grain(pair) + 1];
  for (std::size_t g = 0; g < grains; ++g)
    next[g + 1] += next[g];
  spare.resize(pairs.size());
  for (const Pair& pair : pairs)
    spare[next[grain(pair)]++] = pair;
  pairs.swap(spare);
}

/// Sorts by (i, j).
void sort_pairs(std::vector<Pair>& pairs, std::size_t grains) {
  std::vector<Pair> spare;
  sort_by(pairs, grains, spare, [](const Pair& pair) { return pair.j; });
  sort_by(pairs, grains, spare, [](const Pair& pair) { return pair.i; });
}

} // namespace

std::array<Vec3, image_count> shift_vectors(const Mat3& cell) {
  std::array<Vec3, image_count> shifts;
  for (int kx = -1; kx <= 1; ++kx)
    for (int ky = -1; ky <= 1; ++ky)
      for (int kz = -1; kz <= 1; ++kz)
        shifts[static_cast<std::size_t>(image_index(kx, ky, kz))] =
            cell * Vec3{static_cast<double>(kx), static_cast<double>(ky), static_cast<double>(kz)};
  return shifts;
}

void wrap(const Mat3& cell, std::span<Vec3> position) {
  wrap_each(cell, position, [](std::size_t /*grain*/, const Vec3& /*whole*/) {});
}

std::vector<Pair> neighbour_pairs(const Mat3& cell, std::span<const Vec3> position, double cutoff,
                                  Images images) {
  require_cutoff(cell, cutoff, images);
  const Bins bins = fill_bins(cell, position, cutoff);
  const std::array<Vec3, image_count> shifts = shift_vectors(cell);
  std::vector<Vec3> centre; // in the order of the bins, to be read one after the other
  centre.reserve(position.size());
  for (const std::uint32_t g : bins.grain)
    centre.push_back(position[g]);
  std::vector<Pair> pairs;
  pairs.reserve(position.size() * 4);
  const EqualReach near(shifts, position, cutoff);
  const auto add_if_near = [&](std::uint32_t i, std::uint32_t j, std::uint32_t image) {
    const Pair pair = i < j ? Pair{i, j, image} : Pair{j, i, opposite(image)};
    if (near(pair))
      pairs.push_back(pair);
  };
  std::vector<std::uint32_t> found(position.size());
  // Pairs of a grain with those in a range. The distance may differ in the last digit when computed from the
  // other grain, so the first test is generous. It has no branch, because none could be predicted.
  const double generous = cutoff * cutoff * (1 + 1e-9);
  const auto look_at = [&](std::uint32_t a, std::uint32_t first, std::uint32_t last, std::uint32_t image) {
    const Vec3 from = centre[a] - shifts[image];
    std::size_t count = 0;
    for (std::uint32_t b = first; b < last; ++b) {
      const Vec3 branch = centre[b] - from;
      found[count] = b;
      count += static_cast<std::size_t>(dot(branch, branch) < generous);
    }
    for (std::size_t k = 0; k < count; ++k)
      add_if_near(bins.grain[a], bins.grain[found[k]], image);
  };
  const auto look_ahead = [&](const std::array<int, 3>& home) {
    const std::size_t own = bins.index(home[0], home[1], home[2]);
    const std::uint32_t begin = bins.start[own], end = bins.start[own + 1];
    for (std::uint32_t a = begin; a < end; ++a)
      look_at(a, a + 1, end, no_shift);
    each_ahead(bins, home, images, [&](std::uint32_t first, std::uint32_t last, std::uint32_t image) {
      for (std::uint32_t a = begin; a < end; ++a)
        look_at(a, first, last, image);
    });
  };
  for (int bx = 0; bx < bins.count[0]; ++bx)
    for (int by = 0; by < bins.count[1]; ++by) {
      stop_point();
      for (int bz = 0; bz < bins.count[2]; ++bz)
        look_ahead({bx, by, bz});
    }
  sort_pairs(pairs, position.size());
  return pairs;
}

std::vector<Pair> neighbour_pairs(const Mat3& cell, std::span<const Vec3> position,
                                  std::span<const double> radius, double gap, Images images) {
  if (radius.size() != position.size())
    throw InvalidArgument("neighbour pairs: " + std::to_string(radius.size()) + " radii of " +
                          std::to_string(position.size()) + " grains");
  if (radius.empty())
    return {};
  const double largest = *std::max_element(radius.begin(), radius.end());
  const double mean = std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(radius.size());
  require_cutoff(cell, 2 * largest + gap, images);
  const Vec3 widths = packing::cell_widths(cell);
  const Bins bins = fill_bins(cell, position, 2 * mean + gap);
  const std::array<Vec3, image_count> shifts = shift_vectors(cell);
  const Mat3 to_fraction = inverse_of(cell);
  std::vector<Pair> pairs;
  pairs.reserve(position.size() * 4);
  const UnequalReach near(shifts, position, radius, gap);
  const auto add_if_near = [&](std::uint32_t i, std::uint32_t j, std::uint32_t image) {
    if (radius[j] > radius[i] || (radius[j] == radius[i] && j <= i))
      return;
    if (near.to_smaller(i, j, image))
      pairs.push_back(i < j ? Pair{i, j, image} : Pair{j, i, opposite(image)});
  };
  for (std::uint32_t i = 0; i < position.size(); ++i) {
    stop_point(i);
    const Vec3 s = to_fraction * position[i];
    const std::array<int, 3> home = bin_of(bins, s);
    each_near(bins, home, bins_within(bins, s, home, widths, 2 * radius[i] + gap), images,
              [&](std::uint32_t first, std::uint32_t last, std::uint32_t image) {
                for (std::uint32_t k = first; k < last; ++k)
                  add_if_near(i, bins.grain[k], image);
              });
  }
  sort_pairs(pairs, position.size());
  return pairs;
}

} // namespace granum::dem
