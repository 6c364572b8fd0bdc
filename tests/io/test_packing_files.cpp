// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_files.hpp>

#include "import_support.hpp"

using namespace granum;
using namespace granum::io;
using namespace granum::samples;

namespace {

std::vector<std::filesystem::path> data(const std::vector<std::string>& names) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& name : names)
    paths.emplace_back(data_path(name));
  return paths;
}

std::size_t count_states(const std::vector<std::string>& names) {
  PackingFiles files(data(names));
  std::size_t states = 0;
  while (files.next())
    ++states;
  return states;
}

} // namespace

TEST_CASE("packing files: each format is told by what stands in it") {
  using enum FileKind;
  const std::pair<const char*, FileKind> expected[] = {
      {"lammps_chain.atoms", dump_grains},      {"lammps_chain.contacts", dump_contacts},
      {"lammps_label.contacts", dump_contacts}, {"lammps_tilted.atoms", dump_grains},
      {"liggghts_chain.atoms", dump_grains},    {"liggghts_chain.contacts", dump_contacts},
      {"lammps_chain.data", lammps_data},       {"lammps_tilted.data", lammps_data},
      {"mercury_chain.data", mercury_data},     {"mercury_chain.fstat", mercury_fstat},
      {"yade_text.txt", yade_grains},           {"yade_text_ext.txt", yade_grains},
      {"yade_script.grains", yade_grains},      {"yade_script.contacts", yade_contacts},
      {"yade_chain.contacts", yade_contacts},   {"yade_chain.vtk", vtk_contacts}};
  for (const auto& [name, kind] : expected) {
    INFO(name);
    CHECK(recognise(data_source(name)) == kind);
    CHECK(holds_contacts(kind) ==
          (std::string(description(kind)).find("contacts") != std::string::npos || kind == mercury_fstat));
  }
}

TEST_CASE("packing files: CSV and VTK of spheres, and what is none of all these") {
  const auto kind_of = [](const std::string& text) { return recognise(text_source("file", text)); };
  CHECK(kind_of("id,x_mm,y_mm,z_mm,radius_mm\n") == FileKind::csv_grains);
  CHECK(kind_of("# units: SI\nid1,id2,nx,ny,nz\n") == FileKind::csv_contacts);
  CHECK(kind_of("nx,ny,nz\n") == FileKind::csv_contacts);
  CHECK(kind_of("# vtk DataFile Version 3.0.\ncomment\nASCII\n\nDATASET POLYDATA\nPOINTS 0 double\n") ==
        FileKind::vtk_grains);
  CHECK(refusal([&] { (void)kind_of("Lorem ipsum\n"); }).find("of no format that granum reads") !=
        std::string::npos);
  CHECK(refusal([&] { (void)kind_of(""); }).find("is empty") != std::string::npos);
  CHECK(refusal([&] { (void)kind_of("ITEM: TIMESTEP\n0\n"); }).find("a dump without") != std::string::npos);
  CHECK(kind_of("packing, made by LAMMPS\n\n3 atoms\n") == FileKind::lammps_data);
  CHECK(refusal([] { (void)PackingFiles(data({"none"})); }).find("none") != std::string::npos);
}

TEST_CASE("packing files: the chain out of every format, files in any order") {
  for (const auto& names :
       std::vector<std::vector<std::string>>{{"lammps_chain.atoms", "lammps_chain.contacts"},
                                             {"lammps_chain.contacts", "lammps_chain.atoms"},
                                             {"mercury_chain.data", "mercury_chain.fstat"}}) {
    INFO(names[0]);
    PackingFiles files(data(names));
    const auto packing = files.next();
    REQUIRE(packing);
    check_chain(*packing, 1e-9, 1e-7);
    CHECK(files.kinds().size() == 2);
  }
  PackingFiles yade(data({"yade_script.contacts", "yade_script.grains"}));
  REQUIRE(yade.next());
  CHECK_FALSE(yade.next());
}

TEST_CASE("packing files: frames of one file, then those of the next") {
  CHECK(count_states({"lammps_chain.atoms"}) == 2);
  CHECK(count_states({"lammps_chain.atoms", "lammps_chain.contacts"}) == 2);
  CHECK(count_states({"lammps_chain.atoms", "lammps_chain.contacts", "lammps_face.atoms",
                      "lammps_face.contacts"}) == 2 + 1);
  CHECK(count_states({"lammps_chain.data", "lammps_tilted.data"}) == 2);
}

TEST_CASE("packing files: files that do not go together are refused") {
  const auto refused = [](const std::vector<std::string>& names) {
    try {
      PackingFiles files(data(names));
    } catch (const InvalidArgument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refused({"lammps_chain.contacts"}).find("a file of grains is missing") != std::string::npos);
  CHECK(refused({"lammps_chain.atoms", "lammps_chain.contacts", "lammps_face.contacts"})
            .find("1 files of grains do not go with 2 of contacts") != std::string::npos);
  CHECK(refused({"lammps_chain.atoms", "mercury_chain.fstat"}).find("which does not go with") !=
        std::string::npos);
  CHECK(refused({"lammps_chain.atoms", "lammps_chain.data"}).find("which does not go with") !=
        std::string::npos);
}
