// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <numeric>

#include <granum/stress/shear_path.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/shear_test.hpp>
#include <granum/triaxial/specimen.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "docstrings.hpp"
#include "errors.hpp"
#include "keywords.hpp"
#include "packing.hpp"

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

/// Indices of the keywords of specimen().
namespace recipe_keyword {
enum : std::size_t {
  law,
  radius,
  friction,
  kind,
  grains,
  seed,
  first_pressure,
  tangential_ratio,
  density,
  sizes,
  wall_friction,
};
} // namespace recipe_keyword

triaxial::Density density_of(const std::string& name) {
  if (name == "dense")
    return triaxial::Density::dense;
  if (name == "loose")
    return triaxial::Density::loose;
  throw InvalidArgument("kind is dense or loose, not " + name);
}

triaxial::SpecimenRecipe recipe_of(const Arguments& a) {
  const auto& law = a.as<const contact::NormalLaw&>(recipe_keyword::law, "a contact law");
  dem::Material material{
      .law = law, .friction_coefficient = number_of("friction_coefficient", a[recipe_keyword::friction])};
  material.tangential_ratio = a.given(recipe_keyword::tangential_ratio)
                                  ? number_of("tangential_ratio", a[recipe_keyword::tangential_ratio])
                                  : contact::mindlin_stiffness_ratio(law.grain().poisson_ratio);
  if (a.given(recipe_keyword::density))
    material.density = number_of("density", a[recipe_keyword::density]);
  triaxial::SpecimenRecipe recipe{.material = material,
                                  .radius = number_of("radius", a[recipe_keyword::radius])};
  if (a.given(recipe_keyword::grains))
    recipe.grains = a.as<std::size_t>(recipe_keyword::grains, "a whole number, 0 or more");
  if (a.given(recipe_keyword::seed))
    recipe.seed = a.as<std::uint64_t>(recipe_keyword::seed, "a whole number, 0 or more");
  if (a.given(recipe_keyword::first_pressure))
    recipe.first_pressure = number_of("first_pressure", a[recipe_keyword::first_pressure]);
  if (a.given(recipe_keyword::sizes))
    recipe.sizes = a.as<sizes::Distribution>(recipe_keyword::sizes, "a Distribution");
  if (a.given(recipe_keyword::wall_friction))
    recipe.wall_friction = number_of("wall_friction", a[recipe_keyword::wall_friction]);
  return recipe;
}

py::object specimen(const Arguments& a) {
  const triaxial::SpecimenRecipe recipe = recipe_of(a);
  const triaxial::Density kind = density_of(a.text(recipe_keyword::kind));
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
  py::class_<State>(module, "State", "One state of a path of compression, at rest.")
      .def_readonly("pressure", &State::pressure, "Requested pressure [Pa].")
      .def_readonly("specimen", &State::specimen, "The specimen, for further loading.")
      .def_property_readonly(
          "packing", [](const State& s) { return s.specimen.packing(); },
          "Grains and contacts, with k_n and k_t.")
      .def_property_readonly(
          "stress", [](const State& s) { return array_of(s.report.stress()); },
          "Contact stress [Pa], (3, 3).")
      .def_property_readonly(
          "steps", [](const State& s) { return s.report.steps; }, "Steps of the simulation.")
      .def_property_readonly(
          "unbalanced_force_ratio", [](const State& s) { return s.report.unbalanced_force_ratio; },
          "Mean residual force over mean contact force [1].");
  py::class_<Compression>(module, "Compression", "A path of isotropic compression: an iterator of State.")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &Compression::next);
  define(module,
         {"compress",
          {{"specimen"}, {"pressures"}},
          [](const Arguments& a) {
            return py::cast(Compression(a.as<const Specimen&>(0, "a Specimen"), list_of("pressures", a[1])));
          },
          std::string() +
              R"(Compresses a specimen with friction through a list of pressures, state by state.

If Ctrl-C ends the path, finished states are kept. Another path may begin at the specimen of any state, with
bitwise identical results.

Parameters
----------
specimen : Specimen
    From specimen(), or the specimen of a state.
pressures : (N,) array_like
    Pressures in this order, > 0 [Pa].

Returns
-------
Compression
    An iterator of State.

Raises
------
InvalidArgument
    For pressures that are not positive.
NotConverged
    By the iterator, if a state does not come to rest.
)" +
              notes("The discrete element method, with the whole loading history of the contacts. "
                    "[CundallStrack1979]",
                    "triaxial::isotropic_path", "triaxial/specimen.hpp"),
          2});
}

