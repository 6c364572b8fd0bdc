// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/verify/analysis.hpp>

#include <algorithm>
#include <cmath>

#include <granum/assembly/density.hpp>
#include <granum/assembly/fabric_tensor.hpp>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/core/units.hpp>

#include "analysis_parts.hpp"

namespace granum::verify {

namespace {

using io::Finding;

CountAnalysis count(const io::ImportedPacking& packing) {
  const Assembly& assembly = packing.assembly;
  std::vector<bool> touched(assembly.grain_count(), false);
  for (const Contact& c : assembly.contacts)
    touched[c.i] = touched[c.j] = true;
  CountAnalysis out{.grains = assembly.grain_count(),
                    .contacts = assembly.contacts.size(),
                    .wall_contacts = packing.walls.size(),
                    .mechanical = mechanical_coordination(assembly, ContactKind::frictional)};
  out.without_contact = static_cast<std::size_t>(std::count(touched.begin(), touched.end(), false));
  out.coordination_number = coordination_number(assembly);
  const double grains = static_cast<double>(out.grains);
  const double touching = grains - static_cast<double>(out.without_contact);
  if (touching > 0)
    out.touching_coordination_number = out.coordination_number * (grains / touching);
  out.coordination_number_with_walls =
      out.coordination_number + static_cast<double>(out.wall_contacts) / grains;
  return out;
}

void measure_geometry(const Assembly& assembly, Analysis& out) {
  out.volume = assembly.volume();
  out.void_ratio = void_ratio(assembly);
  const auto [smallest, largest] = std::minmax_element(assembly.radius.begin(), assembly.radius.end());
  out.smallest_radius = *smallest;
  out.largest_radius = *largest;
  double squares = 0, cubes = 0;
  for (const double radius : assembly.radius) {
    const double relative = radius / out.largest_radius;
    squares += relative * relative;
    cubes += relative * relative * relative;
  }
  out.equivalent_radius = *smallest == *largest ? *largest : out.largest_radius * (cubes / squares);
}

/// The contacts that press: moments of forces have no meaning in tension.
Assembly pressing_part(const Assembly& assembly) {
  Assembly pressing = assembly;
  std::erase_if(pressing.contacts, [](const Contact& c) { return !(c.normal_force > 0); });
  return pressing;
}

} // namespace

ForceAnalysis analyse_forces(const Assembly& assembly, bool tangential_known,
                             const AnalysisOptions& options) {
  ForceAnalysis out{.distribution = force_distribution(normal_forces(assembly), options.force_bins)};
  out.unbalance = unbalance(assembly);
  if (out.distribution.pressing == 0)
    return out;
  const Assembly pressing = pressing_part(assembly);
  out.Z_2 = normal_force_moment(pressing, 2);
  out.Z_5_3 = normal_force_moment(pressing, 5.0 / 3);
  if (!tangential_known)
    return out;
  double tangential = 0;
  for (const Contact& c : pressing.contacts)
    tangential += norm(c.tangential_force);
  out.mean_tangential_over_normal =
      tangential / (out.distribution.mean * static_cast<double>(out.distribution.pressing));
  out.friction = estimate_friction(pressing);
  if (options.friction_coefficient)
    out.sliding_fraction = sliding_fraction(pressing, *options.friction_coefficient);
  else if (out.friction)
    out.sliding_fraction = sliding_fraction(pressing, out.friction->coefficient);
  return out;
}

namespace {

/// Whether the law can be read off forces and overlaps, so that its modulus can be as well.
bool law_is_clear(const LawCheck& check) {
  constexpr double clear = 1e-2;
  constexpr std::size_t fewest = 10;
  return check.contacts >= fewest && check.median_misfit < clear;
}

/// Compares forces with the law, and takes the grain's modulus from them if it is not given.
void find_law(const io::ImportedPacking& packing, const AnalysisOptions& options, Analysis& out) {
  const double nu = options.grain_poisson_ratio;
  constexpr double any_modulus = 1e9; // forces are proportional to it
  const double modulus = options.grain_shear_modulus.value_or(any_modulus);
  if (out.forces)
    out.law_check = check_law(packing.assembly, options.law, {modulus, nu});
  if (options.grain_shear_modulus) {
    out.grain = contact::GrainMaterial{modulus, nu};
  } else if (out.law_check && law_is_clear(*out.law_check)) {
    const double found = any_modulus * out.law_check->coefficient_ratio;
    out.grain = contact::GrainMaterial{found, nu};
    out.law_check->coefficient_ratio = 1;
    out.notes.push_back("G_g of the grains = " + pretty(found, Dimension::pressure) + " with nu_g = " +
                        short_text(nu) + ", from the forces: they fix G_g/(1 - nu_g) alone");
  } else {
    out.notes.push_back("no G_g of the grains given, and forces against overlaps do not tell it: "
                        "no stiffnesses, no closed forms");
  }
}

/// What the closed forms need, or a note on what is not there.
void make_state(const AnalysisOptions& options, Analysis& out) {
  if (!out.grain)
    return;
  if (!out.stress || !out.fabric) {
    out.notes.push_back("no closed forms: they need forces of at least two contacts");
    return;
  }
  const Mat3& stress = out.stress->symmetric;
  effective::State state{.law = options.law(*out.grain, out.equivalent_radius),
                         .tangential_ratio = options.tangential_ratio
                                                 ? contact::given_stiffness_ratio(*options.tangential_ratio)
                                                 : contact::mindlin_stiffness_ratio(out.grain->poisson_ratio),
                         .radius = out.equivalent_radius,
                         .void_ratio = out.void_ratio,
                         .coordination_number = out.counts.coordination_number,
                         .fabric_anisotropy = out.fabric->by_moment.anisotropy,
                         .stress_v = stress(2, 2),
                         .stress_h = (stress(0, 0) + stress(1, 1)) / 2};
  try {
    effective::require_valid(state);
    out.state = state;
  } catch (const InvalidArgument& error) {
    out.notes.push_back(std::string("no closed forms: ") + error.what());
  }
}

bool stiffness_in_files(const io::ImportedPacking& packing) {
  const auto& contacts = packing.assembly.contacts;
  return std::any_of(contacts.begin(), contacts.end(),
                     [](const Contact& c) { return c.normal_stiffness > 0; });
}

/// The assembly with k_n and k_t of its contacts: those of the files, or of the law.
std::optional<Assembly> with_stiffness(const io::ImportedPacking& packing, const AnalysisOptions& options,
                                       Analysis& out) {
  Assembly assembly = packing.assembly;
  if (stiffness_in_files(packing) && !options.stiffness_from) {
    out.notes.emplace_back("k_n and k_t of the network are those of the files");
    return assembly;
  }
  if (!out.grain)
    return std::nullopt;
  const bool rough = packing.has(Finding::few_digits) && out.forces.has_value();
  const io::StiffnessFrom from =
      options.stiffness_from.value_or(rough ? io::StiffnessFrom::force : io::StiffnessFrom::overlap);
  const double ratio =
      options.tangential_ratio.value_or(contact::mindlin_stiffness_ratio(out.grain->poisson_ratio));
  const contact::PowerLaw law = options.law(*out.grain, out.equivalent_radius);
  if (law.alpha() == 2 && out.smallest_radius != out.largest_radius)
    io::assign_hertz_stiffness(assembly, *out.grain, ratio, from);
  else
    io::assign_stiffness(assembly, law, ratio, from);
  out.notes.push_back(from == io::StiffnessFrom::force ? "k_n of the network from the forces"
                                                       : "k_n of the network from the overlaps");
  return assembly;
}

void solve_network(const io::ImportedPacking& packing, const AnalysisOptions& options, Analysis& out) {
  if (!options.solve_network || out.counts.mechanical.contact_count == 0)
    return;
  const std::optional<Assembly> assembly = with_stiffness(packing, options, out);
  if (!assembly)
    return;
  const network::Response response = network::linear_response(*assembly, options.network);
  NetworkAnalysis network{.report = response.report(),
                          .relaxed = response.last_iterate(),
                          .affine = response.affine(),
                          .symmetry = {},
                          .bulk_bounds = bulk_modulus_bounds(*assembly)};
  if (network.relaxed.matrix.norm() > 0)
    network.symmetry = elastic::symmetry_distances(network.relaxed);
  out.network = network;
}

} // namespace

FabricAnalysis analyse_fabric(std::span<const Vec3> normals, std::size_t rose_bins) {
  constexpr std::size_t enough = 20;
  FabricAnalysis out{.contacts = normals.size(),
                     .tensor = {},
                     .by_moment = fabric::estimate_anisotropy(normals),
                     .by_likelihood = fabric::estimate_anisotropy_by_likelihood(normals),
                     .isotropy = fabric::test_isotropy(normals),
                     .density = std::nullopt,
                     .axisymmetry = std::nullopt,
                     .rose = {}};
  for (const Vec3& n : normals)
    out.tensor += (1 / static_cast<double>(normals.size())) * outer(n, n);
  if (normals.size() >= enough) {
    out.density = fabric::test_density(normals);
    out.axisymmetry = fabric::test_axisymmetry(normals);
  }
  out.rose = fabric::rose(normals, out.by_likelihood.anisotropy, rose_bins);
  return out;
}

Analysis analyse(const io::ImportedPacking& packing, const AnalysisOptions& options) {
  Analysis out;
  out.step = packing.step;
  out.time = packing.time;
  measure_geometry(packing.assembly, out);
  out.counts = count(packing);
  if (out.counts.contacts >= 2)
    out.fabric = analyse_fabric(contact_normals(packing.assembly), options.rose_bins);
  const bool forces = out.counts.contacts > 0 && !packing.has(Finding::forces_unknown);
  if (forces) {
    out.forces = analyse_forces(packing.assembly, !packing.has(Finding::tangential_unknown), options);
    out.stress = contact_stress(packing.assembly);
  }
  find_law(packing, options, out);
  make_state(options, out);
  solve_network(packing, options, out);
  add_warnings(packing, out);
  return out;
}

} // namespace granum::verify
