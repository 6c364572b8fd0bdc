// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/forces.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::packing {

namespace {

double frobenius(const Mat3& m) {
  double squares = 0;
  for (const auto& row : m.m)
    for (const double value : row)
      squares += value * value;
  return std::sqrt(squares);
}

} // namespace

ContactStress contact_stress(const Assembly& assembly) {
  require_valid(assembly);
  Mat3 sum;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const Contact& c : *contacts)
      sum += outer(force(c), c.branch);
  const double volume = assembly.volume();
  ContactStress stress;
  Mat3 antisymmetric;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      stress.tensor(i, j) = sum(i, j) / volume;
      stress.symmetric(i, j) = (sum(i, j) + sum(j, i)) / (2 * volume);
      antisymmetric(i, j) = (sum(i, j) - sum(j, i)) / (2 * volume);
    }
  const double size = frobenius(stress.symmetric);
  if (size > 0)
    stress.asymmetry = frobenius(antisymmetric) / size;
  return stress;
}

std::vector<Mat3> grain_stresses(const Assembly& assembly) {
  require_valid(assembly);
  std::vector<Mat3> stress(assembly.grain_count());
  for (const Contact& c : assembly.contacts) {
    const double radii = assembly.radius[c.i] + assembly.radius[c.j];
    for (const std::uint32_t grain : {c.i, c.j})
      stress[grain] += outer(force(c), (assembly.radius[grain] / radii) * c.branch);
  }
  for (const Contact& c : assembly.wall_contacts)
    stress[c.i] += outer(force(c), c.branch);
  for (std::size_t g = 0; g < stress.size(); ++g) {
    const double r = assembly.radius[g];
    stress[g] = (3 / (4 * std::numbers::pi * r * r * r)) * stress[g];
  }
  return stress;
}

std::vector<Residual> residuals(const Assembly& assembly) {
  require_valid(assembly);
  std::vector<Residual> result(assembly.grain_count());
  for (const Contact& c : assembly.contacts) {
    const Vec3 f = force(c);
    const Vec3 turn = cross(c.branch, f);
    const double sum = assembly.radius[c.i] + assembly.radius[c.j];
    result[c.i].force -= f;
    result[c.j].force += f;
    result[c.i].moment -= (assembly.radius[c.i] / sum) * turn;
    result[c.j].moment -= (assembly.radius[c.j] / sum) * turn;
  }
  for (const Contact& c : assembly.wall_contacts) {
    result[c.i].force -= force(c);
    result[c.i].moment -= cross(c.branch, force(c));
  }
  return result;
}

namespace {

/// Unbalanced forces of bodies from those of their grains.
std::vector<Residual> residuals_of(const Bodies& bodies, const Assembly& assembly,
                                   const std::vector<Residual>& grains) {
  std::vector<Residual> result(bodies.assembly.grain_count());
  for (std::size_t g = 0; g < grains.size(); ++g) {
    Residual& body = result[assembly.body[g]];
    body.force += grains[g].force;
    body.moment += grains[g].moment + cross(bodies.offset[g], grains[g].force);
  }
  return result;
}

} // namespace

Unbalance unbalance(const Assembly& assembly) {
  std::vector<double> radii = assembly.radius;
  auto grains = residuals(assembly);
  if (!assembly.body.empty()) {
    const Bodies joined = bodies(assembly);
    grains = residuals_of(joined, assembly, grains);
    radii = joined.assembly.radius;
  }
  double contact_force = 0;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const Contact& c : *contacts)
      contact_force += norm(force(c));
  if (!(contact_force > 0))
    return {};
  contact_force /= static_cast<double>(assembly.contacts.size() + assembly.wall_contacts.size());
  const auto count = static_cast<double>(grains.size());
  const double radius = std::accumulate(radii.begin(), radii.end(), 0.0) / count;
  Unbalance sum;
  for (const Residual& r : grains) {
    sum.force_ratio += norm(r.force);
    sum.moment_ratio += norm(r.moment);
  }
  return {sum.force_ratio / (count * contact_force), sum.moment_ratio / (count * contact_force * radius)};
}

namespace {

/// Empty bins from 0 to range.
std::vector<ForceBin> empty_bins(std::size_t count, double range) {
  std::vector<ForceBin> bins(count);
  const double number = static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    bins[k].low = range * (static_cast<double>(k) / number);
    bins[k].high = range * (static_cast<double>(k + 1) / number);
  }
  return bins;
}

} // namespace

