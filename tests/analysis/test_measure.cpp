// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/measure.hpp>

#include <granum/contact/grains.hpp>
#include <granum/core/stop.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>

#include "analysis/materials.hpp"
#include "lattices.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::analysis;
using namespace lattices;

TEST_CASE("strong and weak contacts have their own fabric") {
  // Six vertical contacts of force 3 and six horizontal ones of force 1, along x and y alike.
  packing::Assembly a{.cell = Mat3::diagonal(10, 10, 10), .position = {}, .radius = {}, .contacts = {}};
  for (std::uint32_t k = 0; k < 12; ++k) {
    const double x = 0.5 + 2 * (k % 4), y = 0.5 + 2 * (k / 4);
    Vec3 branch{};
    branch[k < 6 ? 2 : static_cast<int>(k % 2)] = 0.99;
    a.position.push_back({x, y, 1});
    a.position.push_back(Vec3{x, y, 1} + branch);
    a.radius.insert(a.radius.end(), 2, 0.5);
    a.contacts.push_back({.i = 2 * k, .j = 2 * k + 1, .branch = branch, .normal_force = k < 6 ? 3.0 : 1.0});
  }
  const Forces forces = measure_forces(a, {}, 8);
  REQUIRE((forces.strong && forces.weak));
  CHECK((forces.strong->contacts == 6 && forces.strong->F33 == 1 && forces.strong->anisotropy > 0));
  CHECK((forces.weak->contacts == 6 && forces.weak->F33 == 0 && forces.weak->anisotropy < 0));
}

TEST_CASE("counts of three spheres in a row, by hand") {
  const Measurement m = measure(row());
  CHECK(m.counts.grains == 3);
  CHECK(m.counts.contacts == 2);
  CHECK(m.counts.without_contact == 0);
  CHECK(m.counts.coordination_number == relative(4.0 / 3, 1e-15));
  CHECK(m.counts.coordination_error == relative(1.0 / 3, 1e-14)); // of 1, 2 and 1 contacts
  CHECK(m.counts.mechanical.rattler_count == 3);
  CHECK(m.sizes.smallest == R);
  CHECK(m.sizes.equivalent == R);
  CHECK(m.volume == relative(64e-9, 1e-14));
  REQUIRE(m.stress);
  CHECK(m.stress->symmetric(0, 0) == relative(4 * f_n * edge / 64e-9, 1e-13));
  REQUIRE(m.fabric);
  CHECK(m.fabric->tensor(0, 0) == relative(1, 1e-15));
  packing::Assembly four = row(); // with one that touches nothing, and two contacts with walls
  four.position.push_back({3e-3, 3e-3, 3e-3});
  four.radius.push_back(2 * R);
  four.wall_contacts = {{.i = 0, .branch = {-R, 0, 0}}, {.i = 3, .branch = {0, 0, R}}};
  const Counts counts = measure(four).counts;
  CHECK((counts.without_contact == 1 && counts.wall_contacts == 2 && counts.coordination_number == 1));
  CHECK(counts.touching_coordination_number == relative(4.0 / 3, 1e-15));
  CHECK(counts.coordination_number_with_walls == 1.5);
  CHECK(measure(four).sizes.equivalent == relative(R * (3 + 8) / (3 + 4), 1e-14));
  const StopScope scope([] { return true; });
  CHECK_THROWS_AS((void)measure(row()), Stopped);
}

TEST_CASE("a part is measured where it is wanted, and not elsewhere") {
  const packing::Assembly packing = cubic();
  const Measurement bare = measure(packing, own);
  CHECK_FALSE((bare.network || bare.forces || bare.law_check || bare.interior));
  CHECK(bare.closed_forms.empty());
  CHECK_FALSE(bare.pressure_by_work);
  CHECK_FALSE((bare.fabric->by_likelihood || bare.fabric->density));
  CHECK(bare.fabric->rose.empty());
  CHECK(bare.notes.empty());
  const Measurement full = measure(packing, own,
                                   {.fabric_tests = true,
                                    .rose_bins = 3,
                                    .force_bins = 5,
                                    .law_check = true,
                                    .work = true,
                                    .closed_forms = true,
                                    .interior_layer = R,
                                    .network = network::ResponseOptions{}});
  CHECK((full.network && full.law_check && full.interior && full.pressure_by_work));
  CHECK(full.closed_forms.size() == effective::closed_forms().size());
  CHECK(full.fabric->rose.size() == 3);
  REQUIRE(full.forces);
  CHECK(full.forces->distribution.bins.size() == 5);
  CHECK(full.forces->distribution.mean == relative(f_n, 1e-14));
}

