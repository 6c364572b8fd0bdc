// SPDX-License-Identifier: GPL-3.0-or-later
// Speed against accuracy: makes a fixed set of packings and asks every rung of the ladder about each.
//
//     ladder_run table.csv [grains]
//
// Rungs 0 to 3 know what was measured on the packing, and once more only C_n; rung 4 solves its contact
// network, rung 5 probes it by DEM (first seed). Costs are processor time. Some minutes with 1,500 grains.
#include <ctime>
#include <fstream>

#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/network/linear_response.hpp>

#include "../common.hpp"
#include "../relaxation/recording.hpp"
#include "../relaxation/specimens.hpp"
#include "table.hpp"

namespace {

using namespace granum;
using ladder::Moduli;
using ladder::Row;
using ladder::Specimen;
using triaxial::Density;

using relaxation::kPa;

/// One way to make a specimen, and the states of it that are asked about.
struct Case {
  const char* contact;
  relaxation::Preparation preparation;
};

std::vector<Case> cases(std::size_t grains) {
  const std::vector<relaxation::Stage> isotropic{{10 * kPa}, {100 * kPa}};
  const std::vector<relaxation::Stage> sheared{{10 * kPa}, {100 * kPa}, {100 * kPa, 0.4}, {100 * kPa, 0.8}};
  std::vector<Case> all;
  for (const char* contact : {"sphere", "cone", "flat"})
    for (const Density density : {Density::dense, Density::loose})
      all.push_back(
          {contact,
           {.name = density == Density::dense ? "dense" : "loose",
            .density = density,
            .friction_coefficient = relaxation::usual_friction(),
            .path = density == Density::loose && contact == std::string("sphere") ? sheared : isotropic,
            .grains = grains,
            .max_steps = triaxial::compression_options().max_steps}});
  return all;
}

/// None of the seeds that rung 3 is calibrated on.
constexpr std::uint64_t first_seed = 11, last_seed = 12;

// ---- costs ----

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Median over `repeats` of the processor time of one call, each taken over enough calls to be measured.
template <class Call>
double cost_of(const Call& call, int repeats) {
  constexpr double shortest = 5e-3; // [s], against the microsecond that the clock resolves
  std::vector<double> times;
  long calls = 1;
  while (static_cast<int>(times.size()) < repeats) {
    const double start = processor_time();
    for (long k = 0; k < calls; ++k)
      call();
    const double spent = processor_time() - start;
    if (spent < shortest)
      calls *= 4;
    else
      times.push_back(spent / static_cast<double>(calls));
  }
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  return times[static_cast<std::size_t>(repeats / 2)];
}

volatile double sink; // what the compiler may not leave out

double closed_form_cost(std::size_t rung, const effective::State& s) {
  constexpr int repeats = 9;
  switch (rung) {
  case 0: {
    const effective::IsotropicPacking isotropic{.law = s.law,
                                                .tangential_ratio = s.tangential_ratio,
                                                .radius = s.radius,
                                                .void_ratio = s.void_ratio,
                                                .coordination_number = *s.coordination_number,
                                                .pressure = s.mean_stress()};
    return cost_of([&] { sink = effective::uniform_strain_moduli(isotropic).shear_modulus; }, repeats);
  }
  case 1:
    return cost_of([&] { sink = effective::uniform_strain_stiffness(effective::uniform_contacts(s)).C44; },
                   repeats);
  case 2:
    return cost_of([&] { sink = effective::uniform_strain(s).stiffness.C44; }, repeats);
  default:
    return cost_of([&] { sink = effective::relaxed(s, *s.mechanical_coordination_number).stiffness.C44; },
                   repeats);
  }
}

// ---- rungs ----

class Table {
 public:
  explicit Table(const std::string& path) : out_(path) { out_ << ladder::csv_headings(); }
  void add(Row row, const Moduli& reference) {
    row.error = ladder::errors(row.value, reference);
    out_ << ladder::csv_line(row) << std::flush;
  }
  [[nodiscard]] bool good() const { return out_.good(); }

