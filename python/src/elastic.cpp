// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/waves.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "estimate.hpp"
#include "members.hpp"
#include "rows.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

using elastic::Isotropic;
using elastic::PlaneWaves;
using elastic::TransverselyIsotropic;
using elastic::VoigtStiffness;

/// Five constants as an object of Python.
py::object constants(const TransverselyIsotropic& c) {
  return estimate_object({.stiffness = c, .validity = {}});
}

/// What is refused of a stiffness.
std::string refused_stiffness(const std::string& more) {
  return "For another shape, or a stiffness that is " + more;
}

// ---- symmetry

void bind_symmetry(py::module_& module) {
  using elastic::EngineeringModuli;
  ResultClass<EngineeringModuli>(module, "EngineeringModuli", "Moduli along the axes and in their planes.")
      .show("bulk_modulus", "K [Pa].", &EngineeringModuli::bulk_modulus)
      .show("E_1", "[Pa]", &EngineeringModuli::E_1)
      .show("E_2", "[Pa]", &EngineeringModuli::E_2)
      .show("E_3", "[Pa]", &EngineeringModuli::E_3)
      .show("C44", "[Pa]", &EngineeringModuli::C44)
      .show("C55", "[Pa]", &EngineeringModuli::C55)
      .show("C66", "[Pa]", &EngineeringModuli::C66);
  using elastic::SymmetryDistances;
  ResultClass<SymmetryDistances>(module, "SymmetryDistances",
                                 "Distances of a stiffness from classes of symmetry.")
      .show("isotropic", "[1]", &SymmetryDistances::isotropic)
      .show("cubic", "[1]", &SymmetryDistances::cubic)
      .show("transversely_isotropic", "[1]", &SymmetryDistances::transversely_isotropic)
      .show("orthotropic", "[1]", &SymmetryDistances::orthotropic);
  define(
      module, "engineering_moduli", {stiffness_keyword()},
      {"Moduli of a stiffness along the axes and in their planes.",
       "EngineeringModuli\n    E is 0 along an axis with a zero-energy deformation.",
       refused_stiffness("not symmetric and finite."), "", "elastic::engineering_moduli",
       "elastic/isotropic.hpp"},
      [](const VoigtStiffness& c) { return elastic::engineering_moduli(c); }, 1);
  define(
      module, "symmetry_distances", {stiffness_keyword()},
      {"Distances of a stiffness from classes of symmetry.",
       "SymmetryDistances\n    Distances relative to the norm of the stiffness [1].",
       refused_stiffness("zero or not symmetric and finite."), "[Moakher2006]", "elastic::symmetry_distances",
       "elastic/stiffness.hpp"},
      [](const VoigtStiffness& c) { return elastic::symmetry_distances(c); }, 1);
  define(
      module, "rotate",
      {stiffness_keyword(),
       required("rotation", "(3, 3) array_like", "An orthogonal matrix of determinant 1 [1].")},
      {"The stiffness of a rotated material, in unchanged axes.", "(6, 6) ndarray\n    Voigt matrix [Pa].",
       refused_stiffness("not symmetric, or a matrix that is no rotation."), "[Mehrabadi1990]",
       "elastic::rotate", "elastic/stiffness.hpp"},
      [](const VoigtStiffness& c, const Mat3& rotation) {
        return array_of(elastic::rotate(c, rotation).matrix);
      },
      1);
}

// ---- projections and averages

void bind_isotropic(py::module_& module) {
  ResultClass<Isotropic> type(module, "Isotropic", "An isotropic elastic solid.");
  type.show("bulk_modulus", "K [Pa].", &Isotropic::bulk_modulus)
      .show("shear_modulus", "G [Pa].", &Isotropic::shear_modulus)
      .show("young_modulus", "E [Pa].", &Isotropic::young_modulus)
      .show("poisson_ratio", "nu [1].", &Isotropic::poisson_ratio)
      .show("lame_lambda", "lambda [Pa].", &Isotropic::lame_lambda)
      .show("stiffness", "6 x 6 Voigt matrix [Pa].",
            [](const Isotropic& solid) { return elastic::voigt(solid).matrix; })
      .def("__repr__", [](const Isotropic& solid) {
        return py::str("Isotropic(bulk_modulus={!r}, shear_modulus={!r})")
            .format(solid.bulk_modulus(), solid.shear_modulus());
      });
  define_method(type, "wave_speeds", {required("bulk_density", "float", "Mass per volume, > 0 [kg/m3].")},
                {"Speeds of plane waves p and s [m/s].", "dict of float"},
                [](const Isotropic& solid, double density) {
                  const elastic::WaveSpeeds speeds = elastic::wave_speeds(solid, density);
                  return py::dict(py::arg("p") = speeds.p, py::arg("s") = speeds.s);
                });
  define(module, "isotropic",
         {required("bulk_modulus", "float", "K > 0 [Pa]; inf: incompressible."),
          required("shear_modulus", "float", "G > 0 [Pa].")},
         {"The isotropic solid with these two moduli.", "Isotropic",
          "Unless both are positive, and the shear modulus finite.", "",
          "elastic::Isotropic::from_bulk_and_shear", "elastic/isotropic.hpp"},
         [](double bulk, double shear) { return Isotropic::from_bulk_and_shear(bulk, shear); });
}

