// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what check_paraview.py reads:  write_paraview_sample <folder>
#include <filesystem>

#include <granum/io/output_file.hpp>
#include <granum/io/vtk/paraview.hpp>

int main(int, char** arguments) {
  using namespace granum;
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const std::string& text) {
    io::write_file(folder / name, text, io::Existing::replace);
  };
  packing::Assembly assembly{.cell = Mat3::diagonal(4e-3, 4e-3, 4e-3),
                             .position = {{1e-3, 2e-3, 2e-3}, {1.9e-3, 2e-3, 2e-3}, {1e-3, 2e-3, 2.7e-3}},
                             .radius = {0.5e-3, 0.5e-3, 0.25e-3},
                             .contacts = {}};
  assembly.contacts = {{.i = 0, .j = 1, .branch = {0.9e-3, 0, 0}, .normal_force = 2},
                       {.i = 0,
                        .j = 2,
                        .branch = {0, 0, 0.7e-3},
                        .normal_force = 1.0 / 3,
                        .tangential_force = {0.1, -0.2, 0}}};
  assembly.wall_contacts = {{.i = 2, .j = 5, .branch = {0, 0, 0.2e-3}, .normal_force = 3}};
  write("grains.vtu", io::grains_vtu(assembly, {}, 0.25));
  write("contacts.vtp", io::contacts_vtp(assembly));
}
