# SPDX-License-Identifier: GPL-3.0-or-later
# Where a scene comes from, and which of its keys a command takes.
function(granum_scene_refuses what code message)
  granum_cli_test("scene: ${what}" EXIT ${code} STDERR "^granum: error: ${message}" ARGS ${ARGN})
endfunction()

# ---- what is no scene file
foreach(expectation "verify --scene" "plan --scene" "trade --scene" "reproduce --resume" "verify --out" "estimate --out")
  string(REGEX MATCH "--[a-z]+$" option "${expectation}")
  # an empty argument, as of a shell variable that is not set; CMake's own lists would drop it
  add_test(NAME "cli: scene: ${expectation} with nothing behind it"
    COMMAND sh -c "'$<TARGET_FILE:granum_cli>' ${expectation} '' 2>&1 | grep -q '^granum: error: ${option} is empty'")
  set_tests_properties("cli: scene: ${expectation} with nothing behind it" PROPERTIES LABELS cli)
endforeach()
granum_scene_refuses("a folder" 3 "\\.: [^\n]*folder" verify --scene .)
granum_scene_refuses("a device without end" 3 "/dev/zero: is a device" verify --scene /dev/zero)
granum_scene_refuses("no bytes of a device" 3 "/dev/null: is a device" plan --scene /dev/null)
string(REPEAT "x" 5000 long)
granum_scene_refuses("a name of 5,000 characters" 3 "xxx[^\n]*too long" verify --scene ${long})
granum_scene_refuses("a folder of 5,000 characters" 3 "[^\n]*xxx" verify --grains 40 --out ${long})

set(hostile "${CMAKE_CURRENT_BINARY_DIR}/hostile")
string(REPEAT "a." 50000 parts)
file(WRITE "${hostile}/dotted_key.toml" "${parts}a = 1\n")
file(WRITE "${hostile}/dotted_header.toml" "\n[${parts}a]\nb = 1\n")
string(REPEAT "\"a\" . " 50000 parts)
file(WRITE "${hostile}/quoted_key.toml" "${parts}a = 1\n")
string(REPEAT "[" 50000 open)
file(WRITE "${hostile}/brackets.toml" "a = ${open}\n")
string(REPEAT "{a=" 50000 open)
file(WRITE "${hostile}/tables.toml" "a = ${open}\n")
string(REPEAT "a" 50000 key)
file(WRITE "${hostile}/long_key.toml" "${key} = 1\n")
file(WRITE "${hostile}/nul.toml" "[study]\ncontacts = [\"sphere\\u0000xyz\"]\n")
string(REPEAT "# 34 characters of comment, in all\n" 40000 comments)
file(WRITE "${hostile}/long_file.toml" "${comments}")
foreach(expectation "dotted_key=:1: a key of more than 8 parts" "dotted_header=:2: a key of more than 8 parts"
    "quoted_key=:1: a key of more than 8 parts" "brackets=:1: brackets more than 8 deep"
    "nul=:2: study\\.contacts: 'sphere\\\\x00xyz' is unknown" "tables=:1: brackets more than 8 deep" "long_key=:1: a key or value of more than 1000 characters"
    "long_file=: is longer than 1000000 bytes")
  string(REGEX MATCH "^([a-z_]+)=(.*)$" matched "${expectation}")
  granum_scene_refuses("hostile, ${CMAKE_MATCH_1}" 3 "[^\n]*${CMAKE_MATCH_1}\\.toml${CMAKE_MATCH_2}"
    plan --scene "${hostile}/${CMAKE_MATCH_1}.toml")
endforeach()
add_test(NAME "cli: scene: comes through a pipe" WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/data"
  COMMAND sh -c "cat scene_small.toml | '$<TARGET_FILE:granum_cli>' plan --scene /dev/stdin --json | grep -q '\"radius_m\": 0.0003'")
set_tests_properties("cli: scene: comes through a pipe" PROPERTIES LABELS cli)

