// SPDX-License-Identifier: GPL-3.0-or-later
// granum's network solver beside those of libraries, on one packing; bench/solvers/run.sh runs it.
//   bench_solvers list                            names of the methods that were built
//   bench_solvers METHOD IN.data X Y Z THREADS    one 6x6 of so many copies (see bench_growth)
// Libraries get the assembled stiffness matrix, use one thread, and precondition the same block method of
// conjugate gradients, which applies the stiffness without a matrix, as granum does; -cg methods solve by
// themselves. Their time to number the grains and to assemble the matrix is shown apart; that of granum holds
// all. Memory is the most that the process held beyond what it held before, over the grains.
// Prints a line of a CSV table; fails where the 6x6 is not that of granum. Exit codes: 0 done, 1 something
// failed, 2 usage.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <malloc.h>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/network/linear_response.hpp>

#include "../meter.hpp"
#include "../stored_packing.hpp"
#include "methods.hpp"
#include "network/block_cg.hpp"
#include "network/contact_operator.hpp"

using namespace granum;
using namespace granum::bench;

namespace {

// That of network::ResponseOptions.
constexpr double tolerance = 1e-10;
constexpr int iteration_limit = 1000;
// Between two 6x6 whose error is of second order in that tolerance.
constexpr double agreement = 1e-8;

std::vector<Method> methods() {
  std::vector<Method> all;
  const auto add = [&](const std::vector<Method>& more) { all.insert(all.end(), more.begin(), more.end()); };
  add(eigen_methods());
#ifdef GRANUM_BENCH_CHOLMOD
  add(cholmod_methods());
#endif
#ifdef GRANUM_BENCH_HYPRE
  add(hypre_methods());
#endif
#ifdef GRANUM_BENCH_TRILINOS
  add(trilinos_methods());
#endif
  return all;
}

/// One row of the table; seconds.
struct Row {
  double assembly = 0, setup = 0, solution = 0, cpu = 0; ///< cpu of the latter two
  double bytes = 0;
  int iterations = 0;
  double residual = 0, difference = 0; ///< of the 6x6 from granum's, over its largest number
};

void print(const std::string& name, std::size_t grains, std::size_t threads, const Row& r) {
  std::printf("%s,%zu,%zu,%.4g,%.4g,%.4g,%.4g,%.0f,%d,%.2g,%.2g\n", name.c_str(), grains, threads, r.assembly,
              r.setup, r.solution, r.cpu, r.bytes / static_cast<double>(grains), r.iterations, r.residual,
              r.difference);
}

Row by_granum(const packing::Assembly& assembly, std::size_t threads) {
  const Meter meter;
  const network::Response response =
      network::linear_response(assembly, {.tolerance = tolerance, .threads = threads});
  return {.solution = meter.seconds(),
          .cpu = meter.cpu_seconds(),
          .bytes = meter.bytes(),
          .iterations = response.report().iterations,
          .residual = response.report().residual};
}

/// Of H q = -W: A + W^T q, over the volume.
elastic::Matrix6 relaxed(const packing::Assembly& assembly, const network::Backbone& backbone,
                         const Motions& load, const Motions& q) {
  const double unit =
      backbone.stiffness_scale * backbone.length_scale * backbone.length_scale / assembly.volume();
  const elastic::Matrix6 c =
      network::affine_energy(backbone) + network::products<6>(network::Workers(), load, q);
  return unit * (c + c.transpose()) / 2;
}

Row by(const Method& method, const packing::Assembly& assembly) {
  Row row;
  const Meter whole;
  const network::Backbone backbone = network::load_bearing_network(assembly, {});
  if (!backbone.rotations)
    throw std::invalid_argument("the packing has no friction");
  const Motions load = network::affine_forces<6>(backbone);
  Matrix matrix = assembled(backbone, method.shift);
  row.assembly = whole.seconds();
  const double cpu_before = whole.cpu_seconds();
  Solved solved;
  const auto solve = [&](const auto& made, const auto& with) {
    row.setup = whole.seconds() - row.assembly;
    solved = with(made);
    row.solution = whole.seconds() - row.assembly - row.setup;
  };
  if (method.make_solver)
    solve(method.make_solver(backbone, std::move(matrix)),
          [&](const auto& solver) { return solver(load, tolerance); });
  else
    solve(method.make(backbone, std::move(matrix)),
          [&](const Preconditioner& m) { return block_cg(backbone, load, m, tolerance, iteration_limit); });
  row.cpu = whole.cpu_seconds() - cpu_before;
  row.bytes = whole.bytes();
  row.iterations = solved.iterations;
  row.residual = solved.residual;
  const elastic::Matrix6 own = network::linear_response(assembly).relaxed().matrix;
  row.difference = (relaxed(assembly, backbone, load, solved.motions) - own).cwiseAbs().maxCoeff() /
                   own.cwiseAbs().maxCoeff();
  return row;
}

} // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> given(argv + 1, argv + argc);
  const std::vector<Method> all = methods();
  if (given.size() == 1 && given[0] == "list") {
    std::printf("granum\n");
    for (const Method& m : all)
      std::printf("%s\n", m.name.c_str());
    return 0;
  }
  const auto method = std::find_if(all.begin(), all.end(),
                                   [&](const Method& m) { return !given.empty() && m.name == given[0]; });
  if (given.size() != 6 || (given[0] != "granum" && method == all.end())) {
    std::fprintf(stderr, "usage: bench_solvers list | METHOD IN X Y Z THREADS\n");
    return 2;
  }
  const dem::Specimen state =
      side_by_side(load_packing(given[1]), count_of(given[2]), count_of(given[3]), count_of(given[4]));
  const packing::Assembly assembly =
      network_of(state, count_of(given[2]) * count_of(given[3]) * count_of(given[4]) > 1);
  if (method != all.end())
    method->start();
  malloc_trim(0);
  const std::size_t threads = count_of(given[5]);
  const Row row = given[0] == "granum" ? by_granum(assembly, threads) : by(*method, assembly);
  print(given[0], assembly.grain_count(), threads, row);
  const bool arrived = row.residual <= tolerance;
  if (arrived && !(row.difference <= agreement))
    throw std::runtime_error("the 6x6 is not that of granum");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench_solvers: %s\n", error.what());
  return 1;
}
