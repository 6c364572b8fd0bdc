// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_files.hpp>

#include <thread>
#include <tuple>

#include <sys/stat.h>

#include <zlib.h>

#include <granum/io/output_file.hpp>
#include <granum/io/vtk/paraview.hpp>

#include "import_support.hpp"
#include "temporary_folder.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

std::vector<PackingFile> data(const std::vector<std::string>& names) {
  std::vector<PackingFile> files;
  for (const std::string& name : names)
    files.emplace_back(data_path(name));
  return files;
}

std::size_t count_states(const std::vector<std::string>& names) {
  PackingFiles files(data(names));
  std::size_t states = 0;
  while (files.next())
    ++states;
  return states;
}

} // namespace

TEST_CASE("packing files: each format is recognised by its content") {
  const std::tuple<const char*, const PackingFormat*, Holds> expected[] = {
      {"lammps_chain.atoms", &lammps_dump_format, Holds::grains},
      {"lammps_chain.contacts", &lammps_dump_format, Holds::contacts},
      {"liggghts_chain.atoms", &lammps_dump_format, Holds::grains},
      {"liggghts_chain.contacts", &lammps_dump_format, Holds::contacts},
      {"lammps_chain.data", &lammps_data_format, Holds::grains},
      {"mercury_chain.data", &mercury_format, Holds::grains},
      {"mercury_chain.fstat", &mercury_format, Holds::contacts},
      {"yade_text.txt", &yade_text_format, Holds::grains},
      {"yade_text_ext.txt", &yade_text_format, Holds::grains},
      {"yade_script.grains", &yade_text_format, Holds::grains},
      {"yade_script.contacts", &yade_text_format, Holds::contacts},
      {"yade_chain.contacts", &yade_text_format, Holds::contacts},
      {"yade_chain.vtk", &yade_vtk_format, Holds::contacts},
      {"yade_chain.vtu", &vtk_xml_format, Holds::grains},
      {"yade_chain.vtp", &vtk_xml_format, Holds::contacts},
      {"vtk_raw.vtu", &vtk_xml_format, Holds::grains},
      {"vtk_appended.vtp", &vtk_xml_format, Holds::contacts}};
  for (const auto& [file, format, holds] : expected) {
    const char* name = file;
    INFO(name);
    CHECK(PackingFile(data_path(name)).kind() == FileKind{format, holds});
  }
  for (const PackingFormat* format : packing_formats) {
    INFO(format->name);
    CHECK_FALSE((format->name.empty() || format->sign.empty() || format->grains.empty()));
    CHECK(description({format, Holds::grains}) == format->grains);
    CHECK(description({format, Holds::contacts}) == format->contacts);
  }
}

TEST_CASE("packing files: CSV and VTK of spheres, and unknown files") {
  const auto kind_of = [](const std::string& text) {
    TextSource source = text_source("file", text);
    return recognise(source);
  };
  const auto kind = [](const PackingFormat& format, Holds holds) { return FileKind{&format, holds}; };
  CHECK(kind_of("id,x_mm,y_mm,z_mm,radius_mm\n") == kind(csv_format, Holds::grains));
  CHECK(kind_of("# units: SI\nid1,id2,nx,ny,nz\n") == kind(csv_format, Holds::contacts));
  CHECK(kind_of("nx,ny,nz\n") == kind(csv_format, Holds::contacts));
  CHECK(kind_of("# vtk DataFile Version 3.0.\ncomment\nASCII\n\nDATASET POLYDATA\nPOINTS 0 double\n") ==
        kind(yade_vtk_format, Holds::grains));
  const std::string points = "<VTKFile type=\"PolyData\"><PolyData>\n<Piece NumberOfPoints=\"3\"";
  CHECK(kind_of(points + " NumberOfLines=\"0\">") == kind(vtk_xml_format, Holds::grains));
  CHECK(kind_of(points + " NumberOfLines=\"2\">") == kind(vtk_xml_format, Holds::contacts));
  CHECK(kind_of(with(points, "3", "0") + " NumberOfLines=\"0\">") == kind(vtk_xml_format, Holds::contacts));
  CHECK(kind_of("ITEM: UNITS\nsi\n" + data_text("lammps_chain.atoms")) ==
        kind(lammps_dump_format, Holds::grains));
  for (const auto& [text, named] : {std::pair{"<?xml?>\n<html/>\n", ""},
                                    {"Begin ModelPartData\n", "Kratos"},
                                    {"\x89HDF\r\n", "HDF5"},
                                    {"Lorem ipsum\n", ""},
                                    {"", ""},
                                    {"ITEM: TIMESTEP\n0\n", ""}}) {
    const std::string said = refusal([&, content = text] { (void)kind_of(content); });
    CHECK((!said.empty() && said.find(named) != std::string::npos));
  }
  CHECK(kind_of("packing, made by LAMMPS\n\n3 atoms\n") == kind(lammps_data_format, Holds::grains));
  CHECK(refusal([] { (void)PackingFiles(data({"none"})); }).find("none") != std::string::npos);
}

TEST_CASE("packing files: the chain out of every format, files in any order") {
  const struct {
    std::vector<std::string> names;
    double of_forces, of_overlaps; ///< relative errors
  } chains[] = {{{"lammps_chain.atoms", "lammps_chain.contacts"}, 1e-9, 1e-7},
                {{"lammps_chain.contacts", "lammps_chain.atoms"}, 1e-9, 1e-7},
                {{"mercury_chain.data", "mercury_chain.fstat"}, 1e-9, 1e-7},
                {{"yade_chain.vtp", "yade_chain.vtu"}, 3e-9, 1e-2},
                {{"yade_script.contacts", "yade_script.grains"}, 1e-9, 1e-7}};
  for (const auto& chain : chains) {
    INFO(chain.names[0]);
    PackingFiles files(data(chain.names));
    const auto packing = files.next();
    REQUIRE(packing);
    check_chain(*packing, chain.of_forces, chain.of_overlaps);
  }
}

