// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the packings that the relaxation factor is calibrated on, and solves their contact networks.
//
//     relaxation_run states.csv [threads]
//
// One row a state is appended as soon as the state is finished. A run that is started again skips the states
// that the file holds already, so it may be stopped at any time; a specimen whose path was cut is compressed
// anew, to the same bits. States that do not come to rest are named on the error stream and left out.
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/contact/friction.hpp>
#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/projection.hpp>
#include <granum/network/linear_response.hpp>
#include <granum/packing/cell_work.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/packing/force_moments.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

namespace {

using namespace granum;

constexpr double radius = 0.5e-3; // R [m]
constexpr contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
constexpr double ratios[] = {0, 0.03, 0.1, 0.3, 0.6, 0.918918918918919, 1}; // k_t/k_n of the solved networks
constexpr double kPa = 1e3, MPa = 1e6;

/// One kind of contact.
struct Shape {
  const char* name;
  contact::PowerLaw law;
  double pressure_limit; // [Pa]; beyond, the contact discs are no longer small
  bool fitted = true;    // else made by some preparations alone, to be compared with what the fit says
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{
      {"cone", contact::PowerLaw::cone(grain, 0.4), 100 * MPa},
      {"sphere", contact::PowerLaw::sphere(grain, radius), 100 * MPa},
      {"flat", contact::PowerLaw::flat(grain, 5.7e-6), 30 * MPa},
      {"alpha1.5", contact::PowerLaw::general(grain, 1.5, 180), 100 * MPa},
      {"alpha4", contact::PowerLaw::general(grain, 4, 2e12), 30 * MPa, false},
  };
  return all;
}

/// Mean stress and stress ratio q/p of one state on a path.
struct Stage {
  double pressure = 0;     // [Pa]
  double stress_ratio = 0; // (stress_v - stress_h)/p
};

/// How a jammed specimen is opened before friction is switched on.
struct Opening {
  double strain = 0.003;   // linear, each time
  double agitation = 0.03; // of the grains after it, over the radius
  int times = 1;
};
constexpr Opening slight{.strain = 0.01, .agitation = 0.1};
constexpr Opening stirred{.strain = 0.02, .agitation = 0.3};
constexpr Opening to_a_gas{.strain = 0.09, .agitation = 0.5, .times = 4}; // of a solid fraction of 0.23

/// One way to make a specimen, and its stress path.
struct Preparation {
  const char* name;
  triaxial::Density density = triaxial::Density::loose;
  double friction_coefficient; // of the compression
  std::vector<Stage> path;
  Opening opening = {};
  std::size_t grains = 4000;
  std::size_t max_steps = 40000; // of a stage
  double approach = 1;           // how many times faster than usual the first stage may be compressed
  bool unfitted_shapes = false;  // makes packings of the shapes that no fit sees as well
};

Preparation gas(const char* name, double friction_coefficient, const std::vector<Stage>& path,
                bool unfitted_shapes = false) {
  return {.name = name,
          .friction_coefficient = friction_coefficient,
          .path = path,
          .opening = to_a_gas,
          .grains = 2000,
          .max_steps = 200000,
          .approach = 20,
          .unfitted_shapes = unfitted_shapes};
}

const std::vector<Preparation>& preparations() {
  using enum triaxial::Density;
  const double mu = contact::Friction::from_angle(26.5 * M_PI / 180).coefficient();
  const std::vector<Stage> low{{10 * kPa}, {30 * kPa}, {100 * kPa}};
  std::vector<Stage> wide = low;
  wide.insert(wide.end(), {{1 * MPa}, {10 * MPa}, {30 * MPa}, {100 * MPa}});
  const std::vector<Stage> decades{{10 * kPa}, {100 * kPa}, {1 * MPa}};
  const std::vector<Stage> cycle{{10 * kPa}, {3 * MPa}, {300 * kPa}, {100 * kPa}, {30 * kPa}, {10 * kPa}};
  const std::vector<Stage> compression{{100 * kPa},      {100 * kPa, 0.2}, {100 * kPa, 0.4},
                                       {100 * kPa, 0.6}, {100 * kPa, 0.7}, {100 * kPa, 0.8}};
  const std::vector<Stage> extension{{100 * kPa}, {100 * kPa, -0.25}, {100 * kPa, -0.5}, {100 * kPa, -0.6}};
  static const std::vector<Preparation> all{
      {.name = "dense", .density = dense, .friction_coefficient = mu, .path = wide, .unfitted_shapes = true},
      {.name = "loose", .friction_coefficient = mu, .path = low, .unfitted_shapes = true},
      {.name = "mu0.1", .friction_coefficient = 0.1, .path = decades},
      {.name = "mu0.2", .friction_coefficient = 0.2, .path = decades},
      {.name = "dense txc", .density = dense, .friction_coefficient = mu, .path = compression},
      {.name = "loose txc", .friction_coefficient = mu, .path = compression},
      {.name = "mu0.03", .friction_coefficient = 0.03, .path = decades},
      {.name = "mu1",
       .friction_coefficient = 1,
       .path = low,
       .opening = slight,
       .grains = 1000,
       .max_steps = 200000},
      {.name = "dense txe", .density = dense, .friction_coefficient = mu, .path = extension},
      {.name = "cycle", .friction_coefficient = mu, .path = cycle},
      {.name = "mu0.2 txc", .friction_coefficient = 0.2, .path = compression},
      {.name = "agitated",
       .friction_coefficient = mu,
       .path = low,
       .opening = stirred,
       .grains = 1000,
       .max_steps = 200000},
      gas("gas mu0.02", 0.02, decades),
      gas("gas mu0.1", 0.1, decades),
      gas("gas mu0.3", 0.3, decades, true),
      gas("gas", mu, decades),
      gas("gas mu1", 1, decades),
  };
  return all;
}

triaxial::SpecimenRecipe recipe(const Shape& shape, const Preparation& preparation, std::uint64_t seed) {
  return {.material = {.law = shape.law,
                       .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                       .friction_coefficient = preparation.friction_coefficient},
          .radius = radius,
          .grains = preparation.grains,
          .seed = seed,
          .first_pressure = preparation.path.front().pressure,
          .unjamming_strain = preparation.opening.strain,
          .agitation = preparation.opening.agitation};
}

/// A row in the making: headings and cells side by side.
struct Row {
  std::string headings;
  std::string cells;

