// SPDX-License-Identifier: GPL-3.0-or-later
// How the state of a loose specimen answers to its recipe: C_n, z*, rattlers and void ratio at 10 kPa against
// the random move (agitation) and the linear strain (unjamming_strain) between jamming and compression with
// friction.
//
//     loose_state table.csv [grains] [seeds]
#include <granum/analysis/measure.hpp>
#include <granum/contact/grains.hpp>
#include <granum/io/csv/table.hpp>
#include <granum/io/output_file.hpp>
#include <granum/triaxial/specimen.hpp>

#include "../common.hpp"
#include "../relaxation/specimens.hpp"

namespace {

using namespace granum;

/// One specimen at 10 kPa.
struct Sample {
  analysis::Microstructure micro;
  double void_ratio = 0;
  std::size_t steps = 0;
};

Sample compressed(const dem::Specimen& packing, const triaxial::SpecimenRecipe& recipe) {
  const triaxial::Snapshot at =
      relaxation::compressed(packing, triaxial::Density::loose, recipe, {recipe.first_pressure});
  return {.micro = analysis::measure(
                       dem::contact_network(at.state, recipe.material),
                       {.law = recipe.material.law, .tangential_ratio = recipe.material.tangential_ratio})
                       .microstructure(),
          .void_ratio = dem::void_ratio(at.state),
          .steps = at.report.steps};
}

/// Over the seeds.
template <class Of>
Mean mean(const std::vector<Sample>& samples, const Of& of) {
  std::vector<double> values;
  for (const Sample& sample : samples)
    values.push_back(of(sample));
  return mean_of(values);
}

void run(const std::string& path, std::size_t grains, std::size_t seeds) {
  std::vector<dem::Specimen> packings;
  for (std::size_t k = 0; k < seeds; ++k)
    packings.push_back(triaxial::frictionless_specimen(relaxation::sphere_recipe(grains, k + 1)).state);
  io::CsvContent csv;
  csv.notes = {{"grains", std::to_string(grains)}, {"seeds", std::to_string(seeds)}};
  csv.headings = {"unjamming_strain", "agitation", "C_n", "C_n_error", "z_star",
                  "z_star_error",     "rattlers",  "e",   "e_error",   "steps"};
  const std::pair<double, double> recipes[] = {{0.003, 0},    {0.003, 0.001}, {0.003, 0.003}, {0.003, 0.006},
                                               {0.003, 0.01}, {0.003, 0.03},  {0.003, 0.1},   {0.003, 0.3},
                                               {0.001, 0.03}, {0.01, 0.03}};
  std::printf("unjamming  agitation    C_n             z*     rattlers  e\n");
  for (const auto& [strain, agitation] : recipes) {
    std::vector<Sample> samples;
    for (std::size_t k = 0; k < seeds; ++k) {
      triaxial::SpecimenRecipe one = relaxation::sphere_recipe(grains, k + 1);
      one.unjamming_strain = strain;
      one.agitation = agitation;
      samples.push_back(compressed(packings[k], one));
    }
    const Mean c = mean(samples, [](const Sample& s) { return s.micro.coordination_number; });
    const Mean z = mean(samples, [](const Sample& s) { return s.micro.mechanical_coordination_number; });
    const Mean rattlers = mean(samples, [](const Sample& s) { return s.micro.rattler_fraction; });
    const Mean e = mean(samples, [](const Sample& s) { return s.void_ratio; });
    const Mean steps = mean(samples, [](const Sample& s) { return static_cast<double>(s.steps); });
    csv.rows.push_back({strain, agitation, c.value, c.error, z.value, z.error, rattlers.value, e.value,
                        e.error, std::round(steps.value)});
    std::printf("%9.3f  %9.3f  %.3f +- %.3f  %.3f  %.3f     %.4f +- %.4f\n", strain, agitation, c.value,
                c.error, z.value, rattlers.value, e.value, e.error);
    std::fflush(stdout);
    io::write_file(path, io::csv_text(csv), io::Existing::replace);
  }
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv, {{"", "table.csv [grains] [seeds]", [](const Arguments& arguments) {
                                 run(arguments[0], arguments.size() > 1 ? std::stoul(arguments[1]) : 1000,
                                     arguments.size() > 2 ? std::stoul(arguments[2]) : 3);
                               }}});
}
