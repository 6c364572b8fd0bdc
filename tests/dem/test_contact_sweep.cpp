// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/contact_sweep.hpp"

#include <granum/dem/neighbours.hpp>

#include "dem/sweep/normal_forces.hpp"
#include "lattice_state.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::radius;

/// A lattice whose grains have been moved, so that some touch and some do not.
Specimen shaken_lattice(bool unequal) {
  Specimen state = test::fcc(radius, 4, 1e-6);
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    state.position[g] += 2e-6 * test::scatter(g);
    if (unequal)
      state.size.push_back(1 + 1e-3 * std::sin(static_cast<double>(g)));
  }
  return state;
}

template <class Row, class Sums>
struct Swept {
  Sums sums;
  std::vector<Row> load;
};

template <class AnyGrains>
AnyGrains grains_of(const Specimen& state) {
  AnyGrains grains;
  grains.resize(state.grain_count());
  grains.set_sizes(own_sizes(state, 2650));
  for (std::size_t g = 0; g < state.grain_count(); ++g)
    grains.set_centre(g, state.position[g]);
  return grains;
}

Partition parts_of(const Specimen& state) {
  return partition(neighbour_pairs(state.cell, state.position, 2.1 * radius), state.grain_count());
}

const contact::NormalKernel law = contact::NormalLaw(test::quartz_sphere(radius)).kernel();

Swept<LoadRow, SweepSums> smooth(const Specimen& state) {
  const auto grains = grains_of<Grains>(state);
  const Partition parts = parts_of(state);
  Swept<LoadRow, SweepSums> out{.sums = {}, .load = std::vector<LoadRow>(parts.rows)};
  const SweepInput input{.pairs = parts.pairs,
                         .grains = grains,
                         .cell = state.cell,
                         .gradient = {},
                         .diameter = 2 * radius * largest_size(state),
                         .unit_radius = radius,
                         .elapsed = 0,
                         .tangential_ratio = 0,
                         .friction = 0};
  for (const Chunk& chunk : parts.chunks)
    out.sums += contact_sweep(law, input, chunk, nullptr, out.load);
  return out;
}

Swept<PushRow, DescentSums> descending(const Specimen& state) {
  const auto grains = grains_of<TranslatingGrains>(state);
  const Partition parts = parts_of(state);
  Swept<PushRow, DescentSums> out{.sums = {}, .load = std::vector<PushRow>(parts.rows)};
  const DescentInput input{.pairs = parts.pairs,
                           .grains = grains,
                           .cell = state.cell,
                           .diameter = 2 * radius * largest_size(state),
                           .unit_radius = radius};
  for (const Chunk& chunk : parts.chunks)
    out.sums += descent_sweep(law, input, chunk, out.load);
  return out;
}

} // namespace

TEST_CASE("a descent gets the forces of a sweep without friction, to the bit, and their sums") {
  for (const bool unequal : {false, true}) {
    CAPTURE(unequal);
    const Specimen state = shaken_lattice(unequal);
    const auto whole = smooth(state);
    const auto part = descending(state);
    CHECK(whole.sums.contacts > 500);
    CHECK(whole.sums.contacts < 6 * state.grain_count());
    CHECK(part.sums.contacts == whole.sums.contacts);
    CHECK(part.sums.normal_force == whole.sums.normal_force);
    CHECK(part.sums.stiffest == whole.sums.stiffest);
    CHECK(part.sums.virial > 0);
    CHECK(part.sums.virial == doctest::Approx(trace(whole.sums.stress)).epsilon(1e-13));
    for (std::size_t g = 0; g < state.grain_count(); ++g)
      CHECK(force(part.load[g]) == force(whole.load[g]));
  }
}

namespace {

/// Hertz' kernel as one that has no vector code of its own.
struct PlainSphere {
  contact::SphereKernel hertz;
  contact::NormalResponse operator()(double overlap) const noexcept { return hertz(overlap); }
  [[nodiscard]] PlainSphere of_pair_radius(double ratio) const noexcept {
    return {hertz.of_pair_radius(ratio)};
  }
};

} // namespace

TEST_CASE("a kernel without vector code of its own has the sizes of a pair") {
  const contact::SphereKernel hertz{2e9};
  CHECK(normal_response<VectorLevel::baseline>(PlainSphere{hertz}, 0, 0, 0).force == 0);
  for (const double ratio : {0.4, 1.0, 1.7})
    for (const double overlap : {1e-9, 1e-8, 1e-6}) {
      const contact::NormalResponse found =
          normal_response<VectorLevel::baseline>(PlainSphere{hertz}, overlap, overlap / ratio, 0);
      const contact::NormalResponse expected = hertz.of_pair_radius(ratio)(overlap);
      CHECK(found.force == relative(expected.force, 1e-15));
      CHECK(found.stiffness == relative(expected.stiffness, 1e-15));
    }
}
