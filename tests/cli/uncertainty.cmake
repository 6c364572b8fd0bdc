# SPDX-License-Identifier: GPL-3.0-or-later
# The ranges of each input are in test_uncertainty.py.
set(spheres --coordination-number 5.9 --rattler-fraction 2% --void-ratio 0.56)
set(state --void-ratio 0.56 --pressure 100kPa)

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
