// SPDX-License-Identifier: GPL-3.0-or-later
#include "material.hpp"

#include <deque>
#include <memory>
#include <stdexcept>
#include <vector>

#include <granum/elastic/isotropic.hpp>

#include "rows.hpp"

namespace granum::python {

namespace {

/// Poisson's ratio of the two moduli, which may be arrays.
py::object poisson_ratio_of(const Argument& bulk, const Argument& shear) {
  const Argument moduli[] = {bulk, shear};
  return computed(
      answer_rows<double>(moduli, true, 0.0,
                          [](const double* x, Notes&) {
                            return elastic::Isotropic::from_bulk_and_shear(x[0], x[1]).poisson_ratio();
                          }),
      [](double ratio) { return ratio; });
}

std::size_t place_of(const KeywordFunction& function, const std::string& name) {
  for (std::size_t k = 0; k < function.keywords.size(); ++k)
    if (function.keywords[k].name == name)
      return k;
  throw std::logic_error(std::string(function.name) + " has no " + name);
}

/// The last entry of the section Parameters.
void document(std::string& text, const Keyword& keyword, bool array) {
  const std::string::size_type end = text.find("\nReturns\n");
  text.insert(end, std::string(keyword.name) + " : " + (array ? "array_like" : "float") +
                       ", optional\n    K > 0 of the same solid [Pa], instead of Poisson's ratio.\n");
}

} // namespace

KeywordFunction with_bulk_modulus(KeywordFunction function, const std::string& prefix) {
  static auto& names = *new std::deque<std::string>; // keywords point to them
  const std::size_t shear_at = place_of(function, prefix + "shear_modulus");
  const std::size_t ratio_at = place_of(function, prefix + "poisson_ratio");
  const bool needed = function.keywords[ratio_at].shown_default == nullptr;
  function.keywords[ratio_at].shown_default = "None";
  function.keywords.push_back({names.emplace_back(prefix + "bulk_modulus").c_str(), "None"});
  document(function.documentation, function.keywords.back(),
           function.documentation.find("array_like") != std::string::npos);
  const std::size_t bulk_at = function.keywords.size() - 1;
  const auto inner = std::make_shared<KeywordFunction>(function);
  function.call = [inner, shear_at, ratio_at, bulk_at, needed](const Arguments& a) {
    const auto name = [&](std::size_t k) { return inner->keywords[k].name; };
    std::vector<PyObject*> values;
    for (std::size_t k = 0; k < inner->keywords.size(); ++k)
      values.push_back(a[k].ptr());
    py::object ratio;
    if (a.given(bulk_at)) {
      if (a.given(ratio_at))
        throw py::type_error(std::string(inner->name) + "() takes " + name(ratio_at) + " or " +
                             name(bulk_at) + ", not both");
      if (!a.given(shear_at))
        throw py::type_error(std::string(inner->name) + "() needs " + name(shear_at) + " with " +
                             name(bulk_at));
      ratio = poisson_ratio_of({name(bulk_at), a[bulk_at]}, {name(shear_at), a[shear_at]});
      values[ratio_at] = ratio.ptr();
    } else if (needed && values[ratio_at] == nullptr) {
      throw py::type_error(std::string(inner->name) + "() needs the keyword argument '" + name(ratio_at) +
                           "' or '" + name(bulk_at) + "'");
    }
    return inner->call(Arguments(*inner, values));
  };
  return function;
}

} // namespace granum::python
