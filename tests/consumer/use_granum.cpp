// SPDX-License-Identifier: GPL-3.0-or-later
// Needs every library: one call into each of theory, fit, dem, io and granum.
#include <cstdio>
#include <string>

#include <granum/contact/power_law.hpp>
#include <granum/core/error.hpp>
#include <granum/core/version.hpp>
#include <granum/hardin/equation.hpp>
#include <granum/io/output_file.hpp>
#include <granum/packing/assembly.hpp>

int main() {
  const std::string version(granum::version());
  std::printf(
      "granum %s, k_t/k_n = %g, f(0.56) = %g\n", version.c_str(),
      granum::contact::mindlin_stiffness_ratio(0.15),
      granum::hardin::void_ratio_value(granum::hardin::VoidRatioFunction::hardin_richart_round, 0.56));
  granum::packing::require_valid(
      {.cell = granum::Mat3::identity(), .position = {{0, 0, 0}}, .radius = {0.5}, .contacts = {}});
  try {
    granum::io::write_file("no such folder/file.txt", "text", granum::io::Existing::replace);
    return 1;
  } catch (const granum::FileError&) {
  }
  return version == GRANUM_EXPECTED_VERSION ? 0 : 1;
}
