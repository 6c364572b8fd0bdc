// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyse_paraview.hpp"

#include <string>
#include <utility>

namespace granum::cli {

ParaviewFrames::ParaviewFrames(std::filesystem::path folder, io::Existing existing)
    : folder_(std::move(folder)), existing_(existing) {}

void ParaviewFrames::add(const io::ImportedPacking& packing, std::size_t number) {
  const double time = packing.time.value_or(static_cast<double>(packing.step));
  grains_.push_back({time, "grains-" + std::to_string(number) + ".vtu"});
  io::write_file(folder_ / grains_.back().file, io::grains_vtu(packing.assembly, packing.id, packing.time),
                 existing_);
  contacts_.push_back({time, "contacts-" + std::to_string(number) + ".vtp"});
  io::write_file(folder_ / contacts_.back().file, io::contacts_vtp(packing.assembly, packing.id), existing_);
}

void ParaviewFrames::finish() const {
  io::write_file(folder_ / "grains.pvd", io::pvd(grains_), existing_);
  io::write_file(folder_ / "contacts.pvd", io::pvd(contacts_), existing_);
}

} // namespace granum::cli
