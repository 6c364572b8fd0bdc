// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>
#include <granum/elastic/stiffness.hpp>

#include "core/compiled_once.hpp"
#include "mistakes.hpp"

namespace granum::studies {

namespace {

using io::Finding;

/// Notes of the reader that invalidate a comparison.
void pass_on(const io::ImportedPacking& packing, std::vector<std::string>& out) {
  for (const io::ImportNote& note : packing.notes)
    switch (note.finding) {
    case Finding::duplicated:
    case Finding::one_sided:
    case Finding::cell_unknown:
    case Finding::wall_contacts:
    case Finding::contact_moments:
    case Finding::cell_turned:
    case Finding::own_image:
    case Finding::units_differ:
    case Finding::unbalanced_rows:
    case Finding::bodies:
    case Finding::signs_turned:
    case Finding::shapes:
    case Finding::empty_rows:
      out.push_back(note.text);
      break;
    case Finding::walls_unknown:
      out.push_back(note.text + ": stress, z* and the network lack them");
      break;
    default:
      break;
    }
}

/// Few digits of lengths, where they matter.
void judge_digits(const io::ImportedPacking& packing, std::vector<std::string>& out) {
  constexpr double matters = 0.01;
  const double share = analysis::rounded_share(packing.assembly, packing.rounding.overlap);
  const bool contacts = !packing.assembly.contacts.empty();
  for (const io::ImportNote& note : packing.notes)
    if (note.finding == Finding::few_digits && (share > matters || !contacts))
      out.push_back(note.text + (contacts
                                     ? ": overlaps are known to " + short_text(packing.rounding.overlap, 2) +
                                           " m, " + percent(share) + " of their median"
                                     : ""));
}

/// Files of grains alone.
void judge_contacts(const io::ImportedPacking& packing, const MeasuredFrame& frame,
                    std::vector<std::string>& out) {
  if (!frame.contacts_known)
    out.emplace_back(
        "the files contain no contacts, and no spheres overlap: C_n, z*, fabric, stress and stiffness are "
        "unknown (positions or radii of few digits, or grains that do not touch)");
  else if (packing.has(Finding::contacts_from_overlaps))
    out.push_back("the files contain no contacts: overlapping spheres are used instead, " +
                  std::string(packing.has(Finding::forces_unknown)
                                  ? "and forces are unknown"
                                  : "with the normal forces of the given material and no tangential ones"));
}

/// A boundary that is no periodic one: the volume that belongs to the grains is not known.
void judge_boundary(const io::ImportedPacking& packing, bool interior, std::vector<std::string>& out) {
  const auto open = std::count(packing.periodic.begin(), packing.periodic.end(), false);
  if (open > 0 && !packing.has(Finding::cell_unknown))
    out.emplace_back(
        interior
            ? "the box has faces that are not periodic: void ratio, stress and C_n above are those of the "
              "whole box with its boundary"
            : "the box has faces that are not periodic: void ratio, stress and C_n are those of the whole "
              "box with its boundary, and so are the closed forms, which assume no walls; --window selects "
              "the interior");
}

/// Grains with exactly one value of a coordinate, as walls glued of grains have.
std::size_t largest_plane(const packing::Assembly& assembly, int axis) {
  std::map<double, std::size_t> planes;
  std::size_t largest = 0;
  for (std::size_t g = 0; g < assembly.grain_count(); ++g) {
    stop_point(g);
    largest = std::max(largest, ++planes[assembly.position[g][axis]]);
  }
  return largest;
}

/// Walls listed as grains: they count in N, and their contacts in N_c.
void judge_grains(const io::ImportedPacking& packing, std::vector<std::string>& out) {
  constexpr double large = 10;       // times the median radius
  constexpr std::size_t fewest = 16; // grains of a glued wall
  constexpr double share_of_plane = 0.05;
  const packing::Assembly& assembly = packing.assembly;
  std::vector<double> radii = assembly.radius;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  for (std::size_t g = 0; g < assembly.grain_count(); ++g)
    if (assembly.radius[g] > large * *middle) {
      out.push_back("grain " + std::to_string(packing.id[g]) + " has " +
                    short_text(assembly.radius[g] / *middle, 3) +
                    " times the radius of the others: is it a wall that counts as a grain?");
      break;
    }
  if (packing.has(Finding::few_digits))
    return; // rounded coordinates coincide by chance
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t count = largest_plane(assembly, axis);
    if (count >= fewest &&
        static_cast<double>(count) >= share_of_plane * static_cast<double>(assembly.grain_count()))
      out.push_back(std::to_string(count) + " grains have exactly the same " + "xyz"[axis] +
                    ": are they a wall made of grains, or a lattice? They count in C_n, fabric and stress");
  }
}

std::string vector_text(const Vec3& v) {
  constexpr double nothing = 1e-4;
  const double size = norm(v);
  const auto part = [&](double x) { return short_text(std::abs(x) < nothing * size ? 0 : x / size, 3); };
  return "(" + part(v.x) + ", " + part(v.y) + ", " + part(v.z) + ")";
}

/// Whether a contact in tension resists rolling or twisting too.
bool is_bonded(const packing::Assembly& assembly) {
  return std::any_of(assembly.contacts.begin(), assembly.contacts.end(), [](const packing::Contact& c) {
    return c.normal_force < 0 && (c.rolling_stiffness > 0 || c.twisting_stiffness > 0);
  });
}

void judge_forces(const io::ImportedPacking& packing, const analysis::Forces& forces, bool adhesion_given,
                  std::vector<std::string>& out) {
  const double at_rest = 1e-3 + unbalance_by_rounding(packing);
  if (forces.distribution.in_tension > 0 && !adhesion_given)
    out.push_back(std::to_string(forces.distribution.in_tension) + " contacts are in tension: " +
                  (is_bonded(packing.assembly)
                       ? "they are bonds, which resist rolling too"
                       : "their forces have viscous parts, or adhesion, which is not given"));
  if (forces.distribution.pressing + forces.distribution.in_tension == 0)
    out.emplace_back(
        "all forces are 0, though grains touch: the files were written before forces were computed, "
        "or another column holds them; stress and stiffness are 0");
  if (!forces.unbalance)
    return;
  double left = forces.unbalance->force_ratio;
  if (forces.weight) {
    left *= forces.weight->left_over;
    const double size = norm(forces.weight->per_volume);
    out.push_back("the grains have weight: the contact forces leave the same force per volume on each, " +
                  short_text(size / 1e3, 4) + " kN per m3 of solid along " +
                  vector_text(forces.weight->per_volume) +
                  "; stress and stiffness grow with depth, and the numbers are means over the depth");
  }
  if (left > at_rest)
    out.push_back("the packing is not at rest: the mean unbalanced force on a grain is " + percent(left) +
                  " of the mean contact force");
}

/// The principal stress whose direction is nearest to z, and those across it, that are not those of a state
/// symmetric about z.
/// \return   whether there are such
bool judge_stress_axes(const Mat3& stress, std::size_t contacts, std::vector<std::string>& out) {
  constexpr double least = 0.1, scatter = 4; // of the mean stress; of that of one contact
  const double matters = std::max(least, scatter / std::sqrt(static_cast<double>(contacts)));
  const double mean = trace(stress) / 3;
  const auto& s = stress;
  const double across = std::hypot(s(0, 0) - s(1, 1), 2 * s(0, 1)), tilted = 2 * std::hypot(s(0, 2), s(1, 2));
  if (!(mean > 0) || std::max(across, tilted) <= matters * mean)
    return false;
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      matrix(i, j) = stress(i, j);
  const SymmetricEigen<3> principal = symmetric_eigen<3>(matrix);
  std::string list;
  for (int k = 2; k >= 0; --k)
    list += (list.empty() ? "" : ", ") + pretty(principal.values[k], Dimension::pressure) + " along " +
            vector_text({principal.vectors(0, k), principal.vectors(1, k), principal.vectors(2, k)});
  out.push_back(
      "the stress is not symmetric about z, which the closed forms and the moduli of one axis assume: "
      "principal stresses " +
      list + "; use the 6x6 stiffness, and --axis if the axis of the test is another");
  return true;
}

/// Moments that no force explains: the network without them is not this material's.
void judge_moments(const analysis::Measurement& measured, std::vector<std::string>& out) {
  constexpr double least = 0.02, times_force = 3;
  if (!measured.forces || !measured.forces->unbalance)
    return;
  const packing::Unbalance& left = *measured.forces->unbalance;
  if (!measured.moments.starts_with("contacts carry") ||
      left.moment_ratio <= std::max(least, times_force * left.force_ratio))
    return;
  out.push_back(
      "forces balance to " + percent(left.force_ratio) + " but moments to " + percent(left.moment_ratio) +
      " only: contacts carry moments (rolling resistance, bonds), or the grains are parts of clumps. "
      "Rung 3 is not evaluated, and the network describes this material only if --rolling-stiffness and "
      "--twisting-stiffness, or the ids of the clumps, are given");
}

/// The exponent of forces that fit no law.
std::string cause_of_misfit(const analysis::LawCheck& check, bool several_types) {
  constexpr double near = 0.03;
  const auto is = [&](double exponent) {
    return check.force_exponent && std::abs(check.force_exponent->value - exponent) < near;
  };
  const std::string found =
      check.force_exponent ? "they grow as d^" + short_text(check.force_exponent->value, 4) : "";
  if (is(1))
    return found +
           ": springs of several stiffnesses, or viscous parts; --contact flat uses one stiffness for all";
  if (several_types)
    return "the grains have several types: give --material for each; or viscous parts";
  if (is(1.5))
    return found + " as Hertz', with different factors: several materials (give --material for each type), "
                   "or viscous parts";
  if (is(2))
    return found + ": cones (--contact cone), or viscous parts";
  return "viscous parts, another law, or forces that depend on the loading history";
}

/// \param    rounded   share of the overlaps by which they may be off: forces by 1.5 times as much, and those
///                     of small overlaps by more
/// \param    law_known   not its shape alone
void judge_law(const analysis::LawCheck& check, double rounded, bool law_known, bool several_types,
               std::vector<std::string>& out) {
  constexpr double too_rough = 0.1, small_overlaps = 3;
  const double scatter = 1e-2 + small_overlaps * 1.5 * rounded;
  if (check.contacts == 0)
    return;
  if (rounded > too_rough) {
    out.emplace_back("forces and overlaps do not give the contact law: the overlaps are rounded");
    return;
  }
  if (check.misfit_90 > scatter)
    out.push_back("forces do not follow the contact law: 10 % of the contacts are off by " +
                  percent(check.misfit_90) + " or more (" + cause_of_misfit(check, several_types) + ")");
  else if (law_known && check.coefficient_ratio && std::abs(*check.coefficient_ratio - 1) > scatter)
    out.push_back("forces are " + short_text(*check.coefficient_ratio) +
                  " times those of the given law: the grains are of another material");
}

/// The largest parts of a strain, "11" or "11 and -33".
std::string strain_text(const Eigen::Matrix<double, 6, 1>& strain) {
  const char* const names[] = {"11", "22", "33", "23", "13", "12"};
  constexpr double counts = 0.4;
  const double largest = strain.cwiseAbs().maxCoeff();
  Eigen::Index first = 0;
  strain.cwiseAbs().maxCoeff(&first);
  std::string text;
  for (int k = 0; k < 6; ++k)
    if (std::abs(strain[k]) > counts * largest)
      text +=
          (text.empty() ? "" : " and ") + std::string(strain[k] * strain[first] < 0 ? "-" : "") + names[k];
  return text;
}

/// Strains that the network lets happen at no cost.
void judge_free_strains(const analysis::Network& network, std::vector<std::string>& out) {
  constexpr double nothing = 1e-9;
  const double scale = network.affine.stiffness.matrix.norm();
  if (!network.response.converged() || !(scale > 0))
    return;
  const elastic::EigenSystem modes = elastic::eigen_system(network.relaxed.stiffness.matrix);
  std::string free;
  int count = 0;
  for (int k = 0; k < 6; ++k)
    if (std::abs(modes.values[k]) < nothing * scale) {
      free += (free.empty() ? "" : "; ") + strain_text(modes.vectors.col(k));
      ++count;
    }
  if (count == 6)
    out.emplace_back(
        "the network has no stiffness for any strain: the grains can move freely (a pile, a gas, or "
        "contacts that are missing); its moduli are zero apart from rounding");
  else if (count > 0)
    out.push_back("the network does not resist " + std::to_string(count) + " of six strains (" + free +
                  "): the grains can follow these freely, and such moduli are zero apart from rounding");
}

void judge_network(const network::Response::Report& report, std::vector<std::string>& out) {
  if (report.status == network::Status::iteration_limit)
    out.push_back("the network did not converge: residual " + short_text(report.residual, 2));
  if (report.status == network::Status::not_positive_definite)
    out.emplace_back("the network is unstable: it has no moduli");
}

/// Contact forces that are not small beside the stiffness of the contacts, by the shear modulus that they
/// change most.
void judge_force_terms(const network::Response& response, std::vector<std::string>& out) {
  constexpr double matters = 0.02, resists = 1e-6; // of the modulus; of that under uniform strain
  if (!response.converged() || !response.force_terms())
    return;
  double most = 0;
  for (int plane = 3; plane < 6; ++plane) {
    const double G = response.relaxed().matrix(plane, plane);
    const double share = response.force_terms()->geometric.matrix(plane, plane) / G;
    if (G > resists * response.affine().matrix(plane, plane) && std::abs(share) > std::abs(most))
      most = share;
  }
  if (std::abs(most) > matters)
    out.push_back("to first order, the contact forces themselves change a shear modulus by " + percent(most) +
                  "; the network does not include this: overlaps are large, or grains move so easily "
                  "that only the forces stabilise them");
}

} // namespace

