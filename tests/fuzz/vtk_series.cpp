// SPDX-License-Identifier: GPL-3.0-or-later
// Series of VTK files: read in the order of their times, and equal when written and read again.
#include <cmath>

#include <granum/io/vtk/xml.hpp>

#include "input.hpp"

using namespace granum;

namespace {

io::TextSource source(std::string_view text) { return io::TextSource::of_text("series", text); }

/// A control character cannot be written into XML.
bool writable(const std::vector<io::SeriesEntry>& series) {
  for (const io::SeriesEntry& entry : series)
    for (const char c : entry.file)
      if (static_cast<unsigned char>(c) < 0x20)
        return false;
  return true;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run([&] {
    const std::string_view text = fuzz::text(data, size);
    io::TextSource first = source(text);
    (void)io::is_collection(first);
    const std::vector<io::SeriesEntry> series = io::read_collection(source(text));
    fuzz::demand(!series.empty());
    for (std::size_t k = 0; k < series.size(); ++k) {
      fuzz::demand(std::isfinite(series[k].time) && !series[k].file.empty());
      fuzz::demand(k == 0 || series[k - 1].time < series[k].time);
    }
    if (!writable(series))
      return;
    const std::string written = io::pvd(series);
    const std::vector<io::SeriesEntry> again = io::read_collection(source(written));
    fuzz::demand(again.size() == series.size());
    for (std::size_t k = 0; k < series.size(); ++k)
      fuzz::demand(again[k].time == series[k].time && again[k].file == series[k].file);
  });
}
