// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/thomsen.hpp>

#include <cmath>

#include <granum/core/error.hpp>

namespace granum::elastic {

namespace {

/// a + b + c with the rounding of both additions put back: exact but for the last place, even where the sum
/// is a small remainder of its terms.
double compensated_sum(double a, double b, double c) {
  const auto rounding = [](double x, double y, double sum) {
    const double x_in_sum = sum - y;
    return (x - x_in_sum) + (y - (sum - x_in_sum));
  };
  const double ab = a + b;
  const double abc = ab + c;
  return abc + (rounding(a, b, ab) + rounding(ab, c, abc));
}

void require_positive_definite(const TransverselyIsotropic& c) {
  if (!c.positive_definite())
    throw InvalidArgument("Thomsen parameters need a finite and positive definite stiffness");
}

/// C13 less its isotropic value C33 - 2 C44.
double excess(const TransverselyIsotropic& c) { return compensated_sum(c.C13, 2 * c.C44, -c.C33); }

ThomsenParameters with_delta(const TransverselyIsotropic& c, double delta) {
  return {.epsilon = (c.C11 - c.C33) / (2 * c.C33),
          .delta = delta,
          .gamma = compensated_sum(c.C11, -c.C12, -2 * c.C44) / (4 * c.C44)};
}

} // namespace

ThomsenParameters thomsen_parameters(const TransverselyIsotropic& c) {
  require_positive_definite(c);
  if (!(c.C33 > c.C44))
    throw InvalidArgument("C33", c.C33, "Pa", "(C44, inf): Thomsen's delta needs V_p0 > V_s0");
  // (C13+C44)^2 - (C33-C44)^2 = (C13 + 2 C44 - C33)(C13 + C33)
  return with_delta(c, excess(c) / (2 * c.C33) * ((c.C13 + c.C33) / (c.C33 - c.C44)));
}

ThomsenParameters weak_thomsen_parameters(const TransverselyIsotropic& c) {
  require_positive_definite(c);
  return with_delta(c, excess(c) / c.C33);
}

ThomsenSolid thomsen_solid(const TransverselyIsotropic& c, double bulk_density) {
  require_positive("bulk_density", bulk_density, "kg/m3");
  const ThomsenParameters parameters = thomsen_parameters(c);
  return {.bulk_density = bulk_density,
          .vertical_p_speed = std::sqrt(c.C33 / bulk_density),
          .vertical_s_speed = std::sqrt(c.C44 / bulk_density),
          .anisotropy = parameters};
}

TransverselyIsotropic transversely_isotropic(const ThomsenSolid& solid) {
  const double density = require_positive("bulk_density", solid.bulk_density, "kg/m3");
  const double V_s = require_positive("vertical_s_speed", solid.vertical_s_speed, "m/s");
  const double V_p = require_positive("vertical_p_speed", solid.vertical_p_speed, "m/s");
  if (!(V_p > V_s))
    throw InvalidArgument("vertical_p_speed", V_p, "m/s", "(vertical_s_speed, inf)");
  const double epsilon = require_finite("epsilon", solid.anisotropy.epsilon);
  const double delta = require_finite("delta", solid.anisotropy.delta);
  const double gamma = require_finite("gamma", solid.anisotropy.gamma);

  const double C33 = density * V_p * V_p, C44 = density * V_s * V_s;
  const double difference = density * (V_p - V_s) * (V_p + V_s); // C33 - C44
  const double square = difference * (difference + 2 * delta * C33);
  if (!(square >= 0))
    throw InvalidArgument("delta", delta, "", "[-(1 - V_s0^2/V_p0^2)/2, inf)");
  TransverselyIsotropic c{.C11 = C33 * (1 + 2 * epsilon), .C33 = C33, .C12 = 0, .C13 = 0, .C44 = C44};
  c.C12 = c.C11 - 2 * C44 * (1 + 2 * gamma);
  // sqrt(square) - C44, as a quotient without cancellation
  c.C13 = C33 * ((difference - C44) + 2 * delta * difference) / (std::sqrt(square) + C44);
  if (!c.positive_definite())
    throw InvalidArgument("no positive definite stiffness has these Thomsen parameters");
  return c;
}

} // namespace granum::elastic