TEST_CASE("contacts are in the interior where their middles are") {
  packing::Assembly middle = row();
  for (Vec3& x : middle.position)
    x.y = x.z = 2e-3;
  middle.contacts[0].sliding = true;
  const auto mechanical = mechanical_coordination(middle, packing::ContactKind::frictional);
  const auto sliding = [&](double layer) { // along x, contacts have theirs at about 1.5 and 2.5 mm
    return part_measures(middle, mechanical, packing::Interior(middle.cell, layer)).micro.sliding_fraction;
  };
  CHECK(sliding(1.49e-3) == 0.5);
  middle.contacts[0].branch *= 1 + 2e-9; // as well where numbers do not end evenly
  CHECK(sliding(1.49e-3) == 0.5);
}

TEST_CASE("K of rung 3 stays within the bounds of the packing, its shear moduli stay") {
  const Measurement m = measure(cubic(), own, {.closed_forms = true, .network = network::ResponseOptions{}});
  const elastic::TransverselyIsotropic formula =
      effective::relaxed(*m.state, *m.state->mechanical_coordination_number).stiffness;
  const elastic::TransverselyIsotropic kept = m.closed_form(effective::RungName::relaxed)->stiffness;
  CHECK(std::abs(formula.bulk_modulus() / (k_n / (3 * edge)) - 1) >
        0.01); // both bounds of a lattice are its K
  CHECK(kept.bulk_modulus() == relative(k_n / (3 * edge), 1e-12));
  CHECK(kept.C44 == formula.C44);
  CHECK(kept.C66() == relative(formula.C66(), 1e-12));
  // Without a network no bound is known.
  const Measurement free = measure(cubic(), own, {.closed_forms = true});
  CHECK(free.closed_form(effective::RungName::relaxed)->stiffness == formula);
  const double K = formula.bulk_modulus();
  const auto within = [&](double lower, double upper) {
    Measurement moved = m;
    moved.closed_forms = free.closed_forms;
    moved.notes.clear();
    moved.network->bulk_bounds = {.lower = lower, .upper = upper};
    keep_within_bounds(moved);
    const double found = moved.closed_form(effective::RungName::relaxed)->stiffness.bulk_modulus();
    CHECK(moved.notes.size() == (found == K ? 0 : 1));
    return found;
  };
  CHECK(within(0.9 * K, 1.1 * K) == K);
  CHECK(within(0, 0) == K); // unknown
  CHECK(within(0.8 * K, 0.9 * K) == relative(0.9 * K, 1e-12));
  CHECK(within(1.1 * K, 1.2 * K) == relative(1.1 * K, 1e-12));
  CHECK(within(0.2, 0.5) == relative(0.5, 1e-6));
  check_threshold(1e-9, [&](double above) { return within(K * (1 + above), 2 * K) == K ? 1 : 0; });
}

