// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <granum/core/bytes.hpp>
#include <granum/core/stop.hpp>
#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/stress/stress.hpp>

/// Triaxial shearing of a specimen from an isotropic state to past its peak.
namespace granum::triaxial {

struct ShearOptions {
  stress::ShearPath path = stress::ShearPath::txc;
  double mean_stress = 100e3;    ///< isotropic stress at the start, > 0 [Pa]
  double inertial_number = 2e-4; ///< driven strain rate times d sqrt(density/p'), p' the present one [1]
  double eta_step = 0.05;        ///< a snapshot at each first passage of a multiple of this eta [1] ...
  double strain_step = 0.0025;   ///< ... and of this axial strain [1]
  double largest_strain = 0.03;  ///< axial strain, either sense, at which the test ends [1]
  double time_step_fraction = dem::default_time_step_fraction; ///< of the stability limit, in (0, 1]
  double drag_share = 1e-3; ///< most that the drag may carry of the mean stress at the start, in (0, 1) [1]
  /// Checked regularly; true ends advance() early, and a later call continues.
  StopRequest stop_requested = {};
};

/// \throws InvalidArgument naming the option that no test can have.
void require_valid(const ShearOptions& options);

/// Present point of a test. Strains are logarithmic, from the start of the path, compression positive.
struct PathPoint {
  stress::AxialStress stress;   ///< at the boundaries, horizontal one the mean of x and y [Pa]
  double stress_difference = 0; ///< between x and y [Pa]
  double axial_strain = 0;
  double volumetric_strain = 0;
  double work = 0; ///< done on the specimen, per volume at the start [J/m^3]
  std::size_t step = 0;

  bool operator==(const PathPoint&) const = default;
};

/// Outcome of advance().
enum class ShearEvent {
  snapshot, ///< eta or the axial strain has passed a multiple of its step
  finished, ///< the largest strain is reached
  stopped,  ///< by stop_requested
  unstable  ///< a velocity or a stress is no longer finite
};

/// One test under way. The stress that the path changes is driven by a constant inertial number: axial strain
/// in TXC and RTXE, equal horizontal strains of half that rate in RTXC and TXE. The other stress is kept
/// constant by servos (proportional and integral, for a strain rate that changes slowly must not need a gap),
/// and so is the equality of the two horizontal stresses. eta follows, past its peak as well. The drag is
/// constant and weak (ShearOptions::drag_share): the adaptive one of the engine raises the friction angle of
/// 1,000 grains between walls by 1 to 2 degrees at an inertial number of 2e-4.
/// Assumes   an orthogonal box along the axes, at rest under options.mean_stress.
/// Same state, same options: same bits.            [Chung2014], checked by tests/triaxial/test_shear_test.cpp
class ShearTest {
 public:
  /// \throws InvalidArgument for options or a state that no test can have
  ShearTest(dem::Specimen state, const dem::Material& material, const ShearOptions& options);

  /// Goes on to the next event. After `finished` it returns that at once.
  [[nodiscard]] ShearEvent advance();

  [[nodiscard]] const PathPoint& now() const { return now_; }
  /// The point of the largest |eta| so far.
  [[nodiscard]] const PathPoint& peak() const { return peak_; }
  /// Largest relative error of the constant stress of the path so far [1].
  [[nodiscard]] double path_error() const { return path_error_; }
  [[nodiscard]] double largest_inertial_number() const { return largest_inertial_number_; }
  [[nodiscard]] const dem::Engine& engine() const { return engine_; }

  /// All that the rest of the test depends on, to the bit.
  void save(ByteWriter& to) const;
  /// The saved test, which continues with the same bits. stop_requested is not part of the bytes.
  /// \throws   FileError if the bytes end too early or were written for another material
  [[nodiscard]] static ShearTest load(ByteReader& from, const dem::Material& material,
                                      StopRequest stop_requested = {});

 private:
  ShearTest(dem::Engine engine, const ShearOptions& options);
  struct Servo {
    double integral = 0; ///< strain rate that it has learnt [1/s]
  };

  void step();
  void measure();
  [[nodiscard]] double servo_rate(Servo& servo, double gap, double modulus, double limit) const;
  [[nodiscard]] Vec3 strain_rates();
  [[nodiscard]] bool passes_snapshot();

  ShearOptions options_;
  dem::Engine engine_;
  Mat3 start_cell_;
  Servo held_, held_y_, trim_;
  PathPoint now_, peak_;
  double path_error_ = 0;
  double largest_inertial_number_ = 0;
  std::size_t next_eta_ = 1;
  std::size_t next_strain_ = 1;
};

} // namespace granum::triaxial
