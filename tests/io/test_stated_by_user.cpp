// SPDX-License-Identifier: GPL-3.0-or-later
// What a user states about files, and what the files hold beyond that, over all formats.
#include <granum/io/packing_files.hpp>

#include <map>

#include <granum/io/output_file.hpp>
#include <granum/io/vtk/paraview.hpp>
#include <granum/io/vtk/xml.hpp>

#include "import_support.hpp"
#include "temporary_folder.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

/// A file of three grains in a box of 4 mm, with one more column.
struct Sample {
  const PackingFormat* format;
  bool states_box;
  std::string text; ///< "EXTRA" is the name of the column
};

const Sample formats[] = {
    {&lammps_dump_format, true,
     "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS\n0 4e-3\n0 4e-3\n0 4e-3\n"
     "ITEM: ATOMS id radius x y z EXTRA\n1 5e-4 1e-3 2e-3 2e-3 7\n2 5e-4 1.9e-3 2e-3 2e-3 7\n"
     "3 5e-4 3e-3 2e-3 2e-3 8\n"},
    {&yade_text_format, false,
     "#format x_y_z_r_EXTRA\n1e-3 2e-3 2e-3 5e-4 7\n1.9e-3 2e-3 2e-3 5e-4 7\n"
     "3e-3 2e-3 2e-3 5e-4 8\n"},
    {&yade_text_format, true,
     "# granum: grains of a YADE scene, SI\n# cell 4e-3 0 0 0 4e-3 0 0 0 4e-3\n# id x y z r EXTRA\n"
     "1 1e-3 2e-3 2e-3 5e-4 7\n2 1.9e-3 2e-3 2e-3 5e-4 7\n3 3e-3 2e-3 2e-3 5e-4 8\n"},
    {&yade_vtk_format, false,
     "# vtk DataFile Version 3.0.\ncomment\nASCII\nDATASET POLYDATA\nPOINTS 3 double\n1e-3 2e-3 2e-3\n"
     "1.9e-3 2e-3 2e-3\n3e-3 2e-3 2e-3\nPOINT_DATA 3\nSCALARS radius double 1\nLOOKUP_TABLE default\n5e-4\n"
     "5e-4\n5e-4\nSCALARS EXTRA double 1\nLOOKUP_TABLE default\n7\n7\n8\n"},
    {&vtk_xml_format, false,
     "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>\n<Piece NumberOfPoints=\"3\" "
     "NumberOfCells=\"0\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\">1e-3 2e-3 2e-3 "
     "1.9e-3 2e-3 2e-3 3e-3 2e-3 2e-3</DataArray></Points><PointData><DataArray type=\"Float64\" "
     "Name=\"RADIUS\">5e-4 5e-4 5e-4</DataArray><DataArray type=\"Float64\" Name=\"EXTRA\">7 7 8</DataArray>"
     "</PointData></Piece></UnstructuredGrid></VTKFile>\n"},
    {&csv_format, false,
     "x_m,y_m,z_m,radius_m,EXTRA\n1e-3,2e-3,2e-3,5e-4,7\n1.9e-3,2e-3,2e-3,5e-4,7\n3e-3,2e-3,2e-3,5e-4,8\n"}};

/// The first state of a text, with the extra column of a name.
ImportedPacking read(const Sample& sample, const std::string& extra, const PackingFileOptions& options = {}) {
  return first_of(*sample.format, with(sample.text, "EXTRA", extra), {}, options);
}

PackingFileOptions boxed(double side) { return {.box = CsvBox{Mat3::diagonal(side, side, side)}}; }

bool notes(const ImportedPacking& packing, Finding finding, const std::string& word) {
  for (const ImportNote& note : packing.notes)
    if (note.finding == finding && note.text.find(word) != std::string::npos)
      return true;
  return false;
}

/// A text of `formats` with the extra column c1.
std::string plain(std::size_t k) { return with(formats[k].text, "EXTRA", "c1"); }

