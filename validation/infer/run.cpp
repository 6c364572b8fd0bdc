// SPDX-License-Identifier: GPL-3.0-or-later
// Does inference give back the contacts of packings that are known, and foretell their moduli elsewhere? The
// network's G and K of granum's own packings are the measurements, the counted z* and the networks at other
// pressures the truth.
//     infer_run <validation/relaxation/states.csv> <validation/laboratory/beads_states.csv> [states.csv]
// Exit code 0 only if what README.md promises holds.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/inverse/inference.hpp>
#include <granum/io/csv/table.hpp>

#include "../relaxation/reading.hpp"
#include "contacts.hpp"

namespace {

using namespace granum;
using effective::State;
using inverse::Observation;
using inverse::Quantity;

/// A packing that is known altogether.
struct Known {
  std::string group;    ///< what it is reported under
  std::string specimen; ///< one a specimen
  State state;
  double coordination = 0;   ///< z* as counted
  double shear_modulus = 0;  ///< of the network [Pa]
  double bulk_modulus = 0;   ///< of the network [Pa]
  double overlap = 0;        ///< of the mean force over the diameter
  bool on_the_way_up = true; ///< pressure was never larger before
};

constexpr double largest_overlap = 0.01;

std::vector<Known> packings_of_relaxation(const std::string& path) {
  std::vector<Known> all;
  for (const relaxation::Packing& p : relaxation::read_packings(path)) {
    if (!p.isotropic())
      continue;
    const auto of_specimen = [&](const relaxation::Network& n) {
      return std::abs(n.ratio - p.state.tangential_ratio) < 1e-9;
    };
    const auto network = std::find_if(p.networks.begin(), p.networks.end(), of_specimen);
    State state = p.state;
    state.stress_v = state.stress_h = (p.state.stress_v + 2 * p.state.stress_h) / 3;
    state.fabric_anisotropy = 0;
    all.push_back({.group = p.contact,
                   .specimen = p.specimen,
                   .state = state,
                   .coordination = p.mechanical_coordination,
                   .shear_modulus = relaxation::isotropic_shear_modulus(network->stiffness),
                   .bulk_modulus = network->stiffness.bulk_modulus(),
                   .overlap = p.relative_overlap,
                   .on_the_way_up = p.preparation != "cycle"});
  }
  // The file has the states of a specimen in the order of its path, but those of others between them.
  std::ranges::stable_sort(all, {}, &Known::specimen);
  return all;
}

/// Specimens of `granum verify`: other seeds, other grains.
std::vector<Known> packings_of_beads(const std::string& path) {
  const io::CsvTable table = io::read_csv(path);
  const auto column = [&](const char* name) { return table.numbers(name, Dimension::dimensionless); };
  const auto stress = [&](const char* name) { return table.numbers(name, Dimension::pressure); };
  const auto p = stress("p"), K = stress("K_network"), G = stress("G_network");
  const auto e = column("e"), C_n = column("C_n"), z = column("z_star"), seed = column("seed");
  const contact::GrainMaterial glass{.shear_modulus = 29e9, .poisson_ratio = 0.2};
  const double radius = 0.05e-3;
  std::vector<Known> all;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const State state{.law = contact::PowerLaw::sphere(glass, radius),
                      .tangential_ratio = contact::mindlin_stiffness_ratio(0.2),
                      .radius = radius,
                      .void_ratio = e[k],
                      .coordination_number = C_n[k],
                      .stress_v = p[k],
                      .stress_h = p[k]};
    const std::string density = table.fields(k)[1];
    all.push_back({.group = "beads",
                   .specimen = density + std::to_string(static_cast<int>(seed[k])),
                   .state = state,
                   .coordination = z[k],
                   .shear_modulus = G[k],
                   .bulk_modulus = K[k],
                   .overlap = state.law.overlap(effective::mean_contact_force(state)) / (2 * radius)});
  }
  return all;
}

inverse::InferenceAnswer infer_from(const Known& known, Quantity quantity, inverse::GrowthRule growth) {
  const double value = quantity == Quantity::K ? known.bulk_modulus : known.shear_modulus;
  const Observation measured{quantity, {value, 0}, known.state};
  return inverse::infer(std::span(&measured, 1), {.growth = growth});
}

// ---- distributions

struct Miss {
  double error = 0;          ///< found minus true
  double stated = 0;         ///< standard error
  std::string specimen = {}; ///< its misses are not independent
};

/// Share of the specimens of which the root mean square of error over stated error is at most `errors`.
double specimens_within(const std::vector<Miss>& misses, double errors) {
  std::map<std::string, std::vector<double>> squares;
  for (const Miss& miss : misses)
    squares[miss.specimen].push_back(std::pow(miss.error / miss.stated, 2));
  double within = 0;
  for (const auto& [specimen, of_it] : squares) {
    const double mean = std::accumulate(of_it.begin(), of_it.end(), 0.0) / static_cast<double>(of_it.size());
    within += std::sqrt(mean) <= errors;
  }
  return within / static_cast<double>(squares.size());
}

struct Summary {
  double rms = 0, within_tenth = 0, within_one = 0, within_two = 0;
};

