// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

/// Largest errors of granum's functions against the same formulas written anew in 50-digit arithmetic.
namespace accuracy {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

inline Real pi() { return boost::math::constants::pi<Real>(); }

/// Random arguments, the same in every run and on every machine.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) { return low + (high - low) * unit_(engine_); }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  /// One of the given values in a third of the draws, else uniform between low and high.
  double uniform_or(double low, double high, std::initializer_list<double> special) {
    if (unit_(engine_) < 1.0 / 3)
      return special.begin()[static_cast<std::size_t>(unit_(engine_) * static_cast<double>(special.size()))];
    return uniform(low, high);
  }
  double poisson_ratio() { return uniform_or(-0.999999, 0.5, {0.0, 0.25, 0.5, -0.999999}); }
  double anisotropy() { return uniform_or(-1, 1, {-1.0, 0.0, 1.0, 1e-9}); }
  /// k_t/k_n.
  double ratio() { return uniform_or(0, 2, {0.0, 1.0, 2.0, 1e-9}); }
  double coordination_number() { return uniform_or(0.01, 14, {14.0, 4.0, 6.0}); }
  double pressure() { return log_uniform(1e-300, 1e12); }

 private:
  boost::random::mt19937_64 engine_;
  boost::random::uniform_01<double> unit_;
};

/// What a row promises: the largest error in units in the last place.
struct Reach {
  double ulp;
};
constexpr Reach closed_form{8};
constexpr Reach cement{16}; ///< of the regression, as its docstring says
/// Relative 1e-14, what the docstrings of the stiffness with fabric promise.
constexpr Reach stiffness_form{1e-14 / 2.220446049250313e-16};
constexpr Reach quadrature{1e-13 / 2.220446049250313e-16}; ///< relative 1e-13
/// Relative 1e-12, what the docstrings of derivatives and of the kinematic field promise.
constexpr Reach derivative{1e-12 / 2.220446049250313e-16};

/// The table: one row a function and domain, with its largest error so far.
class Table {
 public:
  struct Row {
    std::string function;
    std::string domain;
    double reach = 0;
    double worst = 0;
    std::string where = {}; ///< arguments of the largest error
    std::size_t samples = 0;
  };

  /// Compares one value, whose error is relative to `scale`: itself, or one of larger ones that it is a
  /// difference of. `where` says the arguments.
  void take(const std::string& function, const std::string& domain, Reach reach, double value,
            const Real& reference, const Real& scale, const std::string& where);

  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

/// "name=value" with six digits, of each of the names.
std::string said(const std::string& names, std::initializer_list<double> values);

/// Rows of one domain, at some arguments.
struct At {
  Table& table;
  std::string domain, where;
  Reach reach = closed_form;

  void operator()(const std::string& function, double value, const Real& reference) const {
    table.take(function, domain, reach, value, reference, reference, where);
  }
  void of(const Real& scale, const std::string& function, double value, const Real& reference) const {
    table.take(function, domain, reach, value, reference, scale, where);
  }
};

/// All samples of contacts, and one sample, of that number, of each other group of formulas.
void check_contact(Table& table, Draw& draw, std::size_t samples);
void check_fabric(Table& table, Draw& draw, std::size_t k);
void check_elastic(Table& table, Draw& draw, std::size_t k);
void check_uniform_field(Table& table, Draw& draw, std::size_t k);
void check_directional(Table& table, Draw& draw, std::size_t k);
void check_sphere_packs(Table& table, Draw& draw, std::size_t k);
void check_sphere_models(Table& table, Draw& draw, std::size_t k);
void check_static_field(Table& table, Draw& draw, std::size_t k);
void check_derivatives(Table& table, Draw& draw, std::size_t k);
void check_kinematic(Table& table, Draw& draw, std::size_t k);
void check_relaxation(Table& table, Draw& draw, std::size_t k);
void check_waves(Table& table, Draw& draw, std::size_t k);
void check_tensors(Table& table, Draw& draw, std::size_t k);
void check_distribution(Table& table, Draw& draw, std::size_t k);

} // namespace accuracy