std::vector<double> normal_forces(const Assembly& assembly) {
  std::vector<double> forces;
  forces.reserve(assembly.contacts.size());
  for (const Contact& c : assembly.contacts)
    forces.push_back(c.normal_force);
  return forces;
}

ForceDistribution force_distribution(std::span<const double> forces, std::size_t bins, double range) {
  require_closed("bins", static_cast<double>(bins), 1, 1000);
  require_positive("range", range);
  ForceDistribution out;
  for (const double f : forces) {
    require_finite("normal_force", f, "N");
    out.pressing += f > 0;
    out.unloaded += f == 0;
    out.in_tension += f < 0;
    out.largest = std::max(out.largest, f);
  }
  out.bins = empty_bins(bins, range);
  if (out.pressing == 0)
    return out;
  const double count = static_cast<double>(out.pressing);
  double sum = 0;
  for (const double f : forces)
    sum += f > 0 ? f : 0;
  out.mean = sum / count;
  for (const double f : forces) {
    if (!(f > 0))
      continue;
    const double place = f / out.mean / range * static_cast<double>(bins);
    if (place < static_cast<double>(bins))
      ++out.bins[static_cast<std::size_t>(place)].count;
    else
      ++out.beyond;
  }
  const double width = range / static_cast<double>(bins);
  for (ForceBin& bin : out.bins) {
    const double in_bin = static_cast<double>(bin.count);
    bin.density = in_bin / (count * width);
    bin.density_error = std::sqrt(in_bin) / (count * width);
  }
  return out;
}

namespace {

/// f^2/k, the work of a force on its own displacement.
double compliance_energy(double force, double stiffness) {
  if (force == 0)
    return 0;
  return stiffness > 0 ? force * force / stiffness : std::numeric_limits<double>::infinity();
}

} // namespace

double normal_force_moment(const Assembly& assembly, double exponent) {
  require_valid(assembly);
  require_finite("exponent", exponent);
  double count = 0, sum = 0;
  for (const Contact& c : assembly.contacts) {
    require_non_negative("normal_force", c.normal_force, "N");
    count += c.normal_force > 0;
    sum += c.normal_force;
  }
  if (!(sum > 0))
    throw InvalidArgument("force moment: no contact carries force");
  const double mean = sum / count;
  double moment = 0;
  for (const Contact& c : assembly.contacts)
    if (c.normal_force > 0)
      moment += std::pow(c.normal_force / mean, exponent);
  return moment / count;
}

BulkModulusBounds bulk_modulus_bounds(const Assembly& assembly) {
  const double pressure = contact_stress(assembly).mean();
  double stiffness = 0, energy = 0;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const Contact& c : *contacts) {
      stiffness += c.normal_stiffness * dot(c.branch, c.branch);
      energy += compliance_energy(c.normal_force, c.normal_stiffness) +
                compliance_energy(norm(c.tangential_force), c.tangential_stiffness);
    }
  const double volume = assembly.volume();
  return {.lower = energy > 0 ? pressure * pressure * volume / energy : 0, .upper = stiffness / (9 * volume)};
}

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

double force_unevenness(const Assembly& assembly, const contact::NormalLaw& law, double law_radius,
                        std::span<const double> relative_stiffness) {
  require_valid(assembly);
  require_positive("law_radius", law_radius, "m");
  const bool one_kind = relative_stiffness.empty();
  if (!one_kind && relative_stiffness.size() != assembly.contacts.size())
    throw InvalidArgument("force_unevenness: there must be one relative stiffness for each contact");
  struct Kind {
    double squares = 0, work = 0, lengths = 0;
  };
  const PairLaws law_of(assembly, law, law_radius);
  double stiffness = 0;
  std::map<double, Kind> kinds;
  for (std::size_t k = 0; k < assembly.contacts.size(); ++k) {
    const Contact& c = assembly.contacts[k];
    const double length = norm(c.branch), force = std::max(c.normal_force, 0.0),
                 relative = one_kind ? 1 : require_positive("relative_stiffness", relative_stiffness[k]);
    Kind& kind = kinds[relative];
    stiffness += relative * law_of(c.i, c.j).stiffness_at_force(force) * (length * length);
    kind.squares += length * length;
    kind.work += force * length;
    kind.lengths += length;
  }
  double even = 0, work = 0;
  for (const auto& [relative, kind] : kinds) {
    even += relative * (law.stiffness_at_force(kind.work / kind.lengths) * kind.squares);
    work += kind.work;
  }
  return work > 0 ? std::log(stiffness / even) : 0;
}

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
