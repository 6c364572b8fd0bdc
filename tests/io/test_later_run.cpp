// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/later_run.hpp"

#include <granum/io/output_file.hpp>
#include <granum/io/packing_files.hpp>
#include <granum/io/vtk/paraview.hpp>

#include "import_support.hpp"
#include "temporary_folder.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

std::string dump_head(int step, const std::string& count) {
  return "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF " + count +
         "\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n";
}
/// A frame of two grains; the run is in the place of the first, x = run [m].
std::string dump_frame(int step, int run) {
  const std::string x = std::to_string(run);
  return dump_head(step, "ATOMS\n2") + "ITEM: ATOMS id radius x y z\n1 0.5 " + x + " 0 0\n2 0.5 " + x +
         " 0.9 0\n";
}
std::string contact_frame(int step, int run) {
  return dump_head(step, "ENTRIES\n1") + "ITEM: ENTRIES id1 id2 force\n1 2 " + std::to_string(run) + "\n";
}
std::string data_frame(int time, int run) {
  return "2 " + std::to_string(time) + " 0 0 0 9 9 9\n" + std::to_string(run) +
         " 0 0 0 0 0 0.5 0 0 0 0 0 0 0\n0 5 0 0 0 0 0.5 0 0 0 0 0 0 0\n";
}

struct Seen {
  std::vector<long> steps;
  std::vector<int> runs;
  std::vector<std::string> said;
  bool operator==(const Seen&) const = default;
};

class Files {
 public:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    write_file(folder_.path() / name, text, Existing::replace);
    return folder_.path() / name;
  }
  /// Step, or time, and run of each state.
  static Seen read(const std::vector<std::filesystem::path>& names) {
    PackingFiles files(files_of_series(names));
    Seen out;
    while (const auto packing = files.next()) {
      out.steps.push_back(packing->time ? std::lround(*packing->time) : packing->step);
      out.runs.push_back(static_cast<int>(std::lround(packing->assembly.position[0].x)));
      for (const packing::Contact& c : packing->assembly.contacts)
        CHECK(c.normal_force == out.runs.back());
    }
    out.said = files.replaced();
    return out;
  }

 private:
  TemporaryFolder folder_;
};

template <class Frame>
std::string joined(const Frame& frame, const std::vector<std::pair<int, int>>& frames) {
  std::string out;
  for (const auto& [step, run] : frames)
    out += frame(step, run);
  return out;
}

} // namespace

TEST_CASE("later run: frames from the step on at which it begins are replaced") {
  const auto of = [](std::vector<double> moments) { return replaced(moments); };
  CHECK(of({0, 10, 20}) == std::vector<bool>(3));
  CHECK(of({0, 0, 0}) == std::vector<bool>(3)); // steps that are not known
  CHECK(of({0, 10, 20, 10, 20}) == std::vector<bool>{false, true, true, false, false});
  CHECK(of({0, 10, 20, 15, 20, 5, 30}) == std::vector<bool>{false, true, true, true, true, false, false});
  CHECK(of({0, 10, ends_early(20), 20}) == std::vector<bool>{false, false, true, false});
  CHECK(of({0, 10, ends_early(20), 30}) == std::vector<bool>(4));
}

TEST_CASE("later run: answers in dumps of grains and contacts, and in MercuryDPM's files") {
  const Files files;
  const std::vector<std::pair<int, int>> twice{{0, 1}, {10, 1}, {20, 1}, {30, 1}, {20, 2}, {30, 2}, {40, 2}};
  const Seen expected{.steps = {0, 10, 20, 30, 40}, .runs = {1, 1, 2, 2, 2}, .said = {}};
  const auto dump = files.write("a.dump", joined(dump_frame, twice));
  const auto contacts = files.write("c.dump", joined(contact_frame, twice));
  const auto data = files.write("m.data", joined(data_frame, twice));
  for (const auto& names :
       std::vector<std::vector<std::filesystem::path>>{{dump}, {dump, contacts}, {data}}) {
    Seen seen = Files::read(names);
    REQUIRE(seen.said.size() == 1);
    for (const char* number : {"20", " 2 "}) // where it begins, and the frames that it replaces
      CHECK(seen.said[0].find(number) != std::string::npos);
    seen.said.clear();
    CHECK(seen == expected);
  }
  // contacts written less often, and the frame in which the first run was killed
  const auto some = files.write("c.dump", joined(contact_frame, {{0, 1}, {30, 1}, {20, 2}, {30, 2}}));
  CHECK(Files::read({dump, some}).runs == std::vector<int>{1, 2, 2});
  std::string killed = joined(dump_frame, {{0, 1}, {10, 1}});
  killed.resize(killed.find_last_of("\n", killed.size() - 2) + 1); // a row is missing
  CHECK(Files::read({files.write("k.dump", killed + dump_frame(10, 2))}).runs == std::vector<int>{1, 2});
  // killed anywhere in a frame, within a line or a number too, and appended to
  const std::string whole = dump_frame(10, 1);
  for (std::size_t cut = 1; cut < whole.size() - 1; ++cut) {
    CAPTURE(whole.substr(0, cut));
    const std::string appended =
        dump_frame(0, 1) + whole.substr(0, cut) + dump_frame(10, 2) + dump_frame(20, 2);
    CHECK(Files::read({files.write("k.dump", appended)}).runs == std::vector<int>{1, 2, 2});
  }
  const auto gap = files.write("k.dump", killed + dump_frame(20, 2)); // the frame of step 10 is nowhere
  CHECK_THROWS_AS((void)Files::read({gap}), FileError);
}

TEST_CASE("later run: among files whose names differ in numbers") {
  const Files files;
  const auto first = files.write("run.1.dump", joined(dump_frame, {{0, 1}, {10, 1}, {20, 1}}));
  const auto read = [&](const std::string& name, const std::vector<std::pair<int, int>>& frames) {
    return Files::read({first, files.write(name, joined(dump_frame, frames))}).runs;
  };
  CHECK(read("run.2.dump", {{10, 2}, {20, 2}}) == std::vector<int>{1, 2, 2});
  CHECK(read("run.2.dump", {{20, 2}, {30, 2}}) == std::vector<int>{1, 1, 1, 2, 2}); // goes on
  CHECK(read("run.2.dump", {{0, 2}, {10, 2}}) == std::vector<int>{1, 1, 1, 2, 2});  // another simulation
  CHECK(read("sun.2.dump", {{10, 2}, {20, 2}}) == std::vector<int>{1, 1, 1, 2, 2}); // another series
}

TEST_CASE("later run: in an index file of a series") {
  const Files files;
  std::string index = "<VTKFile type=\"Collection\"><Collection>\n";
  const auto add = [&](int time, int run) {
    const std::string name = "g" + std::to_string(index.size()) + ".vtu";
    (void)files.write(name, grains_vtu({.cell = Mat3::diagonal(9, 9, 9),
                                        .position = {{1.0 * run, 0, 0}},
                                        .radius = {0.1},
                                        .contacts = {}}));
    index += "<DataSet timestep=\"" + std::to_string(time) + "\" part=\"0\" file=\"" + name + "\"/>\n";
  };
  for (const auto& [time, run] : std::vector<std::pair<int, int>>{{0, 1}, {10, 1}, {20, 1}, {10, 2}, {20, 2}})
    add(time, run);
  const Seen seen = Files::read({files.write("s.pvd", index + "</Collection></VTKFile>\n")});
  CHECK(seen.steps == std::vector<long>{0, 10, 20});
  CHECK(seen.runs == std::vector<int>{1, 2, 2});
  CHECK(seen.said.size() == 1);
}
