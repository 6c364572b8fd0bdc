// SPDX-License-Identifier: GPL-3.0-or-later
// What the pictures of the lesson draw: two grains pressed together, a rough contact, and the motions of
// the grains of a small packing under shear.
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <granum/contact/rough_sphere.hpp>
#include <granum/core/error.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/packing/coordination.hpp>

#include "answers.hpp"
#include "experiment.hpp"

namespace {

using namespace granum;

/// How far the surfaces of both grains together move back at r >= a from the axis of their contact, for a gap
/// that grows as r^alpha: (2/pi) times the integral of d (1 - (t/a)^alpha)/sqrt(r^2 - t^2) from 0 to a.
/// Source    [Sneddon1965], with d (1 - (t/a)^alpha) for his chi(t). Accuracy  1e-9 of d.
/// Checked by web/tests/drawings.test.mjs, with the closed form for spheres
double surface_displacement(const contact::PowerLaw& law, double overlap, double radius_of_contact,
                            double r) {
  constexpr int steps = 128; // of Simpson's rule
  const double share = r / radius_of_contact, end = std::asin(1 / share), h = end / steps;
  const auto of = [&](double angle) { return 1 - std::pow(std::sin(angle) * share, law.alpha()); };
  double sum = of(0) + of(end);
  for (int k = 1; k < steps; ++k)
    sum += (k % 2 == 1 ? 4 : 2) * of(k * h);
  return 2 / std::numbers::pi * overlap * sum * h / 3;
}

} // namespace

/// Two grains of a power law pressed together: force [N], k_n [N/m] and contact radius a [m]; then, at
/// `points` equal steps of the distance r from the axis up to `half_width`, the height of the upper
/// grain's surface over the plane of the contact, unloaded and deformed [m]; the lower grain is its
/// mirror image. Flat punches have no surface beyond a: NaN there.
/// \throws   Error for a law of no single power
GRANUM_EXPORT(contact_picture)
void contact_picture(double shape, double shear_modulus, double poisson_ratio, double radius,
                     double first_number, double second_number, double overlap, double half_width,
                     double points) {
  const contact::NormalLaw law =
      web::law_of({shape, shear_modulus, poisson_ratio, radius, first_number, second_number});
  const contact::PowerLaw* const power = law.power_law();
  if (power == nullptr)
    throw Error("surfaces are drawn for contacts of one power alone");
  const double a = power->contact_radius(overlap);
  web::numbers() = {power->force(overlap), power->stiffness_at_overlap(overlap), a};
  const bool flat = std::isinf(power->alpha());
  for (double k = 0; k <= points; ++k) {
    const double r = half_width * (k / points);
    const double profile = flat ? 0 : power->profile_constant() * std::pow(r, power->alpha());
    const double unloaded = profile - overlap / 2;
    const double deformed = r <= a ? 0 : unloaded + surface_displacement(*power, overlap, a, r) / 2;
    const bool outside = flat && r > a;
    web::numbers().insert(web::numbers().end(),
                          {outside ? web::nothing : unloaded, outside ? web::nothing : deformed});
  }
}

/// A contact of rough spheres at a force [N]: k_n [N/m], its exponent, the share of a further approach
/// that the roughness takes up, u0 k_n/f; and of the smooth spheres below the roughness the overlap and
/// the contact radius [m].
/// \throws   Error for another law
GRANUM_EXPORT(rough_contact)
void rough_contact(double shape, double shear_modulus, double poisson_ratio, double radius, double roughness,
                   double second_number, double force) {
  if (web::shape_of(shape) != contact::Shape::rough)
    throw Error("only rough spheres have a roughness");
  const contact::NormalLaw law =
      web::law_of({shape, shear_modulus, poisson_ratio, radius, roughness, second_number});
  const contact::PowerLaw smooth =
      contact::PowerLaw::sphere({.shear_modulus = shear_modulus, .poisson_ratio = poisson_ratio}, radius);
  const double k = law.stiffness_at_force(force), overlap = smooth.overlap(force);
  web::numbers() = {k, law.exponent_at_force(force), roughness * k / force, overlap,
                    smooth.contact_radius(overlap)};
}

/// The motions of the compressed specimen's grains in a shear that shortens the vertical axis 3 as much
/// as it stretches axis 1, for a unit of each: the modulus (C11 + C33 - 2 C13)/4 by uniform strain and
/// relaxed [Pa]; z*, C_n, edges of the cell over the mean radius; numbers of grains and contacts. Of each
/// grain centre and radius, displacement beside that of the mean strain and turn (radius times rotation),
/// all over the mean radius, and the number of its contacts in the network, 0 for a rattler. Of each
/// contact between grains that carry load: both grains, branch over the mean radius, k_n and k_t over the
/// mean k_n. The mean strain moves a grain at x by (x_1, 0, -x_3).
/// \throws   Error before a compression
GRANUM_EXPORT(experiment_motions) void experiment_motions() {
  const web::Experiment& e = web::experiment();
  if (!(e.pressure > 0))
    throw Error("grains move in a network after a compression only");
  const packing::Assembly packing = dem::contact_network(e.state, e.recipe.material);
  const network::Response response = network::linear_response(packing, {.motions = true});
  const auto modulus = [](const elastic::VoigtStiffness& C) {
    return (C.matrix(0, 0) + C.matrix(2, 2) - 2 * C.matrix(0, 2)) / 4;
  };
  const packing::MechanicalCoordination mechanical =
      packing::mechanical_coordination(packing, packing::ContactKind::frictional);
  const double unit = e.recipe.radius;
  std::vector<double>& row = web::numbers();
  const std::size_t grains = packing.grain_count();
  std::vector<int> contacts_of(grains, 0);
  std::vector<packing::Contact> kept;
  double stiffness = 0;
  for (const packing::Contact& contact : packing.contacts) {
    if (mechanical.rattler[contact.i] || mechanical.rattler[contact.j] || !(contact.normal_force > 0))
      continue;
    ++contacts_of[contact.i];
    ++contacts_of[contact.j];
    stiffness += contact.normal_stiffness;
    kept.push_back(contact);
  }
  row = {modulus(response.affine()),      modulus(response.relaxed()),
         mechanical.coordination_number,  packing::coordination_number(packing),
         packing.cell(0, 0) / unit,       packing.cell(1, 1) / unit,
         packing.cell(2, 2) / unit,       static_cast<double>(grains),
         static_cast<double>(kept.size())};
  const auto add = [&row](const Vec3& of, double scale) {
    for (int axis = 0; axis < 3; ++axis)
      row.push_back(of[axis] / scale);
  };
  const network::StrainMotions& motions = response.motions();
  for (std::size_t g = 0; g < grains; ++g) {
    add(packing.position[g], unit);
    row.push_back(packing.radius[g] / unit);
    const network::GrainMotion &vertical = motions[2][g], &horizontal = motions[0][g];
    // StrainMotions belong to x moving by strain times x, which stretches.
    add(horizontal.displacement - vertical.displacement, unit);
    add(horizontal.turn - vertical.turn, unit);
    row.push_back(contacts_of[g]);
  }
  for (const packing::Contact& contact : kept) {
    row.insert(row.end(), {static_cast<double>(contact.i), static_cast<double>(contact.j)});
    add(contact.branch, unit);
    const double mean = stiffness / static_cast<double>(kept.size());
    row.insert(row.end(), {contact.normal_stiffness / mean, contact.tangential_stiffness / mean});
  }
}