TEST_CASE("a cubic lattice has the stress, the bounds, the moduli and the waves of its springs") {
  Given given = own;
  given.grain_density = 2650;
  const Measurement m = measure(cubic(), given, {.network = network::ResponseOptions{}});
  const Network& network = m.solved_network();
  CHECK(m.stress->mean() == relative(f_n / (edge * edge), 1e-12));
  CHECK(network.bulk_bounds.upper == relative(k_n / (3 * edge), 1e-12));
  CHECK(network.bulk_bounds.lower == relative(k_n / (3 * edge), 1e-12)); // affine: both bounds are K
  CHECK(network.isotropic_affine().bulk_modulus() == relative(k_n / (3 * edge), 1e-12));
  const elastic::Matrix6& c = network.response.relaxed().matrix;
  CHECK(network.G_hh() == c(5, 5));
  const Microstructure micro = m.microstructure();
  CHECK(micro.coordination_number == relative(6, 1e-15));
  CHECK(micro.mechanical_coordination_number == relative(6, 1e-15));
  CHECK(std::abs(micro.fabric_anisotropy) < 1e-12);
  const double density = 2650 / (1 + m.void_ratio);
  CHECK(m.bulk_density.value() == relative(density, 1e-14));
  CHECK(network.affine.stiffness.matrix == network.response.affine().matrix);
  CHECK(network.relaxed.stiffness.matrix == c);
  for (const NetworkMatrix* matrix : {&network.affine, &network.relaxed}) {
    // One spring along each axis and cell of edge^3: C11 = k_n/edge, C44 = k_t/(2 edge) once grains may spin.
    const double axial = k_n / edge, shear = k_t / (2 * edge);
    CHECK(matrix->moduli.bulk_modulus == relative(axial / 3, 1e-9));
    for (const double E : {matrix->moduli.E_1, matrix->moduli.E_2, matrix->moduli.E_3})
      CHECK(E == relative(axial, 1e-9));
    for (const double C : {matrix->moduli.C44, matrix->moduli.C55, matrix->moduli.C66})
      CHECK(C == relative(shear, 1e-9));
    CHECK(matrix->symmetry.cubic < 1e-9);
    CHECK(matrix->symmetry.isotropic > 0.1); // C11 - C12 is not 2 C44
    REQUIRE(matrix->waves);
    for (const elastic::PlaneWaves& along : *matrix->waves) {
      CHECK(along.fastest.speed == relative(std::sqrt(axial / density), 1e-9));
      CHECK(along.middle.speed == relative(std::sqrt(shear / density), 1e-9));
      CHECK(along.slowest.speed == relative(std::sqrt(shear / density), 1e-9));
    }
  }
}

TEST_CASE("a lattice whose forces and stiffnesses differ by axes has them along its axes") {
  packing::Assembly packing = cubic();
  for (packing::Contact& c : packing.contacts) {
    const double times = c.branch.x != 0 ? 1 : c.branch.y != 0 ? 2 : 4;
    c.normal_force *= times;
    c.tangential_stiffness *= times;
  }
  const Measurement m =
      measure(packing, own, {.force_bins = 8, .network = network::ResponseOptions{.force_terms = false}});
  const auto stress = [](double times) { return relative(times * f_n / (edge * edge), 1e-12); };
  CHECK((m.state.value().stress_v == stress(4) && m.state->stress_h == stress(1.5)));
  // Springs of two axes in series, as grains spin: k k'/(k + k').
  const auto shear = [](double k, double other) { return k * other / (k + other) * k_t / edge; };
  CHECK(m.solved_network().G_hh() == relative(shear(1, 2), 1e-9));
  CHECK(m.network->G_vh() == relative((shear(2, 4) + shear(1, 4)) / 2, 1e-9));
  CHECK(m.network->isotropic_relaxed().shear_modulus() !=
        relative(m.network->isotropic_affine().shear_modulus(), 1e-3));
  CHECK(m.forces.value().Z_2 == relative((1 + 4 + 16) * 3 / 49.0, 1e-13));
  CHECK(m.forces->Z_5_3 ==
        relative((1 + std::pow(2, 5.0 / 3) + std::pow(4, 5.0 / 3)) / 3 * std::pow(3.0 / 7, 5.0 / 3), 1e-13));
  CHECK(m.forces->unevenness.value() == relative(force_unevenness(packing, law, R), 1e-12));
  CHECK(m.state->unevenness.value().value == m.forces->unevenness);
  for (const std::size_t count : {19U, 20U}) {
    const std::vector<Vec3> normals = contact_normals(packing);
    const Fabric fabric = measure_fabric(std::span(normals).first(count), everything());
    CHECK((fabric.density.has_value() == (count == 20) && fabric.axisymmetry.has_value() == (count == 20)));
  }
}

