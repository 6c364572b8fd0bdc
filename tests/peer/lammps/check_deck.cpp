// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads back what LAMMPS wrote from a deck and holds it against granum:
//   check_lammps_deck FOLDER
// Exit code 1 if a number is off, with all numbers on standard output.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <granum/assembly/coordination.hpp>
#include <granum/assembly/stress.hpp>
#include <granum/core/number.hpp>
#include <granum/io/lammps_dump.hpp>
#include <granum/io/stiffness.hpp>
#include <granum/network/linear_response.hpp>

using namespace granum;

namespace {

namespace fs = std::filesystem;
using Moduli = std::map<std::string, double>; // [Pa]
using Row = std::map<std::string, std::string>;

constexpr contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};

int failures = 0;

void expect(bool holds, const std::string& what, double value, double limit) {
  std::printf("%-6s %-58s %10.2e  (limit %.0e)\n", holds ? "ok" : "FAILED", what.c_str(), value, limit);
  failures += holds ? 0 : 1;
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields{""};
  for (const char c : line)
    if (c == ',')
      fields.emplace_back();
    else
      fields.back() += c;
  return fields;
}

std::vector<Row> rows_of(const fs::path& path) {
  io::TextSource source(path);
  std::vector<Row> rows;
  std::vector<std::string> heading;
  while (source.next()) {
    const std::vector<std::string> fields = fields_of(source.line());
    if (heading.empty()) {
      heading = fields;
      continue;
    }
    if (fields.size() != heading.size())
      source.fail("a row of another length than the heading");
    Row& row = rows.emplace_back();
    for (std::size_t k = 0; k < fields.size(); ++k)
      row[heading[k]] = fields[k];
  }
  return rows;
}

double number(const Row& row, const std::string& column) { return parse_number(row.at(column)).value(); }

Assembly packing_of(const fs::path& folder, const std::string& state) {
  io::LammpsDump dump(io::TextSource(folder / ("atoms." + state + ".dump")),
                      io::TextSource(folder / ("contacts." + state + ".dump")));
  Assembly packing = dump.next().value().assembly;
  io::assign_hertz_stiffness(packing, quartz, contact::mindlin_stiffness_ratio(quartz.poisson_ratio));
  return packing;
}

Moduli network_moduli(const Assembly& packing) {
  const auto& c = network::linear_response(packing).relaxed().matrix;
  return {{"G_vh", c(4, 4)}, {"G_hh", c(5, 5)}, {"K", c.topLeftCorner<3, 3>().sum() / 9}};
}

/// The stress by contacts against what LAMMPS says of itself, and the forces at rest.
void check_state(const fs::path& folder, const Row& row) {
  const Assembly packing = packing_of(folder, row.at("state"));
  const Mat3 stress = contact_stress(packing).symmetric;
  const double own[3][3] = {
      {number(row, "sigma_xx_Pa"), number(row, "sigma_xy_Pa"), number(row, "sigma_xz_Pa")},
      {number(row, "sigma_xy_Pa"), number(row, "sigma_yy_Pa"), number(row, "sigma_yz_Pa")},
      {number(row, "sigma_xz_Pa"), number(row, "sigma_yz_Pa"), number(row, "sigma_zz_Pa")}};
  double worst = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      worst = std::max(worst, std::abs(stress(i, j) - own[i][j]) / number(row, "pressure_Pa"));
  expect(worst < 1e-10, row.at("state") + ": stress by contacts and by LAMMPS", worst, 1e-10);
  const double target = std::abs(trace(stress) / 3 / number(row, "pressure_Pa") - 1);
  expect(target < 1e-3, row.at("state") + ": pressure and its target", target, 1e-3);
  const double unbalanced = unbalance(packing).force_ratio;
  expect(unbalanced < 1e-4, row.at("state") + ": unbalanced force ratio", unbalanced, 1e-4);
  std::printf("       C_n = %.4f\n", coordination_number(packing));
}

/// Probes against the network of the state they start from; the exponents of both between two pressures.
void check_probes(const fs::path& folder) {
  std::map<double, Moduli> probed, network; // by pressure
  for (const Row& row : rows_of(folder / "moduli.csv"))
    probed[number(row, "pressure_Pa")][row.at("modulus")] = number(row, "value_Pa");
  for (const auto& [pressure, moduli] : probed) {
    const std::string state = exact_text(pressure) + "Pa.frozen";
    network[pressure] = network_moduli(packing_of(folder, state));
    for (const auto& [name, value] : moduli) {
      const double off = value / network[pressure].at(name) - 1;
      expect(std::abs(off) < 0.02, state + ": " + name + " of the probe over network - 1", off, 0.02);
      std::printf("       %s = %.5g MPa\n", name.c_str(), value / 1e6);
    }
  }
  expect(probed.size() == 2, "pressures probed", static_cast<double>(probed.size()), 2);
  for (const std::string name : {"G_vh", "G_hh", "K"}) {
    const auto exponent = [&](const std::map<double, Moduli>& of) {
      return std::log(of.rbegin()->second.at(name) / of.begin()->second.at(name)) /
             std::log(of.rbegin()->first / of.begin()->first);
    };
    const double off = exponent(probed) - exponent(network);
    expect(std::abs(off) < 0.02, "s of " + name + ", probes minus network", off, 0.02);
    std::printf("       s = %.4f\n", exponent(probed));
  }
}

/// One state from a restart, written by another number of processors: the same positions, contacts in another
/// order. What is left is the solver's tolerance, of second order in C, and rounding of sums.
void check_again(const fs::path& folder) {
  const Moduli first = network_moduli(packing_of(folder, "30000Pa.frozen"));
  const Moduli again = network_moduli(packing_of(folder, "again"));
  for (const auto& [name, value] : first) {
    const double off = std::abs(again.at(name) / value - 1);
    expect(off < 1e-8, "on other ranks: network " + name, off, 1e-8);
  }
}

} // namespace

int main(int argc, char** argv) try {
  if (argc != 2)
    return 2;
  const fs::path folder = argv[1];
  const std::vector<Row> states = rows_of(folder / "states.csv");
  for (const Row& state : states)
    check_state(folder, state);
  // Three on the path, two frozen, one taken up again.
  expect(states.size() == 6, "states", static_cast<double>(states.size()), 6);
  check_probes(folder);
  check_again(folder);
  return failures == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::printf("%s\n", error.what());
  return 1;
}
