// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/io/text/source.hpp>

/// What the fuzz targets share. A reader may take an input or refuse it with FileError; anything else is a
/// fault.
namespace granum::fuzz {

/// Divides an input for readers of two files: a line "=====" stands between them.
inline constexpr std::string_view border = "=====\n";

struct Parts {
  std::string_view first;
  std::optional<std::string_view> second;
};

inline std::string_view text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

inline Parts parts(std::string_view input) {
  const std::size_t at = input.find(border);
  if (at == std::string_view::npos)
    return {input, std::nullopt};
  return {input.substr(0, at), input.substr(at + border.size())};
}

inline void demand(bool promise) {
  if (!promise)
    std::abort();
}

/// What every imported packing promises.
inline void check(const io::ImportedPacking& packing) {
  const packing::Assembly& a = packing.assembly;
  require_valid(a);
  demand(packing.id.size() == a.grain_count());
  demand(packing.type.empty() || packing.type.size() == a.grain_count());
  for (std::size_t k = 1; k < packing.id.size(); ++k)
    demand(packing.id[k - 1] < packing.id[k]);
  for (std::size_t k = 1; k < a.contacts.size(); ++k) {
    // A pair of a narrow cell may touch through several images, which stand in the order of their branches.
    const packing::Contact &before = a.contacts[k - 1], &here = a.contacts[k];
    const Vec3 &from = before.branch, &to = here.branch;
    demand(std::tie(before.i, before.j, from.x, from.y, from.z) < std::tie(here.i, here.j, to.x, to.y, to.z));
  }
}

/// Runs a reader; the refusals that it may make are taken for an answer.
template <class Action>
int run(const Action& action) {
  try {
    action();
  } catch (const FileError&) {
    return 0;
  }
  return 0;
}

/// Runs a reader of one file, or of two where the input has two parts.
template <class Read>
int run_packing(const std::uint8_t* data, std::size_t size, const Read& read) {
  return run([&] {
    const Parts input = parts(text(data, size));
    io::TextSource grains = io::TextSource::of_text("grains", input.first);
    if (input.second)
      check(read(std::move(grains), io::TextSource::of_text("contacts", *input.second)));
    else
      check(read(std::move(grains)));
  });
}

} // namespace granum::fuzz
