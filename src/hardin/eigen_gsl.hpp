// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "gsl_errors.hpp"

/// Vectors and matrices of Eigen as those of GSL, and back.
namespace granum::hardin {

inline Eigen::VectorXd vector_of(const gsl_vector* v) {
  Eigen::VectorXd copy(static_cast<Eigen::Index>(v->size));
  for (std::size_t k = 0; k < v->size; ++k)
    copy[static_cast<Eigen::Index>(k)] = gsl_vector_get(v, k);
  return copy;
}

inline void copy_to(const Eigen::VectorXd& from, gsl_vector* to) {
  for (std::size_t k = 0; k < to->size; ++k)
    gsl_vector_set(to, k, from[static_cast<Eigen::Index>(k)]);
}

inline void copy_to(const Eigen::MatrixXd& from, gsl_matrix* to) {
  for (std::size_t i = 0; i < to->size1; ++i)
    for (std::size_t j = 0; j < to->size2; ++j)
      gsl_matrix_set(to, i, j, from(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
}

inline GslMatrix gsl_matrix_of(const Eigen::MatrixXd& from) {
  GslMatrix to =
      allocated_matrix(static_cast<std::size_t>(from.rows()), static_cast<std::size_t>(from.cols()));
  copy_to(from, to.get());
  return to;
}

} // namespace granum::hardin
