// SPDX-License-Identifier: GPL-3.0-or-later
// Each warning of a measured frame, provoked by a file, and not there in the same file without its cause.
#include "studies/analyse/measured_frame.hpp"

#include "read_specimen.hpp"
#include "studies/analyse/frame_warnings.hpp"
#include "thresholds.hpp"
#include "unit.hpp"
#include "written_packing.hpp"

using namespace granum::samples;
using analysis::Given;

namespace {

const Given given_modulus{.grain_shear_modulus = specimen_grain.shear_modulus};

/// Everything but the network, or with it solved.
analysis::Wanted wanted(const std::optional<network::ResponseOptions>& network = {}) {
  analysis::Wanted out = analysis::everything();
  out.network = network;
  return out;
}

std::vector<std::string> warnings(const io::ImportedPacking& packing, const Given& given = given_modulus,
                                  const analysis::Wanted& measured = wanted()) {
  return studies::measure_frame(packing, given, measured).warnings;
}

/// Whether one of them has this number or note.
bool one_says(const std::vector<std::string>& all, const std::string& number) {
  return std::ranges::any_of(all, [&](const std::string& w) { return w.find(number) != std::string::npos; });
}

Given cones() {
  Given cone = given_modulus;
  cone.law_family = [](const contact::GrainMaterial& grain, double) {
    return contact::PowerLaw::cone(grain, 0.4);
  };
  return cone;
}

/// The specimen, changed, through a dump.
template <class Change>
io::ImportedPacking changed(const Change& change) {
  packing::Assembly a = specimen();
  change(a);
  return through_dump(a);
}

/// Gives a frame this stress of so many contacts.
void set_stress(analysis::Measurement& m, double contacts, const Mat3& stress) {
  m.counts.contacts = static_cast<std::size_t>(contacts);
  m.stress->symmetric = stress;
}

/// Gives it contacts that carry moments, of which this is left over.
void set_moments(analysis::Measurement& m, double force_ratio, double moment_ratio) {
  m.moments = "contacts carry moments";
  m.forces->unbalance = packing::Unbalance{.force_ratio = force_ratio, .moment_ratio = moment_ratio};
}

std::vector<std::string> warnings_of(const io::ImportedPacking& packing, studies::MeasuredFrame frame) {
  frame.warnings.clear();
  studies::add_warnings(packing, frame);
  return frame.warnings;
}

std::size_t warnings_with(const io::ImportedPacking& packing, const studies::MeasuredFrame& frame) {
  return warnings_of(packing, frame).size();
}

/// Four grains, each in contact with the two beside it in the list, through faces along z too.
packing::Assembly ring(const Mat3& cell, const std::vector<Vec3>& places) {
  packing::Assembly a{
      .cell = cell, .position = places, .radius = std::vector(4, specimen_radius), .contacts = {}};
  for (const auto& [i, j] :
       std::initializer_list<std::pair<std::uint32_t, std::uint32_t>>{{0, 1}, {0, 3}, {1, 2}, {2, 3}}) {
    Vec3 branch = places[j] - places[i];
    branch.z -= cell(2, 2) * std::round(branch.z / cell(2, 2));
    a.contacts.push_back({.i = i, .j = j, .branch = branch, .overlap = 1e-5, .normal_force = 1});
  }
  return a;
}
} // namespace

