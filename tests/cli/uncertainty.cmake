# SPDX-License-Identifier: GPL-3.0-or-later
# granum_uncertainty_test(<input> <value> <deviation> <less> <more> [POWER <field>=<exponent>] [WITHOUT <field>] ARGS <other arguments>...)
# is check_uncertainty.cmake for one kind of input.
function(granum_uncertainty_test input value deviation less more)
  cmake_parse_arguments(PARSE_ARGV 5 run "" "POWER;WITHOUT" "ARGS")
  list(JOIN run_ARGS " " others)
  set(name "cli: estimate --uncertainty: ${input} ${value} +- ${deviation}, ${others}")
  string(MD5 file "${name}")
  add_test(NAME "${name}"
    COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:granum_cli>" "-DINPUT=${input}" "-DVALUE=${value}"
      "-DDEVIATION=${deviation}" "-DLESS=${less}" "-DMORE=${more}" "-DPOWER=${run_POWER}" "-DWITHOUT=${run_WITHOUT}"
      "-DFILE=${CMAKE_CURRENT_BINARY_DIR}/uncertainty ${file}"
      -P "${CMAKE_CURRENT_SOURCE_DIR}/check_uncertainty.cmake" -- ${run_ARGS})
  set_tests_properties("${name}" PROPERTIES LABELS cli)
endfunction()

# Counted contacts: K and G are powers of what follows. Spheres ~ G_g^(2/3) p^(1/3) whatever their size; cones
# ~ (G_g/A)^(1/2); alpha = 1.5 ~ G_g^0.6 A^-0.4; punches ~ G_g a/R. At 0.1 Pa, for overlaps shorten branches, which at
# 100 kPa changes a power by up to 2e-3 (tests/effective/test_relaxed_exponents.cpp has by how much).
set(counted --coordination-number 5.9 --rattler-fraction 2%)
set(light --pressure 0.1Pa)
set(spheres ${counted} --void-ratio 0.56)
granum_uncertainty_test(grain-shear-modulus 30GPa 10% 27GPa 33GPa POWER shear_modulus=0.66666666666666667
  ARGS ${spheres} ${light})
granum_uncertainty_test(pressure 0.1Pa 0.02Pa 0.08Pa 0.12Pa POWER bulk_modulus=0.33333333333333333 ARGS ${spheres})
granum_uncertainty_test(radius 0.5mm 10% 0.45mm 0.55mm POWER shear_modulus=0 ARGS ${spheres} ${light})
granum_uncertainty_test(slope 0.4 0.1 0.3 0.5 POWER shear_modulus=-0.5 ARGS ${spheres} ${light} --contact cone)
granum_uncertainty_test(profile-constant 180 10% 162 198 POWER shear_modulus=-0.4
  ARGS ${spheres} ${light} --contact power-law --alpha 1.5)
granum_uncertainty_test(punch-radius 5um 1um 4um 6um POWER shear_modulus=1 ARGS ${spheres} ${light} --contact flat)
granum_uncertainty_test(radius 0.5mm 0.05mm 0.45mm 0.55mm POWER shear_modulus=-1 ARGS ${spheres} ${light} --contact flat)
granum_uncertainty_test(pressure 0.1Pa 5% 0.095Pa 0.105Pa POWER shear_modulus=0 ARGS ${spheres} --contact flat)
granum_uncertainty_test(solid-fraction 0.64 0.01 0.63 0.65 POWER bulk_density=1 ARGS ${counted} ${light})
granum_uncertainty_test(grain-density 2650kg/m3 100kg/m3 2550kg/m3 2750kg/m3 POWER compression_wave_speed=-0.5
  ARGS ${spheres} ${light})
