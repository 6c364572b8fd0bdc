// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/force_chains.hpp"

#include <granum/plot/palette.hpp>

#include "count_pieces.hpp"
#include "unit.hpp"
#include "well_formed.hpp"

using namespace granum::studies;

namespace {

/// Four grains of radius 1 in a row along x at y = 0, and one far behind.
packing::Assembly row() {
  packing::Assembly out{.cell = Mat3::diagonal(20, 20, 20), .position = {}, .radius = {}, .contacts = {}};
  for (int k = 0; k < 4; ++k)
    out.position.push_back({2.0 * k, 0, 0});
  out.position.push_back({0, 8, 0});
  out.position.push_back({0, -8, 0});
  out.radius.assign(6, 1);
  const double forces[] = {1, 3, 0};
  for (std::uint32_t k = 0; k < 3; ++k)
    out.contacts.push_back({.i = k, .j = k + 1, .branch = {2, 0, 0}, .normal_force = forces[k]});
  return out;
}

} // namespace

TEST_CASE("force chains are as wide as their force, those above the mean in colour, and only in the slice") {
  const auto chains = force_chains(row());
  REQUIRE(chains);
  CHECK(well_formed(chains->svg));
  CHECK(well_formed(chains->in_page));
  CHECK(count(chains->in_page, "<circle") == 4);               // not the two far away
  CHECK(count(chains->in_page, "<line") == 2);                 // not the one that does not press
  CHECK(count(chains->in_page, "stroke-width=\"1.10\"") == 1); // 2.2 for the mean force, 2
  CHECK(count(chains->in_page, "stroke-width=\"3.30\"") == 1);
  const std::size_t strong = chains->in_page.find(
      "class=\"c" + std::to_string(static_cast<std::size_t>(plot::Colour::force)) + "\"");
  REQUIRE(strong != std::string::npos);
  CHECK(chains->in_page.find("3.30") > strong);
  CHECK(chains->in_page.find("1.10") < strong);
  for (const char* number :
       {" 2 ", " 1 ", " 75 %"}) // contacts, those above the mean force, their share of it
    CHECK(chains->finding.find(number) != std::string::npos);
}

TEST_CASE("force chains are drawn the same wherever the packing is, without pressing contacts not at all") {
  packing::Assembly moved = row();
  for (Vec3& x : moved.position)
    x += Vec3{100, 7, -50};
  const std::string picture = force_chains(moved)->in_page;
  CHECK(picture == force_chains(row())->in_page);
  double last = 12 - 52.5; // four grains of two radii each on 420 between edges of 12
  for (std::size_t at = picture.find(" cx=\""); at != std::string::npos;
       at = picture.find(" cx=\"", at + 1)) {
    CHECK(std::stod(picture.substr(at + 5)) == doctest::Approx(last + 105).epsilon(1e-3));
    last += 105;
  }
  packing::Assembly packing = row();
  for (packing::Contact& contact : packing.contacts)
    contact.normal_force = 0;
  CHECK_FALSE(force_chains(packing));
  CHECK_FALSE(force_chains(
      packing::Assembly{.cell = Mat3::diagonal(1, 1, 1), .position = {}, .radius = {}, .contacts = {}}));
}
