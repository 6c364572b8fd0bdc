// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/sizes/contact_means.hpp>
#include <granum/sizes/distribution.hpp>
#include <nlohmann/json.hpp>

#include "packing_options.hpp"

/// The options for the size of the grains.
namespace granum::cli {

/// --sizes, --sieve and --uniformity.
void add_size_options(Command& command, PackingOptions& options);

/// The mean radius of the grains by number [m]: that of the sieve curve, or by --d50, or --radius.
/// \throws   InvalidArgument if the size is given twice
[[nodiscard]] double resolve_radius(const PackingOptions& options);

/// Means over the contacts of unequal grains, from their distribution and the share of rattlers according to
/// --rattler-fraction or C_n and z*; R is the mean radius by number. Without sizes, those of equal grains.
/// \throws   InvalidArgument for a share out of range
[[nodiscard]] sizes::ContactMeans resolve_contact_means(const PackingOptions& options);

/// Additional description of a packing of unequal grains: their distribution, its gradation and its contact
/// means; an empty object for equal grains.
[[nodiscard]] nlohmann::ordered_json sizes_json(const PackingOptions& options,
                                                const sizes::ContactMeans& contacts);

[[nodiscard]] nlohmann::ordered_json json_of(const sizes::Gradation& gradation);
[[nodiscard]] nlohmann::ordered_json json_of(const sizes::ContactMeans& means);
/// "<l> = 1.0432 2R, ...": for the screen.
[[nodiscard]] std::string means_text(const sizes::ContactMeans& means);
/// "d10 0.3 mm, d50 0.5 mm, d60 0.6 mm".
[[nodiscard]] std::string gradation_text(const sizes::Gradation& gradation);

} // namespace granum::cli
