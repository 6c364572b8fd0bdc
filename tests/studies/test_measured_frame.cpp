// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/measured_frame.hpp"

#include "studies/analyse/frame_series.hpp"
#include <granum/dem/engine.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/packing/assembly.hpp>
#include <granum/packing/coordination.hpp>

#include "read_specimen.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

using namespace granum::studies;
using namespace granum::samples;

namespace {

const analysis::Given known{.grain_shear_modulus = specimen_grain.shear_modulus,
                            .friction_coefficient = specimen_friction};

/// What went through a file is what granum has itself. The network is solved to 1e-10 both times.
void check_same(const analysis::Measurement& measured, const packing::Assembly& own) {
  CHECK(measured.counts.grains == own.grain_count());
  CHECK(measured.counts.contacts == own.contacts.size());
  CHECK(measured.counts.coordination_number == coordination_number(own));
  const packing::MechanicalCoordination mechanical =
      mechanical_coordination(own, packing::ContactKind::frictional);
  CHECK(measured.counts.mechanical.rattler_count == mechanical.rattler_count);
  CHECK(measured.counts.mechanical.coordination_number == mechanical.coordination_number);
  CHECK(measured.void_ratio == relative(void_ratio(own), 1e-14));
  const packing::ContactStress stress = contact_stress(own);
  REQUIRE(measured.stress);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) // relative to the mean: the tangential parts are far smaller
      CHECK(std::abs(measured.stress->tensor(i, j) - stress.tensor(i, j)) < 1e-12 * stress.mean());
  const network::Response response = network::linear_response(own);
  REQUIRE(measured.network);
  CHECK(measured.network->response.converged());
  CHECK((measured.network->response.relaxed().matrix - response.relaxed().matrix).norm() <
        1e-8 * response.relaxed().matrix.norm());
  CHECK((measured.network->response.affine().matrix - response.affine().matrix).norm() <
        1e-8 * response.affine().matrix.norm());
}

/// Whether one of them has this number or option.
bool one_has(const std::vector<std::string>& notes, const std::string& part) {
  return std::ranges::any_of(notes, [&](const std::string& n) { return n.find(part) != std::string::npos; });
}

} // namespace

TEST_CASE("frame: granum's own specimen through CSV and through a dump is the specimen") {
  const packing::Assembly& own = specimen();
  check_same(measure_frame(through_csv(own), known).packing, own);
  check_same(measure_frame(through_dump(own), known).packing, own);
}

TEST_CASE("frame: a packing between walls has the engine's stress") {
  triaxial::SpecimenRecipe recipe = specimen_recipe(50e3, 60);
  recipe.wall_friction = 0.3;
  const dem::Specimen state = states_at({50e3}, recipe).front();
  const packing::Assembly own = dem::contact_network(state, recipe.material);
  REQUIRE(own.wall_contacts.size() > 20);
  // The state was frozen with contacts that stick; those at the Coulomb limit would slip by a rounding.
  dem::Specimen sticking = state;
  dem::Material material = recipe.material;
  sticking.walls->friction_coefficient = material.friction_coefficient =
      std::numeric_limits<double>::infinity();
  const Mat3 engine = dem::Engine(sticking, material).figures().stress;
  io::ImportedPacking packing = through_mercury(own);
  const analysis::Measurement a = measure_frame(packing, known).packing;
  check_same(a, own);
  for (int k = 0; k < 3; ++k) // sums in another order
    CHECK(a.stress->tensor(k, k) == relative(engine(k, k), 1e-11));
  CHECK(a.counts.wall_contacts == own.wall_contacts.size());
  CHECK(a.counts.coordination_number_with_walls ==
        relative(double(2 * own.contacts.size() + own.wall_contacts.size()) / 60, 1e-14));
  CHECK(a.forces->unbalance.value().force_ratio < 1e-6); // walls hold their grains
  // Without the walls a good part of the stress is missing.
  packing.assembly.wall_contacts.clear();
  CHECK(measure_frame(packing, known).packing.stress->mean() < 0.9 * trace(engine) / 3);
}

