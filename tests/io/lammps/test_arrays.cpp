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
    LammpsDump dump(data_source("lammps_box.atoms"), data_source("lammps_box.contacts"));
    return dump.next().value();
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
  CHECK(of_memory.assembly.contacts == of_file.assembly.contacts);
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

TEST_CASE("LAMMPS arrays: the layout is recognised from values, or given by a map") {
  Memory memory;
  const auto of_told = lammps_packing(memory.arrays);
  memory.arrays.contacts->map = parse_column_map("id1=c_i[1],id2=c_i[2],force=c_p[2]");
  const auto of_map = lammps_packing(memory.arrays);
  CHECK(of_map.has(Finding::tangential_unknown));
  for (std::size_t k = 0; k < of_map.assembly.contacts.size(); ++k)
    CHECK(of_map.assembly.contacts[k].normal_force == of_told.assembly.contacts[k].normal_force);
}

TEST_CASE("LAMMPS arrays: other units become SI, unknown ones are refused") {
  Memory memory;
  for (Vec3& x : memory.position)
    x *= 100; // [cm]
  for (double& r : memory.radius)
    r *= 100;
  memory.arrays.cell = 100.0 * memory.arrays.cell;
  memory.arrays.units = "cgs";
  memory.arrays.contacts->map = parse_column_map("id1=c_i[1],id2=c_i[2],force=c_p[2]");
  const auto of_cgs = lammps_packing(memory.arrays).assembly;
  const auto of_file = Memory::of_file().assembly;
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
}

TEST_CASE("LAMMPS arrays: errors name array and element") {
  Memory memory;
  memory.id[3] = memory.id[7];
  CHECK(complaint_of(memory.arrays).starts_with("grains[7]"));
  Memory other;
  other.values[0] = 999;
  CHECK(complaint_of(other.arrays).starts_with("contacts"));
  Memory cut;
  cut.arrays.contacts->values = std::span(cut.values).first(cut.values.size() - 1);
  CHECK(complaint_of(cut.arrays).starts_with("contacts"));
  Memory short_of_radii;
  short_of_radii.arrays.radius = std::span(short_of_radii.radius).first(5);
  CHECK(complaint_of(short_of_radii.arrays).starts_with("radius"));
  Memory nameless;
  nameless.arrays.contacts->columns.assign(17, "v");
  CHECK(complaint_of(nameless.arrays) != "");
}

TEST_CASE("LAMMPS arrays: without contacts they are unknown") {
  Memory memory;
  memory.arrays.contacts.reset();
  const ImportedPacking packing = lammps_packing(memory.arrays);
  CHECK(packing.has(Finding::contacts_unknown));
  CHECK(packing.assembly.grain_count() == 54);
}
