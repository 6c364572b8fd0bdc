// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include <granum/io/packing_files.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "packing.hpp"

namespace granum::python {

namespace {

/// The states of some files, one after the other.
class Frames {
 public:
  explicit Frames(std::unique_ptr<io::PackingFiles> files) : files_(std::move(files)) {}

  SharedPacking next() {
    std::optional<Packing> packing;
    {
      const py::gil_scoped_release unlocked;
      packing = files_->next();
    }
    if (!packing)
      throw py::stop_iteration();
    return std::make_shared<Packing>(std::move(*packing));
  }
  [[nodiscard]] std::size_t skipped() const { return files_->skipped(); }

 private:
  std::unique_ptr<io::PackingFiles> files_;
};

Frames open(const std::vector<std::filesystem::path>& files, const py::object& box,
            const std::map<std::string, std::string>& columns) {
  io::PackingFileOptions options;
  options.columns.insert(columns.begin(), columns.end());
  if (!box.is_none()) {
    const Vec3 edges = vector_of("box", box);
    options.box = io::CsvBox{.cell = Mat3::diagonal(edges.x, edges.y, edges.z)};
  }
  const py::gil_scoped_release unlocked;
  return Frames(std::make_unique<io::PackingFiles>(files, std::move(options)));
}

} // namespace

void bind_io(py::module_& module) {
  py::class_<Frames>(module, "Frames",
                     "The states of some files, one after the other; in memory no more than one.")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &Frames::next)
      .def_property_readonly("skipped", &Frames::skipped,
                             "Frames passed over so far because another file has none of that time step.");
  module.def("_frames", &open, py::arg("files"), py::arg("box"), py::arg("columns"));
  module.def(
      "formats",
      [] {
        py::dict out;
        for (const io::PackingFormat* format : io::packing_formats)
          out[py::str(std::string(format->name))] = std::string(format->sign);
        return out;
      },
      "Formats of packings that are read, and what their files are told by.");
}

} // namespace granum::python
