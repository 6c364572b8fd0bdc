// SPDX-License-Identifier: GPL-3.0-or-later
// Contact law, fabric and closed forms for the page.
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/sands/pooled_law.hpp>

#include "exports.hpp"

namespace {

using namespace granum;

/// Empty for NaN.
std::optional<double> given(double number) {
  return std::isnan(number) ? std::nullopt : std::optional<double>(number);
}

/// K, G_hh, G_vh, s of G_vh and the relative error of G_vh, or NaN.
void add_answer(const effective::RungName name, const effective::State& packing, Validity& validity) {
  constexpr double none = effective::State::unset;
  std::vector<double>& row = web::numbers();
  const effective::Rung& rung = effective::rung(name);
  if (!effective::has_inputs(packing, rung)) {
    row.insert(row.end(), 5, none);
    return;
  }
  const effective::RungAnswer answer = effective::answer_with_exponents(rung, packing);
  validity.merge(answer.validity);
  row.push_back(answer.stiffness.bulk_modulus());
  row.push_back(answer.stiffness.G_hh());
  row.push_back(answer.stiffness.G_vh());
  row.push_back(answer.exponents ? answer.exponents->sum() : none);
  row.push_back(answer.relative_error ? answer.relative_error->G_vh : none);
}

} // namespace

/// alpha, the stiffness exponent at the largest overlap, k_t/k_n; then overlap, force, k_n and contact radius
/// at `points` equal steps of the overlap. NaN for properties of the power family only.
GRANUM_EXPORT(contact_curve)
void contact_curve(double shape, double shear_modulus, double poisson_ratio, double radius,
                   double first_number, double second_number, double largest_overlap, double points) {
  const contact::NormalLaw law =
      web::law_of({shape, shear_modulus, poisson_ratio, radius, first_number, second_number});
  std::vector<double>& row = web::numbers();
  const contact::PowerLaw* const power = law.power_law();
  constexpr double none = effective::State::unset;
  row = {power != nullptr ? power->alpha() : none, law.exponent_at_force(law.force(largest_overlap)),
         contact::mindlin_stiffness_ratio(poisson_ratio)};
  for (double k = 1; k <= points; ++k) {
    const double overlap = largest_overlap * (k / points);
    row.insert(row.end(), {overlap, law.force(overlap), law.stiffness_at_overlap(overlap),
                           power != nullptr ? power->contact_radius(overlap) : none});
  }
}

/// The numbers of a law whose contact is as stiff as that of spheres at a force [N]: its last number is
/// determined, the one before is constant. Rough spheres are softer at any roughness: they are unchanged.
/// \throws   Error if the law has no number of its own
GRANUM_EXPORT(law_as_stiff)
void law_as_stiff(double shape, double shear_modulus, double poisson_ratio, double radius,
                  double first_number, double second_number, double force) {
  const contact::LawRow& law = contact::row_of(web::shape_of(shape));
  if (law.parameters.empty())
    throw Error("this law has no number of its own");
  const bool two = law.parameters.size() > 1;
  const auto stiffness = [&](double number) {
    return web::law_of({shape, shear_modulus, poisson_ratio, radius, two ? first_number : number, number})
        .stiffness_at_force(force);
  };
  const double wanted =
      contact::NormalLaw(
          contact::PowerLaw::sphere({.shear_modulus = shear_modulus, .poisson_ratio = poisson_ratio}, radius))
          .stiffness_at_force(force);
  const double start = two ? second_number : first_number;
  double low = std::log(start * 1e-3), high = std::log(start * 1e3);
  const bool grows = stiffness(std::exp(high)) > stiffness(std::exp(low));
  if ((stiffness(std::exp(low)) - wanted) * (stiffness(std::exp(high)) - wanted) > 0) {
    web::numbers() = two ? std::vector{first_number, second_number} : std::vector{first_number};
    return;
  }
  constexpr int halvings = 60;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    ((stiffness(std::exp(middle)) > wanted) == grows ? high : low) = middle;
  }
  const double found = std::exp((low + high) / 2);
  web::numbers() = two ? std::vector{first_number, found} : std::vector{found};
}

/// The exponents s of G ~ p^s measured on sands, from uniform ones to the widest tested gradings.
GRANUM_EXPORT(sand_exponents) void sand_exponents() {
  for (const double uniformity : {1.0, sands::largest_tested_uniformity})
    web::numbers().push_back(sands::growth_exponent({.uniformity = uniformity}, 1e5).value);
}

/// E(gamma; a) over E(gamma; 0) at `points` equal steps of gamma from 0 to 90 degrees.
GRANUM_EXPORT(fabric_curve) void fabric_curve(double anisotropy, double points) {
  std::vector<double>& row = web::numbers();
  for (double k = 0; k <= points; ++k)
    row.push_back(fabric::density(std::numbers::pi / 2 * (k / points), anisotropy) / fabric::density(0, 0));
}

/// The relaxation factors h of G and of K at z*, k_t/k_n and stiffness exponent, with their relative errors.
GRANUM_EXPORT(relaxation)
void relaxation(double mechanical_coordination_number, double tangential_ratio, double stiffness_exponent) {
  const effective::Relaxation h =
      effective::relaxation(mechanical_coordination_number, tangential_ratio, stiffness_exponent);
  web::numbers() = {h.shear.value, h.shear.relative_error, h.bulk.value, h.bulk.relative_error};
  web::say(h.validity);
}

