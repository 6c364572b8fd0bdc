// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/mercury/output.hpp>

#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string data = data_text("mercury_chain.data");
const std::string fstat = data_text("mercury_chain.fstat");
const std::string sheared_ab =
    "0 1 0 0.00149995 0.002 0.002 1e-07 0 0.0235294118 0.0114329834 1 0 0 0 1 0\n"
    "0 0 1 0.00149995 0.002 0.002 1e-07 0 0.0235294118 0.0114329834 -1 -0 -0 -0 -1 -0\n";
const std::string plain_ab = "0 1 0 0.00149995 0.002 0.002 1e-07 0 0.0235294118 0 1 0 0 0 0 0\n"
                             "0 0 1 0.00149995 0.002 0.002 1e-07 0 0.0235294118 0 -1 -0 -0 -0 -0 -0\n";

std::optional<ImportedPacking> read(const std::string& data_text_, const std::string& fstat_text) {
  MercuryOutput reader(text_source("d", data_text_), text_source("f", fstat_text));
  return reader.next();
}

std::string output_refused(const std::string& data_text_, const std::string& fstat_text = fstat) {
  return refusal([&] { (void)read(data_text_, fstat_text); });
}

} // namespace

TEST_CASE("MercuryDPM: two rows a pair become one contact, forces on the first grain of a row") {
  MercuryOutput reader(data_source("mercury_chain.data"), data_source("mercury_chain.fstat"));
  const auto packing = reader.next();
  REQUIRE(packing);
  check_chain(*packing, 1e-15, 1e-15);
  CHECK(packing->id == std::vector<long>{0, 1, 2});
  CHECK(packing->time == 0.0);
  const auto residual = residuals(packing->assembly);
  check_vector(residual[0].force, {-force_ab, 0, 0}, 1e-15);
  check_vector(residual[1].force, {force_ab, 0, -force_bc}, 1e-15);
  for (const Finding finding : {Finding::duplicated, Finding::one_sided, Finding::wall_contacts})
    CHECK_FALSE(packing->has(finding));
  CHECK(packing->has(Finding::boundary_unknown));
  CHECK_FALSE(reader.next());
}

TEST_CASE("MercuryDPM: the tangential force has its side, and mirror rows are checked") {
  const auto packing = read(data, with(fstat, plain_ab, sheared_ab));
  REQUIRE(packing);
  // the first row is the force on grain 1 by grain 0: so what 0 exerts on 1 points along +y
  check_vector(packing->assembly.contacts[0].tangential_force, {0, 0.0114329834, 0}, 1e-15);
  check_vector(residuals(packing->assembly)[1].force, {force_ab, 0.0114329834, -force_bc}, 1e-15);
  CHECK(
      output_refused(data, with(fstat, plain_ab, with(sheared_ab, "-0 -1 -0", "0 1 0"))).starts_with("f:5:"));
  CHECK(output_refused(data, with(fstat, plain_ab,
                                  with(plain_ab, "0 0 1 0.00149995 0.002 0.002 1e-07 0 0.0235294118",
                                       "0 0 1 0.00149995 0.002 0.002 1e-07 0 0.0245294118")))
            .starts_with("f:5:"));
}

TEST_CASE("MercuryDPM: a pair from one side only, and one from the same side twice, are reported") {
  const std::string one = plain_ab.substr(0, plain_ab.find('\n') + 1);
  const auto single = read(data, with(fstat, plain_ab, one));
  REQUIRE(single);
  check_chain(*single, 1e-15, 1e-15);
  CHECK(single->has(Finding::one_sided));
  const auto twice = read(data, with(fstat, plain_ab, one + one));
  REQUIRE(twice);
  CHECK(twice->assembly.contacts.size() == 2);
  CHECK(twice->has(Finding::one_sided));
  CHECK(twice->has(Finding::duplicated));
}

TEST_CASE("MercuryDPM: negative indices are walls, and no grains") {
  // grain 2 lies on a wall below it in z: the normal is printed from the grain to the wall
  const std::string row = "0 2 -3 0.0019999 0.002 0.0024999 1e-07 0 0.5 0.25 0 0 -1 1 0 0\n";
  for (const bool turned : {false, true}) {
    const auto packing = read(data, fstat + (turned ? with(row, "0 0 -1 1 0 0", "0 0 1 -1 0 0") : row));
    REQUIRE(packing);
    CHECK(packing->assembly.contacts.size() == 2);
    REQUIRE(packing->assembly.wall_contacts.size() == 1);
    const packing::Contact& wall = packing->assembly.wall_contacts[0];
    CHECK(wall.i == 2);
    CHECK(wall.j == 2);
    CHECK(wall.normal_force == 0.5);
    CHECK(wall.overlap == 1e-7);
    check_vector(wall.branch, {0, 0, -0.4999e-3}, 1e-15);
    check_vector(wall.tangential_force, {0.25, 0, 0}, 1e-15);
    CHECK(packing->has(Finding::wall_contacts));
  }
}

