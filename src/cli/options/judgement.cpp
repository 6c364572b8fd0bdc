// SPDX-License-Identifier: GPL-3.0-or-later
#include "judgement.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "cli/frame/help.hpp"
#include "cli/frame/messages.hpp"

namespace granum::cli {

void add_strict(CLI::App& app, bool& strict) {
  app.add_flag("--strict", strict,
               "Fail (exit code 1) if a finding differs from the paper's; do not begin (exit code 4) where a "
               "key of the scene is likely a slip");
  in_group(app, output_group, {"--strict"});
}

ExitCode judged(const std::vector<studies::Verdict>& verdicts, bool strict) {
  ExitCode code = ExitCode::ok;
  const auto fall_short = [&code](std::string_view kind, const studies::Verdict& verdict) {
    say("error", fmt::format("{}: {}: {}", kind, verdict.claim, verdict.measured));
    code = ExitCode::fell_short;
  };
  for (const studies::Verdict& verdict : studies::failed_checks(verdicts))
    fall_short("a check failed", verdict);
  if (strict)
    for (const studies::Verdict& verdict : studies::differing_findings(verdicts))
      fall_short("differs from the paper", verdict);
  return code;
}

} // namespace granum::cli