TEST_CASE("a matrix has waves if the density is known, and none if it is not positive semidefinite") {
  elastic::VoigtStiffness c = voigt(elastic::Isotropic::from_bulk_and_shear(3e8, 2e8));
  CHECK_FALSE(network_matrix(c).waves);
  CHECK(network_matrix(c, 1700).waves);
  CHECK(network_matrix(c).symmetry.isotropic < 1e-15);
  CHECK(network_matrix(c).symmetry.transversely_isotropic < 1e-15);
  c.matrix(3, 3) = -1e8;
  CHECK_FALSE(network_matrix(c, 1700).waves);
  CHECK(network_matrix({}, 1700).moduli.E_1 == 0);
  CHECK_THROWS_AS((void)network_matrix(c, 0), InvalidArgument);
  const Measurement unknown = measure(cubic(), own, {.network = network::ResponseOptions{}});
  CHECK_FALSE((unknown.bulk_density || unknown.network->relaxed.waves));
}

TEST_CASE("the closed forms use measured inputs, or those given by the caller") {
  const Wanted wanted{.closed_forms = true};
  const Measurement m = measure(cubic(), own, wanted);
  REQUIRE(m.state);
  CHECK(m.state->stress_v == relative(f_n / (edge * edge), 1e-12));
  CHECK(m.state->coordination_number == relative(6, 1e-15));
  CHECK(m.state->void_ratio == m.void_ratio);
  using effective::RungName;
  REQUIRE((m.closed_form(RungName::directional) && m.closed_form(RungName::relaxed)));
  CHECK(m.closed_form(RungName::directional)->stiffness == effective::uniform_strain(*m.state).stiffness);
  CHECK(m.closed_form(RungName::relaxed)->stiffness ==
        effective::relaxed(*m.state, m.microstructure().mechanical_coordination_number).stiffness);
  CHECK_FALSE(m.closed_form(RungName::network));
  Given better = own;
  better.void_ratio = 0.7;
  better.stress = {.v = 2e5, .h = 1e5};
  const Measurement other = measure(cubic(), better, wanted);
  REQUIRE(other.state);
  CHECK((other.void_ratio == 0.7 && other.state->void_ratio == 0.7));
  CHECK((other.state->stress_v == 2e5 && other.state->stress_h == 1e5));
  // Without a ratio that of the network, where contacts have stiffnesses; Mindlin's where the law gives them.
  Given unasked = own;
  unasked.tangential_ratio.reset();
  const auto ratio = [&] { return measure(cubic(), unasked, wanted).state->tangential_ratio; };
  CHECK(ratio() == relative(k_t / k_n, 1e-14));
  unasked.stiffness_from = packing::StiffnessFrom::force;
  CHECK(ratio() == contact::mindlin_stiffness_ratio(unasked.grain_poisson_ratio));
  // No static force field bears tension.
  better.stress->v = -1;
  const Measurement none = measure(cubic(), better, wanted);
  CHECK_FALSE(none.state);
  CHECK((none.closed_forms.empty() && none.notes.size() == 1));
}

TEST_CASE("contacts without a stiffness get that of the law, others keep theirs unless requested") {
  packing::Assembly packing = cubic();
  for (packing::Contact& c : packing.contacts)
    c.normal_stiffness = c.tangential_stiffness = 0;
  const Wanted wanted{.network = network::ResponseOptions{}};
  const double by_law = law.stiffness_at_overlap(2 * R - edge);
  CHECK(measure(packing, own, wanted).solved_network().response.affine().matrix(0, 0) ==
        relative(by_law / edge, 1e-9));
  Given by_force = own;
  by_force.stiffness_from = packing::StiffnessFrom::force;
  CHECK(measure(cubic(), by_force, wanted).solved_network().response.affine().matrix(0, 0) ==
        relative(law.stiffness_at_force(f_n) / edge, 1e-9));
}

TEST_CASE("missing parts raise an error") {
  packing::Assembly packing = row();
  const Measurement m = measure(packing, own, {.network = network::ResponseOptions{}});
  CHECK_THROWS_AS((void)m.solved_network(), NotConverged); // nothing bears load
  packing.contacts.pop_back();
  CHECK_THROWS_AS((void)measure(packing, own).microstructure(), InvalidArgument);
  CHECK_THROWS_AS((void)measure(cubic(), own, {.rose_bins = 0}), InvalidArgument);
  CHECK_THROWS_AS((void)measure(cubic(), own, {.interior_layer = 2 * edge}), InvalidArgument);
}

