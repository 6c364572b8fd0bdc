// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/fit.hpp>

#include <random>

#include <boost/random/normal_distribution.hpp>
#include <granum/core/stop.hpp>
#include <thresholds.hpp>

#include "sample_statistics.hpp"
#include "unit.hpp"

using namespace granum::hardin;

namespace {

constexpr double pa = 1e5;

/// The paper's states between eta = -0.6 and 0.6 in steps of 0.05, from the isotropic 100 kPa: TXC and TXE
/// change one stress upwards, RTXC and RTXE the same downwards. `stress_i` is horizontal, `stress_j`
/// vertical, as for G_hv.
std::vector<SoilState> triaxial_paths() {
  std::vector<SoilState> states{{pa, pa, 0.558}};
  for (int step = 1; step <= 12; ++step) {
    const double eta = 0.05 * step;
    const double compression = (3 + 2 * eta) / (3 - eta); // sigma_v/sigma_h at q/p' = eta
    const double extension = (3 - 2 * eta) / (3 + eta);
    states.push_back({pa, pa * compression, 0.558}); // TXC
    states.push_back({pa / compression, pa, 0.558}); // RTXC
    states.push_back({pa, pa * extension, 0.558});   // RTXE
    states.push_back({pa / extension, pa, 0.558});   // TXE
  }
  return states;
}

std::vector<SoilState> isotropic_path() {
  std::vector<SoilState> states;
  for (int step = 1; step <= 10; ++step)
    states.push_back({0.1 * step * pa, 0.1 * step * pa, 0.56});
  return states;
}

std::vector<MeasuredModulus> measured(const Equation& equation, const std::vector<SoilState>& states) {
  std::vector<MeasuredModulus> rows;
  for (const SoilState& state : states)
    rows.push_back({shear_modulus(equation, state), state});
  return rows;
}

Equation equation(double c, double m, double n) {
  return {.coefficient = c, .exponent_i = m, .exponent_j = n, .atmospheric_pressure = pa};
}

FitOptions with(Weights weights) { return {.atmospheric_pressure = pa, .weights = weights}; }

/// The message with which a fit is refused; empty if it is done.
template <typename Fitter>
std::string refusal(Fitter fitter, const std::vector<MeasuredModulus>& rows) {
  try {
    (void)fitter(rows, with(Weights::relative));
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("moduli made with the paper's Table 5 give its m and n back") {
  // G_hv and G_vh rows of Table 5: C [MPa, so times 10 for p_a = 100 kPa], m, n. [Chung2014]
  const double table5[][3] = {{21.45, 0.273, 0.237}, {21.43, 0.234, 0.275}, {13.31, 0.322, 0.353},
                              {13.32, 0.354, 0.325}, {73.74, 0.189, 0.160}, {73.75, 0.162, 0.190},
                              {29.59, 0.176, 0.357}, {29.56, 0.345, 0.189}, {100.8, 0.013, 0.012},
                              {100.9, 0.013, 0.013}, {34.11, 0.058, 0.188}, {34.07, 0.180, 0.064}};
  for (const auto& [c, m, n] : table5)
    for (const Weights weights : {Weights::relative, Weights::absolute}) {
      const FitReport report = fit(measured(equation(10 * c, m, n), triaxial_paths()), with(weights));
      const Fit& result = report.fit();
      CHECK(result.coefficient.value == relative(10 * c, 1e-10));
      CHECK(std::abs(result.exponent_i->value - m) < 1e-10);
      CHECK(std::abs(result.exponent_j->value - n) < 1e-10);
      CHECK(std::abs(result.exponent_sum.value - (m + n)) < 1e-10);
      CHECK(result.rms_relative_residual < 1e-10);
      CHECK(*result.r_squared > 1 - 1e-10);
      CHECK(result.validity.ok());
      CHECK(result.degrees_of_freedom == triaxial_paths().size() - 3);
    }
}

TEST_CASE("noise in the moduli changes the result within the standard errors") {
  const Equation truth = equation(215, 0.273, 0.237);
  const auto states = triaxial_paths();
  const int seeds = 600; // the spread of a sample of 600 is known to 3 %
  for (const Weights weights : {Weights::relative, Weights::absolute}) {
    std::array<std::vector<double>, 4> found, stated;
    std::mt19937_64 bits(20140123);
    boost::random::normal_distribution<double> normal;
    for (int seed = 0; seed < seeds; ++seed) {
      auto rows = measured(truth, states);
      for (MeasuredModulus& row : rows)
        if (weights == Weights::relative)
          row.shear_modulus *= std::exp(0.03 * normal(bits));
        else
          row.shear_modulus += 0.03 * 36e6 * normal(bits);
      const FitReport report = fit(rows, with(weights));
      const Fit& one = report.fit();
      for (int k = 0;
           const Measured& e : {one.coefficient, *one.exponent_i, *one.exponent_j, one.exponent_sum}) {
        found[static_cast<std::size_t>(k)].push_back(e.value);
        stated[static_cast<std::size_t>(k++)].push_back(e.standard_error);
      }
    }
    const double truths[] = {215, 0.273, 0.237, 0.510};
    for (std::size_t k = 0; k < 4; ++k) {
      CAPTURE(k);
      const double spread = deviation(found[k]);
      CHECK(spread == relative(mean(stated[k]), 0.10));
      CHECK(std::abs(mean(found[k]) - truths[k]) < 4 * spread / std::sqrt(double(seeds)));
    }
  }
}

TEST_CASE("the two weights differ on noisy data, and each is at its own minimum") {
  auto rows = measured(equation(215, 0.273, 0.237), triaxial_paths());
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k].shear_modulus *= k % 3 == 0 ? 1.1 : 0.97;
  const auto cost = [&](const Equation& trial, Weights weights) {
    double sum = 0;
    for (const MeasuredModulus& row : rows) {
      const double g = shear_modulus(trial, row.state);
      const double r = weights == Weights::relative ? std::log(row.shear_modulus / g) : row.shear_modulus - g;
      sum += r * r;
    }
    return sum;
  };
  std::vector<double> found;
  for (const Weights weights : {Weights::relative, Weights::absolute}) {
    const Equation best = fit(rows, with(weights)).fit().equation;
    found.push_back(best.exponent_i);
    for (const double step : {-1e-4, 1e-4})
      for (double Equation::*const member :
           {&Equation::coefficient, &Equation::exponent_i, &Equation::exponent_j}) {
        Equation trial = best;
        trial.*member += step * (member == &Equation::coefficient ? best.coefficient : 1);
        CHECK(cost(trial, weights) > cost(best, weights));
      }
  }
  CHECK(std::abs(found[0] - found[1]) > 1e-4);
}

TEST_CASE("covariance, residuals and R squared belong together") {
  auto rows = measured(equation(215, 0.273, 0.237), triaxial_paths());
  rows[3].shear_modulus *= 1.2;
  rows[20].shear_modulus *= 0.9;
  const FitReport report = fit(rows, with(Weights::absolute));
  const Fit& result = report.fit();
  const auto& v = result.covariance;
  CHECK(result.parameters == std::vector<std::string>{"C", "m", "n"});
  CHECK(std::sqrt(v[0][0]) == relative(result.coefficient.standard_error, 1e-12));
  CHECK(std::sqrt(v[1][1]) == relative(result.exponent_i->standard_error, 1e-12));
  CHECK(std::sqrt(v[1][1] + v[2][2] + 2 * v[1][2]) == relative(result.exponent_sum.standard_error, 1e-12));
  double residual = 0, total = 0, mean = 0;
  for (const MeasuredModulus& row : rows)
    mean += row.shear_modulus / static_cast<double>(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    CHECK(result.residuals[k] ==
          relative(rows[k].shear_modulus - shear_modulus(result.equation, rows[k].state), 1e-7));
    residual += result.residuals[k] * result.residuals[k];
    total += std::pow(rows[k].shear_modulus - mean, 2);
  }
  CHECK(*result.r_squared == relative(1 - residual / total, 1e-12));
}

TEST_CASE("units of the data change nothing but C") {
  auto rows = measured(equation(215, 0.273, 0.237), triaxial_paths());
  rows[3].shear_modulus *= 1.2;
  const FitReport first = fit(rows, with(Weights::absolute));
  for (MeasuredModulus& row : rows) {
    row.shear_modulus *= 8;
    row.state.stress_i *= 8;
    row.state.stress_j *= 8;
  }
  const FitReport second = fit(rows, {.atmospheric_pressure = 8 * pa, .weights = Weights::absolute});
  CHECK(second.fit().coefficient.value == relative(first.fit().coefficient.value, 1e-10));
  CHECK(second.fit().exponent_i->standard_error == relative(first.fit().exponent_i->standard_error, 1e-6));
}

TEST_CASE("a proportional path gives only s, with a note") {
  const Equation truth = equation(215, 0.273, 0.237);
  auto states = isotropic_path();
  CHECK(refusal(fit, measured(truth, states)) != "");
  for (SoilState& state : states)
    state.stress_j *= 0.5;
  CHECK(refusal(fit, measured(truth, states)) != "");
  const FitReport report = fit_exponent_sum(measured(truth, states), with(Weights::absolute));
  CHECK(std::abs(report.fit().exponent_sum.value - 0.510) < 1e-10);
  CHECK_FALSE(report.fit().exponent_i.has_value());
  CHECK(report.fit().parameters == std::vector<std::string>{"C", "s"});
  CHECK(report.fit().validity.notes.size() == 1);
  for (const SoilState& state : states) // C is that of the path, if its stresses count alike
    CHECK(shear_modulus(report.fit().equation, state) == relative(shear_modulus(truth, state), 1e-9));

  // A stress ratio other than 1, and one that changes from row to row, are noted from 1 % on.
  for (const bool all : {true, false})
    check_threshold(0.01, [&](double logarithm) {
      auto rows = measured(truth, isotropic_path());
      for (std::size_t k = all ? 0 : 4; k < (all ? rows.size() : 5); ++k)
        rows[k].state.stress_j *= std::exp(logarithm);
      return fit_exponent_sum(rows, with(Weights::absolute)).fit().validity.notes.size();
    });

  check_threshold(1e-6, [&](double falls) { // without noise
    return fit_exponent_sum(measured(equation(215, -falls, 0), isotropic_path()), with(Weights::absolute))
        .fit()
        .validity.notes.size();
  });

  // one stress alone changes: m is known, n and s are not
  states.clear();
  for (int k = 1; k <= 6; ++k)
    states.push_back({k * pa, pa, 0.56});
  CHECK(refusal(fit, measured(truth, states)) != "");
}

TEST_CASE("only s on the isotropic path, with a note where moduli fall as stresses grow") {
  for (const double s : {0.0, 0.025, 0.349, 0.677}) {
    const FitReport report =
        fit_exponent_sum(measured(equation(720, s / 2, s / 2), isotropic_path()), with(Weights::relative));
    CHECK(report.fit().coefficient.value == relative(720, 1e-10));
    CHECK(std::abs(report.fit().exponent_sum.value - s) < 1e-10);
    CHECK(report.fit().validity.ok());
  }
  const auto notes_of = [](double s, double noise) {
    std::vector<MeasuredModulus> rows = measured(equation(900, s / 2, s / 2), isotropic_path());
    for (std::size_t k = 0; k < rows.size(); ++k)
      rows[k].shear_modulus *= k % 2 == 0 ? 1 + noise : 1 - noise;
    return fit_exponent_sum(rows, {.atmospheric_pressure = pa}).fit().validity.notes;
  };
  CHECK(notes_of(-0.44, 0.01).size() == 1);
  CHECK(notes_of(0.44, 0.01).empty());
  CHECK(notes_of(-0.001, 0.1).empty()); // nobody can tell
}

TEST_CASE("stresses that hardly determine m and n separately give a note and large errors") {
  auto states = isotropic_path();
  for (std::size_t k = 0; k < states.size(); ++k)
    states[k].stress_j *= k % 2 == 0 ? 1.01 : 0.99;
  auto rows = measured(equation(215, 0.273, 0.237), states);
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k].shear_modulus *= k % 3 == 0 ? 1.01 : 0.99;
  const FitReport report = fit(rows, with(Weights::relative));
  CHECK_FALSE(report.fit().validity.ok());
  CHECK(report.fit().exponent_i->standard_error > 0.1);
  CHECK(report.fit().exponent_sum.standard_error < 0.02);
}

TEST_CASE("stresses that determine no exponent, or only their sum, are refused from where on") {
  const Equation truth = equation(215, 0.273, 0.237);
  const auto refused = [&](auto fitter, double spread, double power) { // sigma_j ~ sigma_i^power
    std::vector<SoilState> states;
    for (const double at : {-0.5, -0.5, 0.5, 0.5})
      states.push_back({pa * std::exp(spread * at), pa * std::exp(power * spread * at), 0.56});
    return refusal(fitter, measured(truth, states));
  };
  check_threshold(1e-3, [&](double spread) { return refused(fit_exponent_sum, spread, 1).empty() ? 1 : 0; });
  for (const double off : {-0.01, 0.01}) { // of the direction, a unit vector, from equal parts
    const double angle = std::asin(off / std::sqrt(2.0)), steeper = std::tan(M_PI / 4 + angle);
    const auto at = [&](double share) { return refused(fit, 1, 1 + share * (steeper - 1)); };
    CHECK(at(0.98) == at(0));
    CHECK(at(1.02) != at(0));
  }
  const auto across = [&](double width) { // a little off one line
    auto rows = measured(truth, isotropic_path());
    for (std::size_t k = 0; k < rows.size(); ++k)
      rows[k].state.stress_j *= std::exp(k % 2 == 0 ? width : -width);
    return refusal(fit, rows).empty() ? 1 : 0;
  };
  double squares = 0, sum = 0; // along the line: root mean square of sqrt(2) ln stress
  for (int k = 1; k <= 10; ++k) {
    sum += std::log(k);
    squares += std::log(k) * std::log(k);
  }
  const double along = std::sqrt(2 * (squares / 10 - sum * sum / 100));
  CHECK(across(0.9e-3 * std::sqrt(2.0) * along) == 0);
  CHECK(across(1.1e-3 * std::sqrt(2.0) * along) == 1);
}

TEST_CASE("rows that cannot be fitted are refused") {
  const Equation truth = equation(215, 0.273, 0.237);
  const std::vector<MeasuredModulus> rows = measured(truth, triaxial_paths());
  CHECK(refusal(fit, {rows.begin(), rows.begin() + 3}).find("4") != std::string::npos);
  CHECK(refusal(fit_exponent_sum, {rows.begin(), rows.begin() + 2}).find("3") != std::string::npos);
  CHECK(refusal(fit, std::vector<MeasuredModulus>(6, rows[0])) != "");
  CHECK(refusal(fit_exponent_sum, std::vector<MeasuredModulus>(6, rows[0])) != "");
  std::vector<MeasuredModulus> negative = rows, unknown = rows, soft = rows;
  negative[4].state.stress_j = -5e3;
  unknown[4].state.stress_j = std::numeric_limits<double>::quiet_NaN();
  soft[0].shear_modulus = 0;
  CHECK(refusal(fit, negative).starts_with("row 5: stress_j"));
  CHECK(refusal(fit, unknown).starts_with("row 5: stress_j"));
  CHECK(refusal(fit, soft).starts_with("row 1: shear_modulus"));
  CHECK_THROWS_AS((void)fit(rows, FitOptions{}), InvalidArgument); // no atmospheric pressure
}

TEST_CASE("a fit that was stopped gives its result out only on request") {
  auto rows = measured(equation(215, 0.273, 0.237), triaxial_paths());
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k].shear_modulus *= k % 2 == 0 ? 2 : 0.5;
  FitOptions options = with(Weights::absolute);
  options.iteration_limit = 1;
  const FitReport report = fit(rows, options);
  CHECK(report.status() == FitStatus::iteration_limit);
  CHECK_THROWS_AS((void)report.fit(), NotConverged);
  CHECK(report.last().coefficient.value > 0);
  options.iteration_limit = 100;
  CHECK(fit(rows, options).status() == FitStatus::converged);
  const StopScope scope([] { return true; });
  CHECK_THROWS_AS((void)fit(rows, options), Stopped);
}
