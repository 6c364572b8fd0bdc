// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/references.hpp>

#include "unit.hpp"

TEST_CASE("references: every source is typeset for readers") {
  CHECK(references().size() > 80);
  CHECK(std::ranges::is_sorted(references(), {}, &Reference::key));
  for (const Reference& one : references()) {
    CAPTURE(one.key);
    const std::string all = std::string(one.text) + " " + std::string(one.remark);
    CAPTURE(all);
    for (const char* raw : {"\\", "{", "}", "$", "--", "~", "from memory", "not found", " and others", " ,"})
      CHECK(all.find(raw) == std::string::npos);
    CHECK(one.text.ends_with("."));
    CHECK((one.text.find("(1") != std::string_view::npos || one.text.find("(2") != std::string_view::npos));
    CHECK((one.link.empty() || one.link.starts_with("https://")));
    CHECK(one.link.find_first_of(" {}\\") == std::string_view::npos);
  }
}

TEST_CASE("references: those that a text cites") {
  const std::vector<Reference> cited = references_in("[Menq2003; Lo2021], and of 2000");
  REQUIRE(cited.size() == 2);
  CHECK(cited[0].key == "Lo2021");
  CHECK(cited[1].key == "Menq2003");
  CHECK(cited[1].remark.find(", https://github.com/") != std::string_view::npos); // read there, not itself
}
