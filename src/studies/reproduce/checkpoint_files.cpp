// SPDX-License-Identifier: GPL-3.0-or-later
// The files that run_experiment leaves in its folder of checkpoints, recognised by their names.
#include "studies/reproduce/experiment.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>
#include <granum/stress/stress.hpp>

#include "path_run.hpp"

namespace granum::studies {

namespace {

namespace fs = std::filesystem;

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Takes the beginning off the text, if it begins so.
bool skip(std::string_view& text, std::string_view beginning) {
  if (text.substr(0, beginning.size()) != beginning)
    return false;
  text.remove_prefix(beginning.size());
  return true;
}

/// "<number>-<kind>", with one of the given kinds.
bool is_numbered(std::string_view text, const std::vector<std::string>& what) {
  const std::size_t dash = text.find('-');
  return dash != std::string_view::npos && all_digits(text.substr(0, dash)) &&
         std::find(what.begin(), what.end(), text.substr(dash + 1)) != what.end();
}

/// Of a piece of work: "sphere-1-packing", "sphere-dense-1-txc".
bool is_piece(std::string_view stem) {
  std::vector<std::string> paths{path_in_file_names(std::nullopt)};
  for (const stress::ShearPath path : stress::all_shear_paths)
    paths.push_back(path_in_file_names(path));
  for (const contact::LawRow& row : contact::laws()) {
    std::string_view rest = stem;
    if (!skip(rest, std::string(name(row.shape)) + "-"))
      continue;
    if (is_numbered(rest, {"packing"}))
      return true;
    for (const triaxial::Density density : {triaxial::Density::dense, triaxial::Density::loose}) {
      std::string_view of_density = rest;
      if (skip(of_density, std::string(name(density)) + "-") && is_numbered(of_density, paths))
        return true;
    }
  }
  return false;
}

/// A checkpoint, or the unfinished file of a writer that was killed: "<piece>.checkpoint.granum.part".
bool is_checkpoint(std::string_view file) {
  constexpr std::string_view extension = ".checkpoint";
  const std::size_t at = file.find(extension);
  if (at == std::string_view::npos || !is_piece(file.substr(0, at)))
    return false;
  const std::string_view rest = file.substr(at + extension.size());
  return rest.empty() || rest == io::part_extension;
}

} // namespace

void remove_checkpoints(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  const fs::directory_iterator entries(folder, error);
  if (error && error != std::errc::no_such_file_or_directory)
    throw FileError(folder.string(), 0, "cannot be read: " + error.message());
  for (const fs::directory_entry& entry : entries)
    if (is_checkpoint(entry.path().filename().string()) &&
        (entry.is_regular_file(error) || entry.is_symlink(error)))
      files.push_back(entry.path());
  for (const fs::path& file : files)
    if (!fs::remove(file, error) && error)
      throw FileError(file.string(), 0, "cannot be removed: " + error.message());
}

} // namespace granum::studies
