// SPDX-License-Identifier: GPL-3.0-or-later
// Largest error of each function over its domain:  accuracy [--samples n] [--out table.csv]
// Exit code 1 if a function falls short of what it promises.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <sstream>

#include <granum/core/text.hpp>
#include <granum/io/output_file.hpp>

#include "../claims.hpp"
#include "harness.hpp"

namespace accuracy {

namespace {

double error_in_ulps(double value, const Real& reference, const Real& scale) {
  if (!std::isfinite(value) || (scale == 0 && value != 0))
    return std::numeric_limits<double>::infinity();
  // Spacing of doubles at that scale, that of the smallest normal number below it.
  const double nearest = std::max(std::abs(static_cast<double>(scale)), std::numeric_limits<double>::min());
  return static_cast<double>(
      Real(abs(Real(value) - reference) / Real(std::ldexp(1.0, std::ilogb(nearest) - 52))));
}

} // namespace

void Table::take(const std::string& function, const std::string& domain, Reach reach, double value,
                 const Real& reference, const Real& scale, const std::string& where) {
  auto row =
      std::ranges::find_if(rows_, [&](const Row& r) { return r.function == function && r.domain == domain; });
  if (row == rows_.end())
    row = rows_.insert(row, {.function = function, .domain = domain, .reach = reach.ulp});
  const double error = error_in_ulps(value, reference, scale);
  ++row->samples;
  if (error > row->worst || row->where.empty()) {
    row->worst = std::max(row->worst, error);
    row->where = where;
  }
}

std::string said(const std::string& names, std::initializer_list<double> values) {
  std::istringstream words(names);
  std::string text, name;
  for (const double value : values)
    if (words >> name)
      text += (text.empty() ? "" : " ") + name + "=" + granum::short_text(value, 6);
  return text;
}

namespace {

std::string csv(const Table& table) {
  std::string text = "function,domain,samples,largest_error_ulp,promised_ulp,at\n";
  for (const auto& row : table.rows())
    text += '"' + row.function + "\",\"" + row.domain + "\"," + std::to_string(row.samples) + ',' +
            granum::short_text(row.worst, 3) + ',' + granum::short_text(row.reach, 3) + ",\"" + row.where +
            "\"\n";
  return text;
}

bool print(const Table& table) {
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

bool run(const Arguments& arguments) {
  std::size_t samples = 20000;
  std::string out;
  for (std::size_t k = 0; k + 1 < arguments.size(); k += 2)
    if (arguments[k] == "--samples")
      samples = std::stoul(arguments[k + 1]);
    else if (arguments[k] == "--out")
      out = arguments[k + 1];
  const struct {
    void (*check)(Table&, Draw&, std::size_t);
    std::uint64_t seed;
    std::size_t share; ///< of the samples, for what takes long
  } groups[] = {{check_fabric, 2, 1},         {check_elastic, 3, 1},        {check_uniform_field, 4, 1},
                {check_directional, 5, 200},  {check_sphere_packs, 6, 1},   {check_sphere_models, 11, 1},
                {check_static_field, 7, 400}, {check_derivatives, 8, 2000}, {check_kinematic, 9, 400},
                {check_relaxation, 10, 1},    {check_waves, 12, 5},         {check_tensors, 13, 20},
                {check_distribution, 14, 1}};
  Table table;
  Draw of_contacts(1);
  check_contact(table, of_contacts, samples);
  for (const auto& [check, seed, share] : groups) {
    Draw draw(seed);
    for (std::size_t k = 0; k < samples / share; ++k)
      check(table, draw, k);
  }
  const bool all = print(table);
  if (!out.empty())
    granum::io::write_file(out, csv(table), granum::io::Existing::replace);
  return all;
}

} // namespace

} // namespace accuracy

int main(int argc, char** argv) {
  return program(argc, argv, {{"", "[--samples] [n] [--out] [table.csv]", accuracy::run}});
}