TEST_CASE("frame warnings: a specimen at rest has none, and each begins at its threshold") {
  CHECK(studies::measure_frame(through_csv(specimen()), given_modulus, wanted()).warnings.empty());
  const io::ImportedPacking good = through_dump(specimen());
  studies::MeasuredFrame measured = studies::measure_frame(good, given_modulus, wanted());
  REQUIRE(measured.warnings.empty());
  REQUIRE(measured.packing.fabric->density);
  REQUIRE(measured.packing.law_check);
  using Change = void (*)(io::ImportedPacking&, analysis::Measurement&, double);
  const std::pair<double, Change> rows[] = {
      {0.2, [](auto&, auto& m, double x) { m.void_ratio = x; }},
      {3, [](auto&, auto& m, double x) { m.void_ratio = x; }},
      {10, [](auto& p, auto&, double x) { p.assembly.radius[0] *= x; }},
      {0.01, [](auto&, auto& m, double x) { m.fabric->density->chi_square.p_value = x; }},
      {0.01, [](auto&, auto& m, double x) { m.fabric->axisymmetry->both.p_value = x; }},
      {1e-3, [](auto&, auto& m, double x) { m.forces->unbalance->force_ratio = x; }},
      {2e-3,
       [](auto& p, auto& m, double x) { // five contacts, each off by as much
         p.rounding.force = 2e-4;
         m.forces->unbalance->force_ratio = x;
       }},
      {2e-3,
       [](auto& p, auto& m, double x) {
         p.rounding.length = 2e-4 * norm(p.assembly.contacts.front().branch);
         m.forces->unbalance->force_ratio = x;
       }},
      {4e-3,
       [](auto&, auto& m, double x) { // beside a quarter of the weight, which is left
         m.forces->weight.emplace().left_over = 0.25;
         m.forces->unbalance->force_ratio = x;
       }},
      {0.02, [](auto&, auto& m, double x) { set_moments(m, 0, x); }},
      {0.06, [](auto&, auto& m, double x) { set_moments(m, 0.02, x); }},
      {0.01, [](auto&, auto& m, double x) { m.law_check->misfit_90 = x; }},
      {0.1,
       [](auto& p, auto& m, double x) { // three times 1.5 times what rounding makes of forces
         p.rounding.overlap = 0.02 / analysis::rounded_share(p.assembly, 1);
         m.law_check->misfit_90 = x;
       }},
      {0.1,
       [](auto& p, auto&, double x) { p.rounding.overlap = x / analysis::rounded_share(p.assembly, 1); }},
      {0.99, [](auto&, auto& m, double x) { m.law_check->coefficient_ratio = x; }},
      {1.01, [](auto&, auto& m, double x) { m.law_check->coefficient_ratio = x; }},
      {1e6, [](auto&, auto& m, double x) { m.grain->shear_modulus = x; }},
      {1e12, [](auto&, auto& m, double x) { m.grain->shear_modulus = x; }},
      {0.05,
       [](auto& p, auto& m, double x) {
         p.notes.push_back({io::Finding::units_unknown, ""});
         m.grain.reset();
         m.sizes.equivalent = x;
       }},
      {0.1, [](auto&, auto& m, double x) { set_stress(m, 2000, Mat3::diagonal(1, 1 + x, 1 - x)); }},
      {0.1,
       [](auto&, auto& m, double x) {
         set_stress(m, 2000, {{{1, 0, x / 2}, {0, 1, 0}, {x / 2, 0, 1}}});
       }},
      {0.4, [](auto&, auto& m, double x) { set_stress(m, 100, Mat3::diagonal(1 + x, 1, 1 - x)); }},
      {20, [](auto&, auto& m, double x) { set_stress(m, x, Mat3::diagonal(2, 0, 1)); }},
  };
  for (const auto& row : rows)
    check_threshold(row.first, [&](double value) {
      io::ImportedPacking packing = good;
      studies::MeasuredFrame frame = measured;
      row.second(packing, frame.packing, value);
      return warnings_with(packing, frame);
    });
  check_threshold(0.01 / analysis::rounded_share(good.assembly, 1), [&](double x) {
    io::ImportedPacking packing = good;
    packing.notes.push_back({io::Finding::few_digits, ""});
    packing.rounding.overlap = x;
    return warnings_with(packing, measured);
  });
  io::ImportedPacking open = good;
  open.periodic[2] = false;
  CHECK(warnings_with(open, measured) == 1);
}

