// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/report/verdict_lists.hpp"

#include <granum/plot/page.hpp>
#include <granum/plot/svg_text.hpp>

namespace granum::studies {

std::string verdict_lists(const std::vector<Verdict>& verdicts) {
  std::vector<std::string> agrees, differs, checks;
  for (const Verdict& verdict : verdicts) {
    const std::string text = verdict.claim + ": " + verdict.measured;
    if (verdict.finding)
      (verdict.holds ? agrees : differs).push_back(text);
    else
      checks.push_back((verdict.holds ? "holds: " : "FAILS: ") + text);
  }
  if (verdicts.empty())
    return plot::html_paragraph("The run has no data for any claim of the paper.");
  const auto part = [](const std::string& title, const std::vector<std::string>& items) {
    return items.empty() ? "" : plot::html_element("h3", plot::svg_escaped(title)) + plot::html_list(items);
  };
  return plot::html_paragraph(
             std::to_string(agrees.size()) + " of " + std::to_string(agrees.size() + differs.size()) +
             " results of the paper are reproduced. A difference is a result, not a failure.") +
         part("Agrees", agrees) + part("Differs", differs) + part("Checks of granum itself", checks);
}

} // namespace granum::studies
