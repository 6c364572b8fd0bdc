// SPDX-License-Identifier: GPL-3.0-or-later
// Largest error of each function over its domain:  accuracy [--samples n] [--out table.csv]
// Exit code 1 if a function falls short of what it promises.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include <granum/core/text.hpp>
#include <granum/io/output_file.hpp>

#include "harness.hpp"

namespace {

std::string csv(const accuracy::Table& table) {
  std::string text = "function,domain,samples,largest_error_ulp,promised_ulp,at\n";
  for (const auto& row : table.rows())
    text += '"' + row.function + "\",\"" + row.domain + "\"," + std::to_string(row.samples) + ',' +
            granum::short_text(row.worst, 3) + ',' + granum::short_text(row.reach, 3) + ",\"" + row.where +
            "\"\n";
  return text;
}

bool print(const accuracy::Table& table) {
  bool all = true;
  std::printf("%-44s %-34s %8s %10s %10s\n", "function", "domain", "samples", "ulp", "promised");
  for (const auto& row : table.rows()) {
    const bool kept = row.worst <= row.reach;
    all = all && kept;
    std::printf("%-44s %-34s %8zu %10.3g %10.3g%s\n", row.function.c_str(), row.domain.c_str(), row.samples,
                row.worst, row.reach, kept ? "" : "  falls short");
    if (!kept)
      std::printf("    at %s\n", row.where.c_str());
  }
  return all;
}

} // namespace

int main(int count, char** arguments) {
  std::size_t samples = 20000;
  const char* out = nullptr;
  for (int k = 1; k + 1 < count; k += 2) {
    const std::string_view key = arguments[k];
    if (key == "--samples")
      samples = std::strtoul(arguments[k + 1], nullptr, 10);
    else if (key == "--out")
      out = arguments[k + 1];
  }
  accuracy::Table table;
  accuracy::check_contact(table, samples);
  accuracy::check_fabric(table, samples);
  accuracy::check_elastic(table, samples);
  accuracy::check_uniform_field(table, samples);
  accuracy::check_directional(table, samples / 200);
  accuracy::check_sphere_packs(table, samples);
  accuracy::check_sphere_models(table, samples);
  accuracy::check_static_field(table, samples / 400);
  accuracy::check_derivatives(table, samples / 2000);
  accuracy::check_kinematic(table, samples / 400);
  accuracy::check_relaxation(table, samples);
  accuracy::check_waves(table, samples / 5);
  accuracy::check_tensors(table, samples / 20);
  accuracy::check_distribution(table, samples);
  const bool all = print(table);
  if (out)
    granum::io::write_file(out, csv(table), granum::io::Existing::replace);
  return all ? 0 : 1;
}
