// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/bytes.hpp>
#include <granum/dem/specimen.hpp>

namespace granum::dem {

/// A specimen to the bit: what load_specimen reads is equal to it.
/// Checked by tests/dem/test_engine_bytes.cpp
void save_specimen(ByteWriter& to, const Specimen& state);
/// \throws   FileError if the bytes end early, or are of a specimen that no loop could go through safely:
///           grains that it does not have, cells without volume, numbers that are none
[[nodiscard]] Specimen load_specimen(ByteReader& from);

} // namespace granum::dem
