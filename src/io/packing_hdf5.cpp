// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_hdf5.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <granum/core/error.hpp>
#include <hdf5.h>

namespace granum::io {

namespace {

constexpr const char* format = "granum packing";
constexpr const char* signs = "compression positive";

/// Something of HDF5 that is open.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0)
      close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Keeps HDF5 from printing its errors, as long as it lives.
class Silence {
 public:
  Silence() {
    H5Eget_auto2(H5E_DEFAULT, &printer_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, printer_, data_); }

 private:
  H5E_auto2_t printer_ = nullptr;
  void* data_ = nullptr;
};

/// The type of numbers in memory, and in files of any machine.
struct NumberType {
  hid_t memory;
  hid_t file;
};
NumberType type_of(const std::vector<double>&) { return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE}; }
NumberType type_of(const std::vector<std::int64_t>&) { return {H5T_NATIVE_INT64, H5T_STD_I64LE}; }
NumberType type_of(const std::vector<std::uint32_t>&) { return {H5T_NATIVE_UINT32, H5T_STD_U32LE}; }
NumberType type_of(const std::vector<std::uint8_t>&) { return {H5T_NATIVE_UINT8, H5T_STD_U8LE}; }

/// What every data set says of itself.
struct About {
  const char* name;
  const char* unit;
  const char* meaning;
};

Handle text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose};
}

/// A part of a file: its root, or a group.
class Part {
 public:
  Part(hid_t place, std::string path, std::string name)
      : place_(place), path_(std::move(path)), name_(std::move(name)) {}

  [[noreturn]] void fail(const std::string& what) const { throw FileError(path_, 0, name_ + what); }

 protected:
  void require(bool done, const std::string& what) const {
    if (!done)
      fail(what);
  }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& name() const { return name_; }

  hid_t place_;

 private:
  std::string path_;
  std::string name_; ///< "/" or "/contacts/"
};

class Writer : public Part {
 public:
  using Part::Part;

