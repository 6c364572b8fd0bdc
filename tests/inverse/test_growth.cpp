// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/quantity.hpp>

#include "unit.hpp"

using namespace granum::inverse;

namespace {

template <class Action>
std::string complaint(const Action& action) {
  try {
    action();
  } catch (const granum::InvalidArgument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("growths and specimens: each is found by its name") {
  for (const GrowthRule growth : all_growth_rules)
    CHECK(growth_rule_of(name(growth)) == growth);
  for (const AskedPacking specimen : all_asked_packings)
    CHECK(asked_packing_of(name(specimen)) == specimen);
  CHECK(name(GrowthRule::packings) == "packings");
  CHECK(name(AskedPacking::prepared_alike) == "prepared_alike");
}

TEST_CASE("growths, specimens and quantities: an unknown name is refused with all known ones") {
  for (const char* known : {"packings", "fixed", "fitted", "Fixed"})
    CHECK(complaint([] { (void)growth_rule_of("Fixed"); }).find(known) != std::string::npos);
  for (const char* known : {"same", "prepared_alike"})
    CHECK(complaint([] { (void)asked_packing_of(""); }).find(known) != std::string::npos);
  CHECK(complaint([] { (void)quantity_of("E"); }).find("G, G_hh, K, V_s, V_s_hh, V_p, V_p_h") !=
        std::string::npos);
  CHECK_THROWS_AS((void)name(static_cast<GrowthRule>(9)), granum::InvalidArgument);
  CHECK_THROWS_AS((void)name(static_cast<AskedPacking>(9)), granum::InvalidArgument);
}
