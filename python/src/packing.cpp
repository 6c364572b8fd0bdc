// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstring>
#include <deque>
#include <memory>

#include <granum/core/error.hpp>
#include <granum/io/arrays/packing.hpp>
#include <granum/io/lammps/arrays.hpp>
#include <granum/io/packing_files.hpp>
#include <granum/packing/assembly.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "members.hpp"
#include "packing.hpp"

namespace granum::python {

namespace {

using packing::Contact;

// ---- views of what a packing holds

/// Contacts of a packing, kept alive by `owner`.
struct Contacts {
  py::object owner;
  const std::vector<Contact>* list;
};

/// A member of all contacts, as an array.
template <class Number>
auto of_all(const Number Contact::*member) {
  return [member](const Contacts& c) { return member_view(*c.list, member, c.owner); };
}

py::array normals(const Contacts& c) {
  std::vector<Vec3> out;
  out.reserve(c.list->size());
  for (const Contact& contact : *c.list)
    out.push_back(packing::normal(contact));
  return array_of(out);
}

void bind_contacts(py::module_& module) {
  ResultClass<Contacts>(module, "Contacts",
                        "Contacts as arrays, sorted by (i, j). All vectors point from i to j.")
      .show("i", "First grain.", of_all(&Contact::i))
      .show("j", "Second grain, j > i; or the number of a wall.", of_all(&Contact::j))
      .show("branch", "Centre of j, its nearest image, minus centre of i [m], (N, 3).",
            of_all(&Contact::branch))
      .show("normal", "Unit vector of branch [1], (N, 3): what fabric is of.", &normals)
      .show("overlap", "Full approach, R_i + R_j - |branch| [m].", of_all(&Contact::overlap))
      .show("normal_force", "Compression positive [N].", of_all(&Contact::normal_force))
      .show("tangential_force", "Exerted by i on j [N], (N, 3).", of_all(&Contact::tangential_force))
      .show("normal_stiffness", "k_n [N/m]; 0 if unknown.", of_all(&Contact::normal_stiffness))
      .show("tangential_stiffness", "k_t [N/m].", of_all(&Contact::tangential_stiffness))
      .show("rolling_stiffness", "Moment over angle [N m].", of_all(&Contact::rolling_stiffness))
      .show("twisting_stiffness", "The same about the normal [N m].", of_all(&Contact::twisting_stiffness))
      .show("sliding", "Whether it is at the Coulomb limit.", of_all(&Contact::sliding))
      .def("__len__", [](const Contacts& c) { return c.list->size(); });
}

/// A view of a vector of the packing.
template <class Number>
py::array view_of(const std::vector<Number>& values, const py::object& self) {
  return view<Number>({static_cast<py::ssize_t>(values.size())}, {sizeof(Number)}, values.data(), self);
}

py::array positions(const py::object& self) {
  const auto& position = self.cast<const Packing&>().assembly.position;
  if (position.empty())
    return py::array_t<double>(std::vector<py::ssize_t>{0, 3});
  return view<double>({static_cast<py::ssize_t>(position.size()), 3}, {sizeof(Vec3), sizeof(double)},
                      &position.front().x, self);
}

py::list notes_of(const Packing& packing) {
  py::list out;
  for (const io::ImportNote& note : packing.notes)
    out.append(decoded(note.text));
  return out;
}

// ---- pickling: all members, plain memory as bytes

template <class Element>
py::bytes bytes_of(const std::vector<Element>& elements) {
  static_assert(std::is_trivially_copyable_v<Element>);
  return {reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element)};
}

template <class Element>
std::vector<Element> elements_of(const py::handle& bytes) {
  const std::string text = bytes.cast<std::string>();
  std::vector<Element> out(text.size() / sizeof(Element));
  std::memcpy(out.data(), text.data(), out.size() * sizeof(Element));
  return out;
}

py::tuple state_of(const Packing& p) {
  py::list notes;
  for (const io::ImportNote& note : p.notes)
    notes.append(py::make_tuple(static_cast<int>(note.finding), decoded(note.text)));
  const packing::Assembly& a = p.assembly;
  return py::make_tuple(sizeof(Contact), array_of(a.cell), bytes_of(a.position), bytes_of(a.radius),
                        bytes_of(a.contacts), bytes_of(a.wall_contacts), bytes_of(p.id), bytes_of(p.type),
                        p.periodic, p.step, p.time, notes, bytes_of(a.body));
}

SharedPacking from_state(const py::tuple& state) {
  if (state.size() != 13 || state[0].cast<std::size_t>() != sizeof(Contact))
    throw py::value_error("these bytes were written by another version of granum");
  auto out = std::make_shared<Packing>();
  packing::Assembly& a = out->assembly;
  a.cell = matrix_of("cell", state[1]);
  a.position = elements_of<Vec3>(state[2]);
  a.radius = elements_of<double>(state[3]);
  a.contacts = elements_of<Contact>(state[4]);
  a.wall_contacts = elements_of<Contact>(state[5]);
  out->id = elements_of<long>(state[6]);
  out->type = elements_of<long>(state[7]);
  out->periodic = state[8].cast<std::array<bool, 3>>();
  out->step = state[9].cast<long>();
  out->time = state[10].cast<std::optional<double>>();
  for (const auto& note : state[11])
    out->notes.push_back({static_cast<io::Finding>(note.cast<py::tuple>()[0].cast<int>()),
                          note.cast<py::tuple>()[1].cast<std::string>()});
  a.body = elements_of<std::uint32_t>(state[12]);
  require_valid(a);
  return out;
}

/// Properties that keep the packing alive.
void bind_views(ResultClass<Packing, SharedPacking>& type) {
  using Object = const py::object&;
  const auto show = [&type](const char* name, const char* says, const auto& of) {
    type.def_property_readonly(name, of, says);
  };
  show("position", "Centres [m], (N, 3).", &positions);
  show("radius", "[m], (N,).",
       [](Object self) { return view_of(self.cast<const Packing&>().assembly.radius, self); });
  show("contacts", "Between grains.", [](Object self) {
    return Contacts{self, &self.cast<const Packing&>().assembly.contacts};
  });
  show("wall_contacts", "Of grain i with wall j.", [](Object self) {
    return Contacts{self, &self.cast<const Packing&>().assembly.wall_contacts};
  });
  show("id", "Id of each grain in the files, or as it was given.",
       [](Object self) { return view_of(self.cast<const Packing&>().id, self); });
  show("type", "Type of each grain, if the files contain types; else empty.",
       [](Object self) { return view_of(self.cast<const Packing&>().type, self); });
  show("body", "Number of the rigid body of each grain, from 0; empty if each grain is its own body.",
       [](Object self) { return view_of(self.cast<const Packing&>().assembly.body, self); });
}

void bind_class(py::module_& module) {
  ResultClass<Packing, SharedPacking> type(module, "Packing", R"(Grains, contacts and their cell.

Arrays are read-only views of the memory of the packing. SI; compression is positive. Grains of files are
sorted by id, contacts by (i, j).)");
  bind_views(type);
  using packing::Assembly;
  type.show("cell", "Its columns are the three edges [m], (3, 3).", &Packing::assembly, &Assembly::cell)
      .show("periodic", "Whether the pairs of faces are periodic.",
            [](const Packing& p) { return py::tuple(py::cast(p.periodic)); })
      .show("volume", "Of the cell [m^3].", &Packing::assembly, &Assembly::volume)
      .show("void_ratio", "Volume of voids over that of grains, of the whole cell [1].",
            [](const Packing& p) { return packing::void_ratio(p.assembly); })
      .show("step", "Time step of the files; 0 without.", &Packing::step)
      .show("time", "[s]; None if the files do not contain it.", &Packing::time)
      .show("notes", "Assumptions and missing data, one sentence each.", &notes_of)
      .def("__len__", [](const Packing& p) { return p.assembly.grain_count(); })
      .def("__copy__", [](const SharedPacking& p) { return p; })
      .def("__deepcopy__",
           [](const SharedPacking& p, const py::object&) { return std::make_shared<Packing>(*p); })
      .def(
          "__eq__", [](const Packing& a, const Packing& b) { return a.assembly == b.assembly; },
          py::is_operator())
      .def(py::pickle(&state_of, &from_state))
      .def("__repr__", [](const Packing& p) {
        return "<Packing of " + std::to_string(p.assembly.grain_count()) + " grains, " +
               std::to_string(p.assembly.contacts.size()) + " contacts>";
      });
}

// ---- from arrays

/// Numbers of grains, as integers.
std::vector<std::array<long, 2>> pairs_of(const py::handle& value) {
  const py::array any = py::array::ensure(value);
  if (!any || (any.size() > 0 && any.dtype().kind() != 'i' && any.dtype().kind() != 'u')) {
    PyErr_Clear();
    throw py::type_error("contacts is not an array of integers, (N, 2)");
  }
  const py::array_t<long, py::array::c_style | py::array::forcecast> array(any);
  if (array.ndim() != 2 || array.shape(1) != 2)
    throw InvalidArgument("contacts has the shape " + shape_text(array) + ", not (N, 2)");
  std::vector<std::array<long, 2>> out(static_cast<std::size_t>(array.shape(0)));
  std::memcpy(out.data(), array.data(), out.size() * sizeof(out.front()));
  return out;
}

std::optional<Mat3> cell_of(const py::handle& value) {
  const py::array_t<double> array = numbers_of("cell", value);
  if (array.ndim() == 1) {
    const Vec3 edges = vector_of("cell", value);
    return Mat3::diagonal(edges.x, edges.y, edges.z);
  }
  return matrix_of("cell", value);
}

/// The arrays of a call, kept while the packing is built.
class GivenArrays {
 public:
  explicit GivenArrays(const Arguments& arguments) : arguments_(arguments) {}

