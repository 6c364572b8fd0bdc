// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a packing that another code made to the table that the fit takes the scatter between codes from.
//
//     relaxation_codes codes.csv CODE CONTACT SIZES PREPARATION SEED GRAINS CONTACTS
//
// CODE is lammps or yade, whose files GRAINS and CONTACTS are; CONTACT is sphere (Hertz, G_g = 30 GPa,
// nu_g = 0.15) or flat (linear springs between equal grains); SIZES, PREPARATION and SEED say what was made.
// The row has the columns of unequal.csv; codes.sh makes the whole table.
#include <granum/contact/grains.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/io/yade/files.hpp>
#include <granum/packing/stiffness.hpp>

#include "../common.hpp"
#include "reading.hpp"
#include "recording.hpp"
#include "specimens.hpp"

namespace {

using namespace relaxation;

packing::Assembly read(const std::string& code, const std::string& grains, const std::string& contacts) {
  if (code == "lammps") {
    io::LammpsDump dump{io::TextSource(grains), io::TextSource(contacts)};
    return dump.next().value().assembly;
  }
  if (code == "yade")
    return io::read_yade(io::TextSource(grains), io::TextSource(contacts)).assembly;
  throw std::runtime_error("code is " + code + ": lammps or yade");
}

/// \param    of   the arguments from CODE on
void append(Record& record, const std::vector<std::string>& of) {
  const std::string &code = of[0], &contact = of[1];
  packing::Assembly assembly = read(code, of[5], of[6]);
  const double ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio);
  const analysis::Measurement measured =
      analysis::measure(assembly, {.grain_shear_modulus = grain.shear_modulus,
                                   .stiffness_from = packing::StiffnessFrom::force});
  // With the stiffnesses of the contacts at their forces. Springs of one stiffness are those of flat
  // contacts: K over that of a closed form does not ask how stiff.
  const contact::PowerLaw law = relaxation::detail::law(contact, measured.sizes.equivalent);
  if (contact == "sphere")
    assign_hertz_stiffness(assembly, grain, ratio, packing::StiffnessFrom::force);
  else
    assign_stiffness(assembly, law, ratio, packing::StiffnessFrom::force);
  const dem::Material material{.law = law, .tangential_ratio = ratio};
  Row row;
  row.add("sizes", of[2]);
  row.add("contact", contact);
  row.add("preparation", code + " " + of[3]);
  row.add("seed", of[4]);
  row.add({{"grains", static_cast<double>(assembly.grain_count())},
           {"stage", 0},
           {"p_Pa", measured.stress.value().mean()},
           {"alpha", law.alpha()},
           {"stress_ratio", 0},
           {"friction_coefficient", std::numeric_limits<double>::quiet_NaN()}});
  if (record.has(row))
    return;
  row.add("e", measured.void_ratio);
  add_assembly(row, assembly, material);
  add_networks(row, assembly, ratio);
  add_sizes(row, assembly, measured);
  record.append(row);
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv,
                 {{"", "codes.csv lammps|yade sphere|flat SIZES PREPARATION SEED GRAINS CONTACTS",
                   [](const Arguments& arguments) {
                     Record record(arguments[0], 7);
                     append(record, {arguments.begin() + 1, arguments.end()});
                   }}});
}
