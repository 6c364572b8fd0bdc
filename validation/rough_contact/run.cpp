// SPDX-License-Identifier: GPL-3.0-or-later
// Solves the contact of rough spheres from scratch (half_spaces.hpp), fits the numbers of
// contact::RoughSphere's formula to the solutions, and holds record, formula and limits to each other.
//   rough_contact phi.csv          exit code 0 if all of it holds
//   rough_contact phi.csv record   writes phi.csv first
#include <fstream>

#include <Eigen/QR>
#include <granum/contact/rough_sphere.hpp>

#include "../common.hpp"
#include "half_spaces.hpp"

using namespace rough_contact;

namespace {

constexpr int rows = 61; ///< from X = 0.003 to 100, in equal steps of ln X
constexpr double fineness = 1, finer = 2;

struct Row {
  double X, ratio;
};

double X_of_row(int row) { return 0.003 * std::pow(100 / 0.003, row / (rows - 1.0)); }

void record(const std::string& path) {
  std::ofstream file(path);
  file << "X,stiffness over Hertz,the same on twice as fine panels\n";
  for (int row = 0; row < rows; ++row) {
    char line[128];
    const double X = X_of_row(row);
    std::snprintf(line, sizeof line, "%.12g,%.12f,%.12f\n", X, stiffness_over_hertz(X, fineness),
                  stiffness_over_hertz(X, finer));
    file << line;
  }
}

std::vector<Row> read(const std::string& path) {
  std::vector<Row> all;
  for (const Entry& entry : read_record(path))
    all.push_back({entry("X"), entry("stiffness over Hertz")});
  return all;
}

/// The formula with other numbers s0, c, n.
double formula(double X, const Eigen::Vector3d& x) {
  const double q = std::pow(x[1] * X, x[2]);
  const double h = 1 + X * (x[0] + 2 * std::numbers::pi / 3 * q) / (1 + q);
  return 1 / (X + 1 / std::sqrt(h));
}

struct Fit {
  Eigen::Vector3d numbers;
  double worst = 1; ///< largest relative error
};

/// Smallest largest error, by Lawson's least squares: each row weighs as much again as it errs.
Fit fit(const std::vector<Row>& data) {
  const auto count = static_cast<Eigen::Index>(data.size());
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(count), error(count);
  Eigen::MatrixXd slopes(count, 3);
  Eigen::Vector3d x(4.0 / 3, 0.8, 1.1);
  Fit best;
  for (int round = 0; round < 4000; ++round) {
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto [X, ratio] = data[static_cast<std::size_t>(i)];
      error[i] = formula(X, x) / ratio - 1;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d step = 1e-6 * Eigen::Vector3d::Unit(k);
        slopes(i, k) = (formula(X, x + step) - formula(X, x - step)) / 2e-6 / ratio;
      }
    }
    if (const double worst = error.cwiseAbs().maxCoeff(); worst < best.worst)
      best = {x, worst};
    const Eigen::VectorXd root = weight.cwiseSqrt();
    x -= (root.asDiagonal() * slopes).colPivHouseholderQr().solve(root.cwiseProduct(error));
    if (round >= 20) {
      weight = weight.cwiseProduct(error.cwiseAbs());
      weight /= weight.mean();
    }
  }
  return best;
}

int check(const std::vector<Row>& data) {
  Claims claims;
  const auto at_most = [&](const char* what, double value, double reach) {
    claims.require(value <= reach, granum::detail::formatted("%-66s %.2e (%.0e)", what, value, reach));
  };
  claims.require(data.size() == rows, "all rows are recorded");
  double solved = 0, refined = 0, of_library = 0, least = 1, most = 0;
  bool falls = true, b_falls = true;
  double last_b = 1;
  for (std::size_t k = 0; k < data.size(); ++k) {
    const auto [X, ratio] = data[k];
    of_library = std::max(of_library, std::abs(granum::contact::rough_stiffness(X).ratio / ratio - 1));
    falls = falls && (k == 0 || ratio < data[k - 1].ratio);
    if (k > 0) { // b = 1/3 - 2/3 d ln Phi/d ln X falls with the force, as X rises with its inverse
      const double b = (1 - 2 * std::log(ratio / data[k - 1].ratio) / std::log(X / data[k - 1].X)) / 3;
      least = std::min(least, b);
      most = std::max(most, b);
      b_falls = b_falls && (k == 1 || b > last_b);
      last_b = b;
    }
    if (k % 12 == 0) {
      const double again = stiffness_over_hertz(X, fineness);
      solved = std::max(solved, std::abs(again / ratio - 1));
      refined = std::max(refined, std::abs(stiffness_over_hertz(X, finer) / again - 1));
    }
  }
  at_most("solved again, against the record", solved, 1e-9);
  at_most("on twice as fine panels", refined, 1e-9);
  claims.require(falls && b_falls, "Phi falls with X and b rises with it, in the record");
  claims.require(least > 1.0 / 3 && most < 1,
                 granum::detail::formatted("b of the record stays between 1/3 and 1: least above 1/3 by %.2e",
                                           least - 1.0 / 3));
  // Limits: Phi = 1 - X/3 and Phi = 1/(X + sqrt(3/(2 pi X))), each with an error of the next order.
  const double smooth = (1 / stiffness_over_hertz(3e-4, fineness) - 1) / 3e-4;
  at_most("little roughness: (1/Phi - 1)/X at X = 3e-4 from 1/3", std::abs(3 * smooth - 1), 1e-3);
  const double rough = std::pow(1 / stiffness_over_hertz(1000, fineness) - 1000, -2) / 1000;
  at_most("much roughness: h/X at X = 1000 from 2 pi/3", std::abs(rough * 1.5 / std::numbers::pi - 1), 2e-3);
  const Fit fitted = fit(data);
  std::printf("fitted: s0 %.6f  c %.6f  n %.6f, largest error %.2e\n", fitted.numbers[0], fitted.numbers[1],
              fitted.numbers[2], fitted.worst);
  at_most("the library's formula against the record", of_library, 2e-4);
  at_most("its largest error over that of the fit, less 1", std::abs(of_library / fitted.worst - 1), 0.02);
  return claims.exit_code();
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv,
                 {
                     {"", "phi.csv", [](const Arguments& files) { return check(read(files[0])); }},
                     {"", "phi.csv record",
                      [](const Arguments& arguments) {
                        record(arguments[0]);
                        return check(read(arguments[0]));
                      }},
                 });
}