double unbalance_by_rounding(const io::ImportedPacking& packing) {
  constexpr double contacts = 5;
  const packing::Assembly& assembly = packing.assembly;
  if (assembly.contacts.empty())
    return 0;
  return contacts *
         (packing.rounding.force + packing.rounding.length / norm(assembly.contacts.front().branch));
}

void judge_fabric(const analysis::Fabric& fabric, std::vector<std::string>& out) {
  constexpr double doubt = 0.01;
  if (fabric.density && fabric.density->chi_square.p_value < doubt)
    out.push_back("E(gamma; a) does not describe the directions of the contacts: p-value " +
                  short_text(fabric.density->chi_square.p_value, 2));
  if (fabric.axisymmetry && fabric.axisymmetry->both.p_value < doubt)
    out.push_back("the fabric is not symmetric about z, which the closed forms assume: p-value " +
                  short_text(fabric.axisymmetry->both.p_value, 2));
}

void add_warnings(const io::ImportedPacking& packing, MeasuredFrame& frame) {
  std::vector<std::string>& out = frame.warnings;
  const analysis::Measurement& measured = frame.packing;
  pass_on(packing, out);
  judge_digits(packing, out);
  judge_contacts(packing, frame, out);
  stop_point();
  judge_mistakes(packing, frame, out);
  stop_point();
  judge_boundary(packing, measured.interior.has_value(), out);
  judge_grains(packing, out);
  if (measured.fabric)
    judge_fabric(*measured.fabric, out);
  if (measured.forces)
    judge_forces(packing, *measured.forces, frame.adhesion_given, out);
  constexpr std::size_t enough = 20; // contacts
  if (measured.stress && measured.counts.contacts >= enough && !packing.has(Finding::forces_unknown))
    frame.triaxial =
        judge_stress_axes(measured.interior ? measured.interior->stress : measured.stress->symmetric,
                          measured.counts.contacts, out);
  judge_moments(measured, out);
  if (measured.law_check)
    judge_law(*measured.law_check, analysis::rounded_share(packing.assembly, packing.rounding.overlap),
              measured.law.has_value(),
              std::adjacent_find(packing.type.begin(), packing.type.end(), std::not_equal_to<>()) !=
                      packing.type.end() &&
                  !frame.materials_given,
              out);
  if (measured.network) {
    judge_network(measured.network->response.report(), out);
    judge_free_strains(*measured.network, out);
    if (measured.moments.empty()) // otherwise the moments explain the difference
      judge_force_terms(measured.network->response, out);
  }
}

} // namespace granum::studies
