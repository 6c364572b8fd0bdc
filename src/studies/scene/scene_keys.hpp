// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "studies/scene/scene.hpp"
#include <granum/core/units.hpp>

/// The keys of a scene: one table, from which scene files, --set, JSON, help, examples/scene.toml and
/// require_valid follow.
namespace granum::studies {

/// Commands that work on a scene.
enum class SceneCommand { verify, plan, trade, reproduce, export_lammps };

inline constexpr std::array all_scene_commands{SceneCommand::verify, SceneCommand::plan, SceneCommand::trade,
                                               SceneCommand::reproduce, SceneCommand::export_lammps};

/// "verify", ..., "export lammps".
[[nodiscard]] std::string_view name(SceneCommand command);

/// A value of a key: quantities in SI, choices by their names.
using KeyValue =
    std::variant<double, std::uint64_t, std::string, std::vector<double>, std::vector<std::string>>;

/// Allowed numbers of a key, with the reason.
struct KeyRange {
  double low = 0;
  double high = 0;
  bool low_open = false; ///< low itself is left out
  bool high_open = false;
  std::string_view reason;
};

/// "[1e-09, 1000]", in SI.
[[nodiscard]] std::string text(const KeyRange& range, Dimension dimension);

struct SceneKey {
  std::string name;    ///< "grain.radius"
  std::string meaning; ///< for help and for the comment in a scene file
  Dimension dimension = Dimension::dimensionless;
  std::string json_name; ///< within its section, with the unit: "radius_m"
  KeyRange range;        ///< of numbers, or of each number of a list; 0, 0 for names
  std::vector<SceneCommand> commands;
  /// If this key has no effect with the other keys of a scene, the condition that it needs: "a cone in
  /// study.contacts"; empty where it has an effect.
  std::function<std::string(const Scene&)> missing;
  /// Sets it from the text of --set.  \throws   InvalidArgument naming the key
  std::function<void(Scene&, const std::string& text)> set;
  /// Value as in scene files: "mindlin" for a tangential ratio that is not given.
  std::function<KeyValue(const Scene&)> get;
  /// Value used in calculations; differs from get() for the tangential ratio only.
  std::function<KeyValue(const Scene&)> resolved;

  [[nodiscard]] std::string section() const { return name.substr(0, name.find('.')); }
  [[nodiscard]] std::string name_in_section() const { return name.substr(name.find('.') + 1); }
  [[nodiscard]] bool taken_by(SceneCommand command) const;
  /// Meaning and range in one line: "of all grains; in [1e-09, 1000] m".
  [[nodiscard]] std::string description() const;
};

/// All keys by section, in the order of scene files.
[[nodiscard]] std::span<const SceneKey> scene_keys();
/// \throws   InvalidArgument for an unknown name, with the known ones
[[nodiscard]] const SceneKey& scene_key(const std::string& name);

/// Numbers of a key within its range.
/// \throws   InvalidArgument naming key, value, unit, range and its reason
void require_in_range(const SceneKey& key, const Scene& scene);

/// A value as in scene files: "0.5mm", 1000, ["cone", "sphere"]. Reading it gives the same bits.
/// \param    short_units   prefixes where they change no bit; else SI units
[[nodiscard]] std::string toml_text(const KeyValue& value, Dimension dimension, bool short_units = false);

/// A scene as TOML with every key, for programs: reading it gives the same scene, to the bit.
[[nodiscard]] std::string toml_of(const Scene& scene);
/// The default scene as TOML with the meaning of each key: examples/scene.toml.
[[nodiscard]] std::string commented_default_toml();

} // namespace granum::studies
