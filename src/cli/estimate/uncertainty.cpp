// SPDX-License-Identifier: GPL-3.0-or-later
#include "uncertainty.hpp"

#include <algorithm>
#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/format.h>
#include <granum/contact/pair.hpp>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "estimate.hpp"

namespace granum::cli {

std::string key_of(const Number& number) { return number.name.substr(2); }

namespace {

using effective::Input;
using effective::Modulus;

/// More rejected draws than this are worth a remark.
constexpr double many_rejected = 0.01;

effective::RungInputs packing_of(const PackingOptions& o) {
  return {resolve_state(o, resolve_stresses(o)), resolve_mechanical_coordination_number(o)};
}

// ---- inputs

/// Whether the packing is made of this number: it is given, or its default is taken.
bool in_use(const PackingOptions& o, const Number& n) {
  const Number* const defaults[] = {&o.grain_shear_modulus, &o.grain_poisson_ratio, &o.radius,
                                    &o.coordination_number, &o.fabric};
  const bool radius_known = o.d50.given() || (o.sizes && o.sizes->mean_radius());
  const bool by_default = std::find(std::begin(defaults), std::end(defaults), &n) != std::end(defaults) &&
                          !(&n == &o.radius && radius_known);
  const bool of_contact = std::any_of(o.law_numbers.begin(), o.law_numbers.end(), [&](const LawNumber& of) {
    return &n == &of.number && o.contact == of.row->shape;
  });
  return n.given() || by_default || of_contact;
}

/// How the inputs of the closed forms move with a number of the options. A profile moves the coefficient of
/// the contact law, c ~ G_g A^(-1/alpha), as G_g would.
std::array<double, effective::input_count> slopes_of(const PackingOptions& o, const Number& n,
                                                     const effective::RungInputs& packing) {
  const effective::State& s = packing.state;
  const double shear = s.law.grain().shear_modulus, e = s.void_ratio;
  const double z = packing.mechanical_coordination_number.value_or(0);
  const double of_size = contact::row_of(o.contact).depends_on_size ? shear / 2 : 0; // c ~ sqrt(R)
  const Number &cone_slope = o.law_number("cone_slope"), &punch_radius = o.law_number("punch_radius"),
               &profile = o.law_number("profile_constant");
  const double alpha = s.law.power_law() != nullptr ? s.law.power_law()->alpha() : 1; // else unused
  const double carrying = o.rattler_fraction.given() ? 1 - o.rattler_fraction.value : 1;
  const struct {
    const Number* number;
    Input input;
    double slope;
  } all[] = {
      {&cone_slope, Input::grain_shear_modulus, -shear / cone_slope.value},
      {&punch_radius, Input::grain_shear_modulus, shear / punch_radius.value},
      {&o.law_number("alpha"), Input::alpha, 1},
      {&profile, Input::grain_shear_modulus, -shear / (alpha * profile.value)},
      {&o.grain_shear_modulus, Input::grain_shear_modulus, 1},
      {&o.grain_poisson_ratio,
       o.tangential_ratio.given() ? Input::grain_poisson_ratio : Input::grain_poisson_ratio_mindlin, 1},
      {&o.radius, Input::radius, 1},
      {&o.radius, Input::grain_shear_modulus, of_size / s.radius},
      {&o.d50, Input::radius, s.radius / o.d50.value},
      {&o.d50, Input::grain_shear_modulus, of_size / o.d50.value},
      {&o.tangential_ratio, Input::tangential_ratio, 1},
      {&o.void_ratio, Input::void_ratio, 1},
      {&o.porosity, Input::void_ratio, (1 + e) * (1 + e)},        // e = n/(1-n)
      {&o.solid_fraction, Input::void_ratio, -(1 + e) * (1 + e)}, // e = 1/(1-n) - 1
      {&o.coordination_number, Input::coordination_number, 1},
      {&o.coordination_number, Input::mechanical_coordination_number,
       o.rattler_fraction.given() ? 1 / carrying : 0},
      {&o.mechanical_coordination_number, Input::mechanical_coordination_number, 1},
      {&o.rattler_fraction, Input::mechanical_coordination_number, z / carrying}, // z* = C_n/(1-x)
      {&o.fabric, Input::fabric_anisotropy, 1},
      {&o.pressure, Input::mean_stress, 1},
      {&o.stress_v, Input::stress_v, 1},
      {&o.stress_h, Input::stress_h, 1},
  };
  std::array<double, effective::input_count> slopes{};
  for (const auto& [number, input, slope] : all)
    if (number == &n)
      slopes[static_cast<std::size_t>(input)] = slope;
  return slopes;
}

double deviation_of(const std::string& name, const std::string& text, const Number& n) {
  if (!std::string_view(trimmed(text)).ends_with('%'))
    return require_non_negative(name, parse_quantity(name, text, n.dimension),
                                std::string(si_symbol(n.dimension)));
  const double share = require_non_negative(name, parse_quantity(name, text, Dimension::dimensionless));
  if (n.value == 0)
    throw InvalidArgument(
        fmt::format("{}={}: per cent of {} = 0 are nothing; give an absolute deviation", name, text, n.name));
  return share * std::abs(n.value);
}

UncertainInput parse(PackingOptions& o, const std::string& setting, const effective::RungInputs& packing) {
  const std::size_t split = setting.find('=');
  if (split == std::string::npos)
    throw InvalidArgument("--uncertainty " + setting + ": write key=sd, as in coordination-number=0.3");
  const std::string key(trimmed(std::string_view(setting).substr(0, split)));
  const std::vector<Number*> all = numbers(o);
  std::vector<std::string> known;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Number& n = *all[k];
    if (!in_use(o, n))
      continue;
    known.push_back(key_of(n));
    if (known.back() == key)
      return {.key = key,
              .dimension = n.dimension,
              .index = k,
              .number = {.value = n.value,
                         .deviation = deviation_of("--uncertainty " + key, setting.substr(split + 1), n),
                         .slopes = slopes_of(o, n, packing),
                         .key = key}};
  }
  throw InvalidArgument(fmt::format("--uncertainty {}: not an input of this packing, which is made of {}",
                                    key, fmt::join(known, ", ")));
}

std::vector<UncertainInput> parse_all(PackingOptions options, const std::vector<std::string>& settings,
                                      const effective::RungInputs& packing) {
  std::vector<UncertainInput> inputs;
  for (const std::string& setting : settings) {
    inputs.push_back(parse(options, setting, packing));
    const auto same = [&](const UncertainInput& other) { return other.key == inputs.back().key; };
    if (std::count_if(inputs.begin(), inputs.end(), same) > 1)
      throw InvalidArgument("--uncertainty " + inputs.back().key + " is given twice");
  }
  // In the order of the options of a packing: the order in which they were given changes no digit of a sum.
  std::sort(inputs.begin(), inputs.end(),
            [](const UncertainInput& a, const UncertainInput& b) { return a.index < b.index; });
  return inputs;
}

// ---- moduli

constexpr std::pair<const char*, Modulus> sampled_moduli[] = {
    {"K", Modulus::K},     {"G_vh", Modulus::G_vh}, {"G_hh", Modulus::G_hh},
    {"E_v", Modulus::E_v}, {"E_h", Modulus::E_h},   {"C11", Modulus::C11},
    {"C33", Modulus::C33}, {"C12", Modulus::C12},   {"C13", Modulus::C13}};

/// A modulus that the packing has, and where its uncertainty goes.
struct Target {
  const ShownForm* form;
  Modulus which;
  ModulusUncertainty* uncertainty;

