// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include <Eigen/SparseCore>

namespace granum::io {

/// A symmetric matrix as a file of MatrixMarket (.mtx): "coordinate real symmetric", the lower triangle by
/// columns, with all digits. scipy.io.mmread, MATLAB's mmread and Julia's MatrixMarket read it.
/// \param    comments   lines below the first, at most 1000 characters each
/// Checked by tests/io/test_matrix_market.cpp
[[nodiscard]] std::string matrix_market(const Eigen::SparseMatrix<double>& symmetric,
                                        std::span<const std::string> comments = {});

} // namespace granum::io
