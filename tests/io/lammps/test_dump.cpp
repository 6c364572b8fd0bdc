// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string atoms = data_text("lammps_chain.atoms");
const std::string contacts = data_text("lammps_chain.contacts");

LammpsDump dump(const std::string& atom_text, const std::string& contact_text, const std::string& map = "") {
  return LammpsDump(text_source("a", atom_text), text_source("c", contact_text),
                    {.columns = parse_column_map(map)});
}

std::string dump_refused(const std::string& atom_text, const std::string& contact_text = contacts,
                         const std::string& map = "") {
  return refusal([&] {
    LammpsDump reader = dump(atom_text, contact_text, map);
    while (reader.next())
      ;
  });
}

constexpr double ten_digits = 1e-8; // as printed, less two for the sums

/// The forces of the dump of atoms (columns fx fy fz) of the first frame.
const std::vector<Vec3> atom_forces{
    {-0.0235294118, -0.0114329834, 0}, {0.0235294118, 0.0114329834, -0.0665512265}, {0, 0, 0.0665512265}};

void check_residuals(const packing::Assembly& assembly, const std::vector<Vec3>& forces,
                     double tolerance = ten_digits) {
  const auto residual = residuals(assembly);
  REQUIRE(residual.size() == forces.size());
  for (std::size_t g = 0; g < forces.size(); ++g)
    check_vector(residual[g].force, forces[g], tolerance);
}

} // namespace

TEST_CASE("LAMMPS: the chain's forces and overlaps, with the side from the dump of atoms") {
  LammpsDump reader(data_source("lammps_chain.atoms"), data_source("lammps_chain.contacts"));
  const auto packing = reader.next();
  REQUIRE(packing);
  check_chain(*packing, 1e-12, 1e-8);
  CHECK(packing->id == std::vector<long>{1, 2, 3});
  CHECK(packing->assembly.cell == Mat3::diagonal(4.0000000000000001e-03, 4e-3, 4e-3));
  CHECK(packing->step == 0);
  CHECK_FALSE(packing->time);
  check_residuals(packing->assembly, atom_forces);
  for (const Finding finding : {Finding::law_unknown, Finding::history_unknown, Finding::stiffness_unknown,
                                Finding::viscous_forces, Finding::units_unknown, Finding::few_digits})
    CHECK(packing->has(finding));
  for (const Finding finding :
       {Finding::duplicated, Finding::unsorted, Finding::through_faces, Finding::forces_swapped,
        Finding::boundary_unknown, Finding::contacts_unknown})
    CHECK_FALSE(packing->has(finding));
}

TEST_CASE("LAMMPS: frames of both files are joined by their time step, others are passed over") {
  LammpsDump both = dump(atoms, contacts);
  REQUIRE(both.next());
  const auto second = both.next();
  REQUIRE(second);
  CHECK(second->step == 20);
  // p1-p3 and fx-fz of this dump of contacts; the dump of atoms has forces of half a step earlier
  check_residuals(
      second->assembly,
      {{-0.0218164849 + 1.59819847e-09, -0.0106741533 - 7.13857383e-09, -0.00207016934 + 1.99651101e-08},
       {0.0208082, 0.0102244, -0.0586027},
       {0.00100828, 0.000449762, 0.0606728}},
      1e-5);
  CHECK_FALSE(second->has(Finding::few_digits)); // nine are printed of numbers that need them
  CHECK_FALSE(both.next());
  CHECK(both.skipped() == 0);

  LammpsDump later = dump(with(atoms, "TIMESTEP\n0\n", "TIMESTEP\n10\n"), contacts);
  const auto only = later.next();
  REQUIRE(only);
  CHECK(only->step == 20);
  CHECK_FALSE(later.next());
  CHECK(later.skipped() == 2);

  CHECK(dump_refused(atoms, with(with(contacts, "\n0\n", "\n1\n"), "\n20\n", "\n21\n")).starts_with("c:22:"));
  LammpsDump again = dump(with(atoms, "TIMESTEP\n0\n", "TIMESTEP\n30\n"), contacts); // a restarted job
  const auto last = again.next();
  REQUIRE(last);
  CHECK(last->step == 20);
  CHECK_FALSE(again.next());
}

