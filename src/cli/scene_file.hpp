// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/verify/scene.hpp>
#include <nlohmann/json.hpp>

namespace granum::cli {

/// Sets one key of a scene from text, as --set and scene files do: "grain.radius", "0.5mm".
/// \throws   InvalidArgument for an unknown key (naming the known ones that are near) or a value it cannot
/// take
void set_key(verify::Scene& scene, const std::string& key, const std::string& value);

/// Applies a TOML scene to the defaults.
/// \throws   FileError with path and line for what cannot be read, an unknown key or a value it cannot take
[[nodiscard]] verify::Scene read_scene(const std::string& path);

/// "key=value" of --set.
/// \throws   InvalidArgument
void apply_setting(verify::Scene& scene, const std::string& setting);

/// A scene as TOML with every key: read_scene of it is the same scene, to the bit.
[[nodiscard]] std::string toml_of(const verify::Scene& scene);

/// The resolved scene in SI, for manifests; and its keys with what they mean, for help.
[[nodiscard]] nlohmann::ordered_json json_of(const verify::Scene& scene);
[[nodiscard]] std::string key_help();

} // namespace granum::cli
