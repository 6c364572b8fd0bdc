// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/grain_fields.hpp>

#include <charconv>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/packing/forces.hpp>

#include "io/grain_numbers.hpp"

namespace granum::io {

namespace {

template <class Number>
void append(std::string& text, Number number) {
  char buffer[64];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
}

/// Three numbers between blanks.
void append(std::string& text, const Vec3& v) {
  for (int k = 0; k < 3; ++k) {
    text += k > 0 ? " " : "";
    append(text, v[k]);
  }
}

} // namespace

void require_numbers(const packing::Assembly& assembly, std::span<const long> id,
                     std::span<const GrainField> fields) {
  require_valid(assembly);
  const std::size_t grains = assembly.grain_count();
  const auto refuse = [&](const std::string& name, std::size_t count) {
    throw InvalidArgument(name + " has " + std::to_string(count) + " numbers for " + std::to_string(grains) +
                          " grains");
  };
  if (!id.empty() && id.size() != grains)
    refuse("id", id.size());
  for (const GrainField& field : fields)
    if (field.values.size() != field.components * grains)
      refuse(field.name, field.values.size());
}

std::vector<GrainField> grain_fields(const packing::Assembly& assembly, KnownForces known) {
  std::vector<GrainField> out{{.name = "radius", .values = assembly.radius}};
  std::vector<double> contacts(assembly.grain_count());
  for (const packing::Contact& c : assembly.contacts)
    contacts[c.i] += 1, contacts[c.j] += 1;
  out.push_back({.name = "contacts", .values = std::move(contacts), .whole = true});
  const auto rattler = mechanical_coordination(assembly, packing::ContactKind::frictional).rattler;
  out.push_back({.name = "rattler", .values = {rattler.begin(), rattler.end()}, .whole = true});
  if (known == KnownForces::none)
    return out;
  GrainField pressure{.name = "pressure"}, all{.name = "grain_stress", .components = 9};
  for (const Mat3& stress : grain_stresses(assembly)) {
    pressure.values.push_back(trace(stress) / 3);
    for (const auto& row : stress.m)
      all.values.insert(all.values.end(), std::begin(row), std::end(row));
  }
  out.push_back(std::move(pressure));
  if (known == KnownForces::all)
    out.push_back(std::move(all));
  return out;
}

std::string grains_xyz(const packing::Assembly& assembly, const std::array<bool, 3>& periodic,
                       std::span<const GrainField> fields, std::span<const long> id,
                       std::optional<double> time) {
  require_numbers(assembly, id, fields);
  std::string text = std::to_string(assembly.grain_count()) + "\nLattice=\"";
  for (int edge = 0; edge < 3; ++edge) {
    text += edge > 0 ? " " : "";
    append(text, column(assembly.cell, edge));
  }
  text += "\" pbc=\"";
  for (std::size_t k = 0; k < 3; ++k)
    text += std::string(k > 0 ? " " : "") + (periodic[k] ? "T" : "F");
  text += "\" Properties=id:I:1:pos:R:3";
  for (const GrainField& field : fields)
    text += ":" + field.name + (field.whole ? ":I:" : ":R:") + std::to_string(field.components);
  if (time) {
    text += " Time=";
    append(text, *time);
  }
  for (std::size_t g = 0; g < assembly.grain_count(); ++g) {
    text += '\n';
    append(text, id_of(id, g));
    text += ' ';
    append(text, assembly.position[g]);
    for (const GrainField& field : fields)
      for (std::size_t k = field.components * g; k < field.components * (g + 1); ++k) {
        text += ' ';
        append(text, field.values[k]);
      }
  }
  return text + '\n';
}

} // namespace granum::io
