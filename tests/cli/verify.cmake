# SPDX-License-Identifier: GPL-3.0-or-later
set(few_states --set study.contacts=sphere --set study.pressures=10kPa,20kPa,40kPa --set study.probe_pressures=)
set(small --grains 120 ${few_states})

# what cannot be run: told apart before anything runs, by both commands
foreach(command verify plan)
  function(granum_study_refuses what code message)
    granum_cli_test("${command}: ${what}" EXIT ${code} STDERR "^granum: error: ${message}" ARGS ${command} ${ARGN})
  endfunction()
  granum_study_refuses("unknown key in a scene" 3
    "scene_unknown_key\\.toml:3: key 'grain\\.radios' is unknown; did you mean grain\\.radius"
    --scene scene_unknown_key.toml)
  granum_study_refuses("pressure without unit in a scene" 3
    "scene_unitless_pressure\\.toml:3: study\\.pressures = 10 has no unit; write 10Pa, 10kPa"
    --scene scene_unitless_pressure.toml)
  granum_study_refuses("scene that is no TOML" 3 "scene_broken\\.toml:4: [^\n]*expected '\\]'"
    --scene scene_broken.toml)
  granum_study_refuses("missing scene" 3 "none\\.toml: [^\n]*No such file" --scene none.toml)
  granum_study_refuses("0 grains" 2 "study\\.grains = 0 is outside \\[40, 1e\\+07\\]" --grains 0)
  granum_study_refuses("1 grain" 2 "study\\.grains = 1 is outside \\[40, 1e\\+07\\]" --grains 1)
  granum_study_refuses("negative grains" 2 "--grains = -1 is outside \\[0, 1e\\+15\\]" --grains -1)
  granum_study_refuses("0 seeds" 2 "study\\.seeds = 0 is outside \\[1, 1000\\]" --seeds 0)
  granum_study_refuses("--set without a value" 2 "--set nonsense: expected key=value" --set nonsense)
  granum_study_refuses("--set of an unknown key" 2 "key 'grain\\.radios' is unknown" --set grain.radios=1mm)
  granum_study_refuses("--set of half a grain" 2 "study\\.grains = 80\\.5 is not a whole number"
    --set study.grains=80.5)
  granum_study_refuses("--set of an unknown contact" 2
    "study\\.contacts: 'cube' is unknown; known are cone, sphere, flat, power-law" --set study.contacts=cube)
  granum_study_refuses("a contact twice" 2 "study\\.contacts: sphere is given twice" --set study.contacts=sphere,sphere)
  granum_study_refuses("nu = 0.6" 2 "grain\\.poisson_ratio = 0\\.6 is outside \\(-1, 0\\.5\\]"
    --set grain.poisson_ratio=0.6)
  granum_study_refuses("falling pressures" 2 "study\\.pressures must rise: 10000" --set study.pressures=20kPa,10kPa,30kPa)
  granum_study_refuses("a probe at no pressure" 2 "study\\.probe_pressures = 15000 Pa is outside study\\.pressures"
    --set study.probe_pressures=15kPa)
  granum_cli_test("${command}: help lists the keys" EXIT 0
    STDOUT "Keys of scenes and of --set:.*grain\\.radius .*study\\.probe_pressures .*specimen\\.agitation "
    ARGS ${command} --help)
endforeach()
granum_cli_test("verify: folder within a file" EXIT 3
  STDERR "^granum: error: isotropic\\.csv/x: cannot be made: Not a directory" ARGS verify ${small} --out isotropic.csv/x)
granum_cli_test("verify: folder that is a file" EXIT 3 STDERR "^granum: error: isotropic\\.csv: cannot be "
  ARGS verify ${small} --out isotropic.csv)

granum_cli_test("plan: table" EXIT 0
  STDOUT "packings +1 +of 120 grains.*specimens with friction +2 .* 3 pressures.*networks +6 .*shear probes +0\n.*memory +[0-9]+ MB\n.*dense\n.*error of G +[0-9.]+ %\n.*error of s +0\\.[0-9]+\n +grains +[0-9]+ +for 2 % of G"
  ARGS plan ${small} --error 2%)
