// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/measure.hpp>

#include <tuple>

#include <granum/core/stop.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>

#include "analysis/materials.hpp"
#include "packing/sample_packings.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::analysis;

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

namespace {

constexpr double R = 0.5e-3, edge = 2 * R - 1e-6, k_n = 2e5, k_t = 1e5, f_n = 0.1;
const contact::PowerLaw law = contact::PowerLaw::sphere({30e9, 0.15}, R);

/// Three spheres in a row: a touches b, and b touches c.
packing::Assembly row() {
  return {.cell = Mat3::diagonal(4e-3, 4e-3, 4e-3),
          .position = {{1e-3, 1e-3, 1e-3}, {1e-3 + edge, 1e-3, 1e-3}, {1e-3 + 2 * edge, 1e-3, 1e-3}},
          .radius = {R, R, R},
          .contacts = {{.i = 0, .j = 1, .branch = {edge, 0, 0}, .overlap = 1e-6, .normal_force = f_n},
                       {.i = 1, .j = 2, .branch = {edge, 0, 0}, .overlap = 1e-6, .normal_force = 3 * f_n}}};
}

/// 27 spheres on a periodic simple cubic lattice, pressed by the same force along all axes.
packing::Assembly cubic() {
  packing::Assembly out{
      .cell = Mat3::diagonal(3 * edge, 3 * edge, 3 * edge), .position = {}, .radius = {}, .contacts = {}};
  const auto at = [](int x, int y, int z) {
    return static_cast<std::uint32_t>((x % 3) * 9 + (y % 3) * 3 + z % 3);
  };
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z) {
        out.position.push_back({x * edge, y * edge, z * edge});
        out.radius.push_back(R);
        for (int axis = 0; axis < 3; ++axis) {
          const std::uint32_t here = at(x, y, z),
                              next = at(x + (axis == 0), y + (axis == 1), z + (axis == 2));
          packing::Contact c{.i = std::min(here, next), .j = std::max(here, next), .overlap = 2 * R - edge};
          c.branch[axis] = here < next ? edge : -edge;
          c.normal_force = f_n;
          c.normal_stiffness = k_n;
          c.tangential_stiffness = k_t;
          out.contacts.push_back(c);
        }
      }
  std::sort(out.contacts.begin(), out.contacts.end(),
            [](const packing::Contact& a, const packing::Contact& b) {
              return std::tie(a.i, a.j) < std::tie(b.i, b.j);
            });
  return out;
}

const Given own{.law = law, .tangential_ratio = 0.5};

} // namespace

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
  CHECK(network.G_vh() == relative((c(3, 3) + c(4, 4)) / 2, 1e-15));
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

