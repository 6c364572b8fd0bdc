// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres beside glass beads and sands that laboratories measured.
//     laboratory <folder of the data> [<folder for pictures>]
// Exit code 0 only if what README.md says of the beads holds.
#include <filesystem>

#include <granum/io/output_file.hpp>

#include "../claims.hpp"
#include "beads.hpp"
#include "contacts.hpp"
#include "sands.hpp"

namespace {

using namespace laboratory;
using granum::inverse::GrowthRule;

void write_pictures(const std::filesystem::path& folder, const Comparison& beads, const Comparison& sand) {
  const auto write = [&](const char* name, const granum::plot::Chart& picture) {
    granum::io::write_file(folder / name, granum::plot::svg(picture), granum::io::Existing::replace);
  };
  write("beads_G.svg", chart(beads, &Moduli::shear, "G"));
  write("beads_K.svg", chart(beads, &Moduli::bulk, "K"));
  write("sand_G.svg", chart(sand, &Moduli::shear, "G"));
  write("sands.svg", sand_chart(0.65));
  write("sand_contacts.svg", contact_chart(quartz, sand.measured));
}

int run(const std::string& folder, const std::string& pictures) {
  const Comparison beads = compare(glass, folder), sand = compare(quartz, folder);
  for (const Comparison* c : {&beads, &sand}) {
    print(*c, &Moduli::shear, "G");
    print(*c, &Moduli::bulk, "K");
  }
  const double from = 6.8e6;
  std::printf("\nbeads, 6.89 to 34.47 MPa: rung 3 misses G by up to %.0f %% (dense), %.0f %% (friction)\n",
              100 * misses(beads, 1, from).worst(), 100 * misses(beads, 2, from).worst());
  for (const double n : {least_porosity, most_porosity}) {
    const Comparison other = compare(glass, folder, n);
    const auto ratio = [&](std::size_t k) {
      return other.estimates[1].moduli[k].shear / other.measured_moduli(k, n).shear /
             (beads.estimates[1].moduli[k].shear / beads.measured_moduli(k).shear);
    };
    std::printf("  porosity %.2f instead: every ratio of closed forms times %.3f\n", n, ratio(0));
  }

  std::printf("\nV_s at all other pressures, inferred from that at one: largest miss for each\n  %-44s",
              "from p [MPa]");
  for (const Measured& m : beads.measured)
    std::printf(" %6.2f", m.pressure / 1e6);
  std::printf("\n");
  const Errors grown =
      foretell("beads, z* growing as own packings'", glass, beads.measured, GrowthRule::packings);
  foretell("beads, z* fixed", glass, beads.measured, GrowthRule::fixed);
  for (const double n : {least_porosity, most_porosity})
    foretell(n < porosity ? "beads, growing, porosity 0.36" : "beads, growing, porosity 0.40", glass,
             beads.measured, GrowthRule::packings, n);
  foretell("sand, z* growing as own packings'", quartz, sand.measured, GrowthRule::packings);
  foretell("sand, z* fixed", quartz, sand.measured, GrowthRule::fixed);
  print_sands();
  print_contacts(glass, beads.measured);
  const std::vector<Errors> sand_misses = print_contacts(quartz, sand.measured);
  print_sand_contacts("kokusho", 0.70);
  print_sand_contacts("hardin-richart-round", 0.60);
  if (!pictures.empty())
    write_pictures(pictures, beads, sand);

  // Worst of both directions. The upper five pressures hardly determine roughness; the stated error of V_s at
  // the lower five includes that.
  Claims claims;
  std::printf("\n");
  claims.require(grown.count() > 0 && grown.worst() < 0.10,
                 "V_s of beads at all other pressures: 10 % at worst");
  claims.require(sand_misses[0].worst() > 0.10 && sand_misses[0].worst_in_stated() > 4,
                 "smooth spheres miss V_s of the sand by more than 10 % and four stated errors");
  for (const std::size_t kind : {1U, 2U})
    claims.require(sand_misses[kind].worst() < 0.03 && sand_misses[kind].worst_in_stated() < 2,
                   std::string(contact_kinds[kind]) + " contacts: within 3 % and two stated errors");
  return claims.exit_code();
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv,
                 {{"", "folder-of-the-data [folder-for-pictures]", [](const Arguments& arguments) {
                     return run(arguments[0], arguments.size() > 1 ? arguments[1] : "");
                   }}});
}