 private:
  std::ofstream out_;
};

void add_closed_forms(Table& table, const Specimen& specimen, const Moduli& network) {
  for (const char* known : {"all", "C_n"}) {
    const estimate::Answer answer = ladder::answer_of(ladder::state_of(specimen), known);
    const estimate::Ladder assessed = estimate::choose(answer, 0.05);
    for (std::size_t k = 0; k <= 3; ++k) {
      const estimate::RungAssessment& rung = assessed.rungs[k];
      if (!rung.stiffness)
        continue;
      table.add({.specimen = specimen,
                 .known = known,
                 .rung = static_cast<double>(k),
                 .value = ladder::moduli(*rung.stiffness),
                 .stated = ladder::triple(rung.relative_error.value()),
                 .cost = closed_form_cost(k, answer.state())},
                network);
    }
  }
}

struct Network {
  Row row;
  elastic::VoigtStiffness stiffness;
};

Network solve_network(const Specimen& specimen, const packing::Assembly& assembly) {
  const auto solve = [&assembly] { return network::linear_response(assembly); };
  const elastic::VoigtStiffness stiffness = solve().relaxed();
  return {.row = {.specimen = specimen,
                  .known = "packing",
                  .rung = 4,
                  .value = ladder::moduli(elastic::transversely_isotropic_projection(stiffness)),
                  .cost = cost_of([&solve] { sink = solve().report().residual; }, 5)},
          .stiffness = stiffness};
}

/// One modulus a probe; the bulk modulus is not probed.
Row probe_row(const Specimen& specimen, const dem::Specimen& frozen, const dem::Material& material) {
  using triaxial::ShearMode;
  const auto modulus = [&](ShearMode mode) {
    const triaxial::ProbeResult result = triaxial::probe(frozen, material, mode);
    return result.converged ? result.shear_modulus() : effective::State::unset;
  };
  return {.specimen = specimen,
          .known = "packing",
          .rung = 5,
          .value = {effective::State::unset, modulus(ShearMode::hh), modulus(ShearMode::vh)},
          .cost = cost_of([&modulus] { sink = modulus(ShearMode::vh); }, 5)};
}

void run_stage(Table& table, const Case& c, std::uint64_t seed, const relaxation::Stage& stage,
               const dem::Specimen& state, const dem::Material& material) {
  const triaxial::FrozenState frozen = triaxial::freeze_in_place(state, material);
  const packing::Assembly assembly = dem::contact_network(frozen.state(), material);
  const analysis::Measurement measured = analysis::measure(assembly);
  const analysis::Microstructure micro = measured.microstructure();
  const Mat3& stress = measured.stress.value().symmetric;
  const Specimen specimen{.contact = c.contact,
                          .preparation = c.preparation.name,
                          .seed = static_cast<double>(seed),
                          .grains = static_cast<double>(assembly.grain_count()),
                          .pressure = stage.pressure,
                          .stress_ratio = stage.stress_ratio,
                          .void_ratio = dem::void_ratio(frozen.state()),
                          .C_n = micro.coordination_number,
                          .z_star = micro.mechanical_coordination_number,
                          .a = micro.fabric_anisotropy,
                          .stress_v = stress(2, 2),
                          .stress_h = (stress(0, 0) + stress(1, 1)) / 2};
  const Network network = solve_network(specimen, assembly);
  add_closed_forms(table, specimen, network.row.value);
  table.add(network.row, network.row.value);
  // A probe shears one plane, the transversely isotropic mean of the network takes in the others.
  const elastic::Matrix6& own = network.stiffness.matrix;
  if (seed == first_seed)
    table.add(probe_row(specimen, frozen.state(), material), {effective::State::unset, own(5, 5), own(4, 4)});
  std::fprintf(stderr, "%s\n", specimen.name().c_str());
}

void run_specimen(Table& table, const Case& c, std::uint64_t seed) {
  triaxial::SpecimenRecipe recipe = relaxation::recipe(
      relaxation::detail::law(c.contact, ladder::grain_radius), ladder::grain_radius, c.preparation, seed);
  recipe.material.tangential_ratio =
      relaxation::no_slip_ratio; // its last digit decides the bits of the record
  dem::Specimen state = triaxial::start_of_compression(triaxial::frictionless_specimen(recipe).state,
                                                       c.preparation.density, recipe);
  for (std::size_t k = 0; k < c.preparation.path.size(); ++k) {
    state = relaxation::at_stage(std::move(state), c.preparation, k, recipe.material);
    run_stage(table, c, seed, c.preparation.path[k], state, recipe.material);
  }
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv, {{"", "table.csv [grains]", [](const Arguments& arguments) {
                                 const std::size_t grains =
                                     arguments.size() > 1 ? std::stoul(arguments[1]) : 1500;
                                 Table table(arguments[0]);
                                 for (std::uint64_t seed = first_seed; seed <= last_seed; ++seed)
                                   for (const Case& c : cases(grains))
                                     run_specimen(table, c, seed);
                                 return table.good();
                               }}});
}
