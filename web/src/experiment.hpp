// SPDX-License-Identifier: GPL-3.0-or-later
// The specimen of the page's experiment, made and compressed in one source and sheared in another.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/dem/engine.hpp>
#include <granum/triaxial/shear_test.hpp>
#include <granum/triaxial/specimen.hpp>

#include "exports.hpp"

extern "C" {
/// Lets the page show the view; called several times a second while the experiment runs.
__attribute__((import_module("page"), import_name("frame"))) void page_frame();
}

namespace granum::web {

/// The view: grains, and contacts with f_n > 0.
struct View {
  std::vector<float> grains;   ///< x, y, z, radius, 1 for a rattler; lengths over the mean radius
  std::vector<float> contacts; ///< x, y, z of one centre, x, y, z of the other, force over the mean force
  float edge[3]{};             ///< of the cell
  /// a, then a histogram of the angle of contact normals to the vertical in equal steps from 0 to 90 degrees,
  /// over that of an isotropic packing; empty below 20 contacts
  std::vector<float> rose;
};

struct Experiment {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::SpecimenRecipe recipe;
  triaxial::Density density = triaxial::Density::dense;
  dem::Specimen state;
  double pressure = 0; ///< of the last compression; 0 before [Pa]
  View view;
  std::vector<double> ln_pressure, ln_network, ln_relaxed;
  double first_force = 0;                   ///< mean force of the contacts at the first pressure [N]
  std::optional<triaxial::ShearTest> shear; ///< once it has begun
};

/// The running experiment.
/// \throws   Error if none has begun
Experiment& experiment();

/// Fills the view, and lets the page show it.
void draw(Experiment& experiment, const dem::Specimen& state);

/// Reports long work to the page ten times a second. It never stops the work: the page does, by ending its
/// worker.
class Clock {
 public:
  template <class Tell>
  bool tick(const Tell& tell) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ > std::chrono::milliseconds(100)) {
      tell();
      last_ = now;
    }
    return false;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace granum::web
