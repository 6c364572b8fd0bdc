// SPDX-License-Identifier: GPL-3.0-or-later
// What LAMMPS hands over in memory is what its dumps are read as: the numbers of the packing in a box, of
// which tests/io/lammps/test_layouts.cpp knows what the files say.
#include <granum/core/text.hpp>
#include <granum/io/lammps/arrays.hpp>
#include <granum/io/lammps/files.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

/// The rows of a dump's table, as numbers.
std::vector<std::vector<double>> table_of(const std::string& file) {
  std::istringstream lines(data_text(file));
  std::string line;
  while (std::getline(lines, line) && !line.starts_with("ITEM: ATOMS") && !line.starts_with("ITEM: ENTRIES"))
    continue;
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    rows.emplace_back();
    for (std::string word; words >> word;)
      rows.back().push_back(*parse_number(word));
  }
  return rows;
}

/// The packing in the box, the last grain first, as LAMMPS may hold it.
struct Memory {
  std::vector<long> id, type;
  std::vector<Vec3> position;
  std::vector<double> radius, values;
  LammpsLocals contacts;
  LammpsArrays arrays;

  Memory() {
    auto grains = table_of("lammps_box.atoms");
    std::reverse(grains.begin(), grains.end());
    for (const auto& row : grains) {
      id.push_back(static_cast<long>(row[0]));
      type.push_back(static_cast<long>(row[1]));
      radius.push_back(row[2]);
      position.push_back({row[3], row[4], row[5]});
    }
    for (const auto& row : table_of("lammps_box.contacts"))
      values.insert(values.end(), row.begin(), row.end());
    contacts.columns = {"c_i[1]", "c_i[2]"};
    for (int k = 1; k <= 15; ++k)
      contacts.columns.push_back("c_p[" + std::to_string(k) + "]");
    contacts.values = values;
    arrays = {.id = id,
              .position = position,
              .radius = radius,
              .type = type,
              .cell = of_file().assembly.cell,
              .periodic = of_file().periodic,
              .step = of_file().step,
              .contacts = contacts};
  }

  static ImportedPacking of_file() {
    return first_of(lammps_dump_format, data_text("lammps_box.atoms"), data_text("lammps_box.contacts"));
  }
};

std::string complaint_of(const LammpsArrays& arrays) {
  try {
    (void)lammps_packing(arrays);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("LAMMPS arrays: the packing is that of the dumps, for any order of the grains") {
  const ImportedPacking of_file = Memory::of_file(), of_memory = lammps_packing(Memory().arrays);
  CHECK(of_memory.assembly.contacts == of_file.assembly.contacts); // walls are in the dump alone
  CHECK(of_memory.assembly.position == of_file.assembly.position);
  CHECK(of_memory.assembly.radius == of_file.assembly.radius);
  CHECK(of_memory.id == of_file.id);
  CHECK(of_memory.type == of_file.type);
  CHECK(of_memory.step == of_file.step);
  CHECK(of_memory.assembly.contacts.size() == 91);
  CHECK(of_memory.assembly.wall_contacts.empty());
  CHECK_FALSE(of_memory.has(Finding::units_unknown)); // a dump without ITEM: UNITS does not tell them
  CHECK(of_memory.has(Finding::law_unknown));
  CHECK(of_memory.has(Finding::viscous_forces));
}

TEST_CASE("LAMMPS arrays: by a map, in other units, which become SI, without contacts") {
  Memory memory;
  for (Vec3& x : memory.position)
    x *= 100; // [cm]
  for (double& r : memory.radius)
    r *= 100;
  memory.arrays.cell = 100.0 * memory.arrays.cell;
  memory.arrays.units = "cgs";
  memory.arrays.contacts->map = parse_column_map("id1=c_i[1],id2=c_i[2],force=c_p[2]");
  const ImportedPacking read = lammps_packing(memory.arrays);
  CHECK(read.has(Finding::tangential_unknown));
  const packing::Assembly &of_cgs = read.assembly, of_file = Memory::of_file().assembly;
  for (std::size_t k = 0; k < of_file.contacts.size(); ++k) {
    CHECK(of_cgs.contacts[k].normal_force == relative(1e-5 * of_file.contacts[k].normal_force, 1e-12));
    check_vector(of_cgs.contacts[k].branch, of_file.contacts[k].branch, 1e-9);
  }
  for (std::size_t k = 0; k < of_file.radius.size(); ++k) {
    CHECK(of_cgs.radius[k] == relative(of_file.radius[k], 1e-12));
    check_vector(of_cgs.position[k], of_file.position[k], 1e-12);
  }
  for (int k = 0; k < 3; ++k)
    CHECK(of_cgs.cell(k, k) == relative(of_file.cell(k, k), 1e-12));
  memory.arrays.units = "lj";
  CHECK(lammps_packing(memory.arrays).has(Finding::units_unknown));
  memory.arrays.units = "real";
  CHECK(complaint_of(memory.arrays).find("'real'") != std::string::npos);
  Memory alone;
  alone.arrays.contacts.reset();
  CHECK(lammps_packing(alone.arrays).has(Finding::contacts_unknown));
}

TEST_CASE("LAMMPS arrays: errors name array and element") {
  const auto complaint = [](const auto& change) {
    Memory memory;
    change(memory);
    return complaint_of(memory.arrays);
  };
  CHECK(complaint([](Memory& m) { m.id[3] = m.id[7]; }).starts_with("grains[7]"));
  CHECK(complaint([](Memory& m) { m.values[0] = 999; }).starts_with("contacts"));
  CHECK(complaint([](Memory& m) {
          m.arrays.contacts->values = std::span(m.values).first(m.values.size() - 1);
        }).starts_with("contacts"));
  CHECK(complaint([](Memory& m) { m.arrays.radius = std::span(m.radius).first(5); }).starts_with("radius"));
  CHECK(complaint([](Memory& m) { m.arrays.contacts->columns.assign(17, "v"); }) != "");
  CHECK(complaint([](Memory& m) { m.arrays.contacts->columns.clear(); }).starts_with("contacts"));
}

TEST_CASE("a column map is a list of quantity=column, and is refused with a slip") {
  CHECK(parse_column_map("").empty());
  CHECK(parse_column_map("id1=c_cl[1], id2 = c_cl[2],force=v_f") ==
        ColumnMap{{"id1", "c_cl[1]"}, {"id2", "c_cl[2]"}, {"force", "v_f"}});
  for (const auto& [map, named] :
       {std::pair{"id1", "'id1'"}, {"kq=c_1", "'kq'"}, {"id=", "'id'"}, {"id=a,id=b", "'id'"}})
    CHECK_THROWS_WITH_AS(parse_column_map(map), doctest::Contains(named), InvalidArgument);
}
