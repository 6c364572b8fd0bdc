// SPDX-License-Identifier: GPL-3.0-or-later
// Assemblies as other codes write them, for the tests of what reads them back.
#pragma once

#include <string>
#include <vector>

#include <granum/assembly/assembly.hpp>
#include <granum/core/number.hpp>
#include <granum/io/lammps_dump.hpp>
#include <granum/io/packing_csv.hpp>

namespace granum::samples {

inline std::string words(const std::vector<double>& numbers, const char* between, int digits = 17) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : between) + (digits == 17 ? exact_text(number) : short_text(number, digits));
  return text;
}

/// An upright box as LAMMPS writes it.
inline std::string dump_box(const Assembly& a, const char* boundary) {
  std::string text = std::string("ITEM: BOX BOUNDS ") + boundary + "\n";
  for (int k = 0; k < 3; ++k)
    text += "0 " + exact_text(a.cell(k, k)) + "\n";
  return text;
}

inline std::string dump_grains(const Assembly& a, long step, int digits = 17,
                               const char* boundary = "pp pp pp") {
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ATOMS\n" +
                     std::to_string(a.grain_count()) + "\n" + dump_box(a, boundary) +
                     "ITEM: ATOMS id radius x y z\n";
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    const Vec3& x = a.position[g];
    text += std::to_string(g + 1) + " " + exact_text(a.radius[g]) + " " +
            words({x.x, x.y, x.z}, " ", digits) + "\n";
  }
  return text;
}

/// Forces are those on the first grain.
inline std::string dump_contacts(const Assembly& a, long step) {
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ENTRIES\n" +
                     std::to_string(a.contacts.size()) + "\n" + dump_box(a, "pp pp pp") +
                     "ITEM: ENTRIES id1 id2 dx dy dz force ftx fty ftz\n";
  for (const Contact& c : a.contacts) {
    const Vec3 d = -c.branch, t = -c.tangential_force;
    text += std::to_string(c.i + 1) + " " + std::to_string(c.j + 1) + " " +
            words({d.x, d.y, d.z, c.normal_force, t.x, t.y, t.z}, " ") + "\n";
  }
  return text;
}

/// What is read back from a dump of one frame.
inline io::ImportedPacking through_dump(const Assembly& a, int digits = 17) {
  io::LammpsDump dump(io::TextSource::of_text("grains", dump_grains(a, 7, digits)),
                      io::TextSource::of_text("contacts", dump_contacts(a, 7)));
  return dump.next().value();
}

inline std::string csv_grains(const Assembly& a) {
  std::string text = "# units: SI\nid,x,y,z,radius\n";
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    const Vec3& x = a.position[g];
    text += std::to_string(g) + "," + words({x.x, x.y, x.z, a.radius[g]}, ",") + "\n";
  }
  return text;
}

inline std::string csv_contacts(const Assembly& a) {
  std::string text = "# units: SI\nid1,id2,nx,ny,nz,fx,fy,fz,lx,ly,lz,delta\n";
  for (const Contact& c : a.contacts) {
    const Vec3 n = normal(c), f = force(c);
    text += std::to_string(c.i) + "," + std::to_string(c.j) + "," +
            words({n.x, n.y, n.z, f.x, f.y, f.z, c.branch.x, c.branch.y, c.branch.z, c.overlap}, ",") + "\n";
  }
  return text;
}

inline io::ImportedPacking through_csv(const Assembly& a) {
  return io::read_packing_csv(io::TextSource::of_text("grains", csv_grains(a)),
                              io::TextSource::of_text("contacts", csv_contacts(a)), io::CsvBox{a.cell});
}

} // namespace granum::samples