TEST_CASE("measure: the errors of rung 3 grow as those of z* do, the fewer grains an interior has") {
  packing::Assembly many = cubic(); // z* = 6, in each part too
  const Given given{.law = law};
  const auto errors = [&](double from, double to) {
    Wanted wanted{.closed_forms = true};
    if (to > 0)
      wanted.window = Window{.low = {from, from, from}, .high = {to, to, to}};
    const Measurement found = measure(many, given, wanted);
    return std::tuple(found.interior ? found.interior->grains : 27,
                      found.closed_form(effective::RungName::relaxed)->relative_error.value(), *found.state);
  };
  const auto [all, of_all, state] = errors(0, 0);
  const auto [whole, of_whole, same] = errors(-0.5 * edge, 2.5 * edge);
  const auto [few, of_few, part] = errors(-0.5 * edge, 1.5 * edge);
  REQUIRE((all == 27 && whole == 27 && few == 8));
  CHECK(of_whole.G_vh == relative(of_all.G_vh, 1e-9));
  const auto at = [&, whole_state = effective::State(state)](double z) {
    effective::State other = whole_state;
    other.coordination_number = z;
    return effective::relaxed(other, z).stiffness;
  };
  const auto added = [&](auto modulus, double few_error, double all_error) {
    const double slope = (std::log(modulus(6.01)) - std::log(modulus(5.99))) / 0.02;
    CHECK(few_error * few_error - all_error * all_error ==
          relative((std::pow(1.5 * slope, 2) + 0.64) * (1.0 / 8 - 1.0 / 27), 1e-3));
  };
  added([&](double z) { return at(z).G_vh(); }, of_few.G_vh, of_all.G_vh);
  added([&](double z) { return at(z).G_hh(); }, of_few.G_hh, of_all.G_hh);
  added([&](double z) { return at(z).bulk_modulus(); }, of_few.bulk_modulus, of_all.bulk_modulus);
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

TEST_CASE("measure: from how clear forces the material follows, and what is said of rolling stiffness") {
  const auto part = [](std::size_t k) { return static_cast<double>(k % 3) - 1; }; // -1, 0 and 1
  packing::Assembly packing = cubic();
  const Given cones{.law_family = [](const contact::GrainMaterial& grain, double) {
    return contact::NormalLaw(contact::PowerLaw::cone(grain, 0.4));
  }};
  check_threshold(0.01, [&](double off) { // of the forces of two thirds
    for (std::size_t k = 0; k < packing.contacts.size(); ++k) {
      packing::Contact& c = packing.contacts[k];
      c.overlap = (2 * R - edge) * (1 + 0.01 * static_cast<double>(k));
      c.normal_force = contact::PowerLaw::cone({30e9, 0.15}, 0.4).force(c.overlap) * (1 + off * part(k));
    }
    return measure(packing, cones).grain.has_value() ? 1 : 0;
  });
  const auto rolled = [&](double ratio, double deviation) {
    packing::Assembly rolling = cubic();
    rolling.radius[5] *= 1.5;
    for (std::size_t k = 0; k < rolling.contacts.size(); ++k) {
      packing::Contact& c = rolling.contacts[k];
      c.rolling_stiffness = k_n * std::pow(1 / (1 / rolling.radius[c.i] + 1 / rolling.radius[c.j]), 2) *
                            ratio * (1 + std::sqrt(1.5) * deviation * part(k));
    }
    return measure(rolling, own);
  };
  const auto notes = [&](double ratio, double deviation, const char* words) {
    const std::vector<std::string> all = rolled(ratio, deviation).notes;
    return std::count_if(all.begin(), all.end(),
                         [&](const std::string& note) { return note.find(words) != std::string::npos; });
  };
  check_threshold(0.05, [&](double x) { return notes(0.1, x, "%"); });
  check_threshold(1, [&](double x) { return notes(x, 0, "up to 1"); });
  for (const double k_r : {0.3, 1 + 5e-10, 1.01}) // known up to 1, but for rounding
    CHECK(rolled(k_r, 0).state.value().rolling == doctest::Approx(k_r > 1.001 ? 0 : k_r).epsilon(1e-9));
}

TEST_CASE(
    "measure: types of grains differ by their factors of forces from 2 % on, of five contacts or more") {
  packing::Assembly packing = cubic();
  std::vector<long> type(27, 1);
  for (std::size_t g = 9; g < 18; ++g)
    type[g] = 2; // nine contacts among these layers of a plane, and nine to either side
  const auto differ = [&](double factor, std::size_t few) {
    std::size_t between = 0;
    for (packing::Contact& c : packing.contacts) {
      c.normal_force = law.force(c.overlap);
      if (type[c.i] == 2 && type[c.j] == 2)
        c.normal_force *= ++between <= few ? factor : 0;
    }
    return analysis::factors_differ(packing, type) ? 1 : 0;
  };
  check_threshold(1.02, [&](double factor) { return differ(factor, 18); });
  check_threshold(1 / 1.02, [&](double factor) { return differ(factor, 18); });
  CHECK(differ(2, 5) == 1);
  CHECK(differ(2, 4) == 0);
}
