// SPDX-License-Identifier: GPL-3.0-or-later
// The orders in which people ask compute pair/local for its values, known by the values themselves; and
// the contacts with walls that fix wall/gran writes. The packing rests in a box under its weight: what its
// contacts leave on each grain is the weight of that grain.
#include <granum/core/text.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"
#include "thresholds.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string grains = data_text("lammps_box.atoms");

/// The values of the file by their names: dist force fx fy fz p1 ... p10.
const std::vector<std::string> names{"id1", "id2", "dist", "force", "fx", "fy", "fz", "p1", "p2",
                                     "p3",  "p4",  "p5",   "p6",    "p7", "p8", "p9", "p10"};

std::vector<std::string> split(const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> out;
  for (std::string word; words >> word;)
    out.push_back(word);
  return out;
}

/// The contacts of the box with some of the values alone, in any order, as one compute beside the ids.
std::string contacts_with(const std::string& values, int digits = 17) {
  std::istringstream lines(data_text("lammps_box.contacts"));
  std::string out, line;
  const std::vector<std::string> wanted = split(values);
  while (std::getline(lines, line) && !line.starts_with("ITEM: ENTRIES"))
    out += line + "\n";
  out += "ITEM: ENTRIES index c_ids[1] c_ids[2]";
  for (std::size_t k = 1; k <= wanted.size(); ++k)
    out += " c_p[" + std::to_string(k) + "]";
  out += "\n";
  for (int row = 1; std::getline(lines, line); ++row) {
    const std::vector<std::string> fields = split(line);
    out += std::to_string(row) + " " + fields[0] + " " + fields[1];
    for (const std::string& name : wanted) {
      const auto at = std::find(names.begin(), names.end(), name) - names.begin();
      const std::string number = name == "0" ? "0" : fields[static_cast<std::size_t>(at)];
      out += " " + (digits == 17 ? number : short_text(*parse_number(number), digits));
    }
    out += "\n";
  }
  return out;
}

ImportedPacking read(const std::string& contact_text, const std::string& map = "") {
  return first_of(lammps_dump_format, grains, contact_text, {.columns = parse_column_map(map)});
}

std::string layout_refused(const std::string& contact_text) {
  return refusal_of(lammps_dump_format, grains, contact_text);
}

void check_normal_forces(const ImportedPacking& packing, const ImportedPacking& expected) {
  for (std::size_t k = 0; k < packing.assembly.contacts.size(); ++k)
    CHECK(packing.assembly.contacts[k].normal_force ==
          relative(expected.assembly.contacts[k].normal_force, 1e-12));
}

std::string read_as(const ImportedPacking& packing) {
  for (const ImportNote& note : packing.notes)
    if (note.finding == Finding::columns_told)
      return note.text;
  return "";
}

/// The same file by hand.
const std::string whole_map = "id1=c_ids[1],id2=c_ids[2],force=c_p[2],ftx=c_p[6],fty=c_p[7],ftz=c_p[8]";
const std::string all = "dist force fx fy fz p1 p2 p3 p4 p5 p6 p7 p8 p9 p10";

constexpr double weight = 2650.0 * 4 / 3 * std::numbers::pi * 0.5e-3 * 0.5e-3 * 0.5e-3 * 9.81; // [N]

} // namespace

TEST_CASE("LAMMPS layouts: every usual order of values gives the packing that a column map gives") {
  const ImportedPacking by_map = read(contacts_with(all), whole_map);
  REQUIRE(by_map.assembly.contacts.size() == 91);
  CHECK(read_as(by_map).empty());
  std::string not_used = " ";
  for (const ImportNote& note : by_map.notes)
    if (note.finding == Finding::not_used)
      not_used += note.text + ",";
  for (int k = 1; k <= 15; ++k) // the map has the force and p1 to p3
    CHECK((not_used.find(" c_p[" + std::to_string(k) + "],") == std::string::npos) ==
          (k == 2 || (6 <= k && k <= 8)));
  for (const std::string values :
       {"dist force fx fy fz p1 p2 p3", "dist force fx fy fz p1 p2 p3 p4", "force fx fy fz p1 p2 p3 p4",
        "dist force p1 p2 p3 p4", "force p1 p2 p3 p4", "dist 0 force fx fy fz p1 p2 p3 p4",
        "dist force p1 p2 p3 fx fy fz", "dist force fx fy fz p1 p2 p3 p4 p5 p6 p7",
        "dist force fx fy fz p1 p2 p3 p4 p5 p6 p7 p8", "dist force fx fy fz p1 p2 p3 p4 p5 p6 p7 p8 p9",
        all.c_str()}) {
    CAPTURE(values);
    const ImportedPacking packing = read(contacts_with(values));
    CHECK(packing.assembly == by_map.assembly);
    CHECK_FALSE(read_as(packing).empty());
    CHECK_FALSE(packing.has(Finding::tangential_unknown));
    CHECK(packing.has(Finding::forces_swapped) == (values == "dist force p1 p2 p3 fx fy fz"));
  }
  // without the scalar, forces are lengths of vectors
  for (const std::string values : {"fx fy fz p1 p2 p3", "fx fy fz p1 p2 p3 p4", "dist fx fy fz p1 p2 p3"}) {
    CAPTURE(values);
    check_normal_forces(read(contacts_with(values)), by_map);
  }
  // without tangential values they are unknown, without forces all are
  for (const std::string values :
       {"dist force", "force", "dist force fx fy fz", "force fx fy fz", "fx fy fz"}) {
    CAPTURE(values);
    const ImportedPacking packing = read(contacts_with(values));
    CHECK(packing.has(Finding::tangential_unknown));
    check_normal_forces(packing, by_map);
  }
  CHECK(read(contacts_with("dist")).has(Finding::forces_unknown));
}

