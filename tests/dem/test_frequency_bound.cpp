// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/frequency_bound.hpp"

#include <functional>
#include <optional>
#include <random>

#include <Eigen/Dense>
#include <granum/contact/grains.hpp>
#include <granum/contact/laws.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/dem/specimen.hpp>

#include "dem/sweep/verlet_list.hpp"
#include "lattice_state.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::radius;
constexpr double density = 2650, mass = 1.4e-6;

/// Of the eigenvalues.
constexpr double rounding = 1 - 1e-12;
/// Where grains are thrown together; 2.6 to 2.9 in packings before each contact had its own share for either
/// grain.
constexpr double loose_at_most = 1.7;

/// What the engine knows when it chooses its time step.
struct Scene {
  Specimen state;
  contact::PowerLaw law;
  double tangential_ratio;
  std::vector<Pair> pairs;
  Partition parts;
  Grains grains;
  std::optional<WallContacts> walls;

  Scene(Specimen given, const contact::PowerLaw& of_pairs, double ratio)
      : state(std::move(given)), law(of_pairs), tangential_ratio(ratio) {
    VerletList list(state, 0.02);
    list.build(state);
    pairs = list.pairs();
    parts = partition(pairs, state.grain_count());
    grains.resize(state.grain_count());
    grains.set_sizes(own_sizes(state, density));
    for (std::size_t g = 0; g < state.grain_count(); ++g)
      grains.set_centre(g, state.position[g]);
    if (state.walls) {
      walls.emplace(state.walls->friction_coefficient);
      walls->list(state.cell, grains, radius, 0.02 * radius, {});
    }
  }
  [[nodiscard]] double bound(bool backwards = false) const {
    const std::size_t count = parts.chunks.size();
    return FrequencyBound().highest_squared(contact::NormalLaw(law).kernel(),
                                            {.parts = parts,
                                             .grains = grains,
                                             .cell = state.cell,
                                             .radius = radius,
                                             .tangential_ratio = tangential_ratio,
                                             .mass = mass},
                                            walls ? &*walls : nullptr,
                                            [&](const std::function<void(std::size_t)>& job) {
                                              for (std::size_t c = 0; c < count; ++c)
                                                job(backwards ? count - 1 - c : c);
                                            });
  }
  [[nodiscard]] double mass_of(std::size_t g) const { return grains.own.empty() ? mass : grains.own[g].mass; }
};

/// Velocity of i against j at their contact, for moving and turning (in radii) of both.
Eigen::Matrix<double, 3, 12> approach(const Eigen::Vector3d& lever) {
  Eigen::Matrix3d turn;
  turn << 0, lever.z(), -lever.y(), -lever.z(), 0, lever.x(), lever.y(), -lever.x(), 0;
  Eigen::Matrix<double, 3, 12> out;
  out << Eigen::Matrix3d::Identity(), turn, -Eigen::Matrix3d::Identity(), turn;
  return out;
}

Eigen::Matrix3d stiffness(const Eigen::Vector3d& lever, double k, double ratio) {
  const Eigen::Matrix3d along = lever.normalized() * lever.normalized().transpose();
  return k * (along + ratio * (Eigen::Matrix3d::Identity() - along));
}

/// Highest eigenvalue of M^-1 H, with H put together contact by contact.
double exact(const Scene& scene) {
  const Specimen& state = scene.state;
  const auto at = [](std::size_t g) { return 6 * static_cast<Eigen::Index>(g); };
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(at(state.grain_count()), at(state.grain_count()));
  const auto add = [&](const std::vector<std::size_t>& grains, const Vec3& to_contact, double k,
                       double ratio) {
    const Eigen::Vector3d lever(to_contact.x, to_contact.y, to_contact.z);
    const Eigen::Matrix<double, 3, 12> moved = approach(lever);
    const Eigen::Matrix<double, 12, 12> own = moved.transpose() * stiffness(lever, k, ratio) * moved;
    for (std::size_t a = 0; a < grains.size(); ++a)
      for (std::size_t b = 0; b < grains.size(); ++b)
        h.block<6, 6>(at(grains[a]), at(grains[b])) += own.block<6, 6>(at(a), at(b));
  };
  const std::array<Vec3, image_count> shifts = shift_vectors(state.cell);
  for (const Pair& pair : scene.pairs) {
    const double reach = state.radius_of(pair.i) + state.radius_of(pair.j);
    const Vec3 b = state.position[pair.j] + shifts[pair.image] - state.position[pair.i];
    const contact::NormalLaw law =
        contact::of_sizes(scene.law, state.radius_of(pair.i) / radius, state.radius_of(pair.j) / radius);
    if (norm(b) < reach)
      add({pair.i, pair.j}, 1 / reach * b, law.stiffness_at_overlap(reach - norm(b)), scene.tangential_ratio);
  }
  const auto planes = wall_planes(state.cell);
  for (std::size_t g = 0; scene.walls && g < state.grain_count(); ++g)
    for (const WallPlane& plane : planes) {
      const double overlap = radius - wall_distance(plane, state.position[g]);
      const double ratio = scene.walls->friction() > 0 ? scene.tangential_ratio : 0;
      if (overlap > 0) // from a rigid plane, the law of two equal grains that are twice as deep in each other
        add({g}, -(1 - overlap / radius) * plane.normal, 2 * scene.law.stiffness_at_overlap(2 * overlap),
            ratio);
    }
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    h.middleRows<6>(at(g)) /= std::sqrt(scene.mass_of(g));
    h.middleCols<6>(at(g)) /= std::sqrt(scene.mass_of(g));
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(h, Eigen::EigenvaluesOnly).eigenvalues().tail<1>()(0);
}

