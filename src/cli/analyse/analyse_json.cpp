// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_fields.hpp"
#include "cli/frame/frame.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/options/packing_json.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;

ordered_json frame_json(const FrameAnswer& frame) {
  const analysis::Measurement& a = frame.measured.packing;
  ordered_json json = members(frame_fields(frame), frame);
  if (a.counts.grains == 0)
    return json;
  json["gradation"] = json_of(a.sizes.gradation);
  json["contact_means"] = frame.measured.contacts_known ? json_of(a.sizes.contacts) : ordered_json();
  for (const char* part : {"stress", "forces"})
    if (!a.forces && !json.contains(part))
      json[part] = nullptr;
  return json;
}

ordered_json series_json(const AnalyseAnswer& answer, const StateSeries& series) {
  ordered_json json = {{"name", series.name}, {"frames", ordered_json::array()}};
  for (const std::size_t k : series.frames)
    json["frames"].push_back(answer.frames[k].number);
  for (const RungSeries& rung : series.rungs) {
    ordered_json& exponents = json["exponents"][rung.name];
    put_members(exponents, sum_fields(), rung);
    put_members(exponents, separate_fields(), rung);
  }
  return json;
}

} // namespace

ordered_json analyse_json(const AnalyseAnswer& answer) {
  ordered_json json = json_head("analyse");
  for (std::size_t k = 0; k < answer.files.size(); ++k)
    json["files"].push_back({{"path", answer.files[k]}, {"kind", io::description(answer.kinds[k])}});
  json["conventions"] = {
      {"units", "SI"},
      {"signs", "compression positive; z is the vertical axis v"},
      {"stiffness",
       "C of the network in the axes of the file, Voigt order 11 22 33 23 13 12, engineering shear "
       "strains; moduli are projections: K and G isotropic, the others symmetric about z"}};
  json["frames_skipped"] = answer.skipped;
  json["frames"] = ordered_json::array();
  for (const FrameAnswer& frame : answer.frames)
    json["frames"].push_back(frame_json(frame));
  for (const StateSeries& series : answer.series)
    json["series"].push_back(series_json(answer, series));
  return json;
}

} // namespace granum::cli