granum_uncertainty_test(grain-poisson-ratio 0.2 0.05 0.15 0.25 ARGS ${spheres} --pressure 100kPa)
granum_uncertainty_test(tangential-ratio 0.9 0.1 0.8 1 ARGS ${spheres} --pressure 100kPa)
granum_uncertainty_test(rolling 0.3 0.1 0.2 0.4 ARGS ${spheres} --pressure 100kPa)
granum_uncertainty_test(porosity 36% 2% 35.28% 36.72% ARGS ${counted} --pressure 100kPa)
granum_uncertainty_test(fabric 0.1 0.05 0.05 0.15 ARGS ${spheres} --pressure 100kPa)
granum_uncertainty_test(stress-v 200kPa 10kPa 190kPa 210kPa ARGS ${spheres} --stress-h 100kPa)
granum_uncertainty_test(stress-h 100kPa 10kPa 90kPa 110kPa ARGS ${spheres} --stress-v 200kPa)
# sigma_h follows from sigma_v and K_0, whichever of them moves
granum_uncertainty_test(stress-v 200kPa 10kPa 190kPa 210kPa ARGS ${spheres} --k0 0.5)
granum_uncertainty_test(k0 0.5 0.1 0.4 0.6 ARGS ${spheres} --stress-v 200kPa)
# one number of the contacts at the other that is told with it, and alone
set(state --void-ratio 0.56 --pressure 100kPa)
granum_uncertainty_test(rattler-fraction 2% 0.01 1% 3% ARGS ${state} --coordination-number 5.9)
granum_uncertainty_test(coordination-number 5.9 0.1 5.8 6 ARGS ${state} --rattler-fraction 2%)
granum_uncertainty_test(coordination-number 5.9 0.1 5.8 6 ARGS ${state} --mechanical-coordination-number 6.2)
granum_uncertainty_test(mechanical-coordination-number 6 0.1 5.9 6.1 ARGS ${state} --rattler-fraction 2%)
granum_uncertainty_test(mechanical-coordination-number 5.5 0.1 5.4 5.6 ARGS ${state})
# contacts that follow from the void ratio move with it; how they grow with stress stays
granum_uncertainty_test(void-ratio 0.6 5% 0.57 0.63 WITHOUT stress_exponent ARGS --pressure 100kPa)
granum_uncertainty_test(d50 0.5mm 0.1mm 0.4mm 0.6mm POWER shear_modulus=0 ARGS ${spheres} ${light} --uniformity 1.5 --grain-shape sphere)

granum_uncertainty_test(relative-density 60% 0.1 50% 70% WITHOUT stress_exponent
  ARGS --grain glass --least-void-ratio 0.55 --largest-void-ratio 0.75 --pressure 100kPa)

# A share of rattlers below 0 is impossible: 2 % less 3.25 % becomes 0, where z* is C_n.
granum_cli_test("estimate --uncertainty: impossible values are moved less far" EXIT 0
  JSON "answer/mechanical_coordination_number/low=^5\\.(9$|90000|89999)"
  "answer/mechanical_coordination_number/high=^6\\.2269"
  ARGS estimate ${state} --coordination-number 5.9 --rattler-fraction 2% --uncertainty rattler-fraction=0.0325 --json)
# Beyond all that is possible a deviation reaches the limits, -1 and 0.5 of nu_g, however large it is.
foreach(deviation 10 1e12)
  granum_cli_test("estimate --uncertainty: nu_g by ${deviation}" EXIT 0
    JSON "answer/shear_modulus/low=^52353[34]" "answer/shear_modulus/high=^18903[01][0-9]" "answer/shares/grain-poisson-ratio=^0\\.1974"
    ARGS estimate --void-ratio 0.6 --pressure 100kPa --grain-shape sphere --grain-shear-modulus 30GPa --fabric 0
      --uncertainty grain-poisson-ratio=${deviation} --json)
