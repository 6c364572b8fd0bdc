// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/report/compression.hpp"
#include <nlohmann/json.hpp>

namespace granum::cli {

/// The first specimen of each contact and density in a manifest of verify, with s over all seeds.
/// \throws   nlohmann::json::exception if it is not such a manifest
[[nodiscard]] std::vector<studies::Compression> compressions_of(const studies::Scene& scene,
                                                                const nlohmann::ordered_json& manifest);

/// The report as a page.
struct StudyPage {
  std::string html;
  std::vector<studies::Panel> panels; ///< its pictures
};

/// The report of a run, from its scene and its manifest only.
/// \throws   nlohmann::json::exception if that is not a manifest of verify
[[nodiscard]] StudyPage study_page(const studies::Scene& scene, const nlohmann::ordered_json& manifest);

} // namespace granum::cli
