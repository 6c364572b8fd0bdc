// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/reproduce/experiment.hpp"
#include <granum/core/stop.hpp>

#include "studies/running/work_sharing.hpp"

/// The pieces of the experiment, each the work of one thread. Each goes on from its checkpoint if there is
/// one.
namespace granum::studies {

/// Data that every piece needs in addition to its own state.
struct Piece {
  const Scene& scene;
  const CheckpointFolder& checkpoints;
  Meter& meter;
  contact::Shape contact;
  triaxial::Density density;
  std::uint64_t seed;
  double work; ///< predicted, in steps of the engine with friction
};

/// The frictionless packing; dense and loose specimens share it.
[[nodiscard]] dem::Specimen packing(const Piece& piece);

/// Isotropic compression of a frictionless packing.
/// \param    end   gets the state at the last pressure, if it is reached
[[nodiscard]] PathRun isotropic_run(const Piece& piece, const dem::Specimen& packing, dem::Specimen& end);

/// A stress path from the end of isotropic compression.
[[nodiscard]] PathRun shear_run(const Piece& piece, const dem::Specimen& start, stress::ShearPath path);

/// Name of a path in checkpoint files: "txc"; "iso" without a path, for isotropic compression.
[[nodiscard]] std::string path_in_file_names(const std::optional<stress::ShearPath>& path);

/// Brings a copy of the state to rest at fixed cell, measures it, and records the results.
/// \param    at       point of the path of the state
/// \param    probed   whether to shear it by DEM as well
/// \param    notes    gets a note if probes did not come to rest; the state is then without probes
/// \throws   NotConverged if it does not come to rest, or its network is not solved; Stopped if so
///           asked
[[nodiscard]] StateRecord state_record(const dem::Specimen& state, const dem::Material& material,
                                       const triaxial::PathPoint& at, bool probed,
                                       std::vector<std::string>& notes, const StopRequest& stop_requested);

/// A cycle of horizontal shear with friction at constant normal stresses. Near failure it need not come to
/// rest: the loop is drawn as it is.
/// \throws   Stopped on stop_requested
[[nodiscard]] ShearLoop shear_loop(const dem::Specimen& state, const dem::Material& material, double eta,
                                   double amplitude, const StopRequest& stop_requested);

} // namespace granum::studies
