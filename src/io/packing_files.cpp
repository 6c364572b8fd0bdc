// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_files.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <system_error>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/io/text/source.hpp>
#include <granum/io/vtk/xml.hpp>

#include "io/later_run.hpp"
#include "io/text/row.hpp"

namespace granum::io {

PackingFrames one_frame(ImportedPacking packing) {
  return {
      .next = [packing = std::optional(std::move(packing))]() mutable { return std::exchange(packing, {}); }};
}

namespace {

namespace fs = std::filesystem;

std::string names_of_formats() {
  std::string names;
  for (const PackingFormat* format : packing_formats)
    names += (names.empty() ? "" : ", ") + std::string(format->name);
  return names;
}

/// \throws   InvalidArgument unless the files are of one format, with as many of contacts as of grains or
///            none
void require_one_packing(const std::vector<PackingFile>& files) {
  std::size_t grains = 0;
  const FileKind* first = nullptr; // of grains
  for (const PackingFile& file : files)
    if (file.kind().holds == Holds::grains) {
      ++grains;
      first = first != nullptr ? first : &file.kind();
    }
  const std::size_t contacts = files.size() - grains;
  if (grains == 0)
    throw InvalidArgument("a file of grains is missing: contacts alone do not make a packing");
  if (contacts > 0 && contacts != grains)
    throw InvalidArgument(std::to_string(grains) + " files of grains do not go with " +
                          std::to_string(contacts) + " of contacts");
  for (const PackingFile& file : files)
    if (file.kind().format != first->format)
      throw InvalidArgument(file.path().string() + " is " + std::string(description(file.kind())) +
                            ", which does not go with " + std::string(description(*first)));
}

/// A file of a name, and its position in it.
struct NamedFile {
  PackingFile file;
  std::string name; ///< that was given
  std::size_t place = 0;
  std::optional<double> time = {}; ///< from the series
};

bool is_series(const fs::path& name) {
  std::error_code unknown; // a pipe can be read only once, and is no list of files
  if (!fs::is_regular_file(name, unknown))
    return false;
  TextSource source(name);
  return is_collection(source);
}

/// A name of a file, or of a series of them.
std::vector<NamedFile> files_of(const fs::path& name) {
  std::vector<NamedFile> out;
  if (!is_series(name)) {
    out.push_back({.file = PackingFile(name), .name = name.string()});
    return out;
  }
  for (const SeriesEntry& entry : read_collection(TextSource(name))) {
    out.push_back({.file = PackingFile(name.parent_path() / entry.file),
                   .name = name.string(),
                   .place = out.size(),
                   .time = entry.time});
    out.back().file.set_time(entry.time);
    if (entry.replaced > 0)
      out.back().file.set_replaced(replaced_text(name.string(), entry.replaced, entry.time));
  }
  return out;
}

/// Whether a number of the name has a decimal point: the order of such names is found in the files only.
bool has_decimals(const std::string& name) {
  const auto digit = [&](std::size_t k) { return k < name.size() && name[k] >= '0' && name[k] <= '9'; };
  for (std::size_t k = 1; k + 1 < name.size(); ++k)
    if (name[k] == '.' && digit(k - 1) && digit(k + 1))
      return true;
  return false;
}

/// The first time step of a dump; empty for other files.
std::optional<double> first_step(const PackingFile& file) {
  std::error_code unknown;
  if (file.kind().format != &lammps_dump_format || !fs::is_regular_file(file.path(), unknown))
    return std::nullopt;
  TextSource source(file.path());
  for (int k = 0; k < lines_looked_at && source.next(); ++k)
    if (source.line().starts_with("ITEM: TIMESTEP"))
      return source.next() ? parse_number(std::string(trimmed(source.line()))) : std::nullopt;
  return std::nullopt;
}

/// Time steps to sort files whose names differ in decimal numbers; none if the names suffice.
std::vector<double> steps_of(const std::vector<NamedFile>& files) {
  std::vector<std::string> names;
  for (const NamedFile& file : files)
    names.push_back(file.name);
  const std::vector<std::string> series = series_by_name(names);
  std::vector<double> steps;
  if (std::none_of(names.begin(), names.end(), has_decimals) ||
      std::adjacent_find(series.begin(), series.end(), std::not_equal_to<>()) != series.end())
    return {};
  for (const NamedFile& file : files) {
    const auto step = first_step(file.file);
    if (!step)
      return {};
    steps.push_back(*step);
  }
  return steps;
}

/// \throws   InvalidArgument for the first state whose grains and contacts are of different times
void require_one_time(const NamedFile& grains, const NamedFile& contacts) {
  if (grains.time && contacts.time && *grains.time != *contacts.time)
    throw InvalidArgument(grains.file.path().string() + " is of the time " + short_text(*grains.time, 12) +
                          ", " + contacts.file.path().string() + " of " + short_text(*contacts.time, 12) +
                          ": series of grains and contacts must have the same times");
}

} // namespace

std::vector<PackingFile> files_of_series(const std::vector<fs::path>& names) {
  std::vector<NamedFile> grains, contacts;
  for (const fs::path& name : names)
    for (NamedFile& one : files_of(name))
      (one.file.kind().holds == Holds::contacts ? contacts : grains).push_back(std::move(one));
  std::vector<std::size_t> order(std::max(grains.size(), contacts.size()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  const bool pairs = grains.size() == contacts.size();
  if (pairs)
    for (const std::size_t k : order)
      require_one_time(grains[k], contacts[k]);
  const std::vector<NamedFile>& leading = grains.size() < contacts.size() ? contacts : grains;
  const std::vector<double> steps = steps_of(leading);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (!steps.empty() && steps[a] != steps[b])
      return steps[a] < steps[b];
    if (leading[a].name != leading[b].name)
      return natural_less(leading[a].name, leading[b].name);
    return leading[a].place < leading[b].place;
  });
  std::vector<PackingFile> out;
  for (auto* files : {&grains, &contacts})
    for (const std::size_t k : order)
      if (k < files->size())
        out.push_back(std::move((*files)[k].file));
  return out;
}

std::string_view description(const FileKind& kind) {
  return kind.holds == Holds::contacts ? kind.format->contacts : kind.format->grains;
}

/// Files that people have and granum does not read, by how their first line begins.
struct UnreadFormat {
  std::string_view begins, name, instead;
};
constexpr UnreadFormat unread_formats[] = {
    {"Begin ", "a model part of Kratos (.mdpa)",
     "write the grains as a table x,y,z,radius, or the results as VTK"},
    {"\x89HDF", "HDF5, as Blaze-DEM and others write it", "write grains and contacts as tables (CSV)"},
    {"PK\x03\x04", "a zip archive, as MUSEN's projects and numpy's .npz are",
     "write grains and contacts as tables (CSV)"},
};

FileKind recognise(TextSource& source) {
  source.keep_from_start();
  if (!source.next())
    source.fail("is empty");
  for (const UnreadFormat& format : unread_formats)
    if (source.line().starts_with(format.begins))
      source.fail("is " + std::string(format.name) +
                  ", which granum does not read: " + std::string(format.instead));
  for (const PackingFormat* format : packing_formats) {
    source.back_to_start();
    if (const auto holds = format->recognise(source)) {
      source.back_to_start();
      source.stop_keeping();
      return {format, *holds};
    }
  }
  source.fail("of no format that granum reads: " + names_of_formats());
}

PackingFile::PackingFile(fs::path path) : path_(std::move(path)) {
  TextSource source(path_);
  kind_ = recognise(source);
  if (std::error_code unknown; !fs::is_regular_file(path_, unknown))
    source_.emplace(std::move(source));
}

TextSource PackingFile::open() { return source_ ? std::move(*source_) : TextSource(path_); }

PackingFiles::PackingFiles(std::vector<PackingFile> files, PackingFileOptions options)
    : options_(std::move(options)) {
  require_one_packing(files);
  for (const auto& [quantity, column] : options_.columns)
    if (files.front().kind().format != &lammps_dump_format && column != "none")
      throw InvalidArgument("column map: '" + quantity + "=" + column + "' is for dumps, and " +
                            files.front().path().string() +
                            " is none: " + std::string(description(files.front().kind())));
  for (PackingFile& file : files)
    (file.kind().holds == Holds::contacts ? contacts_ : grains_).push_back(std::move(file));
  constexpr double largest = 9e15;
  steps_ = std::ranges::all_of(grains_, [](const PackingFile& file) {
    return file.time() && *file.time() == std::floor(*file.time()) && std::abs(*file.time()) <= largest;
  });
}

/// The frames of the files that come next.
PackingFrames PackingFiles::open_next() {
  const std::size_t at = opened_++;
  std::optional<TextSource> contacts;
  if (!contacts_.empty())
    contacts.emplace(contacts_[at].open());
  return grains_[at].kind().format->read(grains_[at].open(), std::move(contacts), options_);
}

void PackingFiles::look_ahead() {
  const PackingFile& file = grains_[opened_ - 1];
  if (!file.replaced().empty())
    replaced_.push_back(file.replaced());
  const auto say = [&](std::size_t frames, double begin) {
    if (frames > 0)
      replaced_.push_back(replaced_text(file.path().string(), frames, begin));
  };
  const std::vector<bool> again = io::replaced(frames_->moments);
  std::vector<double> moments; // of the frames that are answered
  double begin = no_moment;
  for (std::size_t k = 0; k < again.size(); ++k) {
    if (!again[k])
      moments.push_back(frames_->moments[k]);
    if (k > 0 && frames_->moments[k] < frames_->moments[k - 1])
      begin = std::min(begin, frames_->moments[k]);
  }
  say(again.size() - moments.size(), begin);
  if (moments.size() < 2)
    return;
  std::vector<std::string> names;
  for (std::size_t k = opened_ - 1; k < grains_.size(); ++k)
    names.push_back(grains_[k].path().string());
  const std::vector<std::string> series = series_by_name(names);
  for (std::size_t k = 1; k < names.size(); ++k)
    if (const auto step = first_step(grains_[opened_ - 1 + k]);
        step && series[k] == series[0] && moments.front() < *step && *step < moments.back())
      until_ = std::min(until_, *step);
  if (until_ < no_moment)
    say(static_cast<std::size_t>(std::ranges::count_if(moments, [&](double m) { return m >= until_; })),
        until_);
}

std::optional<ImportedPacking> PackingFiles::next_of_file() {
  auto packing = frames_->next();
  const std::optional<double>& place = grains_[opened_ - 1].time();
  if (packing && place && steps_)
    packing->step = static_cast<long>(*place);
  else if (packing && place && !packing->time)
    packing->time = place;
  return packing;
}

std::optional<ImportedPacking> PackingFiles::next() {
  while (true) {
    try {
      if (frames_) {
        auto packing = next_of_file();
        if (packing && static_cast<double>(packing->step) >= until_)
          continue;
        if (packing) {
          begun_ = true;
          return packing;
        }
        skipped_ = skipped();
        frames_.reset();
      }
      if (opened_ == grains_.size())
        return std::nullopt;
      until_ = no_moment;
      frames_ = open_next();
      look_ahead();
    } catch (const CutFile& error) {
      const bool answered_later = until_ < no_moment;
      if (!answered_later && (!begun_ || opened_ != grains_.size()))
        throw;
      skipped_ = skipped();
      frames_.reset();
      if (!answered_later)
        cut_ = error.what();
    }
  }
}

std::size_t PackingFiles::skipped() const { return skipped_ + (frames_ ? frames_->skipped() : 0); }

} // namespace granum::io
