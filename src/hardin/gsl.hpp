// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include <Eigen/Core>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_vector.h>

#include <granum/core/error.hpp>

namespace granum::hardin {

// Calls of GSL whose errors become exceptions: GSL's own error handler would abort the program.

/// GSL has one error handler for the whole program. While at least one object of this class exists, in any
/// thread, that handler is off, so that functions of GSL return their error; the last object puts back the
/// handler that the first one found. Checked by tests/hardin/test_gsl_errors.cpp
class GslErrorsReturned {
 public:
  GslErrorsReturned();
  GslErrorsReturned(const GslErrorsReturned&) = delete;
  GslErrorsReturned& operator=(const GslErrorsReturned&) = delete;
  ~GslErrorsReturned();
};

/// \throws   NotConverged naming the step, unless `code` is GSL_SUCCESS
void require_success(int code, const std::string& step);

using GslVector = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;
using GslMatrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;
using LinearWorkspace = std::unique_ptr<gsl_multifit_linear_workspace, decltype(&gsl_multifit_linear_free)>;

/// The handle, checked: GSL returns null where there is no memory.
/// \throws   Error if there is no memory, as the next three do
template <class Handle>
Handle required(Handle handle, std::size_t rows) {
  if (!handle)
    throw Error("no memory for a fit of " + std::to_string(rows) + " rows");
  return handle;
}
[[nodiscard]] GslVector allocated_vector(std::size_t size);
[[nodiscard]] GslMatrix allocated_matrix(std::size_t rows, std::size_t columns);
[[nodiscard]] LinearWorkspace allocated_linear_workspace(std::size_t rows, std::size_t parameters);

// Vectors and matrices of Eigen as those of GSL, and back.

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
