// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <granum/sands/known_sands.hpp>
#include <granum/sands/measured_sands.hpp>

#include "bindings.hpp"
#include "members.hpp"
#include "moduli.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using estimate::Input;
using sands::KnownSand;
using sands::MeasuredLaw;

void bind_known_sands(py::module_& module) {
  ResultClass<KnownSand>(module, "KnownSand",
                         "A sand often used in laboratories, with its published properties.")
      .show("key", "Its name on a command line.", &KnownSand::key)
      .show("name", "Its full name.", &KnownSand::name)
      .show("source", "Keys in validation/references.bib.", &KnownSand::source)
      .show("mineral", "Key of its mineral, see minerals().", &KnownSand::mineral)
      .show("d50", "[m]; None if not published.", &KnownSand::d50)
      .show("uniformity", "C_u = d60/d10 [1], or None.", &KnownSand::uniformity)
      .show("least_void_ratio", "e_min [1], or None.", &KnownSand::least_void_ratio)
      .show("largest_void_ratio", "e_max [1], or None.", &KnownSand::largest_void_ratio);
  define_table(module, "known_sands", sands::known_sands(),
               {"Sands by name, for the argument sand of packing_answer() and infer().",
                "dict of KnownSand\n    By their keys.", "",
                "Batches of one name differ. [CubrinovskiIshihara2002] [YangSze2011] [CareyStoneKutter2020] "
                "[Azeiteiro2017] [Fioravante2015] [Arulmoli1992] [Tsomokos2010] [Lo2021]",
                "sands::known_sands", "sands/known_sands.hpp"});
  define(module, "void_ratio_of_relative_density",
         {of_input(Input::relative_density), of_input(Input::least_void_ratio),
          of_input(Input::largest_void_ratio)},
         {"The void ratio of a relative density, e_max - D_r (e_max - e_min).",
          "float or ndarray\n    e [1], of the broadcast shape.", "For the first number out of range.", "",
          "sands::void_ratio_of_relative_density", "sands/known_sands.hpp"},
         [](const Arguments& a) {
           return numbers_of_rows(
               a, [](const double* x) { return sands::void_ratio_of_relative_density(x[0], x[1], x[2]); });
         });
}

void bind_measured_laws(py::module_& module) {
  ResultClass<MeasuredLaw>(module, "MeasuredLaw",
                           "A published law of the small-strain shear modulus of sands.")
      .show("key", "Its name on a command line.", &MeasuredLaw::key)
      .show("sand", "The tested material.", &MeasuredLaw::sand)
      .show("source", "Key in validation/references.bib.", &MeasuredLaw::source)
      .show("formula", "In kPa, as in its source.", &MeasuredLaw::formula)
      .show("bias", "Law over measured, geometric mean over 38 clean sands [1].",
            [](const MeasuredLaw& l) { return l.record.bias; })
      .show("rms_log10", "Root mean square of log10 of law over measured, for the same sands [1].",
            [](const MeasuredLaw& l) { return l.record.rms_log10; });
  define_table(
      module, "measured_laws", sands::measured_laws(),
      {"Published laws of the small-strain shear modulus of sands, in the order of their years.",
       "dict of MeasuredLaw\n    By their keys.", "",
       "[HardinRichart1963] [Kokusho1980] [Jamiolkowski1991] [Menq2003] [WichtmannTriantafyllidis2009] "
       "[OztoprakBolton2013] [WangStokoe2022]",
       "sands::measured_laws", "sands/measured_sands.hpp"});
  define(module, "sand_shear_modulus",
         {required("law", "str", "A key of measured_laws()."), of_input(Input::void_ratio),
          of_input(Input::pressure).called("mean_stress"),
          column("uniformity", "C_u = d60/d10 >= 1 [1]; used by four laws.")
              .or_number(sands::SandState{}.uniformity),
          column("d50", "> 0 [m]; used by two laws.").or_number(sands::SandState{}.d50), strict_keyword()},
         {"Small-strain shear modulus of a sand by a published law.",
          "IsotropicModuli\n    Its notes report numbers outside of the tests of the law. The bulk modulus "
          "is NaN: "
          "the laws have none.",
          "For another law, a number out of range, or a void ratio beyond the law's zero.",
          "Under isotropic stress, clean sands. Sources: measured_laws().", "sands::shear_modulus",
          "sands/measured_sands.hpp"},
         [](const Arguments& a) {
           const MeasuredLaw& law = sands::measured_law(a.text(0));
           return rows_of(a, ModuliRow{}, [&law](const double* x, Notes& notes) {
             const sands::SandModulus found = sands::shear_modulus(
                 law, {.void_ratio = x[0], .mean_stress = x[1], .uniformity = x[2], .d50 = x[3]});
             notes.add(found.validity);
             return ModuliRow{.shear_modulus = found.shear_modulus};
           });
         });
}

} // namespace

void bind_sands(py::module_& module) {
  bind_known_sands(module);
  bind_measured_laws(module);
}

} // namespace granum::python