TEST_CASE("LAMMPS: the label of the contacts is the user's") {
  LammpsDump reader(data_source("lammps_chain.atoms"), data_source("lammps_label.contacts"));
  const auto packing = reader.next();
  REQUIRE(packing);
  check_chain(*packing, 2e-9, 1e-8); // twelve digits against ten
}

TEST_CASE("LAMMPS: a tilted box comes back from its bounds, with units and time") {
  LammpsDump reader(data_source("lammps_tilted.atoms"), data_source("lammps_tilted.contacts"));
  const auto packing = reader.next();
  REQUIRE(packing);
  check_chain(*packing, 1e-12, 1e-8);
  const Mat3& cell = packing->assembly.cell;
  CHECK(cell(0, 0) == relative(4e-3, 1e-15));
  CHECK(cell(0, 1) == 4e-4);
  CHECK(packing->assembly.volume() == relative(64e-9, 1e-15));
  CHECK(packing->time == 0.0);
  CHECK_FALSE(packing->has(Finding::units_unknown));
}

TEST_CASE("LAMMPS: a negative tilt, all three tilts, and a box of three edges") {
  const auto cell = [](const std::string& box) {
    const std::size_t from = atoms.find("ITEM: BOX"), to = atoms.find("ITEM: ATOMS");
    LammpsDump reader(text_source("a", atoms.substr(0, from) + box + atoms.substr(to)));
    return reader.next()->assembly.cell;
  };
  // edges 4 along x, y, z, corner (1, 2, 3), tilts xy, xz, yz = -1, 0.5, -0.25
  const Mat3 expected{{{4, -1, 0.5}, {0, 4, -0.25}, {0, 0, 4}}};
  CHECK(cell("ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 5.5 -1\n1.75 6 0.5\n3 7 -0.25\n") == expected);
  // xy, xz = -1, -0.5: the lower bound is that of both together
  CHECK(cell("ITEM: BOX BOUNDS xy xz yz pp pp pp\n-0.5 5 -1\n1.75 6 -0.5\n3 7 -0.25\n") ==
        Mat3{{{4, -1, -0.5}, {0, 4, -0.25}, {0, 0, 4}}});
  CHECK(cell("ITEM: BOX BOUNDS abc origin pp pp pp\n4 0 0 1\n-1 4 0 2\n0.5 -0.25 4 3\n") == expected);
}

TEST_CASE("LAMMPS: a pair through a face, its ids the other way round") {
  LammpsDump reader(data_source("lammps_face.atoms"), data_source("lammps_face.contacts"));
  const auto packing = reader.next();
  REQUIRE(packing);
  REQUIRE(packing->assembly.contacts.size() == 1);
  const packing::Contact& c = packing->assembly.contacts[0];
  check_vector(c.branch, {-0.9999e-3, 0, 0}, 1e-12);
  CHECK(c.normal_force == force_ab);
  CHECK(c.overlap == relative(1e-7, 1e-8));
  CHECK(packing->has(Finding::through_faces));
  check_residuals(packing->assembly, {{force_ab, 0.0114329834, 0}, {-force_ab, -0.0114329834, 0}});
}