void check_bound(const Scene& scene, double at_most) {
  const double bound = scene.bound(), highest = exact(scene);
  CAPTURE(scene.tangential_ratio);
  CAPTURE(scene.state.size.empty());
  CAPTURE(scene.state.walls.has_value());
  CHECK(bound >= highest * rounding);
  CHECK(bound <= at_most * highest);
}

/// Grains at random in a box, some deep in each other: no packing, but one whose grains are pushed from one
/// side more than from another.
Specimen random_grains(unsigned seed, bool unequal, std::size_t count = 80) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  Specimen state;
  state.radius = radius;
  const double edge = 4.6 * 2 * radius * std::cbrt(static_cast<double>(count) / 80);
  state.cell = Mat3::diagonal(edge, edge, edge);
  for (std::size_t g = 0; g < count; ++g) {
    state.position.push_back(edge * Vec3{uniform(random), uniform(random), uniform(random)});
    if (unequal)
      state.size.push_back(0.5 + 0.5 * uniform(random));
  }
  state.velocity.resize(count);
  state.angular_velocity.resize(count);
  return state;
}

contact::PowerLaw law_of(contact::Shape shape) {
  const contact::GrainMaterial glass{.shear_modulus = 29e9, .poisson_ratio = 0.2};
  if (shape == contact::Shape::cone)
    return contact::PowerLaw::cone(glass, 1.4);
  return shape == contact::Shape::flat ? contact::PowerLaw::flat(glass, 1e-5)
                                       : contact::PowerLaw::sphere(glass, radius);
}

} // namespace

TEST_CASE("the bound is above the highest frequency, also among different grains and between walls") {
  for (const contact::Shape shape : {contact::Shape::cone, contact::Shape::sphere, contact::Shape::flat})
    for (const double ratio : {0.0, 0.9, 1.3})
      check_bound({random_grains(1, false), law_of(shape), ratio}, loose_at_most);
  for (const unsigned seed : {1U, 2U, 3U}) {
    check_bound({random_grains(seed, true), law_of(contact::Shape::sphere), 0.9}, loose_at_most);
    for (const double friction : {0.0, 0.3}) {
      Specimen boxed = random_grains(seed, false);
      boxed.walls = test::walls(friction);
      check_bound({boxed, law_of(contact::Shape::sphere), 0.9}, loose_at_most);
    }
  }
}

TEST_CASE("in packings at rest the bound is near the highest frequency") {
  for (const contact::Shape shape : {contact::Shape::cone, contact::Shape::sphere, contact::Shape::flat})
    for (const bool unequal : {false, true}) {
      Specimen state = random_grains(4, unequal);
      CHECK(minimise_enthalpy(state, law_of(shape), 100e3).converged);
      check_bound({state, law_of(shape), 0.9}, 1.35);
    }
}

TEST_CASE("the order of chunks changes no bit of it") {
  for (const bool unequal : {false, true})
    for (unsigned seed = 1; seed <= 12; ++seed) { // one grain alone decides in each
      CAPTURE(seed);
      Specimen state = random_grains(seed, unequal, 4200);
      if (seed % 2 == 0)
        state.walls = test::walls(0);
      Scene scene(state, law_of(contact::Shape::sphere), 0.9);
      REQUIRE(scene.parts.chunks.size() == 4);
      const double forwards = scene.bound();
      CHECK(scene.bound(true) == forwards);
      const Chunk whole{.grains = {0, state.grain_count()},
                        .pairs = {0, scene.parts.pairs.size()},
                        .spare_rows = {},
                        .additions = {}};
      scene.parts.chunks = {whole};
      CHECK(scene.bound() == forwards);
    }
}

TEST_CASE("it is the highest frequency of two grains, and of a lattice without rotations") {
  const Specimen pair = test::pair_state(1e-7);
  const contact::PowerLaw law = law_of(contact::Shape::sphere);
  const Scene two(pair, law, 0);
  const double k = law.stiffness_at_overlap(1e-7);
  CHECK(two.bound() == relative(2 * k / mass, 1e-9)); // the overlap's rounding
  CHECK(exact(two) == relative(2 * k / mass, 1e-9));
  // moving against and turning with each other, both resisted by k_t
  const Scene rough(pair, law, 0.9);
  CHECK(exact(rough) == relative(4 * 0.9 * k / mass, 1e-3)); // the lever is half an overlap short of R
  check_bound(rough, 1.2);
  const Scene lattice(test::fcc(radius, 3, 1e-7), law, 0);
  CHECK(lattice.bound() >= exact(lattice));
  CHECK(lattice.bound() == relative(8 * k / mass, 1e-4)); // 12 contacts, sum of k nn 4 k each way
}

TEST_CASE("a contact that hardly touches does not spoil it, and without contacts there is no frequency") {
  for (const double barely : {1e-3, 1e-9, 1e-15}) {
    CAPTURE(barely);
    Specimen state = random_grains(5, false);
    // above the box of all others a lonely pair, one of which hardly touches a third
    state.cell(2, 2) *= 3;
    const double height = 0.7 * state.cell(2, 2), x = state.cell(0, 0) / 2;
    for (const double along : {0.0, 1.9 * radius, (3.9 - barely) * radius}) {
      state.position.push_back({x + along - 2 * radius, x, height});
      state.velocity.push_back({});
      state.angular_velocity.push_back({});
    }
    check_bound({state, law_of(contact::Shape::sphere), 0.9}, loose_at_most);
  }
  Specimen apart = random_grains(6, false);
  apart.cell = 30.0 * apart.cell;
  for (Vec3& x : apart.position)
    x = 30.0 * x;
  CHECK(Scene(apart, law_of(contact::Shape::sphere), 0.9).bound() == 0);
}
