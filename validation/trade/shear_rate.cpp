// SPDX-License-Identifier: GPL-3.0-or-later
// Does the friction angle depend on the rate of shear, or on the drag? Dense spheres, each specimen sheared
// from one start at several inertial numbers, and at the default one with several drags.
//
//     trade_shear_rate [table.csv [specimens [grains [lowest rate]]]]
//
// By default 3 specimens of 1000 grains down to a rate of 1e-5, and no table. Exit code: 0 if the mean peak
// angles at the default rate and drag are within 0.3 degrees of those at the lowest rate, or within two
// standard errors; 1 if not, 2 usage.
#include <granum/triaxial/shear_test.hpp>

#include "../common.hpp"
#include "dense_spheres.hpp"

namespace {

using namespace granum;
using namespace trade;

const triaxial::ShearOptions preset;
constexpr std::array rates{1e-3, 5e-4, 2e-4, 5e-5, 1e-5};
constexpr std::array drags{1e-4, 1e-2,
                           0.5}; ///< beside the default; the last is limited as ShearTest limits it

/// A friction angle of each kind [deg]: at the peak, and of the mean q/p' around three axial strains.
using Angles = std::array<double, 4>;
constexpr std::array names{"peak", "1 %", "2 %", "3 %"};
constexpr std::array strains{0.01, 0.02, 0.029};
constexpr double around = 0.00105; ///< half of the width over which q/p' is averaged

struct Row {
  bool walls = false;
  std::uint64_t seed = 0;
  stress::ShearPath path = stress::ShearPath::txc;
  double rate = 0, drag_share = 0;
  Angles angles;
};

Angles sheared(const dem::Specimen& start, const dem::Material& material,
               const triaxial::ShearOptions& options) {
  triaxial::ShearTest test(start, material, options);
  std::array<double, strains.size()> sum{}, count{};
  while (test.advance() == triaxial::ShearEvent::snapshot) {
    for (std::size_t k = 0; k < strains.size(); ++k) {
      if (std::abs(std::abs(test.now().axial_strain) - strains[k]) > around)
        continue;
      sum[k] += test.now().stress.ratio();
      ++count[k];
    }
  }
  Angles angles{};
  angles[0] = stress::mobilised_friction_angle(test.peak().stress) / degree;
  for (std::size_t k = 0; k < strains.size(); ++k)
    angles[k + 1] = angle_at(options.path, sum[k] / count[k]);
  return angles;
}

std::vector<Row> study(std::uint64_t specimens, std::size_t grains, double lowest) {
  std::vector<Row> rows;
  for (const bool walls : {true, false})
    for (std::uint64_t seed = 1; seed <= specimens; ++seed) {
      const triaxial::SpecimenRecipe recipe = recipe_of(walls, seed, grains);
      const dem::Specimen start = compressed(recipe);
      const auto add = [&](stress::ShearPath path, double rate, double drag_share) {
        const triaxial::ShearOptions options{.path = path,
                                             .mean_stress = pressure,
                                             .inertial_number = rate,
                                             .eta_step = 10,
                                             .strain_step = 1e-5,
                                             .drag_share = drag_share};
        rows.push_back({walls, seed, path, rate, drag_share, sheared(start, recipe.material, options)});
        std::fprintf(stderr, "%s, specimen %llu, %s, rate %g, drag %g: %.2f degrees\n",
                     walls ? "walls" : "periodic", static_cast<unsigned long long>(seed),
                     std::string(stress::name(path)).c_str(), rate, drag_share, rows.back().angles[0]);
      };
      for (const stress::ShearPath path : stress::all_shear_paths) {
        for (const double rate : rates)
          if (rate >= lowest)
            add(path, rate, preset.drag_share);
        for (const double drag : drags)
          add(path, preset.inertial_number, drag);
      }
    }
  return rows;
}

io::CsvContent table_of(const std::vector<Row>& rows, std::size_t grains) {
  io::CsvContent table;
  table.headings = {"boundary",
                    "grains",
                    "seed",
                    "path",
                    "inertial_number",
                    "drag_share",
                    "peak_deg",
                    "one_per_cent_deg",
                    "two_per_cent_deg",
                    "three_per_cent_deg"};
  for (const Row& row : rows) {
    auto& cells = table.rows.emplace_back(std::vector<io::CsvCell>{
        std::string(row.walls ? "walls" : "periodic"), static_cast<double>(grains),
        static_cast<double>(row.seed), std::string(stress::name(row.path)), row.rate, row.drag_share});
    for (const double angle : row.angles)
      cells.emplace_back(short_text(angle, 6));
  }
  return table;
}

/// Angles at a rate and drag minus those of the same specimen and path at the reference rate, in the mean.
Mean difference(const std::vector<Row>& rows, bool walls, bool compression, const Row& of, double reference,
                std::size_t kind) {
  std::vector<double> differences;
  for (const Row& a : rows) {
    if (a.walls != walls || stress::is_compression(a.path) != compression || a.rate != of.rate ||
        a.drag_share != of.drag_share)
      continue;
    for (const Row& b : rows)
      if (b.walls == walls && b.seed == a.seed && b.path == a.path && b.rate == reference &&
          b.drag_share == preset.drag_share)
        differences.push_back(a.angles[kind] - b.angles[kind]);
  }
  return mean_of(differences);
}

/// \return   whether the default rate and drag are slow and weak enough
bool report(const std::vector<Row>& rows) {
  double slowest = 1;
  for (const Row& row : rows)
    slowest = std::min(slowest, row.rate);
  bool holds = true;
  for (const bool walls : {true, false})
    for (const bool compression : {true, false}) {
      std::printf("%s, %s: degrees above those at rate %g and drag %g\n", walls ? "walls" : "periodic",
                  compression ? "compression" : "extension", slowest, preset.drag_share);
      for (const Row& row : rows) { // one specimen and path lists all settings
        if (row.walls != walls || row.seed != 1 || stress::is_compression(row.path) != compression ||
            (row.path != stress::ShearPath::txc && row.path != stress::ShearPath::txe) || row.rate == slowest)
          continue;
        std::printf("  rate %-6g drag %-6g", row.rate, row.drag_share);
        for (std::size_t k = 0; k < names.size(); ++k) {
          const Mean d = difference(rows, walls, compression, row, slowest, k);
          std::printf("  %s %+.2f +- %.2f", names[k], d.value, d.error);
          if (k == 0 && row.rate == preset.inertial_number && row.drag_share == preset.drag_share)
            holds = holds && std::abs(d.value) <= std::max(0.3, 2 * d.error);
        }
        std::printf("\n");
      }
    }
  return holds;
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv,
                 {{"", "[table.csv] [specimens] [grains] [lowest-rate]", [](const Arguments& arguments) {
                     const Asked found = asked(arguments, rates.back());
                     if (!(found.last > 0 && found.last < preset.inertial_number))
                       throw InvalidArgument("the lowest rate is not below the default one");
                     const std::vector<Row> rows = study(found.specimens, found.grains, found.last);
                     write(found, table_of(rows, found.grains));
                     return report(rows);
                   }}});
}
