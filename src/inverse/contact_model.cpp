// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_model.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>
#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/waves.hpp>

#include "core/compiled_once.hpp"
#include "hardin/nonlinear_fit.hpp"

namespace granum::inverse::detail {

namespace {

using effective::Modulus;
using effective::State;

/// Lower limit of measurement errors: exact values of dependent quantities could not be fitted.
constexpr double smallest_error = 1e-4;
/// Change of the sum of squares below which the iteration stops.
constexpr double negligible_gain = 1e-12;
/// Tolerance at a kink between contact laws, where no step reduces the sum: the remaining gain of a smooth
/// minimum would change no number by more than 0.01 of its standard error.
constexpr double gain_at_kink = 1e-4;
/// Limit on trial values of the least squares.
constexpr double most_rattlers = 0.9, just_rigid = 1e-6;

/// Indices of the deviations with a normal prior, after the free parameters.
constexpr Eigen::Index rattler_prior = 0, rung_prior = 1, growth_prior = 3, other_prior = 4, prior_count = 5;

/// Derivatives of ln of a modulus by ln K and ln G, in an isotropic packing.
Eigen::RowVector2d weights_of(Modulus which, const elastic::TransverselyIsotropic& c) {
  const double bulk = c.bulk_modulus();
  switch (which) {
  case Modulus::K:
    return {1, 0};
  case Modulus::C11:
    return {bulk / c.C11, 1 - bulk / c.C11};
  case Modulus::C33:
    return {bulk / c.C33, 1 - bulk / c.C33};
  default:
    return {0, 1};
  }
}

/// Change of ln of a quantity with one standard error of K and of G of rung 3.
Eigen::RowVector2d calibration_of(const QuantityRow& row, const effective::RelaxedEstimate& packing) {
  const effective::ModulusErrors& error = packing.relative_error;
  const double shear = row.modulus == Modulus::G_hh ? error.G_hh : error.G_vh;
  const Eigen::RowVector2d weights = weights_of(row.modulus, packing.stiffness);
  return (row.speed ? 0.5 : 1) * weights.cwiseProduct(Eigen::RowVector2d(error.bulk_modulus, shear));
}

const State& first_state(std::span<const Observation> measurements) {
  if (measurements.empty())
    throw InvalidArgument("there is no measurement: a coordination number follows from at least one");
  return measurements.front().state;
}

bool same_state(const State& a, const State& b) {
  return a.stress_v == b.stress_v && a.stress_h == b.stress_h && a.void_ratio == b.void_ratio;
}

Eigen::VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

} // namespace

Eigen::MatrixXd inverse_information(const Eigen::MatrixXd& jacobian) {
  const Eigen::Index size = jacobian.cols();
  return (jacobian.transpose() * jacobian).ldlt().solve(Eigen::MatrixXd::Identity(size, size));
}

ContactModel::ContactModel(std::span<const Observation> measurements, const InferenceOptions& options)
    : measurements_(measurements.begin(), measurements.end()), options_(options),
      first_(first_state(measurements)) {
  isostatic_ = effective::isostatic_coordination_number(first_.tangential_ratio);
  reference_stress_ = require_positive("stress", first_.mean_stress(), "Pa");
  bool one_stress = true;
  for (const Observation& m : measurements_) {
    const QuantityRow& row = row_of(m.quantity);
    require_measured(row, m.value);
    require_known_density(row, m.saturation);
    if (!options_.contacts.numbers.empty() && !m.state.pair_shares.empty())
      throw InvalidArgument(
          "a contact law cannot be inferred for grains of several materials: each pair of them "
          "has its own; give the contacts");
    one_stress = one_stress && m.state.mean_stress() == reference_stress_;
  }
  require_non_negative("pore_density", options_.pore_density, "kg/m3");
  if (options_.grain_density)
    require_positive("grain_density", *options_.grain_density, "kg/m3");
  if (options_.growth == GrowthRule::fitted && one_stress)
    throw InvalidArgument(
        "the growth of z* with stress can be fitted to measurements at two stresses or more");
}

double pore_density(const InferenceOptions& options, std::optional<double> saturation) {
  return saturation ? elastic::water_density * require_closed("saturation", *saturation, 0, 1)
                    : options.pore_density;
}

void ContactModel::require_known_density(const QuantityRow& row, std::optional<double> saturation) const {
  if (row.speed && !options_.grain_density)
    throw InvalidArgument("grain_density is not given [kg/m3]: wave speeds need it");
  if (row.speed && pore_density(options_, saturation) > 0 && row.modulus != Modulus::G_vh &&
      row.modulus != Modulus::G_hh)
    throw InvalidArgument(
        "a compression wave in wet pores travels mainly in the water and depends little on the contacts: use "
        "the shear wave");
}

Eigen::Index ContactModel::parameter_count() const { return law_parameter(options_.contacts.numbers.size()); }

Eigen::Index ContactModel::law_parameter(std::size_t number) const {
  return free_count() + prior_count + static_cast<Eigen::Index>(options_.inputs.keys.size() + number);
}

std::string ContactModel::source_of(Eigen::Index prior) const {
  if (prior >= prior_count) {
    const std::vector<std::string>& keys = options_.inputs.keys;
    const auto index = static_cast<std::size_t>(prior - prior_count);
    return index < keys.size() ? keys[index] : options_.contacts.numbers[index - keys.size()].key;
  }
  static constexpr const char* sources[] = {"rattlers", "rung 3", "rung 3", "growth", "another packing"};
  return sources[prior];
}

std::vector<double> ContactModel::contact_numbers(const Eigen::VectorXd& theta) const {
  std::vector<double> numbers;
  for (const UnknownNumber& number : options_.contacts.numbers)
    numbers.push_back(number.expected * std::exp(number.scatter * theta[law_parameter(numbers.size())]));
  return numbers;
}

effective::ContactCounts ContactModel::counts_in(const Eigen::VectorXd& theta, const State& first) const {
  const double z = isostatic_ + std::exp(theta[0]);
  if (options_.rattler_fraction)
    return {.mechanical_coordination_number = z, .rattler_fraction = *options_.rattler_fraction};
  const effective::ExpectedRattlers expected = effective::expected_rattlers(first, z);
  const double deviation = std::exp(expected.scatter * theta[free_count() + rattler_prior]);
  return {.mechanical_coordination_number = z,
          .rattler_fraction = std::min(most_rattlers, expected.fraction * deviation)};
}

double ContactModel::first_force(const Eigen::VectorXd& theta) const {
  const auto [z, rattlers] = counts_in(theta, first_);
  return effective::mean_contact_force(effective::with_contacts(first_, z, rattlers));
}

State ContactModel::with_law(const Eigen::VectorXd& theta, State state) const {
  if (!options_.contacts.numbers.empty())
    state.law = options_.contacts.law(state.law, first_force(theta), contact_numbers(theta));
  return state;
}

effective::ContactCounts ContactModel::first_contacts(const Eigen::VectorXd& theta) const {
  return counts_in(theta, with_law(theta, first_));
}

effective::ContactCounts ContactModel::at_stress(const Eigen::VectorXd& theta, double mean_stress) const {
  const State first = with_law(theta, first_);
  effective::ContactCounts counts = counts_in(theta, first);
  const double step = std::log(mean_stress / reference_stress_);
  if (options_.growth == GrowthRule::fixed || step == 0)
    return counts;
  const double before = counts.mechanical_coordination_number;
  if (options_.growth == GrowthRule::fitted) {
    counts.mechanical_coordination_number = isostatic_ + std::exp(theta[0] + theta[1] * step);
    State here = first;
    here.stress_v *= mean_stress / reference_stress_;
    here.stress_h *= mean_stress / reference_stress_;
    const double now = counts.mechanical_coordination_number;
    counts.rattler_fraction *= effective::expected_rattlers(here, now).fraction /
                               effective::expected_rattlers(first, before).fraction;
  } else {
    const effective::CarriedContacts carried = effective::carried_contacts(first, counts, mean_stress);
    counts = carried.counts;
    counts.mechanical_coordination_number += carried.coordination_error * theta[free_count() + growth_prior];
  }
  counts.mechanical_coordination_number =
      std::max(counts.mechanical_coordination_number, isostatic_ + just_rigid);
  counts.rattler_fraction = std::min(counts.rattler_fraction, most_rattlers);
  return counts;
}

effective::ContactCounts ContactModel::contacts(const Eigen::VectorXd& theta, const State& at,
                                                AskedPacking specimen) const {
  effective::ContactCounts counts = at_stress(theta, at.mean_stress());
  if (specimen == AskedPacking::same)
    return counts;
  const State there = with_law(theta, at);
  State here = there;
  here.void_ratio = void_ratio_at(theta, at.mean_stress());
  const effective::ContactPrior from = effective::contact_prior(here), to = effective::contact_prior(there);
  const auto z_of = [](const effective::ContactCounts& c) { return c.mechanical_coordination_number; };
  // The relative position between the ends or beyond them; where no packing is so loose, the ends coincide.
  const double width = z_of(from.densest) - z_of(from.loosest);
  const double within = std::clamp(z_of(counts), z_of(from.loosest), z_of(from.densest));
  const double share = width > 0 ? (within - z_of(from.loosest)) / width : 0.5;
  const double z = z_of(to.loosest) + share * (z_of(to.densest) - z_of(to.loosest)) + z_of(counts) - within +
                   to.coordination_error * theta[free_count() + other_prior];
  counts.mechanical_coordination_number = std::max(z, isostatic_ + just_rigid);
  const double by_law = effective::expected_rattlers(there, counts.mechanical_coordination_number).fraction;
  counts.rattler_fraction = std::min(by_law, most_rattlers);
  return counts;
}

double ContactModel::void_ratio_at(const Eigen::VectorXd& theta, double mean_stress) const {
  if (options_.growth != GrowthRule::packings || mean_stress == reference_stress_)
    return first_.void_ratio;
  const State first = with_law(theta, first_);
  return effective::carried_contacts(first, counts_in(theta, first), mean_stress).void_ratio;
}

double ContactModel::log_value(const Eigen::VectorXd& theta, Quantity quantity, const State& at,
                               AskedPacking specimen, std::optional<double> saturation) const {
  const QuantityRow& row = row_of(quantity);
  require_known_density(row, saturation);
  const Eigen::Index priors = free_count();
  const auto [z, rattlers] = contacts(theta, at, specimen);
  State state = effective::with_contacts(at, z, rattlers);
  double density = options_.grain_density.value_or(1);
  if (const std::size_t count = options_.inputs.keys.size(); count > 0)
    options_.inputs.move(state, density, {theta.data() + priors + prior_count, count});
  state = with_law(theta, std::move(state));
  const effective::RelaxedEstimate packing = effective::relaxed(state, z);
  const double value = std::log(effective::modulus(packing.stiffness, row.modulus));
  const double bulk_density = elastic::bulk_density({.grain_density = density,
                                                     .void_ratio = state.void_ratio,
                                                     .pore_density = pore_density(options_, saturation)});
  const double shared = std::sqrt(effective::scatter_share_of_preparation()) *
                        calibration_of(row, packing).dot(theta.segment<2>(priors + rung_prior).transpose());
  return shared + (row.speed ? (value - std::log(bulk_density)) / 2 : value);
}

Eigen::RowVector2d ContactModel::own_scatter(const Eigen::VectorXd& theta, Quantity quantity, const State& at,
                                             AskedPacking specimen) const {
  const auto [z, rattlers] = contacts(theta, at, specimen);
  const State state = with_law(theta, effective::with_contacts(at, z, rattlers));
  return std::sqrt(1 - effective::scatter_share_of_preparation()) *
         calibration_of(row_of(quantity), effective::relaxed(state, z));
}

std::vector<StateGroup> ContactModel::groups(const Eigen::VectorXd& theta) const {
  std::vector<StateGroup> all;
  for (std::size_t k = 0; k < measurements_.size(); ++k) {
    stop_point();
    const auto same = [&](const StateGroup& group) {
      return same_state(measurements_[group.members.front()].state, measurements_[k].state);
    };
    const auto group = std::find_if(all.begin(), all.end(), same);
    (group == all.end() ? all.emplace_back() : *group).members.push_back(k);
  }
  for (StateGroup& group : all) {
    const auto size = static_cast<Eigen::Index>(group.members.size());
    group.scatter.resize(size, 2);
    group.noise.resize(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      stop_point();
      const Observation& m = measurements_[group.members[static_cast<std::size_t>(i)]];
      group.scatter.row(i) = own_scatter(theta, m.quantity, m.state, AskedPacking::same);
      group.noise[i] = std::max(smallest_error, m.value.standard_error / m.value.value);
    }
    Eigen::MatrixXd covariance = group.scatter * group.scatter.transpose();
    covariance.diagonal() += group.noise.cwiseAbs2();
    group.whitening = covariance.llt().matrixL().solve(Eigen::MatrixXd::Identity(size, size));
  }
  return all;
}

Eigen::VectorXd ContactModel::residuals(const std::vector<StateGroup>& groups,
                                        const Eigen::VectorXd& theta) const {
  const auto count = static_cast<Eigen::Index>(measurements_.size());
  const Eigen::Index priors = parameter_count() - free_count();
  Eigen::VectorXd all(count + priors);
  Eigen::Index row = 0;
  for (const StateGroup& group : groups) {
    Eigen::VectorXd misfit(group.noise.size());
    for (Eigen::Index i = 0; i < misfit.size(); ++i) {
      stop_point();
      const Observation& m = measurements_[group.members[static_cast<std::size_t>(i)]];
      misfit[i] =
          log_value(theta, m.quantity, m.state, AskedPacking::same, m.saturation) - std::log(m.value.value);
    }
    all.segment(row, misfit.size()) = group.whitening * misfit;
    row += misfit.size();
  }
  all.tail(priors) = theta.tail(priors);
  return all;
}

Inference ContactModel::solve(std::shared_ptr<const ContactModel> model, double start) {
  std::vector<Eigen::VectorXd> starts{std::log(std::max(start - model->isostatic_, just_rigid)) *
                                      Eigen::VectorXd::Unit(model->parameter_count(), 0)};
  for (std::size_t number = 0; number < model->options_.contacts.numbers.size(); ++number)
    for (const double deviation : {-1.0, 1.0}) {
      starts.push_back(starts.front());
      starts.back()[model->law_parameter(number)] = deviation;
    }
  std::optional<Inference> best;
  std::exception_ptr failure;
  for (const Eigen::VectorXd& from : starts)
    try {
      Inference found = solve_from(model, from);
      if (!best || found.chi_square() < best->chi_square())
        best = std::move(found);
    } catch (const Stopped&) {
      throw;
    } catch (const Error&) { // one minimum is enough
      if (!failure)
        failure = std::current_exception();
    }
  if (!best)
    std::rethrow_exception(failure);
  return *std::move(best);
}

Inference ContactModel::solve_from(const std::shared_ptr<const ContactModel>& model, Eigen::VectorXd theta) {
  std::vector<StateGroup> groups;
  Eigen::MatrixXd jacobian;
  constexpr int rounds = 4; // the scatter of rung 3 depends weakly on z*
  for (int round = 0; round < rounds; ++round) {
    groups = model->groups(theta);
    const auto residuals = [&](const Eigen::VectorXd& at) { return model->residuals(groups, at); };
    const hardin::NonlinearProblem problem{residuals,
                                           [&](const Eigen::VectorXd& at) { return slopes(residuals, at); }};
    const hardin::NonlinearSolution solution =
        hardin::solve(problem, theta, model->options_.iteration_limit, "a coordination number");
    theta = solution.theta;
    jacobian = slopes(residuals, theta);
    // GSL compares sums of squares, which near the minimum differ only by rounding: take one more step.
    const Eigen::VectorXd misfit = residuals(theta),
                          step = inverse_information(jacobian) * (jacobian.transpose() * misfit);
    const double gain = (jacobian * step).squaredNorm();
    if (gain <= negligible_gain * (1 + misfit.squaredNorm()))
      theta -= step;
    if (solution.status != hardin::FitStatus::converged && gain > gain_at_kink)
      throw NotConverged("the fit of a coordination number did not converge after " +
                         std::to_string(solution.iterations) + " iterations");
  }
  Inference inference;
  inference.model_ = model;
  model->describe(inference, groups, theta, jacobian);
  return inference;
}

void ContactModel::describe(Inference& inference, const std::vector<StateGroup>& groups,
                            const Eigen::VectorXd& theta, const Eigen::MatrixXd& jacobian) const {
  const Eigen::MatrixXd covariance = inverse_information(jacobian);
  inference.parameters_.assign(theta.begin(), theta.end());
  for (Eigen::Index i = 0; i < covariance.rows(); ++i)
    inference.covariance_.insert(inference.covariance_.end(), covariance.row(i).begin(),
                                 covariance.row(i).end());
  inference.reference_stress_ = reference_stress_;
  if (options_.growth == GrowthRule::fitted)
    inference.growth_ = Measured{theta[1], std::sqrt(covariance(1, 1))};
  if (!options_.contacts.numbers.empty())
    inference.contacts_ = implied_contacts(groups, theta, jacobian);

  const Eigen::VectorXd misfit = residuals(groups, theta);
  inference.chi_square_ = misfit.squaredNorm();
  inference.degrees_of_freedom_ =
      measurements_.size() - std::min(measurements_.size(), static_cast<std::size_t>(free_count()) +
                                                                options_.contacts.numbers.size());
  inference.probability_ = p_value(inference.chi_square_, inference.degrees_of_freedom_);
  inference.fitted_.resize(measurements_.size());

  // Each residual has unit variance; z* depends on it through its row of the pseudo-inverse.
  const Eigen::RowVectorXd moves = (covariance * jacobian.transpose()).row(0);
  double of_measurement = 0, of_rung = 0;
  Eigen::Index row = 0;
  for (const StateGroup& group : groups) {
    const Eigen::Index size = group.noise.size();
    const Eigen::RowVectorXd by_value = moves.segment(row, size) * group.whitening;
    of_measurement += by_value.cwiseProduct(group.noise.transpose()).squaredNorm();
    of_rung += (by_value * group.scatter).squaredNorm();
    row += size;
    for (Eigen::Index i = 0; i < size; ++i) {
      stop_point();
      const std::size_t k = group.members[static_cast<std::size_t>(i)];
      const Observation& m = measurements_[k];
      FittedObservation& fitted = inference.fitted_[k];
      fitted.value = inference.predict(m.quantity, m.state, AskedPacking::same, m.saturation);
      fitted.deviation = std::log(m.value.value / fitted.value.value) /
                         std::hypot(group.noise[i], group.scatter.row(i).norm());
    }
  }
  inference.shares_ = {{"measurement", of_measurement}, {"rung 3", of_rung}};
  for (Eigen::Index prior = 0; prior < moves.size() - row; ++prior) {
    const double part = moves[row + prior] * moves[row + prior];
    const std::string source = source_of(prior);
    if (source == "rung 3")
      inference.shares_[1].share += part;
    else
      inference.shares_.push_back({source, part});
  }
  for (ErrorShare& share : inference.shares_)
    share.share /= covariance(0, 0);
}

} // namespace granum::inverse::detail

