// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <granum/core/text.hpp>

#include "io/packing_builder.hpp"
#include "io/text/row.hpp"

namespace granum::io {

void DigitWatch::see(std::string_view number) {
  if (seen_ > enough)
    return;
  seen_ = std::max(seen_, significant_digits(number));
  if (const auto value = parse_number(number))
    largest_ = std::max(largest_, std::abs(*value));
}

double DigitWatch::rounding() const {
  return few() && largest_ > 0 ? 0.5 * std::pow(10, std::floor(std::log10(largest_)) - most() + 1) : 0;
}

double DigitWatch::relative_rounding() const { return few() ? 0.5 * std::pow(10, 1 - most()) : 0; }

void PackingBuilder::note(Finding finding, std::string text) {
  const bool stated = (finding == Finding::units_unknown && options_.si) ||
                      (finding == Finding::boundary_unknown && options_.box) ||
                      (finding == Finding::shapes && options_.none("shape"));
  if (!stated)
    packing_.notes.push_back({finding, std::move(text)});
}

void PackingBuilder::note_unused(const std::vector<std::string>& names, const std::string& place) {
  const auto is_shape = [](std::string name) {
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::string_view words[] = {"shape", "blockiness", "quat", "superquadric", "aspect"};
    return std::ranges::any_of(words, [&](auto word) { return name.find(word) != std::string::npos; });
  };
  std::string shapes, others;
  for (const std::string& name : names) {
    std::string& list = is_shape(name) ? shapes : others;
    list += (list.empty() ? "" : ", ") + name;
  }
  if (!shapes.empty())
    note(Finding::shapes,
         place + " " + shapes +
             ": the grains have shapes and are not spheres, but were taken as spheres of their "
             "radius (if they are spheres: --column-map shape=none)");
  if (!others.empty())
    note(Finding::not_used, place + " that were not used: " + others);
}

void PackingBuilder::turn_signs() {
  constexpr std::size_t fewest = 10; // a few bonds may all be in tension
  std::size_t pulling = 0;
  for (const packing::Contact& c : packing_.assembly.contacts) {
    if (c.normal_force > 0 || (c.normal_force < 0 && !(c.overlap > 0)))
      return;
    pulling += c.normal_force < 0 ? 1 : 0;
  }
  if (!forces_known_ || pulling < fewest)
    return;
  for (auto* contacts : {&packing_.assembly.contacts, &packing_.assembly.wall_contacts, &own_images_})
    for (packing::Contact& c : *contacts) {
      c.normal_force = -c.normal_force;
      c.tangential_force = -c.tangential_force;
    }
  note(Finding::signs_turned,
       "the forces of all " + many(pulling, "contacts pull, though the spheres overlap: they have the other "
                                            "sign (force on the first grain, or tension positive), and "
                                            "were turned"));
}

void PackingBuilder::compare_forces() {
  if (stated_force_.empty() || packing_.assembly.contacts.empty() || !packing_.assembly.body.empty() ||
      !forces_known_)
    return;
  std::vector<Vec3> left = stated_force_;
  double sum = 0;
  const auto take = [&](const packing::Contact& c) {
    const Vec3 f = force(c);
    sum += norm(f);
    left[c.i] += f;
    return f;
  };
  for (const packing::Contact& c : packing_.assembly.contacts)
    left[c.j] -= take(c);
  for (const packing::Contact& c : packing_.assembly.wall_contacts)
    take(c);
  const auto contacts = packing_.assembly.contacts.size() + packing_.assembly.wall_contacts.size();
  constexpr double matters = 0.01;
  const double size = matters * sum / static_cast<double>(contacts);
  const auto off = static_cast<std::size_t>(
      std::count_if(left.begin(), left.end(), [&](const Vec3& f) { return norm(f) > size; }));
  const bool gravity = 2 * off > left.size(); // weight, or another force on all
  if (off > 0 && !gravity)
    note(Finding::unbalanced_rows,
         "the forces of " +
             many(off,
                  "grains (fx fy fz) are not the sums of their contacts': rows of contacts, or of walls, "
                  "are missing"));
}

void PackingBuilder::note_digits(const DigitWatch& coordinates, std::string_view what, double unit) {
  if (!coordinates.few())
    return;
  note(Finding::few_digits,
       std::string(what) + " have at most " + std::to_string(coordinates.most()) + " significant digits");
  packing_.rounding.length = unit * coordinates.rounding();
}

void PackingBuilder::note_overlap_digits(const DigitWatch& numbers, std::string_view what, double unit) {
  if (numbers.most() == 0)
    return;
  const double lengths = packing_.rounding.length;
  note_digits(numbers, what, unit);
  packing_.rounding = {
      .length = lengths, .overlap = unit * numbers.rounding(), .force = packing_.rounding.force};
  overlaps_stated_ = true;
}

void PackingBuilder::note_single_precision(std::string text) {
  note(Finding::few_digits, std::move(text));
  double largest = 0;
  for (const Vec3& x : positions())
    largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  packing_.rounding.length = largest * static_cast<double>(std::numeric_limits<float>::epsilon()) / 2;
}

void PackingBuilder::note_counts() {
  if (duplicated_ > 0)
    note(Finding::duplicated, many(duplicated_, "rows repeat a pair and were left out"));
  if (empty_ > 0)
    note(Finding::empty_rows, many(empty_, "rows of contacts hold zeros alone and were left out"));
  if (one_sided_ > 0)
    note(Finding::one_sided, many(one_sided_, "pairs are listed from one side only"));
  if (unsorted_)
    note(Finding::unsorted, "the contacts were not in the order of their grains");
  if (through_faces_ > 0)
    note(Finding::through_faces, many(through_faces_, "rows of contacts reach through periodic faces"));
  if (open_ > 0)
    note(Finding::open_contacts,
         many(open_,
              "rows without an overlap are kept as contacts: they carry a force, or the grains just touch"));
  if (neighbours_ > 0)
    note(Finding::open_contacts,
         many(neighbours_, "rows without overlap and force are neighbours, not contacts; left out"));
  if (const std::size_t walls = packing_.assembly.wall_contacts.size(); walls > 0)
    note(Finding::wall_contacts,
         many(walls, "contacts with walls carry stress, but count in neither C_n nor fabric"));
}

} // namespace granum::io
