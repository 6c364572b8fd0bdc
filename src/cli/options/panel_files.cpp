// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel_files.hpp"

#include <granum/io/output_file.hpp>

#include "cli/frame/frame.hpp"

namespace granum::cli {

void write_panels(const std::filesystem::path& folder, const std::vector<studies::Panel>& panels) {
  prepare_folder(folder, {}, true);
  for (const studies::Panel& panel : panels)
    for (const auto& [ending, text] :
         {std::pair{".csv", studies::panel_csv(panel)}, {".svg", plot::svg(panel.chart)}})
      io::write_file(folder / (panel.stem + ending), text, io::Existing::replace);
}

} // namespace granum::cli