const std::string yade_headings = "# id1 id2 nx ny nz pd fnx fny fnz fsx fsy fsz";
const std::string mercury = "1 0.5 0 0 0 4e-3 4e-3 4e-3\n1e-3 2e-3 2e-3 0 0 0 5e-4 0 0 0 0 0 0 0\n";

} // namespace

TEST_CASE(
    "stated by the user: a box is used by every format without one, and must agree with that of others") {
  for (const Sample& sample : formats) {
    CAPTURE(sample.text);
    const ImportedPacking packing = read(sample, "c1", boxed(4e-3));
    CHECK(packing.assembly.cell(0, 0) == relative(4e-3, 1e-12));
    CHECK(packing.periodic == std::array{true, true, true});
    CHECK_FALSE(packing.has(Finding::cell_unknown));
    CHECK_FALSE(packing.has(Finding::boundary_unknown));
    CHECK_NOTHROW((void)read(sample, "c1", boxed(4.0000001e-3)));
    if (sample.states_box)
      CHECK_THROWS_AS((void)read(sample, "c1", boxed(4.01e-3)), InvalidArgument);
    else
      CHECK(read(sample, "c1", boxed(5e-3)).assembly.cell(2, 2) == 5e-3);
  }
  CHECK_THROWS_AS((void)first_of(mercury_format, mercury, {}, boxed(3e-3)), InvalidArgument);
  CHECK_THROWS_AS((void)first_of(lammps_data_format, data_text("lammps_chain.data"), {}, boxed(3e-3)),
                  InvalidArgument);
  const std::string walled = with(formats[0].text, "BOUNDS", "BOUNDS pp pp ff");
  CHECK_THROWS_AS((void)first_of(lammps_dump_format, walled, {}, boxed(4e-3)), InvalidArgument);
}

TEST_CASE("stated by the user: columns that are not used are listed, shapes by themselves") {
  for (const Sample& sample : formats) {
    CAPTURE(sample.text);
    CHECK(notes(read(sample, "wear"), Finding::not_used, "wear"));
    CHECK_FALSE(read(sample, "wear").has(Finding::shapes));
    for (const char* const shape : {"shapex", "Blockiness1", "quat4", "c-SuperQuadric"}) {
      CHECK(read(sample, shape).has(Finding::shapes));
      CHECK_FALSE(read(sample, shape, {.columns = {{"shape", "none"}}}).has(Finding::shapes));
    }
  }
}

TEST_CASE("not used: formats of fixed columns, and files of contacts, list them too") {
  const auto unused = [](const ImportedPacking& packing, const std::string& names) {
    return notes(packing, Finding::not_used, names);
  };
  const auto of_mercury = [](const std::string& info) {
    return first_of(mercury_format, with(mercury, "0 0 0 0\n", "0 0 0 " + info + "\n"));
  };
  CHECK(unused(of_mercury("3"), "velocities"));
  CHECK_FALSE(unused(of_mercury("3"), "info"));
  CHECK(unused(of_mercury("0.5"), "info"));
  CHECK(unused(first_of(mercury_format, data_text("mercury_chain.data"), data_text("mercury_chain.fstat")),
               "deltat"));
  CHECK(unused(first_of(lammps_data_format, data_text("lammps_chain.data")), "Velocities"));
  const auto yade = [&](const std::string& names, const std::string& values) {
    return first_of(yade_text_format, plain(2),
                    yade_headings + names + "\n1 2 1 0 0 1e-4 4 0 0 0 0 0" + values + "\n");
  };
  CHECK(unused(yade(" wear kn", " 1 2"), "wear, kn")); // k_n without k_t
  CHECK_FALSE(unused(yade(" kn ks", " 2 2"), "kn"));
  const std::string lines =
      with(plain(3), "POINT_DATA",
           "LINES 1 3\n2 0 1\nCELL_DATA 1\nSCALARS wear double 1\nLOOKUP_TABLE default\n7\nPOINT_DATA");
  CHECK(unused(first_of(yade_vtk_format, plain(3), lines), "c1, radius, wear"));
}

