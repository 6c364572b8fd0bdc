# SPDX-License-Identifier: GPL-3.0-or-later
# Down into the ground: granum sweep --depth.
set(ground sweep --grain-shape sphere --void-ratio 0.6 --depth 0m..30m --unit-weight 19kN/m3 --water-table 2m --k0 0.5)

# 4 m: 2 m of 19 kN/m3 and 2 m of (2650 + 0.6 998)/1.6 9.80665 N/m3 = 19.9124 kN/m3; water of 9.787 kN/m3
granum_cli_test("depth: states" EXIT 0 JSON "states/2/depth=^4(\\.0)?$" "states/2/total_stress_v=^77824\\.805"
  "states/2/pore_pressure=^19574\\.07" "states/2/stress_v=^58250\\.73" "states/2/stress_h=^29125\\.36" "states/2/mean_stress=^38833\\.82"
  "states/2/answer/saturation=^1(\\.0)?$" "states/1/stress_v=^38000(\\.0)?$" "states/1/pore_pressure=^0(\\.0)?$"
  "states/1/answer/saturation=^0\\.7513982756" "states/0/answer/shear_modulus/high=^0(\\.0)?$" "states/2/error=^$"
  ARGS ${ground} --points 16 --json)
granum_cli_test("depth: ground in JSON" EXIT 0 JSON "ground/saturated_unit_weight=^19912\\.40" ARGS ${ground} --json)
granum_cli_test("depth: table" EXIT 0
  STDOUT "\ndepth +s_v +u +s'_v +s'_h +p' +G \\(low-high\\) +V_s +V_p\n +m( +kPa)+ +MPa +m/s +m/s\n.*\n    4 77\\.82 19\\.57 58\\.25 29\\.13 38\\.83 +85\\.5 \\(37-135\\) +205 \\(135-258\\) +1639 \\(1588-1677\\)\n"
  ARGS ${ground} --points 16)
granum_cli_test("depth: assumptions" EXIT 0 STDOUT "- 75\\.1 % .*--saturation.*19\\.91 kN/m3: grains of 2650 kg/m3.*--saturated-unit-weight.*assumed --k0 0\\.5"
  ARGS sweep --grain-shape sphere --void-ratio 0.6 --depth 0m..30m --unit-weight 19kN/m3 --water-table 2m)
# A note for what each of these does: no stress at the surface, unequal stresses.
granum_cli_test("depth: notes" EXIT 0 JSON "notes=G and V_s are 0" "notes=--fabric " ARGS ${ground} --json)
granum_cli_test("depth: fewer notes" EXIT 0 JSON "notes/0=--unit-weight" "notes/1=assumed --contact" "notes/8=contacts grow" "notes/9=MISSING"
  ARGS sweep --grain-shape sphere --void-ratio 0.6 --depth 1m..30m --k0 1 --json)
granum_cli_test("depth: isotropic ground, dry, its weight of void ratio" EXIT 0 JSON "ground/unit_weight=^16242\\.26"
  ARGS sweep --grain-shape sphere --void-ratio 0.6 --depth 1m..30m --k0 1 --json)
granum_cli_test("depth: surcharge" EXIT 0 JSON "states/0/stress_v=^50000(\\.0)?$" ARGS ${ground} --surcharge 50kPa --json)
granum_cli_test("depth: water above the ground" EXIT 0 JSON "states/0/pore_pressure=^97870\\." ARGS sweep --grain-shape sphere --void-ratio 0.6
  --depth 0m..30m --water-table -10m --json)
granum_cli_test("depth: given contacts are the same everywhere" EXIT 0 JSON "states/3/answer/mechanical_coordination_number/value=^5\\.2"
  ARGS ${ground} --mechanical-coordination-number 5.2 --json)
granum_cli_test("depth: a low K_0 is remarked" EXIT 0 STDOUT "depth" STDERR "warning: [0-9]+ of 25 states lie outside [^\n]*stress ratio 3\\.33"
  ARGS sweep --grain-shape sphere --void-ratio 0.6 --depth 0m..30m --k0 0.3)
