// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_model.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <boost/math/special_functions/gamma.hpp>
#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

#include "hardin/nonlinear_fit.hpp"

namespace granum::inverse::detail {

namespace {

using effective::Modulus;
using effective::State;

/// Errors of measurements are not taken to be smaller: exact ones of dependent quantities would leave no room.
constexpr double smallest_error = 1e-4;
/// Of the variance that rung 3 states, what packings of one preparation have in common: recipes scatter by
/// 1.9 %, the packings of one by 2.2 %. [validation/relaxation]
constexpr double shared_by_preparation = 0.42;
/// A step of the parameters that no longer matters.
constexpr double smallest_step = 1e-10;

double mean_stress(const State& s) { return (s.stress_v + 2 * s.stress_h) / 3; }

/// What ln of a modulus gains with ln K and with ln G, in an isotropic packing.
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

/// What ln of a quantity gains with one standard error of K and of G of rung 3.
Eigen::RowVector2d calibration_of(const QuantityRow& row, const effective::RelaxedEstimate& packing) {
  const effective::ModulusErrors& error = packing.relative_error;
  const double shear = row.modulus == Modulus::G_hh ? error.G_hh : error.G_vh;
  const Eigen::RowVector2d weights = weights_of(row.modulus, packing.stiffness);
  return (row.speed ? 0.5 : 1) * weights.cwiseProduct(Eigen::RowVector2d(error.bulk_modulus, shear));
}

Eigen::MatrixXd inverse_information(const Eigen::MatrixXd& jacobian) {
  const Eigen::Index size = jacobian.cols();
  return (jacobian.transpose() * jacobian).ldlt().solve(Eigen::MatrixXd::Identity(size, size));
}

Eigen::VectorXd least_squares_step(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residuals) {
  return inverse_information(jacobian) * (jacobian.transpose() * residuals);
}

bool same_state(const State& a, const State& b) {
  return a.stress_v == b.stress_v && a.stress_h == b.stress_h && a.void_ratio == b.void_ratio;
}

Eigen::VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

} // namespace

ContactModel::ContactModel(std::span<const Measurement> measurements, const InferenceOptions& options)
    : measurements_(measurements.begin(), measurements.end()), options_(options) {
  if (measurements_.empty())
    throw InvalidArgument("there is no measurement: a contact number follows from at least one");
  const State& first = measurements_.front().state;
  isostatic_ = effective::isostatic_coordination_number(first.tangential_ratio);
  reference_stress_ = require_positive("stress", mean_stress(first), "Pa");
  bool one_stress = true;
  for (const Measurement& m : measurements_) {
    const QuantityRow& row = row_of(m.quantity);
    require_positive(row.key, m.value.value, row.speed ? "m/s" : "Pa");
    require_non_negative(std::string(row.key) + " error", m.value.standard_error, row.speed ? "m/s" : "Pa");
    if (row.speed && !options_.grain_density)
      throw InvalidArgument("a wave speed tells a modulus only with the density of the grains");
    one_stress = one_stress && mean_stress(m.state) == reference_stress_;
  }
  if (options_.grain_density)
    require_positive("grain_density", *options_.grain_density, "kg/m3");
  if (options_.growth == Growth::fitted && one_stress)
    throw InvalidArgument(
        "the growth of z* with stress can be fitted to measurements at two stresses or more");
}

Eigen::Index ContactModel::parameter_count() const {
  return free_count() + 3 + static_cast<Eigen::Index>(options_.inputs.size());
}

std::string ContactModel::source_of(Eigen::Index prior) const {
  if (prior == 0)
    return "rattlers";
  return prior < 3 ? "rung 3" : options_.inputs[static_cast<std::size_t>(prior - 3)].key;
}

double ContactModel::coordination(const Eigen::VectorXd& theta, const State& at) const {
  double excess = theta[0];
  if (options_.growth == Growth::fitted)
    excess += theta[1] * std::log(mean_stress(at) / reference_stress_);
  return isostatic_ + std::exp(excess);
}

double ContactModel::rattlers(const Eigen::VectorXd& theta, const State& at) const {
  constexpr double most = 0.9; // however far the least squares look around
  const double deviation = std::exp(options_.rattlers.scatter * theta[free_count()]);
  return std::min(most, options_.rattlers.at(coordination(theta, at)) * deviation);
}

double ContactModel::log_value(const Eigen::VectorXd& theta, Quantity quantity, const State& at) const {
  const QuantityRow& row = row_of(quantity);
  const Eigen::Index priors = free_count();
  const double z = coordination(theta, at);
  State state = effective::with_contacts(at, z, rattlers(theta, at));
  double density = options_.grain_density.value_or(1);
  for (std::size_t k = 0; k < options_.inputs.size(); ++k)
    options_.inputs[k].move(state, density, theta[priors + 3 + static_cast<Eigen::Index>(k)]);
  const effective::RelaxedEstimate packing = effective::relaxed(state, z);
  const double value = std::log(effective::modulus(packing.stiffness, row.modulus));
  const double shared = std::sqrt(shared_by_preparation) *
                        calibration_of(row, packing).dot(theta.segment<2>(priors + 1).transpose());
  return shared + (row.speed ? (value - std::log(density / (1 + state.void_ratio))) / 2 : value);
}

Eigen::RowVector2d ContactModel::own_scatter(const Eigen::VectorXd& theta, Quantity quantity,
                                             const State& at) const {
  const double z = coordination(theta, at);
  const State state = effective::with_contacts(at, z, rattlers(theta, at));
  return std::sqrt(1 - shared_by_preparation) *
         calibration_of(row_of(quantity), effective::relaxed(state, z));
}

std::vector<StateGroup> ContactModel::groups(const Eigen::VectorXd& theta) const {
  std::vector<StateGroup> all;
  for (std::size_t k = 0; k < measurements_.size(); ++k) {
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
      const Measurement& m = measurements_[group.members[static_cast<std::size_t>(i)]];
      group.scatter.row(i) = own_scatter(theta, m.quantity, m.state);
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
      const Measurement& m = measurements_[group.members[static_cast<std::size_t>(i)]];
      misfit[i] = log_value(theta, m.quantity, m.state) - std::log(m.value.value);
    }
    all.segment(row, misfit.size()) = group.whitening * misfit;
    row += misfit.size();
  }
  all.tail(priors) = theta.tail(priors);
  return all;
}

