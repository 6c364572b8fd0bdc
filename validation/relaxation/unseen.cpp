// SPDX-License-Identifier: GPL-3.0-or-later
// Packings of seeds that no fit has seen: are the library's errors what it states?
//
//     relaxation_unseen third_seed.csv verify_seeds.csv
//
// The second file is states.csv of a default `granum verify` of seeds that no fit has seen.
// Exit code: 0 if the errors that relaxed() states cover the actual ones, 1 if not, 2 usage.
#include <cstdio>
#include <exception>
#include <functional>
#include <set>

#include "../claims.hpp"
#include "library_errors.hpp"
#include "verify_states.hpp"

namespace {

using namespace relaxation;

/// Two lines for each kind of isotropic packings.
void print_each(const std::vector<Packing>& packings,
                const std::function<std::string(const Packing&)>& kind_of, Forces forces = Forces::unknown) {
  std::set<std::string> kinds;
  for (const Packing& p : packings)
    kinds.insert(kind_of(p));
  for (const std::string& kind : kinds) {
    const LibraryErrors e = library_errors(
        packings, [&](const Packing& p) { return p.isotropic() && kind_of(p) == kind; }, 0, largest_overlap,
        forces);
    if (e.G.count() == 0)
      continue;
    print_errors("  " + kind, FactorErrors{.shear = e.G, .bulk = e.K});
    print_coverage("", e.coverage);
  }
}

void require_covered(const Coverage& coverage, const std::string& of, Claims& claims) {
  claims.require(coverage.count > 0 && coverage.one() >= 0.55, "55 % or more within one stated error: " + of);
  claims.require(coverage.two() >= 0.90, "90 % or more within two: " + of);
}

void judge(const std::vector<Packing>& packings, const std::string& what, const Choice& chosen,
           Claims& claims, double least_overlap = 0, double most_overlap = largest_overlap,
           Forces forces = Forces::unknown) {
  const LibraryErrors e = library_errors(packings, chosen, least_overlap, most_overlap, forces);
  print_errors(what, e);
  print_coverage(what, e.coverage);
  require_covered(e.coverage.shear, "G, " + what, claims);
  require_covered(e.coverage.bulk, "K, " + what, claims);
}

int check(const std::vector<Packing>& packings, const std::vector<Packing>& of_verify) {
  print_each(packings, [](const Packing& p) { return p.contact; });
  print_each(packings, [](const Packing& p) { return unsheared(p.preparation); });
  print_each(packings, [](const Packing& p) { return p.recipe; });
  Claims claims;
  judge(packings, "isotropic states", is_isotropic, claims);
  judge(packings, "sheared states", is_sheared, claims);
  std::printf("where contacts are few\n");
  for (const LibraryErrors& e : print_few_contacts("third seed", packings))
    for (const Coverage* c : {&e.coverage.shear, &e.coverage.bulk})
      claims.require(c->one() >= 0.50 && c->two() >= 0.88,
                     "few contacts: 50 % or more within one stated error, 88 % within two");
  judge(packings, "isotropic states of overlaps beyond 1 %", is_isotropic, claims, largest_overlap, 1);
  const auto recipe = [](const Packing& p) { return p.recipe; };
  std::printf("specimens of verify\n");
  print_each(of_verify, recipe);
  std::printf("forces known\n");
  judge(packings, "isotropic states", is_isotropic, claims, 0, largest_overlap, Forces::measured);
  judge(packings, "sheared states", is_sheared, claims, 0, largest_overlap, Forces::measured);
  print_each(packings, recipe, Forces::measured);
  std::printf("specimens of verify, forces known\n");
  print_each(of_verify, recipe, Forces::measured);
  std::printf("dense specimens of verify, preparation known\n");
  std::vector<Packing> dense = of_verify;
  std::erase_if(dense, [](const Packing& p) { return p.preparation != "dense"; });
  print_each(dense, recipe, Forces::remembered);
  return claims.failed() == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s third_seed.csv verify_seeds.csv\n", argv[0]);
    return 2;
  }
  try {
    return check(read_packings(argv[1]), read_verify_states(argv[2]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
