// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/analysis/measure.hpp>

#include <algorithm>
#include <cmath>

#include <granum/analysis/parts.hpp>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/packing/assembly.hpp>
#include <granum/packing/coordination.hpp>
#include <granum/packing/forces.hpp>
#include <granum/packing/one_layer.hpp>

#include "counts.hpp"
#include "materials.hpp"
#include "part_errors.hpp"

namespace granum::analysis {

namespace {

/// Whether the law can be read off forces and overlaps, so that its modulus can be as well.
/// \param    rounded   share by which overlaps may be off: forces by 1.5 times as much
bool law_is_clear(const LawCheck& check, double rounded) {
  constexpr double clear = 1e-2, too_rough = 0.1;
  constexpr std::size_t fewest = 10;
  return check.contacts >= fewest && rounded < too_rough && check.median_misfit < clear + 1.5 * rounded;
}

/// Whether forces are proportional to the overlaps to the power 3/2, within the error.
bool is_hertz(const Measured& exponent) {
  constexpr double rounding = 1e-4, too_vague = 0.02;
  return exponent.standard_error <= too_vague &&
         std::abs(exponent.value - 1.5) <= 2 * exponent.standard_error + rounding;
}

/// One packing, part after part: each may need those before.
class Measuring {
 public:
  Measuring(const packing::Assembly& assembly, const Given& given, const Wanted& wanted)
      : assembly_(assembly), given_(given), wanted_(wanted),
        forces_known_(given.normal_forces && !assembly.contacts.empty()),
        rounded_(rounded_share(assembly, given.overlap_rounding)) {
    if (!assembly.body.empty())
      bodies_ = packing::bodies(assembly);
  }

  Measurement run() && {
    out_.volume = assembly_.volume();
    out_.void_ratio = given_.void_ratio ? *given_.void_ratio : void_ratio(assembly_);
    if (given_.grain_density)
      out_.bulk_density =
          elastic::bulk_density({.grain_density = *given_.grain_density, .void_ratio = out_.void_ratio});
    out_.sizes = sizes_of(assembly_);
    measure_load();
    find_law();
    out_.counts = out_.law && forces_known_
                      ? counts_of(counted_part(moving(), *out_.law), assembly_.grain_count())
                      : counts_of(moving(), assembly_.grain_count());
    if (out_.counts.contacts >= 2)
      out_.fabric = measure_fabric(contact_normals(assembly_), wanted_);
    if (wanted_.interior_layer)
      out_.interior = interior_measures(moving(), out_.counts.mechanical, *wanted_.interior_layer);
    else if (wanted_.window)
      out_.interior =
          interior_measures(moving(), out_.counts.mechanical,
                            packing::Interior(assembly_.cell, wanted_.window->low, wanted_.window->high));
    if (wanted_.work && out_.law)
      out_.pressure_by_work = pressure_by_cell_work(assembly_, *out_.law,
                                                    out_.sizes.equivalent * out_.sizes.contacts.pair_radius);
    make_state();
    if (wanted_.closed_forms && out_.state) {
      out_.closed_forms = closed_forms(*out_.state);
      add_errors_of_part(out_, assembly_.grain_count());
      withhold_closed_forms();
    }
    if (wanted_.network && out_.counts.mechanical.contact_count > 0 && find_stiffness())
      solve_network(*stiff_);
    keep_within_bounds(out_);
    return std::move(out_);
  }

  packing::Assembly stiffened() && {
    out_.void_ratio = void_ratio(assembly_); // refuses what is no packing
    out_.sizes = sizes_of(assembly_);
    measure_load();
    find_law();
    if (!find_stiffness())
      throw InvalidArgument(
          "the contacts have no stiffness, and it does not follow from their forces, overlaps "
          "and grains: give the material of the grains");
    return *std::move(stiff_);
  }

 private:
  /// The assembly of bodies, or of grains.
  [[nodiscard]] const packing::Assembly& moving() const { return bodies_ ? bodies_->assembly : assembly_; }

  [[nodiscard]] bool turning_resisted() const {
    const auto resists = [](const packing::Contact& c) {
      return c.rolling_stiffness > 0 || c.twisting_stiffness > 0;
    };
    return given_.rolling || given_.twisting ||
           std::any_of(assembly_.contacts.begin(), assembly_.contacts.end(), resists);
  }

