// SPDX-License-Identifier: GPL-3.0-or-later
// One process: smoothed aggregation of ML with the six rigid motions, and incomplete factors of Ifpack.
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_Vector.h>
#include <Ifpack.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#include <mpi.h>

#include "methods.hpp"

namespace granum::bench {

namespace {

void start() { MPI_Init(nullptr, nullptr); }

/// Matrix and preconditioner, which refers to it.
struct Held {
  std::unique_ptr<Epetra_Map> map;
  std::unique_ptr<Epetra_CrsMatrix> matrix;
  std::vector<double> motions; ///< that ML refers to
  std::unique_ptr<Epetra_Operator> inverse;
};

std::unique_ptr<Held> hold(Matrix&& matrix) {
  const Matrix given = std::move(matrix);
  const Epetra_MpiComm alone(MPI_COMM_SELF);
  auto held = std::make_unique<Held>();
  held->map = std::make_unique<Epetra_Map>(given.rows(), 0, alone);
  std::vector<int> count(static_cast<std::size_t>(given.rows()));
  for (std::size_t i = 0; i < count.size(); ++i)
    count[i] = given.row_start[i + 1] - given.row_start[i];
  held->matrix = std::make_unique<Epetra_CrsMatrix>(Copy, *held->map, count.data(), true);
  for (std::size_t i = 0; i < count.size(); ++i)
    held->matrix->InsertGlobalValues(static_cast<int>(i), count[i], given.value.data() + given.row_start[i],
                                     given.column.data() + given.row_start[i]);
  held->matrix->FillComplete();
  held->matrix->OptimizeStorage();
  return held;
}

Preconditioner of(std::shared_ptr<Held> held) {
  const int rows = held->matrix->NumMyRows();
  return case_by_case(rows, [held](const std::vector<double>& r, std::vector<double>& z) {
    Epetra_Vector in(View, *held->map, const_cast<double*>(r.data()));
    Epetra_Vector out(View, *held->map, z.data());
    held->inverse->ApplyInverse(in, out);
  });
}

/// \param    smoother   symmetric Gauss-Seidel, or the incomplete factor of level 1
Preconditioner aggregation(const network::Backbone& backbone, Matrix&& matrix, const char* smoother) {
  std::shared_ptr<Held> held = hold(std::move(matrix));
  held->motions = rigid_motions(backbone);
  Teuchos::ParameterList list;
  ML_Epetra::SetDefaults("SA", list);
  list.set("ML output", 0);
  list.set("PDE equations", 6);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", 6);
  list.set("null space: vectors", held->motions.data());
  list.set("null space: add default vectors", false);
  list.set("smoother: type", smoother);
  list.set("smoother: ifpack type", "ILU");
  list.set("smoother: ifpack level-of-fill", 1.0);
  list.set("smoother: sweeps", 1);
  list.set("coarse: type", "Amesos-KLU");
  list.set("coarse: max size", 600);
  held->inverse = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(*held->matrix, list, true);
  return of(held);
}

Method with(const std::string& name, const char* smoother) {
  return {.name = name,
          .make = [smoother](const network::Backbone& backbone,
                             Matrix&& matrix) { return aggregation(backbone, std::move(matrix), smoother); },
          .start = start};
}

Method incomplete(const std::string& name, const std::string& type, int level) {
  return {.name = name,
          .make =
              [type, level](const network::Backbone&, Matrix&& matrix) {
                std::shared_ptr<Held> held = hold(std::move(matrix));
                std::unique_ptr<Ifpack_Preconditioner> factor(
                    Ifpack().Create(type + " stand-alone", held->matrix.get()));
                Teuchos::ParameterList list;
                list.set("fact: level-of-fill", level);
                if (!factor || factor->SetParameters(list) != 0 || factor->Initialize() != 0 ||
                    factor->Compute() != 0)
                  throw std::runtime_error("Ifpack: no factor " + type);
                held->inverse = std::move(factor);
                return of(held);
              },
          .start = start};
}

} // namespace

std::vector<Method> trilinos_methods() {
  return {with("ml", "symmetric Gauss-Seidel"), with("ml-ilu-1", "IFPACK"), incomplete("ifpack-ic", "IC", 0),
          incomplete("ifpack-ilu-1", "ILU", 1), incomplete("ifpack-ilu-3", "ILU", 3)};
}

} // namespace granum::bench