  /// Empty where none was given.
  std::span<const double> numbers(const char* name) { return kept(name, numbers_); }
  std::span<const Vec3> vectors(const char* name) { return kept(name, vectors_); }

 private:
  template <class Value>
  std::span<const Value> kept(const char* name, std::deque<std::vector<Value>>& all) {
    return all.emplace_back(taken<std::optional<std::vector<Value>>>(arguments_, arguments_.at(name))
                                .value_or(std::vector<Value>()));
  }

  const Arguments& arguments_;
  std::deque<std::vector<double>> numbers_;
  std::deque<std::vector<Vec3>> vectors_;
};

std::vector<double> radii_of(const py::handle& value, std::size_t grains) {
  const py::array_t<double> radius = numbers_of("radius", value);
  return radius.ndim() == 0 ? std::vector<double>(grains, *radius.data()) : list_of("radius", radius);
}

py::object packing_from(const Arguments& a) {
  using Flags = py::array_t<bool, py::array::c_style | py::array::forcecast>;
  GivenArrays given(a);
  const std::vector<Vec3> position = vectors_of("position", a[a.at("position")]);
  const std::vector<double> radius = radii_of(a[a.at("radius")], position.size());
  io::PackingArrays arrays{.position = position, .radius = radius};
  if (a.given(a.at("cell")))
    arrays.cell = cell_of(a[a.at("cell")]);
  if (a.given(a.at("periodic")))
    arrays.periodic = a.as<std::array<bool, 3>>(a.at("periodic"), "three of True or False");
  std::vector<long> body;
  if (a.given(a.at("body")))
    body = a.as<std::vector<long>>(a.at("body"), "integers, one for each grain");
  arrays.body = body;
  std::vector<long> id;
  if (a.given(a.at("id")))
    id = a.as<std::vector<long>>(a.at("id"), "integers, one for each grain");
  arrays.id = id;
  std::vector<std::array<long, 2>> pairs;
  Flags sliding{0};
  if (a.given(a.at("contacts"))) {
    pairs = pairs_of(a[a.at("contacts")]);
    if (a.given(a.at("sliding")))
      sliding = a.as<Flags>(a.at("sliding"), "flags, one for each contact");
    const auto force = given.vectors("forces"); // in the order of the keywords
    arrays.contacts =
        io::ContactArrays{.grains = pairs,
                          .branch = given.vectors("branch"),
                          .overlap = given.numbers("overlap"),
                          .force = force,
                          .normal_force = given.numbers("normal_force"),
                          .tangential_force = given.vectors("tangential_force"),
                          .normal_stiffness = given.numbers("normal_stiffness"),
                          .tangential_stiffness = given.numbers("tangential_stiffness"),
                          .sliding = std::span(sliding.data(), static_cast<std::size_t>(sliding.size())),
                          .rolling_stiffness = given.numbers("rolling_stiffness"),
                          .twisting_stiffness = given.numbers("twisting_stiffness")};
  }
  return py::cast(unlocked([&] { return std::make_shared<Packing>(io::packing_of(arrays)); }));
}

std::vector<Keyword> packing_keywords() {
  const char *const of_contacts = "(M,) array_like", *const vectors = "(M, 3) array_like";
  return {
      required("position", "(N, 3) array_like", "Centres of the grains [m]."),
      required("radius", "float or (N,) array_like", "Radius of each grain, > 0 [m]."),
      optional("cell", "(3,) or (3, 3) array_like",
               "Edges of a rectangular cell, or a matrix with the edges as its columns [m]; without it the "
               "smallest rectangular box around the grains, not periodic."),
      with_default("periodic", "(True, True, True)", "(3,) sequence of bool",
                   "Which pairs of faces are periodic."),
      optional("contacts", "(M, 2) array_like of int",
               "Pairs of grains in contact, numbered from 0; a second number w < 0 is the wall -1 - w. "
               "Without it, the contacts of overlapping spheres are used where needed."),
      optional("forces", vectors, "Total force exerted by the first grain of each pair on the second [N]."),
      optional("branch", vectors,
               "Centre of the second grain minus centre of the first [m]; without it the nearest periodic "
               "image. For a wall, where it is required, from the centre to the wall."),
      optional("overlap", of_contacts, "Full approach of the centres [m]; without it from radii and branch."),
      optional("normal_force", of_contacts, "Normal force, instead of forces, compression positive [N]."),
      optional("tangential_force", vectors,
               "Together with normal_force: exerted by the first on the second [N]."),
      optional("normal_stiffness", of_contacts, ""),
      optional("tangential_stiffness", of_contacts, "k_n and k_t [N/m]."),
      optional("sliding", "(M,) array_like of bool", "Contacts at the Coulomb limit."),
      optional("rolling_stiffness", of_contacts, ""),
      optional("twisting_stiffness", of_contacts,
               "Moment over angle of contacts with resistance to rolling, and to twisting about the normal "
               "[N m]."),
      optional("body", "(N,) sequence of int",
               "Number of the rigid body (clump) of each grain; negative: none. Grains of one body move "
               "together; C_n, z*, rattlers and stress are those of bodies."),
      optional(
          "id", "(N,) sequence of int",
          "Id of each grain, no two the same; the order of the grains and the numbers in `contacts` stay "
          "those of the arrays. Default: from 0.")};
}

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
    for (; said_ < files_->replaced().size(); ++said_)
      warn(files_->replaced()[said_]);
    if (!packing && !files_->cut().empty())
      warn("the last frame is cut off and was left out: " + files_->cut());
    if (!packing)
      throw py::stop_iteration();
    return std::make_shared<Packing>(std::move(*packing));
  }
  [[nodiscard]] std::size_t skipped() const { return skipped_; }

 private:
  static void warn(const std::string& text) {
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0)
      throw py::error_already_set();
  }

  std::unique_ptr<io::PackingFiles> files_;
  std::size_t skipped_ = 0; ///< before the step that may be running
  std::size_t said_ = 0;    ///< of the frames that were left out
  bool running_ = false;
};

