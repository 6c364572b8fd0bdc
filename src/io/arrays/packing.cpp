// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/arrays/packing.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>

#include "io/packing_builder.hpp"

namespace granum::io {

namespace {

void require_length(const char* name, std::size_t length, std::size_t expected, const char* of) {
  if (length != 0 && length != expected)
    throw InvalidArgument(std::string(name) + " has " + std::to_string(length) + " elements, " + of +
                          " has " + std::to_string(expected));
}

void require_lengths(const ContactArrays& c) {
  const std::size_t contacts = c.grains.size();
  const std::pair<const char*, std::size_t> lengths[] = {
      {"branch", c.branch.size()},
      {"overlap", c.overlap.size()},
      {"force", c.force.size()},
      {"normal_force", c.normal_force.size()},
      {"tangential_force", c.tangential_force.size()},
      {"normal_stiffness", c.normal_stiffness.size()},
      {"tangential_stiffness", c.tangential_stiffness.size()},
      {"sliding", c.sliding.size()},
      {"rolling_stiffness", c.rolling_stiffness.size()},
      {"twisting_stiffness", c.twisting_stiffness.size()}};
  for (const auto& [name, length] : lengths)
    require_length(name, length, contacts, "contacts");
  if (!c.force.empty() && !(c.normal_force.empty() && c.tangential_force.empty()))
    throw InvalidArgument("force is the whole force: leave out normal_force and tangential_force");
  if (c.normal_force.empty() && !c.tangential_force.empty())
    throw InvalidArgument("tangential_force goes with normal_force, which is missing");
}

template <class Number>
Number element(std::span<const Number> values, std::size_t k) {
  return values.empty() ? Number{} : values[k];
}

/// Common to grains and walls.
PairRow row_from(const PackingBuilder& builder, const ContactArrays& c, std::size_t k) {
  return {.a = builder.index(c.grains[k][0], k + 1),
          .normal_force = element(c.normal_force, k),
          .tangential_force = element(c.tangential_force, k),
          .normal_stiffness = element(c.normal_stiffness, k),
          .tangential_stiffness = element(c.tangential_stiffness, k),
          .sliding = element(c.sliding, k),
          .rolling_stiffness = element(c.rolling_stiffness, k),
          .twisting_stiffness = element(c.twisting_stiffness, k),
          .line = k + 1};
}

/// Splits a whole force along the branch and across it.
void split_force(PairRow& row, const ContactArrays& c, std::size_t k) {
  if (c.force.empty() || norm(row.branch) <= 0)
    return;
  const Vec3 n = (1 / norm(row.branch)) * row.branch;
  row.normal_force = dot(c.force[k], n);
  row.tangential_force = c.force[k] + -row.normal_force * n;
}

PairRow pair_row(PackingBuilder& builder, const ContactArrays& c, std::size_t k) {
  PairRow row = row_from(builder, c, k);
  row.b = builder.index(c.grains[k][1], k + 1);
  row.branch = c.branch.empty() ? builder.touching_image(row.a, row.b, element(c.force, k), std::nullopt)
                                : c.branch[k];
  row.overlap = c.overlap.empty() ? builder.radius_sum(row.a, row.b) - norm(row.branch) : c.overlap[k];
  if (!c.branch.empty())
    builder.require_agreement(row);
  split_force(row, c, k);
  return row;
}

PairRow wall_row(const PackingBuilder& builder, const ContactArrays& c, std::size_t k) {
  PairRow row = row_from(builder, c, k);
  row.branch = c.branch[k];
  row.overlap = c.overlap.empty() ? builder.radius(row.a) - norm(row.branch) : c.overlap[k];
  split_force(row, c, k);
  return row;
}

void add_contacts(PackingBuilder& builder, const ContactArrays& c) {
  for (std::size_t k = 0; k < c.grains.size(); ++k) {
    const long other = c.grains[k][1];
    if (other >= 0) {
      builder.add(pair_row(builder, c, k));
      continue;
    }
    if (c.branch.empty())
      throw InvalidArgument("contacts[" + std::to_string(k) + "] is with a wall: branch is missing");
    builder.add_wall(wall_row(builder, c, k), -1 - other);
  }
}

void note_unknown(PackingBuilder& builder, const ContactArrays& c) {
  if (c.normal_stiffness.empty())
    builder.note(Finding::stiffness_unknown, "no stiffnesses were given");
  builder.note(Finding::history_unknown, "the loading history of the contacts is not in arrays");
  if (c.force.empty() && c.normal_force.empty()) {
    builder.expect_no_forces();
    builder.note(Finding::forces_unknown, "no forces were given");
  } else if (c.force.empty() && c.tangential_force.empty()) {
    builder.note(Finding::tangential_unknown, "no tangential forces were given");
  }
}

ImportedPacking build(const PackingArrays& arrays) {
  PackingBuilder builder("grains", "contacts");
  if (arrays.cell)
    builder.set_cell(*arrays.cell, arrays.periodic, 0);
  std::vector<GrainRow> rows(arrays.position.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k] = {.id = static_cast<long>(k),
               .position = arrays.position[k],
               .radius = arrays.radius[k],
               .line = k + 1,
               .body = arrays.body.empty() ? std::nullopt : std::optional(arrays.body[k] + 1)};
  builder.set_grains(std::move(rows));
  builder.note(Finding::law_unknown, "contact law and grain material are not in arrays");
  if (!arrays.contacts) {
    builder.note(Finding::contacts_unknown, "no contacts were given");
    return builder.finish(0, std::nullopt);
  }
  const ContactArrays& contacts = *arrays.contacts;
  note_unknown(builder, contacts);
  builder.expect_contacts(contacts.grains.size());
  add_contacts(builder, contacts);
  return builder.finish(0, std::nullopt);
}

} // namespace

namespace {

void require_different(std::span<const long> ids) {
  std::vector<long> sorted(ids.begin(), ids.end());
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    throw InvalidArgument("id " + std::to_string(*twice) + " occurs twice");
}

} // namespace

ImportedPacking packing_of(const PackingArrays& arrays) {
  if (arrays.radius.size() != arrays.position.size())
    throw InvalidArgument("radius has " + std::to_string(arrays.radius.size()) + " elements, position has " +
                          std::to_string(arrays.position.size()));
  require_length("body", arrays.body.size(), arrays.position.size(), "position");
  require_length("id", arrays.id.size(), arrays.position.size(), "position");
  require_different(arrays.id);
  if (arrays.contacts)
    require_lengths(*arrays.contacts);
  try {
    ImportedPacking packing = build(arrays);
    if (!arrays.id.empty())
      packing.id.assign(arrays.id.begin(), arrays.id.end());
    return packing;
  } catch (const FileError& error) {
    throw in_arrays(error);
  }
}

} // namespace granum::io
