// SPDX-License-Identifier: GPL-3.0-or-later
// The page's experiment: one specimen, made and then compressed from pressure to pressure, measured at rest.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/contact/grains.hpp>
#include <granum/core/numerics.hpp>
#include <granum/fabric/estimates.hpp>
#include <granum/fabric/orientation.hpp>

#include "experiment.hpp"
#include "studies/verify/seed_mean.hpp"

namespace {

using namespace granum;
using web::Clock;
using web::Experiment;
using web::View;

std::unique_ptr<Experiment> running;

/// The directions of the contacts with f_n > 0.
void look_at_fabric(const packing::Assembly& packing, View& view) {
  constexpr std::size_t bins = 18, fewest = 20;
  std::vector<Vec3> normals;
  for (const packing::Contact& contact : packing.contacts)
    if (contact.normal_force > 0)
      normals.push_back(packing::normal(contact));
  view.rose.clear();
  if (normals.size() < fewest)
    return;
  const double a = std::clamp(fabric::estimate_anisotropy(normals).anisotropy, -1.0, 1.0);
  view.rose.push_back(static_cast<float>(a));
  std::vector<std::size_t> counts;
  for (const fabric::RoseBin& bin : fabric::rose(normals, a, bins))
    counts.push_back(bin.count);
  for (const fabric::RoseBin& bin : fabric::readable_rose(counts, a))
    view.rose.push_back(static_cast<float>(bin.density / fabric::density(0, 0)));
}

void look_at(const packing::Assembly& packing, double unit, View& view) {
  look_at_fabric(packing, view);
  const packing::MechanicalCoordination mechanical =
      packing::mechanical_coordination(packing, packing::ContactKind::frictional);
  view.grains.clear();
  const auto add = [unit](std::vector<float>& to, const Vec3& at) {
    for (int axis = 0; axis < 3; ++axis)
      to.push_back(static_cast<float>(at[axis] / unit));
  };
  for (std::size_t g = 0; g < packing.grain_count(); ++g) {
    add(view.grains, packing.position[g]);
    view.grains.push_back(static_cast<float>(packing.radius[g] / unit));
    view.grains.push_back(mechanical.rattler[g] ? 1.0f : 0.0f);
  }
  double mean = 0;
  for (const packing::Contact& contact : packing.contacts)
    mean += contact.normal_force / static_cast<double>(packing.contacts.size());
  view.contacts.clear();
  for (const packing::Contact& contact : packing.contacts) {
    if (!(contact.normal_force > 0))
      continue;
    add(view.contacts, packing.position[contact.i]);
    add(view.contacts, packing.position[contact.i] + contact.branch);
    view.contacts.push_back(static_cast<float>(contact.normal_force / mean));
  }
  for (int axis = 0; axis < 3; ++axis)
    view.edge[axis] = static_cast<float>(packing.cell(axis, axis) / unit);
}

/// ln G against ln p; empty before the second pressure.
std::optional<StraightLine> line_of(const Experiment& e, const std::vector<double>& ln_modulus) {
  if (e.ln_pressure.size() < 2)
    return std::nullopt;
  std::vector<Point> points;
  for (std::size_t k = 0; k < e.ln_pressure.size(); ++k)
    points.push_back({e.ln_pressure[k], ln_modulus[k]});
  return straight_line(points);
}

/// s of the network and its error; NaN before the second pressure. The scatter between specimens cannot be
/// derived from one path, and exceeds its own error if the specimen is loose: it was measured between 10 and
/// 100 kPa, with equal grains and the initial friction of the page.
Measured exponent(const Experiment& e, const std::optional<StraightLine>& line) {
  if (!line)
    return {effective::State::unset, effective::State::unset};
  const studies::TableValue s = *studies::mean_over_seeds(
      {{line->slope.value, line->slope.standard_error}},
      studies::exponent_scatter(e.contact, e.density, studies::ExponentRoute::network, e.recipe.grains));
  return {s.value, *s.standard_error};
}

/// G and K of a closed form; NaN if it has none.
std::array<double, 2> closed_form(const analysis::Measurement& found, effective::RungName name) {
  const std::optional<effective::RungAnswer> answer = found.closed_form(name);
  if (!answer)
    return {effective::State::unset, effective::State::unset};
  return {answer->stiffness.G_vh(), answer->stiffness.bulk_modulus()};
}

} // namespace

