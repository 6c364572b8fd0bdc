// SPDX-License-Identifier: GPL-3.0-or-later
// Triaxial compression of the page's specimen: constant lateral stress, growing axial strain.
#include <memory>

#include <granum/core/error.hpp>
#include <granum/stress/stress.hpp>

#include "experiment.hpp"

using namespace granum;

/// A test of the last compressed specimen, up to the axial strain. Its rate and the spacing of the points of
/// its curve are those of `granum reproduce`.
GRANUM_EXPORT(experiment_shear_begin) void experiment_shear_begin(double largest_strain) {
  web::Experiment& e = web::experiment();
  if (!(e.pressure > 0))
    throw Error("the specimen can be sheared only after its compression");
  constexpr double points_between_states = 5;
  triaxial::ShearOptions options{
      .path = stress::ShearPath::txc, .mean_stress = e.pressure, .largest_strain = largest_strain};
  options.eta_step /= points_between_states;
  options.strain_step /= points_between_states;
  // Shared with the test, which keeps the function: it continues where the last call ended.
  options.stop_requested = [&e, clock = std::make_shared<web::Clock>()] {
    return clock->tick([&e] {
      if (e.shear)
        web::draw(e, e.shear->engine().state());
    });
  };
  e.shear.emplace(e.state, e.recipe.material, options);
}

/// Moves to the next point of the curve: 0 if there are more, 1 at the last one, 2 if the motion became
/// unstable; axial and volumetric strain; q, eta = q/p', sigma_v, sigma_h [Pa]; at the peak so far q, eta,
/// axial strain and the friction angle that it mobilises [rad]; the largest error of sigma_h so far,
/// relative; work done on the specimen [J/m3].
GRANUM_EXPORT(experiment_shear) void experiment_shear() {
  web::Experiment& e = web::experiment();
  if (!e.shear)
    throw Error("the shear test has not begun");
  const triaxial::ShearEvent event = e.shear->advance();
  web::draw(e, e.shear->engine().state());
  const triaxial::PathPoint &now = e.shear->now(), &peak = e.shear->peak();
  web::numbers() = {event == triaxial::ShearEvent::snapshot   ? 0.0
                    : event == triaxial::ShearEvent::finished ? 1.0
                                                              : 2.0,
                    now.axial_strain,
                    now.volumetric_strain,
                    now.stress.deviator(),
                    now.stress.ratio(),
                    now.stress.v,
                    now.stress.h,
                    peak.stress.deviator(),
                    peak.stress.ratio(),
                    peak.axial_strain,
                    stress::mobilised_friction_angle(peak.stress),
                    e.shear->path_error(),
                    now.work};
}
