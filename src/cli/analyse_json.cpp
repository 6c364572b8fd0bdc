// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse.hpp"
#include "frame.hpp"

namespace granum::cli {

using nlohmann::ordered_json;

ordered_json analyse_json(const AnalyseAnswer& answer) {
  ordered_json json = json_head("analyse");
  json["files"] = answer.files;
  return json;
}

} // namespace granum::cli
