// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/waves.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "estimate.hpp"
#include "members.hpp"
#include "rows.hpp"
#include "shared_keywords.hpp"
#include "stacks.hpp"

namespace granum::python {

namespace {

using elastic::EngineeringModuli;
using elastic::Isotropic;
using elastic::Matrix6;
using elastic::PlaneWave;
using elastic::PlaneWaves;
using elastic::SymmetryDistances;
using elastic::ThomsenParameters;
using elastic::TransverselyIsotropic;
using elastic::VoigtStiffness;

/// What is refused of a stiffness.
std::string refused_stiffness(const std::string& more) {
  return "For another shape, or a stiffness that is " + more + " With stacks only under strict.";
}

/// The keywords of a function of stiffnesses.
std::vector<Keyword> of_stiffness(std::vector<Keyword> more = {}) {
  more.insert(more.begin(), stiffness_keyword());
  more.push_back(strict_keyword());
  return more;
}

/// `answer`(stiffness, numbers of the other columns) for every element of a call whose first keyword is a
/// stack of stiffnesses, and whose columns are the others.
template <class Row, class Answer>
Rows<Row> stiffness_rows(const Arguments& a, const Row& refused, const Answer& answer) {
  const Stack stiffness(a, 0, {6, 6});
  std::vector<Argument> columns{stiffness.column()};
  for (const Argument& column : columns_of(a))
    columns.push_back(column);
  return answer_rows<Row>(columns, is_strict(a), refused, [&](const double* x, Notes&) {
    return answer(stiffness_at(stiffness.at(x[0])), x + 1);
  });
}

// ---- symmetry

void bind_symmetry(py::module_& module) {
  result_class<EngineeringModuli>(module, "EngineeringModuli", "Moduli along the axes and in their planes.")
      .show("bulk_modulus", "K [Pa].", &EngineeringModuli::bulk_modulus)
      .show("E_1", "[Pa]", &EngineeringModuli::E_1)
      .show("E_2", "[Pa]", &EngineeringModuli::E_2)
      .show("E_3", "[Pa]", &EngineeringModuli::E_3)
      .show("C44", "[Pa]", &EngineeringModuli::C44)
      .show("C55", "[Pa]", &EngineeringModuli::C55)
      .show("C66", "[Pa]", &EngineeringModuli::C66);
  result_class<SymmetryDistances>(module, "SymmetryDistances",
                                  "Distances of a stiffness from classes of symmetry.")
      .show("isotropic", "[1]", &SymmetryDistances::isotropic)
      .show("cubic", "[1]", &SymmetryDistances::cubic)
      .show("transversely_isotropic", "[1]", &SymmetryDistances::transversely_isotropic)
      .show("orthotropic", "[1]", &SymmetryDistances::orthotropic);
  define(
      module, "engineering_moduli", of_stiffness(),
      {"Moduli of a stiffness along the axes and in their planes.",
       "EngineeringModuli\n    E is 0 along an axis with a zero-energy deformation.",
       refused_stiffness("not symmetric and finite."), "", "elastic::engineering_moduli",
       "elastic/isotropic.hpp"},
      [](const Arguments& a) {
        return py::cast(stiffness_rows<EngineeringModuli>(
            a, {nan, nan, nan, nan, nan, nan, nan},
            [](const VoigtStiffness& c, const double*) { return elastic::engineering_moduli(c); }));
      },
      1);
  define(
      module, "symmetry_distances", of_stiffness(),
      {"Distances of a stiffness from classes of symmetry.",
       "SymmetryDistances\n    Distances relative to the norm of the stiffness [1].",
       refused_stiffness("zero or not symmetric and finite."), "[Moakher2006]", "elastic::symmetry_distances",
       "elastic/stiffness.hpp"},
      [](const Arguments& a) {
        return py::cast(stiffness_rows<SymmetryDistances>(
            a, {nan, nan, nan, nan},
            [](const VoigtStiffness& c, const double*) { return elastic::symmetry_distances(c); }));
      },
      1);
  define(
      module, "rotate",
      {stiffness_keyword(),
       required("rotation", "(..., 3, 3) array_like", "Orthogonal matrices of determinant 1 [1].")},
      {"The stiffness of a rotated material, in unchanged axes.",
       "(..., 6, 6) ndarray\n    Voigt matrices [Pa].",
       "For another shape, a stiffness that is not symmetric, or a matrix that is no rotation.",
       "[Mehrabadi1990]", "elastic::rotate", "elastic/stiffness.hpp"},
      [](const Arguments& a) {
        const Stack stiffness(a, 0, {6, 6}), rotation(a, 1, {3, 3});
        const Argument columns[] = {stiffness.column(), rotation.column()};
        const auto rows =
            answer_rows<Matrix6>(columns, true, Matrix6::Constant(nan), [&](const double* x, Notes&) {
              Mat3 turn;
              std::memcpy(&turn.m[0][0], rotation.at(x[1]), sizeof(turn.m));
              return elastic::rotate(stiffness_at(stiffness.at(x[0])), turn).matrix;
            });
        return matrices_of(rows.shape, rows.rows);
      },
      1);
}

// ---- isotropic solids, projections and averages

/// The two moduli of an isotropic solid; NaN where it was refused.
struct IsotropicRow {
  double bulk_modulus = nan, shear_modulus = nan;