Inference ContactModel::solve(std::shared_ptr<const ContactModel> model, double start) {
  Eigen::VectorXd theta = Eigen::VectorXd::Zero(model->parameter_count());
  theta[0] = std::log(start - model->isostatic_);
  std::vector<StateGroup> groups;
  Eigen::MatrixXd jacobian;
  constexpr int rounds = 4; // the scatter of rung 3 depends weakly on z*
  for (int round = 0; round < rounds; ++round) {
    groups = model->groups(theta);
    const auto residuals = [&](const Eigen::VectorXd& at) { return model->residuals(groups, at); };
    const hardin::NonlinearProblem problem{residuals,
                                           [&](const Eigen::VectorXd& at) { return slopes(residuals, at); }};
    const hardin::NonlinearSolution solution =
        hardin::solve(problem, theta, model->options_.iteration_limit, "a contact number");
    theta = solution.theta;
    jacobian = slopes(residuals, theta);
    // Exact measurements leave residuals of rounding errors, of which no criterion of GSL makes sense.
    const bool arrived = least_squares_step(jacobian, residuals(theta)).cwiseAbs().maxCoeff() < smallest_step;
    if (solution.status != hardin::FitStatus::converged && !arrived)
      throw NotConverged("the fit of a contact number did not converge after " +
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
  if (options_.growth == Growth::fitted)
    inference.growth_ = Measured{theta[1], std::sqrt(covariance(1, 1))};

  const Eigen::VectorXd misfit = residuals(groups, theta);
  inference.chi_square_ = misfit.squaredNorm();
  inference.degrees_of_freedom_ =
      measurements_.size() - std::min(measurements_.size(), static_cast<std::size_t>(free_count()));
  if (inference.degrees_of_freedom_ > 0)
    inference.probability_ = boost::math::gamma_q(static_cast<double>(inference.degrees_of_freedom_) / 2,
                                                  inference.chi_square_ / 2);
  inference.fitted_.resize(measurements_.size());

  // Each residual has unit variance; z* moves with it by its row of the pseudo-inverse.
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
      const std::size_t k = group.members[static_cast<std::size_t>(i)];
      const Measurement& m = measurements_[k];
      FittedMeasurement& fitted = inference.fitted_[k];
      fitted.value = inference.predict(m.quantity, m.state);
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

InferredPacking Inference::packing(const effective::State& at) const {
  const Eigen::VectorXd theta = detail::as_vector(parameters_);
  const auto z = [&](const Eigen::VectorXd& t) { return model_->coordination(t, at); };
  const auto x = [&](const Eigen::VectorXd& t) { return model_->rattlers(t, at); };
  const auto all = [&](const Eigen::VectorXd& t) { return z(t) * (1 - x(t)); };
  return {.mechanical_coordination_number = with_error(z, theta, covariance_),
          .rattler_fraction = with_error(x, theta, covariance_),
          .coordination_number = with_error(all, theta, covariance_)};
}

Measured Inference::predict(Quantity quantity, const effective::State& at) const {
  const Eigen::VectorXd theta = detail::as_vector(parameters_);
  const auto logarithm = [&](const Eigen::VectorXd& t) { return model_->log_value(t, quantity, at); };
  const Measured log_value =
      with_error(logarithm, theta, covariance_, model_->own_scatter(theta, quantity, at).squaredNorm());
  const double value = std::exp(log_value.value);
  return {value, value * log_value.standard_error};
}

effective::RungInputs Inference::rung_inputs(effective::State at) const {
  const Eigen::VectorXd theta = detail::as_vector(parameters_);
  const double z = model_->coordination(theta, at), x = model_->rattlers(theta, at);
  return {effective::with_contacts(std::move(at), z, x), z};
}

} // namespace granum::inverse
