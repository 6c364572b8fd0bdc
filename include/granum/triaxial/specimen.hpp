// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <granum/core/stop.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/sizes/distribution.hpp>

/// Specimens of spheres in a periodic cell or a box of walls: preparation, isotropic compression.
namespace granum::triaxial {

/// How a specimen is brought to its first pressure. Both kinds have nearly the same void ratio; they differ
/// in how many contacts carry it.
enum class Density {
  dense, ///< without friction until the first pressure is reached; friction is switched on there
  loose, ///< just below jamming friction is switched on, and the specimen is compressed with it
};

struct SpecimenRecipe {
  dem::Material material;
  double radius = 0; ///< R > 0 of all grains, or the mean by number of a distribution of sizes [m]
  sizes::Distribution sizes = sizes::Distribution::equal(); ///< of the radii over R
  std::size_t grains = 1000;                                ///< at least least_grains(sizes)
  std::uint64_t seed = 1;
  /// Given: six rigid walls with this friction coefficient [1]; otherwise the cell is periodic.
  std::optional<double> wall_friction = {};
  double expansion_void_ratio =
      0.56;                     ///< of the fixed cell in which the grains grow, overlaps uncorrected [1]
  double first_pressure = 10e3; ///< [Pa]
  /// Loose specimens: the jammed packing is opened by this linear strain, just below jamming ...
  double unjamming_strain = 0.003;
  /// ... and each centre moved at random by up to this share of its grain's radius, so that old contacts are
  /// forgotten.
  double agitation = 0.03;
};

/// Least number for which the cell is wider than four diameters of the largest grain, because its pairs must
/// meet through one face alone, at a void ratio of 0.2 as well; 40 where all are equal.
[[nodiscard]] std::size_t least_grains(const sizes::Distribution& sizes);

/// \throws InvalidArgument naming the value that no specimen can have.
void require_valid(const SpecimenRecipe& recipe);

/// Sizes as dem::Specimen has them, drawn from the recipe's distribution by its seed, in no order; none
/// where all grains are equal.
[[nodiscard]] std::vector<double> drawn_sizes(const SpecimenRecipe& recipe);

/// A specimen and how well each stage of its preparation converged.
struct FrictionlessPacking {
  dem::Specimen state;
  std::size_t minimiser_steps = 0;
  dem::RelaxReport last; ///< of the stage at first_pressure
};

/// Frictionless specimen in equilibrium at the first pressure, by particle expansion: points at random in a
/// cube grow in stages, overlaps relaxed at fixed cell with a linear law after each; then the true law, and
/// the enthalpy is minimised at 100, 10 and 1 times the first pressure, to an unbalanced force ratio of 1e-5,
/// the tolerance of compression_options() too. After friction is switched on, G of 1,000 spheres is within
/// 1e-3 of the result with 1e-6 (15 of 16 specimens; the other one moved to another packing, 1.6 % softer at
/// 1e-5); 1e-3 would be up to 2 % away. Thousands of grains may not come that far: they are left at 1e-3
/// (see FrictionlessPacking::last), and come to rest once friction is on.
/// Same recipe, same bits. The law, the seed, the sizes and their number decide; friction and density
/// kind do not.
/// \throws   InvalidArgument (recipe); NotConverged if the minimiser does not; Stopped on stop_requested
[[nodiscard]] FrictionlessPacking frictionless_specimen(const SpecimenRecipe& recipe,
                                                        const StopRequest& stop_requested = {});

/// Opens a jammed specimen by recipe.unjamming_strain, moves its grains at random by recipe.agitation, and
/// removes overlaps: no contact carries force afterwards.
/// \throws   InvalidArgument (recipe); NotConverged if contacts still carry force; Stopped on stop_requested
[[nodiscard]] dem::Specimen unjam(dem::Specimen jammed, const SpecimenRecipe& recipe,
                                  const StopRequest& stop_requested = {});

/// The state from which compression with friction starts: the jammed one (dense) or the opened one (loose).
[[nodiscard]] dem::Specimen start_of_compression(const dem::Specimen& frictionless, Density density,
                                                 const SpecimenRecipe& recipe,
                                                 const StopRequest& stop_requested = {});

/// Options that suit isotropic compression of either kind.
[[nodiscard]] dem::QuasistaticOptions compression_options();

/// One equilibrium state on a stress path.
struct Snapshot {
  double pressure = 0; ///< target [Pa]
  dem::Specimen state;
  dem::QuasistaticReport report;
};

/// Compresses with friction through the pressures in turn, each a fresh start from the state before, so that
/// a run that is resumed from any snapshot ends with the same bits.
/// \param    visit  called with each snapshot as it is reached; returning false ends the path
/// \return   false if the path ended early: a stage did not converge, or visit returned false
bool isotropic_path(dem::Specimen state, const dem::Material& material, const std::vector<double>& pressures,
                    const dem::QuasistaticOptions& options,
                    const std::function<bool(const Snapshot&)>& visit);

} // namespace granum::triaxial
