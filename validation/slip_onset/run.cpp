// SPDX-License-Identifier: GPL-3.0-or-later
// G of dense and loose specimens under shear cycles of growing amplitude at constant normal stress, by DEM
// with contacts that may slide: the record that effective::slip_loss is held to (report.cpp).
// Appends a specimen to the file:
//     slip_onset_run states.csv GRAINS SEED dense|loose PRESSURE_Pa LARGEST_STRAIN
// Appends its closed loops, whose areas are its damping, up to a loss of about 5 %:
//     slip_onset_run loops.csv GRAINS SEED dense|loose PRESSURE_Pa loops
#include <filesystem>

#include <granum/analysis/measure.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/output_file.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

#include "../common.hpp"
#include "../relaxation/specimens.hpp"
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
  const auto density = dense ? triaxial::Density::dense : triaxial::Density::loose;
  return triaxial::freeze_in_place(
             relaxation::compressed(triaxial::frictionless_specimen(recipe).state, density, recipe, pressures)
                 .state,
             recipe.material)
      .state();
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

/// Appends rows of one specimen to a file.
class Recorder {
 public:
  Recorder(const Asked& asked, const std::string& path, const std::vector<std::string>& headings)
      : path_(path), material_(recipe(asked.grains, asked.seed).material),
        state_(compressed(recipe(asked.grains, asked.seed), asked.dense, asked.pressure)) {
    csv_.notes = {{"grains", std::to_string(asked.grains)}, {"signs", "compression positive"}};
    csv_.headings = {"density", "seed", "p_Pa", "e", "C_n", "z_star", "sliding", "G0_Pa", "strain_1"};
    csv_.headings.insert(csv_.headings.end(), headings.begin(), headings.end());
    csv_.headings.emplace_back("at_rest");
    if (std::filesystem::exists(path)) {
      const io::CsvTable table = io::read_csv(path);
      for (std::size_t row = 0; row < table.row_count(); ++row)
        csv_.rows.emplace_back(table.fields(row).begin(), table.fields(row).end());
    }
    const packing::Assembly network = dem::contact_network(state_, material_);
    const analysis::Microstructure micro =
        analysis::measure(network, {.law = material_.law, .tangential_ratio = material_.tangential_ratio})
            .microstructure();
    G0_ = triaxial::probe(state_, material_, triaxial::ShearMode::vh).shear_modulus();
    first_ = {std::string(asked.dense ? "dense" : "loose"),
              static_cast<double>(asked.seed),
              asked.pressure,
              dem::void_ratio(state_),
              micro.coordination_number,
              micro.mechanical_coordination_number,
              packing::sliding_fraction(network, slip_onset::friction),
              G0_};
  }
  [[nodiscard]] double G0() const { return G0_; }
  [[nodiscard]] Cycles cycles(double strain) const { return {state_, material_, strain}; }
  void add(double strain, const std::vector<double>& numbers, const Cycles& cycles) {
    std::vector<io::CsvCell>& row = csv_.rows.emplace_back(first_);
    row.emplace_back(strain);
    row.insert(row.end(), numbers.begin(), numbers.end());
    row.emplace_back(std::string(cycles.converged() ? "yes" : "no"));
  }
  void write() const { io::write_file(path_, io::csv_text(csv_), io::Existing::replace); }

 private:
  std::string path_;
  dem::Material material_;
  dem::Specimen state_;
  double G0_ = 0;
  io::CsvContent csv_;
  std::vector<io::CsvCell> first_;
};

/// The third and the tenth cycle of each amplitude, until a loss of 5 %.
void record_loops(const Asked& asked, const std::string& path) {
  Recorder record(asked, path, {"cycle", "G_Pa", "D", "gap"});
  for (double k = 0; k <= 16; ++k) {
    const double strain = 2e-6 * std::pow(10, k / 6);
    Cycles cycles = record.cycles(strain);
    double modulus = 0;
    for (const int cycle : {3, 10}) {
      for (int before = cycle == 3 ? 1 : 4; before < cycle; ++before)
        cycles.next();
      const Cycles::Loop loop = cycles.loop();
      modulus = loop.modulus;
      record.add(strain, {static_cast<double>(cycle), loop.modulus, loop.damping, loop.gap}, cycles);
      std::printf("%.2e %d %.4f %.5f %.4f\n", strain, cycle, loop.modulus / record.G0(), loop.damping,
                  loop.gap);
      std::fflush(stdout);
    }
    if (modulus < 0.95 * record.G0())
      break;
  }
  record.write();
}

/// All amplitudes of one specimen.
void record(const Asked& asked, const std::string& path) {
  Recorder record(asked, path, {"G_cycle_1_Pa", "G_cycle_3_Pa", "G_cycle_10_Pa"});
  for (double k = 0; k <= 12; ++k) {
    const double strain = 1e-6 * std::pow(10, k / 4);
    if (strain > 1.001 * asked.largest_strain)
      break;
    Cycles cycles = record.cycles(strain);
    std::vector<double> G;
    for (int cycle = 1; cycle <= 10; ++cycle)
      if (const double modulus = cycles.next(); cycle == 1 || cycle == 3 || cycle == 10)
        G.push_back(modulus);
    record.add(strain, G, cycles);
    std::printf("%.2e %.4f %.4f %.4f\n", strain, G[0] / record.G0(), G[1] / record.G0(), G[2] / record.G0());
    std::fflush(stdout);
  }
  record.write();
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv,
                 {{"", "states.csv GRAINS SEED dense|loose PRESSURE_Pa LARGEST_STRAIN|loops",
                   [](const Arguments& arguments) {
                     const bool loops = arguments[5] == "loops";
                     if (arguments[3] != "dense" && arguments[3] != "loose")
                       throw std::runtime_error(arguments[3] + " is neither dense nor loose");
                     (loops ? record_loops : record)({.grains = std::stoul(arguments[1]),
                                                      .seed = std::stoul(arguments[2]),
                                                      .dense = arguments[3] == "dense",
                                                      .pressure = std::stod(arguments[4]),
                                                      .largest_strain = loops ? 0 : std::stod(arguments[5])},
                                                     arguments[0]);
                   }}});
}
