// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <granum/core/stop.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::triaxial {

/// Small-strain shear of a frozen copy; the cell's faces move according to the name (first index: the
/// direction that the sheared layers are stacked in, second: the direction that they move in). z is vertical.
enum class ShearMode {
  hh, ///< layers stacked along x move along y
  hv, ///< layers stacked along x move along z
  vh, ///< layers stacked along z move along x
};

struct ProbeOptions {
  /// Shear strain of the cycle [1]; 0: chosen from the mean overlap, 3e-5 overlap/diameter. Weakly
  /// coordinated specimens have contacts that barely touch; three times as much opens enough of them to show
  /// (1 % of G).
  double amplitude = 0;
  /// false: no contact may slide during the probe, the response of the frozen network; true: the material's
  /// friction.
  bool sliding = false;
  /// false: the cell only shears; true: servos keep the normal stresses at its faces constant.
  bool hold_normal_stress = false;
  /// States at rest recorded in each quarter of the cycle, 0: none. The cycle then continues to its first
  /// end once more, where a loop that repeats itself closes.
  std::size_t loop_points = 0;
  std::size_t ramp_steps = 100;
  /// Unbalanced force ratio after each leg [1]. With the settled share below, G is that of the network within
  /// 0.2 % in the mean of loose specimens of 1,000 grains, and 0.8 % where soft modes relax slowest.
  double force_tolerance = 1e-9;
  /// A leg also ends when its stress is steady within this fraction of the stress that the strain causes in a
  /// network that does not relax [1]: among many grains some rattler always moves. The steady creep that this
  /// leaves is subtracted, unless contacts may slide. 0: only forces are checked.
  double settled_share = 3e-5;
  /// Limit for each leg. Hundreds suffice in dense packings; soft modes of loose ones of unequal grains may
  /// need 20,000.
  std::size_t max_steps = 50000;
  StopRequest stop_requested = {};
};

/// A state at rest on the cycle, from its start.
struct LoopPoint {
  double shear_strain = 0; ///< [1]
  double shear_stress = 0; ///< beyond that of the start [Pa]
};

/// Status and results of a probe.
struct [[nodiscard]] ProbeResult {
  bool converged = false; ///< every leg came to rest, or its stress settled
  double amplitude = 0;   ///< shear strain used [1]
  /// Largest after any leg [1]. Beyond the tolerance when the stress settled first, or a leg ran out of
  /// steps: a rattler that is squeezed out of its cage keeps a specimen from rest, but carries no load.
  double unbalanced_force_ratio = 0;
  std::size_t steps = 0;
  // The last iterates of the functions below. 0, and an empty loop, where the cycle was not gone through:
  // unless contacts may slide, a start or a first leg that neither rests nor settles ends the probe.
  double last_shear_modulus = 0;
  double last_opening = 0;
  std::vector<LoopPoint> last_loop;

  /// Secant between the two ends of the cycle [Pa].
  /// \throws   NotConverged unless converged
  [[nodiscard]] double shear_modulus() const;
  /// Stress left at zero strain after the cycle / stress swing; 0 for an elastic response [1].
  /// \throws   NotConverged unless converged
  [[nodiscard]] double opening() const;
  /// The start and 5 quarters, if options.loop_points > 0.
  /// \throws   NotConverged unless converged
  [[nodiscard]] const std::vector<LoopPoint>& loop() const;
};

/// The largest unbalanced force ratio of a frozen state that is at rest [1]: rest_bound, for a rattler on its
/// way out may keep a state above the tolerance that was aimed at, or that tolerance if it is larger.
inline constexpr double rest_bound = 1e-6;
[[nodiscard]] constexpr double largest_unbalance_at_rest(double force_tolerance) {
  return force_tolerance > rest_bound ? force_tolerance : rest_bound;
}

/// Unbalanced force ratio that freezing aims at [1].
inline constexpr double usual_force_tolerance = 1e-8;

