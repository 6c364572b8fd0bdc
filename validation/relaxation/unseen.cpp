// SPDX-License-Identifier: GPL-3.0-or-later
// Packings of seeds that no fit has seen: are the library's errors what it states?
//
//     relaxation_unseen third_seed.csv verify_seeds.csv
//
// The second file is states.csv of a default `granum verify` of seeds that no fit has seen.
// Exit code: 0 if the errors that relaxed() states cover the actual ones, 1 if not, 2 usage.
#include "../common.hpp"
#include "library_errors.hpp"
#include "reading.hpp"

namespace {

using namespace relaxation;

/// A line for each kind of isotropic packings.
void print_each(const std::vector<Packing>& packings, const Label& kind_of, Forces forces = Forces::unknown) {
  std::set<std::string> kinds;
  for (const Packing& p : packings)
    kinds.insert(kind_of(p));
  for (const std::string& kind : kinds) {
    const LibraryErrors e = library_errors(
        packings, [&](const Packing& p) { return p.isotropic() && kind_of(p) == kind; }, forces);
    if (e.G.count() > 0)
      ::print_errors("  " + kind, e);
  }
}

int check(const std::vector<Packing>& packings, const std::vector<Packing>& of_verify) {
  const auto contact = [](const Packing& p) { return p.contact; };
  const auto recipe = [](const Packing& p) { return p.recipe; };
  Claims claims;
  const auto judge = [&](const std::string& what, const Choice& chosen, Forces forces = Forces::unknown,
                         const Range& range = {}) {
    const LibraryErrors e = library_errors(packings, chosen, forces, range);
    print_errors(what, e);
    claims.require_covered(e.G, "G, " + what);
    claims.require_covered(e.K, "K, " + what);
  };
  for (const Label& kind : {Label(contact), Label(preparation_of), Label(recipe)})
    print_each(packings, kind);
  judge("isotropic states", is_isotropic);
  judge("sheared states", is_sheared);
  std::printf("where contacts are few\n");
  for (const LibraryErrors& e : print_few_contacts("third seed", packings))
    for (const Errors* few : {&e.G, &e.K})
      claims.require_covered(*few, "few contacts", 0.50, 0.88);
  judge("isotropic states of overlaps beyond 1 %", is_isotropic, Forces::unknown,
        {.least_overlap = largest_overlap, .most_overlap = 1});
  std::printf("specimens of verify\n");
  print_each(of_verify, recipe);
  std::printf("forces known\n");
  judge("isotropic states", is_isotropic, Forces::measured);
  judge("sheared states", is_sheared, Forces::measured);
  print_each(packings, recipe, Forces::measured);
  std::printf("specimens of verify, forces known\n");
  print_each(of_verify, recipe, Forces::measured);
  std::printf("dense specimens of verify, preparation known\n");
  std::vector<Packing> dense = of_verify;
  std::erase_if(dense, [](const Packing& p) { return p.preparation != "dense"; });
  print_each(dense, recipe, Forces::remembered);
  return claims.exit_code();
}

} // namespace

int main(int argc, char** argv) {
  return program(argc, argv, {{"", "third_seed.csv verify_seeds.csv", [](const Arguments& files) {
                                 return check(read_packings(files[0]), read_verify_states(files[1]));
                               }}});
}