endforeach()
# A deviation of 0 makes exact what would be assumed.
granum_cli_test("estimate --uncertainty: exact inputs" EXIT 0 JSON "answer/assumed_deviations=^{ *\n? *}$"
  "answer/stated_deviations=^{ *\n? *}$" "answer/shares/rung 3=^1(\\.0)?$"
  ARGS estimate ${spheres} --pressure 100kPa --uncertainty grain-shear-modulus=0% --uncertainty grain-poisson-ratio=0
    --uncertainty fabric=0 --uncertainty grain-density=0% --json)
# z* within a deviation of the isostatic point: ranges begin at 0.
granum_cli_test("estimate --uncertainty: below the isostatic point" EXIT 0 JSON "answer/shear_modulus/low=^0(\\.0)?$"
  "answer/shear_modulus/high=^[1-9]" "answer/shares/mechanical-coordination-number=^0\\.[1-9]"
  ARGS estimate ${state} --coordination-number 4 --mechanical-coordination-number 4.2
    --uncertainty mechanical-coordination-number=0.4 --json)

function(granum_uncertainty_refuses what message)
  granum_cli_test("estimate --uncertainty: ${what}" EXIT 2 STDERR "^granum: error: --uncertainty ${message}"
    ARGS estimate --void-ratio 0.6 --pressure 100kPa ${ARGN})
endfunction()
granum_uncertainty_refuses("unknown key" "mood: [^\n]* grain-shear-modulus, [^\n]*, pressure, grain-density, saturation\n" --uncertainty mood=1)
granum_uncertainty_refuses("input of another packing" "porosity: [^\n]*void-ratio" --uncertainty porosity=0.01)
granum_uncertainty_refuses("contacts that are not given" "coordination-number: [^\n]*void-ratio" --uncertainty coordination-number=0.1)
granum_uncertainty_refuses("k_t that follows Poisson's ratio" "tangential-ratio: [^\n]*void-ratio"
  --uncertainty tangential-ratio=0.1)
granum_uncertainty_refuses("negative deviation" "void-ratio = -0\\.1 is outside \\[0, inf\\)"
  --uncertainty void-ratio=-0.1)
granum_uncertainty_refuses("negative share" "void-ratio = -0\\.1 is outside" --uncertainty void-ratio=-10%)
granum_uncertainty_refuses("no unit" "pressure = 5 has no unit; write 5Pa" --uncertainty pressure=5)
granum_uncertainty_refuses("wrong unit" "pressure = '5mm' must be a pressure, not a length" --uncertainty pressure=5mm)
granum_uncertainty_refuses("per cent of zero" "fabric=5%: [^\n]*--fabric = 0 " --uncertainty fabric=5%)
granum_uncertainty_refuses("no value" "void-ratio: write key=sd" --uncertainty void-ratio)
granum_uncertainty_refuses("twice" "void-ratio is given twice" --uncertainty void-ratio=0.1
  --uncertainty void-ratio=0.2)

# Without contacts there is nothing to be uncertain about, and nothing grows with stress.
granum_cli_test("estimate: no contacts" EXIT 0 STDERR "warning: a packing without contacts carries no stress"
  JSON "uniform_strain/K=^0\\.0$" "uniform_stress/E_v=^0\\.0$" "uniform_strain/s=^$" "uniform_stress/m=^$"
  "answer/stress_exponent=^$" "answer/shear_modulus/high=^0(\\.0)?$" "answer/shares=^{ *\n? *}$"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --coordination-number 0 --json)
granum_cli_test("estimate: only rattlers" EXIT 0 JSON "relaxed/K=^0\\.0$" STDERR "z\\* = 0 is not above"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --coordination-number 0 --rattler-fraction 20% --json)
granum_cli_test("sweep: no contacts" EXIT 0 JSON "states/0/rung0/G_hv=^0\\.0$"
  STDERR "warning: 2 of 2 states lie outside a formula's validity[^\n]*without contacts carries no stress"
  ARGS sweep --void-ratio 0.6 --coordination-number 0 --from 10kPa --to 100kPa --points 2 --json)
