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
granum_cli_test("reproduce: --paper and --scene" EXIT 2 STDERR "^granum: error: --paper is a scene of its own"
  ARGS reproduce --paper --scene scene_small.toml)
granum_cli_test("reproduce: --resume and another scene" EXIT 2
  STDERR "^granum: error: --resume takes its scene and folder from the earlier run" ARGS reproduce --resume x --grains 100)
granum_cli_test("reproduce: --resume of nothing" EXIT 3 STDERR "^granum: error: none/scene\\.toml: "
  ARGS reproduce --resume none)
granum_cli_test("reproduce: folder that is a file" EXIT 3 STDERR "^granum: error: isotropic\\.csv: cannot be "
  ARGS reproduce --out isotropic.csv)
granum_cli_test("reproduce: help lists the keys" EXIT 0
  STDOUT "--paper.*--resume.*Keys of scenes and of --set:.*shear\\.paths .*shear\\.probe_eta_step " ARGS reproduce --help)

# runs that write, in folders of their own
add_library(granum_kill_at_rename MODULE kill_at_rename.cpp)
granum_compile_settings(granum_kill_at_rename)
target_link_libraries(granum_kill_at_rename PRIVATE ${CMAKE_DL_LIBS})
foreach(what resume disk)
  add_test(NAME "cli: reproduce: ${what}"
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:granum_cli>"
      "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/reproduce ${what}" "-DKILLER=$<TARGET_FILE:granum_kill_at_rename>" -P "${CMAKE_CURRENT_SOURCE_DIR}/check_reproduce_${what}.cmake")
  set_tests_properties("cli: reproduce: ${what}" PROPERTIES LABELS cli)
endforeach()