namespace granum::web {

Experiment& experiment() {
  if (!running)
    throw Error("the experiment has not begun");
  return *running;
}

void draw(Experiment& e, const dem::Specimen& state) {
  look_at(dem::contact_network(state, e.recipe.material), e.recipe.radius, e.view);
  page_frame();
}

} // namespace granum::web

using web::draw;
using web::experiment;

/// A new experiment; replaces the last one. Sigma is that of lognormal sizes, 0 for equal grains. The random
/// numbers follow from the seed.
GRANUM_EXPORT(experiment_begin)
void experiment_begin(double shape, double shear_modulus, double poisson_ratio, double radius,
                      double first_number, double second_number, double friction_angle, double loose,
                      double sigma, double grains, double seed, double first_pressure) {
  running = std::make_unique<Experiment>(
      Experiment{.contact = web::shape_of(shape),
                 .recipe = {.material = {.law = web::law_of({shape, shear_modulus, poisson_ratio, radius,
                                                             first_number, second_number}),
                                         .tangential_ratio = contact::mindlin_stiffness_ratio(poisson_ratio),
                                         .friction_coefficient =
                                             contact::Friction::from_angle(friction_angle).coefficient()},
                            .radius = radius,
                            .sizes = sizes::Distribution::lognormal(sigma),
                            .grains = static_cast<std::size_t>(grains),
                            .seed = static_cast<std::uint64_t>(seed),
                            .first_pressure = first_pressure},
                 .density = loose != 0 ? triaxial::Density::loose : triaxial::Density::dense});
  triaxial::require_valid(running->recipe);
}

/// Makes the specimen: at rest without friction at the first pressure; a loose one is then opened.
GRANUM_EXPORT(experiment_prepare) void experiment_prepare() {
  Experiment& e = experiment();
  Clock clock;
  const auto tell = [&clock] { return clock.tick([] { page_frame(); }); };
  const triaxial::FrictionlessPacking made = triaxial::frictionless_specimen(e.recipe, tell);
  e.state = triaxial::start_of_compression(made.state, e.density, e.recipe, tell);
  draw(e, e.state);
}

