// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <iterator>

#include <granum/fabric/estimates.hpp>
#include <granum/fabric/orientation.hpp>

#include "bindings.hpp"
#include "members.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using fabric::AnisotropyEstimate;
using fabric::FabricMeasures;

constexpr const char *out_of_range = "For the first number out of range, or shapes that cannot be broadcast.",
                     *refused_normals =
                         "For too few vectors, or one whose length differs from 1 by more than 1e-6.";

/// A function of two columns.
template <double (*of)(double, double)>
py::object of_two(const Arguments& a) {
  return numbers_of_rows(a, [](const double* x) { return of(x[0], x[1]); });
}

void bind_density(py::module_& module) {
  const Keyword anisotropy =
      column("anisotropy", "a in [-1, 1] [1]; > 0: more contacts near the axis.").called("fabric_anisotropy");
  define(module, "fabric_density", {column("polar_angle", "gamma, from axis 3 [rad]."), anisotropy},
         {"E(gamma; a), the density of contact normals per solid angle.",
          "float or ndarray\n    3 (1 + a cos 2 gamma)/(4 pi (3 - a)) [1/sr], of the broadcast shape.",
          out_of_range, "[Chung2014, Eq. 10]", "fabric::density", "fabric/orientation.hpp"},
         &of_two<fabric::density>);
  define(module, "fabric_cumulative_probability",
         {column("polar_cosine", "t of |n3| <= t, in [0, 1] [1]."), anisotropy},
         {"The share of contact normals at an angle from axis 3 that is at least the given one.",
          "float or ndarray\n    P(t) [1], of the broadcast shape.", out_of_range,
          "The integral of fabric_density.", "fabric::cumulative_probability", "fabric/orientation.hpp"},
         &of_two<fabric::cumulative_probability>);
  define(module, "fabric_polar_cosine_quantile", {column("probability", "In [0, 1] [1]."), anisotropy},
         {"The polar cosine of a probability.",
          "float or ndarray\n    t with P(t) = probability [1], of the broadcast shape.", out_of_range,
          "The inverse of fabric_cumulative_probability, with the same bits on every machine.",
          "fabric::polar_cosine_quantile", "fabric/orientation.hpp"},
         &of_two<fabric::polar_cosine_quantile>);
  define(module, "sample_normals",
         {required("anisotropy", "float", "a in [-1, 1] [1].").called("fabric_anisotropy"),
          required("count", "int", "Number of vectors."),
          required("seed", "int", "The same seed gives the same sample on every machine.")},
         {"Unit vectors drawn from E(gamma; a).", "(count, 3) ndarray\n    Unit vectors, in both senses [1].",
          "For an anisotropy out of range.", "Points in the unit disc. [Marsaglia1972]",
          "fabric::sample_normals", "fabric/orientation.hpp"},
         [](double a, std::size_t count, std::uint64_t seed) {
           return array_of(unlocked([&] { return fabric::sample_normals(a, count, seed); }));
         });
}

void bind_measures(py::module_& module) {
  ResultClass<FabricMeasures>(module, "FabricMeasures", "An axisymmetric fabric in the usual notations.")
      .show("anisotropy", "a of E(gamma; a) [1].", &FabricMeasures::anisotropy)
      .show("F11", "Mean of n1^2 [1].", &FabricMeasures::F11)
      .show("F33", "Mean of n3^2 [1].", &FabricMeasures::F33)
      .show("P2_coefficient", "a_c of (1 + a_c P2(cos gamma))/(4 pi) [1].", &FabricMeasures::P2_coefficient)
      .show("mean_cos_2gamma", "2 F33 - 1 [1].", &FabricMeasures::mean_cos_2gamma)
      .show_notes();
  define(module, "fabric_measures",
         {optional("anisotropy", "float", "a of E(gamma; a) [1]."),
          optional("F33", "float", "Mean of n3^2 [1]."),
          optional("P2_coefficient", "float", "a_c of (1 + a_c P2(cos gamma))/(4 pi) [1]."),
          optional("mean_cos_2gamma", "float", "2 F33 - 1 [1].")},
         {"An axisymmetric fabric in all notations, from one of its measures.", "FabricMeasures",
          "For an impossible number.", "[Kanatani1984]", "fabric::measures_from_anisotropy",
          "fabric/orientation.hpp", "TypeError\n    Unless exactly one of the four is given.\n"},
         [](const Arguments& a) {
           constexpr FabricMeasures (*makers[])(double) = {
               fabric::measures_from_anisotropy, fabric::measures_from_F33,
               fabric::measures_from_P2_coefficient, fabric::measures_from_mean_cos_2gamma};
           std::vector<std::size_t> given;
           for (std::size_t k = 0; k < std::size(makers); ++k)
             if (a.given(k))
               given.push_back(k);
           if (given.size() != 1)
             throw py::type_error(
                 "fabric_measures() takes one of anisotropy, F33, P2_coefficient, mean_cos_2gamma");
           return py::cast(makers[given[0]](a.number(given[0])));
         });
}

