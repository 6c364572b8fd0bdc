// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing.hpp"

#include <pybind11/stl.h>

#include <cstring>

#include <granum/core/error.hpp>
#include <granum/io/arrays/packing.hpp>
#include <granum/packing/density.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "errors.hpp"
#include "keywords.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using packing::Contact;

// ---- views of what a packing holds

/// Contacts of a packing, kept alive by `owner`.
struct Contacts {
  py::object owner;
  const std::vector<Contact>* list;
};

template <class Number>
void show_contact(py::class_<Contacts>& type, const char* name, const Number Contact::*member,
                  const char* documentation) {
  type.def_property_readonly(
      name, [member](const Contacts& c) { return member_view(*c.list, member, c.owner); }, documentation);
}

void bind_contacts(py::module_& module) {
  py::class_<Contacts> type(module, "Contacts",
                            "Contacts as arrays, sorted by (i, j). All vectors point from i to j.");
  type.def("__len__", [](const Contacts& c) { return c.list->size(); });
  show_contact(type, "i", &Contact::i, "First grain.");
  show_contact(type, "j", &Contact::j, "Second grain, j > i; or the number of a wall.");
  show_contact(type, "branch", &Contact::branch,
               "Centre of j, its nearest image, minus centre of i [m], (N, 3).");
  type.def_property_readonly(
      "normal",
      [](const Contacts& c) {
        std::vector<Vec3> normals;
        normals.reserve(c.list->size());
        for (const Contact& contact : *c.list)
          normals.push_back(packing::normal(contact));
        return array_of(normals);
      },
      "Unit vector of branch [1], (N, 3): what fabric is of.");
  show_contact(type, "overlap", &Contact::overlap, "Full approach, R_i + R_j - |branch| [m].");
  show_contact(type, "normal_force", &Contact::normal_force, "Compression positive [N].");
  show_contact(type, "tangential_force", &Contact::tangential_force, "Exerted by i on j [N], (N, 3).");
  show_contact(type, "normal_stiffness", &Contact::normal_stiffness, "k_n [N/m]; 0 if unknown.");
  show_contact(type, "tangential_stiffness", &Contact::tangential_stiffness, "k_t [N/m].");
  show_contact(type, "rolling_stiffness", &Contact::rolling_stiffness, "Moment over angle [N m].");
  show_contact(type, "twisting_stiffness", &Contact::twisting_stiffness, "The same about the normal [N m].");
  show_contact(type, "sliding", &Contact::sliding, "Whether it is at the Coulomb limit.");
}

py::array positions(const py::object& self) {
  const auto& position = self.cast<const Packing&>().assembly.position;
  if (position.empty())
    return py::array_t<double>(std::vector<py::ssize_t>{0, 3});
  return view<double>({static_cast<py::ssize_t>(position.size()), 3}, {sizeof(Vec3), sizeof(double)},
                      &position.front().x, self);
}

py::array radii(const py::object& self) {
  const auto& radius = self.cast<const Packing&>().assembly.radius;
  return view<double>({static_cast<py::ssize_t>(radius.size())}, {sizeof(double)}, radius.data(), self);
}

