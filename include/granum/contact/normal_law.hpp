// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/contact/rough_sphere.hpp>

/// The contact law of two grains, of any kind, for closed forms, networks and the engine.
namespace granum::contact {

/// Requirements of a contact law: f(d), d(f), k_n, its local exponent b = d ln k_n/d ln f with its
/// slope db/d ln f, and the energy, each checked; the same law of other grains and of pairs of other sizes;
/// and its kernels for sweeps. b is `constant_exponent` where it is the same at every force, which keeps
/// closed forms closed.
template <class Law>
concept ContactLaw = std::equality_comparable<Law> &&
    requires(const Law& law, const GrainMaterial& grain, double x) {
  typename Law::Kernel; // a std::variant of unchecked kernels, as those of power_law.hpp
  { law.force(x) } -> std::same_as<double>;
  { law.overlap(x) } -> std::same_as<double>;
  { law.stiffness_at_overlap(x) } -> std::same_as<double>;
  { law.stiffness_at_force(x) } -> std::same_as<double>;
  { law.exponent_at_force(x) } -> std::same_as<double>;
  { law.exponent_slope_at_force(x) } -> std::same_as<double>;
  { law.constant_exponent() } -> std::same_as<std::optional<double>>;
  { law.surface() } -> std::same_as<Surface>;
  law.closing_law(); // one of the laws
  { law.first_stiffness() } -> std::same_as<double>;
  { law.energy(x) } -> std::same_as<double>;
  { law.grain() } -> std::same_as<const GrainMaterial&>;
  { law.of_grain(grain) } -> std::same_as<Law>;
  { law.of(grain, x) } -> std::same_as<Law>;
  { law.depends_on_size() } -> std::same_as<bool>;
  { law.of_pair_radius(x) } -> std::same_as<Law>;
  { law.kernel() } -> std::same_as<typename Law::Kernel>;
  { law.power_law() } -> std::same_as<const PowerLaw*>; // null where it is none
  { *law.numbers().begin() } -> std::convertible_to<double>;
  { Law::of_numbers(grain, law.numbers()) } -> std::same_as<Law>; // the same law, to the bit
  { law.text() } -> std::same_as<std::string>;
};

/// The laws that there are. A new one is named here and has its rows in the table of laws.hpp.
using AnyLaw = std::variant<PowerLaw, RoughSphere>;

namespace detail {
template <class... Variants>
struct Joined;
template <class... A>
struct Joined<std::variant<A...>> {
  using type = std::variant<A...>;
};
template <class... A, class... Rest>
struct Joined<std::variant<A...>, std::variant<>, Rest...> : Joined<std::variant<A...>, Rest...> {};
template <class... A, class B, class... C, class... Rest>
struct Joined<std::variant<A...>, std::variant<B, C...>, Rest...>
    : Joined<std::conditional_t<(std::same_as<A, B> || ...), std::variant<A...>, std::variant<A..., B>>,
             std::variant<C...>, Rest...> {}; // each kernel once
template <class>
struct KernelsOf;
template <class... Laws>
struct KernelsOf<std::variant<Laws...>> : Joined<typename Laws::Kernel...> {};
template <class Law, class Laws>
inline constexpr bool is_one_of = false;
template <class Law, class... Laws>
inline constexpr bool is_one_of<Law, std::variant<Laws...>> = (std::same_as<Law, Laws> || ...);
} // namespace detail

/// The kernels of all laws. A sweep visits its kernel once, outside of the loop over contacts.
using NormalKernel = detail::KernelsOf<AnyLaw>::type;

/// One of the laws, as a value. All modules above use this type; code for the power family only calls
/// power_law(). Units, ranges and accuracy are those of the contained law.
/// Checked by tests/contact/test_laws.cpp, for every row of the table of laws
class NormalLaw {
  template <class Function>
  decltype(auto) visit(const Function& function) const {
    return std::visit(function, law_);
  }

 public:
  /// Implicit, so that any law can be used as a NormalLaw.
  template <ContactLaw Law>
  requires detail::is_one_of<Law, AnyLaw> NormalLaw(Law law)
      : law_(std::move(law)) {} // NOLINT(google-explicit-constructor)