granum_cli_test("depth: under --strict" EXIT 4 STDOUT "depth" STDERR "stress ratio 3\\.33" ARGS sweep --grain-shape sphere --void-ratio 0.6 --depth 0m..30m
  --k0 0.3 --strict)

# A strain adds a table on the screen; without stress there is no number.
granum_cli_test("depth: a strain" EXIT 0 STDERR "." STDOUT "G/G0 +damping [^\n]*\n +0 +- +- +-\n +10 +[0-9.]+ \\([0-9.]+-[0-9.]+\\) +0\\.[0-9]+ \\(0\\.[0-9]+-0\\.[0-9]+\\) "
  ARGS sweep --void-ratio 0.7 --depth 0m..10m --points 2 --strain 0.1%)

# Beads that may have no stiffness have no travel time.
granum_cli_test("depth: V_s that may be 0" EXIT 0 STDERR "." JSON "site=^$" "notes=no travel time of a shear wave: V_s may be 0 at"
  ARGS sweep --void-ratio 0.9 --depth 1m..14m --points 4 --rolling 0.4 --rattler-fraction 5% --json)

# Weights that void ratio and grains contradict.
granum_cli_test("depth: too heavy" EXIT 0 STDOUT "depth" STDERR "warning: --unit-weight 22 kN/m3 contradicts void ratio 0\\.6 [^\n]* 19\\.91 kN/m3 with all pores full"
  ARGS sweep --grain-shape sphere --void-ratio 0.6 --depth 0m..30m --unit-weight 22kN/m3)
granum_cli_test("depth: too light" EXIT 0 STDOUT "depth" STDERR "--unit-weight 14 kN/m3 contradicts [^\n]* 16\\.24 kN/m3 with all pores empty"
  ARGS sweep --grain-shape sphere --void-ratio 0.6 --depth 0m..30m --unit-weight 14kN/m3)
granum_cli_test("depth: saturated weight" EXIT 0 STDOUT "below 2 m 21 kN/m3" STDERR "--saturated-unit-weight 21 kN/m3 contradicts"
  ARGS ${ground} --saturated-unit-weight 21kN/m3)
granum_cli_test("depth: saturation and weight" EXIT 0 STDOUT "depth" STDERR "--unit-weight 19 kN/m3 contradicts [^\n]* with this saturation"
  ARGS ${ground} --saturation 0)

function(granum_depth_refuses what message)
  granum_cli_test("depth: ${what}" EXIT 2 STDERR "^granum: error: ${message}" ARGS sweep ${ARGN})
endfunction()
granum_depth_refuses("one depth" "--depth = '30m' must be two depths, such as 0m\\.\\.30m" --void-ratio 0.6 --depth 30m)
granum_depth_refuses("three points, or 0.30 m" "--depth = '0m\\.\\.\\.30m'" --void-ratio 0.6 --depth 0m...30m)
granum_depth_refuses("upwards" "--depth = '3m\\.\\.1m' must be the smaller depth" --void-ratio 0.6 --depth 3m..1m)
granum_depth_refuses("above the ground" "--depth = -1 m is outside" --void-ratio 0.6 --depth -1m..3m)
granum_depth_refuses("a weight without depth" "--unit-weight goes with --depth" --void-ratio 0.6 --from 1kPa --to 2kPa
  --unit-weight 19kN/m3)
granum_depth_refuses("a stress as well" "--pressure goes with --table; with --depth" --void-ratio 0.6 --depth 0m..3m --pressure 1kPa)
granum_depth_refuses("saturated weight without water" "--saturated-unit-weight goes with --water-table" --void-ratio 0.6
  --depth 0m..3m --saturated-unit-weight 20kN/m3)
granum_depth_refuses("a path as well" "--depth excludes --from|--from excludes --depth" --void-ratio 0.6 --depth 0m..3m --from 1kPa)
granum_depth_refuses("K_0 of 0" "--k0 = 0 is outside" --void-ratio 0.6 --depth 0m..3m --k0 0)