TEST_CASE("the network of a measurement is that of the assembly with stiffnesses") {
  packing::Assembly bare = cubic(); // stiffnesses by the law
  for (packing::Contact& c : bare.contacts)
    c.normal_stiffness = c.tangential_stiffness = 0;
  const Given of_law{.law_family = contact::PowerLaw::sphere, .grain_shear_modulus = 30e9};
  for (const auto& [assembly, given] : {std::pair{cubic(), Given{}}, {bare, of_law}}) {
    const Measurement measured = measure(assembly, given, {.network = network::ResponseOptions{}});
    CHECK(network::linear_response(stiffened(assembly, given)).relaxed().matrix ==
          measured.network->response.relaxed().matrix);
  }
  CHECK(stiffened(bare, of_law).contacts[0].normal_stiffness > 0);
  bare.contacts.resize(2);
  CHECK_THROWS_AS(static_cast<void>(stiffened(bare, {})), InvalidArgument);
  packing::Assembly empty;
  empty.cell = Mat3::identity();
  CHECK_THROWS_AS(static_cast<void>(stiffened(empty, {})), InvalidArgument);
}

TEST_CASE("a lattice of grains with adhesion is as stiff as its contacts") {
  // Simple cubic: C11 of the network is k_n/l; adhesion of so soft grains makes a twentieth of it.
  packing::Assembly lattice = cubic();
  const contact::GrainMaterial soft{5e6, 0.3};
  for (const auto model : {contact::AdhesionModel::jkr, contact::AdhesionModel::dmt}) {
    const contact::Adhesion adhesion{model, 0.1};
    const contact::AdhesiveContact state = adhesive_contact_at_overlap(adhesion, soft, R, 1e-6);
    for (packing::Contact& c : lattice.contacts)
      c.normal_force = state.force;
    Given given{.grain_shear_modulus = soft.shear_modulus,
                .grain_poisson_ratio = soft.poisson_ratio,
                .adhesion = adhesion};
    const Measurement m = measure(lattice, given, everything());
    REQUIRE(m.network);
    CHECK(m.network->response.relaxed().matrix(0, 0) == relative(state.stiffness / edge, 1e-12));
    CHECK_FALSE(m.law_check);
    CHECK_FALSE(m.network->response.force_terms());
    given.stiffness_from = packing::StiffnessFrom::force;
    CHECK(stiffened(lattice, given).contacts[0].normal_stiffness == relative(state.stiffness, 1e-12));
    given.materials = std::vector(lattice.grain_count(), soft);
    given.grain_shear_modulus.reset();
    CHECK(stiffened(lattice, given).contacts[0].normal_stiffness == relative(state.stiffness, 1e-12));
  }
  const contact::AdhesiveContact jkr =
      adhesive_contact_at_overlap({contact::AdhesionModel::jkr, 0.1}, soft, R, 1e-6);
  CHECK(jkr.stiffness > 1.04 * contact::PowerLaw::sphere(soft, R).stiffness_at_overlap(1e-6));
}

TEST_CASE("adhesion without a material, of cones, and with k_n = 1.5 f/d is refused") {
  const contact::Adhesion adhesion{contact::AdhesionModel::jkr, 0.1};
  Given given{.adhesion = adhesion};
  CHECK_THROWS_AS((void)measure(cubic(), given), InvalidArgument);
  given.grain_shear_modulus = 1e9;
  CHECK_NOTHROW((void)measure(cubic(), given));
  given.stiffness_from = packing::StiffnessFrom::ratio;
  CHECK_THROWS_AS((void)measure(cubic(), given), InvalidArgument);
  given.stiffness_from.reset();
  given.law_family = [](const contact::GrainMaterial& grain, double) {
    return contact::PowerLaw::cone(grain, 0.1);
  };
  CHECK_THROWS_AS((void)measure(cubic(), given), InvalidArgument);
  CHECK_THROWS_AS((void)measure(cubic(), {.law = law, .adhesion = adhesion}), InvalidArgument);
  const Given negative{.grain_shear_modulus = 1e9, .adhesion = contact::Adhesion{.surface_energy = -1}};
  CHECK_THROWS_AS((void)measure(cubic(), negative), InvalidArgument); // without a network, too
}