TEST_CASE("frame: G_g comes out of the forces where it is not given, options that cannot be are refused") {
  const analysis::Measurement found = measure_frame(through_dump(specimen())).packing;
  REQUIRE(found.grain);
  CHECK(found.grain->shear_modulus == relative(specimen_grain.shear_modulus, 1e-10));
  const analysis::Measurement given = measure_frame(through_dump(specimen()), known).packing;
  REQUIRE((found.state && given.state));
  CHECK(effective::uniform_strain(*found.state).stiffness.C44 ==
        relative(effective::uniform_strain(*given.state).stiffness.C44, 1e-10));
  REQUIRE(given.law_check);
  CHECK(given.law_check->coefficient_ratio.value() == relative(1, 1e-10));
  REQUIRE(given.law_check->alpha);
  // overlaps are differences of lengths 1e5 times as large
  CHECK(given.law_check->alpha->value == relative(2, 1e-8));
  const io::ImportedPacking packing = through_csv(specimen());
  using analysis::Given;
  for (const Given& bad : {Given{.grain_shear_modulus = -1}, Given{.grain_poisson_ratio = 0.7},
                           Given{.friction_coefficient = -0.1}, Given{.tangential_ratio = -0.1}})
    CHECK_THROWS_AS((void)measure_frame(packing, bad), InvalidArgument);
  CHECK_THROWS_AS((void)measure_frame(packing, {}, {.rose_bins = 0}), InvalidArgument);
}

TEST_CASE("frame: without contacts, or without forces, the rest is still there") {
  const packing::Assembly& own = specimen();
  io::ImportedPacking packing = through_csv(own);
  packing.notes.push_back({io::Finding::forces_unknown, ""});
  const analysis::Measurement geometry = measure_frame(packing, known).packing;
  CHECK(geometry.counts.coordination_number == coordination_number(own));
  REQUIRE(geometry.fabric);
  CHECK_FALSE((geometry.forces || geometry.stress || geometry.state));
  REQUIRE(geometry.network); // k_n from the overlaps
  const elastic::Matrix6 expected = network::linear_response(own).relaxed().matrix;
  CHECK((geometry.network->response.relaxed().matrix - expected).norm() < 1e-8 * expected.norm());
  packing.assembly.contacts.clear();
  const analysis::Measurement data = measure_frame(packing).packing;
  CHECK(data.counts.without_contact == own.grain_count());
  CHECK_FALSE((data.fabric || data.forces || data.stress || data.state || data.network));
}

TEST_CASE("frame: a table with only contacts gives fabric and forces") {
  io::ContactTable table;
  table.normal = fabric::sample_normals(0.3, 20000, 1);
  CHECK(measure_frame(table).warnings.empty());
  analysis::Measurement a = measure_frame(table).packing;
  REQUIRE(a.fabric);
  CHECK(std::abs(a.fabric->by_moment.anisotropy - 0.3) < 4 * a.fabric->by_moment.standard_error);
  CHECK(std::abs(a.fabric->by_likelihood->anisotropy - 0.3) < 4 * a.fabric->by_likelihood->standard_error);
  CHECK(a.fabric->isotropy->p_value < 1e-6);
  CHECK(a.fabric->density->chi_square.p_value > 0.001);
  CHECK(a.fabric->rose.size() == 18);
  for (const std::size_t contacts : {1U, 2U}) { // as few as have a fabric
    io::ContactTable few;
    few.normal.assign(table.normal.begin(), table.normal.begin() + static_cast<std::ptrdiff_t>(contacts));
    CHECK(measure_frame(few).packing.fabric.has_value() == (contacts == 2));
  }
  CHECK_FALSE(a.forces);
  for (std::size_t k = 0; k < table.normal.size(); ++k) {
    table.normal_force.push_back(k % 2 == 0 ? 1.0 : 3.0);
    table.tangential_size.push_back(0.5);
    table.force.push_back(2 * table.normal[k]);
  }
  io::ContactTable whole = table;
  whole.normal_force.clear();
  whole.tangential_size.clear();
  CHECK(measure_frame(whole).packing.forces->distribution.largest == relative(2, 1e-15));
  table.force.clear();
  a = measure_frame(table).packing;
  REQUIRE(a.forces);
  CHECK(a.forces->distribution.mean == relative(2, 1e-14));
  CHECK(a.forces->Z_2 == relative(5.0 / 4, 1e-14));
  CHECK(a.forces->mean_tangential_over_normal.value() == relative(0.25, 1e-12)); // a sum of 20,000 roots
}