TEST_CASE("LAMMPS layouts: reported with the columns, six digits, several computes, ids behind the values") {
  CHECK(read_as(read(contacts_with("dist force"))).find("c_p[1] to c_p[2] as dist force") !=
        std::string::npos);
  CHECK(read_as(read(contacts_with("fx fy fz p1 p2 p3 p4"))).find("c_p[1] to c_p[7] as fx fy fz p1 to p4") !=
        std::string::npos);
  const ImportedPacking rounded = read(contacts_with("dist force fx fy fz p1 p2 p3 p4", 6));
  CHECK(read_as(rounded).find("dist force fx fy fz p1 to p4") != std::string::npos);
  std::string apart = contacts_with("dist force fx fy fz p1 p2 p3 p4");
  apart = with(apart, "c_p[1] c_p[2] c_p[3]", "c_d c_f[1] c_f[2]");
  for (int k = 4; k <= 9; ++k)
    apart = with(apart, "c_p[" + std::to_string(k) + "]", "c_f[" + std::to_string(k - 1) + "]");
  CHECK(read(apart).assembly == read(contacts_with(all), whole_map).assembly);
  std::string behind = contacts_with("force id1 id2");
  behind = with(behind, "c_ids[1] c_ids[2] c_p[1] c_p[2] c_p[3]", "q r c_f c_i[1] c_i[2]");
  CHECK(read_as(read(behind)).find("c_f as force") != std::string::npos);
}

TEST_CASE("LAMMPS layouts: values of an unknown order are refused, with the option for a map") {
  // the scalar last, a distance that is none, a vector turned round its axes
  const std::string message = layout_refused(contacts_with("p1 p2 p3 p4 force"));
  CHECK(message.starts_with("c:10:"));
  CHECK(message.find("id1=") != std::string::npos);
  const std::string two = contacts_with("dist force");
  for (const std::string& wrong : {contacts_with("p4 force fx fy fz"), contacts_with("fy fz fx"),
                                   with(two, "\n1 1 2 ", "\n1 1 200 "), with(two, "\n1 1 2 ", "\n1 1.5 2 ")})
    CHECK(layout_refused(wrong) != "");
  CHECK(layout_refused(with(two, "\n1 1 2 ", "\n1 x 2 ")).find("c_ids[1]") != std::string::npos);
  CHECK(layout_refused(with(two, "\n1 1 2 ", "\n1 1 2 3 ")).starts_with("c:10:"));
}