py::array longs(const std::vector<long>& values, const py::object& self) {
  return view<long>({static_cast<py::ssize_t>(values.size())}, {sizeof(long)}, values.data(), self);
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

void bind_class(py::module_& module) {
  py::class_<Packing, SharedPacking>(module, "Packing", R"(Grains, contacts and their cell.

Arrays are read-only views of the memory of the packing. SI; compression is positive. Grains are sorted by id,
contacts by (i, j).)")
      .def_property_readonly("position", &positions, "Centres [m], (N, 3).")
      .def_property_readonly("radius", &radii, "[m], (N,).")
      .def_property_readonly(
          "cell", [](const Packing& p) { return array_of(p.assembly.cell); },
          "Its columns are the three edges [m], (3, 3).")
      .def_property_readonly(
          "periodic", [](const Packing& p) { return py::tuple(py::cast(p.periodic)); },
          "Whether the pairs of faces are periodic.")
      .def_property_readonly(
          "contacts",
          [](const py::object& self) {
            return Contacts{self, &self.cast<const Packing&>().assembly.contacts};
          },
          "Between grains.")
      .def_property_readonly(
          "wall_contacts",
          [](const py::object& self) {
            return Contacts{self, &self.cast<const Packing&>().assembly.wall_contacts};
          },
          "Of grain i with wall j.")
      .def_property_readonly(
          "volume", [](const Packing& p) { return p.assembly.volume(); }, "Of the cell [m^3].")
      .def_property_readonly(
          "void_ratio", [](const Packing& p) { return packing::void_ratio(p.assembly); },
          "Volume of voids over that of grains, of the whole cell [1].")
      .def_property_readonly(
          "id", [](const py::object& self) { return longs(self.cast<const Packing&>().id, self); },
          "Id of each grain in the files.")
      .def_property_readonly(
          "type", [](const py::object& self) { return longs(self.cast<const Packing&>().type, self); },
          "Type of each grain, if the files contain types; else empty.")
      .def_property_readonly(
          "body",
          [](const py::object& self) {
            const auto& body = self.cast<const Packing&>().assembly.body;
            return view<std::uint32_t>({static_cast<py::ssize_t>(body.size())}, {sizeof(std::uint32_t)},
                                       body.data(), self);
          },
          "Number of the rigid body of each grain, from 0; empty if each grain is its own body.")
      .def_readonly("step", &Packing::step, "Time step of the files; 0 without.")
      .def_readonly("time", &Packing::time, "[s]; None if the files do not contain it.")
      .def_property_readonly("notes", &notes_of, "Assumptions and missing data, one sentence each.")
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

/// Copies of the arrays of a call, kept while the packing is built.
struct GivenArrays {
  std::vector<Vec3> position, branch, force, tangential_force;
  std::vector<double> radius, overlap, normal_force, normal_stiffness, tangential_stiffness,
      rolling_stiffness, twisting_stiffness;
  std::vector<long> body;
  std::vector<std::array<long, 2>> contacts;
  py::array_t<bool, py::array::c_style | py::array::forcecast> sliding{0};
};

enum : std::size_t {
  position_at,
  radius_at,
  cell_at,
  periodic_at,
  contacts_at,
  forces_at,
  branch_at,
  overlap_at,
  normal_force_at,
  tangential_force_at,
  normal_stiffness_at,
  tangential_stiffness_at,
  sliding_at,
  rolling_stiffness_at,
  twisting_stiffness_at,
  body_at,
};

void take(const Arguments& a, std::size_t at, const char* name, std::vector<double>& to) {
  if (a.given(at))
    to = list_of(name, a[at]);
}
void take(const Arguments& a, std::size_t at, const char* name, std::vector<Vec3>& to) {
  if (a.given(at))
    to = vectors_of(name, a[at]);
}

void take_contacts(const Arguments& a, GivenArrays& to) {
  to.contacts = pairs_of(a[contacts_at]);
  take(a, forces_at, "forces", to.force);
  take(a, branch_at, "branch", to.branch);
  take(a, overlap_at, "overlap", to.overlap);
  take(a, normal_force_at, "normal_force", to.normal_force);
  take(a, tangential_force_at, "tangential_force", to.tangential_force);
  take(a, normal_stiffness_at, "normal_stiffness", to.normal_stiffness);
  take(a, tangential_stiffness_at, "tangential_stiffness", to.tangential_stiffness);
  take(a, rolling_stiffness_at, "rolling_stiffness", to.rolling_stiffness);
  take(a, twisting_stiffness_at, "twisting_stiffness", to.twisting_stiffness);
  if (a.given(sliding_at))
    to.sliding = py::reinterpret_borrow<py::object>(a[sliding_at]);
}

py::object packing_from(const Arguments& a) {
  GivenArrays given;
  take(a, position_at, "position", given.position);
  if (py::array_t<double> radius = numbers_of("radius", a[radius_at]); radius.ndim() == 0)
    given.radius.assign(given.position.size(), *radius.data());
  else
    given.radius = list_of("radius", radius);
  io::PackingArrays arrays{.position = given.position, .radius = given.radius};
  if (a.given(cell_at))
    arrays.cell = cell_of(a[cell_at]);
  if (a.given(periodic_at))
    arrays.periodic = a.as<std::array<bool, 3>>(periodic_at, "three of True or False");
  if (a.given(body_at)) {
    given.body = a.as<std::vector<long>>(body_at, "integers, one for each grain");
    arrays.body = given.body;
  }
  if (a.given(contacts_at)) {
    take_contacts(a, given);
    arrays.contacts = io::ContactArrays{
        .grains = given.contacts,
        .branch = given.branch,
        .overlap = given.overlap,
        .force = given.force,
        .normal_force = given.normal_force,
        .tangential_force = given.tangential_force,
        .normal_stiffness = given.normal_stiffness,
        .tangential_stiffness = given.tangential_stiffness,
        .sliding = std::span(given.sliding.data(), static_cast<std::size_t>(given.sliding.size())),
        .rolling_stiffness = given.rolling_stiffness,
        .twisting_stiffness = given.twisting_stiffness};
  }
  auto out = std::make_shared<Packing>();
  {
    const Unlocked unlocked;
    *out = io::packing_of(arrays);
  }
  return py::cast(out);
}

} // namespace

void bind_packing(py::module_& module) {
  bind_contacts(module);
  bind_class(module);
  define(module,
         {"packing",
          {{"position"},
           {"radius"},
           {"cell", "None"},
           {"periodic", "(True, True, True)"},
           {"contacts", "None"},
           {"forces", "None"},
           {"branch", "None"},
           {"overlap", "None"},
           {"normal_force", "None"},
           {"tangential_force", "None"},
           {"normal_stiffness", "None"},
           {"tangential_stiffness", "None"},
           {"sliding", "None"},
           {"rolling_stiffness", "None"},
           {"twisting_stiffness", "None"},
           {"body", "None"}},
          &packing_from,
          std::string() + R"(A packing from the arrays of any code, checked and sorted like one from files.

Parameters
----------
position : (N, 3) array_like
    Centres of the grains [m].
radius : float or (N,) array_like
    Radius of each grain, > 0 [m].
cell : (3,) or (3, 3) array_like, optional
    Edges of a rectangular cell, or a matrix with the edges as its columns [m]; without it the smallest
    rectangular box around the grains, not periodic.
periodic : (3,) sequence of bool
    Which pairs of faces are periodic.
contacts : (M, 2) array_like of int, optional
    Pairs of grains in contact, numbered from 0; a second number w < 0 is the wall -1 - w. Without it, the
    contacts of overlapping spheres are used where needed.
forces : (M, 3) array_like, optional
    Total force exerted by the first grain of each pair on the second [N].
branch : (M, 3) array_like, optional
    Centre of the second grain minus centre of the first [m]; without it the nearest periodic image. For a
    wall, where it is required, from the centre to the wall.
overlap : (M,) array_like, optional
    Full approach of the centres [m]; without it from radii and branch.
normal_force : (M,) array_like, optional
    Normal force, instead of forces, compression positive [N].
tangential_force : (M, 3) array_like, optional
    Together with normal_force: exerted by the first on the second [N].
normal_stiffness, tangential_stiffness : (M,) array_like, optional
    k_n and k_t [N/m].
sliding : (M,) array_like of bool, optional
    Contacts at the Coulomb limit.
rolling_stiffness, twisting_stiffness : (M,) array_like, optional
    Moment over angle of contacts with resistance to rolling, and to twisting about the normal [N m].
body : (N,) sequence of int, optional
    Number of the rigid body (clump) of each grain; negative: none. Grains of one body move together; C_n, z*,
    rattlers and stress are those of bodies.

Returns
-------
Packing

Raises
------
InvalidArgument
    Naming the array and its element: shapes, unknown grains, numbers that are not finite.
)" + notes("", "io::packing_of", "io/arrays/packing.hpp")});
}

} // namespace granum::python
