// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// Symbols that head the columns of measured quantities, the same for every command that reads a table;
/// separated by blanks. Those of inputs are in their rows (granum/estimate/inputs.hpp).
/// is_column_of reads primes and the Greek letter sigma in them too.
namespace granum::cli::column_names {

inline constexpr std::string_view shear_modulus = "G G_max Gmax G_0 G0 G_hv G_vh Ghv Gvh";
inline constexpr std::string_view shear_modulus_hh = "G_hh Ghh";
inline constexpr std::string_view bulk_modulus = "K";
inline constexpr std::string_view shear_wave_speed = "V_s Vs v_s vs";
inline constexpr std::string_view shear_wave_speed_hh = "V_s_hh Vs_hh";
inline constexpr std::string_view compression_wave_speed = "V_p Vp v_p vp";
inline constexpr std::string_view compression_wave_speed_h = "V_p_h Vp_h";

} // namespace granum::cli::column_names
