// SPDX-License-Identifier: GPL-3.0-or-later
// Alone in this source, because Eigen's solver takes long to compile.
#include <granum/elastic/eigen_system.hpp>

#include "core/compiled_once.hpp"

namespace granum::elastic {

EigenSystem eigen_system(const Matrix6& symmetric) {
  const SymmetricEigen<6> system = symmetric_eigen<6>(symmetric);
  return {.values = system.values, .vectors = system.vectors};
}

} // namespace granum::elastic
