// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <numeric>

#include <granum/stress/stress.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/shear_test.hpp>
#include <granum/triaxial/specimen.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "members.hpp"
#include "packing.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

/// A specimen of the simulation and the material of its grains.
struct Specimen {
  dem::Specimen state;
  dem::Material material;

  [[nodiscard]] SharedPacking packing() const {
    Packing out{.assembly = dem::contact_network(state, material), .id = {}, .time = {}, .notes = {}};
    out.id.resize(out.assembly.grain_count());
    std::iota(out.id.begin(), out.id.end(), 0L);
    const bool periodic = !state.walls.has_value();
    out.periodic = {periodic, periodic, periodic};
    return std::make_shared<Packing>(std::move(out));
  }
};

// ---- preparation

constexpr std::pair<const char*, triaxial::Density> densities[] = {{"dense", triaxial::Density::dense},
                                                                   {"loose", triaxial::Density::loose}};

std::vector<Keyword> recipe_keywords() {
  return {required("law", "NormalLaw", "Normal contact of two grains of the radius."),
          required("radius", "float",
                   "R > 0 of all grains, or the mean by number of a distribution of sizes [m]."),
          required("friction_coefficient", "float", "Friction between grains [1]."),
          required("kind", "{\"dense\", \"loose\"}",
                   "dense: without friction up to the first pressure; loose: opened to just below jamming, "
                   "then compressed with friction."),
          optional("grains", "int", ""),
          optional("seed", "int", "Number of grains, and seed of the random sample."),
          optional("first_pressure", "float", "Pressure of the frictionless preparation [Pa]."),
          tangential_ratio_keyword(),
          optional("density", "float", "Density of the grains [kg/m3]."),
          optional("sizes", "Distribution", "Distribution of the radii; default: equal."),
          optional("wall_friction", "float",
                   "Friction coefficient of six rigid walls [1]; without it the cell is periodic.")};
}

/// A number that a keyword replaces if it is given.
void take(const Arguments& a, std::size_t k, double& number) {
  number = a.number_if_given(k).value_or(number);
}

triaxial::SpecimenRecipe recipe_of(const Arguments& a) {
  enum : std::size_t {
    law,
    radius,
    friction,
    grains = 4,
    seed,
    first_pressure,
    ratio,
    density,
    sizes,
    walls
  };
  dem::Material material{.law = a.as<const contact::NormalLaw&>(law),
                         .friction_coefficient = a.number(friction)};
  material.tangential_ratio =
      a.number_if_given(ratio).value_or(contact::mindlin_stiffness_ratio(material.law.grain().poisson_ratio));
  take(a, density, material.density);
  triaxial::SpecimenRecipe recipe{.material = material, .radius = a.number(radius)};
  recipe.grains = taken<std::optional<std::size_t>>(a, grains).value_or(recipe.grains);
  recipe.seed = taken<std::optional<std::uint64_t>>(a, seed).value_or(recipe.seed);
  take(a, first_pressure, recipe.first_pressure);
  recipe.sizes = taken<std::optional<sizes::Distribution>>(a, sizes).value_or(recipe.sizes);
  if (a.given(walls))
    recipe.wall_friction = a.number(walls);
  return recipe;
}

py::object specimen(const Arguments& a) {
  const triaxial::SpecimenRecipe recipe = recipe_of(a);
  const triaxial::Density kind = a.choice(3, densities);
  const StopRequest stop = stop_on_signal();
  Specimen out{.state = {}, .material = recipe.material};
  {
    const py::gil_scoped_release unlocked;
    const triaxial::FrictionlessPacking prepared = triaxial::frictionless_specimen(recipe, stop);
    out.state = triaxial::start_of_compression(prepared.state, kind, recipe, stop);
  }
  throw_if_signalled();
  return py::cast(std::move(out));
}

void bind_specimen(py::module_& module) {
  ResultClass<Specimen>(module, "Specimen", "A specimen of the DEM simulation.")
      .show("packing", "Grains and contacts, with k_n and k_t.", &Specimen::packing)
      .show("void_ratio", "[1]", [](const Specimen& s) { return dem::void_ratio(s.state); })
      .def("__len__", [](const Specimen& s) { return s.state.grain_count(); })
      .def(
          "__eq__", [](const Specimen& a, const Specimen& b) { return a.state == b.state; },
          py::is_operator())
      .def("__repr__", [](const Specimen& s) {
        return "<Specimen of " + std::to_string(s.state.grain_count()) + " grains>";
      });
  define(module, "specimen", recipe_keywords(),
         {"Prepares a specimen of spheres for compression with friction.\n\nThe same arguments give bitwise "
          "identical specimens.",
          "Specimen", "For impossible numbers.",
          "Frictionless spheres are relaxed by energy minimisation. [Bitzek2006] [OHern2003]",
          "triaxial::frictionless_specimen", "triaxial/specimen.hpp",
          "NotConverged\n    If no packing at rest is found.\n"},
         &specimen);
}

// ---- compression

/// One state of a path, at rest.
struct State {
  double pressure = 0; ///< as requested [Pa]
  Specimen specimen;
  dem::QuasistaticReport report;
};