TEST_CASE("frame: contact means and the equivalent radius are those of the grains that touch") {
  io::ImportedPacking packing = through_csv(specimen());
  for (std::size_t g = 0; g < packing.assembly.radius.size(); g += 2)
    packing.assembly.radius[g] *= 0.8;
  const analysis::Measurement a = measure_frame(packing, {}, {}).packing;
  const double r = specimen_radius;
  CHECK(a.sizes.smallest == 0.8 * r);
  CHECK(a.sizes.largest == r);
  CHECK(a.sizes.equivalent == relative(r * (1 + 0.8 * 0.8 * 0.8) / (1 + 0.8 * 0.8), 1e-12));
  std::vector<sizes::TouchingPair> pairs;
  double squares = 0;
  for (const packing::Contact& c : packing.assembly.contacts) {
    pairs.push_back({packing.assembly.radius[c.i], packing.assembly.radius[c.j]});
    squares += std::pow(pairs.back().radius_i + pairs.back().radius_j, 2);
  }
  CHECK(a.sizes.contacts == sizes::counted_contact_means(packing.assembly.radius, pairs, a.sizes.equivalent));
  CHECK(a.sizes.gradation.d50 == 2 * r);
  REQUIRE(a.state);
  CHECK(a.state->contacts == a.sizes.contacts);
  // The prefactor is N_c <l^2>/V, whatever radius the means refer to.
  CHECK(effective::prefactor(*a.state) == relative(squares / a.volume, 1e-12));
}

namespace {

const analysis::ClosedForm& relaxed_form(const analysis::Measurement& m) {
  return *std::find_if(m.closed_forms.begin(), m.closed_forms.end(), [](const analysis::ClosedForm& form) {
    return form.rung->name == effective::RungName::relaxed;
  });
}

/// Two grains of a periodic chain along x, on which the contacts leave no force, but moments.
io::ImportedPacking turned_chain() {
  io::ImportedPacking p;
  p.id = {1, 2};
  p.assembly = {.cell = Mat3::diagonal(2, 2, 2),
                .position = {{0.5, 1, 1}, {1.5, 1, 1}},
                .radius = {0.5001, 0.5001},
                .contacts = {}};
  for (const double side : {-1.0, 1.0})
    p.assembly.contacts.push_back({.i = 0,
                                   .j = 1,
                                   .branch = {side, 0, 0},
                                   .overlap = 2e-4,
                                   .normal_force = 1,
                                   .tangential_force = {0, 0.2 * side, 0}});
  return p;
}

} // namespace

TEST_CASE("frame: moments that are left are named, and rung 3 is withheld, packings without them are not") {
  const MeasuredFrame frame = measure_frame(turned_chain(), known);
  REQUIRE((frame.packing.forces && frame.packing.forces->unbalance));
  CHECK(frame.packing.forces->unbalance->force_ratio < 1e-15);
  CHECK(frame.packing.forces->unbalance->moment_ratio > 0.3);
  CHECK_FALSE(frame.packing.moments.empty());
  CHECK(one_has(frame.warnings, "--rolling-stiffness"));
  const analysis::Measurement sound = measure_frame(through_dump(specimen()), known).packing;
  CHECK(sound.moments.empty());
  CHECK(relaxed_form(sound).answer);
}

