// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "block_cg.hpp"

namespace granum::bench {

/// One way to solve H q = -W beside granum's own: a library's preconditioner in block_cg, or a library's
/// solver.
struct Method {
  std::string name;
  /// Added to the diagonal of the matrix that the library gets, over its mean: loose networks have motions
  /// that nothing resists.
  double shift = 1e-6;
  /// What the library makes of the matrix, which is given away.
  std::function<Preconditioner(const network::Backbone& backbone, Matrix&& matrix)> make;
  /// Where the library solves by itself, in place of `make`: made at once, and called with -load.
  std::function<std::function<Solved(const Motions& load, double tolerance)>(
      const network::Backbone& backbone, Matrix&& matrix)>
      make_solver = {};
  /// What the library needs once in a process, before it is measured.
  std::function<void()> start = [] {};
};

/// Rows of the table, of each library that was there when this was built.
[[nodiscard]] std::vector<Method> eigen_methods();
[[nodiscard]] std::vector<Method> cholmod_methods();
[[nodiscard]] std::vector<Method> hypre_methods();
[[nodiscard]] std::vector<Method> trilinos_methods();

} // namespace granum::bench
