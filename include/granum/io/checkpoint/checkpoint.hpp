// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace granum::io {

/// Data to continue a run: its state as bytes (core/bytes.hpp), and its identification.
struct Checkpoint {
  std::string subject; ///< specimen and path of the state: text that no other file of the run has
  std::string scene;   ///< the scene that it came from: text
  std::string state;   ///< bytes

  bool operator==(const Checkpoint&) const = default;
};

/// Version of the file format and of the states that this library writes and reads.
inline constexpr std::uint32_t checkpoint_version = 6;

/// Writes a checkpoint, replacing an existing one: a reader finds the old one or the whole new
/// one, whenever the writer is stopped.
/// \throws   FileError if writing fails; the old checkpoint is then as it was
/// Checked by tests/io/checkpoint/test_checkpoint.cpp
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// \throws   FileError naming the path and what is wrong: no checkpoint, a newer version, another byte order,
///           of the wrong length, or damaged (the checksum covers subject, scene and state)
/// Checked by tests/io/checkpoint/test_checkpoint.cpp
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& path);

} // namespace granum::io
