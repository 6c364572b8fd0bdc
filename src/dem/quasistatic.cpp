// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/quasistatic.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::dem {

namespace {

/// The servo closes the gap between stress and target in about this many steps.
constexpr double servo_steps = 27;
/// Steps between two checks of the criteria to stop.
constexpr std::size_t check_interval = 10;
/// Steps between two checks that the motion is finite.
constexpr std::size_t watch_interval = 500;

double square(double x) { return x * x; }

double squared_norm(const Mat3& m) {
  double sum = 0;
  for (const auto& row : m.m)
    for (const double value : row)
      sum += square(value);
  return sum;
}

struct Rates {
  double largest;     ///< of strain [1/s]
  double to_inertial; ///< inertial number of a unit strain rate [s]
};

Rates rates(const Engine& engine, double pressure, double diameter, const QuasistaticOptions& options) {
  const double to_inertial = diameter * std::sqrt(engine.material().density / pressure);
  return {options.inertial_number / to_inertial, to_inertial};
}

bool interrupted(const Engine& engine, const QuasistaticOptions& options, QuasistaticReport& report) {
  if (report.steps % watch_interval == 0 && !engine.finite()) {
    report.outcome = Outcome::unstable;
    return true;
  }
  if (is_stopped(options.stop_requested)) {
    report.outcome = Outcome::stopped;
    return true;
  }
  return false;
}

void conclude(const Engine& engine, QuasistaticReport& report) {
  report.unbalanced_force_ratio = engine.unbalanced_force_ratio();
  report.last_stress = engine.figures().stress;
  if (!engine.finite())
    report.outcome = Outcome::unstable;
}

/// Whether the stress is constant or changes at a steady rate; checked every settle_steps steps.
class StressWatch {
 public:
  StressWatch(const QuasistaticOptions& options, const Mat3& stress)
      : limit_(options.settled_stress), spell_(options.settle_steps), last_(stress) {}

  bool settled(std::size_t steps_at_rest, const Mat3& stress) {
    if (!(limit_ > 0) || steps_at_rest == 0 || steps_at_rest % spell_ != 0)
      return false;
    const Mat3 change = stress + -1.0 * last_;
    const bool first = steps_at_rest == spell_;
    steady_spells_ = !first && largest_difference(change, change_) <= limit_ ? steady_spells_ + 1 : 0;
    last_ = stress;
    change_ = change;
    return steady_spells_ >= 2;
  }

 private:
  static double largest_difference(const Mat3& a, const Mat3& b) {
    double largest = 0;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        largest = std::max(largest, std::abs(a(row, column) - b(row, column)));
    return largest;
  }

  double limit_;
  std::size_t spell_;
  Mat3 last_, change_;
  int steady_spells_ = 0;
};

void require_valid(const QuasistaticOptions& options) {
  require_positive("inertial_number", options.inertial_number);
  require_positive("force_tolerance", options.force_tolerance);
  require_positive("stress_tolerance", options.stress_tolerance);
  require_non_negative("settled_stress", options.settled_stress, "Pa");
  require_positive("settle_steps", static_cast<double>(options.settle_steps));
}

} // namespace

const Mat3& QuasistaticReport::stress() const {
  if (outcome != Outcome::converged && outcome != Outcome::settled)
    throw NotConverged("a run of the engine did not come to rest: unbalanced force ratio " +
                       short_text(unbalanced_force_ratio) + " after " + std::to_string(steps) + " steps");
  return last_stress;
}

QuasistaticReport equilibrate(Engine& engine, const Vec3& target, const QuasistaticOptions& options) {
  return shear_at_stress(engine, Mat3{}, 0, target, options);
}

QuasistaticReport shear_at_stress(Engine& engine, const Mat3& strain, std::size_t ramp_steps,
                                  const Vec3& target, const QuasistaticOptions& options) {
  require_valid(options);
  engine.set_time_step_fraction(options.time_step_fraction);
  for (int axis = 0; axis < 3; ++axis)
    require_positive("target stress", target[axis], "Pa");
  const double pressure = (target.x + target.y + target.z) / 3;
  const Rates rate = rates(engine, pressure, engine.diameter(), options);
  QuasistaticReport report;
  for (; report.steps < options.max_steps; ++report.steps) {
    if (interrupted(engine, options, report))
      break;
    const StepFigures& now = engine.figures();
    const bool ramp = report.steps < ramp_steps;
    Mat3 gradient;
    if (ramp)
      gradient = 1 / (static_cast<double>(ramp_steps) * engine.time_step()) * strain;
    double worst = 0, norm_squared = squared_norm(gradient);
    for (int axis = 0; axis < 3; ++axis) {
      const double gap = target[axis] - now.boundary_stress[axis];
      worst = std::max(worst, std::abs(gap));
      const double modulus = std::max(now.p_wave_modulus, pressure);
      const double strain_rate =
          std::clamp(gap / (modulus * servo_steps * engine.time_step()), -rate.largest, rate.largest);
      gradient(axis, axis) -= strain_rate;
      norm_squared += square(strain_rate);
    }
    if (!ramp && report.steps % check_interval == 0 && report.steps > 0 &&
        now.contacts + now.wall_contacts > 0 && worst < options.stress_tolerance * pressure &&
        engine.unbalanced_force_ratio() < options.force_tolerance) {
      report.outcome = Outcome::converged;
      break;
    }
    report.largest_inertial_number =
        std::max(report.largest_inertial_number, std::sqrt(norm_squared / 3) * rate.to_inertial);
    engine.set_velocity_gradient(gradient);
    engine.step();
  }
  engine.set_velocity_gradient(Mat3{});
  conclude(engine, report);
  return report;
}

QuasistaticReport deform(Engine& engine, const Mat3& strain, std::size_t ramp_steps,
                         const QuasistaticOptions& options) {
  require_valid(options);
  engine.set_time_step_fraction(options.time_step_fraction);
  const double pressure = std::max(trace(engine.figures().stress) / 3, 1e-300);
  const double to_inertial = rates(engine, pressure, engine.diameter(), options).to_inertial;
  QuasistaticReport report;
  for (; report.steps < ramp_steps; ++report.steps) {
    if (is_stopped(options.stop_requested)) {
      report.outcome = Outcome::stopped;
      break;
    }
    // The time step may change, so the rate follows from the strain of each step.
    const double rate = 1 / (static_cast<double>(ramp_steps) * engine.time_step());
    report.largest_inertial_number =
        std::max(report.largest_inertial_number, std::sqrt(squared_norm(strain)) * rate * to_inertial);
    engine.set_velocity_gradient(rate * strain);
    engine.step();
  }
  engine.set_velocity_gradient(Mat3{});
  const std::size_t ramped = report.steps;
  StressWatch watch(options, engine.figures().stress);
  for (; report.steps < options.max_steps; ++report.steps) {
    if (interrupted(engine, options, report))
      break;
    if (watch.settled(report.steps - ramped, engine.figures().stress)) {
      report.outcome = Outcome::settled;
      break;
    }
    if (report.steps % check_interval == 0 && engine.figures().contacts > 0 &&
        engine.unbalanced_force_ratio() < options.force_tolerance) {
      report.outcome = Outcome::converged;
      break;
    }
    engine.step();
  }
  conclude(engine, report);
  return report;
}

} // namespace granum::dem
