# SPDX-License-Identifier: GPL-3.0-or-later
# what cannot be run: told apart before anything runs
granum_cli_test("reproduce: unknown path" EXIT 2
  STDERR "^granum: error: shear\\.paths: 'TXX' is unknown; did you mean TXC or TXE"
  ARGS reproduce --set shear.paths=TXX)
granum_cli_test("reproduce: a path twice" EXIT 2 STDERR "^granum: error: shear\\.paths: TXC is given twice"
  ARGS reproduce --set shear.paths=TXC,TXC)
granum_cli_test("reproduce: inertial number 0" EXIT 2
  STDERR "^granum: error: shear\\.inertial_number = 0 is outside \\[1e-09, 0\\.1\\)" ARGS reproduce --set shear.inertial_number=0)
granum_cli_test("reproduce: unknown boundary" EXIT 2
  STDERR "^granum: error: specimen\\.boundary: 'wall' is unknown; did you mean walls"
  ARGS reproduce --set specimen.boundary=wall)
granum_cli_test("reproduce: --paper and --scene" EXIT 2 STDERR "^granum: error: --paper is itself a scene"
  ARGS reproduce --paper --scene scene_small.toml)
granum_cli_test("reproduce: --resume and another scene" EXIT 2
  STDERR "^granum: error: --resume takes its scene and folder from the earlier run" ARGS reproduce --resume x --grains 100)
granum_cli_test("reproduce: --resume of nothing" EXIT 3 STDERR "^granum: error: none/scene\\.toml: "
  ARGS reproduce --resume none)
granum_cli_test("reproduce: folder that is a file" EXIT 3 STDERR "^granum: error: isotropic\\.csv: cannot be "
  ARGS reproduce --out isotropic.csv)
granum_cli_test("reproduce: help lists the keys" EXIT 0
  STDOUT "--paper.*--resume.*Keys of scenes and of --set:.*shear\\.paths .*shear\\.probe_eta_step " ARGS reproduce --help)
granum_cli_test("reproduce: the note on sizes is in the manifest" EXIT 0 STDERR "^granum: note: grain\\.sizes span 1:6: [^\n]*\n$"
  JSON "notes/0=^grain\\.sizes span 1:6: "
  ARGS reproduce --grains 60 --set grain.sizes=uniform:1:6 --set study.contacts=sphere --set study.densities=dense
    --set study.pressures=25kPa,50kPa,100kPa --set study.probe_pressures= --set shear.paths=TXC
    --set shear.inertial_number=1e-3 --set shear.largest_strain=0.001 --set shear.strain_step=0.0005 --set shear.probe_eta_step=0
    --set shear.loop_strain=0 --json --force --out "${CMAKE_CURRENT_BINARY_DIR}/reproduce note")
