// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::string atoms = data_text("lammps_chain.atoms");
const std::string contacts = data_text("lammps_chain.contacts");

std::string dump_refused(const std::string& grains, const MaybeText& contact_text = contacts,
                         const std::string& map = "") {
  return refusal_of(lammps_dump_format, grains, contact_text, {.columns = parse_column_map(map)});
}
ImportedPacking first(const std::string& grains, const MaybeText& contact_text = {},
                      const std::string& map = "") {
  return first_of(lammps_dump_format, grains, contact_text, {.columns = parse_column_map(map)});
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
  const ImportedPacking packing = first(atoms, contacts);
  check_chain(packing, 1e-12, 1e-8);
  CHECK(packing.id == std::vector<long>{1, 2, 3});
  CHECK(packing.assembly.cell == Mat3::diagonal(4e-3, 4e-3, 4e-3));
  CHECK(packing.step == 0);
  CHECK_FALSE(packing.time);
  check_residuals(packing.assembly, atom_forces);
  for (const Finding finding : {Finding::law_unknown, Finding::history_unknown, Finding::stiffness_unknown,
                                Finding::viscous_forces, Finding::units_unknown, Finding::few_digits})
    CHECK(packing.has(finding));
  for (const Finding finding :
       {Finding::duplicated, Finding::unsorted, Finding::through_faces, Finding::forces_swapped,
        Finding::boundary_unknown, Finding::contacts_unknown})
    CHECK_FALSE(packing.has(finding));
  // a map may take the two vectors of forces for each other
  const ImportedPacking swapped = first(
      atoms, contacts,
      "id1=c_pl[1],id2=c_pl[2],force=c_cp[2],fnx=c_cp[6],fny=c_cp[7],fnz=c_cp[8],ftx=c_cp[3],fty=c_cp[4],"
      "ftz=c_cp[5],dx=c_cp[15],dy=c_cp[16],dz=c_cp[17]");
  CHECK(swapped.has(Finding::forces_swapped));
  CHECK(swapped.assembly == packing.assembly);
  // the label of the contacts is the user's: dump_modify label
  const std::string own = with(with(contacts, "ENTRIES", "CONTACTS"), "ITEM: ENTRIES", "ITEM: CONTACTS");
  CHECK(first(atoms, own).assembly == packing.assembly);
}

TEST_CASE("LAMMPS: frames of both files are joined by their time step, others are passed over") {
  const auto dump = [](const std::string& grains) { return states_of(lammps_dump_format, grains, contacts); };
  const PackingFrames both = dump(atoms);
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

  for (const int step : {10, 30}) { // 30: of a job that was restarted
    const PackingFrames later =
        dump(with(atoms, "TIMESTEP\n0\n", "TIMESTEP\n" + std::to_string(step) + "\n"));
    const auto only = later.next();
    REQUIRE(only);
    CHECK(only->step == 20);
    CHECK_FALSE(later.next());
    CHECK((step == 30 || later.skipped() == 2));
  }
  const PackingFrames alone = states_of(lammps_dump_format, atoms.substr(0, atoms.find("ITEM: TIMESTEP", 1)));
  CHECK(alone.next());
  CHECK_FALSE(alone.next());
  CHECK(dump_refused(atoms, with(with(contacts, "\n0\n", "\n1\n"), "\n20\n", "\n21\n")).starts_with("c:22:"));
}

TEST_CASE("LAMMPS: a negative tilt, all three tilts, and a box of three edges") {
  const auto cell = [](const std::string& box) {
    const std::size_t from = atoms.find("ITEM: BOX"), to = atoms.find("ITEM: ATOMS");
    return first(atoms.substr(0, from) + box + atoms.substr(to)).assembly.cell;
  };
  // edges 4 along x, y, z, corner (1, 2, 3), tilts xy, xz, yz = -1, 0.5, -0.25
  const Mat3 expected{{{4, -1, 0.5}, {0, 4, -0.25}, {0, 0, 4}}};
  CHECK(cell("ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 5.5 -1\n1.75 6 0.5\n3 7 -0.25\n") == expected);
  // xy, xz = -1, -0.5: the lower bound is that of both together
  CHECK(cell("ITEM: BOX BOUNDS xy xz yz pp pp pp\n-0.5 5 -1\n1.75 6 -0.5\n3 7 -0.25\n") ==
        Mat3{{{4, -1, -0.5}, {0, 4, -0.25}, {0, 0, 4}}});
  CHECK(cell("ITEM: BOX BOUNDS abc origin pp pp pp\n4 0 0 1\n-1 4 0 2\n0.5 -0.25 4 3\n") == expected);
}