void bind_projections(py::module_& module) {
  define(
      module, "isotropic_projection", {stiffness_keyword()},
      {"The isotropic solid nearest to a stiffness.", "Isotropic",
       refused_stiffness("not symmetric, or a resulting modulus that is not positive."),
       "Nearest in the norm that no rotation changes. [Moakher2006]", "elastic::isotropic_projection",
       "elastic/isotropic.hpp"},
      [](const VoigtStiffness& c) { return elastic::isotropic_projection(c); }, 1);
  define(
      module, "transversely_isotropic_projection",
      {stiffness_keyword(),
       optional("axis", "(3,) array_like", "Axis of symmetry, of any length [1]; default: axis 3.")},
      {"The transversely isotropic stiffness nearest to a stiffness.",
       "Estimate\n    In axes with the axis of symmetry as the third.",
       refused_stiffness("not symmetric, or an axis of zero length."),
       "Nearest in the norm that no rotation changes. [Moakher2006]",
       "elastic::transversely_isotropic_projection", "elastic/isotropic.hpp"},
      [](const VoigtStiffness& c, const std::optional<Vec3>& axis) {
        return constants(axis ? elastic::transversely_isotropic_projection(c, *axis)
                              : elastic::transversely_isotropic_projection(c));
      },
      1);
  using elastic::IsotropicAverages;
  ResultClass<IsotropicAverages>(module, "IsotropicAverages", "Averages over all orientations.")
      .show("voigt", "Equal strain: an upper bound.", &IsotropicAverages::voigt)
      .show("hill", "Mean of both.", &IsotropicAverages::hill)
      .show("reuss", "Equal stress: a lower bound.", &IsotropicAverages::reuss);
  define(
      module, "isotropic_averages", {stiffness_keyword()},
      {"Voigt's, Hill's and Reuss' averages of a stiffness over all orientations.", "IsotropicAverages",
       refused_stiffness("not symmetric and positive definite."), "[Hill1952]", "elastic::isotropic_averages",
       "elastic/isotropic.hpp"},
      [](const VoigtStiffness& c) { return elastic::isotropic_averages(c); }, 1);
}

// ---- waves

struct Waves {
  std::vector<py::ssize_t> shape; ///< of the directions without their last axis
  std::vector<PlaneWaves> waves;
};

constexpr elastic::PlaneWave PlaneWaves::*by_speed[] = {&PlaneWaves::fastest, &PlaneWaves::middle,
                                                        &PlaneWaves::slowest};

py::array speeds(const Waves& w) {
  std::vector<py::ssize_t> shape = w.shape;
  shape.push_back(3);
  py::array_t<double> out(shape);
  double* to = out.mutable_data();
  for (std::size_t k = 0; k < w.waves.size(); ++k) {
    hear_signals(k);
    for (const auto wave : by_speed)
      *to++ = (w.waves[k].*wave).speed;
  }
  return out;
}

py::array polarisations(const Waves& w) {
  std::vector<py::ssize_t> shape = w.shape;
  shape.insert(shape.end(), {3, 3});
  py::array_t<double> out(shape);
  double* to = out.mutable_data();
  for (std::size_t k = 0; k < w.waves.size(); ++k) {
    hear_signals(k);
    for (const auto wave : by_speed)
      for (int axis = 0; axis < 3; ++axis)
        *to++ = (w.waves[k].*wave).polarisation[axis];
  }
  return out;
}

Waves plane_waves(const VoigtStiffness& matrix, double bulk_density, const py::object& direction) {
  const py::array_t<double, py::array::c_style | py::array::forcecast> directions =
      numbers_of("direction", direction);
  if (directions.ndim() < 1 || directions.shape(directions.ndim() - 1) != 3)
    throw InvalidArgument("direction has the shape " + shape_text(directions) + ", not (..., 3)");
  Waves out{{directions.shape(), directions.shape() + directions.ndim() - 1}, {}};
  const double* from = directions.data();
  const auto count = static_cast<std::size_t>(directions.size() / 3);
  const Unlocked unlocked;
  for (std::size_t k = 0; k < count; ++k, from += 3) {
    stop_point(k);
    out.waves.push_back(elastic::plane_waves(matrix, bulk_density, {from[0], from[1], from[2]}));
  }
  return out;
}

