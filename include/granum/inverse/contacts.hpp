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
#include <granum/core/measured.hpp>
#include <granum/effective/state.hpp>
#include <granum/inverse/quantity.hpp>

/// Contacts that measurements are asked for, besides their number.
namespace granum::inverse {

/// A positive number of the contact law, and what is known of it before anything is measured: its logarithm
/// is normal.
struct UnknownNumber {
  std::string key;
  double expected = 1; ///< in its unit
  double scatter = 1;  ///< standard deviation of its logarithm; wide, so that it hardly moves what data tell
  std::string unit = {};
};

/// A family of contact laws with unknown numbers.
struct UnknownContacts {
  std::string name = "given"; ///< "given": none is asked for
  std::vector<UnknownNumber> numbers;
  /// The law of these numbers.
  /// \param    given   that of the measured state
  /// \param    force   mean contact force of the first measurement [N]
  std::function<contact::NormalLaw(const contact::NormalLaw& given, double force,
                                   std::span<const double> numbers)>
      law;
};

/// Those that can be asked for, by name:
///   given       the law of the states, none of whose numbers is asked for
///   rough       spheres of roughness u0 [m], expected 20 nm within a factor of 10
///   power-law   f ~ d^(1+1/alpha): `softness`, k_n over that of Hertz' law at the mean force of the first
///               measurement, expected 1 within a factor of 3, and `alpha`, expected 2 within a factor of 2
/// What the last two replace is a law of smooth spheres.
/// \throws   InvalidArgument with all names for another name
/// Checked by tests/inverse/test_contacts.cpp
[[nodiscard]] UnknownContacts unknown_contacts(std::string_view name);
[[nodiscard]] std::span<const std::string_view> unknown_contact_names();

/// f = c d^(1+1/alpha) with a stiffness k_n > 0 [N/m] at a force > 0 [N].
/// \throws   InvalidArgument unless 0 < alpha < infinity and c is a positive number
/// Accuracy  relative 1e-13.  Checked by tests/inverse/test_contacts.cpp
[[nodiscard]] contact::PowerLaw power_law_through(const contact::GrainMaterial& grain, double alpha,
                                                  double force, double stiffness);

/// What the measurements say of one number: z*, or one of the contact law.
struct ImpliedNumber {
  std::string key;
  std::string unit;
  Measured value;
  double before = 0; ///< standard deviation before anything was measured
  /// Whether the measurements take at least half of that away, and leave less than half of the value open.
  [[nodiscard]] bool determined() const { return value.standard_error < 0.5 * std::min(before, value.value); }
};

/// Contacts that measurements imply.
struct ImpliedContacts {
  std::vector<ImpliedNumber> numbers; ///< z* first
  std::vector<double> correlation;    ///< of their logarithms, by rows; 1 on the diagonal
  std::optional<contact::NormalLaw> law;
  double local_exponent = 0; ///< b at the mean force of the first measurement
  double softness = 1;       ///< k_n over Hertz' there
  /// What, measured at the same states within 2 %, would tell every number that they do not; nothing where
  /// all are determined, or none would.
  std::optional<Quantity> would_determine;
};

} // namespace granum::inverse
