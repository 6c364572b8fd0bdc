// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/force_chains.hpp"

#include <granum/plot/palette.hpp>
#include <granum/plot/svg_text.hpp>

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

TEST_CASE("force chains are of contacts in a slice of four mean radii, in a picture round all grains") {
  using plot::svg_number;
  packing::Assembly packing = row();
  packing.radius = {1, 1, 1, 1, 3, 3}; // of 10/6 in the mean
  packing.position[4] = {10, 8, -3};
  packing.position[5] = {-2, -8, 9};
  packing.contacts[2].normal_force = 95;
  const double scale = 420 / (9.0 + 3 + 3 + 3), foot = -6, top = 12, left = -5, right = 13;
  const auto chains = force_chains(packing);
  const auto tag = [](double width, double height) {
    return "viewBox=\"0 0 " + svg_number(width) + " " + svg_number(height) + "\"";
  };
  CHECK(chains->svg.find(tag(24 + scale * (right - left), 24 + scale * (top - foot))) != std::string::npos);
  for (int k = 0; k < 3; ++k)
    CHECK(count(chains->in_page, "x1=\"" + svg_number(12 + scale * (2 * k - left)) + "\" y1=\"" +
                                     svg_number(12 + scale * top) + "\" x2=\"" +
                                     svg_number(12 + scale * (2 * k + 2 - left)) + "\" y2=\"" +
                                     svg_number(12 + scale * top) + "\"") == 1);
  CHECK(count(chains->in_page, "r=\"" + svg_number(scale) + "\"") == 4);
  CHECK(count(chains->in_page, "stroke-width=\"6.33\"") == 1); // 95 over 33 of 2.2
  packing.contacts[2].normal_force = 1000;
  CHECK(count(force_chains(packing)->in_page, "stroke-width=\"6.57\"") == 1); // as before
  for (const double y : {3.33, 3.34}) {                                       // half of 4 times 10/6
    packing.position[0].y = y;
    packing.contacts[0].branch.y = 0;
    CHECK(count(force_chains(packing)->in_page, "<line") == (y < 10.0 / 3 ? 3 : 2));
    CHECK(count(force_chains(packing)->in_page, "<circle") == (y < 10.0 / 3 ? 4 : 3));
  }
  packing.contacts[0].branch.y = -0.1; // its middle counts
  CHECK(count(force_chains(packing)->in_page, "<line") == 3);
}

TEST_CASE("force chains of more than 10,000 contacts are drawn without grains and weak contacts") {
  for (const std::size_t contacts : {10'000U, 10'001U}) {
    packing::Assembly packing = row();
    packing.contacts.assign(contacts, packing.contacts[0]);
    packing.contacts[0].normal_force = 100;
    const std::string picture = force_chains(packing)->in_page;
    CHECK(count(picture, "<line") == (contacts == 10'000 ? 10'000 : 1));
    CHECK(count(picture, "<circle") == (contacts == 10'000 ? 4 : 0));
    CHECK(count(picture, "stroke-width=\"9.00\"") == 1); // at most
  }
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
