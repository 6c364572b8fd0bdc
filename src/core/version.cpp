// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/version.hpp>

namespace granum {

std::string_view version() { return GRANUM_VERSION; }

std::string_view compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

} // namespace granum