  /// Contacts of spheres that neither roll nor bond leave moments as small as the forces.
  [[nodiscard]] bool moments_are_left() const {
    constexpr double least = 0.02, times_force = 3;
    if (!out_.forces || !out_.forces->unbalance || !given_.tangential_forces)
      return false;
    const packing::Unbalance& left = *out_.forces->unbalance;
    return left.moment_ratio > std::max(least, times_force * left.force_ratio) + given_.force_rounding;
  }

  void judge_moments() {
    if (bodies_)
      out_.moments = "grains are parts of rigid bodies";
    else if (turning_resisted())
      out_.moments = "contacts resist rolling or twisting";
    else if (given_.contact_moments || moments_are_left())
      out_.moments = "contacts carry moments (rolling resistance, bonds, clumps)";
  }

  /// Closed forms are of single spheres; rung 3 is calibrated without moments but those of rolling.
  void withhold_closed_forms() {
    for (ClosedForm& form : out_.closed_forms) {
      const bool known = out_.moments.empty() || out_.state->rolling > 0;
      if (!bodies_ && (known || form.rung->name != effective::RungName::relaxed))
        continue;
      form.answer.reset();
      form.refusal =
          "not evaluated: " + out_.moments +
          (bodies_ ? "; closed forms are for single spheres"
                   : "; the calibration is for single spheres, without moments but of rolling resistance");
    }
  }

  void measure_load() {
    if (!forces_known_)
      return;
    if (wanted_.force_bins)
      out_.forces = measure_forces(assembly_, given_, *wanted_.force_bins);
    judge_moments();
    if (!given_.tangential_forces)
      out_.notes.emplace_back("tangential forces are missing: equilibrium cannot be checked, and the "
                              "stress lacks their contribution");
    out_.stress = contact_stress(moving());
  }

  /// Compares forces with the law, and finds the grain's modulus from them if it is not given.
  void find_law() {
    constexpr double any_modulus = 1e9; // forces of one exponent are proportional to it
    const double nu = given_.grain_poisson_ratio;
    const double modulus = given_.grain_shear_modulus.value_or(any_modulus);
    if (given_.adhesion)
      require_spheres_of_material();
    if (given_.law) {
      out_.law = given_.law;
      if (wanted_.law_check && forces_known_)
        out_.law_check = check_law(
            assembly_, [this](const contact::GrainMaterial&, double) { return *given_.law; }, {modulus, nu});
      return;
    }
    if (!given_.materials.empty())
      return take_materials();
    if (take_springs())
      return;
    if (forces_known_ && !given_.adhesion && (wanted_.law_check || !given_.grain_shear_modulus))
      out_.law_check = check_law(assembly_, given_.law_family, {modulus, nu});
    if (given_.grain_shear_modulus) {
      out_.grain = contact::GrainMaterial{modulus, nu};
    } else if (out_.law_check && law_is_clear(*out_.law_check, rounded_) &&
               !factors_differ(assembly_, given_.type) && out_.law_check->coefficient_ratio &&
               of_any_modulus().surface().begins_at_touch) {
      const double found = any_modulus * *out_.law_check->coefficient_ratio;
      out_.grain = contact::GrainMaterial{found, nu};
      out_.law_check->coefficient_ratio = 1;
      out_.notes.push_back("G_g of the grains = " + pretty(found, Dimension::pressure) + " with nu_g = " +
                           short_text(nu) + ", from the forces, which determine G_g/(1 - nu_g) only");
    } else {
      if (out_.law_check)
        out_.law_check->coefficient_ratio.reset();
      if (!take_hertz())
        out_.notes.emplace_back(
            "G_g of the grains is not given and cannot be found from forces and overlaps: "
            "no stiffness and no closed forms are computed");
    }
    if (out_.grain)
      out_.law = given_.law_family(*out_.grain, out_.sizes.equivalent * out_.sizes.contacts.pair_radius);
  }

  /// What adhesion changes is known of spheres whose material is given.
  void require_spheres_of_material() {
    contact::require_valid(*given_.adhesion);
    const contact::NormalLaw any = of_any_modulus();
    if (given_.law || any.power_law() == nullptr || any.power_law()->alpha() != 2)
      throw InvalidArgument("adhesion is of spheres of a material: the contact law is another");
    if (given_.stiffness_from == packing::StiffnessFrom::ratio)
      throw InvalidArgument("k_n of contacts with adhesion is not 1.5 f/d: it follows from f or d");
    if (!given_.grain_shear_modulus && given_.materials.empty())
      throw InvalidArgument(
          "adhesion needs the material of the grains: forces that contain it do not show it");
    out_.notes.emplace_back("adhesion changes k_n and k_t of the network; rungs 0 to 3 take Hertz contacts "
                            "under the mean stress");
  }

