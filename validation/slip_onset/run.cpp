// SPDX-License-Identifier: GPL-3.0-or-later
// G of dense and loose specimens under shear cycles of growing amplitude at constant normal stress, by DEM
// with contacts that may slide: the record that effective::slip_loss is held to (report.cpp).
// Appends a specimen to the file:
//     slip_onset_run states.csv GRAINS SEED dense|loose PRESSURE_Pa LARGEST_STRAIN
// Appends its closed loops, whose areas are its damping, up to a loss of about 5 %:
//     slip_onset_run loops.csv GRAINS SEED dense|loose PRESSURE_Pa loops
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/output_file.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

#include "states.hpp"

namespace {

using namespace granum;

triaxial::SpecimenRecipe recipe(std::size_t grains, std::uint64_t seed) {
  return {.material = {.law = contact::PowerLaw::sphere(slip_onset::quartz, slip_onset::radius),
                       .tangential_ratio = slip_onset::tangential_ratio(),
                       .friction_coefficient = slip_onset::friction},
          .radius = slip_onset::radius,
          .grains = grains,
          .seed = seed};
}

/// At rest under 10 kPa, 100 kPa and, if so asked, more.
dem::Specimen compressed(const triaxial::SpecimenRecipe& recipe, bool dense, double pressure) {
  std::vector<double> pressures;
  for (double p = 10e3; p < 0.99 * pressure; p *= std::sqrt(10.0))
    pressures.push_back(p);
  pressures.push_back(pressure);
  dem::Specimen state;
  const auto density = dense ? triaxial::Density::dense : triaxial::Density::loose;
  const bool arrived = triaxial::isotropic_path(
      triaxial::start_of_compression(triaxial::frictionless_specimen(recipe).state, density, recipe),
      recipe.material, pressures, triaxial::compression_options(), [&](const triaxial::Snapshot& snapshot) {
        state = snapshot.state;
        return snapshot.report.converged();
      });
  if (!arrived)
    throw std::runtime_error("a specimen did not come to rest");
  return triaxial::freeze_in_place(state, recipe.material).state();
}

/// Secant between the two ends of cycles in the vertical plane, the normal stresses held.
class Cycles {
 public:
  Cycles(const dem::Specimen& state, const dem::Material& material, double amplitude)
      : engine_(state, material), amplitude_(amplitude), held_(engine_.figures().boundary_stress) {
    top_ = sheared(amplitude);
  }
  /// G of the next cycle, down and up again [Pa].
  double next() {
    const double down = sheared(-2 * amplitude_);
    top_ = sheared(2 * amplitude_);
    return (top_ - down) / (2 * amplitude_);
  }
  [[nodiscard]] bool converged() const { return converged_; }

  /// A cycle that is recorded.
  struct Loop {
    double modulus = 0; ///< secant [Pa]
    double damping = 0; ///< area over 4 pi times the elastic energy, D [1]
    double gap = 0;     ///< stress by which it does not close over its amplitude [1]
  };
  Loop loop() {
    constexpr std::size_t points = 16; // of each branch
    const double top = top_, step = 2 * amplitude_ / points;
    std::vector<double> stress{top};
    for (const double sign : {-1.0, 1.0})
      for (std::size_t k = 0; k < points; ++k)
        stress.push_back(top_ = sheared(sign * step));
    const double down = stress[points], height = (top - down) / 2;
    // Both branches are curved alike: the chords of all points, and of every second one, give the arcs.
    const auto area = [&](std::size_t every) {
      double sum = 0;
      for (std::size_t k = 0; k < points; k += every)
        sum -= (stress[k] + stress[k + every]) / 2;
      for (std::size_t k = points; k < 2 * points; k += every)
        sum += (stress[k] + stress[k + every]) / 2;
      return sum * step * static_cast<double>(every);
    };
    const double enclosed = (4 * area(1) - area(2)) / 3;
    return {.modulus = height / amplitude_,
            .damping = enclosed / (2 * std::numbers::pi * height * amplitude_),
            .gap = (top_ - top) / height};
  }

 private:
  double sheared(double by) {
    Mat3 gradient;
    gradient(0, 2) = by;
    const dem::QuasistaticReport report = dem::shear_at_stress(engine_, gradient, 100, held_, {});
    converged_ = converged_ && report.converged();
    return -(report.last_stress(0, 2) + report.last_stress(2, 0)) / 2;
  }

  dem::Engine engine_;
  double amplitude_;
  Vec3 held_;
  double top_ = 0;
  bool converged_ = true;
};

/// Which specimen, and how far it is strained.
struct Asked {
  std::size_t grains = 1000;
  std::uint64_t seed = 1;
  bool dense = true;
  double pressure = 0;       ///< [Pa]
  double largest_strain = 0; ///< amplitude [1]
};

/// The file as it is, or its headings.
io::CsvContent content_of(const std::string& path, std::size_t grains) {
  io::CsvContent csv;
  csv.notes = {{"grains", std::to_string(grains)}, {"signs", "compression positive"}};
  csv.headings = {"density",      "seed",          "p_Pa",   "e",        "C_n",
                  "z_star",       "sliding",       "G0_Pa",  "strain_1", "G_cycle_1_Pa",
                  "G_cycle_3_Pa", "G_cycle_10_Pa", "at_rest"};
  if (!std::filesystem::exists(path))
    return csv;
  const io::CsvTable table = io::read_csv(path);
  for (std::size_t row = 0; row < table.row_count(); ++row)
    csv.rows.emplace_back(table.fields(row).begin(), table.fields(row).end());
  return csv;
}

/// The specimen, and what is counted in it.
struct Prepared {
  dem::Specimen state;
  triaxial::SpecimenRecipe with;
  analysis::Microstructure micro;
  double sliding = 0, G0 = 0;

