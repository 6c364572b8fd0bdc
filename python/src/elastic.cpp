// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <granum/elastic/averages.hpp>
#include <granum/elastic/christoffel.hpp>
#include <granum/elastic/engineering_moduli.hpp>
#include <granum/elastic/mandel.hpp>
#include <granum/elastic/projection.hpp>
#include <granum/elastic/saturation.hpp>
#include <granum/elastic/symmetry.hpp>
#include <granum/elastic/thomsen.hpp>
#include <granum/elastic/wave_speeds.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "errors.hpp"
#include "estimate.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using elastic::Isotropic;
using elastic::PlaneWaves;
using elastic::TransverselyIsotropic;

elastic::VoigtStiffness stiffness(const py::object& value) { return stiffness_of("stiffness", value); }

/// Five constants as an object of Python.
py::object constants(const TransverselyIsotropic& c) {
  return estimate_object({.stiffness = c, .validity = {}});
}

// ---- symmetry

void bind_symmetry(py::module_& module) {
  using elastic::EngineeringModuli;
  py::class_<EngineeringModuli>(module, "EngineeringModuli", "Moduli along the axes and in their planes.")
      .def_readonly("bulk_modulus", &EngineeringModuli::bulk_modulus, "K [Pa].")
      .def_readonly("E_1", &EngineeringModuli::E_1, "[Pa]")
      .def_readonly("E_2", &EngineeringModuli::E_2, "[Pa]")
      .def_readonly("E_3", &EngineeringModuli::E_3, "[Pa]")
      .def_readonly("C44", &EngineeringModuli::C44, "[Pa]")
      .def_readonly("C55", &EngineeringModuli::C55, "[Pa]")
      .def_readonly("C66", &EngineeringModuli::C66, "[Pa]");
  using elastic::SymmetryDistances;
  py::class_<SymmetryDistances>(module, "SymmetryDistances",
                                "Distances of a stiffness from classes of symmetry.")
      .def_readonly("isotropic", &SymmetryDistances::isotropic, "[1]")
      .def_readonly("cubic", &SymmetryDistances::cubic, "[1]")
      .def_readonly("transversely_isotropic", &SymmetryDistances::transversely_isotropic, "[1]")
      .def_readonly("orthotropic", &SymmetryDistances::orthotropic, "[1]");
  module.def(
      "engineering_moduli", [](const py::object& c) { return elastic::engineering_moduli(stiffness(c)); },
      py::arg("stiffness"),
      (std::string("Moduli of a stiffness along the axes and in their planes.\n") + stiffness_parameter + R"(
Returns
-------
EngineeringModuli
    E is 0 along an axis with a zero-energy deformation.
)" + raises_invalid("For another shape, or a stiffness that is not symmetric and finite.") +
       notes("", "elastic::engineering_moduli", "elastic/engineering_moduli.hpp"))
          .c_str());
  module.def(
      "symmetry_distances", [](const py::object& c) { return elastic::symmetry_distances(stiffness(c)); },
      py::arg("stiffness"),
      (std::string("Distances of a stiffness from classes of symmetry.\n") + stiffness_parameter + R"(
Returns
-------
SymmetryDistances
    Distances relative to the norm of the stiffness [1].
)" + raises_invalid("For another shape, or a stiffness that is zero or not symmetric and finite.") +
       notes("[Moakher2006]", "elastic::symmetry_distances", "elastic/symmetry.hpp"))
          .c_str());
  module.def(
      "rotate",
      [](const py::object& c, const py::object& rotation) {
        return array_of(elastic::rotate(stiffness(c), matrix_of("rotation", rotation)).matrix);
      },
      py::arg("stiffness"), py::kw_only(), py::arg("rotation"),
      (std::string("The stiffness of a rotated material, in unchanged axes.\n") + stiffness_parameter +
       R"(rotation : (3, 3) array_like
    An orthogonal matrix of determinant 1 [1].

Returns
-------
(6, 6) ndarray
    Voigt matrix [Pa].
)" + raises_invalid("For other shapes, a stiffness that is not symmetric, or a matrix that is no rotation.") +
       notes("[Mehrabadi1990]", "elastic::rotate", "elastic/mandel.hpp"))
          .c_str());
}

// ---- projections and averages

