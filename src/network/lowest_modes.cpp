// SPDX-License-Identifier: GPL-3.0-or-later
// Block Lanczos iterations [GolubUnderwood1977] on (K + s)^-1 K (K + s)^-1 with a direct factor of K + s, K
// the stiffness over the masses: of all eigenvalues x of K those next above s have the largest x/(x + s)^2,
// and motions without stiffness 0, however many there are. A block as wide as the number of wanted modes
// finds modes of one frequency as often as they occur.
#include <granum/network/lowest_modes.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>

#include <granum/core/error.hpp>
#include <granum/network/stiffness_matrix.hpp>

namespace granum::network {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// s over the mean stiffness per largest mass, for N^(2/3) = 1: a thousandth of the eigenvalue of the longest
// shear wave of a loose packing of N grains, and far above rounding.
constexpr double without_stiffness = 1e-4;
// Residual of a mode over its eigenvalue; the error of the eigenvalue is of the second order in it.
constexpr double least_residual = 1e-8;
constexpr Index spare_modes = 4, most_blocks = 60;

/// The masses of the unknowns [kg].
VectorXd masses_of(const StiffnessMatrix& h, const packing::Assembly& assembly, double grain_density) {
  VectorXd masses(h.matrix.rows());
  for (Index row = 0; row < masses.size(); ++row) {
    const Index in_block = row % h.unknowns_per_grain;
    const double radius = assembly.radius[h.grain[static_cast<std::size_t>(row / h.unknowns_per_grain)]];
    const double mass = grain_density * 4 / 3 * std::numbers::pi * radius * radius * radius;
    masses[row] = in_block < 3 ? mass : 2 * mass / 5;
  }
  return masses;
}

/// The operator of the iterations.
class Softness {
 public:
  Softness(const Sparse& stiffness, double shift) : stiffness_(stiffness) {
    factor_.setShift(shift);
    factor_.compute(stiffness);
    if (factor_.info() != Eigen::Success)
      throw NotConverged("network is unstable: its stiffness matrix is not positive definite");
  }
  [[nodiscard]] Index size() const { return stiffness_.rows(); }
  [[nodiscard]] MatrixXd operator()(const MatrixXd& x) const {
    return factor_.solve(stiffness_ * factor_.solve(x));
  }

 private:
  const Sparse& stiffness_;
  Eigen::SimplicialLLT<Sparse> factor_;
};

MatrixXd orthonormal(const MatrixXd& m) {
  return Eigen::HouseholderQR<MatrixXd>(m).householderQ() * MatrixXd::Identity(m.rows(), m.cols());
}

/// Columns that are orthogonal to those before, from columns that need not be.
MatrixXd next_block(MatrixXd block, const MatrixXd& basis) {
  for (int pass = 0; pass < 2; ++pass)
    block = orthonormal(block - basis * (basis.transpose() * block));
  return block;
}

/// Numbers with mean zero, the same for each number of rows.
MatrixXd any_block(Index rows, Index columns) {
  std::mt19937_64 bits(1);
  return MatrixXd::NullaryExpr(rows, columns,
                               [&] { return static_cast<double>(bits() >> 11) * 0x1p-52 - 1; });
}

/// The eigenvectors of the largest eigenvalues, as columns.
MatrixXd softest(const Softness& softness, Index count, const StopRequest& stop_requested) {
  const Index n = softness.size();
  MatrixXd block = orthonormal(any_block(n, std::min(n, count + spare_modes))), basis(n, 0), projected;
  for (Index blocks = 0; blocks < most_blocks; ++blocks) {
    throw_if_stopped(stop_requested);
    const Index before = basis.cols(), after = before + block.cols();
    basis.conservativeResize(n, after);
    basis.rightCols(block.cols()) = block;
    const MatrixXd image = softness(block), within = basis.transpose() * image;
    projected.conservativeResize(after, after);
    projected.rightCols(block.cols()) = within;
    projected.bottomLeftCorner(block.cols(), before) = within.topRows(before).transpose();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> ritz((projected + projected.transpose()) / 2);
    const Index wanted = std::min(count, after);
    const MatrixXd vectors = ritz.eigenvectors().rightCols(wanted).rowwise().reverse();
    const VectorXd values = ritz.eigenvalues().tail(wanted).reverse();
    const MatrixXd outside = image - basis * within;
    const VectorXd residual = (outside * vectors.bottomRows(block.cols())).colwise().norm().transpose();
    if (after == n || (wanted == count && (residual.array() <= least_residual * values.array().abs()).all()))
      return basis * vectors;
    block = next_block(outside.leftCols(std::min(block.cols(), n - after)), basis);
  }
  throw NotConverged("the lowest modes of the network did not converge");
}

Mode mode_of(const VectorXd& weighted, double eigenvalue, const VectorXd& masses, const StiffnessMatrix& h,
             std::size_t grains) {
  Mode mode{.frequency = std::sqrt(eigenvalue) / (2 * std::numbers::pi),
            .motion = std::vector<GrainMotion>(grains)};
  double sum = 0, squares = 0;
  for (std::size_t k = 0; k < h.grain.size(); ++k) {
    GrainMotion& motion = mode.motion[h.grain[k]];
    const Index first = static_cast<Index>(k) * h.unknowns_per_grain;
    for (Index d = 0; d < h.unknowns_per_grain; ++d)
      (d < 3 ? motion.displacement : motion.turn)[static_cast<int>(d % 3)] =
          weighted[first + d] / std::sqrt(masses[first + d]);
    const double energy = weighted.segment(first, h.unknowns_per_grain).squaredNorm();
    sum += energy;
    squares += energy * energy;
  }
  mode.participation_ratio = sum * sum / (static_cast<double>(h.grain.size()) * squares);
  return mode;
}

} // namespace

std::vector<Mode> lowest_modes(const packing::Assembly& assembly, double grain_density, std::size_t count,
                               const ResponseOptions& options) {
  require_positive("grain_density", grain_density, "kg/m3");
  require_positive("count", static_cast<double>(count));
  if (!assembly.body.empty())
    throw InvalidArgument("modes: not implemented for grains that are parts of rigid bodies");
  StiffnessMatrix h = stiffness_matrix(assembly, options);
  if (h.matrix.nonZeros() == 0)
    return {};
  const VectorXd masses = masses_of(h, assembly, grain_density);
  const VectorXd per_root_mass = masses.cwiseSqrt().cwiseInverse();
  const double shift = without_stiffness * h.matrix.diagonal().mean() / masses.maxCoeff() /
                       std::pow(static_cast<double>(h.grain.size()), 2.0 / 3);
  h.matrix = per_root_mass.asDiagonal() * h.matrix * per_root_mass.asDiagonal();
  const Softness softness(h.matrix, shift);
  std::vector<Mode> modes;
  for (Index wanted = 0; modes.size() < count && wanted < h.matrix.rows();) { // some may be left out
    wanted = std::min<Index>(wanted + static_cast<Index>(count - modes.size()), h.matrix.rows());
    modes.clear();
    const MatrixXd vectors = softest(softness, wanted, options.stop_requested);
    for (Index k = 0; k < vectors.cols(); ++k)
      if (const double eigenvalue = vectors.col(k).dot(h.matrix * vectors.col(k)); eigenvalue > shift)
        modes.push_back(mode_of(vectors.col(k), eigenvalue, masses, h, assembly.grain_count()));
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  return modes;
}

} // namespace granum::network
