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

} // namespace

TEST_CASE("LIGGGHTS: the chain's forces and overlaps, with the side from the dump of atoms") {
  const PackingFrames frames =
      states_of(lammps_dump_format, data_text("liggghts_chain.atoms"), data_text("liggghts_chain.contacts"));
  const auto packing = frames.next();
  REQUIRE(packing);
  check_chain(*packing, six_digits, 1e-15); // overlaps are printed as such
  CHECK(packing->has(Finding::few_digits));
  const auto residual = residuals(packing->assembly);
  check_vector(residual[0].force, {-0.0235294, -0.00145127, 0}, six_digits);
  check_vector(residual[1].force, {0.0235294, 0.00145127, -0.0665512}, six_digits);
  check_vector(residual[2].force, {0, 0, 0.0665512}, six_digits);
  REQUIRE(frames.next());
  CHECK_FALSE(frames.next());
}

TEST_CASE("LIGGGHTS: positions inside the box, a flag for the pair through a face, ids the other way round") {
  const ImportedPacking packing = first_of(lammps_dump_format, atoms, contacts);
  REQUIRE(packing.assembly.contacts.size() == 1);
  const packing::Contact& c = packing.assembly.contacts[0];
  check_vector(c.branch, {-0.9999e-3, 0, 0}, 1e-12);
  CHECK(c.overlap == 1e-7);
  CHECK(c.normal_force == relative(force_ab, six_digits));
  CHECK(packing.has(Finding::through_faces));
  check_vector(residuals(packing.assembly)[0].force, {0.0235294, 0.00145127, 0}, six_digits);
}

TEST_CASE("LIGGGHTS: each field of the contacts that is wrong is refused with path and line") {
  check_refused(lammps_dump_format, atoms, contacts, {},
                {{"2 1 1 ", {"2 1 0 ", "2 3 1 ", "2 1 0.5 "}, "c:10:"}, // 0: the flag is missing
                 {"0.0034001 ", {"0.0044001 ", "nan "}, "c:10:"},
                 {" 1e-07 ", {" 1e-07m "}, "c:10:"},
                 {" c_cp[28] ", {" "}, "c:10:"}});
}