void bind_projections(py::module_& module) {
  py::class_<Isotropic>(module, "Isotropic", "An isotropic elastic solid.")
      .def_property_readonly("bulk_modulus", &Isotropic::bulk_modulus, "K [Pa].")
      .def_property_readonly("shear_modulus", &Isotropic::shear_modulus, "G [Pa].")
      .def_property_readonly("young_modulus", &Isotropic::young_modulus, "E [Pa].")
      .def_property_readonly("poisson_ratio", &Isotropic::poisson_ratio, "nu [1].")
      .def_property_readonly("lame_lambda", &Isotropic::lame_lambda, "lambda [Pa].")
      .def_property_readonly(
          "stiffness", [](const Isotropic& solid) { return array_of(elastic::voigt(solid).matrix); },
          "6 x 6 Voigt matrix [Pa].")
      .def(
          "wave_speeds",
          [](const Isotropic& solid, double density) {
            const elastic::WaveSpeeds speeds = elastic::wave_speeds(solid, density);
            return py::dict(py::arg("p") = speeds.p, py::arg("s") = speeds.s);
          },
          py::kw_only(), py::arg("bulk_density"), "Speeds of plane waves p and s [m/s].")
      .def("__repr__", [](const Isotropic& solid) {
        return py::str("Isotropic(bulk_modulus={!r}, shear_modulus={!r})")
            .format(solid.bulk_modulus(), solid.shear_modulus());
      });
  module.def(
      "isotropic", [](double bulk, double shear) { return Isotropic::from_bulk_and_shear(bulk, shear); },
      py::kw_only(), py::arg("bulk_modulus"), py::arg("shear_modulus"),
      (R"(The isotropic solid with these two moduli.

Parameters
----------
bulk_modulus : float
    K > 0 [Pa]; inf: incompressible.
shear_modulus : float
    G > 0 [Pa].

Returns
-------
Isotropic
)" + raises_invalid("Unless both are positive, and the shear modulus finite.") +
       notes("", "elastic::Isotropic::from_bulk_and_shear", "elastic/isotropic.hpp"))
          .c_str());
  module.def(
      "isotropic_projection", [](const py::object& c) { return elastic::isotropic_projection(stiffness(c)); },
      py::arg("stiffness"),
      (std::string("The isotropic solid nearest to a stiffness.\n") + stiffness_parameter + R"(
Returns
-------
Isotropic
)" +
       raises_invalid("For another shape, a stiffness that is not symmetric, or a resulting modulus that is "
                      "not positive.") +
       notes("Nearest in the norm that no rotation changes. [Moakher2006]", "elastic::isotropic_projection",
             "elastic/projection.hpp"))
          .c_str());
  module.def(
      "transversely_isotropic_projection",
      [](const py::object& c, const py::object& axis) {
        if (axis.is_none())
          return constants(elastic::transversely_isotropic_projection(stiffness(c)));
        return constants(elastic::transversely_isotropic_projection(stiffness(c), vector_of("axis", axis)));
      },
      py::arg("stiffness"), py::kw_only(), py::arg("axis") = py::none(),
      (std::string("The transversely isotropic stiffness nearest to a stiffness.\n") + stiffness_parameter +
       R"(axis : (3,) array_like, optional
    Axis of symmetry, of any length [1]; default: axis 3.

Returns
-------
Estimate
    In axes with the axis of symmetry as the third.
)" + raises_invalid("For other shapes, a stiffness that is not symmetric, or an axis of zero length.") +
       notes("Nearest in the norm that no rotation changes. [Moakher2006]",
             "elastic::transversely_isotropic_projection", "elastic/projection.hpp"))
          .c_str());
  using elastic::IsotropicAverages;
  py::class_<IsotropicAverages>(module, "IsotropicAverages", "Averages over all orientations.")
      .def_readonly("voigt", &IsotropicAverages::voigt, "Equal strain: an upper bound.")
      .def_readonly("hill", &IsotropicAverages::hill, "Mean of both.")
      .def_readonly("reuss", &IsotropicAverages::reuss, "Equal stress: a lower bound.");
  module.def(
      "isotropic_averages", [](const py::object& c) { return elastic::isotropic_averages(stiffness(c)); },
      py::arg("stiffness"),
      (std::string("Voigt's, Hill's and Reuss' averages of a stiffness over all orientations.\n") +
       stiffness_parameter + R"(
Returns
-------
IsotropicAverages
)" + raises_invalid("For another shape, or unless the stiffness is symmetric and positive definite.") +
       notes("[Hill1952]", "elastic::isotropic_averages", "elastic/averages.hpp"))
          .c_str());
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

