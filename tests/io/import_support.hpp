// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <granum/io/imported_packing.hpp>
#include <granum/io/packing_files.hpp>
#include <granum/io/text/source.hpp>

#include "unit.hpp"

/// What the tests of the readers share.
namespace granum::samples {

inline constexpr double force_ab = 0.0235294118; // [N], as the codes print it
inline constexpr double force_bc = 0.0665512265; // [N]

inline std::string data_path(const std::string& name) { return GRANUM_IO_DATA "/" + name; }

inline std::string data_text(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(data_path(name), std::ios::binary).rdbuf();
  if (text.str().empty())
    throw std::runtime_error("no test data " + name);
  return text.str();
}

inline io::TextSource text_source(const std::string& name, const std::string& text) {
  return io::TextSource::of_text(name, text);
}

/// The text with the first `from` replaced; `from` must be there.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
    throw std::runtime_error("the test data do not hold " + from);
  return text.replace(at, from.size(), to);
}

/// The message with which `action` refuses a file; empty if it does not.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

using MaybeText = std::optional<std::string>;

/// The states of texts with the names g, of grains, and c, of contacts.
inline io::PackingFrames states_of(const io::PackingFormat& format, const std::string& grains,
                                   const MaybeText& contacts = {},
                                   const io::PackingFileOptions& options = {}) {
  std::optional<io::TextSource> second;
  if (contacts)
    second = text_source("c", *contacts);
  return format.read(text_source("g", grains), std::move(second), options);
}

inline io::ImportedPacking first_of(const io::PackingFormat& format, const std::string& grains,
                                    const MaybeText& contacts = {},
                                    const io::PackingFileOptions& options = {}) {
  return states_of(format, grains, contacts, options).next().value();
}

/// The message with which the texts are refused in any of their frames.
inline std::string refusal_of(const io::PackingFormat& format, const std::string& grains,
                              const MaybeText& contacts = {}, const io::PackingFileOptions& options = {}) {
  return refusal([&] {
    const io::PackingFrames frames = states_of(format, grains, contacts, options);
    while (frames.next())
      continue;
  });
}

/// Changes of a text in one place, and the file and line that their refusals begin with.
struct Wrong {
  std::string from;
  std::vector<std::string> to;
  std::string place;
};

/// Each change of `text` is refused at its place.
template <class Refused>
void check_refused(const std::string& text, const std::vector<Wrong>& changes, const Refused& refused) {
  for (const Wrong& wrong : changes)
    for (const std::string& to : wrong.to) {
      CAPTURE(wrong.from);
      CAPTURE(to);
      const std::string said = refused(with(text, wrong.from, to));
      CHECK_FALSE(said.empty());
      CHECK(said.starts_with(wrong.place));
    }
}

/// The same of the grains alone or beside their contacts, and of the contacts of a format.
inline void check_refused(const io::PackingFormat& format, const std::string& grains,
                          const MaybeText& contacts, const std::vector<Wrong>& of_grains,
                          const std::vector<Wrong>& of_contacts = {}) {
  check_refused(grains, of_grains,
                [&](const std::string& changed) { return refusal_of(format, changed, contacts); });
  check_refused(contacts.value_or(""), of_contacts,
                [&](const std::string& changed) { return refusal_of(format, grains, changed); });
}

inline void check_vector(const Vec3& value, const Vec3& expected, double tolerance) {
  INFO(value.x, " ", value.y, " ", value.z, " expected ", expected.x, " ", expected.y, " ", expected.z);
  CHECK(norm(value - expected) <= tolerance * norm(expected));
}

/// The two contacts of the chain, whichever code wrote them; tolerance of forces, and of overlaps relative to
/// them.
inline void check_chain(const io::ImportedPacking& packing, double force_tolerance,
                        double overlap_tolerance) {
  const packing::Assembly& a = packing.assembly;
  REQUIRE(a.grain_count() == 3);
  REQUIRE(a.contacts.size() == 2);
  CHECK(a.radius == std::vector<double>{0.5e-3, 0.5e-3, 0.5e-3});
  const packing::Contact &ab = a.contacts[0], &bc = a.contacts[1];
  CHECK((ab.i == 0 && ab.j == 1 && bc.i == 1 && bc.j == 2));
  check_vector(ab.branch, {0.9999e-3, 0, 0}, 1e-6);
  check_vector(bc.branch, {0, 0, 0.9998e-3}, 1e-6);
  CHECK(ab.overlap == relative(1e-7, overlap_tolerance));
  CHECK(bc.overlap == relative(2e-7, overlap_tolerance));
  CHECK(ab.normal_force == relative(force_ab, force_tolerance));
  CHECK(bc.normal_force == relative(force_bc, force_tolerance));
}

} // namespace granum::samples