// ---- probes

triaxial::ShearMode mode_of(const std::string& name) {
  using triaxial::ShearMode;
  static constexpr std::pair<const char*, ShearMode> all[] = {
      {"hh", ShearMode::hh}, {"hv", ShearMode::hv}, {"vh", ShearMode::vh}};
  for (const auto& [known, mode] : all)
    if (name == known)
      return mode;
  throw InvalidArgument("mode is hh, hv or vh, not " + name);
}

py::object probe(const Arguments& a) {
  const Specimen& specimen = a.as<const Specimen&>(0, "a Specimen");
  const triaxial::ShearMode mode = mode_of(a.text(1));
  triaxial::ProbeOptions options;
  if (a.given(2))
    options.amplitude = number_of("amplitude", a[2]);
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
  py::class_<ProbeResult>(module, "ProbeResult", "A small cycle of shear of a specimen at rest.")
      .def_readonly("converged", &ProbeResult::converged, "Whether every part of the cycle came to rest.")
      .def_readonly("amplitude", &ProbeResult::amplitude, "Amplitude of the shear strain [1].")
      .def_readonly("steps", &ProbeResult::steps, "Steps of the simulation.")
      .def_readonly("unbalanced_force_ratio", &ProbeResult::unbalanced_force_ratio,
                    "Largest value after any part of the cycle [1].")
      .def_property_readonly("shear_modulus", &ProbeResult::shear_modulus, "[Pa]. Raises NotConverged.")
      .def_property_readonly("opening", &ProbeResult::opening,
                             "Residual stress after the cycle over its amplitude [1]. Raises NotConverged.");
  define(module, {"probe",
                  {{"specimen"}, {"mode"}, {"amplitude", "None"}, {"sliding", "False"}},
                  &probe,
                  std::string() + R"(Small-strain shear cycle of a specimen at rest: rung 5.

Parameters
----------
specimen : Specimen
    At rest: the specimen of a state.
mode : {"hh", "hv", "vh"}
    hh: layers stacked along x move along y; hv: along z; vh: layers stacked along z move along x.
amplitude : float, optional
    Shear strain [1]; without it chosen from the mean overlap.
sliding : bool
    Whether contacts may slide; else the response of the frozen network.

Returns
-------
ProbeResult

Raises
------
InvalidArgument
    For another mode, or an amplitude that is not positive.
)" +
                      notes("Loads and unloads in small steps, each until the specimen is at rest.",
                            "triaxial::probe", "triaxial/probe.hpp"),
                  1});
}

// ---- shear paths

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

/// Places of the keywords of shear().
namespace shear_keyword {
enum : std::size_t { path = 1, mean_stress, eta_step, strain_step, largest_strain, inertial };
} // namespace shear_keyword

py::object shear(const Arguments& a) {
  triaxial::ShearOptions options{.path = path_of(a.text(shear_keyword::path)),
                                 .mean_stress = number_of("mean_stress", a[shear_keyword::mean_stress])};
  const std::pair<std::size_t, double*> numbers[] = {{shear_keyword::eta_step, &options.eta_step},
                                                     {shear_keyword::strain_step, &options.strain_step},
                                                     {shear_keyword::largest_strain, &options.largest_strain},
                                                     {shear_keyword::inertial, &options.inertial_number}};
  constexpr const char* names[] = {"eta_step", "strain_step", "largest_strain", "inertial_number"};
  for (std::size_t k = 0; k < std::size(numbers); ++k)
    if (a.given(numbers[k].first))
      *numbers[k].second = number_of(names[k], a[numbers[k].first]);
  options.stop_requested = stop_on_signal();
  return py::cast(std::make_unique<Shearing>(a.as<const Specimen&>(0, "a Specimen"), options));
}

