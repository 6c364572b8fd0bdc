// SPDX-License-Identifier: GPL-3.0-or-later
// What analyse is told in a text of its own, one a line: frames, box, stress, window, depth, materials. Each
// is taken or refused with a message.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "cli/analyse/analyse_options.hpp"
#include "input.hpp"

using namespace granum;

namespace {

std::vector<std::string> lines(std::string_view rest) {
  std::vector<std::string> out;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    out.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return out;
}

template <class Action>
void taken_or_refused(const Action& action) {
  try {
    action();
  } catch (const InvalidArgument& error) {
    fuzz::demand(!std::string(error.what()).empty());
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> texts = lines(fuzz::text(data, size));
  const std::vector<std::string> materials(
      texts.begin() + static_cast<long>(std::min<std::size_t>(texts.size(), 5)), texts.end());
  texts.resize(5);
  taken_or_refused([&] {
    const cli::FrameChoice frames = cli::parse_frames(texts[0]);
    fuzz::demand(frames.stride > 0 && frames.first <= frames.last);
    (void)frames.takes(std::numeric_limits<std::size_t>::max());
  });
  taken_or_refused([&] {
    if (const auto box = cli::parse_box(texts[1]))
      for (const double value : {box->cell(0, 0), box->cell(1, 1), box->cell(2, 2)})
        fuzz::demand(value > 0 && std::isfinite(value));
  });
  taken_or_refused([&] {
    for (const double value : cli::parse_stress(texts[2]))
      fuzz::demand(std::isfinite(value));
  });
  taken_or_refused([&] {
    if (const auto window = cli::parse_window(texts[3], texts[4])) {
      for (std::size_t k = 0; k < 3; ++k)
        for (const auto& end : {window->low[k], window->high[k]})
          fuzz::demand(!end || std::isfinite(*end));
      if (window->depth)
        fuzz::demand(window->depth->first >= 0 && window->depth->second > 0);
    }
  });
  taken_or_refused([&] {
    for (const auto& material : cli::parse_materials(materials))
      fuzz::demand(material.second.shear_modulus > 0 && material.second.poisson_ratio > -1 &&
                   material.second.poisson_ratio <= 0.5);
  });
  return 0;
}
