// SPDX-License-Identifier: GPL-3.0-or-later
// How far fitted factors are from the measured ones.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "../errors.hpp"
#include "factor_fits.hpp"

namespace relaxation {

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
