// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/report/compression.hpp"
#include <nlohmann/json.hpp>

namespace granum::cli {

/// The first specimen of each contact and density in a manifest of verify, with s over all seeds.
/// \throws   nlohmann::json::exception if it is no such manifest
[[nodiscard]] std::vector<studies::Compression> compressions_of(const studies::Scene& scene,
                                                                const nlohmann::ordered_json& manifest);

/// A report for people.
struct StudyPage {
  std::string html;
  std::vector<studies::Panel> panels; ///< of its pictures
};

/// The report of a run, made of its scene and its manifest alone.
/// \throws   nlohmann::json::exception if that is no manifest of verify
[[nodiscard]] StudyPage study_page(const studies::Scene& scene, const nlohmann::ordered_json& manifest);

} // namespace granum::cli
