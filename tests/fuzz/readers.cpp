// SPDX-License-Identifier: GPL-3.0-or-later
// Every reader of files.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <granum/io/csv/table.hpp>
#include <granum/io/lammps/arrays.hpp>
#include <granum/io/packing_files.hpp>
#include <granum/io/vtk/xml.hpp>

#include "input.hpp"

namespace {

using namespace granum;
using fuzz::demand;

io::TextSource source(std::string_view text) { return io::TextSource::of_text("file", text); }

/// What every imported packing promises.
void check(const io::ImportedPacking& packing) {
  const packing::Assembly& a = packing.assembly;
  require_valid(a);
  demand(packing.id.size() == a.grain_count());
  demand(packing.type.empty() || packing.type.size() == a.grain_count());
  for (std::size_t k = 1; k < packing.id.size(); ++k)
    demand(packing.id[k - 1] < packing.id[k]);
  for (std::size_t k = 1; k < a.contacts.size(); ++k) {
    // A pair of a narrow cell may touch through several images, in the order of their branches.
    const packing::Contact &before = a.contacts[k - 1], &here = a.contacts[k];
    const Vec3 &from = before.branch, &to = here.branch;
    demand(std::tie(before.i, before.j, from.x, from.y, from.z) < std::tie(here.i, here.j, to.x, to.y, to.z));
  }
}

/// A packing of one file, or of two where a line "=====" separates them.
template <const io::PackingFormat& format>
void packing(std::string_view input) {
  constexpr std::string_view border = "=====\n";
  const std::size_t at = input.find(border);
  std::optional<io::TextSource> contacts;
  if (at != std::string_view::npos)
    contacts = source(input.substr(at + border.size()));
  fuzz::taken_or_refused<FileError>([&] {
    const io::PackingFrames frames = format.read(source(input.substr(0, at)), std::move(contacts), {});
    while (const auto read = frames.next())
      check(*read);
  });
}

/// The bytes of a file, plain or compressed: whatever zlib makes of them, the lines end and are numbered.
void text_source(std::string_view input) {
  const fuzz::MemoryFile file(input);
  io::TextSource lines{std::filesystem::path(file.path())};
  for (std::size_t count = 1; lines.next(); ++count) {
    demand(lines.line_number() == count);
    demand(lines.line().find('\n') == std::string_view::npos);
  }
}

void packing_kind(std::string_view input) {
  io::TextSource file = source(input);
  demand(!io::description(io::recognise(file)).empty());
  demand(file.next() && file.line_number() == 1);
}

/// A curve without fault is a distribution.
void sieve(std::string_view input) {
  const std::vector<sizes::SievePoint> curve = io::sieve_curve(io::CsvTable("sieves", input));
  demand(!sizes::find_fault(curve));
  const auto grains = sizes::Distribution::sieve(curve);
  demand(grains.mean_radius() && *grains.mean_radius() > 0);
  demand(grains.smallest() <= 1 && grains.largest() >= 1);
  demand(grains.moment(3) >= 1 - 1e-9);
}

/// Series of VTK files: in the order of their times, and equal when written and read again, but for control
/// characters, which XML cannot hold.
void vtk_series(std::string_view input) {
  io::TextSource first = source(input);
  (void)io::is_collection(first);
  const std::vector<io::SeriesEntry> series = io::read_collection(source(input));
  demand(!series.empty());
  bool writable = true;
  for (std::size_t k = 0; k < series.size(); ++k) {
    demand(std::isfinite(series[k].time) && !series[k].file.empty());
    demand(k == 0 || series[k - 1].time < series[k].time);
    writable = writable && std::ranges::none_of(series[k].file,
                                                [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  }
  if (!writable)
    return;
  const std::vector<io::SeriesEntry> again = io::read_collection(source(io::pvd(series)));
  demand(again.size() == series.size());
  for (std::size_t k = 0; k < series.size(); ++k)
    demand(again[k].time == series[k].time && again[k].file == series[k].file);
}

void column_map(std::string_view input) {
  for (const auto& [quantity, column] : io::parse_column_map(input))
    demand(!quantity.empty() && !column.empty());
}

template <auto read, class Refusal = FileError>
void refusing(std::string_view input) {
  fuzz::taken_or_refused<Refusal>([&] { read(input); });
}

const fuzz::Named readers[] = {
    {"lammps_dump", packing<io::lammps_dump_format>},
    {"lammps_data", packing<io::lammps_data_format>},
    {"yade_text", packing<io::yade_text_format>},
    {"yade_vtk", packing<io::yade_vtk_format>},
    {"vtk_xml", packing<io::vtk_xml_format>},
    {"mercury", packing<io::mercury_format>},
    {"extended_xyz", packing<io::extended_xyz_format>},
    {"packing_csv", packing<io::csv_format>},
    {"text_source", refusing<text_source>},
    {"packing_kind", refusing<packing_kind>},
    {"sieve", refusing<sieve>},
    {"vtk_series", refusing<vtk_series>},
    {"column_map", refusing<column_map, InvalidArgument>},
};

} // namespace