/// A function of contact normals, without Python's lock.
template <class Function>
auto of_normals(const Function& function) {
  return [function](const std::vector<Vec3>& normals) { return unlocked([&] { return function(normals); }); };
}

void bind_estimates(py::module_& module) {
  using fabric::LikelihoodEstimate;
  ResultClass<AnisotropyEstimate>(module, "AnisotropyEstimate",
                                  "a of E(gamma; a) from contact normals, by F33.")
      .show("anisotropy", "[1]", &AnisotropyEstimate::anisotropy)
      .show("standard_error", "For independent contacts [1].", &AnisotropyEstimate::standard_error)
      .show("F33", "Mean of n3^2 [1].", &AnisotropyEstimate::F33)
      .show("contacts", "Number of contacts.", &AnisotropyEstimate::contacts)
      .show_notes();
  ResultClass<LikelihoodEstimate>(module, "LikelihoodEstimate", "a of E(gamma; a) by maximum likelihood.")
      .show("anisotropy", "In [-1, 1].", &LikelihoodEstimate::anisotropy)
      .show("standard_error", "[1]", &LikelihoodEstimate::standard_error)
      .show("log_likelihood_gain", "Gain of log-likelihood over isotropy.",
            &LikelihoodEstimate::log_likelihood_gain)
      .show("at_boundary", "Whether a is -1 or 1, the boundary, with the likelihood still rising.",
            &LikelihoodEstimate::at_boundary)
      .show("contacts", "Number of contacts.", &LikelihoodEstimate::contacts)
      .show_notes();
  const Keyword normals =
      required("normals", "(N, 3) array_like", "One unit vector per contact, in either sense [1].");
  define(module, "estimate_anisotropy", {normals},
         {"a of E(gamma; a) from contact normals, by the mean of n3^2.",
          "AnisotropyEstimate\n    With its standard error for independent contacts; contacts of a packing "
          "scatter less.",
          refused_normals, "Axis 3 is the axis of symmetry.", "fabric::estimate_anisotropy",
          "fabric/estimates.hpp"},
         of_normals([](const auto& all) { return fabric::estimate_anisotropy(all); }), 1);
  define(module, "estimate_anisotropy_by_likelihood", {normals},
         {"a of E(gamma; a) from contact normals, by maximum likelihood.",
          "LikelihoodEstimate\n    a in [-1, 1], with its standard error from the observed information.",
          refused_normals,
          "Scatters less than estimate_anisotropy, the more so the further a is from 0, but assumes E(gamma; "
          "a).",
          "fabric::estimate_anisotropy_by_likelihood", "fabric/estimates.hpp"},
         of_normals([](const auto& all) { return fabric::estimate_anisotropy_by_likelihood(all); }), 1);
  define(module, "isotropy_p_value", {normals},
         {"p-value: probability of directions at least as uneven as these, if the true fabric is isotropic.",
          "float\n    p of (F33 - 1/3)/sqrt(4/(45 N)), either sign, for independent contacts [1].",
          refused_normals, "", "fabric::test_isotropy", "fabric/estimates.hpp"},
         of_normals([](const auto& all) { return fabric::test_isotropy(all).p_value; }), 1);
  define(
      module, "rose",
      {normals,
       required("anisotropy", "float", "a in [-1, 1] to compare with [1].").called("fabric_anisotropy"),
       required("bins", "int", "Of equal width, in [1, 1000].")},
      {"Histogram of the angle between contact normals and axis 3, with E(gamma; a) for comparison.",
       "list of RoseBin\n    With densities and their standard errors, in both hemispheres [1/sr].",
       refused_normals, "", "fabric::rose", "fabric/estimates.hpp"},
      [](const std::vector<Vec3>& all, double anisotropy, std::size_t bins) {
        return unlocked([&] { return fabric::rose(all, anisotropy, bins); });
      },
      1);
}

} // namespace

void bind_fabric(py::module_& module) {
  using fabric::RoseBin;
  ResultClass<RoseBin>(module, "RoseBin", "One bin of the angles between contact normals and axis 3.")
      .show("low", "[rad]", &RoseBin::low)
      .show("high", "[rad]", &RoseBin::high)
      .show("count", "Contacts in it.", &RoseBin::count)
      .show("density", "[1/sr]", &RoseBin::density)
      .show("density_error", "[1/sr]", &RoseBin::density_error)
      .show("expected_density", "[1/sr]", &RoseBin::expected_density);
  bind_density(module);
  bind_measures(module);
  bind_estimates(module);
}

} // namespace granum::python
