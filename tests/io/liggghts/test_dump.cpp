// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include <granum/packing/forces.hpp>

#include "io/import_support.hpp"

using namespace granum::io;
using namespace granum::samples;

namespace {

constexpr double six_digits = 5e-6; // half of the last digit printed
const std::string atoms = data_text("liggghts_face.atoms");
const std::string contacts = data_text("liggghts_face.contacts");

std::string refused(const std::string& contact_text) {
  return refusal([&] {
    LammpsDump reader(text_source("a", atoms), text_source("c", contact_text));
    while (reader.next())
      ;
  });
}

} // namespace

TEST_CASE("LIGGGHTS: the chain's forces and overlaps, with the side from the dump of atoms") {
  LammpsDump reader(data_source("liggghts_chain.atoms"), data_source("liggghts_chain.contacts"));
  const auto packing = reader.next();
  REQUIRE(packing);
  check_chain(*packing, six_digits, 1e-15); // overlaps are printed as such
  CHECK(packing->has(Finding::few_digits));
  const auto residual = residuals(packing->assembly);
  check_vector(residual[0].force, {-0.0235294, -0.00145127, 0}, six_digits);
  check_vector(residual[1].force, {0.0235294, 0.00145127, -0.0665512}, six_digits);
  check_vector(residual[2].force, {0, 0, 0.0665512}, six_digits);
  REQUIRE(reader.next());
  CHECK_FALSE(reader.next());
}

TEST_CASE("LIGGGHTS: positions inside the box, a flag for the pair through a face, ids the other way round") {
  LammpsDump reader(data_source("liggghts_face.atoms"), data_source("liggghts_face.contacts"));
  const auto packing = reader.next();
  REQUIRE(packing);
  REQUIRE(packing->assembly.contacts.size() == 1);
  const packing::Contact& c = packing->assembly.contacts[0];
  check_vector(c.branch, {-0.9999e-3, 0, 0}, 1e-12);
  CHECK(c.overlap == 1e-7);
  CHECK(c.normal_force == relative(force_ab, six_digits));
  CHECK(packing->has(Finding::through_faces));
  check_vector(residuals(packing->assembly)[0].force, {0.0235294, 0.00145127, 0}, six_digits);
}

TEST_CASE("LIGGGHTS: each field of the contacts that is wrong is refused with path and line") {
  const std::string row = "0.0034001 0.002 0.002 0.0004 0.002 0.002 2 1 1 ";
  const auto changed = [&](const std::string& to) { return refused(with(contacts, row, to)); };
  CHECK(
      changed("0.0034001 0.002 0.002 0.0004 0.002 0.002 2 1 0 ").starts_with("c:10:")); // the flag is missing
  CHECK(changed("0.0044001 0.002 0.002 0.0004 0.002 0.002 2 1 1 ").starts_with("c:10:"));
  CHECK(changed("nan 0.002 0.002 0.0004 0.002 0.002 2 1 1 ").starts_with("c:10:"));
  CHECK(changed("0.0034001 0.002 0.002 0.0004 0.002 0.002 2 3 1 ").starts_with("c:10:"));
  CHECK(changed("0.0034001 0.002 0.002 0.0004 0.002 0.002 2 1 0.5 ").starts_with("c:10:"));
  CHECK(refused(with(contacts, " 1e-07 ", " 1e-07m ")).starts_with("c:10:"));
  CHECK(refused(with(contacts, " c_cp[28] ", " ")).starts_with("c:10:"));
}
