// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/packing_hdf5.hpp>

#include <fstream>
#include <functional>
#include <string>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <hdf5.h>

#include "io/temporary_folder.hpp"
#include "sample.hpp"

using namespace granum;
using namespace granum::io;

namespace {

bool same(const ImportedPacking& a, const ImportedPacking& b) {
  return a.assembly == b.assembly && a.id == b.id && a.periodic == b.periodic && a.step == b.step &&
         a.time == b.time;
}

/// What reading says of the sample's file after a change by HDF5 itself.
std::string refused(const std::function<void(hid_t file)>& change) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "packing.h5";
  write_packing_hdf5(path, samples::hdf5_sample(), Existing::keep);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  REQUIRE(file >= 0);
  change(file);
  H5Fclose(file);
  try {
    (void)read_packing_hdf5(path);
  } catch (const FileError& error) {
    const std::string text = error.what();
    CHECK(text.starts_with(path.string() + ": "));
    return text.substr(path.string().size() + 2);
  }
  return "";
}

std::string without(const char* name) {
  return refused([&](hid_t file) { H5Ldelete(file, name, H5P_DEFAULT); });
}

/// The first number of a data set, or its first row, replaced.
std::string with_numbers(const char* name, hid_t type, const void* numbers) {
  return refused([&](hid_t file) {
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
    REQUIRE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers) >= 0);
    H5Dclose(set);
  });
}

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

} // namespace

TEST_CASE("a packing comes back to the bit") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "packing.h5";
  const ImportedPacking sample = samples::hdf5_sample();
  write_packing_hdf5(path, sample, Existing::keep);
  const ImportedPacking back = read_packing_hdf5(path);
  CHECK(same(back, sample));
  CHECK((back.has(Finding::law_unknown) && back.has(Finding::history_unknown)));
  CHECK_THROWS_AS(write_packing_hdf5(path, sample, Existing::keep), FileError);
  ImportedPacking other = sample;
  other.assembly.contacts.clear();
  other.assembly.wall_contacts.clear();
  other.time.reset();
  write_packing_hdf5(path, other, Existing::replace);
  CHECK(same(read_packing_hdf5(path), other));
}

TEST_CASE("a packing that is none is not written") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "packing.h5";
  ImportedPacking sample = samples::hdf5_sample();
  sample.id.pop_back();
  CHECK_THROWS_WITH_AS(write_packing_hdf5(path, sample, Existing::keep), "id has 2 numbers for 3 grains",
                       InvalidArgument);
  sample = samples::hdf5_sample();
  sample.assembly.radius[0] = 0;
  CHECK_THROWS_AS(write_packing_hdf5(path, sample, Existing::keep), InvalidArgument);
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("what is no such file is refused with its path") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "words";
  std::ofstream(path) << "Lorem ipsum\n";
  CHECK_THROWS_WITH_AS((void)read_packing_hdf5(path),
                       (path.string() + ": cannot be read: no HDF5 file, or damaged").c_str(), FileError);
  CHECK_THROWS_AS((void)read_packing_hdf5(folder.path() / "none"), FileError);
}

TEST_CASE("each data set that is missing or wrong is refused by name") {
  for (const char* group : {"/contacts/", "/wall_contacts/"})
    for (const char* name : {"i", "j", "branch", "overlap", "normal_force", "tangential_force",
                             "normal_stiffness", "tangential_stiffness", "sliding"})
      CHECK(without((std::string(group) + name).c_str()) ==
            std::string(group) + name + ": expected such a data set");
  for (const char* name :
       {"/cell", "/periodic", "/step", "/time", "/grains/id", "/grains/position", "/grains/radius"})
    CHECK(without(name) == std::string(name) + ": expected such a data set");
  for (const char* name : {"grains", "contacts", "wall_contacts"})
    CHECK(without(name) == "/" + std::string(name) + ": expected such a group");
  CHECK(holds(refused([](hid_t file) { H5Adelete(file, "format"); }), "expected the attribute format"));
  CHECK(refused([](hid_t file) { H5Adelete_by_name(file, "/grains/radius", "unit", H5P_DEFAULT); }) ==
        "/grains/radius: expected the unit m, found ''");
  // radii with a row too few, and as a table
  for (const hsize_t columns : {hsize_t{1}, hsize_t{2}})
    CHECK(holds(refused([&](hid_t file) {
                  H5Lmove(file, "/grains/radius", file, "/old", H5P_DEFAULT, H5P_DEFAULT);
                  const hsize_t sizes[] = {2, columns};
                  const hid_t space = H5Screate_simple(columns == 1 ? 1 : 2, sizes, nullptr);
                  const hid_t set = H5Dcreate2(file, "/grains/radius", H5T_IEEE_F64LE, space, H5P_DEFAULT,
                                               H5P_DEFAULT, H5P_DEFAULT);
                  const hid_t old = H5Dopen2(file, "/old", H5P_DEFAULT);
                  const hid_t from = H5Aopen(old, "unit", H5P_DEFAULT);
                  const hid_t type = H5Aget_type(from), scalar = H5Screate(H5S_SCALAR);
                  const hid_t to = H5Acreate2(set, "unit", type, scalar, H5P_DEFAULT, H5P_DEFAULT);
                  const char* unit = "m";
                  H5Awrite(to, type, &unit);
                  for (const hid_t attribute : {from, to})
                    H5Aclose(attribute);
                  H5Tclose(type);
                  H5Sclose(scalar);
                  H5Sclose(space);
                  H5Dclose(old);
                  H5Dclose(set);
                }),
                columns == 1 ? "/grains: expected as many rows in all data sets"
                             : "/grains/radius: expected rows of 1 numbers"));
}

TEST_CASE("numbers that no packing has are refused") {
  const double radii[] = {1, 0, 1};
  CHECK(holds(with_numbers("/grains/radius", H5T_NATIVE_DOUBLE, radii), "grain 1: its radius must be"));
  const std::int64_t ids[] = {1, 3, 3};
  CHECK(holds(with_numbers("/grains/id", H5T_NATIVE_INT64, ids), "expected ids in ascending order"));
  const std::uint32_t second[] = {2, 1};
  CHECK(holds(with_numbers("/contacts/j", H5T_NATIVE_UINT32, second), "in the order of (i, j)"));
  const std::uint32_t beyond[] = {1, 3};
  CHECK(holds(with_numbers("/contacts/j", H5T_NATIVE_UINT32, beyond), "needs grain indices"));
  const double flat[9] = {};
  CHECK(holds(with_numbers("/cell", H5T_NATIVE_DOUBLE, flat), "cell volume"));
}