Summary report(const std::string& name, const std::vector<Miss>& misses, double unit, const char* symbol) {
  const double count = static_cast<double>(misses.size());
  double mean = 0, worst = 0;
  Summary s;
  for (const auto& [error, stated, specimen] : misses) {
    mean += error / count;
    s.rms += error * error / count;
    worst = std::max(worst, std::abs(error));
    s.within_tenth += (std::abs(error) <= 0.1) / count;
    s.within_one += (std::abs(error) <= stated) / count;
    s.within_two += (std::abs(error) <= 2 * stated) / count;
  }
  s.rms = std::sqrt(s.rms);
  std::printf("  %-34s %4zu  mean %+7.3f%s  rms %6.3f%s  worst %6.3f%s", name.c_str(), misses.size(),
              mean / unit, symbol, s.rms / unit, symbol, worst / unit, symbol);
  if (unit == 1)
    std::printf("  within 0.1 %3.0f %%", 100 * s.within_tenth);
  std::printf("  within one stated error %3.0f %%, two %3.0f %%\n", 100 * s.within_one, 100 * s.within_two);
  return s;
}

/// z* as found minus z* as counted.
std::vector<Miss> coordination_misses(const std::vector<Known>& all, Quantity quantity, double low,
                                      double high, const std::function<bool(const Known&)>& wanted) {
  std::vector<Miss> misses;
  for (const Known& known : all) {
    if (!wanted(known) || known.coordination < low || known.coordination > high ||
        known.overlap > largest_overlap)
      continue;
    const auto answer = infer_from(known, quantity, inverse::GrowthRule::fixed);
    if (!answer.together)
      continue; // K below what any rigid network has
    const Measured z = answer.together->packing(known.state).mechanical_coordination_number;
    misses.push_back({z.value - known.coordination, z.standard_error});
  }
  return misses;
}

/// ln G as predicted from the first state of each specimen, minus ln G of its network there.
std::vector<Miss> prediction_misses(const std::vector<Known>& all, inverse::GrowthRule growth) {
  std::vector<Miss> misses;
  const Known* first = nullptr;
  std::optional<inverse::InferenceAnswer> answer;
  for (const Known& known : all) {
    if (!known.on_the_way_up || known.overlap > largest_overlap)
      continue;
    if (first == nullptr || first->specimen != known.specimen) {
      first = &known;
      answer = infer_from(known, Quantity::G_vh, growth);
      continue;
    }
    if (!answer->together)
      continue;
    const Measured G = answer->together->predict(Quantity::G_vh, known.state);
    misses.push_back({std::log(G.value / known.shear_modulus), G.standard_error / G.value, known.specimen});
  }
  return misses;
}

void run(const std::string& states, const std::string& beads, Claims& claims) {
  const std::vector<Known> own = packings_of_relaxation(states), fresh = packings_of_beads(beads);
  const auto any = [](const Known&) { return true; };
  const double low = 4.4, high = 6.3;
  std::printf("z* of G of the network, minus z* as counted, z* from 4.4 to 6.3\n");
  const Summary all = report("all that rung 3 was calibrated on",
                             coordination_misses(own, Quantity::G_vh, low, high, any), 1, "");
  for (const char* shape : {"cone", "sphere", "alpha1.5", "flat", "alpha4"})
    (void)report(
        shape,
        coordination_misses(own, Quantity::G_vh, low, high, [&](const Known& k) { return k.group == shape; }),
        1, "");
  const Summary of_beads =
      report("glass beads, fresh seeds", coordination_misses(fresh, Quantity::G_vh, low, high, any), 1, "");
  std::printf("the same of K\n");
  (void)report("all", coordination_misses(own, Quantity::K, low, high, any), 1, "");
  std::printf("ln G predicted from the first pressure of each specimen, z* growing as own packings'\n");
  const Summary grown = report("all", prediction_misses(own, inverse::GrowthRule::packings), 0.01, " %");
  const std::vector<Miss> of_fresh = prediction_misses(fresh, inverse::GrowthRule::packings);
  const Summary of_beads_grown = report("glass beads, fresh seeds", of_fresh, 0.01, " %");
  const double beads_within = specimens_within(of_fresh, 2);
  std::printf("  %-34s %.0f %% within two stated errors (rms)\n", "- their specimens", 100 * beads_within);
  std::printf("the same with z* fixed\n");
  const Summary fixed = report("all", prediction_misses(own, inverse::GrowthRule::fixed), 0.01, " %");
  (void)report("glass beads, fresh seeds", prediction_misses(fresh, inverse::GrowthRule::fixed), 0.01, " %");

  claims.require(all.rms < 0.1 && of_beads.rms < 0.1, "z*: rms within 0.1");
  claims.require(all.within_two > 0.9, "z*: more than 90 % within two stated errors");
  claims.require(grown.rms < 0.5 * fixed.rms, "ln G: half the rms of a z* that is fixed");
  claims.require(grown.within_two > 0.9, "ln G: more than 90 % within two stated errors");
  Claims::aim(of_beads_grown.within_two > 0.8,
              "ln G of fresh beads: more than 80 % within two stated errors");
  claims.require(beads_within > 0.8, "ln G of fresh beads: more than 80 % of the specimens in rms");
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr, "usage: infer_run relaxation/states.csv laboratory/beads_states.csv [states.csv]\n");
    return 2;
  }
  try {
    Claims claims;
    run(argv[1], argv[2], claims);
    if (argc == 4)
      implied::judge(argv[3], claims);
    return claims.failed() == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "infer_run: %s\n", error.what());
    return 2;
  }
}
