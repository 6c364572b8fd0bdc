// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/cell_work.hpp>

#include <algorithm>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>

namespace granum::packing {

namespace {

/// The law of two grains of an assembly.
class PairLaws {
 public:
  PairLaws(const Assembly& assembly, const contact::NormalLaw& law, double radius)
      : assembly_(assembly), law_(law), radius_(radius) {}

  [[nodiscard]] contact::NormalLaw operator()(std::size_t i, std::size_t j) const {
    const double a = assembly_.radius[i] / radius_, b = assembly_.radius[j] / radius_;
    return a == 1 && b == 1 ? law_ : of_sizes(law_, a, b);
  }

 private:
  const Assembly& assembly_;
  const contact::NormalLaw& law_;
  double radius_;
};

/// Energy that the contacts release as the cell grows from 1 - strain to 1 + strain of its size. Summed
/// contact by contact: the difference of two sums over all would lose the digits that a small strain needs.
double released_energy(const Assembly& assembly, const PairLaws& law, double strain) {
  const auto released = [strain](const contact::NormalLaw& of_pair, double overlap, double branch) {
    return of_pair.energy(overlap + strain * branch) -
           of_pair.energy(std::max(0.0, overlap - strain * branch));
  };
  double sum = 0;
  for (const Contact& c : assembly.contacts)
    sum += released(law(c.i, c.j), c.overlap, norm(c.branch));
  for (const Contact& c : assembly.wall_contacts)
    sum += released(law(c.i, c.i), 2 * c.overlap, 2 * norm(c.branch)) / 2;
  return sum;
}

} // namespace

double pressure_by_cell_work(const Assembly& assembly, const contact::NormalLaw& law, double law_radius) {
  require_valid(assembly);
  require_positive("law_radius", law_radius, "m");
  double overlap = 0, length = 0;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const Contact& c : *contacts) {
      overlap += c.overlap;
      length += norm(c.branch);
    }
  if (!(overlap > 0))
    return 0;
  const double strain = 1e-6 * overlap / length;
  return released_energy(assembly, PairLaws(assembly, law, law_radius), strain) /
         (2 * strain * 3 * assembly.volume());
}

} // namespace granum::packing
