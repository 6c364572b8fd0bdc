// SPDX-License-Identifier: GPL-3.0-or-later
#include "size_options.hpp"

#include <algorithm>

#include <fmt/core.h>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/csv/sieve.hpp>
#include <granum/sizes/distribution_text.hpp>

#include "cli/frame/contradictions.hpp"

namespace granum::cli {

namespace {

void set_sizes(PackingOptions& o, sizes::Distribution distribution) {
  if (o.sizes)
    throw InvalidArgument(given_twice::sizes);
  o.sizes = std::move(distribution);
}

} // namespace

void add_size_options(Command& command, PackingOptions& o) {
  const Exclusion once{"--sizes --sieve --uniformity", given_twice::sizes};
  command.add(
      sizes_group,
      {{.name = "--sizes",
        .value = read_by([&o](const std::string& text) { set_sizes(o, sizes::parse_distribution(text)); },
                         "DISTRIBUTION"),
        .meaning = "Grain-size distribution: " + sizes::distribution_forms() +
                   ". Sizes are radii by number: RATIO, large over small; SHARE, of large grains (0.5 if "
                   "left out); SIGMA, standard deviation of ln radius; EXPONENT, of a density "
                   "radius^-EXPONENT; SIZE_RATIO, largest over smallest, where the distribution is cut. By "
                   "mass: C_U, d60/d10 of a lognormal distribution; PASSING, share finer than the diameter D",
        .excludes = {once},
        .synonyms = {{"psd gsd sievecurve sizedistribution"}}},
       {.name = "--sieve",
        .value = read_by(
            [&o](const std::string& path) {
              set_sizes(o, sizes::Distribution::sieve(io::read_sieve_curve(path)));
              o.graded = true;
            },
            "FILE"),
        .meaning = "Sieve curve of the grains, a CSV file with columns d_mm and passing_%; sets --radius "
                   "as well",
        .excludes = {once},
        .synonyms = {{"psd gsd sievecurve sizedistribution"}}},
       {.name = "--uniformity",
        .value = read_by(
            [&o](const std::string& text) {
              o.uniformity = parse_quantity("--uniformity", text, Dimension::dimensionless);
              set_sizes(o, sizes::Distribution::uniformity(*o.uniformity));
              o.graded = true;
            },
            "NUMBER"),
        .meaning = "Uniformity coefficient C_u = d60/d10 of grains that are lognormal by mass",
        .excludes = {once},
        .synonyms = {{"cu uniformitycoefficient gradation"}}}});
}

double resolve_radius(const PackingOptions& o) {
  if (o.radius.given() && o.d50.given())
    throw InvalidArgument(estimate::with_options(estimate::conflict::size));
  const std::optional<double> of_sieve = o.sizes ? o.sizes->mean_radius() : std::nullopt;
  if (of_sieve && (o.radius.given() || o.d50.given()))
    throw InvalidArgument(fmt::format("the sieve curve gives the size of the grains: leave out {}",
                                      (o.radius.given() ? o.radius : o.d50).name));
  if (of_sieve)
    return *of_sieve;
  const Number& size = o.d50.given() ? o.d50 : o.radius;
  require_within(size);
  if (!o.d50.given())
    return size.value;
  return o.sizes ? sizes::mean_radius_of(*o.sizes, o.d50.value) : o.d50.value / 2;
}

sizes::ContactMeans resolve_contact_means(const PackingOptions& o) {
  if (!o.sizes)
    return {};
  double rattlers = 0;
  if (o.rattler_fraction.given())
    rattlers = o.rattler_fraction.value;
  else if (o.coordination_number.given() && o.mechanical_coordination_number.given() &&
           o.mechanical_coordination_number.value > 0)
    rattlers = std::max(0.0, 1 - o.coordination_number.value / o.mechanical_coordination_number.value);
  return sizes::expected_contact_means(*o.sizes, rattlers);
}

nlohmann::ordered_json sizes_json(const PackingOptions& o, const sizes::ContactMeans& contacts) {
  if (!o.sizes)
    return nlohmann::ordered_json::object();
  return {{"sizes", o.sizes->text()},
          {"gradation", json_of(sizes::gradation(*o.sizes, resolve_radius(o)))},
          {"contact_means", json_of(contacts)}};
}

nlohmann::ordered_json json_of(const sizes::Gradation& g) {
  return {{"d10", g.d10}, {"d50", g.d50}, {"d60", g.d60}, {"uniformity", g.uniformity()}};
}

nlohmann::ordered_json json_of(const sizes::ContactMeans& c) {
  return {{"branch", c.branch},
          {"branch_square", c.branch_square},
          {"pair_radius", c.pair_radius},
          {"grain_volume", c.grain_volume}};
}

std::string means_text(const sizes::ContactMeans& c) {
  return fmt::format("branch <l> = {:.4f} x 2R, <l^2> = {:.4f} x (2R)^2, pair radius 2R* = {:.4f} x R, "
                     "grain volume <V> = {:.4f} x 4/3 pi R^3",
                     c.branch, c.branch_square, c.pair_radius, c.grain_volume);
}

std::string gradation_text(const sizes::Gradation& g) {
  return fmt::format("d10 {}, d50 {}, d60 {}", pretty(g.d10, Dimension::length),
                     pretty(g.d50, Dimension::length), pretty(g.d60, Dimension::length));
}

} // namespace granum::cli