Waves plane_waves(const py::object& c, double bulk_density, const py::object& direction) {
  const py::array_t<double, py::array::c_style | py::array::forcecast> directions =
      numbers_of("direction", direction);
  if (directions.ndim() < 1 || directions.shape(directions.ndim() - 1) != 3)
    throw InvalidArgument("direction has the shape " + shape_text(directions) + ", not (..., 3)");
  const elastic::VoigtStiffness matrix = stiffness(c);
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
  py::class_<Waves>(module, "PlaneWaves",
                    "Three plane waves along each direction, from the fastest to the slowest.")
      .def_property_readonly("speed", &speeds, "Phase speeds [m/s], (..., 3).")
      .def_property_readonly("polarisation", &polarisations, "Unit vectors of motion, (..., 3, 3).");
  module.def(
      "plane_waves", &plane_waves, py::arg("stiffness"), py::kw_only(), py::arg("bulk_density"),
      py::arg("direction"),
      (std::string("Three plane waves along each direction, by the Christoffel equation.\n") +
       stiffness_parameter +
       R"(bulk_density : float
    Mass per volume, > 0 [kg/m3].
direction : (..., 3) array_like
    Directions of propagation, vectors of any non-zero length [1].

Returns
-------
PlaneWaves
    Speeds (..., 3) and polarisations (..., 3, 3), from the fastest to the slowest.
)" +
       raises_invalid(
           "For other shapes, a density or direction out of range, or a stiffness that is not symmetric and "
           "positive semidefinite.") +
       notes("Small amplitudes, wave lengths far above the size of the grains. [Musgrave1970]",
             "elastic::plane_waves", "elastic/christoffel.hpp"))
          .c_str());
  module.def(
      "bulk_density",
      [](double grain_density, double void_ratio, double pore_density) {
        return elastic::bulk_density({grain_density, void_ratio, pore_density});
      },
      py::kw_only(), py::arg("grain_density"), py::arg("void_ratio"),
      py::arg("pore_density") = elastic::GrainsAndPores{}.pore_density,
      (R"(Mass per volume of a packing, (rho_s + e rho_pore)/(1+e).

Parameters
----------
grain_density : float
    rho_s > 0 of the grains' solid [kg/m3].
void_ratio : float
    e >= 0 [1].
pore_density : float
    Density of the pore fluid, >= 0 [kg/m3].

Returns
-------
float
    [kg/m3]
)" + raises_invalid("For a number out of range.") +
       notes("", "elastic::bulk_density", "elastic/wave_speeds.hpp"))
          .c_str());
  using elastic::ThomsenParameters;
  py::class_<ThomsenParameters>(module, "ThomsenParameters", "Transverse isotropy in Thomsen's notation.")
      .def_readonly("epsilon", &ThomsenParameters::epsilon, "(C11-C33)/(2 C33) [1].")
      .def_readonly("delta", &ThomsenParameters::delta, "[1]")
      .def_readonly("gamma", &ThomsenParameters::gamma, "(C66-C44)/(2 C44) [1].");
  module.def(
      "thomsen_parameters",
      [](const py::object& c, bool weak) {
        const TransverselyIsotropic ti = elastic::transversely_isotropic_projection(stiffness(c));
        return weak ? elastic::weak_thomsen_parameters(ti) : elastic::thomsen_parameters(ti);
      },
      py::arg("stiffness"), py::kw_only(), py::arg("weak") = false,
      (std::string("Thomsen's parameters of a stiffness, made symmetric about axis 3.\n") +
       stiffness_parameter + R"(weak : bool
    delta to first order.

Returns
-------
ThomsenParameters
)" +
       raises_invalid(
           "For another shape, or unless the stiffness is symmetric, positive definite and C33 > C44.") +
       notes("[Thomsen1986]", "elastic::thomsen_parameters", "elastic/thomsen.hpp"))
          .c_str());
}

void bind_saturation(py::module_& module) {
  module.def(
      "saturated",
      [](const py::object& c, double grain_bulk_modulus, double fluid_bulk_modulus, double void_ratio) {
        return constants(elastic::saturated(elastic::transversely_isotropic_projection(stiffness(c)),
                                            {.grain_bulk_modulus = grain_bulk_modulus,
                                             .fluid_bulk_modulus = fluid_bulk_modulus,
                                             .void_ratio = void_ratio}));
      },
      py::arg("stiffness"), py::kw_only(), py::arg("grain_bulk_modulus"), py::arg("fluid_bulk_modulus"),
      py::arg("void_ratio"),
      (std::string("Undrained stiffness of a packing with saturated pores, by Gassmann.\n") +
       stiffness_parameter + R"(grain_bulk_modulus : float
    K_s > 0 of the grains' solid [Pa]; bulk_modulus of a law or a mineral.
fluid_bulk_modulus : float
    K_f > 0 of the pore fluid [Pa].
void_ratio : float
    e > 0 [1].

Returns
-------
Estimate
    Stiffness with saturated pores, symmetrised about axis 3.
)" + raises_invalid("For another shape, a stiffness that is not symmetric, or a number out of range.") +
       notes("One solid, connected pores; shear moduli do not change. [Gassmann1951] [Mavko2009]",
             "elastic::saturated", "elastic/saturation.hpp"))
          .c_str());
  module.def("water_and_air_bulk_modulus", &elastic::water_and_air_bulk_modulus, py::arg("saturation"),
             (R"(Bulk modulus of a fine mixture of water and air, as in moist ground.

Parameters
----------
saturation : float
    Degree of saturation S, in [0, 1] [1].

Returns
-------
float
    1/(S/K_w + (1 - S)/K_a) [Pa]: 2.18 GPa of water alone, 0.142 MPa of air.
)" + raises_invalid("For a saturation outside of [0, 1].") +
              notes("Menisci between grains are not included. [Mavko2009]",
                    "elastic::water_and_air_bulk_modulus", "elastic/saturation.hpp"))
                 .c_str());
}

} // namespace

void bind_elastic(py::module_& module) {
  bind_symmetry(module);
  bind_projections(module);
  bind_waves(module);
  bind_saturation(module);
}

} // namespace granum::python