TEST_CASE("packing files: a pipe is read once, plain or gzip, however late its format is recognised") {
  const TemporaryFolder folder;
  std::string text = "# vtk DataFile Version 3.0.\ncomment\nASCII\n\nDATASET POLYDATA\nPOINTS 20000 double\n";
  for (int k = 0; k < 20000; ++k)
    text += std::to_string(k) + " 0 0\n";
  text += "\nPOINT_DATA 20000\nSCALARS radius double 1\nLOOKUP_TABLE default\n";
  for (int k = 0; k < 20000; ++k)
    text += "0.5\n";
  for (const bool packed : {false, true}) {
    INFO(packed);
    const auto pipe = folder.path() / (packed ? "packed" : "plain");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    std::thread writer([&] {
      const gzFile file = gzopen(pipe.c_str(), packed ? "wb" : "wbT");
      gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
      gzclose(file);
    });
    std::vector<PackingFile> files;
    files.emplace_back(pipe);
    writer.join();
    PackingFiles states(std::move(files));
    const auto packing = states.next();
    REQUIRE(packing);
    CHECK(packing->assembly.grain_count() == 20000);
    CHECK_FALSE(states.next());
  }
}

TEST_CASE("packing files: frames of one file, then those of the next") {
  CHECK(count_states({"lammps_chain.atoms"}) == 2);
  CHECK(count_states({"lammps_chain.atoms", "lammps_chain.contacts"}) == 2);
  CHECK(count_states({"lammps_chain.atoms", "lammps_chain.contacts", "liggghts_face.atoms",
                      "liggghts_face.contacts"}) == 2 + 1);
  CHECK(count_states({"yade_chain.vtu", "vtk_raw.vtu", "vtk_big.vtu"}) == 3);
  CHECK(count_states({"lammps_chain.data", "lammps_chain.data"}) == 2);
}

TEST_CASE("packing files: files that do not go together are refused") {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"lammps_chain.contacts"},
        {"lammps_chain.atoms", "lammps_chain.contacts", "liggghts_face.contacts"},
        {"lammps_chain.atoms", "mercury_chain.fstat"},
        {"lammps_chain.atoms", "lammps_chain.data"}})
    CHECK_THROWS_AS((void)PackingFiles(data(names)), InvalidArgument);
}

namespace {

/// A grain at x = number/100, as granum writes it for ParaView.
void write_grain(const std::filesystem::path& path, int number) {
  const packing::Assembly one{
      .cell = Mat3::identity(), .position = {{number / 100.0, 0.5, 0.5}}, .radius = {0.1}, .contacts = {}};
  write_file(path, grains_vtu(one), Existing::keep);
}

/// The numbers of the grains of all states, in their order.
std::vector<int> numbers_of(const std::vector<std::filesystem::path>& names) {
  PackingFiles files(files_of_series(names));
  std::vector<int> out;
  while (const auto packing = files.next())
    out.push_back(static_cast<int>(std::lround(100 * packing->assembly.position[0].x)));
  return out;
}

} // namespace

TEST_CASE("packing files: states of several files come in the order of the numbers in their names") {
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> names;
  for (const int number : {9, 11, 2, 10, 1}) {
    names.push_back(folder.path() / ("p" + std::to_string(number) + ".vtu"));
    write_grain(names.back(), number);
  }
  CHECK(numbers_of(names) == std::vector<int>{1, 2, 9, 10, 11});
  PackingFiles files(files_of_series(names));
  REQUIRE((files.next() && files.next()));
  CHECK(files.path() == names[2]);
}

TEST_CASE("packing files: a series of VTK files is sorted by time, not by name") {
  const TemporaryFolder folder;
  const auto at = [&](const std::string& name) { return folder.path() / name; };
  std::filesystem::create_directory(at("states"));
  for (const int number : {1, 2, 3})
    write_grain(at("states") / ("g" + std::to_string(number) + ".vtu"), number);
  write_file(at("late.pvd"), pvd(std::vector<SeriesEntry>{{30, "states/g1.vtu"}, {10, "states/g3.vtu"}}),
             Existing::keep);
  CHECK(numbers_of({at("late.pvd")}) == std::vector<int>{3, 1});
  // beside files, by the names that were given
  CHECK(numbers_of({at("states") / "g2.vtu", at("late.pvd")}) == std::vector<int>{3, 1, 2});
  write_file(at("lost.pvd"), pvd(std::vector<SeriesEntry>{{0, "states/none.vtu"}}), Existing::keep);
  CHECK(refusal([&] { (void)files_of_series({at("lost.pvd")}); }).find("none.vtu") != std::string::npos);
}

TEST_CASE("packing files: series of grains and of contacts have the same times") {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::vector<SeriesEntry>& entries) {
    write_file(folder.path() / name, pvd(entries), Existing::replace);
    return folder.path() / name;
  };
  const std::string grains = data_path("yade_chain.vtu"), contacts = data_path("yade_chain.vtp");
  const auto first = write("g.pvd", {{1, grains}}), second = write("c.pvd", {{1, contacts}});
  PackingFiles files(files_of_series({second, first}));
  const auto packing = files.next();
  REQUIRE(packing);
  check_chain(*packing, 3e-9, 1e-2);
  (void)write("c.pvd", {{2, contacts}});
  CHECK_THROWS_WITH_AS((void)files_of_series({first, second}), doctest::Contains("1"), InvalidArgument);
}