  /// The law for grains of unknown material.
  [[nodiscard]] contact::NormalLaw of_any_modulus() const {
    return given_.law_family({1e9, given_.grain_poisson_ratio}, out_.sizes.equivalent);
  }

  /// Hertz contacts of unknown materials: k_n = 1.5 f/d of each; closed forms use the mean.
  bool take_hertz() {
    const double nu = given_.grain_poisson_ratio;
    const contact::NormalLaw any = of_any_modulus();
    if (!forces_known_ || rounded_ > rough || any.power_law() == nullptr || any.power_law()->alpha() != 2)
      return false;
    const auto exponent = common_exponent(assembly_, given_.type);
    if (!exponent || !is_hertz(*exponent))
      return false;
    out_.grain = mean_material_of_forces(assembly_, nu);
    stiffness_of_ratio_ = true;
    out_.notes.push_back(
        "the forces are proportional to the overlaps to the power " + short_text(exponent->value, 5) +
        " +- " + short_text(exponent->standard_error, 2) +
        ", as for Hertz: k_n = 1.5 f/d of each contact, no material needed; closed forms use the mean, "
        "G_g = " +
        pretty(out_.grain->shear_modulus, Dimension::pressure) + " with nu_g = " + short_text(nu));
    return true;
  }

  /// Grains of several materials: closed forms use the mean over the contacts.
  void take_materials() {
    if (assembly_.contacts.empty())
      return;
    mixed_ = mixed_contacts(assembly_, given_.materials);
    out_.grain = mixed_.mean;
    out_.law = given_.law_family(*out_.grain, out_.sizes.equivalent);
    const std::string mean = "G_g = " + pretty(out_.grain->shear_modulus, Dimension::pressure) +
                             ", nu_g = " + short_text(out_.grain->poisson_ratio);
    out_.notes.push_back(mixed_.pair_shares.empty()
                             ? "all contacts are of one material, " + mean
                             : "several materials: rungs 0 to 2 use the mean over the contacts, " + mean +
                                   "; in rung 3 soft contacts take more of the strain");
    if (forces_known_ && wanted_.law_check && !given_.adhesion)
      out_.law_check = check_law(assembly_, given_.law_family, given_.materials);
  }

  /// Linear springs, if the forces show them and no other law is given.
  bool take_springs() {
    if (!given_.law_assumed || given_.grain_shear_modulus || !forces_known_)
      return false;
    const auto spring = linear_spring(assembly_);
    if (!spring)
      return false;
    // flat punches have one k_n, 2 G a/(1-nu), at every force
    constexpr double small = 0.05; // beside the grain, as assumed in the closed forms
    const double nu = given_.grain_poisson_ratio, radius = small * out_.sizes.equivalent;
    out_.law = contact::PowerLaw::flat({*spring * (1 - nu) / (2 * radius), nu}, radius);
    if (wanted_.law_check)
      out_.law_check = check_law(
          assembly_, [this](const contact::GrainMaterial&, double) { return *out_.law; }, out_.law->grain());
    out_.notes.push_back(
        "the forces are linear in the overlaps: springs of k_n = " + short_text(*spring, 6) +
        " N/m, taken as they are (--contact flat); k_t/k_n = " + short_text(tangential_ratio()) +
        (given_.tangential_ratio ? ""
         : stiffness_of_files()  ? " by the files"
                                 : " is assumed, LAMMPS' gran/hooke has 2/7 (--tangential-ratio)"));
    return true;
  }

  /// k_t/k_n of the closed forms: given, of the sums in the files (uniform strain adds them), or Mindlin's.
  [[nodiscard]] double tangential_ratio() const {
    if (given_.tangential_ratio)
      return contact::given_stiffness_ratio(*given_.tangential_ratio);
    if (stiffness_of_files()) {
      double k_n = 0, k_t = 0;
      for (const packing::Contact& c : assembly_.contacts) {
        k_n += c.normal_stiffness;
        k_t += c.tangential_stiffness;
      }
      return k_t / k_n;
    }
    const double nu = out_.grain ? out_.grain->poisson_ratio : given_.grain_poisson_ratio;
    return contact::mindlin_stiffness_ratio(nu);
  }

