// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include <granum/contact/grains.hpp>
#include <granum/core/stop.hpp>
#include <granum/dem/neighbours.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/packing/one_layer.hpp>

namespace granum::studies {

namespace {

using packing::Assembly;
using packing::Contact;

/// The image of a grain that is the grain.
constexpr std::uint32_t itself = dem::image_count / 2;

/// Finds overlapping spheres of one assembly.
class OverlapSearch {
 public:
  OverlapSearch(const Assembly& assembly, const std::array<bool, 3>& periodic)
      : assembly_(assembly), place_(assembly.position), shifts_(dem::shift_vectors(assembly.cell)),
        open_(!periodic[0] && !periodic[1] && !periodic[2]),
        whole_(periodic[0] && periodic[1] && periodic[2]) {
    if (whole_)
      dem::wrap(assembly.cell, place_);
    else if (!open_)
      wrap_along(periodic);
    for (std::uint32_t image = 0; image < dem::image_count; ++image) {
      const auto number = static_cast<int>(image);
      const std::array<int, 3> steps{number / 9 - 1, number / 3 % 3 - 1, number % 3 - 1};
      bool allowed = true;
      for (std::size_t k = 0; k < 3; ++k)
        allowed = allowed && (periodic[k] || steps[k] == 0);
      allowed_[image] = allowed;
    }
  }

  [[nodiscard]] std::vector<Contact> run() && {
    if (place_.empty())
      return {};
    const double largest = *std::max_element(assembly_.radius.begin(), assembly_.radius.end());
    const Vec3 widths = packing::cell_widths(assembly_.cell);
    if (open_ || (whole_ && 4 * largest <= std::min({widths.x, widths.y, widths.z}))) {
      for (const dem::Pair& pair : neighbour_pairs(assembly_.cell, place_, assembly_.radius, 0,
                                                   open_ ? dem::Images::none : dem::Images::periodic))
        look_at(pair.i, pair.j, pair.image);
    } else {
      search_among_copies(largest);
    }
    return std::move(found_);
  }

 private:
  /// Along open axes grains may be outside of the box.
  void wrap_along(const std::array<bool, 3>& periodic) {
    const Mat3 to_parts = inverse_of(assembly_.cell);
    for (Vec3& x : place_) {
      const Vec3 part = to_parts * x;
      for (int k = 0; k < 3; ++k)
        if (const double turns = std::floor(part[k]); periodic[static_cast<std::size_t>(k)] && turns != 0)
          x -= turns * column(assembly_.cell, k);
    }
  }

  /// In a narrow cell a pair meets through several images: grains and those of their images that can reach
  /// any grain are searched like the grains of a box without faces.
  void search_among_copies(double largest) {
    const auto count = static_cast<std::uint32_t>(place_.size());
    Vec3 low = place_.front(), high = low;
    for (const Vec3& x : place_) {
      low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
      high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
    constexpr double enough = 1.01;
    const double margin = enough * 2 * largest;
    const Vec3 edge{margin, margin, margin}, size = high - low + 2 * edge;
    std::vector<Vec3> all(place_.size());
    std::transform(place_.begin(), place_.end(), all.begin(), [&](const Vec3& x) { return x - low + edge; });
    std::vector<double> radius = assembly_.radius;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> copies; // grain and image
    for (std::uint32_t image = 0; image < dem::image_count; ++image)
      for (std::uint32_t g = 0; allowed_[image] && image != itself && g < count; ++g) {
        const Vec3 x = all[g] + shifts_[image];
        const double beyond = margin - enough * (assembly_.radius[g] + largest); // out of any grain's reach
        if (x.x < beyond || x.y < beyond || x.z < beyond || x.x >= size.x - beyond ||
            x.y >= size.y - beyond || x.z >= size.z - beyond)
          continue;
        all.push_back(x);
        radius.push_back(assembly_.radius[g]);
        copies.emplace_back(g, image);
      }
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> met; // i, j and image
    for (const dem::Pair& pair :
         neighbour_pairs(Mat3::diagonal(size.x, size.y, size.z), all, radius, 0, dem::Images::none)) {
      if (pair.i >= count)
        continue;
      const auto [j, image] = pair.j < count ? std::pair{pair.j, itself} : copies[pair.j - count];
      if (pair.i < j) // each pair of images is met from both of its grains
        met.emplace_back(pair.i, j, image);
    }
    std::sort(met.begin(), met.end());
    for (const auto& [i, j, image] : met)
      look_at(i, j, image);
  }

  void look_at(std::uint32_t i, std::uint32_t j, std::uint32_t image) {
    if (!allowed_[image])
      return;
    const Vec3 branch = place_[j] + shifts_[image] - place_[i];
    const double overlap = assembly_.radius[i] + assembly_.radius[j] - norm(branch);
    if (overlap > 0 && norm(branch) > 0)
      found_.push_back({.i = i, .j = j, .branch = branch, .overlap = overlap});
  }

  const Assembly& assembly_;
  std::vector<Vec3> place_;
  std::array<Vec3, dem::image_count> shifts_;
  std::array<bool, dem::image_count> allowed_{};
  bool open_, whole_; ///< along no axis, along all
  std::vector<Contact> found_;
};

/// Normal forces by the law for equal grains of the pair's 2 R_i R_j/(R_i + R_j).
void set_forces(Assembly& assembly, const analysis::Given& given) {
  for (Contact& c : assembly.contacts) {
    stop_point(static_cast<std::size_t>(&c - assembly.contacts.data()));
    const contact::GrainMaterial grain =
        given.materials.empty()
            ? contact::GrainMaterial{given.grain_shear_modulus.value(), given.grain_poisson_ratio}
            : contact::pair_material(given.materials[c.i], given.materials[c.j]);
    const double radius = contact::pair_radius(assembly.radius[c.i], assembly.radius[c.j]);
    c.normal_force = given.adhesion
                         ? adhesive_contact_at_overlap(*given.adhesion, grain, radius, c.overlap).force
                         : given.law_family(grain, radius).force(c.overlap);
  }
}

} // namespace

std::vector<Contact> overlapping_pairs(const Assembly& assembly, const std::array<bool, 3>& periodic) {
  require_valid(assembly);
  return OverlapSearch(assembly, periodic).run();
}

io::ImportedPacking with_overlap_contacts(io::ImportedPacking packing, const analysis::Given& given) {
  using io::Finding;
  if (!packing.has(Finding::contacts_unknown))
    return packing;
  packing::require_space(packing.assembly);
  packing = io::without_own_images(std::move(packing));
  auto found = overlapping_pairs(packing.assembly, packing.periodic);
  if (found.empty())
    return packing;
  packing.assembly.contacts = std::move(found);
  packing.notes.push_back({Finding::contacts_from_overlaps,
                           std::to_string(packing.assembly.contacts.size()) +
                               " pairs of spheres overlap: they are used as contacts" +
                               (given.adhesion ? "; necks across gaps are not among them" : "")});
  if (given.grain_shear_modulus || !given.materials.empty()) {
    set_forces(packing.assembly, given);
    packing.notes.push_back({Finding::tangential_unknown,
                             "no tangential forces: normal ones are those of the given "
                             "material at the overlaps"});
  } else {
    packing.notes.push_back({Finding::forces_unknown, "no forces; with --grain-shear-modulus the normal ones "
                                                      "follow from the overlaps"});
  }
  return packing;
}

} // namespace granum::studies