  explicit Prepared(const Asked& asked)
      : state(compressed(recipe(asked.grains, asked.seed), asked.dense, asked.pressure)),
        with(recipe(asked.grains, asked.seed)) {
    const packing::Assembly network = dem::contact_network(state, with.material);
    micro = analysis::measure(network,
                              {.law = with.material.law, .tangential_ratio = with.material.tangential_ratio})
                .microstructure();
    sliding = packing::sliding_fraction(network, slip_onset::friction);
    G0 = triaxial::probe(state, with.material, triaxial::ShearMode::vh).shear_modulus();
  }
};

/// The third and the tenth cycle of each amplitude, until a loss of 5 %.
void record_loops(const Asked& asked, const std::string& path) {
  const Prepared specimen(asked);
  io::CsvContent csv = content_of(path, asked.grains);
  csv.headings = {"density", "seed",     "p_Pa",  "e",    "C_n", "z_star", "sliding",
                  "G0_Pa",   "strain_1", "cycle", "G_Pa", "D",   "gap",    "at_rest"};
  for (double k = 0; k <= 16; ++k) {
    const double strain = 2e-6 * std::pow(10, k / 6);
    Cycles cycles(specimen.state, specimen.with.material, strain);
    double modulus = 0;
    for (const int cycle : {3, 10}) {
      for (int before = cycle == 3 ? 1 : 4; before < cycle; ++before)
        cycles.next();
      const Cycles::Loop loop = cycles.loop();
      modulus = loop.modulus;
      csv.rows.push_back({std::string(asked.dense ? "dense" : "loose"), static_cast<double>(asked.seed),
                          asked.pressure, dem::void_ratio(specimen.state), specimen.micro.coordination_number,
                          specimen.micro.mechanical_coordination_number, specimen.sliding, specimen.G0,
                          strain, static_cast<double>(cycle), loop.modulus, loop.damping, loop.gap,
                          std::string(cycles.converged() ? "yes" : "no")});
      std::printf("%.2e %d %.4f %.5f %.4f\n", strain, cycle, loop.modulus / specimen.G0, loop.damping,
                  loop.gap);
      std::fflush(stdout);
    }
    if (modulus < 0.95 * specimen.G0)
      break;
  }
  io::write_file(path, io::csv_text(csv), io::Existing::replace);
}

/// All amplitudes of one specimen, below the rows of the file.
void record(const Asked& asked, const std::string& path) {
  io::CsvContent csv = content_of(path, asked.grains);
  const Prepared specimen(asked);
  const auto& [state, with, micro, sliding, G0] = specimen;
  for (double k = 0; k <= 12; ++k) {
    const double strain = 1e-6 * std::pow(10, k / 4);
    if (strain > 1.001 * asked.largest_strain)
      break;
    Cycles cycles(state, with.material, strain);
    const double first = cycles.next();
    cycles.next();
    const double third = cycles.next();
    for (int later = 4; later < 10; ++later)
      cycles.next();
    const double tenth = cycles.next();
    csv.rows.push_back({std::string(asked.dense ? "dense" : "loose"), static_cast<double>(asked.seed),
                        asked.pressure, dem::void_ratio(state), micro.coordination_number,
                        micro.mechanical_coordination_number, sliding, G0, strain, first, third, tenth,
                        std::string(cycles.converged() ? "yes" : "no")});
    std::printf("%.2e %.4f %.4f %.4f\n", strain, first / G0, third / G0, tenth / G0);
    std::fflush(stdout);
  }
  io::write_file(path, io::csv_text(csv), io::Existing::replace);
}

} // namespace

int main(int argc, char** argv) {
  const std::string density = argc == 7 ? argv[4] : "";
  if (density != "dense" && density != "loose") {
    std::fprintf(stderr, "usage: slip_onset_run states.csv GRAINS SEED dense|loose PRESSURE_Pa "
                         "LARGEST_STRAIN|loops\n");
    return 2;
  }
  try {
    const std::string last = argv[6];
    const auto make = last == "loops" ? record_loops : record;
    make({.grains = std::strtoul(argv[2], nullptr, 10),
          .seed = std::strtoul(argv[3], nullptr, 10),
          .dense = density == "dense",
          .pressure = std::strtod(argv[5], nullptr),
          .largest_strain = std::strtod(argv[6], nullptr)},
         argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "slip_onset_run: %s\n", error.what());
    return 1;
  }
}