TEST_CASE("MercuryDPM: a pair through a face") {
  const std::string two = "2 0 0 0 0 0.004 0.004 0.004\n0.0004 0.002 0.002 0 0 0 0.0005 0 0 0 0 0 0 0\n"
                          "0.0034001 0.002 0.002 0 0 0 0.0005 0 0 0 0 0 0 0\n";
  const std::string head = fstat.substr(0, fstat.find("0 1 0"));
  const auto packing = read(two, head + "0 0 1 0.00390005 0.002 0.002 1e-07 0 0.0235294118 0 1 0 0 0 0 0\n");
  REQUIRE(packing);
  check_vector(packing->assembly.contacts[0].branch, {-0.9999e-3, 0, 0}, 1e-12);
  CHECK(packing->has(Finding::through_faces));
}

TEST_CASE("MercuryDPM: frames are joined by their time") {
  const auto at = [](std::string text, const std::string& first, const std::string& later) {
    return with(std::move(text), first, later);
  };
  const std::string data2 = data + at(data, "3 0 ", "3 0.1 ") + at(data, "3 0 ", "3 0.2 ");
  const std::string fstat2 = at(fstat, "# 0 1", "# 0.1 1") + at(fstat, "# 0 1", "# 0.2000001 1");
  MercuryOutput reader(text_source("d", data2), text_source("f", fstat2));
  const auto first = reader.next(), second = reader.next();
  REQUIRE((first && second));
  CHECK(first->time == 0.1);
  CHECK(first->step == 1);
  CHECK(second->time == 0.2);
  CHECK_FALSE(reader.next());
  CHECK(reader.skipped() == 1);
  CHECK(output_refused(data, at(fstat, "# 0 1", "# 7 1")) != "");
  MercuryOutput grains(text_source("d", data2));
  CHECK(grains.next()->has(Finding::contacts_unknown));
  CHECK(grains.next());
  CHECK(grains.next());
  CHECK_FALSE(grains.next());
}

TEST_CASE("MercuryDPM: each field that is wrong is refused with path and line") {
  const auto grain = [](const std::string& from, const std::string& to) {
    return output_refused(with(data, from, to));
  };
  const auto row = [](const std::string& from, const std::string& to) {
    return output_refused(data, with(fstat, from, to));
  };
  check_refused(grain, {{"3 0 0", "4 0 0", "d:4:"},
                        {"3 0 0", "x 0 0", "d:1:"},
                        {"3 0 0", "3 nan 0", "d:1:"},
                        {"3 0 0 0 0 0.004 0.004 0.004", "3 0 0 0 0.004 0.004", "d:1:"},
                        {"3 0 0 0 0 0.004 0.004 0.004", "3 0 0 0 0 0.004", "d:1:"},
                        {"3 0 0 0 0 0.004", "3 0 0 0 0 0", "d:1:"},
                        {"0.001 0.002", "0.001 0,002", "d:2:"},
                        {" 0.0005 ", " 0 ", "d:2:"},
                        {" 0.0005 ", " ", "d:2:"}});
  check_refused(row, {{"# 0.0005", "0.0005", "f:3:"},
                      {"# 0 1", "# t 1", "f:1:"},
                      {"0 1 0 0.0", "0 1 0.5 0.0", "f:4:"},
                      {"0 1 0 0.0", "0 3 0 0.0", "f:4:"},
                      {"0 1 0 0.0", "0 -1 0 0.0", "f:4:"},
                      {"0 1 0 0.0", "0 1 1 0.0", "f:4:"},
                      {" 0.0235294118 0 1 0 0 ", " inf 0 1 0 0 ", "f:4:"},
                      {" 1 0 0 0 0 0", " 2 0 0 0 0 0", "f:4:"},
                      {" 1 0 0 0 0 0", " 0 1 0 0 0 0", "f:4:"},
                      {" 1 0 0 0 0 0", " 1 0 0 0 0", "f:4:"}});
  CHECK(output_refused(data, fstat.substr(0, 6)) != "");
  CHECK(output_refused("").starts_with("f:7:"));
}