TEST_CASE("LAMMPS: without branches the nearest image of the tilted cell is taken") {
  // Grain 1 near the lower face y = 0, grain 2 near the upper one: its image lies one tilted edge lower.
  const std::string box = "ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 0.0044 0.0004\n0 0.004 0\n0 0.004 0\n";
  const std::string head = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ";
  const std::string a =
      head + "ATOMS\n2\n" + box +
      "ITEM: ATOMS id radius x y z\n1 0.0005 0.002 0.0004 0.002\n2 0.0005 0.0024 0.0034001 0.002\n";
  const std::string c = head + "ENTRIES\n1\n" + box + "ITEM: ENTRIES id1 id2 force\n1 2 0.0235294118\n";
  const ImportedPacking packing = first(a, c);
  check_vector(packing.assembly.contacts[0].branch, {0, -0.9999e-3, 0}, 1e-12);
  CHECK(packing.has(Finding::tangential_unknown));
  CHECK(packing.has(Finding::through_faces));

  CHECK(dump_refused(with(a, "pp pp pp", "pp ff pp"), c).starts_with("c:10:"));
}

TEST_CASE("LAMMPS: sections in another order, and unknown ones, change nothing") {
  const std::string a =
      "ITEM: COLOURS\nred\ngreen\nITEM: BOX BOUNDS pp ff ss\n0 4\n0 4\n0 4\nITEM: ATOMS z y x id "
      "diameter\n2 2 1 7 1\n2 2 2 5 1\nITEM: NUMBER OF ATOMS\n2\nITEM: TIMESTEP\n4\n";
  const PackingFrames frames = states_of(lammps_dump_format, a + a);
  const auto packing = frames.next();
  REQUIRE(packing);
  CHECK(packing->id == std::vector<long>{5, 7});
  CHECK(packing->assembly.position == std::vector<Vec3>{{2, 2, 2}, {1, 2, 2}});
  CHECK(packing->assembly.radius == std::vector<double>{0.5, 0.5});
  CHECK(packing->periodic == std::array<bool, 3>{true, false, false});
  CHECK(packing->has(Finding::contacts_unknown));
  CHECK(frames.next());
  CHECK_FALSE(frames.next());
}

TEST_CASE("LAMMPS: units that one file states are those of both") {
  const ImportedPacking cgs = first("ITEM: UNITS\ncgs\n" + atoms, contacts);
  CHECK(cgs.assembly.radius[0] == relative(0.5e-5, 1e-15));
  CHECK(cgs.assembly.contacts[0].normal_force == relative(force_ab * 1e-5, 1e-15));
  CHECK(norm(cgs.assembly.contacts[0].branch) == relative(0.9999e-5, 1e-12));
  CHECK_FALSE(cgs.has(Finding::units_differ));
  std::string centimetres = contacts;
  for (const auto& [metres, other] : {std::pair("4.0000000000000001e-03", "0.4"), {"0.000999", "0.0999"}})
    while (centimetres.find(metres) != std::string::npos)
      centimetres = with(centimetres, metres, other);
  const std::string si = "ITEM: UNITS\nsi\n";
  CHECK(first(si + atoms, "ITEM: UNITS\ncgs\n" + centimetres).has(Finding::units_differ));
  CHECK_FALSE(first(si + atoms, si + contacts).has(Finding::units_differ));
  CHECK(dump_refused("ITEM: UNITS\nlj\n" + atoms).find("'lj'") != std::string::npos);
}

TEST_CASE("LAMMPS: a column map overrides the names, and forces as one vector are split") {
  const std::string map =
      "id1=c_pl[1],id2=c_pl[2],fx=c_cp[3],fy=c_cp[4],fz=c_cp[5],dx=c_cp[15],dy=c_cp[16],dz=c_cp[17]";
  const ImportedPacking packing = first(atoms, contacts, map);
  check_chain(packing, 1e-12, 1e-8);
  CHECK(packing.assembly.contacts[0].tangential_force == Vec3{});
  for (const char* const wrong : {"id1=c_pl[1],id2=c_pl[9]", "id1=c_pl[1]"})
    CHECK(dump_refused(atoms, contacts, wrong).starts_with("c:9:"));
  CHECK(dump_refused(atoms, contacts, "radius=c_r").starts_with("g:9:"));
}