  IsotropicRow() = default;
  explicit IsotropicRow(const Isotropic& solid)
      : bulk_modulus(solid.bulk_modulus()), shear_modulus(solid.shear_modulus()) {}
  [[nodiscard]] bool refused() const { return std::isnan(shear_modulus); }
  [[nodiscard]] Isotropic solid() const {
    return Isotropic::from_bulk_and_shear(bulk_modulus, shear_modulus);
  }
};
using Solids = Rows<IsotropicRow>;

struct AveragesRow {
  IsotropicRow voigt, hill, reuss;
};

py::object isotropic_object(Solids solids) { return py::cast(std::move(solids)); }

/// A number of every solid.
auto of_solids(double (Isotropic::*number)() const) {
  return [number](const Solids& solids) {
    return computed(
        solids, [number](const IsotropicRow& row) { return row.refused() ? nan : (row.solid().*number)(); });
  };
}

py::array matrices_of_solids(const Solids& solids) {
  std::vector<Matrix6> all;
  all.reserve(solids.rows.size());
  for (const IsotropicRow& row : solids.rows)
    all.push_back(row.refused() ? Matrix6::Constant(nan).eval() : elastic::voigt(row.solid()).matrix);
  return matrices_of(solids.shape, all);
}

py::object wave_speeds(const Arguments& a) {
  const auto& solids = a.as<const Solids&>(0);
  py::array_t<double> places(solids.shape);
  for (py::ssize_t k = 0; k < places.size(); ++k)
    places.mutable_data()[k] = static_cast<double>(k);
  const Argument columns[] = {solids.scalar ? Argument{"solid", 0.0} : Argument{"solid", py::handle(places)},
                              {"bulk_density", a[1]}};
  const auto speed = [&](double elastic::WaveSpeeds::*which) {
    return numbers_of_rows(columns, [&](const double* x) {
      const IsotropicRow& row = solids.rows[static_cast<std::size_t>(x[0])];
      return row.refused() ? nan : elastic::wave_speeds(row.solid(), x[1]).*which;
    });
  };
  return py::dict(py::arg("p") = speed(&elastic::WaveSpeeds::p),
                  py::arg("s") = speed(&elastic::WaveSpeeds::s));
}

// Memory and messages, for a pickle.
py::tuple state_of_solids(const Solids& solids) {
  py::dict errors;
  for (const auto& [row, message] : solids.errors)
    errors[py::int_(row)] = decoded(message);
  return py::make_tuple(
      solids.scalar, solids.shape,
      py::bytes(reinterpret_cast<const char*>(solids.rows.data()), solids.rows.size() * sizeof(IsotropicRow)),
      errors);
}

Solids solids_of_state(const py::tuple& state) {
  Solids out;
  out.scalar = state[0].cast<bool>();
  out.shape = state[1].cast<std::vector<py::ssize_t>>();
  const std::string bytes = state[2].cast<std::string>();
  out.rows.resize(bytes.size() / sizeof(IsotropicRow));
  std::memcpy(static_cast<void*>(out.rows.data()), bytes.data(), out.rows.size() * sizeof(IsotropicRow));
  out.errors = state[3].cast<std::map<std::size_t, std::string>>();
  return out;
}

void bind_isotropic(py::module_& module) {
  auto type = result_class<IsotropicRow>(module, "Isotropic", "Isotropic elastic solids.");
  type.show("bulk_modulus", "K [Pa].", &IsotropicRow::bulk_modulus)
      .show("shear_modulus", "G [Pa].", &IsotropicRow::shear_modulus);
  type.def_property_readonly("young_modulus", of_solids(&Isotropic::young_modulus), "E [Pa].")
      .def_property_readonly("poisson_ratio", of_solids(&Isotropic::poisson_ratio), "nu [1].")
      .def_property_readonly("lame_lambda", of_solids(&Isotropic::lame_lambda), "lambda [Pa].")
      .def_property_readonly("stiffness", &matrices_of_solids, "6 x 6 Voigt matrices [Pa], (..., 6, 6).")
      .def(py::pickle(&state_of_solids, &solids_of_state))
      .def("__repr__", [](const Solids& solids) -> std::string {
        if (!solids.scalar)
          return "<Isotropic of shape " +
                 std::string(py::str(py::object(py::tuple(py::cast(solids.shape))))) + ">";
        return py::str("Isotropic(bulk_modulus={!r}, shear_modulus={!r})")
            .format(solids.front().bulk_modulus, solids.front().shear_modulus);
      });
  define_method(type, "wave_speeds", {column("bulk_density", "Mass per volume, > 0 [kg/m3].")},
                {"Speeds of plane waves p and s [m/s].", "dict of float or ndarray"}, &wave_speeds);
  define(module, "isotropic",
         {column("bulk_modulus", "K > 0 [Pa]; inf: incompressible."), column("shear_modulus", "G > 0 [Pa]."),
          strict_keyword()},
         {"The isotropic solid with these two moduli.", "Isotropic",
          "Unless both are positive, and the shear modulus finite; with arrays only under strict.", "",
          "elastic::Isotropic::from_bulk_and_shear", "elastic/isotropic.hpp"},
         [](const Arguments& a) {
           return rows_of(a, IsotropicRow(), [](const double* x, Notes&) {
             return IsotropicRow(Isotropic::from_bulk_and_shear(x[0], x[1]));
           });
         });
}

py::object projected(const Arguments& a) {
  const Stack stiffness(a, 0, {6, 6});
  std::vector<Argument> columns{stiffness.column()};
  std::optional<Stack> axis;
  if (a.given(1))
    columns.push_back(axis.emplace(a, 1, std::vector<py::ssize_t>{3}).column());
  return estimate_object(answer_rows(columns, is_strict(a), StiffnessRow{}, [&](const double* x, Notes&) {
    const VoigtStiffness c = stiffness_at(stiffness.at(x[0]));
    if (!axis)
      return StiffnessRow{.stiffness = elastic::transversely_isotropic_projection(c)};
    const double* n = axis->at(x[1]);
    return StiffnessRow{.stiffness = elastic::transversely_isotropic_projection(c, {n[0], n[1], n[2]})};
  }));
}

void bind_projections(py::module_& module) {
  define(
      module, "isotropic_projection", of_stiffness(),
      {"The isotropic solid nearest to a stiffness.", "Isotropic",
       refused_stiffness("not symmetric, or a resulting modulus that is not positive."),
       "Nearest in the norm that no rotation changes. [Moakher2006]", "elastic::isotropic_projection",
       "elastic/isotropic.hpp"},
      [](const Arguments& a) {
        return isotropic_object(stiffness_rows(a, IsotropicRow(), [](const VoigtStiffness& c, const double*) {
          return IsotropicRow(elastic::isotropic_projection(c));
        }));
      },
      1);
  define(module, "transversely_isotropic_projection",
         of_stiffness({optional("axis", "(..., 3) array_like",
                                "Axes of symmetry, of any length [1]; default: axis 3.")}),
         {"The transversely isotropic stiffness nearest to a stiffness.",
          "Estimate\n    In axes with the axis of symmetry as the third.",
          refused_stiffness("not symmetric, or an axis of zero length."),
          "Nearest in the norm that no rotation changes. [Moakher2006]",
          "elastic::transversely_isotropic_projection", "elastic/isotropic.hpp"},
         &projected, 1);
  auto type = result_class<AveragesRow>(module, "IsotropicAverages", "Averages over all orientations.");
  const auto show = [&type](const char* name, const char* says, IsotropicRow AveragesRow::*solid) {
    type.def_property_readonly(
        name,
        [solid](const Rows<AveragesRow>& averages) {
          Solids solids{averages.scalar, averages.shape, {}, averages.errors, averages.notes};
          for (const AveragesRow& row : averages.rows)
            solids.rows.push_back(row.*solid);
          return isotropic_object(std::move(solids));
        },
        says);
  };
  show("voigt", "Equal strain: an upper bound.", &AveragesRow::voigt);
  show("hill", "Mean of both.", &AveragesRow::hill);
  show("reuss", "Equal stress: a lower bound.", &AveragesRow::reuss);
  define(
      module, "isotropic_averages", of_stiffness(),
      {"Voigt's, Hill's and Reuss' averages of a stiffness over all orientations.", "IsotropicAverages",
       refused_stiffness("not symmetric and positive definite."), "[Hill1952]", "elastic::isotropic_averages",
       "elastic/isotropic.hpp"},
      [](const Arguments& a) {
        return py::cast(stiffness_rows(a, AveragesRow(), [](const VoigtStiffness& c, const double*) {
          const elastic::IsotropicAverages averages = elastic::isotropic_averages(c);
          return AveragesRow{IsotropicRow(averages.voigt), IsotropicRow(averages.hill),
                             IsotropicRow(averages.reuss)};
        }));
      },
      1);
}

// ---- waves

constexpr PlaneWave PlaneWaves::*by_speed[] = {&PlaneWaves::fastest, &PlaneWaves::middle,
                                               &PlaneWaves::slowest};

/// Numbers of the three waves of every element.
template <class Write>
py::array of_waves(const Rows<PlaneWaves>& waves, std::initializer_list<py::ssize_t> axes,
                   const Write& write) {
  std::vector<py::ssize_t> shape = waves.shape;
  shape.insert(shape.end(), axes);
  py::array_t<double> out(shape);
  double* to = out.mutable_data();
  for (std::size_t k = 0; k < waves.rows.size(); ++k) {
    hear_signals(k);
    for (const auto wave : by_speed)
      to = write(waves.rows[k].*wave, to);
  }
  return out;
}

py::array speeds(const Rows<PlaneWaves>& waves) {
  return of_waves(waves, {3}, [](const PlaneWave& wave, double* to) {
    *to = wave.speed;
    return to + 1;
  });
}

py::array polarisations(const Rows<PlaneWaves>& waves) {
  return of_waves(waves, {3, 3}, [](const PlaneWave& wave, double* to) {
    for (int axis = 0; axis < 3; ++axis)
      *to++ = wave.polarisation[axis];
    return to;
  });
}

py::object plane_waves(const Arguments& a) {
  const Stack stiffness(a, 0, {6, 6}), direction(a, 2, {3});
  const Argument columns[] = {stiffness.column(), {a.name(1), a[1]}, direction.column()};
  const PlaneWave none{nan, {nan, nan, nan}};
  return py::cast(
      answer_rows<PlaneWaves>(columns, is_strict(a), {none, none, none}, [&](const double* x, Notes&) {
        const double* n = direction.at(x[2]);
        return elastic::plane_waves(stiffness_at(stiffness.at(x[0])), x[1], {n[0], n[1], n[2]});
      }));
}

void bind_waves(py::module_& module) {
  result_class<PlaneWaves>(module, "PlaneWaves",
                           "Three plane waves along each direction, from the fastest to the slowest.")
      .def_property_readonly("speed", &speeds, "Phase speeds [m/s], (..., 3).")
      .def_property_readonly("polarisation", &polarisations, "Unit vectors of motion, (..., 3, 3).");
  define(module, "plane_waves",
         of_stiffness({column("bulk_density", "Mass per volume, > 0 [kg/m3]."),
                       required("direction", "(..., 3) array_like",
                                "Directions of propagation, vectors of any non-zero length [1].")}),
         {"Three plane waves along each direction, by the Christoffel equation.",
          "PlaneWaves\n    Speeds (..., 3) and polarisations (..., 3, 3), from the fastest to the slowest.",
          refused_stiffness("not symmetric and positive semidefinite, a density or direction out of range."),
          "Small amplitudes, wave lengths far above the size of the grains. [Musgrave1970]",
          "elastic::plane_waves", "elastic/waves.hpp"},
         &plane_waves, 1);
  define(
      module, "bulk_density",
      {of_input(estimate::Input::grain_density),
       column("void_ratio", "Volume of voids over that of grains, >= 0 [1]."),
       column("pore_density", "Density of the pore fluid, >= 0 [kg/m3].")
           .or_number(elastic::GrainsAndPores{}.pore_density)},
      {"Mass per volume of a packing, (rho_s + e rho_pore)/(1+e).", "float or ndarray\n    [kg/m3]",
       "For a number out of range.", "", "elastic::bulk_density", "elastic/waves.hpp"},
      [](const Arguments& a) {
        return numbers_of_rows(a, [](const double* x) { return elastic::bulk_density({x[0], x[1], x[2]}); });
      });
  result_class<ThomsenParameters>(module, "ThomsenParameters", "Transverse isotropy in Thomsen's notation.")
      .show("epsilon", "(C11-C33)/(2 C33) [1].", &ThomsenParameters::epsilon)
      .show("delta", "[1]", &ThomsenParameters::delta)
      .show("gamma", "(C66-C44)/(2 C44) [1].", &ThomsenParameters::gamma);
  define(
      module, "thomsen_parameters",
      of_stiffness({with_default("weak", "False", "bool", "delta to first order.")}),
      {"Thomsen's parameters of a stiffness, made symmetric about axis 3.", "ThomsenParameters",
       "For another shape, or unless the stiffness is symmetric, positive definite and C33 > C44. With "
       "stacks "
       "only under strict.",
       "[Thomsen1986]", "elastic::thomsen_parameters", "elastic/waves.hpp"},
      [](const Arguments& a) {
        const auto parameters = a.flag(1) ? &elastic::weak_thomsen_parameters
                                          : static_cast<ThomsenParameters (*)(const TransverselyIsotropic&)>(
                                                &elastic::thomsen_parameters);
        return py::cast(stiffness_rows<ThomsenParameters>(
            a, {nan, nan, nan}, [=](const VoigtStiffness& c, const double*) {
              return parameters(elastic::transversely_isotropic_projection(c));
            }));
      },
      1);
}

void bind_saturation(py::module_& module) {
  define(
      module, "saturated",
      of_stiffness({column("grain_bulk_modulus",
                           "K_s > 0 of the grains' solid [Pa]; bulk_modulus of a law or a mineral."),
                    column("fluid_bulk_modulus", "K_f > 0 of the pore fluid [Pa]."),
                    of_input(estimate::Input::void_ratio)}),
      {"Undrained stiffness of a packing with saturated pores, by Gassmann.",
       "Estimate\n    Stiffness with saturated pores, symmetrised about axis 3.",
       refused_stiffness("not symmetric, or a number out of range."),
       "One solid, connected pores; shear moduli do not change. [Gassmann1951] [Mavko2009]",
       "elastic::saturated", "elastic/waves.hpp"},
      [](const Arguments& a) {
        return estimate_object(
            stiffness_rows(a, StiffnessRow{}, [](const VoigtStiffness& c, const double* x) {
              return StiffnessRow{
                  .stiffness = elastic::saturated(
                      elastic::transversely_isotropic_projection(c),
                      {.grain_bulk_modulus = x[0], .fluid_bulk_modulus = x[1], .void_ratio = x[2]})};
            }));
      },
      1);
  define(
      module, "water_and_air_bulk_modulus", {column("saturation", "Degree of saturation S, in [0, 1] [1].")},
      {"Bulk modulus of a fine mixture of water and air, as in moist ground.",
       "float or ndarray\n    1/(S/K_w + (1 - S)/K_a) [Pa]: 2.18 GPa of water alone, 0.142 MPa of air.",
       "For a saturation outside of [0, 1].", "Menisci between grains are not included. [Mavko2009]",
       "elastic::water_and_air_bulk_modulus", "elastic/waves.hpp"},
      [](const Arguments& a) {
        return numbers_of_rows(a, [](const double* x) { return elastic::water_and_air_bulk_modulus(x[0]); });
      },
      1);
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