  void add(const std::string& heading, const std::string& cell) {
    const char* comma = headings.empty() ? "" : ",";
    headings += comma + heading;
    cells += comma + cell;
  }
  void add(const std::string& heading, double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.7g", value);
    add(heading, std::isnan(value) ? std::string() : std::string(text));
  }
};

void add_stiffness(Row& row, const std::string& suffix, const elastic::VoigtStiffness& stiffness) {
  const elastic::TransverselyIsotropic c = elastic::transversely_isotropic_projection(stiffness);
  row.add("C11_" + suffix + "_Pa", c.C11);
  row.add("C33_" + suffix + "_Pa", c.C33);
  row.add("C12_" + suffix + "_Pa", c.C12);
  row.add("C13_" + suffix + "_Pa", c.C13);
  row.add("C44_" + suffix + "_Pa", c.C44);
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// The packing stays; only the tangential stiffness of its elastic contacts is another.
void add_networks(Row& row, packing::Assembly assembly, double own_ratio) {
  int iterations = 0;
  double residual = 0;
  network::Options options;
  for (const double ratio : ratios) {
    for (packing::Contact& contact : assembly.contacts)
      contact.tangential_stiffness = ratio * contact.normal_stiffness;
    // Without tangential stiffness most of the packings are floppy: no use in insisting on ten digits.
    options.iteration_limit = ratio > 0 ? 20000 : 1500;
    const network::Response response = network::linear_response(assembly, options);
    if (ratio > 0 && !response.converged())
      throw std::runtime_error("a network did not converge");
    add_stiffness(row, short_number(ratio), response.last_iterate());
    if (ratio > 0) {
      iterations = std::max(iterations, response.report().iterations);
      residual = std::max(residual, response.report().residual);
    } else {
      row.add("residual_0", response.report().residual);
    }
  }
  row.add("iterations", iterations);
  row.add("residual", residual);

  for (packing::Contact& contact : assembly.contacts)
    contact.tangential_stiffness = own_ratio * contact.normal_stiffness;
  const network::Response plain = network::linear_response(assembly);
  add_stiffness(row, "affine", plain.affine());
  options.prestress = true;
  const network::Response stressed = network::linear_response(assembly, options);
  const bool definite = stressed.converged();
  const elastic::Matrix6& c = stressed.last_iterate().matrix;
  row.add("C44_prestress_Pa", definite ? (c(3, 3) + c(4, 4)) / 2 : std::numeric_limits<double>::quiet_NaN());
  row.add("C66_prestress_Pa", definite ? c(5, 5) : std::numeric_limits<double>::quiet_NaN());
}

double mean_tangential_share(const packing::Assembly& assembly) {
  double normal_sum = 0, tangential_sum = 0;
  for (const packing::Contact& c : assembly.contacts) {
    normal_sum += c.normal_force;
    tangential_sum += norm(c.tangential_force);
  }
  return tangential_sum / normal_sum;
}

void add_assembly(Row& row, const packing::Assembly& assembly, const dem::Material& material) {
  const analysis::Measurement measured =
      analysis::measure(assembly, {.law = material.law, .tangential_ratio = material.tangential_ratio});
  const analysis::Microstructure micro = measured.microstructure();
  const packing::MechanicalCoordination frictionless =
      mechanical_coordination(assembly, packing::ContactKind::frictionless);
  const Mat3& stress = measured.stress.value().symmetric;
  const packing::BulkModulusBounds bounds = bulk_modulus_bounds(assembly);
  const double b = material.law.stiffness_exponent();
  row.add("C_n", micro.coordination_number);
  row.add("z_star", micro.mechanical_coordination_number);
  row.add("rattler_fraction", micro.rattler_fraction);
  row.add("z_star_frictionless", frictionless.coordination_number);
  row.add("rattler_fraction_frictionless", frictionless.rattler_fraction);
  row.add("a", micro.fabric_anisotropy);
  row.add("stress_v_Pa", stress(2, 2));
  row.add("stress_h_Pa", (stress(0, 0) + stress(1, 1)) / 2);
  row.add("force_moment_b", normal_force_moment(assembly, b));
  row.add("force_moment_2", normal_force_moment(assembly, 2));
  row.add("force_moment_2_minus_b", normal_force_moment(assembly, 2 - b));
  row.add("tangential_share", mean_tangential_share(assembly));
  row.add("K_lower_Pa", bounds.lower);
  row.add("K_upper_Pa", bounds.upper);
}

/// What one row says of a frozen state.
void describe(Row& row, const dem::Specimen& frozen, const dem::Material& material) {
  const packing::Assembly assembly = dem::contact_network(frozen, material);
  row.add("e", dem::void_ratio(frozen));
  add_assembly(row, assembly, material);
  add_networks(row, assembly, material.tangential_ratio);
}

/// The output file: which states it holds, and how another is added.
class Record {
 public:
  explicit Record(const std::filesystem::path& path) : path_(path) {
    std::ifstream in(path);
    std::string line, whole;
    while (std::getline(in, line) && !in.eof()) { // a last line without its end was cut: it is done again
      whole += line + "\n";
      done_.insert(key_of(line));
    }
    in.close();
    std::ofstream(path) << whole;
  }
  static std::string key_of(const std::string& line) {
    std::size_t end = 0;
    for (int field = 0; field < key_fields && end != std::string::npos; ++field)
      end = line.find(',', end + 1);
    return line.substr(0, end);
  }
  [[nodiscard]] bool has(const Row& row) {
    const std::lock_guard lock(mutex_);
    return done_.count(key_of(row.cells)) > 0;
  }
  void append(const Row& row) {
    const std::lock_guard lock(mutex_);
    std::ofstream out(path_, std::ios::app);
    if (done_.empty())
      out << row.headings << "\n";
    out << row.cells << "\n";
    done_.insert(key_of(row.cells));
  }

 private:
  static constexpr int key_fields = 6;
  std::filesystem::path path_;
  std::set<std::string> done_;
  std::mutex mutex_;
};

/// The first columns: six that name a state, and what else it was made with.
Row key(const Shape& shape, const Preparation& preparation, std::uint64_t seed, const Stage& stage,
        std::size_t number) {
  Row row;
  row.add("contact", std::string(shape.name));
  row.add("preparation", std::string(preparation.name));
  row.add("seed", static_cast<double>(seed));
  row.add("grains", static_cast<double>(preparation.grains));
  row.add("stage", static_cast<double>(number));
  row.add("p_Pa", stage.pressure);
  row.add("alpha", shape.law.alpha());
  row.add("stress_ratio", stage.stress_ratio);
  row.add("friction_coefficient", preparation.friction_coefficient);
  return row;
}

/// Frictionless specimens, each made once and then used by every preparation of its shape, seed and size.
class Packings {
 public:
  dem::Specimen get(const Shape& shape, const triaxial::SpecimenRecipe& recipe) {
    Entry& entry = find({shape.name, recipe.seed, recipe.grains});
    const std::lock_guard lock(entry.mutex);
    if (!entry.state)
      entry.state = triaxial::frictionless_specimen(recipe).state;
    return *entry.state;
  }

 private:
  struct Entry {
    std::mutex mutex;
    std::optional<dem::Specimen> state;
  };
  using Name = std::tuple<std::string, std::uint64_t, std::size_t>;
  Entry& find(const Name& name) {
    const std::lock_guard lock(mutex_);
    return entries_[name];
  }
  std::mutex mutex_;
  std::map<Name, Entry> entries_;
};

void run_specimen(const Shape& shape, const Preparation& preparation, std::uint64_t seed, Packings& packings,
                  Record& record) {
  std::vector<Row> keys;
  std::size_t last_missing = 0;
  for (std::size_t k = 0; k < preparation.path.size(); ++k) {
    keys.push_back(key(shape, preparation, seed, preparation.path[k], k));
    if (preparation.path[k].pressure <= shape.pressure_limit && !record.has(keys.back()))
      last_missing = k + 1;
  }
  if (last_missing == 0)
    return;
  const triaxial::SpecimenRecipe specimen = recipe(shape, preparation, seed);
  triaxial::SpecimenRecipe at_10_kPa = specimen;
  at_10_kPa.first_pressure = 10 * kPa;
  dem::Specimen state =
      triaxial::start_of_compression(packings.get(shape, at_10_kPa), preparation.density, specimen);
  for (int opening = 1; opening < preparation.opening.times; ++opening) {
    triaxial::SpecimenRecipe again = specimen;
    again.seed += 1000 * static_cast<std::uint64_t>(opening);
    state = triaxial::unjam(std::move(state), again);
  }
  // The loosest specimens creep for long. A stage that runs out of steps is frozen as it stands: its stress
  // is measured on the contacts.
  const dem::QuasistaticOptions usual = triaxial::compression_options();
  dem::QuasistaticOptions options = usual;
  options.max_steps = preparation.max_steps;
  for (std::size_t k = 0; k < last_missing; ++k) {
    const auto [p, eta] = preparation.path[k];
    const double stress_h = p * (1 - eta / 3), stress_v = p * (1 + 2 * eta / 3);
    options.inertial_number = (k == 0 ? preparation.approach : 1) * usual.inertial_number;
    dem::Engine engine(std::move(state), specimen.material);
    const dem::QuasistaticReport report = dem::equilibrate(engine, {stress_h, stress_h, stress_v}, options);
    if (report.outcome == dem::Outcome::unstable)
      throw std::runtime_error("stage " + std::to_string(k) + " became unstable");
    engine.rest();
    state = engine.state();
    if (record.has(keys[k]))
      continue;
    const triaxial::FrozenState frozen = triaxial::freeze_in_place(state, specimen.material);
    if (!frozen.at_rest()) {
      std::fprintf(stderr, "%s: not at rest, unbalanced force ratio %.2g\n",
                   Record::key_of(keys[k].cells).c_str(), frozen.report.unbalanced_force_ratio);
      continue;
    }
    Row row = keys[k];
    describe(row, frozen.state(), specimen.material);
    record.append(row);
    std::fprintf(stderr, "%s\n", Record::key_of(row.cells).c_str());
  }
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    std::fprintf(stderr, "usage: %s states.csv [threads [first letters of the preparations]]\n", argv[0]);
    return 2;
  }
  const std::string chosen = argc > 3 ? argv[3] : "";
  const std::size_t threads = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  constexpr std::uint64_t seeds_per_shape = 3;
  struct Task {
    const Shape* shape;
    const Preparation* preparation;
    std::uint64_t seed;
  };
  // Every shape and preparation once before any of them with a second seed. No two shapes share a seed.
  std::vector<Task> tasks;
  for (std::uint64_t round = 0; round < seeds_per_shape; ++round)
    for (const Preparation& preparation : preparations())
      if (std::string(preparation.name).starts_with(chosen))
        for (std::size_t k = 0; k < shapes().size(); ++k)
          if (shapes()[k].fitted || preparation.unfitted_shapes)
            tasks.push_back({&shapes()[k], &preparation, 100 * (k + 1) + round});
  Record record(argv[1]);
  Packings packings;
  std::atomic<std::size_t> next = 0;
  const auto worker = [&] {
    for (std::size_t k = next++; k < tasks.size(); k = next++) {
      const Task& task = tasks[k];
      try {
        run_specimen(*task.shape, *task.preparation, task.seed, packings, record);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s %s #%zu: %s\n", task.shape->name, task.preparation->name,
                     static_cast<std::size_t>(task.seed), error.what());
      }
    }
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < threads; ++t)
    others.emplace_back(worker);
  worker();
  for (std::thread& other : others)
    other.join();
}