void bind_shear(py::module_& module) {
  using Point = Shearing::Point;
  py::class_<Point>(module, "PathPoint", "State of a triaxial test; strains are logarithmic, from its start.")
      .def_property_readonly(
          "stress_v", [](const Point& p) { return p.point.stress.v; }, "[Pa]")
      .def_property_readonly(
          "stress_h", [](const Point& p) { return p.point.stress.h; }, "[Pa]")
      .def_property_readonly(
          "mean_stress", [](const Point& p) { return p.point.stress.mean(); }, "p' [Pa].")
      .def_property_readonly(
          "eta", [](const Point& p) { return p.point.stress.ratio(); }, "q/p' [1].")
      .def_property_readonly(
          "axial_strain", [](const Point& p) { return p.point.axial_strain; }, "[1]")
      .def_property_readonly(
          "volumetric_strain", [](const Point& p) { return p.point.volumetric_strain; }, "[1]")
      .def_property_readonly(
          "step", [](const Point& p) { return p.point.step; }, "Step of the simulation.")
      .def_readonly("specimen", &Point::specimen, "The specimen in motion, to probe or to shear further.")
      .def_property_readonly(
          "packing", [](const Point& p) { return p.specimen.packing(); },
          "Grains and contacts in motion; k_n and k_t follow from the law.");
  py::class_<Shearing>(module, "Shearing", "A running triaxial test: an iterator of PathPoint.")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &Shearing::next);
  define(module, {"shear",
                  {{"specimen"},
                   {"path"},
                   {"mean_stress"},
                   {"eta_step", "None"},
                   {"strain_step", "None"},
                   {"largest_strain", "None"},
                   {"inertial_number", "None"}},
                  &shear,
                  std::string() + R"(Shears a specimen along a triaxial stress path, snapshot by snapshot.

Parameters
----------
specimen : Specimen
    At rest under mean_stress: the specimen of a state.
path : {"TXC", "RTXC", "RTXE", "TXE"}
    Which stress changes, and in which direction.
mean_stress : float
    Isotropic stress at the start [Pa].
eta_step, strain_step : float, optional
    A snapshot is taken whenever a multiple of this stress ratio [1] or of this axial strain [1] is first
    passed.
largest_strain : float, optional
    Axial strain at which the test ends [1].
inertial_number : float, optional
    Inertial number of shearing [1].

Returns
-------
Shearing
    An iterator of PathPoint.

Raises
------
InvalidArgument
    For another path, or numbers out of range.
NotConverged
    By the iterator, if the simulation becomes unstable.
)" + notes("The stress paths of the paper. [Chung2014]", "triaxial::ShearTest", "triaxial/shear_test.hpp"),
                  1});
}

} // namespace

void bind_triaxial(py::module_& module) {
  py::class_<Specimen>(module, "Specimen", "A specimen of the DEM simulation.")
      .def_property_readonly("packing", &Specimen::packing, "Grains and contacts, with k_n and k_t.")
      .def_property_readonly(
          "void_ratio", [](const Specimen& s) { return dem::void_ratio(s.state); }, "[1]")
      .def("__len__", [](const Specimen& s) { return s.state.grain_count(); })
      .def(
          "__eq__", [](const Specimen& a, const Specimen& b) { return a.state == b.state; },
          py::is_operator())
      .def("__repr__", [](const Specimen& s) {
        return "<Specimen of " + std::to_string(s.state.grain_count()) + " grains>";
      });
  define(module,
         {"specimen",
          {{"law"},
           {"radius"},
           {"friction_coefficient"},
           {"kind"},
           {"grains", "None"},
           {"seed", "None"},
           {"first_pressure", "None"},
           {"tangential_ratio", "None"},
           {"density", "None"},
           {"sizes", "None"},
           {"wall_friction", "None"}},
          &specimen,
          std::string() + R"(Prepares a specimen of spheres for compression with friction.

The same arguments give bitwise identical specimens.

Parameters
----------
law : NormalLaw
    Normal contact of two grains of the radius.
radius : float
    R > 0 of all grains, or the mean by number of a distribution of sizes [m].
friction_coefficient : float
    Friction between grains [1].
kind : {"dense", "loose"}
    dense: without friction up to the first pressure; loose: opened to just below jamming, then compressed
    with friction.
grains, seed : int, optional
    Number of grains, and seed of the random sample.
first_pressure : float, optional
    Pressure of the frictionless preparation [Pa].
tangential_ratio : float, optional
    k_t/k_n [1]; without it mindlin_stiffness_ratio of the law's material.
density : float, optional
    Density of the grains [kg/m3].
sizes : Distribution, optional
    Distribution of the radii; default: equal.
wall_friction : float, optional
    Friction coefficient of six rigid walls [1]; without it the cell is periodic.

Returns
-------
Specimen

Raises
------
InvalidArgument
    For impossible numbers.
NotConverged
    If no packing at rest is found.
)" +
              notes("Frictionless spheres are relaxed by energy minimisation. [Bitzek2006] [OHern2003]",
                    "triaxial::frictionless_specimen", "triaxial/specimen.hpp")});
  bind_compression(module);
  bind_probe(module);
  bind_shear(module);
}

} // namespace granum::python
