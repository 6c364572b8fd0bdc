// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/table.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run([&] {
    const std::vector<sizes::SievePoint> curve =
        io::sieve_curve(io::CsvTable("sieves", fuzz::text(data, size)));
    fuzz::demand(!sizes::find_fault(curve));
    const auto grains = sizes::Distribution::sieve(curve); // a curve without fault is a distribution
    fuzz::demand(grains.mean_radius() && *grains.mean_radius() > 0);
    fuzz::demand(grains.smallest() <= 1 && grains.largest() >= 1);
    fuzz::demand(grains.moment(3) >= 1 - 1e-9);
  });
}
