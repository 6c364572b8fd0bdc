// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_files.hpp>

#include <algorithm>
#include <functional>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/lammps_data.hpp>
#include <granum/io/lammps_dump.hpp>
#include <granum/io/mercury.hpp>
#include <granum/io/yade_text.hpp>
#include <granum/io/yade_vtk.hpp>

#include "text_row.hpp"

namespace granum::io {

namespace {

namespace fs = std::filesystem;

/// Lines of a file that are looked at before it is given up.
constexpr int lines_of_a_header = 40;

/// Whether a line consists of numbers, at least `fewest` of them.
bool all_numbers(std::string_view line, std::size_t fewest) {
  std::size_t count = 0;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    if (!parse_number(line.substr(0, end)))
      return false;
    ++count;
    line.remove_prefix(end);
  }
  return count >= fewest;
}

FileKind kind_of_dump(TextSource& source) {
  for (int k = 0; k < lines_of_a_header && source.next(); ++k) {
    if (source.line().starts_with("ITEM: NUMBER OF ATOMS"))
      return FileKind::dump_grains;
    if (source.line().starts_with("ITEM: NUMBER OF "))
      return FileKind::dump_contacts;
  }
  source.fail("a dump without ITEM: NUMBER OF ATOMS or ENTRIES");
}

FileKind kind_of_vtk(TextSource& source) {
  while (source.next())
    if (source.line().starts_with("LINES"))
      return FileKind::vtk_contacts;
  return FileKind::vtk_grains;
}

/// What a file that begins with a remark holds; nothing if the remark does not tell.
std::optional<FileKind> kind_by_remark(std::string_view line) {
  if (line.starts_with("#format") || line.starts_with("# granum: grains of a YADE"))
    return FileKind::yade_grains;
  if (line.starts_with("# granum: contacts of a YADE") || line.starts_with("# id1 id2 "))
    return FileKind::yade_contacts;
  if (line.starts_with("#") && all_numbers(line.substr(1), 2))
    return FileKind::mercury_fstat;
  return std::nullopt;
}

bool names_a_normal(std::string_view heading) {
  return heading.starts_with("nx") || heading.find(",nx") != std::string_view::npos ||
         heading.find(", nx") != std::string_view::npos;
}

/// Of a file that begins with neither a key word nor a remark that tells.
FileKind kind_of_table(TextSource& source) {
  constexpr std::size_t numbers_of_mercury = 6; // N, time and a box in two dimensions
  if (all_numbers(source.line(), numbers_of_mercury))
    return FileKind::mercury_data;
  std::optional<FileKind> csv;
  bool heading_seen = false;
  source.hold();
  for (int k = 0; k < lines_of_a_header && source.next(); ++k) {
    const std::string_view line = trimmed(source.line());
    const auto count = leading_number(line);
    if (count && trimmed(count->rest) == "atoms")
      return FileKind::lammps_data; // whose first line may hold anything, commas as well
    const bool remark = line.empty() || line.starts_with('#');
    if (!remark && !heading_seen && line.find(',') != std::string_view::npos)
      csv = names_a_normal(line) ? FileKind::csv_contacts : FileKind::csv_grains;
    heading_seen = heading_seen || !remark;
  }
  if (csv)
    return *csv;
  source.fail("of no format that granum reads: LAMMPS or LIGGGHTS dumps, LAMMPS data, YADE's text or VTK, "
              "MercuryDPM's .data and .fstat, CSV");
}

using Reader = std::function<std::optional<ImportedPacking>()>;

/// A reader of files that hold one state.
Reader once(ImportedPacking packing) {
  return [packing = std::optional(std::move(packing))]() mutable { return std::exchange(packing, {}); };
}

/// A reader that goes on from frame to frame, and what it passes over.
template <class Frames>
Reader frames(Frames source, std::size_t& skipped) {
  const auto shared = std::make_shared<Frames>(std::move(source));
  return [shared, &skipped, before = skipped] {
    auto packing = shared->next();
    skipped = before + shared->skipped();
    return packing;
  };
}

FileKind partner_of(FileKind grains) {
  switch (grains) {
  case FileKind::dump_grains:
    return FileKind::dump_contacts;
  case FileKind::mercury_data:
    return FileKind::mercury_fstat;
  case FileKind::yade_grains:
    return FileKind::yade_contacts;
  case FileKind::vtk_grains:
    return FileKind::vtk_contacts;
  default:
    return FileKind::csv_contacts;
  }
}

} // namespace

