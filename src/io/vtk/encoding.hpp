// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// How the arrays of VTK's XML files are packed when they are not text.
namespace granum::io {

/// Encoding of all packed arrays of a file, from its first element.
struct VtkEncoding {
  bool big_endian = false;
  std::size_t header_size = 4; ///< bytes of a number in front of the data: 4 or 8
  std::string compressor;      ///< empty for none
};

/// The bytes of one array.
/// \param    packed   begins where the array begins, and may go on behind it
/// \param    base64   whether `packed` is base64 text, not the bytes themselves
/// \throws   InvalidArgument for data in another encoding, with the reason
/// Checked by tests/io/vtk/test_xml.cpp
[[nodiscard]] std::string unpacked(std::string_view packed, bool base64, const VtkEncoding& encoding);

} // namespace granum::io
