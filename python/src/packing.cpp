// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing.hpp"

#include <pybind11/stl.h>

#include <cstring>

#include <granum/core/error.hpp>
#include <granum/io/arrays/packing.hpp>
#include <granum/packing/density.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "members.hpp"

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
  show("id", "Id of each grain in the files.",
       [](Object self) { return view_of(self.cast<const Packing&>().id, self); });
  show("type", "Type of each grain, if the files contain types; else empty.",
       [](Object self) { return view_of(self.cast<const Packing&>().type, self); });
  show("body", "Number of the rigid body of each grain, from 0; empty if each grain is its own body.",
       [](Object self) { return view_of(self.cast<const Packing&>().assembly.body, self); });
}

void bind_class(py::module_& module) {
  ResultClass<Packing, SharedPacking> type(module, "Packing", R"(Grains, contacts and their cell.

Arrays are read-only views of the memory of the packing. SI; compression is positive. Grains are sorted by id,
contacts by (i, j).)");
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

template <class Value>
void take(const Arguments& a, std::size_t at, std::vector<Value>& to) {
  if (a.given(at))
    to = taken<std::vector<Value>>(a, at);
}

void take_contacts(const Arguments& a, GivenArrays& to) {
  to.contacts = pairs_of(a[contacts_at]);
  take(a, forces_at, to.force);
  take(a, branch_at, to.branch);
  take(a, overlap_at, to.overlap);
  take(a, normal_force_at, to.normal_force);
  take(a, tangential_force_at, to.tangential_force);
  take(a, normal_stiffness_at, to.normal_stiffness);
  take(a, tangential_stiffness_at, to.tangential_stiffness);
  take(a, rolling_stiffness_at, to.rolling_stiffness);
  take(a, twisting_stiffness_at, to.twisting_stiffness);
  if (a.given(sliding_at))
    to.sliding = py::reinterpret_borrow<py::object>(a[sliding_at]);
}

py::object packing_from(const Arguments& a) {
  GivenArrays given;
  take(a, position_at, given.position);
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

std::vector<Keyword> packing_keywords() {
  const char *const of_contacts = "(M,) array_like", *const vectors = "(M, 3) array_like";
  return {
      required("position", "(N, 3) array_like", "Centres of the grains [m]."),
      required("radius", "float or (N,) array_like", "Radius of each grain, > 0 [m]."),
      optional("cell", "(3,) or (3, 3) array_like",
               "Edges of a rectangular cell, or a matrix with the edges as its columns [m]; without it the "
               "smallest\n"
               "    rectangular box around the grains, not periodic."),
      with_default("periodic", "(True, True, True)", "(3,) sequence of bool",
                   "Which pairs of faces are periodic."),
      optional("contacts", "(M, 2) array_like of int",
               "Pairs of grains in contact, numbered from 0; a second number w < 0 is the wall -1 - w. "
               "Without it,\n"
               "    the contacts of overlapping spheres are used where needed."),
      optional("forces", vectors, "Total force exerted by the first grain of each pair on the second [N]."),
      optional("branch", vectors,
               "Centre of the second grain minus centre of the first [m]; without it the nearest periodic "
               "image. For\n"
               "    a wall, where it is required, from the centre to the wall."),
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
               "together;\n"
               "    C_n, z*, rattlers and stress are those of bodies.")};
}

} // namespace

void bind_packing(py::module_& module) {
  bind_contacts(module);
  bind_class(module);
  define(
      module, "packing", packing_keywords(),
      {"A packing from the arrays of any code, checked and sorted like one from files.", "Packing", "", "",
       "io::packing_of", "io/arrays/packing.hpp",
       "InvalidArgument\n    Naming the array and its element: shapes, unknown grains, numbers that are not "
       "finite.\n"},
      &packing_from);
}

} // namespace granum::python