TEST_CASE(
    "LAMMPS layouts: values that can be read in two ways are refused with both, and the maps that decide") {
  // one contact along (-1, 2, 0): a distance of 1 mm and a force of 2 mN look like a vector along it
  const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ",
                    box = "ITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n";
  const std::string two = head + "ATOMS\n2\n" + box + "ITEM: ATOMS id radius x y z\n1 0.0005 0.5 0.5 0.5\n" +
                          "2 0.0005 0.49955278640450004 0.49910557280900008 0.5\n";
  const auto one = [&](int values, const std::string& row) {
    std::string text = head + "ENTRIES\n1\n" + box + "ITEM: ENTRIES c_i[1] c_i[2]";
    for (int k = 1; k <= values; ++k)
      text += " c_p[" + std::to_string(k) + "]";
    return text + "\n1 2 " + row + "\n";
  };
  // the last three of twelve granular ones are the place of grain 1 from grain 2, of this sign
  const std::string granular = "0.002 8.9442719e-4 1.78885438e-3 0 0 0 0 0 0 0 0 0 0 ",
                    place = "4.4721359e-4 8.9442719e-4 0";
  CHECK(read_as(first_of(lammps_dump_format, two, one(16, granular + place)))
            .find("force fx fy fz p1 to p12") != std::string::npos);
  CHECK(refusal_of(lammps_dump_format, two, one(16, granular + "-4.4721359e-4 -8.9442719e-4 0")) != "");
  // What the positions say of a value counts to 1 %; from p8 on there are moments of rolling and twisting.
  const auto fits = [&](int values, const std::string& row) {
    return refusal_of(lammps_dump_format, two, one(values, row)).empty() ? 1 : 0;
  };
  const auto number = [](double x) { return exact_text(x) + " "; };
  const Vec3 along = (1 / std::sqrt(5.0)) * Vec3{1, 2, 0}, across = (1 / std::sqrt(5.0)) * Vec3{-2, 1, 0};
  const auto turned = [&](const Vec3& v, const Vec3& w, double x) {
    const Vec3 sum = v + x * w;
    return number(sum.x) + number(sum.y) + number(sum.z);
  };
  check_threshold(0.01, [&](double x) { return fits(3, turned(along, across, x)); });
  check_threshold(0.01, [&](double x) { return fits(6, turned(along, {}, 0) + turned(across, along, x)); });
  check_threshold(0.01 / 0.99, [&](double x) { return fits(4, number(1 + x) + turned(along, {}, 0)); });
  check_threshold(0.01 / 0.99, [&](double x) {
    return fits(7, turned(along, {}, 0) + turned(across, {}, 0) + number(1 + x));
  });
  check_threshold(0.01, [&](double x) {
    return first_of(lammps_dump_format, two, one(1, number(1e-3 * (1 + x)))).has(Finding::forces_unknown) ? 1
                                                                                                          : 0;
  });
  for (int extra = 7; extra <= 9; ++extra)
    for (int moment = 5; moment <= extra; ++moment) {
      std::string row = number(1) + turned(along, {}, 0) + "0 0 0 ";
      for (int k = 4; k <= extra; ++k)
        row += k == moment ? "1e-9 " : "0 ";
      CHECK(first_of(lammps_dump_format, two, one(4 + extra, row)).has(Finding::contact_moments) ==
            (moment > 7));
    }
  CHECK(refusal_of(lammps_dump_format, two, one(2, "7 -1")).find("force=c_p[2]") != std::string::npos);
  const std::string message = refusal_of(lammps_dump_format, two, one(6, "0.001 0.002 0 0 0 0"));
  for (const char* map : {"dist force p1 to p4", "id1=c_i[1],id2=c_i[2],force=c_p[2],ftx=c_p[3]",
                          "fx fy fz p1 p2 p3", "id1=c_i[1],id2=c_i[2],fnx=c_p[1]"})
    CHECK(message.find(map) != std::string::npos);
}

TEST_CASE("LAMMPS layouts: a frame without rows, and one in which nothing presses") {
  std::string none = contacts_with("dist force fx fy fz");
  none = with(none.substr(0, none.find("\n1 1 2 ") + 1), "ENTRIES\n91", "ENTRIES\n0");
  CHECK(read(none).assembly.contacts.empty());
  const ImportedPacking unloaded = read(contacts_with("dist 0 0 0 0"));
  CHECK(unloaded.assembly.contacts.size() == 91);
}

TEST_CASE("LAMMPS walls: grains and walls together leave each grain its weight") {
  const ImportedPacking packing = read(contacts_with("dist force fx fy fz p1 p2 p3 p4"));
  const packing::Assembly& a = packing.assembly;
  REQUIRE(a.grain_count() == 54);
  CHECK(a.wall_contacts.size() == 47);
  CHECK(packing.has(Finding::wall_contacts));
  double worst = 0;
  for (const packing::Residual& r : residuals(a))
    worst = std::max(worst, norm(r.force - Vec3{0, 0, weight}));
  CHECK(worst < 1e-8 * weight);
  for (const packing::Contact& c : a.wall_contacts) {
    CHECK(c.overlap == relative(a.radius[c.i] - norm(c.branch), 1e-12));
    CHECK(c.normal_force > 0);
    CHECK(std::abs(dot(c.tangential_force, c.branch)) <= 1e-12 * norm(c.branch) * c.normal_force);
  }
  // without contacts between grains the walls' are there as well
  CHECK(first_of(lammps_dump_format, grains).assembly.wall_contacts == a.wall_contacts);
}

TEST_CASE("LAMMPS walls: eight columns of another fix are no wall, and numbers must be numbers") {
  const auto walls = [](const std::string& text) {
    return first_of(lammps_dump_format, text).assembly.wall_contacts.size();
  };
  // the radius of the first grain at a wall of the third fix is not the grain's
  const std::string row = grains.substr(grains.find("\n1 1 0.0005") + 1);
  const std::string first = row.substr(0, row.find('\n'));
  const std::string but_last = first.substr(0, first.rfind(' '));
  const std::size_t third = walls(with(grains, first, but_last + " 0.0007"));
  CHECK((0 < third && third < 47));
  CHECK(refusal_of(lammps_dump_format, with(grains, first, but_last + " wide")).starts_with("g:10:"));
  // ids instead of ones, as older versions have it
  std::istringstream lines(grains);
  std::string older, line;
  while (std::getline(lines, line)) {
    std::vector<std::string> fields = split(line);
    if (fields.size() == 30 && fields[0] != "ITEM:")
      for (const std::size_t k : {6u, 14u, 22u})
        if (fields[k] == "1")
          fields[k] = fields[0];
    for (const std::string& field : fields)
      older += field + " ";
    older += "\n";
  }
  CHECK(walls(older) == 47);
}
