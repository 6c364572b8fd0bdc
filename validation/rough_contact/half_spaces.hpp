// SPDX-License-Identifier: GPL-3.0-or-later
// Two elastic spheres with a rough interface between them, from scratch: no table and no formula of the
// library.
//
// Units: E* = 1 (of the pair), u0 = 1, R* = 1/6. Hertz' stiffness of the force f is then f^(1/3), and
// X = u0 k_H/f = f^(-2/3) is the one number of the problem. v is the square of the distance from the axis:
// smooth fields are smooth functions of v, and so are the integrals below.
//
// The interface bears p = exp(-gap), gap = v/(2 R*) + u - D. Half spaces sink by u under p, in two steps that
// have no singular kernel [Sneddon1965]:
//   g(w) = integral of p(w + t^2) dt, t from 0,     u(v) = 4/pi integral of g(v sin^2) over a quarter turn,
// and the force is pi times the integral of p dv. Fields are polynomials of v on panels, integrals are Gauss
// rules that are exact for them (the first) or converge as fast (the second). Newton's method on ln p; the
// stiffness is the derivative of the discrete equations, which is exact.
#pragma once

#include <Eigen/LU>
#include <granum/core/numerics.hpp>

#include "../common.hpp"

namespace rough_contact {

constexpr int order = 16; ///< nodes of a panel

/// Panels of v, finest where the pressure of a smooth contact would end.
inline std::vector<double> panel_ends(double X, double fineness) {
  const double edge = 1 / (4 * X);                                       // a^2 of Hertz
  const double layer = 2.5 / fineness * std::cbrt(std::max(edge, 0.03)); // what smears the edge
  const double farthest = edge + 20 + 25 * std::cbrt(edge) + 12 * std::sqrt(std::max(0.0, edge));
  std::vector<double> ends{0, farthest};
  if (edge < farthest)
    ends.push_back(edge);
  for (double distance = layer; distance < farthest; distance *= 1 + 0.8 / fineness)
    for (const double end : {edge - distance, edge + distance})
      if (end > 0 && end < farthest)
        ends.push_back(end);
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// The pressure of one approach, and how force and stiffness follow.
class HalfSpaces {
 public:
  HalfSpaces(double X, double fineness) {
    const std::vector<double> ends = panel_ends(X, fineness);
    ends_ = Eigen::Map<const Eigen::VectorXd>(ends.data(), static_cast<Eigen::Index>(ends.size()));
    fill_rule();
    v_.resize(panels() * order);
    weight_.resize(panels() * order);
    for (Eigen::Index panel = 0; panel < panels(); ++panel) {
      const double half = (ends_[panel + 1] - ends_[panel]) / 2;
      v_.segment(panel * order, order) = ends_[panel] + half * (1 + node_.array());
      weight_.segment(panel * order, order) = half * gauss_;
    }
    sinking_ = sinking_of_integral() * integral_of_pressure();
    // About Hertz': p_m sqrt(1 - v/a^2), and a fall beyond.
    const double edge = 1 / (4 * X), middle = 1.5 * std::pow(X, -1.5) / (std::numbers::pi * edge);
    log_pressure_ = v_.unaryExpr([&](double v) {
      return std::log(middle) + std::log(std::max(1 - v / edge, 1e-2)) / 2 - std::max(0.0, v - edge);
    });
  }

  struct Loaded {
    double force;
    double stiffness;
  };

  /// At a force, by Newton's method on the approach around Newton's method on the pressure.
  Loaded at_force(double force) {
    double approach = std::log(force) + 1.5 * std::cbrt(force * force); // about
    for (int round = 0; round < 60; ++round) {
      const Loaded now = at_approach(approach);
      if (std::abs(now.force / force - 1) < 1e-13)
        return now;
      approach += std::log(force / now.force) * now.force / now.stiffness;
    }
    throw std::runtime_error("no approach bears this force");
  }

  Loaded at_approach(double approach) {
    for (int round = 0; round < 100; ++round) {
      const Eigen::VectorXd pressure = log_pressure_.array().exp().matrix();
      Eigen::MatrixXd slopes = sinking_ * pressure.asDiagonal();
      slopes.diagonal().array() += 1;
      const Eigen::PartialPivLU<Eigen::MatrixXd> solver(slopes);
      const Eigen::VectorXd missing =
          (approach - 3 * v_.array() - log_pressure_.array()).matrix() - sinking_ * pressure;
      const Eigen::VectorXd step = solver.solve(missing);
      const double largest = step.cwiseAbs().maxCoeff();
      log_pressure_ += step.cwiseMin(3); // pressures that fall do no harm
      if (largest < 1e-8) {              // Newton's next error is its square
        const Eigen::VectorXd p = log_pressure_.array().exp().matrix();
        const Eigen::VectorXd share = solver.solve(Eigen::VectorXd::Ones(v_.size()));
        const double force = std::numbers::pi * weight_.dot(p);
        return {force, std::numbers::pi * (weight_.array() * p.array() * share.array()).sum()};
      }
    }
    throw std::runtime_error("the pressure of this approach was not found");
  }

 private:
  [[nodiscard]] Eigen::Index panels() const { return ends_.size() - 1; }

  /// Gauss' rule, and the weights of the polynomial through values at its nodes.
  void fill_rule() {
    node_.resize(order);
    gauss_.resize(order);
    barycentric_.resize(order);
    Eigen::Index k = 0;
    for (const auto& [x, weight] : granum::gauss_legendre(order)) {
      node_[k] = x;
      gauss_[k++] = weight;
    }
    for (k = 0; k < order; ++k) {
      double product = 1;
      for (Eigen::Index other = 0; other < order; ++other)
        if (other != k)
          product *= node_[k] - node_[other];
      barycentric_[k] = 1 / product;
    }
  }

  /// Adds weight times the value at v of each of the panel's polynomials.
  template <class Row>
  void add_values(Row row, Eigen::Index panel, double v, double weight) const {
    const double x = 2 * (v - ends_[panel]) / (ends_[panel + 1] - ends_[panel]) - 1;
    const Eigen::ArrayXd distance = x - node_.array();
    for (Eigen::Index k = 0; k < order; ++k)
      if (distance[k] == 0) {
        row[panel * order + k] += weight;
        return;
      }
    const Eigen::ArrayXd part = barycentric_.array() / distance;
    row.segment(panel * order, order) += (weight / part.sum() * part).matrix().transpose();
  }

  [[nodiscard]] Eigen::MatrixXd integral_of_pressure() const {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(v_.size(), v_.size());
    for (Eigen::Index i = 0; i < v_.size(); ++i)
      for (Eigen::Index panel = 0; panel < panels(); ++panel) {
        if (ends_[panel + 1] <= v_[i])
          continue;
        const double from = std::sqrt(std::max(0.0, ends_[panel] - v_[i])),
                     to = std::sqrt(ends_[panel + 1] - v_[i]);
        for (Eigen::Index k = 0; k < order; ++k) {
          const double t = from + (to - from) / 2 * (1 + node_[k]);
          add_values(matrix.row(i), panel, v_[i] + t * t, (to - from) / 2 * gauss_[k]);
        }
      }
    return matrix;
  }

  [[nodiscard]] Eigen::MatrixXd sinking_of_integral() const {
    const auto fine = granum::gauss_legendre(32);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(v_.size(), v_.size());
    const auto angle = [](double share) { return std::asin(std::sqrt(std::min(1.0, share))); };
    for (Eigen::Index i = 0; i < v_.size(); ++i)
      for (Eigen::Index panel = 0; panel < panels() && ends_[panel] < v_[i]; ++panel) {
        const double from = angle(ends_[panel] / v_[i]), to = angle(ends_[panel + 1] / v_[i]);
        for (const auto& [x, w] : fine) {
          const double sine = std::sin(from + (to - from) / 2 * (1 + x));
          add_values(matrix.row(i), panel, v_[i] * sine * sine, 4 / std::numbers::pi * (to - from) / 2 * w);
        }
      }
    return matrix;
  }

  Eigen::VectorXd ends_, node_, gauss_, barycentric_;
  Eigen::VectorXd v_, weight_, log_pressure_;
  Eigen::MatrixXd sinking_;
};

/// Phi(X) = k_n/k_H.
inline double stiffness_over_hertz(double X, double fineness) {
  HalfSpaces contact(X, fineness);
  const double force = std::pow(X, -1.5);
  return contact.at_force(force).stiffness / std::cbrt(force);
}

} // namespace rough_contact