/// Compresses to a pressure [Pa] and measures: pressure, e, C_n, z*, x_0, mean overlap over the mean
/// diameter; K, G and the affine G of the network, G by uniform strain and relaxed (closed forms); s of the
/// network over all pressures so far, and its error; K by uniform strain and relaxed; G of the network on the
/// line of s at the first pressure and at this one; s of rung 3 with the counted contacts; 1 if the specimen
/// came to rest; the stiffness of a contact relative to the first pressure, if its force is proportional to
/// the pressure, and the exponent of this ratio, NaN at the first pressure.
GRANUM_EXPORT(experiment_compress) void experiment_compress(double pressure) {
  Experiment& e = experiment();
  Clock clock;
  dem::Engine engine(e.state, e.recipe.material);
  dem::QuasistaticOptions options = triaxial::compression_options();
  options.stop_requested = [&] { return clock.tick([&] { draw(e, engine.state()); }); };
  const dem::QuasistaticReport report = dem::equilibrate(engine, {pressure, pressure, pressure}, options);
  engine.rest();
  e.state = engine.state();
  e.pressure = pressure;
  e.shear.reset();
  draw(e, e.state);

  const packing::Assembly packing = dem::contact_network(e.state, e.recipe.material);
  const analysis::Measurement found = analysis::measure(
      packing, {.law = e.recipe.material.law, .tangential_ratio = e.recipe.material.tangential_ratio},
      {.closed_forms = true, .network = network::ResponseOptions{}});
  const analysis::Network& network = found.solved_network();
  const elastic::Isotropic relaxed = network.isotropic_relaxed();
  double overlap = 0, force = 0;
  for (const packing::Contact& contact : packing.contacts) {
    overlap += contact.overlap / static_cast<double>(packing.contacts.size());
    force += contact.normal_force / static_cast<double>(packing.contacts.size());
  }
  if (e.ln_pressure.empty())
    e.first_force = force;
  const auto [uniform_shear, uniform_bulk] = closed_form(found, effective::RungName::isotropic);
  const auto [relaxed_shear, relaxed_bulk] = closed_form(found, effective::RungName::relaxed);
  e.ln_pressure.push_back(std::log(pressure));
  e.ln_network.push_back(std::log(relaxed.shear_modulus()));
  e.ln_relaxed.push_back(std::log(relaxed_shear));
  constexpr double none = effective::State::unset;
  const std::optional<StraightLine> line = line_of(e, e.ln_network);
  const std::optional<StraightLine> rung =
      std::isnan(relaxed_shear) ? std::nullopt : line_of(e, e.ln_relaxed);
  const Measured s = exponent(e, line);
  const contact::NormalLaw& law = e.recipe.material.law;
  const double times = std::exp(e.ln_pressure.back() - e.ln_pressure.front());
  const double alone = law.stiffness_at_force(times * e.first_force) / law.stiffness_at_force(e.first_force);
  web::numbers() = {pressure,
                    found.void_ratio,
                    found.counts.coordination_number,
                    found.counts.mechanical.coordination_number,
                    found.counts.mechanical.rattler_fraction,
                    overlap / (2 * e.recipe.radius),
                    relaxed.bulk_modulus(),
                    relaxed.shear_modulus(),
                    network.isotropic_affine().shear_modulus(),
                    uniform_shear,
                    relaxed_shear,
                    s.value,
                    s.standard_error,
                    uniform_bulk,
                    relaxed_bulk,
                    line ? std::exp((*line)(e.ln_pressure.front())) : none,
                    line ? std::exp((*line)(e.ln_pressure.back())) : none,
                    rung ? rung->slope.value : none,
                    report.converged() ? 1.0 : 0.0,
                    alone,
                    std::log(alone) / (e.ln_pressure.back() - e.ln_pressure.front())};
}

/// The standard deviation of s of the network between specimens of a kind, and its mean; NaN for a
/// contact that was not measured.
GRANUM_EXPORT(exponent_scatter) void exponent_scatter(double shape, double loose, double grains) {
  const studies::KnownScatter known = studies::exponent_scatter(
      web::shape_of(shape), loose != 0 ? triaxial::Density::loose : triaxial::Density::dense,
      studies::ExponentRoute::network, static_cast<std::size_t>(grains));
  web::numbers() = {known.deviation, known.mean.value_or(effective::State::unset)};
}

GRANUM_EXPORT(view_grains) const float* view_grains() { return experiment().view.grains.data(); }
GRANUM_EXPORT(view_grain_count) std::size_t view_grain_count() { return experiment().view.grains.size() / 5; }
GRANUM_EXPORT(view_contacts) const float* view_contacts() { return experiment().view.contacts.data(); }
GRANUM_EXPORT(view_contact_count) std::size_t view_contact_count() {
  return experiment().view.contacts.size() / 7;
}
GRANUM_EXPORT(view_edge) const float* view_edge() { return experiment().view.edge; }
GRANUM_EXPORT(view_rose) const float* view_rose() { return experiment().view.rose.data(); }
GRANUM_EXPORT(view_rose_count) std::size_t view_rose_count() { return experiment().view.rose.size(); }
