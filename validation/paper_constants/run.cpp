// SPDX-License-Identifier: GPL-3.0-or-later
// Equations 3 to 8 of [Chung2014] as printed, against the contact law of two grains.
#include <granum/contact/power_law.hpp>

#include "../common.hpp"

namespace {

using granum::contact::PowerLaw;
using std::numbers::pi;

constexpr granum::contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
constexpr double G = grain.shear_modulus;
constexpr double nu = grain.poisson_ratio;
constexpr double radius = 0.5e-3; // [m]
constexpr double force = 1;       // [N]

// Log-gamma only where the gamma function itself would overflow (alpha = 1000).
double eq3_constant(double alpha, double A) {
  const double gammas = alpha < 300 ? std::tgamma((alpha + 1) / 2) / std::tgamma((alpha + 2) / 2)
                                    : std::exp(std::lgamma((alpha + 1) / 2) - std::lgamma((alpha + 2) / 2));
  return 4 * G * alpha / ((1 - nu) * (alpha + 1)) * std::pow(gammas / (std::sqrt(pi) * A), 1 / alpha);
}
double eq3(double alpha, double A, double displacement) {
  return eq3_constant(alpha, A) * std::pow(displacement, 1 + 1 / alpha);
}
double eq4(double alpha, double A, double f) {
  return (1 + 1 / alpha) * std::pow(eq3_constant(alpha, A), alpha / (1 + alpha)) *
         std::pow(f, 1 / (1 + alpha));
}
double eq5(double f) { return std::sqrt(10 * G / (pi * (1 - nu))) * std::sqrt(f); }
double eq6(double f) {
  return std::pow(2 * G * std::sqrt(2 * radius) / (3 * (1 - nu)), 2.0 / 3) * std::cbrt(f);
}
double eq7() { return 4 * G / (1 - nu); }
double eq8() { return 2 * (1 - nu) / (2 - nu); }

std::map<std::string, double> measured() {
  std::map<std::string, double> values;
  struct Shape {
    const char* name;
    double alpha, A;
    PowerLaw law;
  };
  const double A_2 = 1 / (2 * radius);
  const Shape shapes[] = {{"cone", 1, 0.4, PowerLaw::cone(grain, 0.4)},
                          {"alpha_1.5", 1.5, 180, PowerLaw::general(grain, 1.5, 180)},
                          {"sphere", 2, A_2, PowerLaw::sphere(grain, radius)},
                          {"alpha_8", 8, 1e24, PowerLaw::general(grain, 8, 1e24)}};
  const double overlap = 1e-7;
  for (const auto& [name, alpha, A, law] : shapes) {
    values[std::string("eq3_force_over_law_") + name] = eq3(alpha, A, overlap / 2) / law.force(overlap);
    values[std::string("eq4_over_law_") + name] = eq4(alpha, A, force) / law.stiffness_at_force(force);
  }
  const double sphere = PowerLaw::sphere(grain, radius).stiffness_at_force(force);
  values["eq4_sphere_N_per_m"] = eq4(2, A_2, force);
  values["law_sphere_N_per_m"] = sphere;
  values["eq5_N_per_m"] = eq5(force);
  values["eq5_over_law_slope_0.4"] = eq5(force) / PowerLaw::cone(grain, 0.4).stiffness_at_force(force);
  values["eq5_over_law_slope_0.1"] = eq5(force) / PowerLaw::cone(grain, 0.1).stiffness_at_force(force);
  values["eq5_over_eq4_slope_1.6"] = eq5(force) / eq4(1, 1.6, force);
  values["eq6_N_per_m"] = eq6(force);
  values["eq6_over_law_sphere"] = eq6(force) / sphere;
  values["eq6_over_eq4_sphere"] = eq6(force) / eq4(2, A_2, force);
  const double punch = 5.7e-6;
  values["eq7_times_punch_radius_over_law_flat"] =
      eq7() * punch / PowerLaw::flat(grain, punch).stiffness_at_force(force);
  for (const int alpha : {10, 100, 1000})
    values["eq3_constant_over_eq7_alpha_" + std::to_string(alpha) + "_unit_profile"] =
        eq3_constant(alpha, 1) / eq7();
  values["eq8_over_law"] = eq8() / granum::contact::mindlin_stiffness_ratio(nu);
  return values;
}

bool compare(const std::vector<Entry>& reference) {
  std::map<std::string, double> values = measured();
  bool passed = true;
  std::printf("%-46s %22s %22s %10s\n", "quantity", "expected", "found", "off by");
  for (const Entry& row : reference) {
    const std::string& name = row.text("quantity");
    const double found = values.at(name), off = std::abs(found / row("expected") - 1);
    const bool good = off <= row("relative_tolerance");
    std::printf("%-46s %22.16g %22.16g %10.1e%s\n", name.c_str(), row("expected"), found, off,
                good ? "" : "  WRONG");
    passed = passed && good;
    values.erase(name);
  }
  for (const auto& [name, value] : values)
    std::printf("%-46s has no reference\n", name.c_str());
  return passed && values.empty();
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv, {{"", "reference.csv", [](const Arguments& files) {
                                 return compare(read_record(files[0]));
                               }}});
}
