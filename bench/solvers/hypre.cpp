// SPDX-License-Identifier: GPL-3.0-or-later
// BoomerAMG, one process. Interpolation: each of the six unknowns of a grain by itself ("unknown approach").
#include <memory>
#include <numeric>
#include <utility>

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <mpi.h>

#include "methods.hpp"

namespace granum::bench {

namespace {

void start() {
  MPI_Init(nullptr, nullptr);
  HYPRE_Init();
}

class Vector {
 public:
  explicit Vector(int rows) {
    HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, rows - 1, &ij_);
    HYPRE_IJVectorSetObjectType(ij_, HYPRE_PARCSR);
    HYPRE_IJVectorInitialize(ij_);
    HYPRE_IJVectorAssemble(ij_);
    void* object = nullptr;
    HYPRE_IJVectorGetObject(ij_, &object);
    par_ = static_cast<HYPRE_ParVector>(object);
  }
  Vector(const Vector&) = delete;
  Vector& operator=(const Vector&) = delete;
  ~Vector() { HYPRE_IJVectorDestroy(ij_); }
  void set(const double* x, const std::vector<int>& rows) {
    HYPRE_IJVectorSetValues(ij_, static_cast<int>(rows.size()), rows.data(), x);
  }
  void get(double* x, const std::vector<int>& rows) const {
    HYPRE_IJVectorGetValues(ij_, static_cast<int>(rows.size()), rows.data(), x);
  }
  [[nodiscard]] HYPRE_ParVector par() const { return par_; }

 private:
  HYPRE_IJVector ij_ = nullptr;
  HYPRE_ParVector par_ = nullptr;
};

class Amg {
 public:
  explicit Amg(Matrix&& matrix)
      : rows_(static_cast<std::size_t>(matrix.rows())), r_(matrix.rows()), z_(matrix.rows()) {
    std::iota(rows_.begin(), rows_.end(), 0);
    take(std::move(matrix));
    HYPRE_BoomerAMGCreate(&amg_);
    HYPRE_BoomerAMGSetPrintLevel(amg_, 0);
    HYPRE_BoomerAMGSetMaxIter(amg_, 1);
    HYPRE_BoomerAMGSetTol(amg_, 0);
    HYPRE_BoomerAMGSetNumFunctions(amg_, 6);
    HYPRE_BoomerAMGSetCoarsenType(amg_, 10); // HMIS
    HYPRE_BoomerAMGSetInterpType(amg_, 6);   // extended+i
    HYPRE_BoomerAMGSetPMaxElmts(amg_, 4);
    HYPRE_BoomerAMGSetStrongThreshold(amg_, 0.5); // recommended in three dimensions
    HYPRE_BoomerAMGSetRelaxType(amg_, 6);         // symmetric Gauss-Seidel
    HYPRE_BoomerAMGSetup(amg_, par_, r_.par(), z_.par());
    HYPRE_ClearAllErrors();
  }
  Amg(const Amg&) = delete;
  Amg& operator=(const Amg&) = delete;
  ~Amg() {
    HYPRE_BoomerAMGDestroy(amg_);
    HYPRE_IJMatrixDestroy(ij_);
  }

  void solve(const std::vector<double>& r, std::vector<double>& z) {
    r_.set(r.data(), rows_);
    z.assign(z.size(), 0);
    z_.set(z.data(), rows_);
    HYPRE_BoomerAMGSolve(amg_, par_, r_.par(), z_.par());
    HYPRE_ClearAllErrors();
    z_.get(z.data(), rows_);
  }

 private:
  void take(Matrix&& matrix) {
    const Matrix given = std::move(matrix);
    HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, given.rows() - 1, 0, given.rows() - 1, &ij_);
    HYPRE_IJMatrixSetObjectType(ij_, HYPRE_PARCSR);
    std::vector<int> count(rows_.size());
    for (std::size_t i = 0; i < count.size(); ++i)
      count[i] = given.row_start[i + 1] - given.row_start[i];
    HYPRE_IJMatrixSetRowSizes(ij_, count.data());
    HYPRE_IJMatrixInitialize(ij_);
    HYPRE_IJMatrixSetValues(ij_, given.rows(), count.data(), rows_.data(), given.column.data(),
                            given.value.data());
    HYPRE_IJMatrixAssemble(ij_);
    void* object = nullptr;
    HYPRE_IJMatrixGetObject(ij_, &object);
    par_ = static_cast<HYPRE_ParCSRMatrix>(object);
  }

  std::vector<int> rows_;
  Vector r_, z_;
  HYPRE_IJMatrix ij_ = nullptr;
  HYPRE_ParCSRMatrix par_ = nullptr;
  HYPRE_Solver amg_ = nullptr;
};

Preconditioner multigrid(const network::Backbone&, Matrix&& matrix) {
  const int rows = matrix.rows();
  const auto amg = std::make_shared<Amg>(std::move(matrix));
  return case_by_case(rows,
                      [amg](const std::vector<double>& r, std::vector<double>& z) { amg->solve(r, z); });
}

} // namespace

std::vector<Method> hypre_methods() { return {{.name = "hypre-amg", .make = multigrid, .start = start}}; }

} // namespace granum::bench
