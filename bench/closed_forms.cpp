// SPDX-License-Identifier: GPL-3.0-or-later
// How long the closed forms take, one line a case in main(), and what the machine could do at best. Run by
// bench/run.sh; alone it takes the options of Google Benchmark.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/batch.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/rock_physics/sphere_packs.hpp>

#include "machine_limits.hpp"

namespace {

using namespace granum;
using namespace granum::effective;

constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
constexpr double radius = 5e-4;

contact::PowerLaw sphere() { return contact::PowerLaw::sphere(quartz, radius); }
contact::PowerLaw cone() { return contact::PowerLaw::cone(quartz, 0.4); }
contact::PowerLaw general() { return contact::PowerLaw::general(quartz, 1.5, 180); }
contact::PowerLaw flat() { return contact::PowerLaw::flat(quartz, 0.0114 * radius); }

State isotropic_state() {
  return {.law = sphere(),
          .tangential_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
          .radius = radius,
          .void_ratio = 0.6,
          .coordination_number = 6,
          .stress_v = 1e5,
          .stress_h = 1e5};
}

State anisotropic_state() {
  State state = isotropic_state();
  state.fabric_anisotropy = 0.2;
  state.stress_v = 2e5;
  return state;
}

/// Doubles on a cache line's boundary, all set.
class Array {
 public:
  explicit Array(std::size_t size) : values_(allocate(size)), size_(size) {}
  [[nodiscard]] double& operator[](std::size_t k) { return values_.get()[k]; }
  [[nodiscard]] std::span<double> span() const { return {values_.get(), size_}; }

