// SPDX-License-Identifier: GPL-3.0-or-later
#include "gsl.hpp"

#include <mutex>

namespace granum::hardin {

namespace {

std::mutex handler_mutex;
std::size_t users = 0; ///< objects of GslErrorsReturned that exist
gsl_error_handler_t* handler_before = nullptr;

} // namespace

GslErrorsReturned::GslErrorsReturned() {
  const std::lock_guard lock(handler_mutex);
  if (users++ == 0)
    handler_before = gsl_set_error_handler_off();
}

GslErrorsReturned::~GslErrorsReturned() {
  const std::lock_guard lock(handler_mutex);
  if (--users == 0)
    gsl_set_error_handler(handler_before);
}

void require_success(int code, const std::string& step) {
  if (code != GSL_SUCCESS)
    throw NotConverged(step + " failed: " + gsl_strerror(code));
}

GslVector allocated_vector(std::size_t size) {
  return required(GslVector(gsl_vector_alloc(size), gsl_vector_free), size);
}

GslMatrix allocated_matrix(std::size_t rows, std::size_t columns) {
  return required(GslMatrix(gsl_matrix_alloc(rows, columns), gsl_matrix_free), rows);
}

LinearWorkspace allocated_linear_workspace(std::size_t rows, std::size_t parameters) {
  return required(LinearWorkspace(gsl_multifit_linear_alloc(rows, parameters), gsl_multifit_linear_free),
                  rows);
}

} // namespace granum::hardin
