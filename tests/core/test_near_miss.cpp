// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/text.hpp>

#include "unit.hpp"

TEST_CASE("slips are counted, whichever word comes first") {
  const struct {
    const char* a;
    const char* b;
    std::size_t slips;
  } all[] = {{"", "", 0},
             {"", "abc", 3},
             {"pressure", "pressure", 0},
             {"pressur", "pressure", 1},   // missing
             {"pressuree", "pressure", 1}, // too many
             {"prezsure", "pressure", 1},  // wrong
             {"perssure", "pressure", 1},  // the wrong way round
             {"kitten", "sitting", 3},
             {"ca", "abc", 3}}; // neighbours that changed places are not touched again
  for (const auto& pair : all) {
    CAPTURE(pair.a);
    CAPTURE(pair.b);
    CHECK(slips_between(pair.a, pair.b) == pair.slips);
    CHECK(slips_between(pair.b, pair.a) == pair.slips);
  }
}

TEST_CASE("the word that was meant is found, and none where none is near") {
  const std::vector<std::string> options{"void-ratio", "stress-v", "stress-h", "d50", "fabric", "from"};
  const std::pair<const char*, std::vector<std::string>> all[] = {{"Void_Ratio", {"void-ratio"}},
                                                                  {"void ratio", {"void-ratio"}},
                                                                  {"void", {"void-ratio"}},
                                                                  {"viod-ratoi", {"void-ratio"}},
                                                                  {"stress", {"stress-v", "stress-h"}},
                                                                  {"fabric tensor", {"fabric"}},
                                                                  {"d5", {"d50"}},
                                                                  {"form", {"from"}},
                                                                  {"temperature", {}},
                                                                  {"", {}}};
  for (const auto& [typed, meant] : all)
    CHECK(near_misses(typed, options) == meant);
  CHECK(near_misses("d50 of grains", options) == std::vector<std::string>{"d50"});
  CHECK(near_misses("abcdefg", std::vector<std::string>{"ab"}).empty());
  CHECK(same_word("Ottawa 20-30", "ottawa-20_30"));
  CHECK_FALSE(same_word("Ottawa 20-30", "ottawa"));
}

TEST_CASE("the question lists up to three words") {
  const std::vector<std::string> words{"rung1", "rung2", "rung3", "rung4", "sphere", "cone", "bone", "tone"};
  const auto has = [](const std::string& text, std::initializer_list<const char*> parts) {
    return std::all_of(parts.begin(), parts.end(),
                       [&](const char* part) { return text.find(part) != std::string::npos; });
  };
  CHECK(has(did_you_mean("sphre", words), {"sphere"}));
  CHECK(has(did_you_mean("xone", words), {"cone", "bone", "tone"}));
  CHECK(did_you_mean("xone", words).find("cone, bone or tone") != std::string::npos);
  CHECK(did_you_mean("rung", words).empty());
  CHECK(did_you_mean("flat", words).empty());
  CHECK(has(unknown_word("contact", "sphere2", words), {"contact", "'sphere2'", "sphere?"}));
  CHECK(has(unknown_word("contact", "flat", std::vector<std::string>{"cone", "punch"}), {"cone, punch"}));
}
