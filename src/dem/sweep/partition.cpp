// SPDX-License-Identifier: GPL-3.0-or-later
#include "partition.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include <granum/core/error.hpp>

namespace granum::dem {

namespace {

/// Least number of grains in a chunk: with fewer, more of their pairs cross its boundary.
constexpr std::size_t smallest_chunk = 1024;

/// Assigns rows to the pairs of one chunk: spare ones if j is after the chunk.
class SpareRows {
 public:
  explicit SpareRows(std::size_t grains) : row_(grains, 0) {}

  std::uint32_t row(std::uint32_t j, const Chunk& chunk, std::size_t& rows) {
    if (j < chunk.grains.end)
      return j;
    if (row_[j] < chunk.spare_rows.begin) {
      row_[j] = static_cast<std::uint32_t>(rows++);
      additions_.push_back({row_[j], j});
    }
    return row_[j];
  }
  [[nodiscard]] const std::vector<Addition>& additions() const { return additions_; }

 private:
  std::vector<std::uint32_t> row_; ///< of each grain, the last one given
  std::vector<Addition> additions_;
};

/// Ends of chunks of equal work; a grain takes about as long as a pair.
std::vector<std::size_t> chunk_ends(const std::vector<Pair>& pairs, std::size_t grains, std::size_t count) {
  std::vector<std::size_t> ends(count, grains);
  const auto past = [](std::size_t g, const Pair& pair) { return g < pair.i; };
  for (std::size_t c = 0; c + 1 < count; ++c) {
    // The first grain at which the share of grains and pairs is reached.
    const auto upto = [&](std::size_t g) {
      const auto before = std::upper_bound(pairs.begin(), pairs.end(), g, past) - pairs.begin();
      return count * (static_cast<std::size_t>(before) + g + 1) >= (c + 1) * (pairs.size() + grains);
    };
    std::size_t low = c == 0 ? 0 : std::min(ends[c - 1], grains - 1), high = grains - 1;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (upto(middle))
        high = middle;
      else
        low = middle + 1;
    }
    ends[c] = low + 1;
  }
  return ends;
}

/// Sorts the additions by the chunk of their grain, stably.
void sort_additions(const std::vector<Addition>& additions, std::size_t grains, Partition& out) {
  std::vector<std::uint32_t> chunk_of(grains);
  for (std::size_t c = 0; c < out.chunks.size(); ++c)
    std::fill(chunk_of.begin() + static_cast<std::ptrdiff_t>(out.chunks[c].grains.begin),
              chunk_of.begin() + static_cast<std::ptrdiff_t>(out.chunks[c].grains.end),
              static_cast<std::uint32_t>(c));
  for (const Addition& addition : additions)
    ++out.chunks[chunk_of[addition.grain]].additions.end;
  std::size_t before = 0;
  for (Chunk& chunk : out.chunks) {
    const std::size_t count = chunk.additions.end;
    chunk.additions = {before, before};
    before += count;
  }
  out.additions.resize(additions.size());
  for (const Addition& addition : additions)
    out.additions[out.chunks[chunk_of[addition.grain]].additions.end++] = addition;
}

} // namespace

std::size_t Partition::chunk_of(std::uint32_t grain) const {
  const auto past = [](std::uint32_t g, const Chunk& chunk) { return g < chunk.grains.end; };
  return static_cast<std::size_t>(std::upper_bound(chunks.begin(), chunks.end(), grain, past) -
                                  chunks.begin());
}

Partition partition(const std::vector<Pair>& pairs, std::size_t grains) {
  const std::size_t count = std::bit_floor(std::max<std::size_t>(1, grains / smallest_chunk));
  const std::vector<std::size_t> ends = chunk_ends(pairs, grains, count);
  Partition out;
  out.rows = grains;
  out.pairs.reserve(pairs.size() + count * block_size);
  SpareRows spare(grains);
  auto next = pairs.begin();
  for (std::size_t c = 0; c < count; ++c) {
    Chunk chunk;
    chunk.grains = {out.chunks.empty() ? 0 : out.chunks.back().grains.end, ends[c]};
    chunk.pairs.begin = out.pairs.size();
    chunk.spare_rows.begin = out.rows;
    for (; next != pairs.end() && next->i < chunk.grains.end; ++next)
      out.pairs.emplace_back(RowPlace::of(next->i), RowPlace::of(next->j), RowPlace::of(next->image),
                             RowPlace::of(spare.row(next->j, chunk, out.rows)));
    const RowPlace own = RowPlace::of(static_cast<std::uint32_t>(chunk.grains.begin));
    while ((out.pairs.size() - chunk.pairs.begin) % block_size != 0)
      out.pairs.emplace_back(own, own, far_image, own);
    chunk.pairs.end = out.pairs.size();
    chunk.spare_rows.end = out.rows;
    out.chunks.push_back(chunk);
  }
  if (out.rows > RowPlace::most_rows)
    throw InvalidArgument("grains and spare rows of a list of pairs: " + std::to_string(out.rows) +
                          " [1], allowed: at most " + std::to_string(RowPlace::most_rows));
  sort_additions(spare.additions(), grains, out);
  return out;
}

} // namespace granum::dem
