// SPDX-License-Identifier: GPL-3.0-or-later
// Assemblies as other codes write them, for the tests of what reads them back.
#pragma once

#include <string>
#include <vector>

#include <granum/core/text.hpp>
#include <granum/io/csv/packing.hpp>
#include <granum/io/lammps/files.hpp>
#include <granum/io/mercury/output.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::samples {

inline std::string words(const std::vector<double>& numbers, const char* between, int digits = 17) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : between) + (digits == 17 ? exact_text(number) : short_text(number, digits));
  return text;
}

/// An upright box as LAMMPS writes it.
inline std::string dump_box(const packing::Assembly& a, const char* boundary) {
  std::string text = std::string("ITEM: BOX BOUNDS ") + boundary + "\n";
  for (int k = 0; k < 3; ++k)
    text += "0 " + exact_text(a.cell(k, k)) + "\n";
  return text;
}

inline std::string dump_grains(const packing::Assembly& a, long step, int digits = 17,
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
inline std::string dump_contacts(const packing::Assembly& a, long step, int digits = 17) {
  std::string text = "ITEM: TIMESTEP\n" + std::to_string(step) + "\nITEM: NUMBER OF ENTRIES\n" +
                     std::to_string(a.contacts.size()) + "\n" + dump_box(a, "pp pp pp") +
                     "ITEM: ENTRIES id1 id2 dx dy dz force ftx fty ftz\n";
  for (const packing::Contact& c : a.contacts) {
    const Vec3 d = -c.branch, t = -c.tangential_force;
    text += std::to_string(c.i + 1) + " " + std::to_string(c.j + 1) + " " +
            words({d.x, d.y, d.z, c.normal_force, t.x, t.y, t.z}, " ", digits) + "\n";
  }
  return text;
}

/// What is read back from a dump of one frame.
inline io::ImportedPacking through_dump(const packing::Assembly& a, int digits = 17,
                                        int contact_digits = 17) {
  io::LammpsDump dump(io::TextSource::of_text("grains", dump_grains(a, 7, digits)),
                      io::TextSource::of_text("contacts", dump_contacts(a, 7, contact_digits)));
  return dump.next().value();
}

inline std::string csv_grains(const packing::Assembly& a) {
  std::string text = "# units: SI\nid,x,y,z,radius\n";
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    const Vec3& x = a.position[g];
    text += std::to_string(g) + "," + words({x.x, x.y, x.z, a.radius[g]}, ",") + "\n";
  }
  return text;
}

inline std::string csv_contacts(const packing::Assembly& a) {
  std::string text = "# units: SI\nid1,id2,nx,ny,nz,fx,fy,fz,lx,ly,lz,delta\n";
  for (const packing::Contact& c : a.contacts) {
    const Vec3 n = normal(c), f = force(c);
    text += std::to_string(c.i) + "," + std::to_string(c.j) + "," +
            words({n.x, n.y, n.z, f.x, f.y, f.z, c.branch.x, c.branch.y, c.branch.z, c.overlap}, ",") + "\n";
  }
  return text;
}

inline io::ImportedPacking through_csv(const packing::Assembly& a) {
  return io::read_packing_csv(io::TextSource::of_text("grains", csv_grains(a)),
                              io::TextSource::of_text("contacts", csv_contacts(a)),
                              {.box = io::CsvBox{a.cell}});
}

/// One row of .fstat: force on the first grain, all from the second to the first; walls the other way.
inline std::string fstat_row(long i, long j, const Vec3& point, const packing::Contact& c, double turn) {
  const Vec3 n = turn * normal(c), t = turn * c.tangential_force;
  const double size = norm(t);
  const Vec3 along = size > 0 ? (1 / size) * t : Vec3{};
  return "0 " + std::to_string(i) + " " + std::to_string(j) + " " +
         words({point.x, point.y, point.z, c.overlap, 0, c.normal_force, size, n.x, n.y, n.z, along.x,
                along.y, along.z},
               " ") +
         "\n";
}

/// What is read back from MercuryDPM's files, contacts with walls among them.
inline io::ImportedPacking through_mercury(const packing::Assembly& a) {
  const std::string box = "0 0 0 " + words({a.cell(0, 0), a.cell(1, 1), a.cell(2, 2)}, " ") + "\n";
  std::string data = std::to_string(a.grain_count()) + " 0 " + box;
  for (std::size_t g = 0; g < a.grain_count(); ++g) {
    const Vec3& x = a.position[g];
    data += words({x.x, x.y, x.z, 0, 0, 0, a.radius[g], 0, 0, 0, 0, 0, 0, 0}, " ") + "\n";
  }
  std::string fstat = "# 0 1\n# " + box + "# " + words({a.radius[0], a.radius[0]}, " ") + " 0 0 0 0\n";
  for (const packing::Contact& c : a.contacts)
    fstat += fstat_row(c.i, c.j, a.position[c.i] + 0.5 * c.branch, c, -1) +
             fstat_row(c.j, c.i, a.position[c.i] + 0.5 * c.branch, c, 1);
  for (const packing::Contact& c : a.wall_contacts)
    fstat += fstat_row(c.i, -1 - static_cast<long>(c.j), a.position[c.i] + c.branch, c, 1);
  return io::MercuryOutput(io::TextSource::of_text("data", data), io::TextSource::of_text("fstat", fstat))
      .next()
      .value();
}

} // namespace granum::samples