/// A path of isotropic compression, as an iterator over its states.
class Compression {
 public:
  Compression(Specimen start, std::vector<double> pressures)
      : at_(std::move(start)), pressures_(std::move(pressures)) {}

  State next() {
    const OneStep step(running_);
    if (next_ == pressures_.size())
      throw py::stop_iteration();
    dem::QuasistaticOptions options = triaxial::compression_options();
    options.stop_requested = stop_on_signal();
    State out{
        .pressure = pressures_[next_], .specimen = {.state = {}, .material = at_.material}, .report = {}};
    bool came = false;
    {
      const py::gil_scoped_release unlocked;
      triaxial::isotropic_path(at_.state, at_.material, {out.pressure}, options,
                               [&](const triaxial::Snapshot& snapshot) {
                                 out.specimen.state = snapshot.state;
                                 out.report = snapshot.report;
                                 return came = snapshot.report.converged();
                               });
    }
    throw_if_signalled();
    if (!came)
      throw NotConverged("the specimen did not come to rest under " + std::to_string(out.pressure) + " Pa");
    at_ = out.specimen;
    ++next_;
    return out;
  }

 private:
  Specimen at_;
  std::vector<double> pressures_;
  std::size_t next_ = 0;
  bool running_ = false;
};

void bind_compression(py::module_& module) {
  ResultClass<State>(module, "State", "One state of a path of compression, at rest.")
      .show("pressure", "Requested pressure [Pa].", &State::pressure)
      .show("specimen", "The specimen, for further loading.", &State::specimen)
      .show("packing", "Grains and contacts, with k_n and k_t.", &State::specimen, &Specimen::packing)
      .show("stress", "Contact stress [Pa], (3, 3).", &State::report, &dem::QuasistaticReport::stress)
      .show("steps", "Steps of the simulation.", &State::report, &dem::QuasistaticReport::steps)
      .show("unbalanced_force_ratio", "Mean residual force over mean contact force [1].", &State::report,
            &dem::QuasistaticReport::unbalanced_force_ratio);
  iterator_class<Compression>(module, "Compression",
                              "A path of isotropic compression: an iterator of State.");
  define(
      module, "compress",
      {required("specimen", "Specimen", "From specimen(), or the specimen of a state."),
       required("pressures", "(N,) array_like", "Pressures in this order, > 0 [Pa].")},
      {"Compresses a specimen with friction through a list of pressures, state by state.\n\nIf Ctrl-C ends "
       "the path, finished states are kept. Another path may begin at the specimen of any state, "
       "with\nbitwise identical results.",
       "Compression\n    An iterator of State.", "For pressures that are not positive.",
       "The discrete element method, with the whole loading history of the contacts. [CundallStrack1979]",
       "triaxial::isotropic_path", "triaxial/specimen.hpp",
       "NotConverged\n    By the iterator, if a state does not come to rest.\n"},
      [](const Specimen& specimen, const std::vector<double>& pressures) {
        return Compression(specimen, pressures);
      },
      2);
}

// ---- probes

constexpr std::pair<const char*, triaxial::ShearMode> modes[] = {
    {"hh", triaxial::ShearMode::hh}, {"hv", triaxial::ShearMode::hv}, {"vh", triaxial::ShearMode::vh}};

py::object probe(const Arguments& a) {
  const auto& specimen = a.as<const Specimen&>(0);
  const triaxial::ShearMode mode = a.choice(1, modes);
  triaxial::ProbeOptions options;
  if (a.given(2))
    options.amplitude = a.number(2);
  options.sliding = a.flag(3);
  options.stop_requested = stop_on_signal();
  triaxial::ProbeResult result;
  {
    const py::gil_scoped_release unlocked;
    const triaxial::FrozenState frozen = triaxial::freeze_in_place(
        specimen.state, specimen.material, triaxial::usual_force_tolerance, options.stop_requested);
    if (!is_stopped(options.stop_requested))
      result = triaxial::probe(frozen.state(), specimen.material, mode, options);
  }
  throw_if_signalled();
  return py::cast(std::move(result));
}

void bind_probe(py::module_& module) {
  using triaxial::ProbeResult;
  ResultClass<ProbeResult>(module, "ProbeResult", "A small cycle of shear of a specimen at rest.")
      .show("converged", "Whether every part of the cycle came to rest.", &ProbeResult::converged)
      .show("amplitude", "Amplitude of the shear strain [1].", &ProbeResult::amplitude)
      .show("steps", "Steps of the simulation.", &ProbeResult::steps)
      .show("unbalanced_force_ratio", "Largest value after any part of the cycle [1].",
            &ProbeResult::unbalanced_force_ratio)
      .show("shear_modulus", "[Pa]. Raises NotConverged.", &ProbeResult::shear_modulus)
      .show("opening", "Residual stress after the cycle over its amplitude [1]. Raises NotConverged.",
            &ProbeResult::opening);
  define(
      module, "probe",
      {required("specimen", "Specimen", "At rest: the specimen of a state."),
       required(
           "mode", "{\"hh\", \"hv\", \"vh\"}",
           "hh: layers stacked along x move along y; hv: along z; vh: layers stacked along z move along x."),
       optional("amplitude", "float", "Shear strain [1]; without it chosen from the mean overlap."),
       with_default("sliding", "False", "bool",
                    "Whether contacts may slide; else the response of the frozen network.")},
      {"Small-strain shear cycle of a specimen at rest: rung 5.", "ProbeResult",
       "For another mode, or an amplitude that is not positive.",
       "Loads and unloads in small steps, each until the specimen is at rest.", "triaxial::probe",
       "triaxial/probe.hpp"},
      &probe, 1);
}