  [[nodiscard]] bool pulls() const {
    return std::any_of(assembly_.contacts.begin(), assembly_.contacts.end(),
                       [](const packing::Contact& c) { return c.normal_force < 0; });
  }

  /// Rolling stiffness over k_n R*^2, by sums; 0 beyond the calibration of rung 3, or with twisting.
  [[nodiscard]] double rolling() {
    if (!turning_resisted() || given_.twisting || bodies_ || pulls() || !find_stiffness())
      return 0;
    double springs = 0, normals = 0, squares = 0;
    for (const packing::Contact& c : stiff_->contacts) {
      const double r_i = assembly_.radius[c.i], r_j = assembly_.radius[c.j],
                   reduced = r_i * r_j / (r_i + r_j), normal = c.normal_stiffness * reduced * reduced;
      if (c.twisting_stiffness > 0)
        return 0;
      springs += c.rolling_stiffness;
      normals += normal;
      squares += normal > 0 ? c.rolling_stiffness * (c.rolling_stiffness / normal) : 0;
    }
    if (!(springs > 0 && normals > 0))
      return 0;
    constexpr double uneven = 0.05, rounding = 1e-9;
    const double k_r = springs / normals, deviation = std::sqrt(squares * normals / (springs * springs) - 1);
    const bool known = k_r <= 1 + rounding;
    out_.notes.push_back(
        "rolling stiffness is " + short_text(k_r) + " k_n R*^2" +
        (deviation > uneven
             ? " in the mean, with a standard deviation of " + short_text(100 * deviation, 2) + " %"
             : "") +
        (known ? ": rung 3 takes it the same for all contacts" : ": rung 3 was fitted up to 1"));
    return known ? std::min(k_r, 1.0) : 0;
  }

  /// Q of the counted contacts; not of bodies, nor where contacts pull.
  [[nodiscard]] std::optional<double> unevenness() const {
    if (!forces_known_ || bodies_ || pulls())
      return std::nullopt;
    const packing::Assembly counted = counted_part(assembly_, *out_.law);
    return force_unevenness(counted, *out_.law, out_.sizes.equivalent * out_.sizes.contacts.pair_radius,
                            relative_stiffnesses(counted, given_.materials, mixed_.mean));
  }

  /// Input of the closed forms, or a note about missing data.
  void make_state() {
    if (!out_.law)
      return;
    if (!out_.stress || !out_.fabric) {
      out_.notes.emplace_back("no closed forms: they need forces of at least two contacts");
      return;
    }
    const Mat3& by_contacts = wanted_.window ? out_.interior->stress : out_.stress->symmetric;
    const stress::AxialStress load = given_.stress.value_or(
        stress::AxialStress{.v = by_contacts(2, 2), .h = (by_contacts(0, 0) + by_contacts(1, 1)) / 2});
    const Microstructure micro = out_.microstructure();
    effective::State state{.law = *out_.law,
                           .tangential_ratio = tangential_ratio(),
                           .radius = out_.sizes.equivalent,
                           .void_ratio = out_.interior_void_ratio(),
                           .coordination_number = micro.coordination_number,
                           .mechanical_coordination_number = micro.mechanical_coordination_number,
                           .fabric_anisotropy = micro.fabric_anisotropy,
                           .stress_v = load.v,
                           .stress_h = load.h,
                           .contacts = out_.sizes.contacts,
                           .pair_shares = mixed_.pair_shares};
    if (const std::optional<double> Q = unevenness()) {
      state.unevenness = effective::Unevenness{.value = *Q};
      if (out_.forces)
        out_.forces->unevenness = Q;
    }
    state.rolling = rolling();
    try {
      effective::require_valid(state);
      out_.state = state;
    } catch (const InvalidArgument& error) {
      out_.notes.push_back(std::string("no closed forms: ") + error.what());
    }
  }

  [[nodiscard]] bool stiffness_of_files() const {
    const auto stiff = [](const packing::Contact& c) { return c.normal_stiffness > 0; };
    return !given_.stiffness_from && !given_.adhesion &&
           std::any_of(assembly_.contacts.begin(), assembly_.contacts.end(), stiff);
  }