  void note(hid_t object, const char* attribute, const char* text) const {
    const Handle type = text_type(), space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle note(H5Acreate2(object, attribute, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    require(H5Awrite(note, type, &text) >= 0, attribute + std::string(" cannot be written"));
  }

  /// Rows of `width` numbers.
  template <class T>
  void column(const About& about, const std::vector<T>& values, hsize_t width) const {
    const hsize_t sizes[] = {values.size() / width, width};
    const Handle space(H5Screate_simple(width == 1 ? 1 : 2, sizes, nullptr), H5Sclose);
    const Handle set(
        H5Dcreate2(place_, about.name, type_of(values).file, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    require(H5Dwrite(set, type_of(values).memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0,
            about.name + std::string(" cannot be written"));
    note(set, "unit", about.unit);
    note(set, "meaning", about.meaning);
  }

  template <class Columns>
  void group(const char* group_name, const Columns& columns) const {
    const Handle group(H5Gcreate2(place_, group_name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    transfer(Writer(group, path(), name() + group_name + "/"), columns);
  }
};

class Reader : public Part {
 public:
  using Part::Part;

  [[nodiscard]] std::string note(hid_t object, const char* attribute) const {
    const Handle note(H5Aopen(object, attribute, H5P_DEFAULT), H5Aclose);
    if (note < 0)
      return "";
    const Handle type(H5Aget_type(note), H5Tclose), own = text_type();
    char* text = nullptr;
    if (H5Tis_variable_str(type) <= 0 || H5Aread(note, own, &text) < 0 || text == nullptr)
      return "";
    std::string out = text;
    H5free_memory(text);
    return out;
  }

  template <class T>
  void column(const About& about, std::vector<T>& values, hsize_t width) const {
    const std::string what = about.name;
    const Handle set(H5Dopen2(place_, about.name, H5P_DEFAULT), H5Dclose);
    require(set >= 0, what + ": expected such a data set");
    const Handle space(H5Dget_space(set), H5Sclose);
    const int rank = width == 1 ? 1 : 2;
    hsize_t sizes[] = {0, 1};
    require(H5Sget_simple_extent_ndims(space) == rank &&
                H5Sget_simple_extent_dims(space, sizes, nullptr) >= 0 && sizes[1] == width,
            what + ": expected rows of " + std::to_string(width) + " numbers");
    const std::string unit = note(set, "unit");
    require(unit == about.unit, what + ": expected the unit " + about.unit + ", found '" + unit + "'");
    values.resize(sizes[0] * width);
    require(H5Dread(set, type_of(values).memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0,
            what + ": the numbers cannot be read");
  }

  template <class Columns>
  void group(const char* group_name, Columns& columns) const {
    const Handle group(H5Gopen2(place_, group_name, H5P_DEFAULT), H5Gclose);
    require(group >= 0, group_name + std::string(": expected such a group"));
    transfer(Reader(group, path(), name() + group_name + "/"), columns);
  }
};

struct GrainColumns {
  std::vector<std::int64_t> id;
  std::vector<double> position, radius;
};

struct ContactColumns {
  std::vector<std::uint32_t> i, j;
  std::vector<double> branch, overlap, normal_force, tangential_force, normal_stiffness, tangential_stiffness;
  std::vector<std::uint8_t> sliding;
};

struct PackingColumns {
  std::vector<double> cell, time;
  std::vector<std::uint8_t> periodic;
  std::vector<std::int64_t> step;
  GrainColumns grains;
  ContactColumns contacts, wall_contacts;
};

// The layout of a file, to write it and to read it: `columns` is const for the one and not for the other.

template <class Columns, class Wanted>
concept As = std::same_as<std::remove_const_t<Columns>, Wanted>;

template <class Access, As<GrainColumns> Columns>
void transfer(const Access& part, Columns& c) {
  part.column({"id", "1", "number of the grain, ascending"}, c.id, 1);
  part.column({"position", "m", "centre"}, c.position, 3);
  part.column({"radius", "m", "radius"}, c.radius, 1);
}

template <class Access, As<ContactColumns> Columns>
void transfer(const Access& part, Columns& c) {
  part.column({"i", "1", "row of the first grain"}, c.i, 1);
  part.column({"j", "1", "row of the second grain, or number of the wall"}, c.j, 1);
  part.column({"branch", "m", "from the centre of i to that of j, nearest image, or to the wall"}, c.branch,
              3);
  part.column({"overlap", "m", "approach of the centres, all of it; at a wall that of the centre"}, c.overlap,
              1);
  part.column({"normal_force", "N", "compression positive"}, c.normal_force, 1);
  part.column({"tangential_force", "N", "exerted by i on j"}, c.tangential_force, 3);
  part.column({"normal_stiffness", "N/m", "tangent; 0 where not known"}, c.normal_stiffness, 1);
  part.column({"tangential_stiffness", "N/m", "tangent; 0 where not known"}, c.tangential_stiffness, 1);
  part.column({"sliding", "1", "1 at the Coulomb limit"}, c.sliding, 1);
}

template <class Access, As<PackingColumns> Columns>
void transfer(const Access& part, Columns& c) {
  part.column({"cell", "m", "one edge a row"}, c.cell, 3);
  part.column({"periodic", "1", "1 where the cell repeats along that edge"}, c.periodic, 1);
  part.column({"step", "1", "time step"}, c.step, 1);
  part.column({"time", "s", "none where it is not known"}, c.time, 1);
  part.group("grains", c.grains);
  part.group("contacts", c.contacts);
  part.group("wall_contacts", c.wall_contacts);
}

void append(std::vector<double>& numbers, const Vec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }

Vec3 vector_at(const std::vector<double>& numbers, std::size_t k) {
  return {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
}

ContactColumns columns_of(const std::vector<Contact>& contacts) {
  ContactColumns c;
  for (const Contact& contact : contacts) {
    c.i.push_back(contact.i);
    c.j.push_back(contact.j);
    append(c.branch, contact.branch);
    c.overlap.push_back(contact.overlap);
    c.normal_force.push_back(contact.normal_force);
    append(c.tangential_force, contact.tangential_force);
    c.normal_stiffness.push_back(contact.normal_stiffness);
    c.tangential_stiffness.push_back(contact.tangential_stiffness);
    c.sliding.push_back(contact.sliding ? 1 : 0);
  }
  return c;
}

PackingColumns columns_of(const ImportedPacking& packing) {
  PackingColumns c;
  const Assembly& a = packing.assembly;
  for (int k = 0; k < 3; ++k) {
    append(c.cell, column(a.cell, k));
    c.periodic.push_back(packing.periodic[static_cast<std::size_t>(k)] ? 1 : 0);
  }
  c.step = {packing.step};
  if (packing.time)
    c.time = {*packing.time};
  c.grains.id.assign(packing.id.begin(), packing.id.end());
  for (const Vec3& x : a.position)
    append(c.grains.position, x);
  c.grains.radius = a.radius;
  c.contacts = columns_of(a.contacts);
  c.wall_contacts = columns_of(a.wall_contacts);
  return c;
}

/// \throws   FileError unless all columns have as many rows
void require_rows(const Part& part, const char* group, std::size_t rows,
                  std::initializer_list<std::size_t> others) {
  if (std::ranges::any_of(others, [&](std::size_t other) { return other != rows; }))
    part.fail(std::string(group) + ": expected as many rows in all data sets");
}

std::vector<Contact> contacts_of(const Part& part, const char* group, const ContactColumns& c) {
  const std::size_t count = c.i.size();
  require_rows(part, group, count,
               {c.j.size(), c.branch.size() / 3, c.overlap.size(), c.normal_force.size(),
                c.tangential_force.size() / 3, c.normal_stiffness.size(), c.tangential_stiffness.size(),
                c.sliding.size()});
  std::vector<Contact> contacts;
  for (std::size_t k = 0; k < count; ++k)
    contacts.push_back({.i = c.i[k],
                        .j = c.j[k],
                        .branch = vector_at(c.branch, k),
                        .overlap = c.overlap[k],
                        .normal_force = c.normal_force[k],
                        .tangential_force = vector_at(c.tangential_force, k),
                        .normal_stiffness = c.normal_stiffness[k],
                        .tangential_stiffness = c.tangential_stiffness[k],
                        .sliding = c.sliding[k] != 0});
  const auto place = [](const Contact& contact) { return std::pair(contact.i, contact.j); };
  if (!std::ranges::is_sorted(contacts, {}, place))
    part.fail(std::string(group) + ": expected contacts in the order of (i, j)");
  return contacts;
}

ImportedPacking packing_of(const Part& part, const PackingColumns& c) {
  if (c.cell.size() != 9 || c.periodic.size() != 3 || c.step.size() != 1 || c.time.size() > 1)
    part.fail("expected cell and periodic of 3 rows, step of 1 and time of at most 1");
  ImportedPacking packing;
  Assembly& a = packing.assembly;
  for (int edge = 0; edge < 3; ++edge) {
    packing.periodic[static_cast<std::size_t>(edge)] = c.periodic[static_cast<std::size_t>(edge)] != 0;
    for (int k = 0; k < 3; ++k)
      a.cell(k, edge) = c.cell[static_cast<std::size_t>(3 * edge + k)];
  }
  packing.step = c.step[0];
  if (!c.time.empty())
    packing.time = c.time[0];
  packing.id.assign(c.grains.id.begin(), c.grains.id.end());
  require_rows(part, "grains", packing.id.size(), {c.grains.position.size() / 3, c.grains.radius.size()});
  if (std::ranges::adjacent_find(packing.id, std::greater_equal{}) != packing.id.end())
    part.fail("grains: expected ids in ascending order");
  for (std::size_t k = 0; k < packing.id.size(); ++k)
    a.position.push_back(vector_at(c.grains.position, k));
  a.radius = c.grains.radius;
  a.contacts = contacts_of(part, "contacts", c.contacts);
  a.wall_contacts = contacts_of(part, "wall_contacts", c.wall_contacts);
  try {
    require_valid(a);
  } catch (const InvalidArgument& error) {
    part.fail(error.what());
  }
  packing.notes = {{Finding::law_unknown, "contact law and grain material are not in the file"},
                   {Finding::history_unknown, "the loading history of the contacts is not in the file"}};
  return packing;
}

/// The bytes of a file that is made in memory.
std::string file_image(const std::string& path, const PackingColumns& columns) {
  constexpr std::size_t growth = std::size_t{1} << 20;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access, growth, 0);
  const Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  const Writer root(file, path, "/");
  root.note(file, "format", format);
  root.note(file, "signs", signs);
  transfer(root, columns);
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  std::string bytes(static_cast<std::size_t>(std::max<ssize_t>(size, 0)), '\0');
  if (size <= 0 || H5Fget_file_image(file, bytes.data(), bytes.size()) != size)
    root.fail(" cannot be made");
  return bytes;
}

} // namespace

void write_packing_hdf5(const std::filesystem::path& path, const ImportedPacking& packing,
                        Existing existing) {
  require_valid(packing.assembly);
  if (packing.id.size() != packing.assembly.grain_count())
    throw InvalidArgument("id has " + std::to_string(packing.id.size()) + " numbers for " +
                          std::to_string(packing.assembly.grain_count()) + " grains");
  const Silence silence;
  write_file(path, file_image(path.string(), columns_of(packing)), existing);
}

ImportedPacking read_packing_hdf5(const std::filesystem::path& path) {
  const Silence silence;
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (file < 0)
    throw FileError(path.string(), 0, "cannot be read: no HDF5 file, or damaged");
  const Reader root(file, path.string(), "/");
  if (const std::string found = root.note(file, "format"); found != format)
    root.fail(": expected the attribute format, '" + std::string(format) + "', found '" + found + "'");
  PackingColumns columns;
  transfer(root, columns);
  return packing_of(root, columns);
}

} // namespace granum::io
