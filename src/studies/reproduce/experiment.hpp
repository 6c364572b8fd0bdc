// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/running/probes.hpp"
#include "studies/running/run_control.hpp"
#include "studies/scene/scene.hpp"
#include <granum/analysis/measurement.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/elastic/transverse_isotropic.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/shear_test.hpp>

/// The paper's experiment: specimens compressed isotropically and sheared on four stress paths, frozen again
/// and again, and each frozen state measured, solved as a network, estimated and probed.         [Chung2014]
namespace granum::studies {

inline constexpr std::size_t polar_bins = 18; ///< of gamma in [0, pi/2]
inline constexpr std::size_t force_bins = 32; ///< of f_n/<f_n> in [0, 8)

/// Results of the closed forms for a frozen state.
struct ClosedForms {
  elastic::TransverselyIsotropic uniform_strain; ///< rung 2
  elastic::TransverselyIsotropic uniform_stress;
  elastic::TransverselyIsotropic relaxed; ///< rung 3
  double G_hh_error = 0;                  ///< standard error of relaxed, relative to it [1]
  double G_vh_error = 0;

  bool operator==(const ClosedForms&) const = default;
};

/// One frozen state: the part of its analysis::Measurement that the tables and figures are made of, in plain
/// numbers, so that checkpoints store it to the bit.
struct StateRecord {
  triaxial::PathPoint at;         ///< point of the path at which the state was taken
  stress::AxialStress stress;     ///< of the frozen state [Pa]
  double void_ratio = 0;          ///< cell volume over grain volume, minus 1
  double interior_void_ratio = 0; ///< between walls: two diameters inside; in a periodic cell the same
  analysis::Microstructure micro; ///< of the frozen state, but sliding_fraction while it was still sheared;
                                  ///< between walls: of the part two diameters inside
  double coordination_number_all = 0; ///< C_n of all grains, near walls as well: the paper's
  double coordination_error = 0; ///< its standard error, by the scatter of the grains' numbers of contacts
  Mat3 fabric;                   ///< F_ij of all contacts
  std::array<std::uint32_t, polar_bins> polar_counts{}; ///< all contacts by the polar angle of their normal
  std::array<std::uint32_t, force_bins> force_counts{}; ///< contacts by f_n/<f_n>
  std::uint32_t contacts = 0;
  std::array<double, 36> network{};  ///< relaxed stiffness, rows of the Voigt matrix [Pa]
  std::array<double, 36> affine{};   ///< under uniform strain [Pa]
  std::optional<ClosedForms> closed; ///< none if a state has no static force field (near failure)
  std::optional<Probes> probes;      ///< cyclic shear, if requested
  double unbalanced_force_ratio = 0;
  std::size_t rest_steps = 0; ///< to freeze it

  [[nodiscard]] double G_hh() const { return network[5 * 6 + 5]; }
  [[nodiscard]] double G_vh() const { return (network[3 * 6 + 3] + network[4 * 6 + 4]) / 2; }

  bool operator==(const StateRecord&) const = default;
};

/// A cycle of horizontal shear (G_hh) with friction at constant normal stresses: the start and 5 quarters.
struct ShearLoop {
  double eta = 0;       ///< where the specimen was frozen
  double amplitude = 0; ///< shear strain [1]
  std::vector<triaxial::LoopPoint> points;
};

/// One path of one specimen.
struct PathRun {
  std::optional<stress::ShearPath> path; ///< none: isotropic compression
  std::vector<StateRecord> points;
  std::vector<triaxial::PathPoint> curve; ///< finer than the points; empty for isotropic compression
  std::vector<ShearLoop> loops;           ///< TXC of the first contact shape, dense: at eta = 0, 0.5, 1
  triaxial::PathPoint peak;               ///< of the largest |eta|
  double path_error = 0;                  ///< largest relative error of the constant stress of the path
  double largest_inertial_number = 0;
  std::size_t steps = 0;
  std::vector<std::string> notes; ///< of states that could not be frozen and are left out
  std::string failure;            ///< empty when the path was run to its end
};

/// "ISO", "TXC", "RTXC", "RTXE", "TXE".
[[nodiscard]] std::string_view name(const std::optional<stress::ShearPath>& path);

struct ExperimentSpecimen {
  contact::Shape contact = contact::Shape::sphere;
  triaxial::Density density = triaxial::Density::dense;
  std::uint64_t seed = 0;
  dem::Specimen end_of_iso;  ///< from which the paths start; no grains if compression failed
  std::vector<PathRun> runs; ///< isotropic compression, then the paths of the scene
};

struct Experiment {
  Scene scene;
  std::vector<ExperimentSpecimen> specimens; ///< contact, then density, then seed

  [[nodiscard]] bool complete() const;
};

/// Folder of the checkpoints of a run.
struct CheckpointFolder {
  std::filesystem::path folder; ///< exists and can be written to; empty: no checkpoints
  std::string scene_text;       ///< identifies the scene: checkpoints of another one are refused
};

/// Removes the checkpoints of earlier runs of any scene, and temporary files of killed runs.
/// Files of other names, and folders, stay.
/// \param    folder  need not exist
/// \throws   FileError naming a checkpoint that cannot be removed
/// Checked by tests/studies/test_experiment.cpp
void remove_checkpoints(const std::filesystem::path& folder);

/// Runs the experiment: packings, isotropic compression of each specimen, then all paths from its end, each
/// the work of one thread, so that results do not depend on the number of threads. After each frozen state
/// the path is written to a checkpoint; a run that finds checkpoints of its scene continues from them and
/// ends with the same bits, whenever it was stopped before.
/// \return   all specimens; paths that failed or were stopped contain a message
/// \throws   InvalidArgument for an impossible scene; FileError if a checkpoint cannot be written (nothing
///           that was written before is lost), is damaged, or belongs to another scene
/// Checked by tests/studies/test_experiment.cpp
[[nodiscard]] Experiment run_experiment(const Scene& scene, const RunControl& control = {},
                                        const CheckpointFolder& checkpoints = {});

} // namespace granum::studies