  /// Sets the stiffnesses of the contacts, once. Returns whether they are known.
  bool find_stiffness() {
    if (stiff_)
      return true;
    if (stiffness_of_files()) {
      if (!given_.law)
        out_.notes.push_back(
            "k_n and k_t of the network are those of the files" +
            (given_.tangential_ratio ? "" : "; closed forms: k_t/k_n = " + short_text(tangential_ratio())));
      stiff_ = assembly_;
    } else if (given_.stiffness_from.value_or(stiffness_of_ratio_ ? packing::StiffnessFrom::ratio
                                                                  : packing::StiffnessFrom::overlap) ==
               packing::StiffnessFrom::ratio) {
      stiff_ = assembly_;
      assign_stiffness_of_ratio(*stiff_, tangential_ratio());
      if (!stiffness_of_ratio_)
        out_.notes.emplace_back("k_n of the network is 1.5 f/d of each contact: Hertz without a material");
    } else if (out_.law) {
      stiff_ = with_stiffness();
    } else {
      return false;
    }
    if (given_.rolling)
      assign_rolling_stiffness(*stiff_, *given_.rolling);
    if (given_.twisting)
      assign_twisting_stiffness(*stiff_, *given_.twisting);
    return true;
  }

  /// The assembly with k_n and k_t of its contacts by the law.
  packing::Assembly with_stiffness() {
    packing::Assembly assembly = assembly_;
    // The zero of the overlap of rough grains is a convention of their law; the force of a contact is not.
    const bool by_forces = forces_known_ && (rounded_ > rough || !out_.law->surface().begins_at_touch);
    const packing::StiffnessFrom from = given_.stiffness_from.value_or(
        by_forces ? packing::StiffnessFrom::force : packing::StiffnessFrom::overlap);
    if (given_.adhesion)
      assign_adhesive_stiffness(assembly, *given_.adhesion,
                                given_.materials.empty()
                                    ? std::vector(assembly.grain_count(), out_.grain.value())
                                    : given_.materials,
                                given_.tangential_ratio, from);
    else if (!given_.materials.empty())
      assign_hertz_stiffness(assembly, given_.materials, given_.tangential_ratio, from);
    else if (out_.grain && out_.law->depends_on_size() && out_.sizes.smallest != out_.sizes.largest)
      assign_stiffness_by_size(assembly, *out_.law, tangential_ratio(), from);
    else
      assign_stiffness(assembly, *out_.law, tangential_ratio(), from);
    out_.notes.emplace_back(from == packing::StiffnessFrom::force
                                ? "k_n of the network follows from the forces"
                                : "k_n of the network follows from the overlaps");
    return assembly;
  }

  void solve_network(const packing::Assembly& assembly) {
    network::ResponseOptions options = *wanted_.network;
    options.force_terms = options.force_terms && !bodies_ && !turning_resisted() && !given_.adhesion;
    const network::Response response = network::linear_response(assembly, options);
    out_.network =
        Network{.response = response,
                .affine = network_matrix(response.affine(), out_.bulk_density),
                .affine_all = network_matrix(network::affine_all(assembly, options), out_.bulk_density),
                .relaxed = network_matrix(response.last_iterate(), out_.bulk_density),
                .bulk_bounds = bounds_of(assembly)};
  }

  /// Bounds, valid for contacts without moments and branches along the normals.
  [[nodiscard]] packing::BulkModulusBounds bounds_of(const packing::Assembly& assembly) const {
    return out_.moments.empty() ? bulk_modulus_bounds(assembly) : packing::BulkModulusBounds{};
  }

  const packing::Assembly& assembly_;
  std::optional<packing::Bodies> bodies_;
  const Given& given_;
  const Wanted& wanted_;
  static constexpr double rough = 1e-2; ///< rounding of overlaps above which forces give k_n
  bool forces_known_;
  double rounded_;                         ///< share by which overlaps may be off
  bool stiffness_of_ratio_ = false;        ///< k_n is 1.5 f/d
  effective::MixedContacts mixed_;         ///< of several materials
  std::optional<packing::Assembly> stiff_; ///< with the stiffnesses of its contacts
  Measurement out_;
};

} // namespace

Wanted everything() {
  return {.fabric_tests = true,
          .rose_bins = 18,
          .force_bins = 32,
          .law_check = true,
          .closed_forms = true,
          .network = network::ResponseOptions{}};
}

packing::Assembly stiffened(const packing::Assembly& assembly, const Given& given) {
  return Measuring(assembly, given, {}).stiffened();
}

Measurement measure(const packing::Assembly& assembly, const Given& given, const Wanted& wanted) {
  packing::require_space(assembly);
  return Measuring(assembly, given, wanted).run();
}

} // namespace granum::analysis
