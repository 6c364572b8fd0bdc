// SPDX-License-Identifier: GPL-3.0-or-later
// A whole matrix beside scipy is in python/tests/test_networks.py.
#include <granum/io/matrix_market.hpp>

#include "unit.hpp"

TEST_CASE("MatrixMarket: the lower triangle by columns, numbered from 1, with all digits") {
  Eigen::SparseMatrix<double> matrix(3, 3);
  matrix.insert(0, 0) = 1.0 / 3;
  matrix.insert(2, 0) = matrix.insert(0, 2) = -1e-300;
  matrix.insert(2, 2) = 4;
  matrix.makeCompressed();
  CHECK(io::matrix_market(matrix, std::vector<std::string>{"one", "two"}) ==
        "%%MatrixMarket matrix coordinate real symmetric\n% one\n% two\n3 3 3\n"
        "1 1 0.3333333333333333\n3 1 -1e-300\n3 3 4\n");
  CHECK(io::matrix_market({}) == "%%MatrixMarket matrix coordinate real symmetric\n0 0 0\n");
}
