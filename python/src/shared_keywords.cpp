// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared_keywords.hpp"

#include <algorithm>
#include <cmath>

#include <granum/core/text.hpp>
#include <granum/elastic/isotropic.hpp>

#include "rows.hpp"

namespace granum::python {

namespace {

/// ">= 0" or "in [0, 1]"; empty without limits. Ends far beyond all grains are none.
std::string limits_text(const estimate::Limits& limits) {
  constexpr double far_away = 100, nearly_zero = 1e-5;
  const bool above_zero = limits.low >= 0 && limits.low < nearly_zero;
  if (limits.high >= far_away)
    return !above_zero ? "" : limits.low > 0 || limits.without_low ? ", > 0" : ", >= 0";
  return std::string(", in ") + (limits.without_low ? "(" : "[") + short_text(limits.low) + ", " +
         short_text(limits.high) + (limits.without_high ? ")" : "]");
}

/// The meaning with names of arguments for those of options: "--void-ratio" is void_ratio here.
std::string meaning_of(const estimate::InputRow& row) {
  std::string text = row.meaning;
  for (const char* const of_question : {"; by default", ", such as", ", for "})
    text = text.substr(0, text.find(of_question));
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at)) {
    text.erase(at, 2);
    for (; at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '-');
         ++at)
      if (text[at] == '-')
        text[at] = '_';
  }
  return text;
}

} // namespace

Keyword of_input(estimate::Input input, std::string type) {
  const estimate::InputRow& row = estimate::row_of(input);
  const std::string unit(si_symbol(row.dimension));
  return required(std::string(row.name()), std::move(type),
                  meaning_of(row) + " [" + (unit.empty() ? "1" : unit) + "]" + limits_text(row.limits) + ".");
}

Keyword preparation_keyword() {
  return optional(
      "preparation", "str",
      "How beads were brought together, which determines contacts that are not given: \"dense\" "
      "(without\n    friction), \"dense:10kPa\" (without friction up to that pressure, > 0 and at "
      "most the mean stress, with\n    its unit, and then with friction: G is more accurate), "
      "\"loose\" (friction 0.3 to 0.5) or \"friction:0.3\"\n    (a coefficient > 0). By default "
      "unknown: the range covers all of them. Assumes that the stress was never\n    larger: a "
      "pressure above the mean stress is refused, because unloaded packings have other forces. "
      "Not used\n    by sands.");
}

Keyword law_keyword() {
  return required("law", "NormalLaw", "Normal contact of two grains, for instance from sphere().");
}

Keyword contact_means_keyword() {
  return optional("contact_means", "ContactMeans", "Means for unequal grains; default: equal grains.");
}

Keyword tangential_ratio_keyword(std::string type) {
  Keyword out = of_input(estimate::Input::tangential_ratio, std::move(type)).or_none();
  out.says += " Without it mindlin_stiffness_ratio of the law's material.";
  return out;
}

Keyword strict_keyword() {
  return with_default(
      "strict", "False", "bool",
      "Raise at the first element that is refused, instead of NaN and a message in `errors`.");
}

Keyword stiffness_keyword() {
  return required(
      "stiffness", "(..., 6, 6) array_like",
      "Voigt matrices, order 11 22 33 23 13 12, engineering shear strains [Pa]. Symmetric: both "
      "halves may differ by 1e-3 of the largest entry, as if they were rounded to four digits. An "
      "Estimate or an Isotropic may be given as it is.");
}

std::vector<Keyword> solid_keywords(const std::string& prefix, const std::string& solid,
                                    const std::string& type) {
  return {required(prefix + "shear_modulus", type, "G > 0 of the " + solid + " [Pa]."),
          required(prefix + "poisson_ratio", type, "nu of the " + solid + ", -1 < nu <= 0.5 [1].")};
}

KeywordFunction with_bulk_modulus(KeywordFunction function, const std::string& prefix) {
  const std::size_t shear_at = place_of(function, prefix + "shear_modulus");
  const std::size_t ratio_at = place_of(function, prefix + "poisson_ratio");
  const auto inner = std::make_shared<KeywordFunction>(function);
  Keyword& ratio_keyword = function.keywords[ratio_at];
  const bool needed = ratio_keyword.shown_default == nullptr;
  if (needed)
    ratio_keyword = ratio_keyword.or_none();
  const std::string type = ratio_keyword.type;
  function.keywords.push_back(
      {prefix + "bulk_modulus", "None", type, "K > 0 of the same solid [Pa], instead of Poisson's ratio."});
  function.call = [=](const Arguments& a) {
    const std::size_t bulk_at = inner->keywords.size();
    std::vector<PyObject*> values;
    for (std::size_t k = 0; k < bulk_at; ++k)
      values.push_back(a[k].ptr());
    py::object ratio;
    if (a.given(bulk_at)) {
      if (a.given(ratio_at))
        throw py::type_error(std::string(inner->name) + "() takes " + a.name(ratio_at) + " or " +
                             a.name(bulk_at) + ", not both");
      if (!a.given(shear_at))
        throw py::type_error(std::string(inner->name) + "() needs " + a.name(shear_at) + " with " +
                             a.name(bulk_at));
      const Argument moduli[] = {{a.name(bulk_at), a[bulk_at], "bulk_modulus"},
                                 {a.name(shear_at), a[shear_at], "shear_modulus"}};
      ratio = numbers_of_rows(moduli, [](const double* x) {
        return elastic::Isotropic::from_bulk_and_shear(x[0], x[1]).poisson_ratio();
      });
      values[ratio_at] = ratio.ptr();
    } else if (needed && values[ratio_at] == nullptr) {
      throw py::type_error(std::string(inner->name) + "() needs the keyword argument '" + a.name(ratio_at) +
                           "' or '" + a.name(bulk_at) + "'");
    }
    return inner->call(Arguments(*inner, values));
  };
  return function;
}

std::vector<Keyword> operator+(std::vector<Keyword> first, const std::vector<Keyword>& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

} // namespace granum::python