TEST_CASE("LAMMPS: without branches the nearest image of the tilted cell is taken") {
  // Grain 1 near the lower face y = 0, grain 2 near the upper one: its image lies one tilted edge lower.
  const std::string box = "ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 0.0044 0.0004\n0 0.004 0\n0 0.004 0\n";
  const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ";
  const std::string a =
      head + "ATOMS\n2\n" + box +
      "ITEM: ATOMS id radius x y z\n1 0.0005 0.002 0.0004 0.002\n2 0.0005 0.0024 0.0034001 0.002\n";
  const std::string c = head + "ENTRIES\n1\n" + box + "ITEM: ENTRIES id1 id2 force\n1 2 0.0235294118\n";
  LammpsDump reader = dump(a, c);
  const auto packing = reader.next();
  REQUIRE(packing);
  check_vector(packing->assembly.contacts[0].branch, {0, -0.9999e-3, 0}, 1e-12);
  CHECK(packing->has(Finding::tangential_unknown));

  CHECK(dump_refused(with(a, "pp pp pp", "pp ff pp"), c).starts_with("c:10:"));
}

TEST_CASE("LAMMPS: coordinates wrapped, unwrapped, or fractions of the box") {
  const auto place = [](const std::string& heading, const std::string& values) {
    std::string text = with(atoms, " x y z vx", " " + heading + " vx");
    text = with(text, "0.001 0.002 0.002", values);
    LammpsDump reader(text_source("a", text));
    return reader.next()->assembly.position[0];
  };
  CHECK(place("xu yu zu", "0.009 0.002 -0.002") == Vec3{0.009, 0.002, -0.002});
  check_vector(place("xs ys zs", "0.25 0.5 0.75"), {1e-3, 2e-3, 3e-3}, 1e-15);
  check_vector(place("xsu ysu zsu", "1.25 0.5 0.75"), {5e-3, 2e-3, 3e-3}, 1e-15);
}

TEST_CASE("LAMMPS: sections in another order, and unknown ones, change nothing") {
  const std::string a =
      "ITEM: COLOURS\nred\ngreen\nITEM: BOX BOUNDS pp ff ss\n0 4\n0 4\n0 4\nITEM: ATOMS z y x id "
      "diameter\n2 2 1 7 1\n2 2 2 5 1\nITEM: NUMBER OF ATOMS\n2\nITEM: TIMESTEP\n4\n";
  LammpsDump reader(text_source("a", a + a));
  const auto packing = reader.next();
  REQUIRE(packing);
  CHECK(packing->id == std::vector<long>{5, 7});
  CHECK(packing->assembly.position == std::vector<Vec3>{{2, 2, 2}, {1, 2, 2}});
  CHECK(packing->assembly.radius == std::vector<double>{0.5, 0.5});
  CHECK(packing->periodic == std::array<bool, 3>{true, false, false});
  CHECK(packing->has(Finding::contacts_unknown));
  CHECK(reader.next());
  CHECK_FALSE(reader.next());
}

TEST_CASE("LAMMPS: other units are converted to SI, also if only one file states them") {
  const std::string cgs = "ITEM: UNITS\ncgs\n" + atoms;
  LammpsDump reader = dump(cgs, contacts);
  const auto packing = reader.next();
  REQUIRE(packing);
  CHECK(packing->assembly.radius[0] == relative(0.5e-5, 1e-15));
  CHECK(packing->assembly.contacts[0].normal_force == relative(force_ab * 1e-5, 1e-15));
  LammpsDump si = dump(atoms, contacts);
  const Vec3 across = si.next()->assembly.contacts[0].tangential_force;
  REQUIRE(norm(across) > 0);
  check_vector(packing->assembly.contacts[0].tangential_force, 1e-5 * across, 1e-15);
  CHECK(norm(packing->assembly.contacts[0].branch) == relative(0.9999e-5, 1e-12));
  CHECK(dump_refused("ITEM: UNITS\nlj\n" + atoms).find("'lj'") != std::string::npos);
}