TEST_CASE("LAMMPS: rows out of order, twice, and neighbours without contact") {
  const std::size_t begin = contacts.find("1 1 2 1 1"), end = contacts.find("ITEM: TIMESTEP", 1);
  const std::string row1 = contacts.substr(begin, contacts.find("2 2 3 1 1") - begin);
  const std::string three = with(contacts.substr(0, end), "ENTRIES\n2\n", "ENTRIES\n3\n");
  const ImportedPacking packing = first(atoms, three + row1);
  check_chain(packing, 1e-12, 1e-8);
  CHECK(packing.has(Finding::duplicated));
  CHECK(packing.has(Finding::unsorted));
  const std::string other = with(row1, "0.0235294118 -0.0235294118", "0.0235 -0.0235");
  CHECK(dump_refused(atoms, three + other).starts_with("c:12:"));
  // a neighbour that is no contact, among forces
  const std::string no_force =
      with(contacts, "0.0235294118 -0.0235294118 0 0 0 -0.0114329834 0 0.0114329834", "0 0 0 0 0 0 0 0");
  const ImportedPacking open = first(with(atoms, "0.0019999 0.002 0.002 ", "0.002001 0.002 0.002 "),
                                     with(no_force, "-0.0009999 0 0", "-0.001001 0 0"));
  CHECK(open.assembly.contacts.size() == 1);
  CHECK(open.has(Finding::open_contacts));
}

TEST_CASE("LAMMPS: each field that is wrong is refused with path and line") {
  const std::vector<Wrong> of_grains{
      {"id type", {"ID type"}, "g:9:"},
      {"radius x", {"r x"}, "g:9:"},
      {" x y z ", {" x y q "}, "g:9:"},
      {"1 1 0.0005", {"1.5 1 0.0005", "1.23457e+06 1 0.0005", "1 1 1 0.0005"}, "g:10:"},
      {"1 1 0.0005", {"1 1 0", "1 1 -0.0005", "1 1 nan"}, "g:10:"},
      {"1 1 0.0005", {"2 1 0.0005"}, "g:11:"},
      {"0.001 0.002", {"0.001x 0.002", "inf 0.002"}, "g:10:"},
      {"ATOMS\n3", {"ATOMS\n4", "ATOMS\n999999999999"}, "g:13:"},
      {"ATOMS\n3", {"ATOMS\n2"}, "g:12:"},
      {"ATOMS\n3", {"ATOMS\n-3"}, "g:4:"},
      {"ATOMS\n3", {"ATOMS\n0"}, "g:10:"},
      {"TIMESTEP\n0", {"TIMESTEP\nx"}, "g:2:"},
      {"4.0000000000000001e-03", {"1e400", "1 2"}, "g:6:"},
      {"4.0000000000000001e-03", {"0"}, ""},
      {"ITEM: TIMESTEP", {"ITEM: TIMESTAMP"}, ""},
      {"ITEM: ATOMS", {"ITEM: MOTES"}, ""}};
  const std::vector<Wrong> of_contacts{
      {"c_pl[2]", {"c_pl[7]"}, "c:10:"},
      {"1 1 2 1 1", {"1 1 4 1 1", "1 1 -2 1 1", "1 x 2 1 1", "1 1 1 1 1"}, "c:10:"},
      {"0.0235294118 -", {"nan -"}, "c:10:"},
      {"-0.0235294118 0", {"- 0"}, "c:10:"},
      {"-0.0114329834 0", {"1e999 0"}, "c:10:"},
      {"-0.0009999 0 0", {"-0.0009999 0 1e", "-0.0009999 0", "0.0009999 0 0"}, "c:10:"},
      {"ENTRIES\n2", {"ENTRIES\n3"}, "c:12:"},
      {"ENTRIES\n2", {"ENTRIES\nmany"}, "c:4:"}};
  check_refused(lammps_dump_format, atoms, contacts, of_grains, of_contacts);
  CHECK(dump_refused("") != "");
  CHECK(dump_refused("hello\n").starts_with("g:1:"));
  CHECK(dump_refused(atoms.substr(0, 40)) != "");
  CHECK(dump_refused(atoms.substr(0, atoms.find("2 1 0.0005"))).starts_with("g:10:"));
  CHECK(dump_refused(contacts, atoms).starts_with("g:9:")); // the two files the wrong way round
  const std::string near =
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS pp pp pp\n0 4e-3\n0 4e-3\n0 4e-3\n"
      "ITEM: ENTRIES id1 id2\n2 2\n";
  CHECK(dump_refused(atoms, near).starts_with("c:10:"));
}