 private:
  struct Free {
    void operator()(double* values) const { std::free(values); }
  };
  static double* allocate(std::size_t size) {
    const std::size_t bytes = (size * sizeof(double) + 63) / 64 * 64;
    auto* const values = static_cast<double*>(std::aligned_alloc(64, bytes));
    if (values == nullptr)
      throw std::bad_alloc();
    std::uninitialized_fill_n(values, size, 0.0);
    return values;
  }
  std::unique_ptr<double, Free> values_;
  std::size_t size_;
};

/// The same rows as numpy_baseline.py makes.
struct Columns {
  explicit Columns(std::size_t rows)
      : pressure(rows), coordination_number(rows), porosity(rows), bulk(rows), shear(rows) {
    for (std::size_t k = 0; k < rows; ++k) {
      const double x = static_cast<double>(k) / static_cast<double>(rows);
      pressure[k] = 1e4 + 1e6 * x;
      coordination_number[k] = 4 + 5 * x;
      porosity[k] = 0.3 + 0.15 * x;
    }
  }
  Array pressure, coordination_number, porosity, bulk, shear;
};

PackingBatch three_columns(const contact::NormalLaw& law, const Columns& in) {
  return {.law = law,
          .tangential_ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
          .radius = radius,
          .pressure = std::span<const double>(in.pressure.span()),
          .coordination_number = std::span<const double>(in.coordination_number.span()),
          .porosity = std::span<const double>(in.porosity.span())};
}

PackingBatch one_column(const contact::NormalLaw& law, const Columns& in) {
  PackingBatch batch = three_columns(law, in);
  batch.coordination_number = 6.0;
  batch.porosity = 0.375;
  return batch;
}

/// Registers a case that evaluates `points` points in one call. The table shows CPU time a point.
template <class Evaluate>
void add(const std::string& name, std::size_t points, Evaluate evaluate) {
  benchmark::RegisterBenchmark((name + "/" + std::to_string(points)).c_str(), [=](benchmark::State& state) {
    for ([[maybe_unused]] auto iteration : state)
      benchmark::DoNotOptimize(evaluate());
    state.counters["points"] = static_cast<double>(points);
  })->Unit(benchmark::kNanosecond);
}

std::size_t failed_rows(const PackingBatch& batch, const Columns& in) {
  const BatchReport report = uniform_strain(batch, {in.bulk.span(), in.shear.span()});
  return report.failed;
}

void add_batch(const std::string& name, const contact::NormalLaw& law, const Columns& in) {
  add("batch " + name, in.pressure.span().size(),
      [&in, batch = three_columns(law, in)] { return failed_rows(batch, in); });
}

void add_batch_of_pressures(const std::string& name, const contact::NormalLaw& law, const Columns& in) {
  add("batch " + name + ", p varies", in.pressure.span().size(),
      [&in, batch = one_column(law, in)] { return failed_rows(batch, in); });
}

void add_scalar_calls() {
  add("hertz_mindlin, rung 0", 1,
      [packing = rock_physics::SpherePacking{.shear_modulus = quartz.shear_modulus,
                                             .poisson_ratio = quartz.poisson_ratio,
                                             .porosity = 0.375,
                                             .coordination_number = 6,
                                             .pressure = 1e5}] {
        return rock_physics::hertz_mindlin(packing);
      });
  add("K and G, rung 0", 1, [state = isotropic_state()] { return uniform_strain(state); });
  add("6x6 with fabric from a state, rung 1", 1,
      [state = anisotropic_state()] { return voigt(uniform_strain_stiffness(uniform_contacts(state))); });
  add("6x6 with fabric from contacts, rung 1", 1, [contacts = uniform_contacts(anisotropic_state())] {
    return voigt(uniform_strain_stiffness(contacts));
  });
  add("five constants with fabric from contacts, rung 1", 1,
      [contacts = uniform_contacts(anisotropic_state())] { return uniform_strain_stiffness(contacts); });
  add("uniform strain by direction, rung 2", 1,
      [state = anisotropic_state()] { return uniform_strain(state); });
  add("uniform stress by direction, rung 2", 1,
      [state = anisotropic_state()] { return uniform_stress(state); });
  add("relaxed with standard error, rung 3", 1,
      [state = anisotropic_state()] { return relaxed(state, 6.2); });
  add("exponents m and n of G_vh, rung 2", 1,
      [state = anisotropic_state()] { return uniform_strain_exponents(state, Modulus::G_vh); });
}

void add_limits(const Columns& in) {
  const bench::Streams streams{in.pressure.span(), in.coordination_number.span(), in.porosity.span(),
                               in.bulk.span(), in.shear.span()};
  const std::size_t rows = in.pressure.span().size();
  add("limit: stream through caches", rows, [streams] {
    bench::stream_through_caches(streams);
    return streams.x.data();
  });
  add("limit: stream past caches", rows, [streams] {
    bench::stream_past_caches(streams);
    return streams.x.data();
  });
  if (bench::stream_whole_lines(streams))
    add("limit: stream of whole lines", rows, [streams] { return bench::stream_whole_lines(streams); });
}

/// Moduli of some rows, which the table compares with those of the baseline.
void add_results(const Columns& in) {
  (void)failed_rows(three_columns(sphere(), in), in);
  for (const std::size_t row : {0u, 1u, 500u, 998u, 999u})
    benchmark::AddCustomContext("moduli of row " + std::to_string(row),
                                exact_text(in.bulk.span()[row]) + " " + exact_text(in.shear.span()[row]));
}

} // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  const Columns thousand(1000), million(1000000);
  add_results(thousand);
  benchmark::AddCustomContext("vector lanes", std::to_string(bench::vector_lanes()));

  add_scalar_calls();
  add_batch("of spheres", sphere(), thousand);
  add("limit: multiply-add", bench::chain_instructions, [] { return bench::run_chains(0.9, 0.1); });
  add_batch_of_pressures("of spheres", sphere(), thousand);
  add_batch("of cones", cone(), thousand);
  add_batch("of alpha 1.5", general(), thousand);
  add_batch("of flat punches", flat(), thousand);
  add_batch("of spheres", sphere(), million);
  add_limits(million);
  add_batch_of_pressures("of spheres", sphere(), million);
  add_batch("of cones", cone(), million);
  add_batch("of alpha 1.5", general(), million);
  add_batch("of flat punches", flat(), million);

  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