# Unequal grains: as many as their sizes allow, and what sizes beyond 1:5 cost, in a note.
set(wide "^granum: note: grain\\.sizes span 1:7\\.4: [^\n]* needs 294 grains or more[^\n]*\n$")
granum_cli_test("plan: unequal grains" EXIT 0 STDERR "${wide}"
  STDOUT "packings +1 +of 300 grains.*dense\n.*\n +grains +294 +for 50 % of G"
  ARGS plan ${few_states} --grains 300 --set grain.sizes=lognormal:0.35 --error 50%)
granum_cli_test("plan: too few grains for their sizes" EXIT 2
  STDERR "^granum: error: --grains = 120 is outside \\[294, 1e7\\]: the cell must be wider than four of the largest grains"
  ARGS plan ${small} --set grain.sizes=lognormal:0.35)
granum_cli_test("plan: sizes of 1:5 have no note" EXIT 0 STDOUT "packings +1 +of 230 grains"
  ARGS plan ${few_states} --grains 230 --set grain.sizes=power-law:3:5)
granum_cli_test("plan: sizes of 1:6 have one" EXIT 0 STDERR "^granum: note: grain\\.sizes span 1:6: "
  STDOUT "packings +1 +of 330 grains" ARGS plan ${few_states} --grains 330 --set grain.sizes=power-law:3:6)
granum_cli_test("verify: the note on sizes is in the JSON" EXIT 0 STDERR "${wide}" JSON "notes/0=^grain\\.sizes span 1:7\\.4: "
  ARGS verify ${few_states} --grains 294 --set study.densities=dense --set grain.sizes=lognormal:0.35 --json)
granum_cli_test("plan: no error at all cannot be wanted" EXIT 2 STDERR "error = 0 is outside \\(0, inf\\)"
  ARGS plan ${small} --error 0)
granum_cli_test("plan: JSON" EXIT 0 JSON
    "command=^plan$" "packings=^1$" "specimens=^2$" "network_solutions=^6$" "probes=^0$" "predicted_time_s=^[0-9]"
    "scene/study/grains=^120$" "scene/grain/radius_m=^0\\.00040*" "scene/study/probe_pressures_Pa=^\\[\\]$"
  ARGS plan --scene scene_small.toml --grains 120 --set grain.radius=0.4mm --json)
granum_cli_test("plan: --set overrides the scene, --grains overrides --set" EXIT 0 JSON "scene/study/grains=^90$"
  ARGS plan --scene scene_small.toml --set study.grains=70 --grains 90 --json)
granum_cli_test("plan: existing output is kept" EXIT 3 STDERR "isotropic\\.csv: exists already and is kept"
  ARGS plan ${small} --out isotropic.csv)

# 120 grains are too few for the claims on s: a finding that differs, and no failure
granum_cli_test("verify: JSON" EXIT 0 JSON
    "complete=^(ON|true)$" "exponents/0/network/value=^0\\.[345]" "exponents/1/contact=^sphere$"
    "exponents/1/probe=^$" "specimens/1/states/2/pressure_Pa=^40000" "specimens/0/failure=^$"
  ARGS verify ${small} --json)

granum_cli_test("verify: --strict fails if a result differs, and reports it" EXIT 1
  STDOUT "\"finding\": true" STDERR "^granum: error: differs from the paper: [^\n]*sphere: s is " ARGS verify ${small} --json --strict)
granum_cli_test("verify: --report and another scene" EXIT 2 STDERR "^granum: error: --report uses the earlier run"
  ARGS verify --report x --grains 100)
granum_cli_test("verify: --report of nothing" EXIT 3 STDERR "^granum: error: none/" ARGS verify --report none)
set(reproduced "${CMAKE_CURRENT_BINARY_DIR}/reproduced")
file(WRITE "${reproduced}/manifest.json" "{\"command\": \"reproduce\"}")
granum_cli_test("verify: --report of another command's run" EXIT 3 STDERR "/reproduced: [^\n{}]*reproduce[^\n{}]*verify\n$"
  ARGS verify --report "${reproduced}")