namespace granum::inverse {

namespace {

/// A function of the parameters with its standard error.
template <class Function>
Measured with_error(const Function& function, const Eigen::VectorXd& theta, const std::vector<double>& all,
                    double own_variance = 0) {
  const Eigen::Map<const Eigen::MatrixXd> covariance(all.data(), theta.size(), theta.size()); // symmetric
  const auto vector = [&](const Eigen::VectorXd& at) { return Eigen::VectorXd::Constant(1, function(at)); };
  const Eigen::RowVectorXd slope = detail::slopes(vector, theta);
  return {function(theta), std::sqrt(std::max(0.0, slope.dot(slope * covariance)) + own_variance)};
}

} // namespace

InferredPacking Inference::packing(const effective::State& at, AskedPacking specimen) const {
  const Eigen::VectorXd theta = detail::as_vector(parameters_);
  const auto counts = [&](const Eigen::VectorXd& t) { return model_->contacts(t, at, specimen); };
  const auto z = [&](const Eigen::VectorXd& t) { return counts(t).mechanical_coordination_number; };
  const auto x = [&](const Eigen::VectorXd& t) { return counts(t).rattler_fraction; };
  const auto all = [&](const Eigen::VectorXd& t) { return counts(t).coordination_number(); };
  return {.mechanical_coordination_number = with_error(z, theta, covariance_),
          .rattler_fraction = with_error(x, theta, covariance_),
          .coordination_number = with_error(all, theta, covariance_)};
}

Measured Inference::predict(Quantity quantity, const effective::State& at, AskedPacking specimen,
                            std::optional<double> saturation) const {
  const Eigen::VectorXd theta = detail::as_vector(parameters_);
  const auto logarithm = [&](const Eigen::VectorXd& t) {
    return model_->log_value(t, quantity, at, specimen, saturation);
  };
  const Measured log_value = with_error(logarithm, theta, covariance_,
                                        model_->own_scatter(theta, quantity, at, specimen).squaredNorm());
  const double value = std::exp(log_value.value);
  return {value, value * log_value.standard_error};
}

effective::State Inference::state(effective::State at, AskedPacking specimen) const {
  const auto [z, rattlers] = model_->contacts(detail::as_vector(parameters_), at, specimen);
  return model_->with_law(detail::as_vector(parameters_),
                          effective::with_contacts(std::move(at), z, rattlers));
}

double Inference::void_ratio_at(double mean_stress) const {
  return model_->void_ratio_at(detail::as_vector(parameters_), mean_stress);
}

} // namespace granum::inverse
