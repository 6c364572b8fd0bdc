// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/text.hpp>

#include "unit.hpp"

TEST_CASE("utf8: lengths of characters, 0 for invalid ones") {
  for (const auto& [text, length] :
       {std::pair{"a", 1}, {"\u03b3", 2}, {"\u2264", 3}, {"\U0001F600", 4}, {"", 0}})
    CHECK(utf8_length(text) == static_cast<std::size_t>(length));
  for (const char* wrong : {"\x80", "\xC3", "\xC3(", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
                            "\xEF\xBF\xBF", "\xF0\x80\x80\xAF", "\xF4\x90\x80\x80", "\xFF"})
    CHECK_MESSAGE(utf8_length(wrong) == 0, static_cast<int>(static_cast<unsigned char>(wrong[0])));
}

TEST_CASE("utf8: control characters are escaped, and nothing else is changed") {
  CHECK(printable("\x1b[2Ja\rb\x07\x7f") == "\\x1b[2Ja\\x0db\\x07\\x7f");
  CHECK(printable(std::string("\0", 1)) == "\\x00");
  CHECK(printable("\x9b"
                  "1m \xC2\x9b"
                  "1m") == "\\x9b1m \\xc2\\x9b1m"); // the terminal's other way to say ESC [
  CHECK(printable("a\u202Eb\u2066c") == "a\\xe2\\x80\\xaeb\\xe2\\x81\\xa6c"); // would turn what follows
  for (const char* unseen :
       {"\u00AD", "\u061C", "\u200B", "\u200E", "\u2028", "\u2060", "\uFEFF", "\U000E0041"})
    CHECK(printable(unseen).starts_with("\\x"));
  const std::string harmless =
      "p\u2032 = 1\tkPa\n\u03c3_v, H\xF6he, \u00df, \u2030, \u200D, \U0001F600, \xE4, \xAD";
  CHECK(printable(harmless) == harmless);
}

TEST_CASE("hidden characters of JSON are escapes, which its reader takes back") {
  CHECK(printable_json("{\"a\u202Eb\": \"\u009B2J\x7f\"}\n") == "{\"a\\u202eb\": \"\\u009b2J\\u007f\"}\n");
  CHECK(printable_json("\"\U000E0041\"") == "\"\\udb40\\udc41\"");
  const std::string harmless = "{\n\t\"path\": \"/Körner/砂 \U0001F3D6.csv\"\n}\n";
  CHECK(printable_json(harmless) == harmless);
}