std::string_view description(FileKind kind) {
  switch (kind) {
  case FileKind::dump_grains:
    return "a LAMMPS dump of grains";
  case FileKind::dump_contacts:
    return "a LAMMPS dump of contacts";
  case FileKind::lammps_data:
    return "a LAMMPS data file";
  case FileKind::mercury_data:
    return "a MercuryDPM .data file";
  case FileKind::mercury_fstat:
    return "a MercuryDPM .fstat file";
  case FileKind::yade_grains:
    return "grains of YADE as text";
  case FileKind::yade_contacts:
    return "contacts of YADE as text";
  case FileKind::vtk_grains:
    return "grains of YADE as VTK";
  case FileKind::vtk_contacts:
    return "contacts of YADE as VTK";
  case FileKind::csv_grains:
    return "a CSV table of grains";
  case FileKind::csv_contacts:
    return "a CSV table of contacts";
  }
  return "";
}

bool holds_contacts(FileKind kind) {
  return kind == FileKind::dump_contacts || kind == FileKind::mercury_fstat ||
         kind == FileKind::yade_contacts || kind == FileKind::vtk_contacts || kind == FileKind::csv_contacts;
}

FileKind recognise(TextSource source) {
  if (!source.next())
    source.fail("is empty");
  const std::string_view line = source.line();
  if (line.starts_with("ITEM:")) {
    source.hold();
    return kind_of_dump(source);
  }
  if (line.starts_with("# vtk DataFile"))
    return kind_of_vtk(source);
  if (const auto kind = kind_by_remark(line))
    return *kind;
  return kind_of_table(source);
}

struct PackingFiles::Impl {
  PackingFileOptions options;
  std::vector<FileKind> kinds;
  std::vector<fs::path> grains, contacts;
  FileKind kind = FileKind::dump_grains; ///< of the files of grains
  std::size_t opened = 0, skipped = 0;
  Reader reader;

  /// The reader of the files that stand at a place in the lists.
  Reader open(std::size_t at) {
    TextSource first(grains[at]);
    std::optional<TextSource> second;
    if (!contacts.empty())
      second.emplace(contacts[at]);
    switch (kind) {
    case FileKind::dump_grains:
      return second ? frames(LammpsDump(std::move(first), std::move(*second), options.columns), skipped)
                    : frames(LammpsDump(std::move(first), options.columns), skipped);
    case FileKind::mercury_data:
      return second ? frames(MercuryOutput(std::move(first), std::move(*second)), skipped)
                    : frames(MercuryOutput(std::move(first)), skipped);
    case FileKind::lammps_data:
      return once(read_lammps_data(std::move(first)));
    case FileKind::yade_grains:
      return once(second ? read_yade(std::move(first), std::move(*second)) : read_yade(std::move(first)));
    case FileKind::vtk_grains:
      return once(second ? read_yade_vtk(std::move(first), std::move(*second))
                         : read_yade_vtk(std::move(first)));
    default:
      return once(second ? read_packing_csv(std::move(first), std::move(*second), options.box)
                         : read_packing_csv(std::move(first), options.box));
    }
  }
};

PackingFiles::PackingFiles(const std::vector<fs::path>& files, PackingFileOptions options)
    : impl_(std::make_unique<Impl>()) {
  impl_->options = std::move(options);
  for (const fs::path& file : files) {
    impl_->kinds.push_back(recognise(TextSource(file)));
    (holds_contacts(impl_->kinds.back()) ? impl_->contacts : impl_->grains).push_back(file);
  }
  if (impl_->grains.empty())
    throw InvalidArgument("a file of grains is missing: contacts alone do not make a packing");
  if (!impl_->contacts.empty() && impl_->contacts.size() != impl_->grains.size())
    throw InvalidArgument(std::to_string(impl_->grains.size()) + " files of grains do not go with " +
                          std::to_string(impl_->contacts.size()) + " of contacts");
  const std::vector<FileKind>& kinds = impl_->kinds;
  impl_->kind = *std::find_if_not(kinds.begin(), kinds.end(), holds_contacts);
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (kinds[k] != (holds_contacts(kinds[k]) ? partner_of(impl_->kind) : impl_->kind))
      throw InvalidArgument(files[k].string() + " is " + std::string(description(kinds[k])) +
                            ", which does not go with " + std::string(description(impl_->kind)));
}

PackingFiles::PackingFiles(PackingFiles&&) noexcept = default;
PackingFiles& PackingFiles::operator=(PackingFiles&&) noexcept = default;
PackingFiles::~PackingFiles() = default;

std::optional<ImportedPacking> PackingFiles::next() {
  while (true) {
    if (impl_->reader)
      if (auto packing = impl_->reader())
        return packing;
    if (impl_->opened == impl_->grains.size())
      return std::nullopt;
    impl_->reader = impl_->open(impl_->opened++);
  }
}

const std::vector<FileKind>& PackingFiles::kinds() const { return impl_->kinds; }
std::size_t PackingFiles::skipped() const { return impl_->skipped; }

} // namespace granum::io
