// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include <granum/io/lammps/arrays.hpp>
#include <granum/io/packing_files.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "members.hpp"
#include "packing.hpp"

namespace granum::python {

namespace {

/// The states in some files, in order.
class Frames {
 public:
  explicit Frames(std::unique_ptr<io::PackingFiles> files) : files_(std::move(files)) {}

  SharedPacking next() {
    const OneStep step(running_);
    std::optional<Packing> packing;
    {
      const Unlocked unlocked;
      packing = files_->next();
    }
    skipped_ = files_->skipped();
    if (!packing)
      throw py::stop_iteration();
    return std::make_shared<Packing>(std::move(*packing));
  }
  [[nodiscard]] std::size_t skipped() const { return skipped_; }

 private:
  std::unique_ptr<io::PackingFiles> files_;
  std::size_t skipped_ = 0; ///< before the step that may be running
  bool running_ = false;
};

Frames open(const std::vector<std::filesystem::path>& files, const py::object& box,
            const std::map<std::string, std::string>& columns) {
  io::PackingFileOptions options;
  options.columns.insert(columns.begin(), columns.end());
  if (!box.is_none()) {
    const Vec3 edges = vector_of("box", box);
    options.box = io::CsvBox{.cell = Mat3::diagonal(edges.x, edges.y, edges.z)};
  }
  const Unlocked unlocked;
  return Frames(std::make_unique<io::PackingFiles>(files, std::move(options)));
}

// ---- out of LAMMPS' memory

std::vector<long> integers_of(const py::array_t<long, py::array::c_style | py::array::forcecast>& array) {
  return {array.data(), array.data() + array.size()};
}

/// What from_lammps of the package collects.
SharedPacking lammps_packing(const py::array_t<long, py::array::c_style | py::array::forcecast>& id,
                             const py::object& position, const py::object& radius,
                             const py::array_t<long, py::array::c_style | py::array::forcecast>& type,
                             const py::object& cell, const std::array<bool, 3>& periodic,
                             const std::string& units, long step,
                             const std::optional<std::vector<std::string>>& column_names,
                             const py::array_t<double, py::array::c_style>& values,
                             const std::map<std::string, std::string>& columns) {
  const std::vector<long> ids = integers_of(id), types = integers_of(type);
  const std::vector<Vec3> positions = vectors_of("position", position);
  const std::vector<double> radii = list_of("radius", radius);
  io::LammpsArrays arrays{.id = ids,
                          .position = positions,
                          .radius = radii,
                          .type = types,
                          .cell = matrix_of("cell", cell),
                          .periodic = periodic,
                          .units = units,
                          .step = step};
  if (column_names)
    arrays.contacts =
        io::LammpsLocals{.columns = *column_names,
                         .values = std::span(values.data(), static_cast<std::size_t>(values.size())),
                         .map = {columns.begin(), columns.end()}};
  const Unlocked unlocked;
  return std::make_shared<Packing>(io::lammps_packing(arrays));
}

} // namespace

void bind_io(py::module_& module) {
  ResultClass<Frames>(module, "Frames",
                      "An iterator over the states in some files, with one state in memory at a time.")
      .show("skipped", "Frames skipped so far because another file has no frame of that time step.",
            &Frames::skipped)
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &Frames::next);
  module.def("_frames", &open, py::arg("files"), py::arg("box"), py::arg("columns"));
  module.def("_lammps_packing", &lammps_packing, py::kw_only(), py::arg("id"), py::arg("position"),
             py::arg("radius"), py::arg("type"), py::arg("cell"), py::arg("periodic"), py::arg("units"),
             py::arg("step"), py::arg("column_names"), py::arg("values"), py::arg("columns"));
  define(module, "formats", {},
         {"Formats of packings that can be read.",
          "dict of str\n    By the name of a format: how its files are recognised.", "", "",
          "io::packing_formats", "io/packing_format.hpp"},
         [] {
           py::dict out;
           for (const io::PackingFormat* format : io::packing_formats)
             out[py::str(std::string(format->name))] = std::string(format->sign);
           return out;
         });
}

} // namespace granum::python