  [[nodiscard]] double calibration() const {
    const auto& first = uncertainty->first_order;
    return first && uncertainty->value != 0 ? first->calibration / uncertainty->value : 0;
  }
};

std::vector<effective::UncertainNumber> numbers_of(const std::vector<UncertainInput>& inputs) {
  std::vector<effective::UncertainNumber> uncertain;
  for (const UncertainInput& input : inputs)
    uncertain.push_back(input.number);
  return uncertain;
}

std::optional<effective::FirstOrder> first_order_of(const ShownForm& form,
                                                    const effective::RungInputs& packing, Modulus which,
                                                    const UncertaintyAnswer& all, Validity& validity) {
  try {
    const auto slopes = effective::gradient(*form.rung, packing, which);
    return effective::first_order(slopes.gradient, numbers_of(all.inputs), slopes.standard_error);
  } catch (const InvalidArgument& error) {
    validity.add(
        fmt::format("some moduli under {} have no first-order uncertainty: {}", form.title, error.what()));
    return std::nullopt;
  }
}

/// The moduli at drawn values of the inputs; the last number is the error of the calibration, in units of
/// its own.
std::vector<double> values_at(std::span<const double> drawn, PackingOptions& options,
                              const std::vector<UncertainInput>& inputs, const std::vector<Target>& targets) {
  const std::vector<Number*> all = numbers(options);
  for (std::size_t k = 0; k < inputs.size(); ++k)
    all[inputs[k].index]->value = drawn[k];
  const effective::RungInputs packing = packing_of(options);
  std::vector<double> values;
  const ShownForm* solved = nullptr;
  elastic::TransverselyIsotropic stiffness;
  for (const Target& target : targets) {
    if (target.form != solved)
      stiffness = effective::answer(*target.form->rung, packing).stiffness;
    solved = target.form;
    const auto value = effective::modulus_if_any(stiffness, target.which);
    if (!value)
      throw InvalidArgument("the stiffness is not positive definite");
    values.push_back(*value * (1 + target.calibration() * drawn.back()));
  }
  return values;
}

void sample_all(const PackingOptions& options, const std::vector<Target>& targets, UncertaintyAnswer& all) {
  std::vector<effective::UncertainNumber> uncertain = numbers_of(all.inputs);
  uncertain.push_back({.value = 0, .deviation = 1, .slopes = {}, .key = "calibration"});
  PackingOptions moved = options;
  const auto evaluate = [&](std::span<const double> drawn) {
    return values_at(drawn, moved, all.inputs, targets);
  };
  const effective::Sample sample = effective::sample(uncertain, evaluate, all.sampling);
  for (std::size_t k = 0; k < targets.size(); ++k)
    targets[k].uncertainty->sampled = sample.bands[k];
  all.rejected = sample.rejected;
  if (sample.rejected_share(all.sampling) > many_rejected)
    all.validity.add(
        fmt::format("{} of {} draws are outside the range of the inputs and left out: the sampled "
                    "bands are those of the rest",
                    sample.rejected, all.sampling.draws));
}

} // namespace

