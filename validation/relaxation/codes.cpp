// SPDX-License-Identifier: GPL-3.0-or-later
// Adds a packing that another code made to the table that the fit takes the scatter between codes from.
//
//     relaxation_codes codes.csv CODE SIZES PREPARATION SEED GRAINS CONTACTS
//
// CODE is lammps or yade, whose files GRAINS and CONTACTS are; SIZES, PREPARATION and SEED say what was made. Spheres of
// G_g = 30 GPa and nu_g = 0.15. The row has the columns of unequal.csv; codes.sh makes the whole table.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>

#include <granum/analysis/measure.hpp>
#include <granum/contact/pair.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/io/lammps/dump.hpp>
#include <granum/io/yade/text.hpp>
#include <granum/packing/stiffness.hpp>

#include "recording.hpp"
#include "specimens.hpp"

namespace {

using namespace granum;
using relaxation::Record;
using relaxation::Row;

constexpr const contact::GrainMaterial& quartz = relaxation::grain;

packing::Assembly read(const std::string& code, const char* grains, const char* contacts) {
  if (code == "lammps") {
    io::LammpsDump dump{io::TextSource(grains), io::TextSource(contacts)};
    return dump.next().value().assembly;
  }
  if (code == "yade")
    return io::read_yade(io::TextSource(grains), io::TextSource(contacts)).assembly;
  throw std::runtime_error("code is " + code + ": lammps or yade");
}

void append(Record& record, const std::string& code, char** of) {
  packing::Assembly assembly = read(code, of[3], of[4]);
  const double ratio = contact::mindlin_stiffness_ratio(quartz.poisson_ratio);
  assign_hertz_stiffness(assembly, quartz, ratio, packing::StiffnessFrom::force);
  const analysis::Measurement measured =
      analysis::measure(assembly, {.grain_shear_modulus = quartz.shear_modulus,
                                   .stiffness_from = packing::StiffnessFrom::force});
  const dem::Material material{.law = contact::PowerLaw::sphere(quartz, measured.sizes.equivalent),
                               .tangential_ratio = ratio};
  Row row;
  row.add("sizes", std::string(of[0]));
  row.add("contact", std::string("sphere"));
  row.add("preparation", code + " " + of[1]);
  row.add("seed", std::string(of[2]));
  row.add("grains", static_cast<double>(assembly.grain_count()));
  row.add("stage", 0);
  row.add("p_Pa", measured.stress.value().mean());
  row.add("alpha", material.law.alpha());
  row.add("stress_ratio", 0);
  row.add("friction_coefficient", std::numeric_limits<double>::quiet_NaN());
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
  if (argc != 8) {
    std::fprintf(stderr, "usage: %s codes.csv lammps|yade SIZES PREPARATION SEED GRAINS CONTACTS\n", argv[0]);
    return 2;
  }
  try {
    Record record(argv[1], 7);
    append(record, argv[2], argv + 3);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[6], error.what());
    return 1;
  }
}
