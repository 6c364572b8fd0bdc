// SPDX-License-Identifier: GPL-3.0-or-later
#include "stacks.hpp"

#include <algorithm>

#include <granum/core/error.hpp>

namespace granum::python {

namespace {

/// The value itself, or the matrices of a result that has them: of an Estimate, an Isotropic.
py::object matrices_or(py::handle value) {
  return value && py::hasattr(value, "stiffness") ? py::object(value.attr("stiffness"))
                                                  : py::reinterpret_borrow<py::object>(value);
}

} // namespace

Stack::Stack(const Arguments& a, std::size_t keyword, const std::vector<py::ssize_t>& axes)
    : name_(a.name(keyword)), numbers_(numbers_of(name_, matrices_or(a[keyword]))) {
  const auto last = static_cast<py::ssize_t>(axes.size());
  const py::ssize_t before = numbers_.ndim() - last;
  if (before < 0 || !std::equal(axes.begin(), axes.end(), numbers_.shape() + before)) {
    std::string expected = "(...";
    for (const py::ssize_t length : axes)
      expected += ", " + std::to_string(length);
    throw InvalidArgument(std::string(name_) + " has the shape " + shape_text(numbers_) + ", not " +
                          expected + ")");
  }
  for (const py::ssize_t length : axes)
    size_ *= static_cast<std::size_t>(length);
  if (before == 0)
    return;
  py::array_t<double> places(std::vector<py::ssize_t>(numbers_.shape(), numbers_.shape() + before));
  for (py::ssize_t k = 0; k < places.size(); ++k)
    places.mutable_data()[k] = static_cast<double>(k);
  places_ = std::move(places);
}

Argument Stack::column() const {
  return places_ ? Argument{name_, py::handle(places_)} : Argument{name_, 0.0};
}

elastic::VoigtStiffness stiffness_at(const double* numbers) {
  elastic::VoigtStiffness out;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out.matrix(i, j) = numbers[6 * i + j];
  return out;
}

py::array matrices_of(const std::vector<py::ssize_t>& shape, const std::vector<elastic::Matrix6>& all) {
  std::vector<py::ssize_t> of_all = shape;
  of_all.insert(of_all.end(), {6, 6});
  py::array_t<double> out(of_all);
  double* to = out.mutable_data();
  for (std::size_t k = 0; k < all.size(); ++k) {
    hear_signals(k);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        *to++ = all[k](i, j);
  }
  return out;
}

} // namespace granum::python