/// K, G_hh, G_vh, s and error by uniform strain (rung 2), by uniform stress, and relaxed (rung 3); then the
/// mean contact force, and the transition pressure of rough contacts, NaN for others. NaN for the mechanical
/// coordination number means not given.
GRANUM_EXPORT(closed_forms)
void closed_forms(double shape, double shear_modulus, double poisson_ratio, double radius,
                  double first_number, double second_number, double void_ratio, double coordination_number,
                  double anisotropy, double stress_v, double stress_h,
                  double mechanical_coordination_number) {
  const effective::State packing{
      .law = web::law_of({shape, shear_modulus, poisson_ratio, radius, first_number, second_number}),
      .tangential_ratio = contact::mindlin_stiffness_ratio(poisson_ratio),
      .radius = radius,
      .void_ratio = void_ratio,
      .coordination_number = coordination_number,
      .mechanical_coordination_number = given(mechanical_coordination_number),
      .fabric_anisotropy = anisotropy,
      .stress_v = stress_v,
      .stress_h = stress_h};
  Validity validity;
  for (const effective::RungName name :
       {effective::RungName::directional, effective::RungName::uniform_stress, effective::RungName::relaxed})
    add_answer(name, packing, validity);
  web::numbers().push_back(effective::mean_contact_force(packing));
  web::numbers().push_back(effective::transition_pressure(packing).value_or(effective::State::unset));
  validity.keep_each_once();
  web::say(validity);
}

/// One packing carried from a pressure where z* and x_0 are known to another, at `points` equal steps of
/// ln p: each p, z*, x_0, e, G by uniform strain and relaxed; then s and its error of both.
GRANUM_EXPORT(carried_path)
void carried_path(double shape, double shear_modulus, double poisson_ratio, double radius,
                  double first_number, double second_number, double void_ratio,
                  double mechanical_coordination_number, double rattler_fraction, double from, double to,
                  double points) {
  effective::State known{
      .law = web::law_of({shape, shear_modulus, poisson_ratio, radius, first_number, second_number}),
      .tangential_ratio = contact::mindlin_stiffness_ratio(poisson_ratio),
      .radius = radius,
      .void_ratio = void_ratio,
      .stress_v = from,
      .stress_h = from};
  const effective::ContactCounts counts{mechanical_coordination_number, rattler_fraction};
  known.coordination_number = counts.coordination_number();
  std::vector<double>& row = web::numbers();
  std::vector<Point> uniform_strain, relaxed;
  Validity validity;
  for (double k = 0; k < points; ++k) {
    const double pressure = from * std::pow(to / from, k / (points - 1));
    const effective::CarriedContacts carried = effective::carried_contacts(known, counts, pressure);
    validity.merge(carried.validity);
    effective::State packing = known;
    packing.mechanical_coordination_number = carried.counts.mechanical_coordination_number;
    packing.void_ratio = carried.void_ratio;
    packing.coordination_number = carried.counts.coordination_number();
    packing.stress_v = packing.stress_h = pressure;
    const double stiff =
        effective::answer(effective::rung(effective::RungName::isotropic), packing).stiffness.G_vh();
    const double soft =
        effective::answer(effective::rung(effective::RungName::relaxed), packing).stiffness.G_vh();
    row.insert(row.end(), {pressure, carried.counts.mechanical_coordination_number,
                           carried.counts.rattler_fraction, carried.void_ratio, stiff, soft});
    uniform_strain.push_back({std::log(pressure), std::log(stiff)});
    relaxed.push_back({std::log(pressure), std::log(soft)});
  }
  for (const std::vector<Point>& of : {uniform_strain, relaxed}) {
    const Measured slope = straight_line(of).slope;
    row.insert(row.end(), {slope.value, slope.standard_error});
  }
  validity.keep_each_once();
  web::say(validity);
}

/// s of G ~ p^s of an isotropic packing by uniform strain (rung 0), with a constant number of contacts, at
/// `points` equal steps of ln p.
GRANUM_EXPORT(exponent_path)
void exponent_path(double shape, double shear_modulus, double poisson_ratio, double radius,
                   double first_number, double second_number, double void_ratio, double coordination_number,
                   double from, double to, double points) {
  effective::State packing{
      .law = web::law_of({shape, shear_modulus, poisson_ratio, radius, first_number, second_number}),
      .tangential_ratio = contact::mindlin_stiffness_ratio(poisson_ratio),
      .radius = radius,
      .void_ratio = void_ratio,
      .coordination_number = coordination_number};
  const effective::Rung& rung = effective::rung(effective::RungName::isotropic);
  for (double k = 0; k < points; ++k) {
    packing.stress_v = packing.stress_h = from * std::pow(to / from, k / (points - 1));
    const effective::RungAnswer answer = effective::answer_with_exponents(rung, packing);
    web::numbers().push_back(answer.exponents ? answer.exponents->sum() : effective::State::unset);
  }
}
