// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_fields.hpp"

#include <fmt/core.h>
#include <granum/core/text.hpp>

#include "cli/options/packing_json.hpp"

namespace granum::cli {

namespace {

using analysis::Counts;
using analysis::Fabric;
using analysis::Forces;
using analysis::LawCheck;
using analysis::Measurement;
using io::ShownColumn;
using packing::ContactStress;

constexpr double MPa = 1e6, percent = 0.01;

/// A line of a list, with so many digits behind the point.
ShownColumn item(std::string label, int digits = 4, std::string meaning = "") {
  return {.heading = std::move(label), .digits = digits, .fixed = true, .meaning = std::move(meaning)};
}
/// The same with so many significant digits.
ShownColumn rounded(std::string label, int digits, std::string meaning = "") {
  return {.heading = std::move(label), .digits = digits, .meaning = std::move(meaning)};
}
ShownColumn share(std::string label, std::string meaning = "") {
  return {.heading = std::move(label), .unit = percent, .symbol = " %", .meaning = std::move(meaning)};
}
ShownColumn in_unit(std::string label, Dimension dimension, std::string meaning = "") {
  return {.heading = std::move(label), .dimension = dimension, .meaning = std::move(meaning)};
}
/// A column of a table, in lists too.
ShownColumn column(std::string heading, int width, int digits, std::string meaning = "") {
  return {.heading = std::move(heading),
          .width = width,
          .digits = digits,
          .fixed = true,
          .absent = "-",
          .meaning = std::move(meaning)};
}

/// A member of an optional part.
template <class Whole, class Part, class Of>
auto of_part(std::optional<Part> Whole::*part, Of of) {
  return [part, of](const Whole& whole) {
    using Got = std::remove_cvref_t<std::invoke_result_t<Of, const Part&>>;
    return whole.*part ? std::optional<Got>(std::invoke(of, *(whole.*part))) : std::nullopt;
  };
}

std::string verdict(double p_value, const char* yes, const char* no) {
  constexpr double doubt = 0.01;
  return fmt::format("{}, p-value {}", p_value < doubt ? no : yes, short_text(p_value, 2));
}

/// Adds a test of a fabric: its result for the terminal, and its numbers for JSON.
template <class Test>
void add_test(io::Columns<Fabric>& to, const std::string& key, std::optional<Test> Fabric::*test,
              fabric::ChiSquareTest Test::*chi_square, const char* question) {
  const auto of = [&](auto member) {
    return of_part(test, [=](const Test& t) { return t.*chi_square.*member; });
  };
  to.emplace_back("", "",
                  of_part(test, [=](const Test& t) { return verdict((t.*chi_square).p_value, "yes", "no"); }),
                  item(question, 4, "at a level of 0.01"));
  to.emplace_back("", key + "/chi_square", of(&fabric::ChiSquareTest::statistic));
  to.emplace_back("", key + "/degrees_of_freedom", of(&fabric::ChiSquareTest::degrees_of_freedom));
  to.emplace_back("", key + "/p_value", of(&fabric::ChiSquareTest::p_value));
}

std::vector<std::vector<double>> rows(const Mat3& m) {
  std::vector<std::vector<double>> out;
  for (const auto& row : m.m)
    out.emplace_back(std::begin(row), std::end(row));
  return out;
}

} // namespace

const io::Columns<Measurement>& packing_fields() {
  const auto unequal = [](auto of) {
    return [of](const Measurement& m) {
      const bool equal = m.sizes.smallest == m.sizes.largest;
      return equal ? std::nullopt : std::optional(of(m.sizes));
    };
  };
  static const io::Columns<Measurement> fields = {
      {"", "volume", &Measurement::volume},
      {"", "radius/smallest", [](const Measurement& m) { return m.sizes.smallest; }},
      {"", "", unequal([](const analysis::Sizes& s) { return s.smallest; }),
       in_unit("smallest R", Dimension::length)},
      {"", "radius/largest", [](const Measurement& m) { return m.sizes.largest; },
       in_unit("largest R", Dimension::length)},
      {"", "radius/equivalent", [](const Measurement& m) { return m.sizes.equivalent; },
       in_unit("R of closed forms", Dimension::length, "<R^3>/<R^2>")},
      {"", "", unequal([](const analysis::Sizes& s) { return s.gradation.uniformity(); }),
       item("C_u = d60/d10", 4, "by mass")},
      {"", "", unequal([](const analysis::Sizes& s) { return gradation_text(s.gradation); }), item("")},
      {"e", "void_ratio", &Measurement::void_ratio, column("e", 7, 4, "void ratio")},
  };
  return fields;
}

const io::Columns<Counts>& grain_count_fields() {
  static const io::Columns<Counts> fields = {
      {"", "grains", &Counts::grains, item("grains")},
      {"wall_contacts", "wall_contacts", &Counts::wall_contacts, item("contacts with walls")},
  };
  return fields;
}

io::Columns<Counts> contact_count_fields(const std::string& counted) {
  const auto mechanical = [](auto member) { return [=](const Counts& c) { return c.mechanical.*member; }; };
  using Mechanical = packing::MechanicalCoordination;
  return {
      {"", "contacts", &Counts::contacts, item("contacts N_c")},
      {"C_n", "coordination_number", &Counts::coordination_number,
       column("C_n", 7, 4, "2 N_c/N, all " + counted)},
      {"z_star", "mechanical_coordination_number", mechanical(&Mechanical::coordination_number),
       column("z*", 7, 4, "without rattlers")},
      {"rattler_fraction", "rattler_fraction", mechanical(&Mechanical::rattler_fraction),
       share("rattlers", "of the " + counted)},
      {"grains_without_contact", "grains_without_contact", &Counts::without_contact,
       item(counted + " without contact")},
      {"", "touching_coordination_number", &Counts::touching_coordination_number,
       item("C_n of touching " + counted)},
      {"", "coordination_number_with_walls", &Counts::coordination_number_with_walls,
       item("C_n with walls", 4, "(2 N_c + wall contacts)/N")},
      {"", "rattlers", mechanical(&Mechanical::rattler_count)},
  };
}

const io::Columns<analysis::InteriorMeasures>& window_fields() {
  using analysis::InteriorMeasures;
  using analysis::Microstructure;
  const auto micro = [](double Microstructure::*member) {
    return [=](const InteriorMeasures& in) { return in.micro.*member; };
  };
  static const io::Columns<InteriorMeasures> fields = {
      {"", "grains", &InteriorMeasures::grains, item("grains", 0, "with their centres inside")},
      {"", "void_ratio", &InteriorMeasures::void_ratio, item("void ratio e", 4, "of whole and cut grains")},
      {"", "coordination_number", micro(&Microstructure::coordination_number),
       item("C_n", 4, "of these grains, without walls")},
      {"", "mechanical_coordination_number", micro(&Microstructure::mechanical_coordination_number),
       item("z*")},
      {"", "rattler_fraction", micro(&Microstructure::rattler_fraction), share("rattlers")},
      {"", "anisotropy", micro(&Microstructure::fabric_anisotropy)},
      {"", "",
       [](const InteriorMeasures& in) {
         return Measured{in.micro.fabric_anisotropy, in.micro.fabric_anisotropy_error};
       },
       item("a")},
      {"", "",
       [](const InteriorMeasures& in) {
         return std::vector<double>{in.stress(0, 0), in.stress(1, 1), in.stress(2, 2)};
       },
       ShownColumn{.heading = "stress xx yy zz [kPa]", .digits = 6, .unit = 1e3}},
      {"", "stress", [](const InteriorMeasures& in) { return rows(in.stress); }},
  };
  return fields;
}

const io::Columns<Fabric>& fabric_fields() {
  static const io::Columns<Fabric> fields = [] {
    using Likelihood = fabric::LikelihoodEstimate;
    const auto entries = [](std::array<std::pair<int, int>, 3> places) {
      return [=](const Fabric& f) {
        std::vector<double> out;
        for (const auto& [i, j] : places)
          out.push_back(f.tensor(i, j));
        return out;
      };
    };
    const auto moment = [](const Fabric& f) { return f.by_moment.anisotropy; };
    ShownColumn a = column("a", 7, 3);
    a.listed = false; // there with its error
    io::Columns<Fabric> list = {
        {"", "tensor", [](const Fabric& f) { return rows(f.tensor); }},
        {"", "", entries({{{0, 0}, {1, 1}, {2, 2}}}), item("F_11 F_22 F_33", 5)},
        {"", "", entries({{{1, 2}, {0, 2}, {0, 1}}}), item("F_23 F_13 F_12", 5)},
        {"a", "anisotropy", moment, a},
        {"a_error", "anisotropy_standard_error", [](const Fabric& f) { return f.by_moment.standard_error; }},
        {"", "",
         [](const Fabric& f) {
           return Measured{f.by_moment.anisotropy, f.by_moment.standard_error};
         },
         item("a", 4, "anisotropy, from F_33")},
        {"", "most_likely_anisotropy", of_part(&Fabric::by_likelihood, &Likelihood::anisotropy)},
        {"", "most_likely_anisotropy_standard_error",
         of_part(&Fabric::by_likelihood, &Likelihood::standard_error)},
        {"", "",
         of_part(&Fabric::by_likelihood,
                 [](const Likelihood& l) {
                   return Measured{l.anisotropy, l.standard_error};
                 }),
         item("a", 4, "the same, most likely")},
        {"", "isotropy/z_score", of_part(&Fabric::isotropy, &fabric::IsotropyTest::z_score)},
        {"", "isotropy/p_value", of_part(&Fabric::isotropy, &fabric::IsotropyTest::p_value)},
        {"", "",
         of_part(&Fabric::isotropy,
                 [](const fabric::IsotropyTest& t) { return verdict(t.p_value, "no", "yes"); }),
         item("a differs from 0?", 4, "at a level of 0.01")},
    };
    add_test(list, "density", &Fabric::density, &fabric::DensityTest::chi_square, "E(gamma; a) fits?");
    add_test(list, "axisymmetry", &Fabric::axisymmetry, &fabric::AxisymmetryTest::both, "symmetric about z?");
    return list;
  }();
  return fields;
}

const io::Columns<ContactStress>& stress_fields() {
  static const io::Columns<ContactStress> fields = [] {
    io::Columns<ContactStress> list = {
        {"sigma_v_Pa", "", [](const ContactStress& s) { return s.symmetric(2, 2); }},
        {"sigma_h_Pa", "",
         [](const ContactStress& s) { return (s.symmetric(0, 0) + s.symmetric(1, 1)) / 2; }},
        {"p_Pa", "mean", &ContactStress::mean,
         ShownColumn{
             .heading = "p [kPa]", .width = 9, .digits = 5, .unit = 1e3, .absent = "-", .meaning = "mean"}},
        {"", "asymmetry", &ContactStress::asymmetry, rounded("asymmetry", 2, "of the tensor, relative")},
    };
    for (std::size_t k = 0; k < std::size(studies::stress_names); ++k)
      list.emplace_back(std::string("stress_") + studies::stress_names[k] + "_Pa",
                        std::string("by_contacts/") + studies::stress_names[k],
                        [k](const ContactStress& s) { return studies::printed(s)[k]; });
    return list;
  }();
  return fields;
}

const io::Columns<Forces>& force_fields() {
  const auto of = [](auto member) { return [=](const Forces& f) { return f.distribution.*member; }; };
  const auto anisotropy_of = [](auto part) {
    return of_part(part, [](const fabric::AnisotropyEstimate& a) {
      return Measured{a.anisotropy, a.standard_error};
    });
  };
  using packing::ForceDistribution;
  using packing::Unbalance;
  static const io::Columns<Forces> fields = {
      {"", "pressing", of(&ForceDistribution::pressing), item("pressing contacts")},
      {"", "in_tension", of(&ForceDistribution::in_tension), item("contacts in tension")},
      {"", "unloaded", of(&ForceDistribution::unloaded), item("unloaded contacts")},
      {"f_n_mean_N", "mean_normal_force", of(&ForceDistribution::mean),
       in_unit("mean f_n", Dimension::force, "of pressing contacts")},
      {"", "largest_normal_force", of(&ForceDistribution::largest), in_unit("largest f_n", Dimension::force)},
      {"Z_2", "Z_2", &Forces::Z_2, item("Z(2)", 4, "<f_n^2>/<f_n>^2")},
      {"", "Z_5_3", &Forces::Z_5_3, item("Z(5/3)", 4, "<f_n^(5/3)>/<f_n>^(5/3)")},
      {"unevenness", "unevenness", &Forces::unevenness,
       item("unevenness Q", 4, "ln of K under uniform strain over that of equal forces")},
      {"a_strong", "strong_anisotropy", anisotropy_of(&Forces::strong),
       item("a, strong contacts", 3, "f_n above the mean")},
      {"a_weak", "weak_anisotropy", anisotropy_of(&Forces::weak),
       item("a, weak contacts", 3, "f_n up to the mean")},
      {"", "mean_tangential_over_normal", io::or_null(&Forces::mean_tangential_over_normal),
       item("mean f_t/mean f_n")},
      {"", "friction_coefficient",
       io::or_null(of_part(&Forces::friction, &packing::FrictionEstimate::coefficient)),
       item("friction coefficient", 4, "f_t/f_n of the sliding contacts")},
      {"", "", of_part(&Forces::friction, &packing::FrictionEstimate::contacts),
       item("contacts at friction", 0, "f_t/f_n within 1e-4 of the coefficient")},
      {"sliding_fraction", "sliding_fraction", io::or_null(&Forces::sliding_fraction),
       share("sliding contacts", "f_t within 1e-3 of coefficient x f_n")},
      {"", "", [](const Forces& f) { return f.unbalance ? std::nullopt : std::optional("unknown"); },
       item("unbalanced force", 0, "tangential forces not known")},
      {"unbalanced_force_ratio", "unbalanced_force_ratio",
       io::or_null(of_part(&Forces::unbalance, &Unbalance::force_ratio)),
       rounded("unbalanced force", 3, "mean net force on a grain over mean contact force")},
      {"unbalanced_moment_ratio", "unbalanced_moment_ratio",
       io::or_null(of_part(&Forces::unbalance, &Unbalance::moment_ratio)),
       rounded("unbalanced moment", 3, "mean net moment on a grain over mean contact force x mean radius")},
      {"", "", of_part(&Forces::weight, [](const packing::Weight& w) { return 1 - w.left_over; }),
       share("part due to weight")},
      {"", "", of_part(&Forces::weight, [](const packing::Weight& w) { return norm(w.per_volume); }),
       ShownColumn{.heading = "weight", .unit = 1e3, .symbol = " kN per m3", .meaning = "of solid"}},
      {"", "weight_per_solid_volume",
       of_part(&Forces::weight, [](const packing::Weight& w) { return values(w.per_volume); })},
      {"", "unbalanced_over_weight", of_part(&Forces::weight, &packing::Weight::left_over)},
  };
  return fields;
}

const io::Columns<LawCheck>& law_fields() {
  static const io::Columns<LawCheck> fields = {
      {"", "contacts", &LawCheck::contacts, item("contacts")},
      {"", "left_out", &LawCheck::left_out,
       item("contacts left out", 0, "without overlap or force, or below 1e-3 of the mean force")},
      {"", "force_exponent", io::or_null(&LawCheck::force_exponent), item("f_n ~ d^x, x", 6)},
      {"", "alpha", io::or_null(&LawCheck::alpha), item("alpha", 6, "cone 1, sphere 2")},
      {"", "force_over_law", &LawCheck::coefficient_ratio,
       rounded("force over law", 8, "median of f_n over the law's force")},
      {"", "median_misfit", &LawCheck::median_misfit,
       rounded("misfit", 2, "median of |f_n/(median x law) - 1|")},
      {"", "misfit_90", &LawCheck::misfit_90, rounded("misfit", 2, "90th percentile")},
      {"", "worst_misfit", &LawCheck::worst_misfit, rounded("misfit", 2, "worst")},
  };
  return fields;
}

const io::Columns<RungResult>& rung_fields() {
  static const io::Columns<RungResult> fields = [] {
    using effective::ModulusErrors;
    using studies::Moduli;
    const auto refusal = [](const RungResult& r) { return r.moduli ? std::nullopt : std::optional(r.error); };
    io::Columns<RungResult> list = {
        {"", "error", refusal}, {"", "", &RungResult::title, ShownColumn{.heading = "[MPa]", .width = -16}}};
    const auto modulus = [&](const std::string& heading, const std::string& name, double Moduli::*of,
                             int width = 7, bool isotropic = false) {
      list.emplace_back(
          heading, name,
          [=](const RungResult& r) {
            return r.moduli && (isotropic || r.one_axis) ? std::optional((*r.moduli).*of) : std::nullopt;
          },
          ShownColumn{.heading = name, .width = width, .unit = MPa, .absent = "-"});
    };
    modulus("K", "K", &Moduli::K, 7, true);
    modulus("G", "G", &Moduli::G, 7, true);
    modulus("G_hh", "G_hh", &Moduli::G_hh);
    modulus("G_vh", "G_vh", &Moduli::G_vh);
    modulus("", "C11", &Moduli::C11);
    modulus("", "C33", &Moduli::C33);
    modulus("", "C12", &Moduli::C12, 0);
    modulus("", "C13", &Moduli::C13, 0);
    const auto add = [&](const char* key, auto of, std::optional<ShownColumn> shown = {}) {
      list.emplace_back("", key, of, std::move(shown));
    };
    const auto error = [](double ModulusErrors::*of) { return of_part(&RungResult::relative_error, of); };
    add("relative_error/K", error(&ModulusErrors::bulk_modulus));
    add("relative_error/G", error(&ModulusErrors::G_vh)); // as that of vertical planes
    add("relative_error/G_hh", error(&ModulusErrors::G_hh));
    for (const auto& [key, heading, of] :
         {std::tuple{"measured_over_this/K", "net/K", &RungResult::network_over_K},
          {"measured_over_this/G", "net/G", &RungResult::network_over_G}})
      add(key, of, ShownColumn{.heading = heading, .width = 7, .digits = 3, .fixed = true});
    add("relative_error/G_vh", error(&ModulusErrors::G_vh),
        ShownColumn{.heading = "error", .width = 7, .digits = 2, .unit = percent, .symbol = " %"});
    return list;
  }();
  return fields;
}

const io::Columns<analysis::Network>& network_fields() {
  using analysis::Network;
  using Report = network::Response::Report;
  const auto report = [](auto member) {
    return [=](const Network& n) { return n.response.report().*member; };
  };
  static const io::Columns<Network> fields = {
      {"", "converged", [](const Network& n) { return n.response.converged(); }},
      {"", "grains", report(&Report::grains)},
      {"", "contacts", report(&Report::contacts)},
      {"", "iterations", report(&Report::iterations)},
      {"", "residual", report(&Report::residual)},
      {"", "distance_from_isotropy", [](const Network& n) { return n.relaxed.symmetry.isotropic; }},
      {"", "distance_from_transverse_isotropy",
       [](const Network& n) { return n.relaxed.symmetry.transversely_isotropic; }},
      {"", "K_lower", [](const Network& n) { return n.bulk_bounds.lower; }},
      {"", "K_upper", [](const Network& n) { return n.bulk_bounds.upper; }},
  };
  return fields;
}

std::vector<NamedMatrix> network_matrices(const FrameAnswer& frame) {
  if (!frame.measured.packing.network)
    return {};
  const analysis::Network& network = *frame.measured.packing.network;
  std::vector<NamedMatrix> out{{"affine", &network.affine}, {"affine_all", &network.affine_all}};
  if (network.response.converged())
    out.push_back({"relaxed", &network.relaxed});
  return out;
}

const io::Columns<NamedMatrix>& matrix_fields() {
  static const io::Columns<NamedMatrix> fields = [] {
    using elastic::EngineeringModuli;
    io::Columns<NamedMatrix> list = {
        {"", "", &NamedMatrix::name, ShownColumn{.heading = "[MPa]", .width = -11}},
        {"", "C",
         [](const NamedMatrix& m) {
           std::vector<std::vector<double>> out(6);
           for (int k = 0; k < 36; ++k)
             out[static_cast<std::size_t>(k / 6)].push_back(m.matrix->stiffness.matrix(k / 6, k % 6));
           return out;
         }},
        {"distance_from_isotropy", "distance_from_isotropy",
         [](const NamedMatrix& m) { return m.matrix->symmetry.isotropic; }},
        {"distance_from_transverse_isotropy", "distance_from_transverse_isotropy",
         [](const NamedMatrix& m) { return m.matrix->symmetry.transversely_isotropic; }}};
    for (const auto& [name, of] : {std::pair{"K", &EngineeringModuli::bulk_modulus},
                                   {"E_1", &EngineeringModuli::E_1},
                                   {"E_2", &EngineeringModuli::E_2},
                                   {"E_3", &EngineeringModuli::E_3},
                                   {"C44", &EngineeringModuli::C44},
                                   {"C55", &EngineeringModuli::C55},
                                   {"C66", &EngineeringModuli::C66}})
      list.emplace_back(
          std::string(name) + "_Pa", std::string("engineering_moduli/") + name,
          [of = of](const NamedMatrix& m) { return m.matrix->moduli.*of; },
          ShownColumn{.heading = name, .width = 9, .unit = MPa});
    return list;
  }();
  return fields;
}

const io::Columns<network::Mode>& mode_fields() {
  static const io::Columns<network::Mode> fields = {
      {"frequency_Hz", "frequency", &network::Mode::frequency,
       ShownColumn{.heading = "f [Hz]", .width = 14, .digits = 6}},
      {"participation_ratio", "participation_ratio", &network::Mode::participation_ratio,
       column("participation", 14, 4)}};
  return fields;
}

const io::Columns<NamedMatrix>& wave_fields() {
  static const io::Columns<NamedMatrix> fields = [] {
    using elastic::PlaneWaves;
    io::Columns<NamedMatrix> list = {
        {"", "", &NamedMatrix::name, ShownColumn{.heading = "[m/s]", .width = -11}},
        {"", "wave_speeds",
         [](const NamedMatrix& m) { return m.matrix->waves ? io::Value() : io::Value(nullptr); }}};
    for (const std::size_t axis : {0U, 1U, 2U})
      for (const auto& [name, of] : {std::pair{"fastest", &PlaneWaves::fastest},
                                     {"middle", &PlaneWaves::middle},
                                     {"slowest", &PlaneWaves::slowest}}) {
        const std::string along = std::to_string(axis + 1);
        const bool first = of == &PlaneWaves::fastest;
        list.emplace_back(
            "v_" + along + "_" + name + "_m_per_s", "wave_speeds/along_" + along + "/" + name,
            [axis, of = of](const NamedMatrix& m) {
              const auto& waves = m.matrix->waves;
              return waves ? std::optional(((*waves)[axis].*of).speed) : std::nullopt;
            },
            ShownColumn{.heading = first ? "along " + along : "", .width = first ? 9 : 7});
      }
    return list;
  }();
  return fields;
}

namespace {

/// Columns of a rung in a series of states: its title, and exponents.
const io::Column<RungSeries> title_of_rung{"", "", &RungSeries::title,
                                           ShownColumn{.heading = "G ~ p^s", .width = -24}};

ShownColumn exponent(std::string heading) {
  return {.heading = std::move(heading), .width = 26, .fixed = true, .absent = "-"};
}

} // namespace

const io::Columns<RungSeries>& sum_fields() {
  static const io::Columns<RungSeries> fields = [] {
    const auto fit = [](std::optional<hardin::Fit> studies::SeriesFit::*of, Measured hardin::Fit::*part) {
      return
          [=](const RungSeries& r) { return r.fit.*of ? std::optional((*(r.fit.*of)).*part) : std::nullopt; };
    };
    using studies::SeriesFit;
    return io::Columns<RungSeries>{title_of_rung,
                                   {"", "states", [](const RungSeries& r) { return r.fit.states; }},
                                   {"", "remark", [](const RungSeries& r) { return r.fit.remark; }},
                                   {"", "C", fit(&SeriesFit::sum, &hardin::Fit::coefficient)},
                                   {"", "s", fit(&SeriesFit::sum, &hardin::Fit::exponent_sum), exponent("s")},
                                   {"", "s_with_void_ratio_function",
                                    fit(&SeriesFit::sum_with_void_ratio, &hardin::Fit::exponent_sum),
                                    exponent("s with f(e)")}};
  }();
  return fields;
}

const io::Columns<RungSeries>& separate_fields() {
  const auto part = [](std::optional<Measured> hardin::Fit::*of) {
    return of_part(&RungSeries::separate, [=](const hardin::Fit& fit) { return *(fit.*of); });
  };
  static const io::Columns<RungSeries> fields = {
      title_of_rung,
      {"", "separate_remark", [](const RungSeries& r) { return r.separate_remark; }},
      {"", "m", part(&hardin::Fit::exponent_j), exponent("m (sigma_h), G_vh")},
      {"", "n", part(&hardin::Fit::exponent_i), exponent("n (sigma_v), G_vh")}};
  return fields;
}

} // namespace granum::cli
