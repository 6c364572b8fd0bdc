// SPDX-License-Identifier: GPL-3.0-or-later
// How far fitted factors are from the measured ones.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "factor_fits.hpp"

namespace relaxation {

/// Errors of one quantity.
class Errors {
 public:
  void add(const Errors& more) {
    sum_ += more.sum_;
    squares_ += more.squares_;
    worst_ = std::max(worst_, more.worst_);
    count_ += more.count_;
  }
  void add(double error) {
    sum_ += error;
    squares_ += error * error;
    worst_ = std::max(worst_, std::abs(error));
    ++count_;
  }
  [[nodiscard]] double rms() const { return count_ > 0 ? std::sqrt(squares_ / count_) : 0; }
  [[nodiscard]] double mean() const { return count_ > 0 ? sum_ / count_ : 0; }
  [[nodiscard]] double worst() const { return worst_; }
  [[nodiscard]] int count() const { return count_; }

 private:
  double sum_ = 0, squares_ = 0;
  double worst_ = 0;
  int count_ = 0;
};

struct FactorErrors {
  Errors shear, bulk;
};

inline FactorErrors errors_of(const std::vector<Packing>& packings, const ShearFit& shear,
                              const BulkFit& bulk, double low, double high, const Choice& chosen) {
  FactorErrors errors;
  for (const Packing& p : packings)
    for (const Network& n : p.networks) {
      if (!p.isotropic() || !chosen(p) || n.ratio < low || n.ratio > high)
        continue;
      if (has_shear_factor(p, n))
        errors.shear.add(shear_model(p, n, shear.coefficients) / shear_factor(p, n) - 1);
      if (has_bulk_factor(p, n))
        errors.bulk.add(bulk_model(p, n, bulk.coefficients) / bulk_factor(p, n) - 1);
    }
  return errors;
}

inline void print_errors(const std::string& what, const FactorErrors& e) {
  std::printf("%-40s %5d | G rms %5.2f %% worst %5.2f %% | K rms %5.2f %% worst %5.2f %%\n", what.c_str(),
              e.shear.count(), 100 * e.shear.rms(), 100 * e.shear.worst(), 100 * e.bulk.rms(),
              100 * e.bulk.worst());
}

} // namespace relaxation