/// Tolerance in studies of a whole path: beyond |eta| = 0.6 specimens continue to creep. Against 1e-5
/// it moves G of 1,000 spheres by 1e-7 (median) and 0.2 % at most up to |eta| = 0.6, and by 0.2 % (median),
/// 2 % at most beyond, for a quarter of the steps; 1e-8 needs five times as many again.
inline constexpr double creeping_force_tolerance = 1e-4;

/// A state at rest at fixed cell without sliding contacts, also at walls: the result of freezing a specimen
/// on its path means here. Creep left over from the path ends, so that the network of the frozen state is the
/// one that a probe shears.
struct [[nodiscard]] FrozenState {
  dem::Specimen last_state;      ///< at rest or not
  dem::QuasistaticReport report; ///< steps, and the unbalanced force at the end
  double force_tolerance = 0;    ///< that was aimed at [1]

  [[nodiscard]] bool at_rest() const {
    return report.unbalanced_force_ratio <= largest_unbalance_at_rest(force_tolerance);
  }
  /// \throws   NotConverged unless at_rest()
  [[nodiscard]] const dem::Specimen& state() const;
  /// Contact stress of that state [Pa].
  /// \throws   NotConverged unless at_rest()
  [[nodiscard]] const Mat3& stress() const;
};

/// Takes 10,000 steps at most under adaptive drag, as many in a descent (dem::Engine::descend), and then
/// 20,000 under the drag of the slowest shear wave; all of that again, six times at most, until the state is
/// at rest.
/// \param    force_tolerance  unbalanced force ratio that is aimed at > 0 [1]
///           1e-6 changes the moduli of 1,000 walled grains by 1e-4 (dense) to 5e-4 (loose), 1e-5 by up to
///           5e-3; loose ones seldom rest beyond 5e-7, for all of 40,000 steps of drag
/// \throws   Stopped on stop_requested
/// Checked by tests/triaxial/test_probe.cpp
FrozenState freeze_in_place(const dem::Specimen& state, const dem::Material& material,
                            double force_tolerance = usual_force_tolerance,
                            const StopRequest& stop_requested = {});

/// Shears a copy of the state to +amplitude, -amplitude and back to zero, at rest after each leg.
/// Assumes   the state is in equilibrium (freeze_in_place); the probe first rests at zero strain as well.
/// \throws   InvalidArgument for a negative amplitude, or a constant normal stress that is not positive;
///           Stopped on options.stop_requested
/// Accuracy  as the amplitude goes to zero, the network's response with its force terms
/// (network::ForceTerms): 0.6 % of G in a dense specimen sheared to q/p = 1. At the chosen amplitude,
/// contacts that barely touch are open for half of the cycle: 0.3 % of G in small, loose specimens.
/// Checked against the network's response by tests/triaxial/test_probe.cpp
ProbeResult probe(const dem::Specimen& state, const dem::Material& material, ShearMode mode,
                  const ProbeOptions& options = {});

/// The same for hh, hv and vh, to the bit; the rest at zero strain, the longest part, is shared. Its steps
/// count in each.
/// Checked by tests/triaxial/test_probe.cpp
std::array<ProbeResult, 3> probe_all(const dem::Specimen& state, const dem::Material& material,
                                     const ProbeOptions& options = {});

/// Grains of a recipe thrown into a cube one after the other, at random places where they touch none that is
/// there: a start for codes that make the packing themselves, of any number of grains.
/// Same recipe, same bits.
/// \param    solid_fraction   of the cube, in (0, 0.3]; beyond 0.38 no place is found any more [1]
/// \throws   InvalidArgument (recipe, solid fraction)
/// Cost      O(grains)
/// Checked by tests/triaxial/test_scatter.cpp
[[nodiscard]] dem::Specimen scattered_specimen(const SpecimenRecipe& recipe, double solid_fraction = 0.2);

} // namespace granum::triaxial
