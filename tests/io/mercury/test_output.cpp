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

ImportedPacking read(const std::string& rows, const std::string& grains = data) {
  return first_of(mercury_format, grains, rows);
}
std::string output_refused(const std::string& rows) { return refusal_of(mercury_format, data, rows); }

} // namespace

TEST_CASE("MercuryDPM: two rows a pair become one contact, forces on the first grain of a row") {
  const PackingFrames frames = states_of(mercury_format, data, fstat);
  const auto packing = frames.next();
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
  CHECK_FALSE(frames.next());
  CHECK(packing->rounding.force == 0);
  std::string short_forces = fstat;
  for (const auto& [all, six] : {std::pair("0.0235294118", "0.0235294"), {"0.0665512265", "0.0665512"}})
    while (short_forces.find(all) != std::string::npos)
      short_forces = with(short_forces, all, six);
  CHECK(read(short_forces).rounding.force == relative(0.5e-5, 1e-12));
}

TEST_CASE("MercuryDPM: the tangential force has its side, and mirror rows are checked") {
  const ImportedPacking packing = read(with(fstat, plain_ab, sheared_ab));
  // the first row is the force on grain 1 by grain 0: so what 0 exerts on 1 points along +y
  check_vector(packing.assembly.contacts[0].tangential_force, {0, 0.0114329834, 0}, 1e-15);
  check_vector(residuals(packing.assembly)[1].force, {force_ab, 0.0114329834, -force_bc}, 1e-15);
  const std::string turned = with(sheared_ab, "-0 -1 -0", "0 1 0"),
                    other = with(plain_ab, "0.0235294118 0 -1", "0.0245294118 0 -1");
  for (const std::string& pair : {turned, other})
    CHECK(output_refused(with(fstat, plain_ab, pair)).starts_with("c:5:"));
}

TEST_CASE("MercuryDPM: a pair from one side only, and one from the same side twice, are reported") {
  const std::string one = plain_ab.substr(0, plain_ab.find('\n') + 1);
  const ImportedPacking single = read(with(fstat, plain_ab, one)),
                        twice = read(with(fstat, plain_ab, one + one));
  check_chain(single, 1e-15, 1e-15);
  check_chain(twice, 1e-15, 1e-15);
  CHECK((single.has(Finding::one_sided) && twice.has(Finding::one_sided)));
  CHECK(twice.has(Finding::duplicated));
}

TEST_CASE("MercuryDPM: a pair through a face") {
  const std::string two = "2 0 0 0 0 0.004 0.004 0.004\n0.0004 0.002 0.002 0 0 0 0.0005 0 0 0 0 0 0 0\n"
                          "0.0034001 0.002 0.002 0 0 0 0.0005 0 0 0 0 0 0 0\n";
  const std::string head = fstat.substr(0, fstat.find("0 1 0"));
  const ImportedPacking packing =
      read(head + "0 0 1 0.00390005 0.002 0.002 1e-07 0 0.0235294118 0 1 0 0 0 0 0\n", two);
  check_vector(packing.assembly.contacts[0].branch, {-0.9999e-3, 0, 0}, 1e-12);
  CHECK(packing.has(Finding::through_faces));
}

TEST_CASE("MercuryDPM: frames are joined by their time") {
  const std::string data2 = data + with(data, "3 0 ", "3 0.1 ") + with(data, "3 0 ", "3 0.2 ");
  const std::string fstat2 = with(fstat, "# 0 1", "# 0.1 1") + with(fstat, "# 0 1", "# 0.2000001 1");
  const PackingFrames reader = states_of(mercury_format, data2, fstat2);
  const auto first = reader.next(), second = reader.next();
  REQUIRE((first && second));
  CHECK(first->time == 0.1);
  CHECK(first->step == 1);
  CHECK(second->time == 0.2);
  CHECK_FALSE(reader.next());
  CHECK(reader.skipped() == 1);
  CHECK(output_refused(with(fstat, "# 0 1", "# 7 1")) != "");
  const PackingFrames grains = states_of(mercury_format, data2);
  CHECK(grains.next()->has(Finding::contacts_unknown));
  CHECK(grains.next());
  CHECK(grains.next());
  CHECK_FALSE(grains.next());
}

TEST_CASE("MercuryDPM: each field that is wrong is refused with path and line") {
  const std::vector<Wrong> of_grains{
      {"3 0 0", {"4 0 0"}, "g:4:"},
      {"3 0 0", {"x 0 0", "3 nan 0"}, "g:1:"},
      {"3 0 0 0 0 0.004 0.004 0.004", {"3 0 0 0 0.004 0.004", "3 0 0 0 0 0.004"}, "g:1:"},
      {"3 0 0 0 0 0.004", {"3 0 0 0 0 0"}, "g:1:"},
      {"0.001 0.002", {"0.001 0,002"}, "g:2:"},
      {" 0.0005 ", {" 0 ", " "}, "g:2:"}};
  const std::vector<Wrong> of_contacts{
      {"# 0.0005", {"0.0005"}, "c:3:"},
      {"# 0 1", {"# t 1"}, "c:1:"},
      {"0 1 0 0.0", {"0 1 0.5 0.0", "0 3 0 0.0", "0 -1 0 0.0", "0 1 1 0.0"}, "c:4:"},
      {" 0.0235294118 0 1 0 0 ", {" inf 0 1 0 0 "}, "c:4:"},
      {" 1 0 0 0 0 0", {" 2 0 0 0 0 0", " 0 1 0 0 0 0", " 1 0 0 0 0"}, "c:4:"}};
  check_refused(mercury_format, data, fstat, of_grains, of_contacts);
  CHECK(output_refused(fstat.substr(0, 6)) != "");
  CHECK(refusal_of(mercury_format, "", fstat).starts_with("c:7:"));
}