TEST_CASE("stated by the user: rigid bodies, named or denied") {
  const std::map<const PackingFormat*, std::string> column{
      {&lammps_dump_format, "mol"}, {&csv_format, "body"}, {&yade_text_format, "clumpId"}};
  for (const Sample& sample : formats) {
    if (!column.contains(sample.format))
      continue;
    CAPTURE(sample.text);
    const std::string& name = column.at(sample.format);
    CHECK(read(sample, name).has(Finding::bodies));
    CHECK(read(sample, name, {.columns = {{"body", "none"}}}).assembly.body.empty());
  }
  CHECK(read(formats[0], "c_b", {.columns = {{"body", "c_b"}}}).has(Finding::bodies));
  CHECK(parse_column_map("body=c_b, shape=none").size() == 2);
}

TEST_CASE("stated by the user: SI, columns for dumps are refused with other formats") {
  const TemporaryFolder folder;
  for (const Sample& sample : formats) {
    CHECK_FALSE(read(sample, "c1", {.si = true}).has(Finding::units_unknown));
    const std::filesystem::path path = folder.path() / "grains";
    write_file(path, with(sample.text, "EXTRA", "c1"), Existing::replace);
    const auto open = [&] { return PackingFiles({path}, {.columns = {{"radius", "radius"}}}).next(); };
    if (sample.format == &lammps_dump_format)
      CHECK(open().has_value());
    else
      CHECK_THROWS_AS((void)open(), InvalidArgument);
  }
  const std::string bare = "x y z radius\n0 0 0 1\n2 0 0 1\n";
  CHECK(first_of(csv_format, bare, {}, {.si = true}).assembly.radius[1] == 1);
  CHECK(refusal_of(csv_format, bare) != "");
  CHECK_THROWS_AS((void)first_of(lammps_dump_format, "ITEM: UNITS\nmicro\n" + plain(0), {}, {.si = true}),
                  InvalidArgument);
}

TEST_CASE("cut files: a last frame that is not complete costs itself alone") {
  const TemporaryFolder folder;
  const std::string dump = plain(0);
  for (const std::string& frame : {dump, mercury})
    for (const std::size_t missing : {std::size_t{3}, std::size_t{20}, std::size_t{30}}) {
      CAPTURE(frame);
      CAPTURE(missing);
      const std::string cut = frame.substr(0, frame.size() - missing);
      write_file(folder.path() / "two", frame + frame + cut, Existing::replace);
      PackingFiles files({folder.path() / "two"});
      CHECK(files.next());
      CHECK(files.cut().empty());
      CHECK(files.next());
      CHECK_FALSE(files.next());
      CHECK_FALSE(files.cut().empty());
      CHECK_FALSE(files.next());
      write_file(folder.path() / "none", cut, Existing::replace);
      CHECK_THROWS_AS((void)PackingFiles({folder.path() / "none"}).next(), FileError);
      write_file(folder.path() / "whole", frame, Existing::replace);
      PackingFiles first({folder.path() / "two", folder.path() / "whole"}); // not the last file
      CHECK((first.next() && first.next()));
      CHECK_THROWS_AS((void)first.next(), FileError);
    }
  write_file(folder.path() / "wrong", dump + with(dump, "1 5e-4", "1 five") + dump, Existing::replace);
  PackingFiles wrong({folder.path() / "wrong"});
  CHECK(wrong.next());
  CHECK_THROWS_AS((void)wrong.next(), FileError);
}

