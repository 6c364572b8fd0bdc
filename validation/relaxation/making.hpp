// SPDX-License-Identifier: GPL-3.0-or-later
// Compresses specimens and records their states, on several threads.
#pragma once

#include "../common.hpp"
#include "recording.hpp"
#include "specimens.hpp"
#include "studies/running/work_sharing.hpp"

namespace relaxation {

/// One specimen, and the beginnings of the rows of its stages.
struct Task {
  std::string shape;
  Preparation preparation;
  triaxial::SpecimenRecipe recipe;
  std::vector<Row> keys;
  double pressure_limit = std::numeric_limits<double>::infinity(); ///< of the stages that are wanted [Pa]
};

/// Compresses the specimen along its path, as far as the record lacks stages; `describe` fills the row of one
/// that it lacks, with the frozen state and the task. States that do not come to rest, or whose grains have
/// not met, are named on the error stream and left out.
template <class Describe>
void record_path(const Task& task, Packings& packings, Record& record, const Describe& describe) {
  const auto& [shape, preparation, recipe, keys, pressure_limit] = task;
  std::size_t last_missing = 0;
  for (std::size_t k = 0; k < keys.size(); ++k)
    if (preparation.path[k].pressure <= pressure_limit && !record.has(keys[k]))
      last_missing = k + 1;
  if (last_missing == 0)
    return;
  dem::Specimen state = start_of_path(packings.get(shape, recipe), preparation, recipe);
  for (std::size_t k = 0; k < last_missing; ++k) {
    state = at_stage(std::move(state), preparation, k, recipe.material);
    Row row = keys[k];
    const std::string name = record.key_of(row.cells);
    if (record.has(row))
      continue;
    const triaxial::FrozenState frozen = triaxial::freeze_in_place(state, recipe.material);
    if (const std::string why = why_left_out(frozen, recipe.material); !why.empty()) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), why.c_str());
      continue;
    }
    describe(row, frozen.state(), task);
    record.append(row);
    std::fprintf(stderr, "%s\n", name.c_str());
  }
}

/// All of them; the error of one is printed, and the others go on.
template <class Describe>
void record_all(const std::vector<Task>& tasks, std::size_t threads, Record& record,
                const Describe& describe) {
  Packings packings;
  studies::side_by_side(tasks.size(), threads, [&](std::size_t k) {
    try {
      record_path(tasks[k], packings, record, describe);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", record.key_of(tasks[k].keys.front().cells).c_str(), error.what());
    }
  });
}

} // namespace relaxation
