// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/mistakes.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

#include "studies/analyse/overlaps.hpp"

namespace granum::studies {

namespace {

using io::Finding;
using packing::Contact;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median over the contacts of the distance of the centres over the sum of the radii; 1 without contacts.
double median_distance(const packing::Assembly& assembly) {
  std::vector<double> distances;
  for (const Contact& c : assembly.contacts)
    distances.push_back(norm(c.branch) / (assembly.radius[c.i] + assembly.radius[c.j]));
  return distances.empty() ? 1 : median(std::move(distances));
}

/// The void ratio with all radii times a factor.
double rescaled(double void_ratio, double factor) {
  return (1 + void_ratio) / (factor * factor * factor) - 1;
}

constexpr double least_void_ratio = 0.2;

void judge_void_ratio(const packing::Assembly& assembly, double e, std::vector<std::string>& out) {
  if (e < least_void_ratio && !assembly.body.empty())
    return; // overlaps of grains of one body are counted twice
  constexpr double most = 3, half_way = 0.75;
  const double distance = median_distance(assembly);
  const std::string start = "the void ratio is " + short_text(e, 3) + ": ";
  if (e < least_void_ratio && distance < half_way)
    out.push_back(start + "the centres of grains in contact are " + percent(distance) +
                  " of the sum of their radii apart: does the column of radii contain diameters? Halved, "
                  "they give e = " +
                  short_text(rescaled(e, 0.5), 3));
  else if (e < least_void_ratio)
    out.push_back(
        start +
        "no packing of grains is so dense: do radii and box have the same unit, and is the box complete?");
  else if (e > most)
    out.push_back(start + "most of the box is empty: does it reach beyond the grains (a free surface, "
                          "walls: give --window), or do radii and box have different units?");
}

void judge_open_contacts(const packing::Assembly& assembly, std::vector<std::string>& out) {
  const auto open = [](const Contact& c) { return !(c.overlap > 0); };
  if (assembly.contacts.empty() || !std::all_of(assembly.contacts.begin(), assembly.contacts.end(), open))
    return;
  constexpr double twice = 1.9;
  const double distance = median_distance(assembly);
  std::string cause =
      "are positions and contacts of the same state, and the positions written with enough digits?";
  if (distance > twice)
    cause = "are the radii half of what they should be?";
  if (distance < 1)
    cause = "are the overlaps of the contacts those of these positions?";
  out.push_back(std::string(distance < 1 ? "no contact has an overlap, but" : "every contact is open:") +
                " the centres are " + short_text(distance, 6) +
                " times the sum of the radii apart (median); " + cause);
}

/// Pairs without a row that overlap by more than a tenth of the usual overlap.
void judge_missing_contacts(const io::ImportedPacking& packing, const MeasuredFrame& frame,
                            std::vector<std::string>& out) {
  constexpr double clear = 0.1, share = 0.05;
  const packing::Assembly& assembly = packing.assembly;
  if (assembly.contacts.empty() || packing.has(Finding::contacts_from_overlaps) ||
      packing.has(Finding::cell_unknown))
    return;
  std::vector<double> overlaps;
  for (const Contact& c : assembly.contacts)
    overlaps.push_back(c.overlap);
  const double deep = clear * median(std::move(overlaps));
  if (!(deep > 2 * packing.rounding.length)) // too few digits of the positions
    return;
  const std::vector<Contact> found = overlapping_pairs(assembly, packing.periodic);
  const auto listed = [&](const Contact& pair) {
    return std::binary_search(
        assembly.contacts.begin(), assembly.contacts.end(), pair,
        [](const Contact& a, const Contact& b) { return std::tie(a.i, a.j) < std::tie(b.i, b.j); });
  };
  std::size_t there = 0, missing = 0;
  const auto of_one_body = [&](const Contact& pair) {
    return !assembly.body.empty() && assembly.body[pair.i] == assembly.body[pair.j];
  };
  for (const Contact& pair : found)
    if (pair.overlap > deep && !of_one_body(pair))
      ++(listed(pair) ? there : missing);
  if (static_cast<double>(missing) <= share * static_cast<double>(there + missing))
    return;
  constexpr double large = 0.05;
  const auto& forces = frame.packing.forces;
  const bool unbalanced =
      forces && forces->unbalance && !forces->weight && forces->unbalance->force_ratio > large;
  out.push_back(
      std::to_string(missing) + " of " + std::to_string(there + missing) +
      " pairs of overlapping spheres are in no row of the contacts" +
      (unbalanced ? ", and forces of " + percent(forces->unbalance->force_ratio) +
                        " of the mean contact force are left on the grains"
                  : "") +
      ": is the file of contacts complete (all processors, all types), or are they spheres of one clump?");
}

/// Grains at the very place of another: no line joins their centres, so that no contact does.
void judge_places(const io::ImportedPacking& packing, std::vector<std::string>& out) {
  const std::vector<Vec3>& place = packing.assembly.position;
  std::vector<std::uint32_t> order(place.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t g) { return std::tie(place[g].x, place[g].y, place[g].z); };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::size_t twice = 0;
  std::string first;
  for (std::size_t k = 1; k < order.size(); ++k)
    if (place[order[k]] == place[order[k - 1]] && ++twice == 1)
      first = std::to_string(packing.id[order[k - 1]]) + " and " + std::to_string(packing.id[order[k]]);
  if (twice > 0)
    out.push_back(std::to_string(twice) + " grains are at the position of another (" + first +
                  "): they count in e and C_n, but no contact joins them; was a file read twice?");
}

/// Moduli of grains, by material.
void judge_modulus(const MeasuredFrame& frame, std::vector<std::string>& out) {
  constexpr double softest = 1e6, hardest = 1e12;
  constexpr double millimetres = 1e6; // G as lengths in mm show it, times this, is G
  if (!frame.packing.grain)
    return;
  const double G = frame.packing.grain->shear_modulus;
  if (G >= softest && G <= hardest)
    return;
  const bool in_mm = G * millimetres > 1e8 && G * millimetres < hardest;
  out.push_back("G_g of the grains is " + pretty(G, Dimension::pressure) +
                (G > hardest ? ", more than diamond has" : ", softer than rubber") + ": is its unit right" +
                (in_mm && frame.packing.law_check
                     ? ", or are lengths in mm taken for m? Then " +
                           pretty(G * millimetres, Dimension::pressure) + " is shown as " +
                           pretty(G, Dimension::pressure) + ". "
                     : "? ") +
                "Quartz has 30 to 45 GPa");
}

void judge_lengths(const io::ImportedPacking& packing, const MeasuredFrame& frame,
                   std::vector<std::string>& out) {
  constexpr double boulder = 0.05; // [m]
  const double radius = frame.packing.sizes.equivalent;
  if (packing.has(Finding::units_unknown) && radius > boulder && !frame.packing.grain)
    out.push_back("the grains have radii of " + pretty(radius, Dimension::length) +
                  ": are the lengths in mm? The files state no units, and metres were assumed");
}

} // namespace

std::string percent(double share) { return short_text(100 * share, 3) + " %"; }

void judge_mistakes(const io::ImportedPacking& packing, const MeasuredFrame& frame,
                    std::vector<std::string>& out) {
  if (packing.assembly.grain_count() == 0)
    return;
  judge_void_ratio(packing.assembly, frame.packing.void_ratio, out);
  judge_open_contacts(packing.assembly, out);
  judge_places(packing, out);
  if (frame.packing.void_ratio >= least_void_ratio) // else grains overlap for another reason
    judge_missing_contacts(packing, frame, out);
  judge_modulus(frame, out);
  judge_lengths(packing, frame, out);
}

} // namespace granum::studies
