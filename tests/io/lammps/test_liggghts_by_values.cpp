// SPDX-License-Identifier: GPL-3.0-or-later
// compute pair/gran/local of LIGGGHTS writes what was asked for in an order of its own: told by the values.
#include <granum/core/text.hpp>
#include <granum/io/lammps/files.hpp>

#include "io/import_support.hpp"
#include "thresholds.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string of_liggghts =
    "ITEM: TIMESTEP\n1000\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS pp pp pp\n0 0.01\n0 "
    "0.01\n0 0.01\nITEM: ATOMS id type x y z radius\n1 1 0.001 0.005 0.005 0.0005\n2 1 "
    "0.00199 0.005 0.005 0.0005\n3 1 0.000012 0.005 0.005 0.0005\n";

ImportedPacking read(int values, const std::string& first, const std::string& second,
                     const std::string& map = "") {
  std::string text = "ITEM: TIMESTEP\n1000\nITEM: NUMBER OF ENTRIES\n2\nITEM: BOX BOUNDS pp pp pp\n0 0.01\n0 "
                     "0.01\n0 0.01\nITEM: ENTRIES";
  for (int k = 1; k <= values; ++k)
    text += " c_fc[" + std::to_string(k) + "]";
  text += "\n" + first + "\n" + second + "\n";
  return first_of(lammps_dump_format, of_liggghts, text, {.columns = parse_column_map(map)});
}

const std::string pos1 = "0.001 0.005 0.005 0.00199 0.005 0.005 ",
                  pos2 = "0.001 0.005 0.005 0.000012 0.005 0.005 ";
const std::string ids1 = "1 2 0 ", ids2 = "1 3 0 ";

void check_forces(const ImportedPacking& p) {
  REQUIRE(p.assembly.contacts.size() == 2);
  CHECK(p.assembly.contacts[0].normal_force == doctest::Approx(0.0123));
  CHECK(p.assembly.contacts[1].normal_force == doctest::Approx(0.0164));
  CHECK(norm(p.assembly.contacts[1].tangential_force - Vec3{0, -0.0004, 0}) < 1e-12);
  CHECK_FALSE(p.has(Finding::tangential_unknown));
}

} // namespace

TEST_CASE("LIGGGHTS: pos id force, id force, total forces and their parts, with following columns") {
  check_forces(read(12, pos1 + ids1 + "-0.0123 0 0", pos2 + ids2 + "0.0164 0.0004 0"));
  check_forces(read(6, ids1 + "-0.0123 0 0", ids2 + "0.0164 0.0004 0"));
  const std::string vel = "1 2 3 4 5 6 ";
  check_forces(read(18, pos1 + vel + ids1 + "-0.0123 0 0", pos2 + vel + ids2 + "0.0164 0.0004 0"));
  const std::string f1 = "-0.0123 0 0 -0.0123 0 0 0 0 0 ", f2 = "0.0164 0.0004 0 0.0164 0 0 0 0.0004 0 ";
  const ImportedPacking twenty =
      read(20, pos1 + ids1 + f1 + "3e-8 1.004e-5", pos2 + ids2 + f2 + "4e-8 1.2e-5");
  check_forces(twenty);
  CHECK(twenty.assembly.contacts[0].overlap == doctest::Approx(1.004e-5)); // the last column
  CHECK(twenty.assembly.contacts[1].overlap == doctest::Approx(1.2e-5));
  check_forces(read(12, ids1 + f1, ids2 + f2));
  check_forces(read(9, ids1 + f1.substr(12), ids2 + f2.substr(16))); // force_normal force_tangential
}

TEST_CASE("LIGGGHTS: positions, forces and overlaps agree with their columns to 1 %") {
  // The second force has a part x across; the sum is that of both parts, but for y; the overlap is off by z.
  const auto read_with = [](double x, double y = 0, double z = 0, double off = 0) {
    const auto text = [](double number) { return granum::exact_text(number) + " "; };
    const auto row = [&](const std::string& ids, double f) {
      return ids + text(f + y * f) + text(0.5 * f) + "0 " + text(f) + text(f * x) + "0 " +
             text(0.5 * f * off) + text(0.5 * f) + "0 " + text(1.1e-5 * (1 + z) + (f > 0 ? 1e-6 : -1e-6));
    };
    return read(13, row(ids1, -0.0123), row(ids2, 0.0164));
  };
  const auto words = [](const ImportedPacking& packing) {
    for (const ImportNote& note : packing.notes)
      if (note.finding == Finding::columns_told)
        return note.text;
    return std::string();
  };
  const auto has_parts = [&](const ImportedPacking& packing) {
    return words(packing).find("force_tangential") == std::string::npos ? 0 : 1;
  };
  CHECK(words(read_with(0)).find("c_fc[1] to c_fc[13] as id force force_normal force_tangential ... delta") !=
        std::string::npos);
  check_threshold(0.01, [&](double x) { return has_parts(read_with(x, 0, 0, 0)); });
  check_threshold(0.011281, [&](double y) { return has_parts(read_with(0, y)); });
  check_threshold(0.01, [&](double off) { return has_parts(read_with(0, 0, 0, off)); });
  check_threshold(0.01, [&](double z) {
    return std::abs(read_with(0, 0, z).assembly.contacts[0].overlap - 1e-5) > 1e-8 ? 1 : 0;
  });
  const std::string pos = pos1 + ids1 + "-0.0123 0 0", vel = pos1 + "1 2 3 4 5 6 " + ids1 + "-0.0123 0 0";
  CHECK(words(read(12, pos, pos2 + ids2 + "0.0164 0 0")).find("as pos id force_normal") != std::string::npos);
  CHECK(words(read(18, vel, pos2 + "1 2 3 4 5 6 " + ids2 + "0.0164 0 0")).find("as pos vel id force") !=
        std::string::npos);
}

TEST_CASE("LIGGGHTS: columns that fit no order are refused, and read with a map") {
  const std::string row1 = "1 2 0 0.0123 0 0", row2 = "1 3 0 -0.0164 0.0004 0";
  const std::string map = "id1=c_fc[1],id2=c_fc[2],fx=c_fc[4],fy=c_fc[5],fz=c_fc[6]";
  REQUIRE(refusal([&] { (void)read(6, row1, row2); }).find(map) != std::string::npos);
  CHECK(read(6, row1, row2, map).assembly.contacts.size() == 2);
  CHECK(refusal([] { (void)read(6, "1 9 0 -0.0123 0 0", "1 3 0 0.0164 0 0"); }).find("c:") == 0);
}