Frames open(const std::vector<std::filesystem::path>& files, const py::object& box,
            const std::map<std::string, std::string>& columns, const std::optional<std::string>& units) {
  io::PackingFileOptions options{.si = units.has_value()};
  if (units && *units != "si")
    throw InvalidArgument("units must be 'si' or None, not '" + *units + "'");
  options.columns.insert(columns.begin(), columns.end());
  if (!box.is_none()) {
    const Vec3 edges = vector_of("box", box);
    options.box = io::CsvBox{.cell = Mat3::diagonal(edges.x, edges.y, edges.z)};
  }
  const Unlocked unlocked;
  return Frames(std::make_unique<io::PackingFiles>(io::files_of_series(files), std::move(options)));
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

void bind_packing(py::module_& module) {
  bind_contacts(module);
  bind_class(module);
  define(module, "packing", packing_keywords(),
         {"A packing from the arrays of any code, checked and sorted like one from files.", "Packing", "", "",
          "io::packing_of", "io/arrays/packing.hpp",
          "InvalidArgument\n    Naming the array and its element: shapes, unknown grains, numbers that are "
          "not finite.\n"},
         &packing_from);
}

void bind_io(py::module_& module) {
  iterator_class<Frames>(module, "Frames",
                         "An iterator over the states in some files, with one state in memory at a time.")
      .show("skipped", "Frames skipped so far because another file has no frame of that time step.",
            &Frames::skipped);
  module.def("_frames", &open, py::arg("files"), py::arg("box"), py::arg("columns"), py::arg("units"));
  module.def("_lammps_packing", &lammps_packing, py::kw_only(), py::arg("id"), py::arg("position"),
             py::arg("radius"), py::arg("type"), py::arg("cell"), py::arg("periodic"), py::arg("units"),
             py::arg("step"), py::arg("column_names"), py::arg("values"), py::arg("columns"));
  define(module, "formats", {},
         {"Formats of packings that can be read.",
          "dict of str\n    By the name of a format: how its files are recognised.", "", "",
          "io::packing_formats", "io/packing_files.hpp"},
         [] {
           py::dict out;
           for (const io::PackingFormat* format : io::packing_formats)
             out[py::str(std::string(format->name))] = std::string(format->sign);
           return out;
         });
}

} // namespace granum::python
