// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/core/numerics.hpp>
#include <granum/effective/state.hpp>
#include <granum/inverse/quantity.hpp>

/// Contact laws with parameters to be inferred, besides the number of contacts.
namespace granum::inverse {

/// A positive parameter of the contact law and its prior: its logarithm is normally distributed.
struct UnknownNumber {
  std::string key;
  double expected = 1; ///< in its unit
  double scatter = 1;  ///< standard deviation of its logarithm; wide, so that the data dominate
  std::string unit = {};
};

/// A family of contact laws with unknown parameters.
struct UnknownContacts {
  std::string name = "given"; ///< "given": no unknown parameter
  std::vector<UnknownNumber> numbers;
  /// The law with these parameters.
  /// \param    given   law of the measured state
  /// \param    force   mean contact force of the first measurement [N]
  std::function<contact::NormalLaw(const contact::NormalLaw& given, double force,
                                   std::span<const double> numbers)>
      law;
};

/// The families by name:
///   given       the law of the states, without unknown parameters
///   rough       spheres of roughness u0 [m], expected 20 nm within a factor of 10
///   power-law   f ~ d^(1+1/alpha): `softness`, k_n over that of Hertz' law at the mean force of the first
///               measurement, expected 1 within a factor of 3, and `alpha`, expected 2 within a factor of 2
/// The last two replace a law of smooth spheres.
/// \throws   InvalidArgument with all names for another name
/// Checked by tests/inverse/test_contacts.cpp
[[nodiscard]] UnknownContacts unknown_contacts(std::string_view name);
[[nodiscard]] std::span<const std::string_view> unknown_contact_names();

/// f = c d^(1+1/alpha) with a stiffness k_n > 0 [N/m] at a force > 0 [N].
/// \throws   InvalidArgument unless 0 < alpha < infinity and c is a positive number
/// Accuracy  relative 1e-13.  Checked by tests/inverse/test_contacts.cpp
[[nodiscard]] contact::PowerLaw power_law_through(const contact::GrainMaterial& grain, double alpha,
                                                  double force, double stiffness);

/// One inferred number: z*, or a parameter of the contact law.
struct ImpliedNumber {
  std::string key;
  std::string unit;
  Measured value;
  double before = 0; ///< standard deviation of the prior
  /// Whether the measurements reduce it to half or less, and to less than half of the value.
  [[nodiscard]] bool determined() const { return value.standard_error < 0.5 * std::min(before, value.value); }
};

/// Contacts implied by measurements.
struct ImpliedContacts {
  std::vector<ImpliedNumber> numbers; ///< z* first
  std::vector<double> correlation;    ///< of their logarithms, by rows; 1 on the diagonal
  std::optional<contact::NormalLaw> law;
  double local_exponent = 0; ///< b at the mean force of the first measurement
  double softness = 1;       ///< k_n over that of Hertz' law there
  /// The quantity that would determine all undetermined numbers if it were measured at the same states within
  /// 2 %; empty where all are determined, or no quantity would do.
  std::optional<Quantity> would_determine;
};

} // namespace granum::inverse
