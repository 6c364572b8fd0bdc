// SPDX-License-Identifier: GPL-3.0-or-later
// The contact sweep of the DEM engine (sphere law, friction, one core) beside what this machine's arithmetic
// and memory can do, measured in turn in one run. Writes a table to standard output; takes no arguments.
//
// Work of a listed pair, counted in src/dem/contact_sweep.cpp: sums, products, quotients and roots, each as
// one operation, and a product that is fused with a sum as one too, as in what the machine's arithmetic is
// measured by; whether or not the pair touches. Comparisons, moves and turning rows into columns are not
// counted, though they take the same ports.
#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <vector>

#include <granum/dem/engine.hpp>

#include "dem/sweep/contact_sweep.hpp"
#include "dem/sweep/grain_rows.hpp"
#include "dem/sweep/verlet_list.hpp"
#include "machine_limits.hpp"
#include "specimens.hpp"

namespace {

using namespace granum;

constexpr double root_work = 11;   // inverse_root: h 2, near 4, rest 2, and 3
constexpr double branch_work = 17; // rows of i and j and the image, 8 places, 2 each; spin_y
constexpr double normal_work = 3 + root_work + 1 + (root_work + 4) + 4;
constexpr double shear_work = 6 + 3 * 4 + 3 + 3 * 2 + 5 + 3 + 1 + 3 + 1 + 3 + 3 * 3;
constexpr double sums_work = 9 + 1 + 1 + 1;
constexpr double unload_work = 16;
constexpr double work_of_pair = branch_work + normal_work + shear_work + sums_work + unload_work;

/// What a sweep reads and writes once: pair, memory (both ways); of a grain its motion, and its load, which
/// is set to zero and added to.
constexpr double bytes_of_pair = sizeof(dem::ListedPair) + 2.0 * sizeof(dem::MemoryBlock) / dem::block_size;
constexpr double bytes_of_grain = sizeof(dem::MotionRow) + sizeof(double) + 2.0 * sizeof(dem::LoadRow);

volatile double sink = 0; // what a measured call finds goes here, so that it is not left out

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds of one call, from some tenth of a second of them.
template <class Call>
double time_of(const Call& call) {
  constexpr double least = 0.1;
  call();
  for (std::size_t calls = 1;; calls *= 2) {
    const double begin = processor_seconds();
    for (std::size_t k = 0; k < calls; ++k)
      call();
    const double seconds = processor_seconds() - begin;
    if (seconds > least)
      return seconds / static_cast<double>(calls);
  }
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// The parts of an engine that a sweep needs.
class Sweep {
 public:
  explicit Sweep(const dem::Specimen& start)
      : state_(dem::reordered(start, dem::near_order(start))), list_(state_, 0.02) {
    list_.build(state_);
    parts_ = dem::partition(list_.pairs(), state_.grain_count());
    grains_.resize(state_.grain_count());
    for (std::size_t g = 0; g < grains_.size(); ++g) {
      grains_.set_centre(g, state_.position[g]);
      grains_.set_velocity(g, state_.velocity[g]);
    }
    memory_.assign(parts_.pairs.size() / dem::block_size, dem::MemoryBlock{});
    load_.resize(parts_.rows);
  }

  double run() {
    const dem::Material material = bench::material(0.5);
    const dem::SweepInput input{.pairs = parts_.pairs,
                                .grains = grains_,
                                .cell = state_.cell,
                                .gradient = {},
                                .diameter = 2 * state_.radius,
                                .unit_radius = state_.radius,
                                .elapsed = 1e-12, // forces stay where they are
                                .tangential_ratio = material.tangential_ratio,
                                .friction = material.friction_coefficient};
    double force = 0;
    for (const dem::Chunk& chunk : parts_.chunks)
      force += dem::contact_sweep(law_, input, chunk, memory_.data(), load_).normal_force;
    return force;
  }

  [[nodiscard]] double pairs() const { return static_cast<double>(parts_.pairs.size()); }
  [[nodiscard]] double bytes() const {
    return bytes_of_pair * pairs() + bytes_of_grain * static_cast<double>(grains_.size());
  }

 private:
  dem::Specimen state_;
  dem::VerletList list_;
  dem::Partition parts_;
  dem::Grains grains_;
  std::vector<dem::MemoryBlock> memory_;
  std::vector<dem::LoadRow> load_;
  contact::NormalKernel law_ = bench::material(0.5).law.kernel();
};

/// Bytes a second that go through five columns which together take as much room.
double stream_rate(double bytes) {
  const auto rows = static_cast<std::size_t>(bytes / (5 * sizeof(double))) / 8 * 8;
  std::array<std::vector<double>, 5> columns;
  columns.fill(std::vector<double>(rows, 1.0));
  const bench::Streams streams{columns[0], columns[1], columns[2], columns[3], columns[4]};
  return static_cast<double>(5 * sizeof(double) * rows) /
         time_of([&] { bench::stream_through_caches(streams); });
}

/// Operations a second, on all places of a vector.
double arithmetic_rate() {
  const double seconds = time_of([] { sink = bench::run_chains(0.5, 1.0); });
  return static_cast<double>(bench::chain_instructions * bench::vector_lanes()) / seconds;
}

void measure(const dem::Specimen& start) {
  constexpr int rounds = 7;
  Sweep sweep(start);
  std::vector<double> per_pair, arithmetic, memory, share;
  for (int round = 0; round < rounds; ++round) {
    const double limit_of_arithmetic = work_of_pair / arithmetic_rate();
    const double limit_of_memory = sweep.bytes() / sweep.pairs() / stream_rate(sweep.bytes());
    const double pair = time_of([&] { sink = sweep.run(); }) / sweep.pairs();
    per_pair.push_back(pair);
    arithmetic.push_back(limit_of_arithmetic);
    memory.push_back(limit_of_memory);
    share.push_back(std::max(limit_of_arithmetic, limit_of_memory) / pair);
  }
  const double grains = static_cast<double>(start.grain_count());
  std::printf("| %.0f | %.2f | %.0f | %.0f | %.2f | %.2f | %.2f | %.0f%% |\n", grains, sweep.pairs() / grains,
              work_of_pair, sweep.bytes() / sweep.pairs(), 1e9 * median(arithmetic), 1e9 * median(memory),
              1e9 * median(per_pair), 100 * median(share));
}

} // namespace

int main() {
  std::printf(
      "Vectors of %zu doubles. Medians of 7 rounds, in nanoseconds of processor time a listed pair.\n\n"
      "| grains | pairs a grain | operations a pair | bytes a pair | arithmetic | memory | sweep | share |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n",
      bench::vector_lanes());
  const dem::Specimen thousand = bench::thousand_grains();
  measure(bench::repeated(thousand, 1, 1, 1));
  measure(bench::repeated(thousand, 5, 2, 1));
  measure(bench::repeated(thousand, 5, 5, 4));
  return 0;
}