# ---- keys that a command would ignore
foreach(expectation "verify=specimen.boundary=walls" "plan=specimen.boundary=walls" "trade=specimen.boundary=walls"
    "export lammps=specimen.boundary=walls" "verify=shear.paths=TXC" "plan=shear.eta_step=0.1"
    "trade=shear.inertial_number=1e-4" "export lammps=shear.largest_strain=0.1" "verify=specimen.wall_friction=0.3"
    "trade=study.probe_pressures=10kPa")
  string(REGEX MATCH "^([a-z ]+)=(([a-z_.]+)=.*)$" matched "${expectation}")
  set(words "${CMAKE_MATCH_1}")
  set(setting "${CMAKE_MATCH_2}")
  set(key "${CMAKE_MATCH_3}")
  string(REPLACE " " ";" command "${words}")
  set(out "")
  if(command MATCHES export)
    set(out --out refused)
  endif()
  string(REPLACE "." "\\." key "${key}")
  granum_scene_refuses("${words} would ignore ${setting}" 2
    "--set: key '${key}' would be ignored by ${words}. it is for [^\n]*reproduce" ${command} --set ${setting} ${out})
endforeach()
granum_scene_refuses("a slope without cones" 2 "--set: key 'contact\\.cone_slope' has no effect without cone in study\\.contacts"
  plan --set study.contacts=sphere --set contact.cone_slope=0.5)
granum_scene_refuses("friction of walls without walls" 2
  "--set: key 'specimen\\.wall_friction' has no effect without specimen\\.boundary = walls"
  reproduce --set specimen.wall_friction=0.3)
granum_scene_refuses("agitation without loose specimens" 2
  "--set: key 'specimen\\.agitation' has no effect without loose in study\\.densities"
  plan --set study.densities=dense --set specimen.agitation=0.1)

# ---- the same in a file, with its line; a file for all commands may hold every key at its default
file(WRITE "${hostile}/walls.toml" "[grain]\nradius = \"0.4mm\"\n[specimen]\nboundary = \"walls\"\n")
foreach(command verify plan trade)
  granum_scene_refuses("${command} would ignore a file's walls" 3
    "[^\n]*walls\\.toml:4: key 'specimen\\.boundary' would be ignored by ${command}. it is for reproduce"
    ${command} --scene "${hostile}/walls.toml")
endforeach()
file(WRITE "${hostile}/idle_slope.toml" "[study]\ncontacts = [\"sphere\"]\n[contact]\ncone_slope = 0.5\n")
granum_scene_refuses("a file's slope without cones" 3
  "[^\n]*idle_slope\\.toml:4: key 'contact\\.cone_slope' has no effect without cone in study\\.contacts"
  plan --scene "${hostile}/idle_slope.toml")
file(WRITE "${hostile}/two_shapes.toml" "[study]\ncontacts = [\"sphere\", \"cone\"]\n[contact]\ncone_slope = 0.5\n")
granum_cli_test("scene: a file's slope, its cones left out by --set" EXIT 0 JSON "scene/contact/cone_slope=^0\\.5"
  ARGS plan --scene "${hostile}/two_shapes.toml" --set study.contacts=sphere --json)
granum_scene_refuses("every key at its default passes in trade, which wants one contact" 2
  "study\\.contacts: trade measures one contact shape"
  trade --scene "${PROJECT_SOURCE_DIR}/examples/scene.toml" --seeds 2)
granum_scene_refuses("every key at its default passes in export, which wants spheres" 2 "LAMMPS has no contact law"
  export lammps --scene "${PROJECT_SOURCE_DIR}/examples/scene.toml" --out refused)

# ---- values at which something would overflow, hang or end in an error of its own
granum_scene_refuses("radius of 1e102 m" 2 "grain\\.radius = 1e\\+102 m is outside \\[1e-09, 1000\\]: "
  verify --set grain.radius=1e102m)
granum_scene_refuses("radius of 1e-110 m" 2 "grain\\.radius = 1e-110 m is outside \\[1e-09, 1000\\]: "
  verify --set grain.radius=1e-110m)
granum_scene_refuses("pressures that would close the voids" 2
  "study\\.pressures: at 10 GPa [a-z]+ contacts of these grains would overlap by [0-9.]+ of a diameter, which is outside "
  reproduce --set study.pressures=10kPa,1MPa,10GPa --set study.probe_pressures=)
granum_scene_refuses("a tangential ratio below 0" 2 "contact\\.tangential_ratio = -1 is outside \\[0, 100\\]: "
  plan --set contact.tangential_ratio=-1)
granum_cli_test("scene: the tangential ratio of Mindlin by its name" EXIT 0 JSON "scene/contact/tangential_ratio=^0\\.9189"
  ARGS plan --set contact.tangential_ratio=mindlin --json)