TEST_CASE("series: steps or times of the index, of both kinds of index, and the pieces of a parallel file") {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file(folder.path() / name, text, Existing::replace);
    return folder.path() / name;
  };
  for (const char* const name : {"a.vtu", "b.vtu"})
    (void)write(name, plain(4));
  const auto states = [&](const std::filesystem::path& index) {
    PackingFiles files(files_of_series({index}));
    std::vector<ImportedPacking> out;
    while (auto packing = files.next())
      out.push_back(std::move(*packing));
    REQUIRE(out.size() == 2);
    return out;
  };
  const SeriesEntry whole[] = {{1000, "a.vtu"}, {2000, "b.vtu"}}, parts[] = {{0, "a.vtu"}, {0.5, "b.vtu"}};
  const auto steps = states(write("s.pvd", pvd(whole)));
  CHECK((steps[0].step == 1000 && steps[1].step == 2000 && !steps[1].time));
  const auto times = states(write("t.pvd", pvd(parts)));
  CHECK((times[0].time == 0.0 && times[1].time == 0.5 && times[1].step == 0));
  const auto json = states(write("t.vtu.series", "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n"
                                                 "    { \"name\" : \"b.vtu\", \"time\" : 0.5 },\n"
                                                 "    { \"name\" : \"a.vtu\", \"time\" : 0.25 }\n  ]\n}\n"));
  CHECK((json[0].time == 0.25 && json[1].time == 0.5));
  const auto no_time =
      write("bad.vtu.series", "{\"file-series-version\":\"1.0\",\"files\":[{\"name\":\"a.vtu\"}]}");
  CHECK_THROWS_AS((void)files_of_series({no_time}), FileError);
  const auto parallel = write("p.pvtu", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\">\n"
                                        "<PUnstructuredGrid GhostLevel=\"0\">\n<Piece Source=\"a.vtu\"/>\n"
                                        "<Piece Source=\"b.vtu\"/>\n</PUnstructuredGrid>\n</VTKFile>\n");
  PackingFiles pieces({parallel});
  const auto packing = pieces.next();
  REQUIRE(packing);
  CHECK(packing->assembly.grain_count() == 6);
  CHECK(packing->id == std::vector<long>{0, 1, 2, 3, 4, 5});
  CHECK(packing->assembly.radius[5] == 5e-4);
}

TEST_CASE("tables: separators, and the names of ParaView and PFC") {
  for (const char separator : {',', ';', '\t', ' '}) {
    std::string grains = "id x_m y_m z_m radius_m\n1 0 0 0 0.5\n2 0.99 0 0 0.5\n",
                pairs = "end1 end2 fn_N\n1 2 3\n";
    std::ranges::replace(grains, ' ', separator);
    std::ranges::replace(pairs, ' ', separator);
    TextSource of_grains = text_source("g", grains), of_pairs = text_source("c", pairs);
    CHECK(recognise(of_grains) == FileKind{&csv_format, Holds::grains});
    CHECK(recognise(of_pairs) == FileKind{&csv_format, Holds::contacts});
    const ImportedPacking packing = first_of(csv_format, grains, pairs);
    CHECK(packing.assembly.position[1].x == 0.99);
    CHECK(packing.assembly.contacts[0].normal_force == 3);
  }
  const ImportedPacking paraview =
      first_of(csv_format, "\"Radius\",\"Points:0\",\"Points:1\",\"Points:2\"\n0.5,0,0,0\n0.5,0.99,0,0\n");
  CHECK(paraview.has(Finding::units_unknown));
  CHECK(paraview.assembly.position[1].x == 0.99);
}

TEST_CASE("ParaView files: forces that are not known are not written") {
  const packing::Assembly pair{.cell = Mat3::identity(),
                               .position = {{0.1, 0.5, 0.5}, {0.29, 0.5, 0.5}},
                               .radius = {0.1, 0.1},
                               .contacts = {{.i = 0, .j = 1, .branch = {0.19, 0, 0}, .overlap = 0.01}}};
  const auto back = [&](KnownForces known) {
    return first_of(vtk_xml_format, grains_vtu(pair), contacts_vtp(pair, {}, known));
  };
  CHECK(back(KnownForces::none).has(Finding::forces_unknown));
  CHECK(back(KnownForces::normal).has(Finding::tangential_unknown));
  CHECK_FALSE(back(KnownForces::normal).has(Finding::forces_unknown));
  CHECK_FALSE(back(KnownForces::all).has(Finding::tangential_unknown));
}