void bind_waves(py::module_& module) {
  ResultClass<Waves>(module, "PlaneWaves",
                     "Three plane waves along each direction, from the fastest to the slowest.")
      .show("speed", "Phase speeds [m/s], (..., 3).", &speeds)
      .show("polarisation", "Unit vectors of motion, (..., 3, 3).", &polarisations);
  define(module, "plane_waves",
         {stiffness_keyword(), required("bulk_density", "float", "Mass per volume, > 0 [kg/m3]."),
          required("direction", "(..., 3) array_like",
                   "Directions of propagation, vectors of any non-zero length [1].")},
         {"Three plane waves along each direction, by the Christoffel equation.",
          "PlaneWaves\n    Speeds (..., 3) and polarisations (..., 3, 3), from the fastest to the slowest.",
          refused_stiffness("not symmetric and positive semidefinite, a density or direction out of range."),
          "Small amplitudes, wave lengths far above the size of the grains. [Musgrave1970]",
          "elastic::plane_waves", "elastic/waves.hpp"},
         &plane_waves, 1);
  define(module, "bulk_density",
         {of_input(estimate::Input::grain_density, "float"),
          required("void_ratio", "float", "Volume of voids over that of grains, >= 0 [1]."),
          required("pore_density", "float", "Density of the pore fluid, >= 0 [kg/m3].")
              .or_number(elastic::GrainsAndPores{}.pore_density)},
         {"Mass per volume of a packing, (rho_s + e rho_pore)/(1+e).", "float\n    [kg/m3]",
          "For a number out of range.", "", "elastic::bulk_density", "elastic/waves.hpp"},
         [](double grain_density, double void_ratio, double pore_density) {
           return elastic::bulk_density({grain_density, void_ratio, pore_density});
         });
  using elastic::ThomsenParameters;
  ResultClass<ThomsenParameters>(module, "ThomsenParameters", "Transverse isotropy in Thomsen's notation.")
      .show("epsilon", "(C11-C33)/(2 C33) [1].", &ThomsenParameters::epsilon)
      .show("delta", "[1]", &ThomsenParameters::delta)
      .show("gamma", "(C66-C44)/(2 C44) [1].", &ThomsenParameters::gamma);
  define(
      module, "thomsen_parameters",
      {stiffness_keyword(), with_default("weak", "False", "bool", "delta to first order.")},
      {"Thomsen's parameters of a stiffness, made symmetric about axis 3.", "ThomsenParameters",
       "For another shape, or unless the stiffness is symmetric, positive definite and C33 > C44.",
       "[Thomsen1986]", "elastic::thomsen_parameters", "elastic/waves.hpp"},
      [](const VoigtStiffness& c, bool weak) {
        const TransverselyIsotropic ti = elastic::transversely_isotropic_projection(c);
        return weak ? elastic::weak_thomsen_parameters(ti) : elastic::thomsen_parameters(ti);
      },
      1);
}

void bind_saturation(py::module_& module) {
  define(
      module, "saturated",
      {stiffness_keyword(),
       required("grain_bulk_modulus", "float",
                "K_s > 0 of the grains' solid [Pa]; bulk_modulus of a law or a mineral."),
       required("fluid_bulk_modulus", "float", "K_f > 0 of the pore fluid [Pa]."),
       of_input(estimate::Input::void_ratio, "float")},
      {"Undrained stiffness of a packing with saturated pores, by Gassmann.",
       "Estimate\n    Stiffness with saturated pores, symmetrised about axis 3.",
       refused_stiffness("not symmetric, or a number out of range."),
       "One solid, connected pores; shear moduli do not change. [Gassmann1951] [Mavko2009]",
       "elastic::saturated", "elastic/waves.hpp"},
      [](const VoigtStiffness& c, double grain_bulk_modulus, double fluid_bulk_modulus, double void_ratio) {
        return constants(elastic::saturated(elastic::transversely_isotropic_projection(c),
                                            {.grain_bulk_modulus = grain_bulk_modulus,
                                             .fluid_bulk_modulus = fluid_bulk_modulus,
                                             .void_ratio = void_ratio}));
      },
      1);
  define(module, "water_and_air_bulk_modulus",
         {required("saturation", "float", "Degree of saturation S, in [0, 1] [1].")},
         {"Bulk modulus of a fine mixture of water and air, as in moist ground.",
          "float\n    1/(S/K_w + (1 - S)/K_a) [Pa]: 2.18 GPa of water alone, 0.142 MPa of air.",
          "For a saturation outside of [0, 1].", "Menisci between grains are not included. [Mavko2009]",
          "elastic::water_and_air_bulk_modulus", "elastic/waves.hpp"},
         &elastic::water_and_air_bulk_modulus, 1);
}

} // namespace

void bind_elastic(py::module_& module) {
  bind_symmetry(module);
  bind_isotropic(module);
  bind_projections(module);
  bind_waves(module);
  bind_saturation(module);
}

} // namespace granum::python
