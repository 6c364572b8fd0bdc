// SPDX-License-Identifier: GPL-3.0-or-later
#include "state_series.hpp"

#include <algorithm>

#include <granum/io/text/source.hpp>

namespace granum::studies {

namespace {

using Frames = std::vector<FrameAnswer>;

/// Exponents of one rung over the frames of a series.
RungSeries rung_series(const Frames& frames, const std::vector<std::size_t>& members,
                       const RungResult& rung) {
  std::vector<hardin::MeasuredModulus> mean, by_direction;
  for (const std::size_t k : members) {
    const FrameAnswer& frame = frames[k];
    const RungResult* its = find_rung(frame, rung.name);
    const auto p = mean_stress(frame);
    if (its == nullptr || !p)
      continue;
    const double e = frame.measured.packing.interior_void_ratio();
    if (its->moduli->G > 0)
      mean.push_back({its->moduli->G, {*p, *p, e}});
    if (const auto& state = frame.measured.packing.state; state && its->one_axis && its->moduli->G_vh > 0)
      by_direction.push_back({its->moduli->G_vh, {state->stress_v, state->stress_h, e}});
  }
  SeriesFit separate = fit_series(by_direction);
  return {rung.name, rung.title, fit_series(mean), std::move(separate.separate),
          separate.separate_remark.empty() ? separate.remark : separate.separate_remark};
}

StateSeries one_series(const Frames& frames, std::string name, std::vector<std::size_t> members) {
  StateSeries out{.name = std::move(name), .frames = std::move(members), .rungs = {}};
  const auto longest =
      std::max_element(out.frames.begin(), out.frames.end(), [&](std::size_t a, std::size_t b) {
        return frames[a].rungs.size() < frames[b].rungs.size();
      });
  for (const RungResult& rung : frames[*longest].rungs)
    out.rungs.push_back(rung_series(frames, out.frames, rung));
  return out;
}

} // namespace

std::vector<StateSeries> series_of(const Frames& frames, SeriesBy by) {
  std::vector<StateSeries> out;
  if (frames.size() < 2)
    return out;
  std::vector<std::string> files;
  for (const FrameAnswer& frame : frames)
    files.push_back(frame.file);
  const std::vector<std::string> names = io::series_by_name(files);
  std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const auto same = [&](const auto& group) { return group.first == names[k]; };
    const auto found = std::find_if(groups.begin(), groups.end(), same);
    (found == groups.end() ? groups.emplace_back(names[k], std::vector<std::size_t>{}) : *found)
        .second.push_back(k);
  }
  const bool single =
      std::all_of(groups.begin(), groups.end(), [](const auto& g) { return g.second.size() < 2; });
  if (by == SeriesBy::all || single) {
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < frames.size(); ++k)
      members.push_back(k);
    groups = {{"all", std::move(members)}};
  }
  for (auto& [name, members] : groups)
    out.push_back(one_series(frames, name, std::move(members)));
  return out;
}

} // namespace granum::studies
