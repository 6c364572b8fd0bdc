// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_files.hpp>

#include <string>
#include <system_error>
#include <utility>

#include <granum/core/error.hpp>

namespace granum::io {

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

} // namespace

std::string_view description(const FileKind& kind) {
  return kind.holds == Holds::contacts ? kind.format->contacts : kind.format->grains;
}

FileKind recognise(TextSource& source) {
  source.keep_from_start();
  if (!source.next())
    source.fail("is empty");
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
  for (PackingFile& file : files)
    (file.kind().holds == Holds::contacts ? contacts_ : grains_).push_back(std::move(file));
}

/// The frames of the files that come next.
PackingFrames PackingFiles::open_next() {
  const std::size_t at = opened_++;
  std::optional<TextSource> contacts;
  if (!contacts_.empty())
    contacts.emplace(contacts_[at].open());
  return grains_[at].kind().format->read(grains_[at].open(), std::move(contacts), options_);
}

std::optional<ImportedPacking> PackingFiles::next() {
  while (true) {
    if (frames_) {
      if (auto packing = frames_->next())
        return packing;
      skipped_ = skipped();
      frames_.reset();
    }
    if (opened_ == grains_.size())
      return std::nullopt;
    frames_ = open_next();
  }
}

std::size_t PackingFiles::skipped() const { return skipped_ + (frames_ ? frames_->skipped() : 0); }

} // namespace granum::io
