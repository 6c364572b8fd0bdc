// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/effective/rungs.hpp>
#include <granum/effective/sensitivity/uncertainty.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/packing_options.hpp"

/// What granum estimate --uncertainty works out, and how it is put into words.
namespace granum::cli {

/// An option whose value is uncertain.
struct UncertainInput {
  std::string key; ///< the option without its hyphens
  Dimension dimension;
  std::size_t index; ///< in numbers(PackingOptions&)
  effective::UncertainNumber number;
};

/// Nothing where a modulus, or its derivative, does not exist.
struct ModulusUncertainty {
  const char* key;
  double value = 0;
  std::optional<effective::FirstOrder> first_order = std::nullopt;
  std::optional<effective::Band> sampled = std::nullopt;
};

struct RungUncertainty {
  const char* title;
  const char* key;
  std::vector<ModulusUncertainty> moduli;
};

struct UncertaintyAnswer {
  std::vector<UncertainInput> inputs;
  effective::Sampling sampling;
  std::size_t rejected = 0; ///< draws that no packing can have
  std::vector<RungUncertainty> rungs;
  Validity validity;
};

void add_uncertainty_option(CLI::App& command, std::vector<std::string>& settings);

/// The option of a number without its hyphens.
[[nodiscard]] std::string key_of(const Number& number);
/// The deviation that "key=sd" says of a number; nothing if it speaks of another.
/// \throws   InvalidArgument for a bad deviation
[[nodiscard]] std::optional<double> said_deviation(const std::string& setting, const Number& number);

/// Works out the uncertainty of every modulus that granum estimate shows.
/// \param    settings   key=sd; sd with the unit of the key, or in per cent of its value
/// \throws   InvalidArgument for a key that is no input of this packing, given twice, or with a bad deviation
[[nodiscard]] UncertaintyAnswer propagate(const PackingOptions& options,
                                          const std::vector<std::string>& settings);

[[nodiscard]] nlohmann::ordered_json uncertainty_json(const UncertaintyAnswer& answer);
[[nodiscard]] std::string uncertainty_table(const UncertaintyAnswer& answer);

} // namespace granum::cli
