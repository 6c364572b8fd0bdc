// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "studies/reproduce/experiment.hpp"

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
};

/// The frictionless packing; dense and loose specimens share it.
[[nodiscard]] dem::Specimen packing(const Piece& piece);

/// Isotropic compression of a frictionless packing.
struct IsoRun {
  PathRun run;
  dem::Specimen state; ///< at the last pressure
};
[[nodiscard]] IsoRun isotropic_run(const Piece& piece, const dem::Specimen& packing);

/// A stress path from the end of isotropic compression.
[[nodiscard]] PathRun shear_run(const Piece& piece, const dem::Specimen& start, stress::ShearPath path);

/// Name of a path in checkpoint files: "txc"; "iso" without a path, for isotropic compression.
[[nodiscard]] std::string path_in_file_names(const std::optional<stress::ShearPath>& path);

/// Predicted work of the pieces and of all of them, in steps of the engine with friction.
[[nodiscard]] double packing_steps(const Scene& scene);
[[nodiscard]] double isotropic_steps(const Scene& scene, contact::Shape contact, triaxial::Density density);
[[nodiscard]] double shear_steps(const Scene& scene, contact::Shape contact, stress::ShearPath path);
[[nodiscard]] double experiment_steps(const Scene& scene);

} // namespace granum::studies