TEST_CASE(
    "LAMMPS: normal and tangential force in the other order are distinguished by the lines of centres") {
  const std::string head =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n2\nITEM: BOX BOUNDS pp pp pp\n0 0.004\n0 "
      "0.004\n0 0.004\nITEM: ENTRIES c_cl[1] c_cl[2] c_cp[1] c_cp[2] c_cp[3] c_cp[4] c_cp[5] "
      "c_cp[6] c_cp[7] c_cp[8] \n";
  const std::string n1 = "-0.0235294118 0 0", t1 = "0 -0.0114329834 0", n2 = "0 0 -0.0665512265",
                    t2 = "0 0 0";
  const std::string ab = "1 2 0.0009999 0.0235294118 ", bc = "2 3 0.0009998 0.0665512265 ";
  LammpsDump as_documented = dump(atoms, head + ab + n1 + " " + t1 + "\n" + bc + n2 + " " + t2 + "\n");
  LammpsDump swapped = dump(atoms, head + ab + t1 + " " + n1 + "\n" + bc + t2 + " " + n2 + "\n");
  const auto first = as_documented.next(), second = swapped.next();
  REQUIRE((first && second));
  CHECK(first->assembly == second->assembly);
  check_residuals(second->assembly, atom_forces);
  CHECK_FALSE(first->has(Finding::forces_swapped));
  CHECK(second->has(Finding::forces_swapped));
  // on grain 2 instead of grain 1: refused rather than turned round
  CHECK(
      dump_refused(atoms, head + ab + "0.0235294118 0 0 " + t1 + "\n" + bc + "0 0 0.0665512265 " + t2 + "\n")
          .starts_with("c:10:"));
}

TEST_CASE("LAMMPS: a column map overrides the names, and forces as one vector are split") {
  const std::string map =
      "id1=c_pl[1],id2=c_pl[2],fx=c_cp[3],fy=c_cp[4],fz=c_cp[5],dx=c_cp[15],dy=c_cp[16],dz=c_cp[17]";
  LammpsDump reader = dump(atoms, contacts, map);
  const auto packing = reader.next();
  REQUIRE(packing);
  check_chain(*packing, 1e-12, 1e-8);
  CHECK(packing->assembly.contacts[0].tangential_force == Vec3{});
  CHECK(dump_refused(atoms, contacts, "id1=c_pl[1],id2=c_pl[9]").starts_with("c:9:"));
  CHECK(dump_refused(atoms, contacts, "id1=c_pl[1]").starts_with("c:9:"));
  CHECK(dump_refused(atoms, contacts, "radius=c_r").starts_with("a:9:"));
}

TEST_CASE("LAMMPS: rows out of order, twice, and neighbours without contact") {
  const std::string row1 =
      contacts.substr(contacts.find("1 1 2 1 1"), contacts.find("2 2 3 1 1") - contacts.find("1 1 2 1 1"));
  const std::string first = contacts.substr(0, contacts.find("ITEM: TIMESTEP", 1));
  LammpsDump reader = dump(atoms, with(first, "ENTRIES\n2\n", "ENTRIES\n3\n") + row1);
  const auto packing = reader.next();
  REQUIRE(packing);
  check_chain(*packing, 1e-12, 1e-8);
  CHECK(packing->has(Finding::duplicated));
  CHECK(packing->has(Finding::unsorted));
  CHECK(dump_refused(atoms, with(first, "ENTRIES\n2\n", "ENTRIES\n3\n") +
                                with(row1, "0.0235294118 -0.0235294118", "0.0235 -0.0235"))
            .starts_with("c:12:"));

  const std::string apart = with(with(atoms, "0.0019999 0.002 0.002 ", "0.002001 0.002 0.002 "), "", "");
  LammpsDump open = dump(
      apart,
      with(with(contacts, "0.0235294118 -0.0235294118 0 0 0 -0.0114329834 0 0.0114329834", "0 0 0 0 0 0 0 0"),
           "-0.0009999 0 0", "-0.001001 0 0"));
  const auto one = open.next();
  REQUIRE(one);
  CHECK(one->assembly.contacts.size() == 1);
  CHECK(one->has(Finding::open_contacts));
}

