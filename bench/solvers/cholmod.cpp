// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

#include <cholmod.h>

#include "methods.hpp"

namespace granum::bench {

namespace {

/// An exact factor of the shifted matrix.
class Factor {
 public:
  Factor(Matrix&& matrix, int ordering) {
    cholmod_start(&common_);
    common_.nmethods = 1;
    common_.method[0].ordering = ordering;
    common_.postorder = 1;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.print = 0;
    Matrix given = std::move(matrix);
    cholmod_sparse h{};
    h.nrow = h.ncol = static_cast<std::size_t>(given.rows());
    h.nzmax = given.value.size();
    h.p = given.row_start.data();
    h.i = given.column.data();
    h.x = given.value.data();
    h.stype = -1; // the lower triangle is read
    h.itype = CHOLMOD_INT;
    h.xtype = CHOLMOD_REAL;
    h.dtype = CHOLMOD_DOUBLE;
    h.sorted = h.packed = 1;
    factor_ = cholmod_analyze(&h, &common_);
    if (factor_ == nullptr || cholmod_factorize(&h, factor_, &common_) == 0 || common_.status != CHOLMOD_OK)
      throw std::runtime_error("CHOLMOD: no factor, status " + std::to_string(common_.status));
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;
  ~Factor() {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }

  void solve(const Motions& r, Motions& z) {
    const std::size_t rows = 6 * r.size();
    cholmod_dense* right = cholmod_allocate_dense(rows, network::load_cases, rows, CHOLMOD_REAL, &common_);
    for (int c = 0; c < network::load_cases; ++c)
      take_case(r, c, static_cast<double*>(right->x) + static_cast<std::size_t>(c) * rows);
    cholmod_dense* left = cholmod_solve(CHOLMOD_A, factor_, right, &common_);
    for (int c = 0; c < network::load_cases; ++c)
      put_case(static_cast<const double*>(left->x) + static_cast<std::size_t>(c) * rows, c, z);
    cholmod_free_dense(&right, &common_);
    cholmod_free_dense(&left, &common_);
  }

 private:
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
};

Method with(const std::string& name, int ordering) {
  return {.name = name, .shift = 1e-10, .make = [ordering](const network::Backbone&, Matrix&& matrix) {
            const auto factor = std::make_shared<Factor>(std::move(matrix), ordering);
            return Preconditioner([factor](const Motions& r, Motions& z) { factor->solve(r, z); });
          }};
}

} // namespace

std::vector<Method> cholmod_methods() {
  return {with("cholmod-metis", CHOLMOD_METIS), with("cholmod-amd", CHOLMOD_AMD)};
}

} // namespace granum::bench
