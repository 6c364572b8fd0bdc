// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/bytes.hpp>
#include <granum/dem/specimen.hpp>

namespace granum::dem {

/// Writes a specimen to the bit; load_specimen reads an equal one.
/// Checked by tests/dem/test_engine_bytes.cpp
void save_specimen(ByteWriter& to, const Specimen& state);
/// \throws   FileError if the bytes end early, or describe an invalid specimen: indices of missing grains,
///           cells without volume, NaN
[[nodiscard]] Specimen load_specimen(ByteReader& from);

} // namespace granum::dem
