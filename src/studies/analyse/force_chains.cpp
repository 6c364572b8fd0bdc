// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/force_chains.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <granum/core/text.hpp>
#include <granum/plot/svg_text.hpp>

namespace granum::studies {

namespace {

constexpr double longer_side = 420; // of the longer side
constexpr double edge_width = 12;   // around the drawing
constexpr double slice_radii = 4;   // thickness in mean radii
constexpr double mean_width = 2.2;  // of the line of a mean force
constexpr double most_width = 9;
constexpr std::size_t most_contacts = 10'000; // of a slice that is drawn whole, and not its chains alone

double average(const std::vector<double>& values) {
  return values.empty()
             ? 0
             : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// View of a packing: along y, x to the right and z up.
class Slice {
 public:
  explicit Slice(const packing::Assembly& packing) : packing_(packing) {
    const double thickness = slice_radii * average(packing.radius);
    double low = packing.position.front().y, high = low;
    for (const Vec3& p : packing.position) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
    const double middle = (low + high) / 2;
    const auto within = [&](double y) { return std::abs(y - middle) <= thickness / 2; };
    for (std::size_t k = 0; k < packing.position.size(); ++k)
      if (within(packing.position[k].y))
        grains_.push_back(k);
    for (const packing::Contact& contact : packing.contacts)
      if (contact.normal_force > 0 && within(packing.position[contact.i].y + contact.branch.y / 2))
        contacts_.push_back(&contact);
    left_ = right_ = packing.position.front().x;
    foot_ = top_ = packing.position.front().z;
    for (std::size_t k = 0; k < packing.position.size(); ++k) {
      left_ = std::min(left_, packing.position[k].x - packing.radius[k]);
      right_ = std::max(right_, packing.position[k].x + packing.radius[k]);
      foot_ = std::min(foot_, packing.position[k].z - packing.radius[k]);
      top_ = std::max(top_, packing.position[k].z + packing.radius[k]);
    }
    scale_ = longer_side / std::max(right_ - left_, top_ - foot_);
  }

  [[nodiscard]] const std::vector<const packing::Contact*>& contacts() const { return contacts_; }
  [[nodiscard]] double width() const { return 2 * edge_width + scale_ * (right_ - left_); }
  [[nodiscard]] double height() const { return 2 * edge_width + scale_ * (top_ - foot_); }

  [[nodiscard]] std::string grains() const {
    std::string circles;
    if (contacts_.size() > most_contacts)
      return circles;
    for (const std::size_t k : grains_)
      circles += plot::svg_element("circle", {{"cx", x(packing_.position[k])},
                                              {"cy", y(packing_.position[k])},
                                              {"r", plot::svg_number(scale_ * packing_.radius[k])}});
    return plot::svg_group(
        {{"fill", "none"}, {"stroke", "currentColor"}, {"stroke-width", "0.6"}, {"opacity", "0.3"}}, circles);
  }

  /// Lines of the contacts whose force is above the mean, or of the others.
  [[nodiscard]] std::string chains(double mean_force, bool strong) const {
    std::string lines;
    if (!strong && contacts_.size() > most_contacts)
      return lines;
    for (const packing::Contact* contact : contacts_) {
      const double share = contact->normal_force / mean_force;
      if ((share > 1) != strong)
        continue;
      const Vec3 from = packing_.position[contact->i], to = from + contact->branch;
      lines += plot::svg_element(
          "line", {{"x1", x(from)},
                   {"y1", y(from)},
                   {"x2", x(to)},
                   {"y2", y(to)},
                   {"stroke-width", plot::svg_number(std::min(most_width, mean_width * share))},
                   {"data-f", short_text(share, 3)}});
    }
    plot::SvgAttributes group{{"stroke", "currentColor"},
                              {"stroke-linecap", "round"},
                              {"data-mean", short_text(mean_force, 4)}}; // [N], for the page's script
    if (strong)
      for (auto& attribute : plot::svg_colour(plot::Colour::force))
        group.push_back(std::move(attribute));
    else
      group.emplace_back("opacity", "0.5");
    return plot::svg_group(group, lines);
  }

 private:
  [[nodiscard]] std::string x(const Vec3& p) const {
    return plot::svg_number(edge_width + scale_ * (p.x - left_));
  }
  [[nodiscard]] std::string y(const Vec3& p) const {
    return plot::svg_number(edge_width + scale_ * (top_ - p.z));
  }

  const packing::Assembly& packing_;
  std::vector<std::size_t> grains_;
  std::vector<const packing::Contact*> contacts_;
  double left_ = 0, right_ = 0, foot_ = 0, top_ = 0;
  double scale_ = 1;
};

} // namespace

std::optional<ForceChains> force_chains(const packing::Assembly& packing) {
  if (packing.position.empty())
    return std::nullopt;
  const Slice slice(packing);
  if (slice.contacts().empty())
    return std::nullopt;
  std::vector<double> forces;
  for (const packing::Contact* contact : slice.contacts())
    forces.push_back(contact->normal_force);
  const double mean_force = average(forces);
  double above = 0;
  std::size_t count = 0;
  for (const double force : forces)
    if (force > mean_force) {
      above += force;
      ++count;
    }
  const std::string finding =
      "Force chains in a slice of " + std::to_string(forces.size()) + " contacts: " + std::to_string(count) +
      " of them are above the mean force and carry " +
      short_text(100 * above / (mean_force * static_cast<double>(forces.size())), 2) + " % of all force.";
  const plot::SvgPicture picture{.width = slice.width(),
                                 .height = slice.height(),
                                 .finding = finding,
                                 .content = slice.grains() + slice.chains(mean_force, false) +
                                            slice.chains(mean_force, true)};
  return ForceChains{.svg = plot::svg(picture), .in_page = plot::svg_in_page(picture), .finding = finding};
}

} // namespace granum::studies