TEST_CASE("LAMMPS: each field of the grains that is wrong is refused with path and line") {
  const auto atom = [](const std::string& from, const std::string& to) {
    return dump_refused(with(atoms, from, to));
  };
  check_refused(atom, {{"id type", "ID type", "a:9:"},
                       {"radius x", "r x", "a:9:"},
                       {" x y z ", " x y q ", "a:9:"},
                       {"1 1 0.0005", "1.5 1 0.0005", "a:10:"},
                       {"1 1 0.0005", "1.23457e+06 1 0.0005", "a:10:"},
                       {"1 1 0.0005", "2 1 0.0005", "a:11:"},
                       {"1 1 0.0005", "1 1 0", "a:10:"},
                       {"1 1 0.0005", "1 1 -0.0005", "a:10:"},
                       {"1 1 0.0005", "1 1 nan", "a:10:"},
                       {"0.001 0.002", "0.001x 0.002", "a:10:"},
                       {"0.001 0.002", "inf 0.002", "a:10:"},
                       {"1 1 0.0005", "1 1 1 0.0005", "a:10:"},
                       {"ATOMS\n3", "ATOMS\n4", "a:13:"},
                       {"ATOMS\n3", "ATOMS\n2", "a:12:"},
                       {"ATOMS\n3", "ATOMS\n-3", "a:4:"},
                       {"ATOMS\n3", "ATOMS\n0", "a:10:"},
                       {"ATOMS\n3", "ATOMS\n999999999999", "a:13:"},
                       {"TIMESTEP\n0", "TIMESTEP\nx", "a:2:"},
                       {"4.0000000000000001e-03", "0", ""},
                       {"4.0000000000000001e-03", "1e400", "a:6:"},
                       {"4.0000000000000001e-03", "1 2", "a:6:"},
                       {"ITEM: TIMESTEP", "ITEM: TIMESTAMP", ""},
                       {"ITEM: ATOMS", "ITEM: MOTES", ""}});
  CHECK(dump_refused("") != "");
  CHECK(dump_refused("hello\n").starts_with("a:1:"));
  CHECK(dump_refused(atoms.substr(0, 40)) != "");
  CHECK(dump_refused(atoms.substr(0, atoms.find("2 1 0.0005"))).starts_with("a:10:"));
}

TEST_CASE("LAMMPS: each field of the contacts that is wrong is refused with path and line") {
  const auto contact = [](const std::string& from, const std::string& to) {
    return dump_refused(atoms, with(contacts, from, to));
  };
  check_refused(contact, {{"c_pl[2]", "c_pl[7]", "c:10:"},
                          {"1 1 2 1 1", "1 1 4 1 1", "c:10:"},
                          {"1 1 2 1 1", "1 1 -2 1 1", "c:10:"},
                          {"1 1 2 1 1", "1 x 2 1 1", "c:10:"},
                          {"0.0235294118 -", "nan -", "c:10:"},
                          {"-0.0235294118 0", "- 0", "c:10:"},
                          {"-0.0114329834 0", "1e999 0", "c:10:"},
                          {"-0.0009999 0 0", "-0.0009999 0 1e", "c:10:"},
                          {"-0.0009999 0 0", "-0.0009999 0", "c:10:"},
                          {"-0.0009999 0 0", "0.0009999 0 0", "c:10:"},
                          {"1 1 2 1 1 0.0009999", "1 1 1 1 1 0.0009999", "c:10:"},
                          {"ENTRIES\n2", "ENTRIES\n3", "c:12:"},
                          {"ENTRIES\n2", "ENTRIES\nmany", "c:4:"}});
  CHECK(dump_refused(contacts, atoms).starts_with("a:9:")); // the two files the wrong way round
  const std::string near =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS pp pp pp\n0 4e-3\n0 4e-3\n0 4e-3\n"
      "ITEM: ENTRIES id1 id2\n2 2\n";
  CHECK(dump_refused(atoms, near).starts_with("c:10:"));
}
