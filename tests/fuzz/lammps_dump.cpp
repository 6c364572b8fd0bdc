// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/files.hpp>

#include "input.hpp"

using namespace granum;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::run([&] {
    const fuzz::Parts input = fuzz::parts(fuzz::text(data, size));
    io::TextSource atoms = io::TextSource::of_text("atoms", input.first);
    io::LammpsDump dump =
        input.second ? io::LammpsDump(std::move(atoms), io::TextSource::of_text("contacts", *input.second))
                     : io::LammpsDump(std::move(atoms));
    while (const auto packing = dump.next())
      fuzz::check(*packing);
  });
}
