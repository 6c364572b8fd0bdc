// SPDX-License-Identifier: GPL-3.0-or-later
#include "judgement.hpp"

#include <fmt/core.h>

#include "cli/frame/messages.hpp"

namespace granum::cli {

void add_strict(Command& command, bool& strict) {
  command.add(output_group,
              {{.name = "--strict",
                .value = flag(strict),
                .meaning = "Fail (exit code 1) if a result differs from the paper's by more than its goal; "
                           "stop before the run (exit code 4) "
                           "if a key of the scene is probably a mistake"}});
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
