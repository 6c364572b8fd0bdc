// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres beside glass beads and sands that laboratories measured.
//     laboratory <folder of the data> [<folder for pictures>]
// Exit code 0 only if what README.md says of the beads holds.
#include <exception>
#include <filesystem>

#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

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

bool run(const std::string& folder, const char* pictures) {
  const Comparison beads = compare(glass, folder), sand = compare(quartz, folder);
  for (const Comparison* c : {&beads, &sand}) {
    print(*c, &Moduli::shear, "G");
    print(*c, &Moduli::bulk, "K");
  }
  const double from = 6.8e6;
  std::printf("\nbeads, 6.89 to 34.47 MPa: rung 3 misses G by up to %.0f %% (dense), %.0f %% (friction)\n",
              100 * largest_miss(beads, 1, from), 100 * largest_miss(beads, 2, from));
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
  const Foretold grown = foretell(glass, beads.measured, GrowthRule::packings);
  print(grown, "beads, z* growing as own packings'");
  print(foretell(glass, beads.measured, GrowthRule::fixed), "beads, z* fixed");
  for (const double n : {least_porosity, most_porosity})
    print(foretell(glass, beads.measured, GrowthRule::packings, n),
          n < porosity ? "beads, growing, porosity 0.36" : "beads, growing, porosity 0.40");
  print(foretell(quartz, sand.measured, GrowthRule::packings), "sand, z* growing as own packings'");
  print(foretell(quartz, sand.measured, GrowthRule::fixed), "sand, z* fixed");
  print_sands();
  print_contacts(glass, beads.measured);
  const std::vector<Miss> sand_misses = print_contacts(quartz, sand.measured);
  print_sand_contacts("kokusho", 0.70);
  print_sand_contacts("hardin-richart-round", 0.60);
  if (pictures != nullptr)
    write_pictures(pictures, beads, sand);

  // Worst of both directions. The upper five pressures hardly determine roughness; the stated error of V_s at
  // the lower five includes that.
  const Miss &smooth = sand_misses[0], &rough = sand_misses[1], &power_law = sand_misses[2];
  const bool contacts_hold = smooth.relative > 0.10 && smooth.in_errors > 4 && rough.relative < 0.03 &&
                             rough.in_errors < 2 && power_law.relative < 0.03 && power_law.in_errors < 2;
  const bool holds = grown.largest() < 0.10 && contacts_hold;
  std::printf("\n%s\n", holds ? "holds" : "DOES NOT HOLD: see README.md");
  return holds;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: laboratory <folder of the data> [<folder for pictures>]\n");
    return 2;
  }
  try {
    return run(argv[1], argc == 3 ? argv[2] : nullptr) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "laboratory: %s\n", error.what());
    return 2;
  }
}
