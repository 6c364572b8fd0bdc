// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: rates of strain e, compression positive; M the uniform-strain modulus of the network, the scale
// of a servo's gain: e = gap/(M t) + integral, t = servo_steps time steps.
#include <granum/triaxial/shear_test.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <granum/core/error.hpp>

namespace granum::triaxial {

namespace {

/// A servo alone closes a gap in about this many steps; its integral needs integral_factor times as long.
/// Critical damping needs 4; the specimen near its peak is many times softer than M, which reduces the
/// damping.
constexpr double servo_steps = 13;
constexpr double integral_factor = 10;
/// Strain rate that a servo may reach, in driven rates: a dilating specimen near its peak needs 1 at most.
constexpr double largest_servo_rate = 3;
/// Largest drag [1/time step]: at slow rates ShearOptions::drag_share would allow more.
constexpr double largest_drag = 0.1;
/// Steps between two checks that the motion is finite.
constexpr std::size_t watch_interval = 500;

bool drives_axial(stress::ShearPath path) {
  return path == stress::ShearPath::txc || path == stress::ShearPath::rtxe;
}

/// Time of the inertial number [s]: rate = inertial number / time.
double inertial_time(const dem::Engine& engine, double pressure) {
  return engine.diameter() * std::sqrt(engine.material().density / pressure);
}

/// Drag coefficient of a test [1/s]. Grains that do not follow the mean strain, at worst whole blocks that
/// slide along one another, move relative to the cell with up to rate x at a distance x from its centre. A
/// drag c on a mass density rho then carries a stress rho c rate L^2/12 over a length L. The engine's
/// adaptive drag is so much larger that friction angles at an inertial number of 2e-4 are 1 to 2 degrees too
/// large with it.
double drag_coefficient(const dem::Engine& engine, const ShearOptions& options) {
  const Mat3& cell = engine.cell();
  const double length = std::max({cell(0, 0), cell(1, 1), cell(2, 2)});
  const double rate = options.inertial_number / inertial_time(engine, options.mean_stress);
  const double allowed =
      12 * options.drag_share * options.mean_stress / (engine.material().density * rate * length * length);
  return std::min(allowed, largest_drag / engine.time_step());
}

/// +1 where the driven strain compresses.
double driven_sense(stress::ShearPath path) {
  return path == stress::ShearPath::txc || path == stress::ShearPath::txe ? 1 : -1;
}

} // namespace

void require_valid(const ShearOptions& options) {
  require_positive("mean_stress", options.mean_stress, "Pa");
  require_open("inertial_number", options.inertial_number, 0, 0.1);
  require_positive("eta_step", options.eta_step);
  require_positive("strain_step", options.strain_step);
  require_open("largest_strain", options.largest_strain, 0, 1);
  require_open("drag_share", options.drag_share, 0, 1);
  require_closed("time_step_fraction", require_positive("time_step_fraction", options.time_step_fraction), 0,
                 1);
  (void)name(options.path);
}

ShearTest::ShearTest(dem::Engine engine, const ShearOptions& options)
    : options_(options), engine_(std::move(engine)), start_cell_(engine_.cell()) {
  engine_.set_time_step_fraction(options_.time_step_fraction);
  measure();
  peak_ = now_;
}

ShearTest::ShearTest(dem::Specimen state, const dem::Material& material, const ShearOptions& options)
    : ShearTest(dem::Engine((require_valid(options), std::move(state)), material), options) {
  engine_.set_damping(drag_coefficient(engine_, options_));
}

/// Quantities of the present state; step() adds the work.
void ShearTest::measure() {
  const Vec3& stress = engine_.figures().boundary_stress;
  const Mat3& cell = engine_.cell();
  now_.stress = {.v = stress.z, .h = (stress.x + stress.y) / 2};
  now_.stress_difference = std::abs(stress.x - stress.y);
  now_.axial_strain = -std::log(cell(2, 2) / start_cell_(2, 2));
  now_.volumetric_strain = -std::log(determinant(cell) / determinant(start_cell_));
  now_.step = engine_.steps();
}

double ShearTest::servo_rate(Servo& servo, double gap, double modulus, double limit) const {
  const double per_step = 1 / (servo_steps * integral_factor);
  const double proportional = gap / (modulus * servo_steps * engine_.time_step());
  const double wanted = proportional + servo.integral;
  // The integral is constant while the rate is at its limit, to prevent overshoot.
  if (std::abs(wanted) < limit || wanted * gap < 0)
    servo.integral = std::clamp(servo.integral + per_step * proportional, -limit, limit);
  return std::clamp(wanted, -limit, limit);
}

Vec3 ShearTest::strain_rates() {
  const dem::StepFigures& figures = engine_.figures();
  const double pressure = std::max(now_.stress.mean(), 1e-3 * options_.mean_stress);
  const double to_inertial = inertial_time(engine_, pressure);
  const double driven = driven_sense(options_.path) * options_.inertial_number / to_inertial;
  const double limit = largest_servo_rate * std::abs(driven);
  const double modulus = std::max(figures.p_wave_modulus, pressure);
  const Vec3& stress = figures.boundary_stress;
  Vec3 rates;
  if (drives_axial(options_.path)) {
    rates.z = driven;
    rates.x = servo_rate(held_, options_.mean_stress - stress.x, modulus, limit);
    rates.y = servo_rate(held_y_, options_.mean_stress - stress.y, modulus, limit);
  } else {
    const double trim = servo_rate(trim_, (stress.y - stress.x) / 2, modulus, limit);
    rates.x = driven / 2 + trim;
    rates.y = driven / 2 - trim;
    rates.z = servo_rate(held_, options_.mean_stress - stress.z, modulus, limit);
  }
  largest_inertial_number_ =
      std::max(largest_inertial_number_, std::sqrt(dot(rates, rates) / 3) * to_inertial);
  return rates;
}

void ShearTest::step() {
  const Vec3 rates = strain_rates();
  const double dt = engine_.time_step();
  const auto power = [&] {
    const Vec3& stress = engine_.figures().boundary_stress;
    return determinant(engine_.cell()) * (stress.x * rates.x + stress.y * rates.y + stress.z * rates.z);
  };
  const double before = power();
  engine_.set_velocity_gradient(Mat3::diagonal(-rates.x, -rates.y, -rates.z));
  engine_.step();
  now_.work += dt * (before + power()) / 2 / determinant(start_cell_);
  measure();
  if (std::abs(now_.stress.ratio()) > std::abs(peak_.stress.ratio()))
    peak_ = now_;
  const Vec3& stress = engine_.figures().boundary_stress;
  const double gap = drives_axial(options_.path) ? std::max(std::abs(stress.x - options_.mean_stress),
                                                            std::abs(stress.y - options_.mean_stress))
                                                 : std::abs(stress.z - options_.mean_stress);
  path_error_ = std::max(path_error_, gap / options_.mean_stress);
}

namespace {

/// Whether the value has come to the next multiple of the step, which is then moved on to the first one above
/// it, in a few steps also where a forged checkpoint or a test that is no longer finite is beyond them all.
bool passes_multiple(double value, double step, std::size_t& next) {
  if (!(value >= static_cast<double>(next) * step))
    return false;
  constexpr double beyond_all = 0x1p53; // above it doubles skip whole numbers
  const double reached = std::floor(value / step);
  if (!(reached < beyond_all)) {
    next = std::max(next, static_cast<std::size_t>(beyond_all));
    return true;
  }
  if (reached > 1) // one less: the quotient may have been rounded up
    next = std::max(next, static_cast<std::size_t>(reached) - 1);
  while (value >= static_cast<double>(next) * step)
    ++next;
  return true;
}

} // namespace

/// Whether eta or the strain has passed its next multiple, which is then moved on.
bool ShearTest::passes_snapshot() {
  const double eta = now_.stress.ratio() * (stress::is_compression(options_.path) ? 1 : -1);
  const bool by_eta = passes_multiple(eta, options_.eta_step, next_eta_);
  const bool by_strain = passes_multiple(std::abs(now_.axial_strain), options_.strain_step, next_strain_);
  return by_eta || by_strain;
}

ShearEvent ShearTest::advance() {
  while (std::abs(now_.axial_strain) < options_.largest_strain) {
    // Before the step: a test that is saved here and resumed misses no snapshot.
    if (is_stopped(options_.stop_requested))
      return ShearEvent::stopped;
    step();
    if (engine_.steps() % watch_interval == 0 && !engine_.finite())
      return ShearEvent::unstable;
    if (passes_snapshot())
      return ShearEvent::snapshot;
  }
  return engine_.finite() ? ShearEvent::finished : ShearEvent::unstable;
}

namespace {

/// Members of a test beside its engine, listed once for writing and reading.
template <class Visit, class... Members>
void each(const Visit& visit, Members&... members) {
  (visit(members), ...);
}

} // namespace

void ShearTest::save(ByteWriter& to) const {
  engine_.save(to);
  const ShearOptions& o = options_;
  each([&](const auto& value) { to.put(value); }, o.path, o.mean_stress, o.inertial_number, o.eta_step,
       o.strain_step, o.largest_strain, o.time_step_fraction, start_cell_, held_, held_y_, trim_, now_, peak_,
       path_error_, largest_inertial_number_, next_eta_, next_strain_);
}

ShearTest ShearTest::load(ByteReader& from, const dem::Material& material, StopRequest stop_requested) {
  dem::Engine engine = dem::Engine::load(from, material);
  ShearOptions o;
  o.stop_requested = std::move(stop_requested);
  const auto read = [&](auto& value) { value = from.get<std::remove_reference_t<decltype(value)>>(); };
  each(read, o.path, o.mean_stress, o.inertial_number, o.eta_step, o.strain_step, o.largest_strain,
       o.time_step_fraction);
  try {
    require_valid(o);
  } catch (const InvalidArgument& error) {
    from.fail(error.what());
  }
  ShearTest test(std::move(engine), o);
  each(read, test.start_cell_, test.held_, test.held_y_, test.trim_, test.now_, test.peak_, test.path_error_,
       test.largest_inertial_number_, test.next_eta_, test.next_strain_);
  return test;
}

} // namespace granum::triaxial
