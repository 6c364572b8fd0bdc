// SPDX-License-Identifier: GPL-3.0-or-later
// The contact law that measurements imply, as a section of a document.
#include <fmt/format.h>
#include <granum/core/text.hpp>

#include "infer.hpp"

namespace granum::cli {

namespace {

/// Numbers not determined by the data, and a quantity that would determine them.
Prose open_question(const inverse::ImpliedContacts& contacts) {
  std::vector<std::string> open;
  for (const inverse::ImpliedNumber& number : contacts.numbers)
    if (!number.determined())
      open.push_back(number.key);
  if (open.empty())
    return {};
  return {{fmt::format("not determined by these data: {}", fmt::join(open, ", ")),
           contacts.would_determine
               ? fmt::format("{} at the same states, within 2 %, would determine all",
                             inverse::row_of(*contacts.would_determine).key)
               : "no further quantity at the same states would determine them: measure over a wider range of "
                 "pressures"}};
}

} // namespace

void add_contact_law(Document& to, const std::string& kind, const inverse::ImpliedContacts& contacts) {
  using inverse::ImpliedNumber;
  Items law{.key = "contacts", .title = "inferred contact law: " + kind};
  io::add_item(law.items, "kind", kind);
  for (const ImpliedNumber& number : contacts.numbers)
    add_line(law, number.key.c_str(),
             number.unit.empty() ? with_error(number.value, 3)
                                 : fmt::format("{} +- {}", pretty(number.value.value, Dimension::length),
                                               pretty(number.value.standard_error, Dimension::length)));
  io::add_item(law.items, "exponent", contacts.local_exponent,
               io::ShownColumn{.heading = "b",
                               .digits = 3,
                               .meaning = "k_n ~ f^b at the mean contact force f of the first measurement"});
  io::ShownColumn softness = shown_as_percent("k_n");
  softness.meaning = "of k_n by Hertz' law at this f";
  io::add_item(law.items, "softness", contacts.softness, softness);
  io::add_item(law.items, "correlation", contacts.correlation);
  const std::size_t size = contacts.numbers.size();
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = i + 1; k < size; ++k)
      add_line(law, "correlation", fmt::format("{:.2f}", contacts.correlation[i * size + k]),
               fmt::format("of ln {} and ln {}", contacts.numbers[i].key, contacts.numbers[k].key));
  io::add_item(law.items, "would_determine",
               contacts.would_determine
                   ? io::Value(std::string(inverse::row_of(*contacts.would_determine).key))
                   : io::Value(nullptr));
  to.add(Seen::always, std::move(law));
  const io::Columns<ImpliedNumber> columns = {
      {"", "key", &ImpliedNumber::key},
      {"", "value", [](const ImpliedNumber& number) { return number.value.value; }},
      {"", "standard_error", [](const ImpliedNumber& number) { return number.value.standard_error; }},
      {"", "determined", &ImpliedNumber::determined}};
  to.add(Seen::data, table_of("contacts/numbers", "", columns, contacts.numbers));
  to.add(Seen::always, open_question(contacts));
}

} // namespace granum::cli
