// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <granum/sands/known_sands.hpp>
#include <granum/sands/measured_sands.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "keywords.hpp"
#include "moduli.hpp"

namespace granum::python {

namespace {

using sands::KnownSand;
using sands::MeasuredLaw;

void bind_known_sands(py::module_& module) {
  py::class_<KnownSand>(module, "KnownSand",
                        "A sand often used in laboratories, with its published properties.")
      .def_readonly("key", &KnownSand::key, "Its name on a command line.")
      .def_readonly("name", &KnownSand::name, "Its full name.")
      .def_readonly("source", &KnownSand::source, "Keys in validation/references.bib.")
      .def_readonly("mineral", &KnownSand::mineral, "Key of its mineral, see minerals().")
      .def_readonly("d50", &KnownSand::d50, "[m]; None if not published.")
      .def_readonly("uniformity", &KnownSand::uniformity, "C_u = d60/d10 [1], or None.")
      .def_readonly("least_void_ratio", &KnownSand::least_void_ratio, "e_min [1], or None.")
      .def_readonly("largest_void_ratio", &KnownSand::largest_void_ratio, "e_max [1], or None.");
  module.def(
      "known_sands",
      [] {
        py::dict all;
        for (const KnownSand& sand : sands::known_sands())
          all[sand.key] = py::cast(&sand, py::return_value_policy::reference);
        return all;
      },
      (R"(Sands by name, for the argument sand of packing_answer() and infer().

Returns
-------
dict of KnownSand
    By their keys.
)" + notes("Batches of one name differ. [CubrinovskiIshihara2002] [YangSze2011] [CareyStoneKutter2020] "
           "[Azeiteiro2017] [Fioravante2015] [Arulmoli1992] [Tsomokos2010] [Lo2021]",
           "sands::known_sands", "sands/known_sands.hpp"))
          .c_str());
}

void bind_relative_density(py::module_& module) {
  define(module, {"void_ratio_of_relative_density",
                  {{"relative_density"}, {"least_void_ratio"}, {"largest_void_ratio"}},
                  [](const Arguments& a) {
                    const Argument columns[] = {
                        {"relative_density", a[0]}, {"least_void_ratio", a[1]}, {"largest_void_ratio", a[2]}};
                    return computed(answer_rows<double>(columns, true, 0.0,
                                                        [](const double* x, Notes&) {
                                                          return sands::void_ratio_of_relative_density(
                                                              x[0], x[1], x[2]);
                                                        }),
                                    [](double void_ratio) { return void_ratio; });
                  },
                  std::string(R"(The void ratio of a relative density, e_max - D_r (e_max - e_min).

Parameters
----------
relative_density : array_like
    D_r, in [0, 1.2] [1].
least_void_ratio, largest_void_ratio : array_like
    e_min > 0 and e_max above it [1].

Returns
-------
float or ndarray
    e [1], of the broadcast shape.
)") + raises_invalid("For the first number out of range.") +
                      notes("", "sands::void_ratio_of_relative_density", "sands/known_sands.hpp")});
}

void bind_measured_laws(py::module_& module) {
  py::class_<MeasuredLaw>(module, "MeasuredLaw",
                          "A published law of the small-strain shear modulus of sands.")
      .def_readonly("key", &MeasuredLaw::key, "Its name on a command line.")
      .def_readonly("sand", &MeasuredLaw::sand, "The tested material.")
      .def_readonly("source", &MeasuredLaw::source, "Key in validation/references.bib.")
      .def_readonly("formula", &MeasuredLaw::formula, "In kPa, as in its source.")
      .def_property_readonly(
          "bias", [](const MeasuredLaw& l) { return l.record.bias; },
          "Law over measured, geometric mean over 38 clean sands [1].")
      .def_property_readonly(
          "rms_log10", [](const MeasuredLaw& l) { return l.record.rms_log10; },
          "Root mean square of log10 of law over measured, for the same sands [1].");
  module.def(
      "measured_laws",
      [] {
        py::dict all;
        for (const MeasuredLaw& law : sands::measured_laws())
          all[law.key] = py::cast(&law, py::return_value_policy::reference);
        return all;
      },
      (R"(Published laws of the small-strain shear modulus of sands, in the order of their years.

Returns
-------
dict of MeasuredLaw
    By their keys.
)" + notes("[HardinRichart1963] [Kokusho1980] [Jamiolkowski1991] [Menq2003] [WichtmannTriantafyllidis2009] "
           "[OztoprakBolton2013] [WangStokoe2022]",
           "sands::measured_laws", "sands/measured_sands.hpp"))
          .c_str());
  define(
      module,
      {"sand_shear_modulus",
       {{"law"}, {"void_ratio"}, {"pressure"}, {"uniformity", "1.5"}, {"d50", "0.0004"}, {"strict", "False"}},
       [](const Arguments& a) {
         const MeasuredLaw& law = sands::measured_law(a.text(0));
         const Argument columns[] = {{"void_ratio", a[1]},
                                     {"pressure", a[2], "mean_stress"},
                                     a.given(3) ? Argument{"uniformity", a[3]}
                                                : Argument{"uniformity", sands::SandState{}.uniformity},
                                     a.given(4) ? Argument{"d50", a[4]}
                                                : Argument{"d50", sands::SandState{}.d50}};
         return moduli_of_shear(columns, a.flag(5), [&law](const double* x, Notes& notes) {
           const sands::SandModulus found = sands::shear_modulus(
               law, {.void_ratio = x[0], .mean_stress = x[1], .uniformity = x[2], .d50 = x[3]});
           notes.add(found.validity);
           return found.shear_modulus;
         });
       },
       std::string(R"(Small-strain shear modulus of a sand by a published law.

Parameters
----------
law : str
    A key of measured_laws().
void_ratio : array_like
    e > 0 [1].
pressure : array_like
    Mean effective stress p > 0 [Pa].
uniformity : array_like
    C_u = d60/d10 >= 1 [1]; used by four laws.
d50 : array_like
    > 0 [m]; used by two laws.
strict : bool
    Raise at the first element that is refused, instead of NaN and a message in `errors`.

Returns
-------
IsotropicModuli
    Its notes report numbers outside of the tests of the law. The bulk modulus is NaN: the laws have none.
)") + raises_invalid("For another law, a number out of range, or a void ratio beyond the law's zero.") +
           notes("Under isotropic stress, clean sands. Sources: measured_laws().", "sands::shear_modulus",
                 "sands/measured_sands.hpp")});
}

} // namespace

void bind_sands(py::module_& module) {
  bind_known_sands(module);
  bind_relative_density(module);
  bind_measured_laws(module);
}

} // namespace granum::python
