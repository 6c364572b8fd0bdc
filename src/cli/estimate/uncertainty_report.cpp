// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/core.h>
#include <granum/core/number.hpp>

#include "uncertainty.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;

/// As in the inputs of the JSON: coordination_number.
std::string json_key(std::string key) {
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

struct Share {
  std::string key;
  double share;
};

/// What each input makes of the variance, and the calibration where it has an error.
std::vector<Share> shares_of(const effective::FirstOrder& first, const std::vector<UncertainInput>& inputs) {
  std::vector<Share> shares;
  for (std::size_t k = 0; k < inputs.size(); ++k)
    shares.push_back({inputs[k].key, first.share(first.contributions[k])});
  if (first.calibration > 0)
    shares.push_back({"calibration", first.share(first.calibration)});
  return shares;
}

ordered_json json_of(const ModulusUncertainty& modulus, const std::vector<UncertainInput>& inputs) {
  ordered_json json = {{"standard_deviation", nullptr}, {"share_of_variance", nullptr}, {"sampled", nullptr}};
  if (const auto& first = modulus.first_order) {
    json["standard_deviation"] = first->deviation;
    json["share_of_variance"] = ordered_json::object();
    for (const Share& share : shares_of(*first, inputs))
      json["share_of_variance"][json_key(share.key)] = share.share;
  }
  if (const auto& band = modulus.sampled)
    json["sampled"] = {{"mean", band->mean},
                       {"standard_deviation", band->deviation},
                       {"q16", band->low},
                       {"q50", band->median},
                       {"q84", band->high}};
  return json;
}

std::string pressure_text(double value) { return pretty(value, Dimension::pressure); }

/// "coordination-number 85 %, grain-shear-modulus 10 %": the three largest, without what rounds to nothing.
std::string shares_text(const effective::FirstOrder& first, const std::vector<UncertainInput>& inputs) {
  std::vector<Share> shares = shares_of(first, inputs);
  std::stable_sort(shares.begin(), shares.end(),
                   [](const Share& a, const Share& b) { return a.share > b.share; });
  shares.resize(std::min<std::size_t>(shares.size(), 3));
  std::string text;
  for (const Share& share : shares)
    if (share.share >= 0.005)
      text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", share.key, 100 * share.share);
  return text;
}

std::string row(const ModulusUncertainty& m, const std::vector<UncertainInput>& inputs) {
  const auto& first = m.first_order;
  const auto& band = m.sampled;
  const std::string undefined = "undefined";
  std::string line = fmt::format(
      "  {:<6} {:>12} {:>15}   {:>11} {:>11} {:>11}   {}", m.key, band ? pressure_text(m.value) : undefined,
      first ? "+- " + pressure_text(first->deviation) : undefined, band ? pressure_text(band->low) : "",
      band ? pressure_text(band->median) : "", band ? pressure_text(band->high) : "",
      first ? shares_text(*first, inputs) : "");
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

} // namespace

ordered_json uncertainty_json(const UncertaintyAnswer& answer) {
  ordered_json json = {{"inputs", ordered_json::object()},
                       {"draws", answer.sampling.draws},
                       {"rejected", answer.rejected},
                       {"seed", answer.sampling.seed}};
  for (const UncertainInput& input : answer.inputs)
    json["inputs"][json_key(input.key)] = {{"value", input.number.value},
                                           {"standard_deviation", input.number.deviation}};
  for (const RungUncertainty& rung : answer.rungs)
    for (const ModulusUncertainty& modulus : rung.moduli)
      json[rung.key][modulus.key] = json_of(modulus, answer.inputs);
  return json;
}

std::string uncertainty_table(const UncertaintyAnswer& answer) {
  std::string text = "\nUncertainty from inputs that are independent and normally distributed\n\n";
  for (const UncertainInput& input : answer.inputs)
    text += fmt::format("  {:<32} {:>10} +- {}\n", input.key, pretty(input.number.value, input.dimension),
                        pretty(input.number.deviation, input.dimension));
  text += fmt::format(
      "\nFirst-order standard deviation; 16, 50 and 84 % of {} draws{}; largest shares of the\nvariance\n",
      answer.sampling.draws,
      answer.rejected > 0 ? fmt::format(", {} of them rejected", answer.rejected) : "");
  for (const RungUncertainty& rung : answer.rungs) {
    text += fmt::format("\n  {}\n", rung.title);
    for (const ModulusUncertainty& modulus : rung.moduli)
      text += row(modulus, answer.inputs);
  }
  return text;
}

} // namespace granum::cli