TEST_CASE("frame: contacts that resist rolling make network and rung 3 stiffer by the same") {
  using Of = packing::TurningSpring::Of;
  const auto with = [](double value, Of of) {
    analysis::Given rolling = known;
    rolling.rolling = packing::TurningSpring{.value = value, .of = of};
    return rolling;
  };
  const analysis::Measurement sound = measure_frame(through_dump(specimen()), known).packing;
  const MeasuredFrame frame = measure_frame(through_dump(specimen()), with(0.2, Of::normal));
  CHECK_FALSE(one_has(frame.warnings, "--rolling-stiffness")); // it is known
  REQUIRE(relaxed_form(frame.packing).answer);
  CHECK(frame.packing.state->rolling == relative(0.2, 1e-14));
  CHECK(one_has(frame.packing.notes, "0.2 k_n"));
  const auto check_gains = [&](const analysis::Measurement& m, double tolerance) {
    const double of_network =
        m.network->isotropic_relaxed().shear_modulus() / sound.network->isotropic_relaxed().shear_modulus();
    CHECK(relaxed_form(m).answer->stiffness.G_vh() / relaxed_form(sound).answer->stiffness.G_vh() ==
          relative(of_network, tolerance));
    return of_network;
  };
  CHECK(check_gains(frame.packing, 0.05) > 1.05);
  CHECK(relaxed_form(frame.packing).answer->relative_error->G_vh > 0.02);
  CHECK(frame.packing.network->isotropic_affine().shear_modulus() ==
        relative(sound.network->isotropic_affine().shear_modulus(), 1e-12));
  // Springs of one stiffness on contacts of many: their mean.
  check_gains(measure_frame(through_dump(specimen()), with(1e-3, Of::angle)).packing, 0.06);
  // Rung 3 is not evaluated beyond its fit, where twisting is resisted too, and of bonds.
  const auto answered = [](const analysis::Given& given, double first_force = 1) {
    io::ImportedPacking p = through_dump(specimen());
    p.assembly.contacts[3].normal_force *= first_force;
    const analysis::Measurement m = measure_frame(p, given).packing;
    CHECK(relaxed_form(m).answer.has_value() == relaxed_form(m).refusal.empty());
    return relaxed_form(m).answer.has_value();
  };
  CHECK(answered(with(1, Of::normal)));
  CHECK_FALSE(answered(with(1.1, Of::normal)));
  CHECK_FALSE(answered(with(0.2, Of::normal), -1));
  analysis::Given twisting = with(0.2, Of::normal);
  twisting.twisting = twisting.rolling;
  CHECK_FALSE(answered(twisting));
}

TEST_CASE("frame: bodies count in place of grains") {
  io::ImportedPacking p = through_dump(specimen());
  const packing::Contact joined = p.assembly.contacts.front();
  std::uint32_t bodies = 0;
  for (std::uint32_t g = 0; g < p.assembly.grain_count(); ++g)
    p.assembly.body.push_back(g == joined.j ? p.assembly.body[joined.i] : bodies++);
  const analysis::Measurement m = measure_frame(p, known).packing;
  CHECK(m.counts.grains == p.assembly.grain_count());
  CHECK(m.counts.bodies == bodies);
  CHECK(m.counts.coordination_number ==
        relative(2.0 * (static_cast<double>(p.assembly.contacts.size()) - 1) / bodies, 1e-14));
  CHECK_FALSE(m.closed_forms.empty());
  for (const analysis::ClosedForm& form : m.closed_forms) {
    CAPTURE(form.rung->key);
    CHECK_FALSE(form.answer);
    CHECK_FALSE(form.refusal.empty());
  }
  CHECK(m.network->response.converged());
}
