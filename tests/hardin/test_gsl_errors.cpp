// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <thread>

#include <granum/hardin/equation.hpp>
#include <granum/hardin/fit.hpp>
#include <gsl/gsl_errno.h>

#include "unit.hpp"

namespace {

std::atomic<int> handled = 0;

/// A host's handler of GSL's errors. The default one aborts, so a test could not go on after it.
void count_error(const char* /*reason*/, const char* /*file*/, int /*line*/, int /*code*/) { ++handled; }

/// The host's handler for the length of a test.
class HostHandler {
 public:
  HostHandler() : before_(gsl_set_error_handler(count_error)) { handled = 0; }
  HostHandler(const HostHandler&) = delete;
  HostHandler& operator=(const HostHandler&) = delete;
  ~HostHandler() { gsl_set_error_handler(before_); }

  /// Whether the handler is still the host's.
  [[nodiscard]] static bool in_place() {
    gsl_error_handler_t* const now = gsl_set_error_handler(count_error);
    return now == count_error;
  }

 private:
  gsl_error_handler_t* before_;
};

std::vector<hardin::MeasuredModulus> measurements() {
  std::vector<hardin::MeasuredModulus> rows;
  for (int k = 1; k <= 12; ++k) {
    const double i = 1e4 * k, j = 1e4 * (1 + k * k % 7);
    rows.push_back({8e7 * std::pow(i, 0.3) * std::pow(j, 0.2) * (1 + 0.01 * (k % 3)), {i, j, 0.6}});
  }
  return rows;
}

} // namespace

TEST_CASE("a polynomial through numbers that no fit can take is refused without GSL's handler") {
  const HostHandler host;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> good{0, 1, 2, 3, 4};
  for (const double bad : {nan, infinity, -infinity, 1e200, -1e200}) {
    std::vector<double> values = good;
    values[2] = bad;
    CAPTURE(bad);
    CHECK_THROWS_AS((void)hardin::fit_polynomial(values, good, 3), InvalidArgument);
    CHECK_THROWS_AS((void)hardin::fit_polynomial(good, values, 3), InvalidArgument);
  }
  CHECK(handled == 0);
  CHECK(HostHandler::in_place());
}

TEST_CASE("a polynomial through fewer places than it has terms is finite, or refused") {
  const HostHandler host;
  const std::vector<double> same{2, 2, 2, 2}, tiny{0, 1e-300, 2e-300, 3e-300}, y{1, 2, 3, 4};
  for (const std::vector<double>& x : {same, tiny})
    try {
      const hardin::Polynomial fit = hardin::fit_polynomial(x, y, 3);
      CHECK(std::ranges::all_of(fit.coefficients, [](double c) { return std::isfinite(c); }));
      CHECK(std::isfinite(fit.rms));
    } catch (const Error&) {
    }
  CHECK(handled == 0);
  CHECK(HostHandler::in_place());
}

TEST_CASE("fits in several threads leave the host its handler") {
  const HostHandler host;
  const std::vector<hardin::MeasuredModulus> rows = measurements();
  const hardin::FitOptions options{.atmospheric_pressure = 100e3};
  const double expected = hardin::fit(rows, options).fit().exponent_sum.value;
  std::atomic<int> different = 0;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&] {
      for (int repeat = 0; repeat < 50; ++repeat)
        if (hardin::fit(rows, options).fit().exponent_sum.value != expected)
          ++different;
    });
  for (std::thread& thread : threads)
    thread.join();
  CHECK(different == 0);
  CHECK(handled == 0);
  CHECK(HostHandler::in_place());
}
