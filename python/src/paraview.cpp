// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <string>
#include <vector>

#include "studies/analyse/grain_fields.hpp"
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>
#include <granum/io/vtk/paraview.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "functions.hpp"
#include "packing.hpp"

namespace granum::python {

namespace {

/// Numbers of grains that are given beside those that a packing has: (N,) or (N, components).
std::vector<io::GrainField> fields_of(const Packing& packing, const py::handle& given) {
  std::vector<io::GrainField> fields = io::grain_fields(packing.assembly, studies::known_forces(packing));
  if (given.is_none())
    return fields;
  for (const auto& [key, value] : given.cast<py::dict>()) {
    if (!py::isinstance<py::str>(key))
      throw py::type_error("write_vtk(): fields must be a dict of arrays by their names");
    const auto name = key.cast<std::string>();
    const py::array_t<double, py::array::c_style | py::array::forcecast> numbers =
        numbers_of(name.c_str(), value);
    const auto grains = static_cast<py::ssize_t>(packing.assembly.grain_count());
    if (numbers.ndim() < 1 || numbers.ndim() > 2 || numbers.shape(0) != grains)
      throw InvalidArgument(name + " has the shape " + shape_text(numbers) +
                            ", not (N,) or (N, M) with N = " + std::to_string(grains));
    std::erase_if(fields, [&](const io::GrainField& field) { return field.name == name; });
    fields.push_back({.name = name,
                      .components = numbers.ndim() == 1 ? 1 : static_cast<std::size_t>(numbers.shape(1)),
                      .values = {numbers.data(), numbers.data() + numbers.size()}});
  }
  return fields;
}

void write_vtk(const Arguments& a) {
  const auto& packing = a.as<const Packing&>(0);
  const auto path = a.as<std::filesystem::path>(1, "a path");
  const py::object fields = a.given(2) ? py::reinterpret_borrow<py::object>(a[2]) : py::object(py::none());
  if (!fields.is_none() && !py::isinstance<py::dict>(fields))
    throw py::type_error("write_vtk(): fields must be a dict of arrays");
  std::string text;
  if (path.extension() == ".vtu")
    text = io::grains_vtu(packing.assembly, packing.id, packing.time, fields_of(packing, fields));
  else if (path.extension() == ".vtp" && fields.is_none())
    text = io::contacts_vtp(packing.assembly, packing.id, studies::known_forces(packing));
  else
    throw InvalidArgument(path.extension() == ".vtp"
                              ? "fields are of grains: a .vtu has them, a .vtp contacts"
                              : "path must end in .vtu (grains) or .vtp (contacts)");
  io::write_file(path, text, io::Existing::replace);
}

} // namespace

void bind_paraview(py::module_& module) {
  define(
      module, "write_vtk",
      {required("packing", "Packing", "From read(), packing() or a simulation."),
       required("path", "path_like",
                "Its ending says what is written: .vtu the grains, .vtp the contacts as lines. An existing "
                "file is replaced."),
       optional("fields", "dict of array_like",
                "More numbers of the grains by name, (N,) or (N, M) [their units], such as results that were "
                "computed here. Default: radius, contacts, rattler, and what known forces give.")},
      {"Writes the grains or the contacts of a packing for ParaView.", "None",
       "For another ending, fields of another shape, and fields of contacts.",
       "ASCII, SI, with all digits: read() reads both files back. A glyph scaled with the radius shows "
       "grains "
       "as spheres, a tube of contacts by normal_force the force chains.",
       "io::grains_vtu", "io/vtk/paraview.hpp", "FileError\n    If the file cannot be written.\n"},
      [](const Arguments& a) {
        write_vtk(a);
        return py::none();
      },
      2);
}

} // namespace granum::python