  /// f of the overlap d >= 0, the full approach [N].
  [[nodiscard]] double force(double overlap) const {
    return visit([=](const auto& law) { return law.force(overlap); });
  }
  /// d at a force f >= 0 [m].
  [[nodiscard]] double overlap(double force) const {
    return visit([=](const auto& law) { return law.overlap(force); });
  }
  /// k_n = df/dd at d >= 0 [N/m].
  [[nodiscard]] double stiffness_at_overlap(double overlap) const {
    return visit([=](const auto& law) { return law.stiffness_at_overlap(overlap); });
  }
  /// k_n at f >= 0 [N/m].
  [[nodiscard]] double stiffness_at_force(double force) const {
    return visit([=](const auto& law) { return law.stiffness_at_force(force); });
  }
  /// b = d ln k_n/d ln f at f >= 0 [1].
  [[nodiscard]] double exponent_at_force(double force) const {
    return visit([=](const auto& law) { return law.exponent_at_force(force); });
  }
  /// db/d ln f at f >= 0 [1].
  [[nodiscard]] double exponent_slope_at_force(double force) const {
    return visit([=](const auto& law) { return law.exponent_slope_at_force(force); });
  }
  /// b where it is the same at every force.
  [[nodiscard]] std::optional<double> constant_exponent() const {
    return visit([](const auto& law) { return law.constant_exponent(); });
  }
  /// What the surfaces in contact mean for a packing.
  [[nodiscard]] Surface surface() const {
    return visit([](const auto& law) { return law.surface(); });
  }
  /// The law whose overlap brings further grains into contact.
  [[nodiscard]] NormalLaw closing_law() const {
    return visit([](const auto& law) { return NormalLaw(law.closing_law()); });
  }
  /// k_n that the time step of a simulation must resolve while no contact is stiffer [N/m]; 0: any.
  [[nodiscard]] double first_stiffness() const {
    return visit([](const auto& law) { return law.first_stiffness(); });
  }
  /// Elastic energy, the integral of the force up to d >= 0 [J].
  [[nodiscard]] double energy(double overlap) const {
    return visit([=](const auto& law) { return law.energy(overlap); });
  }
  /// Material of both grains.
  [[nodiscard]] const GrainMaterial& grain() const {
    return visit([](const auto& law) -> const GrainMaterial& { return law.grain(); });
  }
  /// The same surface on grains of another solid.
  /// \throws   InvalidArgument if it is out of range
  [[nodiscard]] NormalLaw of_grain(const GrainMaterial& grain) const {
    return visit([&](const auto& law) { return NormalLaw(law.of_grain(grain)); });
  }
  /// The same surface on two equal grains of another solid and radius [m].
  /// \throws   InvalidArgument if they are out of range
  [[nodiscard]] NormalLaw of(const GrainMaterial& grain, double radius) const {
    return visit([&](const auto& law) { return NormalLaw(law.of(grain, radius)); });
  }
  /// Whether the law of a pair depends on the sizes of its grains.
  [[nodiscard]] bool depends_on_size() const {
    return visit([](const auto& law) { return law.depends_on_size(); });
  }
  /// The law of a pair whose pair_radius is so many times that of this law's pair (grains.hpp).
  /// \throws   InvalidArgument if the ratio is not positive and finite
  [[nodiscard]] NormalLaw of_pair_radius(double ratio) const {
    return visit([=](const auto& law) { return NormalLaw(law.of_pair_radius(ratio)); });
  }
  /// The unchecked kernel of the law, for sweeps.
  [[nodiscard]] NormalKernel kernel() const {
    return visit([](const auto& law) {
      return std::visit([](const auto& kernel) { return NormalKernel(kernel); }, law.kernel());
    });
  }
  /// The numbers that determine the forces: laws with the same numbers have the same forces, to the bit.
  [[nodiscard]] std::vector<double> numbers() const {
    return visit([](const auto& law) {
      const auto all = law.numbers();
      return std::vector<double>(all.begin(), all.end());
    });
  }
  /// Which of the laws it is, for of_numbers(): a place in AnyLaw.
  [[nodiscard]] std::size_t kind() const { return law_.index(); }
  /// The law of this kind, grain and numbers(), to the bit: out of a file, or of another process.
  /// \throws   InvalidArgument for another kind, as many numbers as it has not, or one that is out of range
  [[nodiscard]] static NormalLaw of_numbers(std::size_t kind, const GrainMaterial& grain,
                                            std::span<const double> numbers);
  /// Kind and numbers, for people who compare two.
  [[nodiscard]] std::string text() const {
    return visit([](const auto& law) { return law.text(); });
  }

  /// The law as one of the power family; null where it is none.
  [[nodiscard]] const PowerLaw* power_law() const {
    return visit([](const auto& law) { return law.power_law(); });
  }

  bool operator==(const NormalLaw&) const = default;

 private:
  AnyLaw law_;
};

} // namespace granum::contact