namespace {

const std::string three_grains =
    "# units: SI\nid,x,y,z,radius\n1,0,0,0,0.5\n2,0.99,0,0,0.5\n3,1.98,0,0,0.5\n";

ImportedPacking joined(const std::string& contacts) {
  return first_of(csv_format, three_grains, "# units: SI\n" + contacts);
}

/// A dump of contacts beside formats[0].
std::string contact_dump(const std::string& length, const std::string& columns, const std::string& rows) {
  const std::string side = "0 " + length + "\n";
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ENTRIES\n2\nITEM: BOX BOUNDS\n" + side + side + side +
         "ITEM: ENTRIES " + columns + "\n" + rows;
}

ImportedPacking dumped(const std::string& contacts) {
  return first_of(lammps_dump_format, plain(0), contacts);
}

} // namespace

TEST_CASE("rows of zeros are left out with a note, and others still count") {
  for (const char* const rows :
       {"id1,id2,nx,ny,nz,fn\n1,2,1,0,0,4\n2,3,0,0,0,0\n", "id1,id2,fx,fy,fz\n1,2,4,0,0\n0,0,0,0,0\n"}) {
    const ImportedPacking packing = joined(rows);
    CHECK(packing.has(Finding::empty_rows));
    REQUIRE(packing.assembly.contacts.size() == 1);
    CHECK(packing.assembly.contacts[0].normal_force == 4);
  }
  CHECK_THROWS_AS((void)joined("id1,id2,nx,ny,nz,fn\n1,2,0,0,0,4\n"), FileError);
  const ImportedPacking dump = dumped(contact_dump("4e-3", "id1 id2 dx dy dz force ftx fty ftz",
                                                   "1 2 -9e-4 0 0 4 0 0 0\n0 0 0 0 0 0 0 0 0\n"));
  CHECK(dump.has(Finding::empty_rows));
  CHECK(dump.assembly.contacts.size() == 1);
  const ImportedPacking yade = first_of(
      yade_text_format, plain(2), yade_headings + "\n1 2 1 0 0 1e-4 4 0 0 0 0 0\n2 3 0 0 0 0 0 0 0 0 0 0\n");
  CHECK(yade.has(Finding::empty_rows));
  CHECK(yade.assembly.contacts.size() == 1);
}

TEST_CASE("stiffnesses in tables and dumps are those of the contacts") {
  for (const char* const names :
       {"kn,kt", "k_n,k_t", "kn_N/m,ks_N/m", "normal_stiffness,tangential_stiffness"}) {
    const ImportedPacking packing =
        joined(std::string("id1,id2,fn,") + names + "\n1,2,4,2e5,1e5\n2,3,4,3e5,1e5\n");
    CHECK_FALSE(packing.has(Finding::stiffness_unknown));
    CHECK_FALSE(packing.has(Finding::not_used));
    REQUIRE(packing.assembly.contacts.size() == 2);
    CHECK(packing.assembly.contacts[1].normal_stiffness == 3e5);
    CHECK(packing.assembly.contacts[1].tangential_stiffness == 1e5);
  }
  const ImportedPacking half = joined("id1,id2,fn,kn\n1,2,4,2e5\n2,3,4,3e5\n"); // k_t would be 0
  CHECK(half.has(Finding::stiffness_unknown));
  CHECK(notes(half, Finding::not_used, "kn"));
  const ImportedPacking dump =
      dumped(contact_dump("4e-3", "id1 id2 force kn kt", "1 2 4 2e5 1e5\n2 3 0.1 3e5 1e5\n"));
  CHECK_FALSE(dump.has(Finding::stiffness_unknown));
  CHECK(dump.assembly.contacts[0].normal_stiffness == 2e5);
}

TEST_CASE("dumps whose boxes differ by more than rounding are refused") {
  const std::string columns = "id1 id2 force", rows = "1 2 4\n2 3 0.1\n";
  CHECK_NOTHROW((void)dumped(contact_dump("4.0000001e-3", columns, rows)));
  CHECK_THROWS_AS((void)dumped(contact_dump("4.01e-3", columns, rows)), FileError);
}