// ---- shear paths

/// A path in letters of either case.
stress::ShearPath path_of(std::string name) {
  for (char& letter : name)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  for (const stress::ShearPath path : stress::all_shear_paths)
    if (name == stress::name(path))
      return path;
  throw InvalidArgument("path is one of TXC, RTXC, RTXE, TXE, not " + name);
}

/// A running triaxial test, as an iterator over its snapshots.
class Shearing {
 public:
  Shearing(const Specimen& start, const triaxial::ShearOptions& options)
      : material_(start.material), test_(start.state, start.material, options) {}

  /// State of the test at a snapshot.
  struct Point {
    triaxial::PathPoint point;
    Specimen specimen;
  };

  Point next() {
    const OneStep step(running_);
    if (finished_)
      throw py::stop_iteration();
    triaxial::ShearEvent event;
    {
      const py::gil_scoped_release unlocked;
      event = test_.advance();
    }
    throw_if_signalled();
    if (event == triaxial::ShearEvent::stopped) // by Ctrl-C in an earlier step
      throw Stopped();
    if (event == triaxial::ShearEvent::unstable)
      throw NotConverged("the specimen is unstable: a velocity or a stress is no longer finite");
    finished_ = event == triaxial::ShearEvent::finished;
    return {test_.now(), {test_.engine().state(), material_}};
  }
  [[nodiscard]] const triaxial::PathPoint& peak() const { return test_.peak(); }

 private:
  dem::Material material_;
  triaxial::ShearTest test_;
  bool finished_ = false, running_ = false;
};

py::object shear(const Arguments& a) {
  triaxial::ShearOptions options{.path = path_of(a.text(1)), .mean_stress = a.number(2)};
  take(a, 3, options.eta_step);
  take(a, 4, options.strain_step);
  take(a, 5, options.largest_strain);
  take(a, 6, options.inertial_number);
  options.stop_requested = stop_on_signal();
  return py::cast(std::make_unique<Shearing>(a.as<const Specimen&>(0), options));
}

void bind_shear(py::module_& module) {
  using Point = Shearing::Point;
  using triaxial::PathPoint;
  ResultClass<Point>(module, "PathPoint",
                     "State of a triaxial test; strains are logarithmic, from its start.")
      .show("stress_v", "[Pa]", &Point::point, &PathPoint::stress, &stress::AxialStress::v)
      .show("stress_h", "[Pa]", &Point::point, &PathPoint::stress, &stress::AxialStress::h)
      .show("mean_stress", "p' [Pa].", &Point::point, &PathPoint::stress, &stress::AxialStress::mean)
      .show("eta", "q/p' [1].", &Point::point, &PathPoint::stress, &stress::AxialStress::ratio)
      .show("axial_strain", "[1]", &Point::point, &PathPoint::axial_strain)
      .show("volumetric_strain", "[1]", &Point::point, &PathPoint::volumetric_strain)
      .show("step", "Step of the simulation.", &Point::point, &PathPoint::step)
      .show("specimen", "The specimen in motion, to probe or to shear further.", &Point::specimen)
      .show("packing", "Grains and contacts in motion; k_n and k_t follow from the law.", &Point::specimen,
            &Specimen::packing);
  iterator_class<Shearing>(module, "Shearing", "A running triaxial test: an iterator of PathPoint.");
  define(module, "shear",
         {required("specimen", "Specimen", "At rest under mean_stress: the specimen of a state."),
          required("path", "{\"TXC\", \"RTXC\", \"RTXE\", \"TXE\"}",
                   "Which stress changes, and in which direction."),
          required("mean_stress", "float", "Isotropic stress at the start [Pa]."),
          optional("eta_step", "float", ""),
          optional("strain_step", "float",
                   "A snapshot is taken whenever a multiple of this stress ratio [1] or of this axial strain "
                   "[1] is first passed."),
          optional("largest_strain", "float", "Axial strain at which the test ends [1]."),
          optional("inertial_number", "float", "Inertial number of shearing [1].")},
         {"Shears a specimen along a triaxial stress path, snapshot by snapshot.",
          "Shearing\n    An iterator of PathPoint.", "For another path, or numbers out of range.",
          "The stress paths of the paper. [Chung2014]", "triaxial::ShearTest", "triaxial/shear_test.hpp",
          "NotConverged\n    By the iterator, if the simulation becomes unstable.\n"},
         &shear, 1);
}

} // namespace

void bind_triaxial(py::module_& module) {
  bind_specimen(module);
  bind_compression(module);
  bind_probe(module);
  bind_shear(module);
}

} // namespace granum::python
