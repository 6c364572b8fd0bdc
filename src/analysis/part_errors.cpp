// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_errors.hpp"

#include <algorithm>
#include <cmath>

#include <granum/effective/relaxation.hpp>

namespace granum::analysis {

void add_errors_of_part(Measurement& measurement, std::size_t grains) {
  if (!measurement.interior || !measurement.state)
    return;
  constexpr double of_contacts = 1.5, of_moduli = 0.8, step = 1e-3;
  const double of_part = 1 / static_cast<double>(measurement.interior->grains),
               of_whole = 1 / static_cast<double>(grains);
  const double error = std::sqrt(std::max(0.0, of_part - of_whole));
  effective::State more = *measurement.state;
  const double z = *more.mechanical_coordination_number;
  more.coordination_number = *more.coordination_number * (z + step) / z;
  for (ClosedForm& form : measurement.closed_forms) {
    if (form.rung->name != effective::RungName::relaxed || !form.answer || !form.answer->relative_error)
      continue;
    const elastic::TransverselyIsotropic next = effective::relaxed(more, z + step).stiffness,
                                         &here = form.answer->stiffness;
    const auto add = [&](double& to, double from, double towards) {
      if (from > 0)
        to = std::hypot(to, of_moduli * error, of_contacts * error / step * std::log(towards / from));
    };
    effective::ModulusErrors& errors = *form.answer->relative_error;
    add(errors.bulk_modulus, here.bulk_modulus(), next.bulk_modulus());
    add(errors.G_hh, here.G_hh(), next.G_hh());
    add(errors.G_vh, here.G_vh(), next.G_vh());
  }
}

} // namespace granum::analysis