TEST_CASE("frame warnings: the cause of a misfit is named by the exponent of the forces") {
  const io::ImportedPacking good = through_dump(specimen());
  studies::MeasuredFrame frame = studies::measure_frame(good, given_modulus, wanted());
  const auto cause = [&](double exponent, bool several = false, bool materials = false) {
    io::ImportedPacking packing = good;
    packing.type.assign(packing.assembly.grain_count(), 1);
    packing.type.back() = several ? 2 : 1;
    frame.materials_given = materials;
    frame.packing.law_check->misfit_90 = 1;
    frame.packing.law_check->force_exponent = Measured{exponent, 0};
    std::vector<std::string> all = warnings_of(packing, frame);
    REQUIRE(all.size() == 1);
    std::erase_if(all.front(), [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
    return all.front();
  };
  const std::string none = cause(3);
  for (const double at : {1.0, 1.5, 2.0})
    for (const double side : {-1.0, 1.0}) {
      CHECK((cause(at + 0.0299 * side) == cause(at) && cause(at) != none));
      CHECK(cause(at + 0.0301 * side) == none);
      // Types explain all but springs.
      CHECK((cause(at, true) == cause(3, true)) == (at != 1));
      CHECK(cause(at, true, true) == cause(at));
    }
  CHECK((cause(1) != cause(1.5) && cause(1.5) != cause(2) && cause(1) != cause(2)));
}

TEST_CASE("frame warnings: principal stresses and the weight are shown with their directions") {
  const io::ImportedPacking good = through_dump(specimen());
  studies::MeasuredFrame frame = studies::measure_frame(good, given_modulus, wanted());
  // 5, 3 and 1 kPa along (0.8, 0, 0.6), (0, 1, 0) and (-0.6, 0, 0.8)
  set_stress(frame.packing, 2000, {{{3560, 0, 1920}, {0, 3000, 0}, {1920, 0, 2440}}});
  std::vector<std::string> all = warnings_of(good, frame);
  REQUIRE(all.size() == 1);
  std::erase(all[0], '-');
  CHECK(one_says(all, "5 kPa along (0.8, 0, 0.6), 3 kPa along (0, 1, 0), 1 kPa along (0.6, 0, 0.8)"));
  set_stress(frame.packing, 2000, Mat3::identity());
  for (const double small : {0.99e-4, 1.01e-4}) { // parts of less than 1e-4 are shown as 0
    frame.packing.forces->weight.emplace().per_volume = {25e3 * small, 0, -25e3};
    all = warnings_of(good, frame);
    CHECK(one_says(all, small < 1e-4 ? "25 kN per m3 of solid along (0, 0, -1)"
                                     : "25 kN per m3 of solid along (0.000101, 0, -1)"));
  }
}

TEST_CASE("frame warnings: notes of the reader that invalidate a comparison are passed on") {
  using enum io::Finding;
  for (const io::Finding finding :
       {duplicated, one_sided, cell_unknown, wall_contacts, contact_moments, cell_turned, own_image,
        units_differ, unbalanced_rows, bodies, signs_turned, shapes, empty_rows, walls_unknown}) {
    CAPTURE(int(finding));
    io::ImportedPacking packing = through_csv(specimen());
    packing.notes.push_back({finding, "a note"});
    const std::vector<std::string> passed = warnings(packing);
    REQUIRE(passed.size() == 1);
    CHECK(passed.front().starts_with("a note"));
  }
}

TEST_CASE("frame warnings: few digits are reported by their effect on the overlaps") {
  // lines of centres with all digits: those of the coordinates do not matter
  const io::ImportedPacking coordinates = through_dump(specimen(), 6), six = through_dump(specimen(), 6, 6);
  for (const io::ImportedPacking& harmless : {coordinates, six}) {
    CHECK(harmless.has(io::Finding::few_digits));
    CHECK(warnings(harmless).empty());
  }
  CHECK(coordinates.rounding.overlap == 0);
  CHECK(six.rounding.overlap == relative(5e-10, 1e-12));        // of a millimetre
  const auto found = studies::measure_frame(six).packing.grain; // G_g comes out of them
  REQUIRE(found);
  CHECK(found->shear_modulus == relative(specimen_grain.shear_modulus,
                                         3 * analysis::rounded_share(six.assembly, six.rounding.overlap)));
  CHECK_FALSE(warnings(six, cones()).empty()); // another law shows at six digits
  // four digits say nothing of the overlaps, and leave a little on the grains
  CHECK(one_says(warnings(through_dump(specimen(), 6, 4)), "5e-08 m"));
}

TEST_CASE("frame warnings: forces of 0, tension, bonds, and forces of another material") {
  CHECK_FALSE(warnings(changed([](packing::Assembly& a) {
                for (packing::Contact& c : a.contacts)
                  c.normal_force = 0, c.tangential_force = {};
              })).empty());
  const auto pulled = changed([](packing::Assembly& p) { p.contacts[3].normal_force *= -0.1; });
  CHECK(one_says(warnings(pulled), "1 "));
  io::ImportedPacking bonded = pulled;
  for (packing::Contact& c : bonded.assembly.contacts)
    c.rolling_stiffness = 1e-3;
  CHECK(warnings(bonded) != warnings(pulled));
  CHECK(one_says(warnings(through_dump(specimen()), {.grain_shear_modulus = 20e9}), "1.5"));
}

TEST_CASE("frame warnings: walls made of grains") {
  const auto in_one_plane = [](int count) {
    return warnings(changed([count](packing::Assembly& a) {
      for (int k = 0; k < count; ++k) {
        a.position.push_back({1e-4 * k, 2e-4 * k, 1e-3});
        a.radius.push_back(specimen_radius);
      }
    }));
  };
  CHECK(in_one_plane(16).size() == in_one_plane(15).size() + 1);
  CHECK(one_says(in_one_plane(20), "20 "));
  const io::ImportedPacking good = through_dump(specimen()); // 5 % of all grains
  const studies::MeasuredFrame measured = studies::measure_frame(good, given_modulus, wanted());
  const auto of_all = [&](std::size_t all) {
    io::ImportedPacking packing = good;
    for (std::size_t k = packing.assembly.grain_count(); k < all; ++k) {
      const double apart = 1e-6 * static_cast<double>(k);
      packing.assembly.position.push_back({apart, apart, all - k <= 20 ? -1 : apart});
      packing.assembly.radius.push_back(specimen_radius);
    }
    return warnings_with(packing, measured);
  };
  CHECK(of_all(400) == of_all(401) + 1);
}

TEST_CASE("frame warnings: directions that no E(gamma, a) has") {
  io::ContactTable cone, plane; // evenly round the axis, but at 45 degrees to it all; and none round it
  for (int k = 0; k < 400; ++k) {
    const double angle = 0.7 * k;
    cone.normal.push_back(std::sqrt(0.5) * Vec3{std::cos(angle), std::sin(angle), 1});
    plane.normal.push_back({std::sin(angle), 0, std::cos(angle)});
  }
  CHECK(studies::measure_frame(cone).warnings.size() == 1);
  CHECK_FALSE(studies::measure_frame(plane).warnings.empty());
}

TEST_CASE("frame warnings: too few iterations of the network") {
  const auto of = [](const network::ResponseOptions& options) {
    return warnings(through_csv(specimen()), given_modulus, wanted(options)).size();
  };
  CHECK((of({}) == 0 && of({.iteration_limit = 1}) > 0));
}

TEST_CASE("frame warnings: forces matter from 2 % of the shear modulus that they change most") {
  const io::ImportedPacking packing = through_csv(specimen());
  const auto softened = [&](double factor) {
    return studies::measure_frame(packing, {.grain_shear_modulus = specimen_grain.shear_modulus / factor},
                                  wanted(network::ResponseOptions{}));
  };
  const auto most = [](const studies::MeasuredFrame& frame) {
    const network::Response& response = frame.packing.network->response;
    double share = 0;
    for (const int plane : {3, 4, 5})
      share = std::max(share, std::abs(response.force_terms()->geometric.matrix(plane, plane) /
                                       response.relaxed().matrix(plane, plane)));
    return share;
  };
  double factor = 1; // at which it is 2 %
  for (int k = 0; k < 4; ++k)
    factor *= 0.02 / most(softened(factor));
  CHECK(most(softened(factor)) == relative(0.02, 1e-4));
  check_threshold(factor, [&](double f) { return softened(f).warnings.size(); });
}

TEST_CASE("frame warnings: strains that nothing resists are named by their parts") {
  const io::ImportedPacking packing = through_csv(specimen());
  studies::MeasuredFrame frame =
      studies::measure_frame(packing, given_modulus, wanted(network::ResponseOptions{}));
  const double scale = frame.packing.network->affine.stiffness.matrix.norm();
  const auto found = [&](double stiffness, double other) { // of the strain (11, other 33)
    Eigen::Matrix<double, 6, 1> strain = Eigen::Matrix<double, 6, 1>::Zero();
    strain[0] = 1, strain[2] = other;
    strain.normalize();
    frame.packing.network->relaxed.stiffness.matrix =
        scale * (Eigen::Matrix<double, 6, 6>::Identity() - (1 - stiffness) * strain * strain.transpose());
    return warnings_of(packing, frame);
  };
  check_threshold(1e-9, [&](double stiffness) { return found(stiffness, 0).size(); });
  check_threshold(0.4, [&](double other) { return one_says(found(0, other), "(11 and 33)"); });
  CHECK(one_says(found(0, -0.5), "(11 and -33)"));
  CHECK(one_says(found(0, -3), "(-11 and 33)") != one_says(found(0, -2.4), "(-11 and 33)"));
  CHECK(one_says(found(0, 0.3), " 1 of six strains (11)"));
}

TEST_CASE("frame warnings: strains that nothing resists are named") {
  const analysis::Wanted solved = wanted(network::ResponseOptions{});
  // a straight chain through the faces of the cell carries stress along itself, and nothing else of six
  const auto chain = through_csv(
      ring(Mat3::diagonal(4e-3, 4e-3, 3.96e-3),
           {{2e-3, 2e-3, 0}, {2e-3, 2e-3, 0.99e-3}, {2e-3, 2e-3, 1.98e-3}, {2e-3, 2e-3, 2.97e-3}}));
  CHECK(one_says(warnings(chain, given_modulus, solved), " 5 "));
  // a ring of four that does not reach through the cell carries nothing at all
  const auto square = through_csv(
      ring(Mat3::diagonal(9e-3, 9e-3, 9e-3),
           {{4e-3, 4e-3, 4e-3}, {4.99e-3, 4e-3, 4e-3}, {4.99e-3, 4.99e-3, 4e-3}, {4e-3, 4.99e-3, 4e-3}}));
  CHECK(warnings(square, given_modulus, solved).size() > warnings(square).size());
}
