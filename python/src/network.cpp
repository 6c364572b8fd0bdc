// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <granum/network/lowest_modes.hpp>
#include <granum/network/stiffness_matrix.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "measure.hpp"
#include "members.hpp"
#include "rows.hpp"
#include "shared_keywords.hpp"
#include "studies/analyse/grain_fields.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/overlaps.hpp"

namespace granum::python {

namespace {

/// What was found of an assembly whose contacts have their stiffnesses.
template <class Find>
auto of_network(const Arguments& a, const Find& find) {
  const auto packing = a.as<SharedPacking>(a.at("packing"));
  const analysis::Given given = given_of(a, *packing);
  network::ResponseOptions options;
  options.prestress = a.flag(a.at("prestress"));
  options.stop_requested = stop_on_signal();
  auto out = unlocked([&] {
    return find(packing->has(io::Finding::contacts_unknown)
                    ? studies::stiffened(studies::with_overlap_contacts(*packing, given), given)
                    : studies::stiffened(*packing, given),
                options);
  });
  throw_if_signalled();
  return out;
}

/// Six rows a grain, those without load empty.
struct Elements {
  std::vector<double> value;
  std::vector<std::int64_t> row, column;
  std::size_t rows = 0;
};

Elements matrix_elements(const packing::Assembly& assembly, const network::ResponseOptions& options) {
  const network::StiffnessMatrix h = network::stiffness_matrix(assembly, options);
  const auto place = [&](Eigen::Index k) {
    return static_cast<std::int64_t>(6 * h.grain[static_cast<std::size_t>(k / h.unknowns_per_grain)]) +
           k % h.unknowns_per_grain;
  };
  Elements out;
  for (Eigen::Index column = 0; column < h.matrix.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator element(h.matrix, column); element; ++element) {
      out.value.push_back(element.value());
      out.row.push_back(place(element.row()));
      out.column.push_back(place(column));
    }
  const auto& body = assembly.body;
  out.rows = 6 * (body.empty() ? assembly.grain_count() : 1 + *std::max_element(body.begin(), body.end()));
  return out;
}

template <class Number>
py::array numbers(const std::vector<Number>& all) {
  return py::array_t<Number>(static_cast<py::ssize_t>(all.size()), all.data());
}

py::object stiffness_matrix(const Arguments& a) {
  py::module_ sparse;
  try {
    sparse = py::module_::import("scipy.sparse");
  } catch (py::error_already_set& error) {
    py::raise_from(error, PyExc_ImportError,
                   "stiffness_matrix() returns a matrix of scipy, which is not installed");
    throw py::error_already_set();
  }
  const Elements all = of_network(a, matrix_elements);
  return sparse.attr("csr_matrix")(
      py::make_tuple(numbers(all.value), py::make_tuple(numbers(all.row), numbers(all.column))),
      py::arg("shape") = py::make_tuple(all.rows, all.rows));
}

/// Modes, with arrays over all of them.
struct Modes {
  std::vector<double> frequency, participation_ratio;
  std::vector<std::vector<network::GrainMotion>> motions;
};

py::object lowest_modes(const Arguments& a) {
  const auto count = a.as<std::size_t>(a.at("count"), "a whole number, 1 or more");
  const double density = a.number(a.at("grain_density"));
  Modes out;
  for (network::Mode& mode :
       of_network(a, [&](const packing::Assembly&assembly, const network::ResponseOptions&options) {
         return network::lowest_modes(assembly, density, count, options);
       })) {
    out.frequency.push_back(mode.frequency);
    out.participation_ratio.push_back(mode.participation_ratio);
    out.motions.push_back(std::move(mode.motion));
  }
  return py::cast(std::move(out));
}

void define_d2min(py::module_& module) {
  define(
      module, "d2min",
      {required("before", "Packing", "A frame of a packing, from read(), frames() or packing()."),
       required("after", "Packing", "Another frame of it. Grains are the same if their ids are."),
       with_default("reach", "1.5", "float",
                    "Grains are neighbours if their centres before are closer than reach (R_i + R_j), 1 to "
                    "5 [1].")},
      {"D2min of each grain: what its neighbours moved between two frames beside one uniform deformation.",
       "ndarray\n    (N,) [m2], of the grains of after, a sum over the neighbours; 0 with up to three "
       "neighbours, which one\n    deformation explains, and for grains that are not in both.",
       "For a reach out of range.", "[FalkLanger1998]", "analysis::d2min", "analysis/rearrangement.hpp"},
      [](const Arguments& a) -> py::object {
        const auto before = a.as<SharedPacking>(0), after = a.as<SharedPacking>(1);
        const double reach = a.number_if_given(2).value_or(studies::neighbour_reach);
        return numbers(unlocked([&] { return studies::d2min(*before, *after, reach); }));
      },
      2);
}

} // namespace

void bind_network(py::module_& module) {
  using analysis::Network;
  ResultClass<Network>(module, "Network", "Linear response of the contact network, rung 4.")
      .show("relaxed", "6 x 6 with every grain in equilibrium [Pa]. Raises NotConverged if not solved.",
            [](const Network& n) { return n.response.relaxed().matrix; })
      .show("motions",
            "What the grains of relaxed do beside a unit of each strain, in Voigt order: u and R w [m], "
            "(6, N, 6); of bodies if grains form bodies. None unless measure was called with motions=True.",
            [](const Network& n) -> py::object {
              const network::StrainMotions& motions = n.response.motions();
              return motions[0].empty() ? py::object(py::none()) : array_of_motions(motions);
            })
      .show("affine", "6 x 6 under uniform strain without spin [Pa].",
            [](const Network& n) { return n.response.affine().matrix; })
      .show("converged", "Whether the solver converged.",
            [](const Network& n) { return n.response.converged(); })
      .show("iterations", "Iterations of conjugate gradients.",
            [](const Network& n) { return n.response.report().iterations; })
      .show("residual", "Residual force over affine force, for the worst load case [1].",
            [](const Network& n) { return n.response.report().residual; })
      .show("grains", "Number of grains that carry load.",
            [](const Network& n) { return n.response.report().grains; })
      .show("contacts", "Number of contacts between them.",
            [](const Network& n) { return n.response.report().contacts; })
      .show("G_hh", "Shear modulus of the horizontal plane [Pa].", &Network::G_hh)
      .show("G_vh", "Mean shear modulus of both vertical planes [Pa].", &Network::G_vh)
      .show("bulk_modulus", "K of the nearest isotropic solid [Pa].", &Network::isotropic_relaxed,
            &elastic::Isotropic::bulk_modulus)
      .show("shear_modulus", "G of the nearest isotropic solid [Pa].", &Network::isotropic_relaxed,
            &elastic::Isotropic::shear_modulus)
      .show("moduli", "Moduli of the relaxed network.",
            [](const Network& n) { return of_one(n.relaxed.moduli); })
      .show("symmetry", "Symmetry of the relaxed network.",
            [](const Network& n) { return of_one(n.relaxed.symmetry); })
      .show("bulk_modulus_bounds", "[Pa]",
            [](const Network& n) { return std::pair(n.bulk_bounds.lower, n.bulk_bounds.upper); });
}

void bind_network_matrix(py::module_& module) {
  ResultClass<Modes>(module, "Modes", "Free oscillations of a contact network, from the lowest frequency on.")
      .show("frequency", "f, with (2 pi f)^2 the eigenvalue [Hz], (n,).",
            [](const Modes& m) { return numbers(m.frequency); })
      .show("participation_ratio",
            "(sum e)^2/(N sum e^2) of the kinetic energies e of the N grains that carry load [1], (n,).",
            [](const Modes& m) { return numbers(m.participation_ratio); })
      .show("motions", "u and R w of each grain where u^T M u is 1 kg m^2 [m], (n, N, 6).",
            [](const Modes& m) { return array_of_motions(m.motions); });
  define(
      module, "stiffness_matrix", given_keywords(),
      {"The stiffness matrix of a contact network, the Hessian of its energy, as a sparse matrix.",
       "scipy.sparse.csr_matrix\n    (6 N, 6 N) [N/m]. Rows 6 g to 6 g + 5 are the unknowns of grain g: its "
       "displacement u and its rotation times its radius, R w, both in m. Rows of grains without load are "
       "empty. If grains form bodies, N is their number.",
       "For an impossible packing, and if nothing gives the stiffnesses of the contacts.", "",
       "network::stiffness_matrix", "network/stiffness_matrix.hpp", "ImportError\n    Without scipy.\n"},
      &stiffness_matrix, 1);
  std::vector<Keyword> keywords = given_keywords();
  const Keyword own[] = {
      required("count", "int", "Number of modes."),
      required("grain_density", "float", "Density of the grains, for their masses [kg/m3].")};
  keywords.insert(keywords.begin() + 1, std::begin(own), std::end(own));
  define(
      module, "lowest_modes", keywords,
      {"The free oscillations of a contact network of the lowest frequencies.\n\nMotions without stiffness, "
       "such as translations, are left out. The time is that of a direct factor: 2 s for 1,000 grains, 5 min "
       "for 10,000; Ctrl-C ends it after the factor.",
       "Modes\n    Fewer than count if the network has no more.",
       "For what stiffness_matrix refuses, and for grains that form bodies.",
       "Spheres: mass m for u, 2/5 m for R w. [GolubUnderwood1977], [BellDean1970]", "network::lowest_modes",
       "network/lowest_modes.hpp"},
      &lowest_modes, 3);
  define_d2min(module);
}

} // namespace granum::python
