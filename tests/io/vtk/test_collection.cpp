// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/vtk/xml.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

const std::vector<SeriesEntry> entries{{20, "grains-20.vtu"}, {-0.5, "a & b/grains.vtu"}, {3.25, "c.vtu"}};

std::vector<SeriesEntry> read(const std::string& text) { return read_collection(text_source("s.pvd", text)); }
std::string collection_refused(const std::string& text) {
  const std::string said = refusal([&] { (void)read(text); });
  return said.substr(std::min(said.find("s.pvd"), said.size()));
}

} // namespace

TEST_CASE("VTK series: of granum and of other programs, in the order of the times") {
  const std::vector<SeriesEntry> back = read(pvd(entries));
  REQUIRE(back.size() == 3);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK((back[k].time == entries[(k + 1) % 3].time && back[k].file == entries[(k + 1) % 3].file));
  const std::vector<SeriesEntry> other = read(
      "<?xml version='1.0'?>\r\n<!-- by hand -->\r\n<VTKFile byte_order='LittleEndian' type='Collection'>\r\n"
      "<Collection><DataSet group='' file='b.vtp' timestep='1e-3' part='0'></DataSet>\r\n"
      "<DataSet timestep='0' file='a.vtp'/></Collection></VTKFile>");
  REQUIRE(other.size() == 2);
  CHECK((other[0].file == "a.vtp" && other[1].file == "b.vtp" && other[1].time == 1e-3));
}

TEST_CASE("VTK series: told from other files") {
  const auto told = [](const std::string& text) {
    TextSource source = text_source("s", text);
    return is_collection(source);
  };
  CHECK(told(pvd(entries)));
  CHECK(told("<VTKFile type=\"Collection\">\n"));
  CHECK_FALSE(told(data_text("yade_chain.vtu")));
  CHECK_FALSE(told("a <VTKFile type=\"Collection\">\n"));
  CHECK_FALSE(told("<?xml?>\n<html/>\n"));
  CHECK_FALSE(told(""));
}

TEST_CASE("VTK series: damaged files are refused with their line") {
  const std::string good = pvd(entries);
  for (const std::string& wrong : {good.substr(0, good.size() - 12), pvd({}), std::string()})
    CHECK(collection_refused(wrong) != "");
  check_refused(good,
                {{"timestep=\"20\"", {"timestep=\"nan\""}, "s.pvd:4:"},
                 {" timestep=\"20\"", {""}, "s.pvd"},
                 {" file=\"c.vtu\"", {""}, "s.pvd:6:"},
                 {"3.25", {"-0.5"}, "s.pvd"},
                 {"Collection\"", {"PolyData\""}, "s.pvd:2:"},
                 {"<VTKFile", {"<!DOCTYPE VTKFile><VTKFile"}, "s.pvd"}},
                collection_refused);
}
