// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "cli/commands.hpp"
#include "io/temporary_folder.hpp"

/// What `granum sweep`, or another command, writes to a file.
inline std::string swept(const std::vector<std::string>& words, const std::string& command = "sweep") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "curve").string();
  std::vector<std::string> all{"granum", command, "--out", file};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all)
    arguments.push_back(word.data());
  REQUIRE(granum::cli::parse_and_run(static_cast<int>(arguments.size()), arguments.data()) ==
          granum::cli::ExitCode::ok);
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}