std::optional<double> said_deviation(const std::string& setting, const Number& number) {
  const std::size_t split = setting.find('=');
  const std::string key(trimmed(std::string_view(setting).substr(0, split)));
  if (split == std::string::npos || key != key_of(number))
    return std::nullopt;
  return deviation_of("--uncertainty " + key, setting.substr(split + 1), number);
}

void add_uncertainty_option(CLI::App& command, std::vector<std::string>& settings) {
  command
      .add_option(
          "--uncertainty", settings,
          "Standard deviation of an input, may be repeated: coordination-number=0.3, pressure=5%; % of "
          "its value")
      ->type_name("KEY=SD")
      ->allow_extra_args(false);
}

UncertaintyAnswer propagate(const PackingOptions& options, const std::vector<std::string>& settings) {
  const effective::RungInputs packing = packing_of(options);
  UncertaintyAnswer all;
  all.inputs = parse_all(options, settings, packing);
  const std::vector<ShownForm> forms = shown_forms(packing);
  for (const ShownForm& form : forms) {
    all.rungs.push_back({.title = form.title, .key = form.key, .moduli = {}});
    for (const auto& [key, which] : sampled_moduli)
      all.rungs.back().moduli.push_back({.key = key});
  }
  std::vector<Target> targets;
  for (std::size_t k = 0; k < forms.size(); ++k) {
    const elastic::TransverselyIsotropic stiffness = effective::answer(*forms[k].rung, packing).stiffness;
    for (std::size_t i = 0; i < std::size(sampled_moduli); ++i) {
      const Modulus which = sampled_moduli[i].second;
      ModulusUncertainty& uncertainty = all.rungs[k].moduli[i];
      const auto value = effective::modulus_if_any(stiffness, which);
      if (!value)
        continue;
      uncertainty.value = *value;
      uncertainty.first_order = first_order_of(forms[k], packing, which, all, all.validity);
      targets.push_back({&forms[k], which, &uncertainty});
    }
  }
  sample_all(options, targets, all);
  all.validity.keep_each_once();
  return all;
}

} // namespace granum::cli
