// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/stress/shear_path.hpp>

#include <cmath>
#include <numbers>
#include <string>

#include <granum/core/error.hpp>

namespace granum::stress {

namespace {

void require_eta_on(ShearPath path, double eta) {
  const bool inside = is_compression(path) ? eta >= 0 && eta < 3 : eta > -1.5 && eta <= 0;
  if (!inside)
    throw InvalidArgument("eta", eta, "",
                          (is_compression(path) ? "[0, 3) of " : "(-1.5, 0] of ") + std::string(name(path)));
}

} // namespace

std::string_view name(ShearPath path) {
  switch (path) {
  case ShearPath::txc:
    return "TXC";
  case ShearPath::rtxc:
    return "RTXC";
  case ShearPath::rtxe:
    return "RTXE";
  case ShearPath::txe:
    return "TXE";
  }
  throw InvalidArgument("stress path is not one of the known ones");
}

bool is_compression(ShearPath path) { return path == ShearPath::txc || path == ShearPath::rtxc; }

AxialStress stress_on_path(ShearPath path, double start, double eta) {
  require_positive("stress at the start of the path", start, "Pa");
  require_eta_on(path, eta);
  const double v_by_p = 1 + 2 * eta / 3;
  const double h_by_p = 1 - eta / 3;
  const bool horizontal_constant = path == ShearPath::txc || path == ShearPath::rtxe;
  return horizontal_constant ? AxialStress{.v = start * (v_by_p / h_by_p), .h = start}
                             : AxialStress{.v = start, .h = start * (h_by_p / v_by_p)};
}

double failure_ratio(ShearPath path, double friction_angle) {
  require_open("friction_angle", friction_angle, 0, std::numbers::pi / 2, "rad");
  const double sine = std::sin(friction_angle);
  return is_compression(path) ? 6 * sine / (3 - sine) : -6 * sine / (3 + sine);
}

} // namespace granum::stress
