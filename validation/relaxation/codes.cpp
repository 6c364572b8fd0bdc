// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a packing that another code made to the table that the fit takes the scatter between codes from.
//
//     relaxation_codes codes.csv CODE CONTACT SIZES PREPARATION SEED GRAINS CONTACTS
//
// CODE is lammps or yade, whose files GRAINS and CONTACTS are; CONTACT is sphere (Hertz, G_g = 30 GPa,
// nu_g = 0.15) or flat (linear springs between equal grains); SIZES, PREPARATION and SEED say what was made.
// The row has the columns of unequal.csv; codes.sh makes the whole table.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <granum/analysis/measure.hpp>
#include <granum/contact/grains.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/io/yade/files.hpp>
#include <granum/packing/stiffness.hpp>

#include "reading.hpp"
#include "recording.hpp"
#include "specimens.hpp"

namespace {

using namespace granum;
using relaxation::Record;
using relaxation::Row;

using relaxation::grain;

packing::Assembly read(const std::string& code, const char* grains, const char* contacts) {
  if (code == "lammps") {
    io::LammpsDump dump{io::TextSource(grains), io::TextSource(contacts)};
    return dump.next().value().assembly;
  }
  if (code == "yade")
    return io::read_yade(io::TextSource(grains), io::TextSource(contacts)).assembly;
  throw std::runtime_error("code is " + code + ": lammps or yade");
}

/// With the stiffnesses of its contacts, at the forces that they bear.
struct Packed {
  packing::Assembly assembly;
  dem::Material material;
  analysis::Measurement measured;
};

/// Springs of one stiffness are those of flat contacts: K over that of a closed form does not ask how stiff.
Packed packed(packing::Assembly assembly, const std::string& contact) {
  const double ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio);
  const analysis::Measurement measured =
      analysis::measure(assembly, {.grain_shear_modulus = grain.shear_modulus,
                                   .stiffness_from = packing::StiffnessFrom::force});
  const contact::PowerLaw law = relaxation::detail::law(contact, measured.sizes.equivalent);
  if (contact == "sphere")
    assign_hertz_stiffness(assembly, grain, ratio, packing::StiffnessFrom::force);
  else
    assign_stiffness(assembly, law, ratio, packing::StiffnessFrom::force);
  return {std::move(assembly), {.law = law, .tangential_ratio = ratio}, measured};
}

/// \param    of   the arguments from CODE on
void append(Record& record, char** of) {
  const std::string code = of[0], contact = of[1];
  const auto [assembly, material, measured] = packed(read(code, of[5], of[6]), contact);
  Row row;
  row.add("sizes", std::string(of[2]));
  row.add("contact", contact);
  row.add("preparation", code + " " + of[3]);
  row.add("seed", std::string(of[4]));
  row.add("grains", static_cast<double>(assembly.grain_count()));
  row.add("stage", 0);
  row.add("p_Pa", measured.stress.value().mean());
  row.add("alpha", material.law.power_law()->alpha());
  row.add("stress_ratio", 0);
  row.add("friction_coefficient", std::numeric_limits<double>::quiet_NaN());
  if (record.has(row))
    return;
  row.add("e", measured.void_ratio);
  add_assembly(row, assembly, material);
  add_networks(row, assembly, material.tangential_ratio);
  add_sizes(row, assembly, measured);
  record.append(row);
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 9) {
    std::fprintf(stderr,
                 "usage: %s codes.csv lammps|yade sphere|flat SIZES PREPARATION SEED GRAINS CONTACTS\n",
                 argv[0]);
    return 2;
  }
  try {
    Record record(argv[1], 7);
    append(record, argv + 2);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[7], error.what());
    return 1;
  }
}
