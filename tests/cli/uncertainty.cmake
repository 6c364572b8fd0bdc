# SPDX-License-Identifier: GPL-3.0-or-later

# Of two uncertain inputs one is G_g with 1 %; what the other makes of the variance follows from the powers in
# K ~ C_n k_n/(R (1+e)), G ~ K (2+3r): exponents x and y give the share x^2/(x^2+y^2).
# What the answer remarks stands in `warning`.
function(granum_uncertainty_share what modulus json_key share)
  granum_cli_test("estimate --uncertainty: ${what}" EXIT 0 ${warning}
    JSON "uncertainty/uniform_strain/${modulus}/share_of_variance/${json_key}=^${share}"
    ARGS estimate --json --uncertainty grain-shear-modulus=1% ${ARGN})
endfunction()

# k_n = 2 G a/(1-nu): every exponent 1, that of the void ratio e/(1+e), of the porosity n/(1-n).
set(half "(0\\.5|0\\.4999999999|0\\.5000000000)")
set(warning STDERR "no sphere packing is so loose")
set(flat --contact flat --punch-radius 5um --pressure 100kPa --tangential-ratio 1)
granum_uncertainty_share("punch radius" K punch_radius "${half}" ${flat} --void-ratio 1 --uncertainty punch-radius=1%)
granum_uncertainty_share("radius of grains with punches" K radius "${half}" ${flat} --void-ratio 1
  --uncertainty radius=1%)
granum_uncertainty_share("contacts" K coordination_number "${half}" ${flat} --void-ratio 1
  --uncertainty coordination-number=1%)
granum_uncertainty_share("void ratio" K void_ratio "0\\.(2|19999999999|2000000000)" ${flat} --void-ratio 1
  --uncertainty void-ratio=1%)
granum_uncertainty_share("porosity" K porosity "${half}" ${flat} --porosity 50% --uncertainty porosity=1%)
granum_uncertainty_share("solid fraction" K solid_fraction "${half}" ${flat} --solid-fraction 0.4
  --uncertainty solid-fraction=0.004)
granum_uncertainty_share("pressure on punches" K pressure "0\\.0$" ${flat} --void-ratio 1 --uncertainty pressure=10kPa)

# nu = 0, absolute 0.01: 1/(1-nu) alone, and 1 - 3 (1/2)/(2+3) = 0.7 where r = 2(1-nu)/(2-nu) follows it; r = 1: 3/5.
set(poisson --contact flat --void-ratio 1 --pressure 100kPa --grain-poisson-ratio 0)
granum_uncertainty_share("Poisson's ratio at given k_t" G_vh grain_poisson_ratio "${half}" ${poisson}
  --tangential-ratio 1
  --uncertainty grain-poisson-ratio=0.01)
granum_uncertainty_share("Poisson's ratio with its k_t" G_vh grain_poisson_ratio "0\\.32885906040" ${poisson}
  --uncertainty grain-poisson-ratio=0.01)
granum_uncertainty_share("tangential ratio" G_vh tangential_ratio "0\\.26470588235" ${poisson} --tangential-ratio 1
  --uncertainty tangential-ratio=0.01)
# C33 ~ (35+7a)/(3-a): 7/35 + 1/3 at a = 0.
granum_uncertainty_share("fabric" C33 fabric "0\\.2214532871" ${poisson} --tangential-ratio 1 --uncertainty fabric=0.01)

unset(warning)
# Cones K ~ (G_g/A)^(1/2); alpha = 1.5 K ~ G_g^0.6 A^-0.4; spheres K ~ G_g^(2/3) p^(1/3), whatever their size.
set(state --void-ratio 0.6 --pressure 100kPa)
granum_uncertainty_share("slope" K slope "${half}" ${state} --contact cone --uncertainty slope=1%)
granum_uncertainty_share("profile" K profile_constant "0\\.3076923076" ${state} --contact power-law --alpha 1.5
  --profile-constant 180 --uncertainty profile-constant=1%)
granum_uncertainty_share("pressure" K pressure "0\\.(2|19999999999|2000000000)" ${state} --uncertainty pressure=1%)
granum_uncertainty_share("radius of spheres" K radius "(0\\.0$|[0-9.]+e-[23][0-9])" ${state} --uncertainty radius=1%)
# p = (sigma_v + 2 sigma_h)/3
granum_cli_test("estimate --uncertainty: two stresses" EXIT 0
  JSON "uncertainty/uniform_strain/K/share_of_variance/stress_v=^0\\.(2|19999999999|2000000000)"
  ARGS estimate --void-ratio 0.6 --stress-v 100kPa --stress-h 100kPa --json --uncertainty stress-v=1%
  --uncertainty stress-h=1%)

# A modulus proportional to G_g: 5 % of it, and 0.9945 deviations around it, up to 1.5/sqrt(4096) of one.
set(linear estimate --contact flat --void-ratio 0.6 --pressure 100kPa --coordination-number 5.73 --uncertainty grain-shear-modulus=5%)
granum_cli_test("estimate --uncertainty: linear, first order" EXIT 0
  STDOUT "K +152\\.9 MPa +\\+- 7\\.644 MPa +14[45]\\.[0-9]* MPa +15[23].* +16[01].* +grain-shear-modulus 100 %"
  ARGS ${linear})
granum_cli_test("estimate --uncertainty: linear, sampled" EXIT 0
  JSON "uncertainty/uniform_stress/K/sampled/standard_deviation=^7[3-9][0-9][0-9][0-9][0-9][0-9]\\."
  ARGS ${linear} --json)
granum_cli_test("estimate --uncertainty: drawn from a fixed seed" EXIT 0 JSON
  "uncertainty/draws=^4096$" ARGS ${linear} --json)

# The calibration of the relaxed moduli is one more input, and all there is where the inputs are exact.
set(dense estimate --void-ratio 0.56 --pressure 100kPa --coordination-number 5.9)
granum_cli_test("estimate --uncertainty: calibration alone" EXIT 0
  JSON "uncertainty/relaxed/G_vh/share_of_variance/calibration=^1(\\.0)?$"
  ARGS ${dense} --mechanical-coordination-number 6.02 --json --uncertainty void-ratio=0)
granum_cli_test("estimate --uncertainty: no calibration in uniform strain" EXIT 0
  JSON "uncertainty/uniform_strain/G_vh/share_of_variance=^{[^,]*}$"
  ARGS ${dense} --mechanical-coordination-number 6.02 --json --uncertainty void-ratio=0.01)
# z* = C_n/(1-x): with a given share of rattlers x C_n moves z* too, beside its own 2/3; 0.02 of z* are 0.02 (1-x)/z*
# of x.
foreach(way "--mechanical-coordination-number;6.020408163265306;mechanical-coordination-number=0.02;0\\.03534[0-9]+$"
    "--rattler-fraction;2%;rattler-fraction=0.0032555555555555553;0\\.03534[0-9]+$"
    "--mechanical-coordination-number;6.020408163265306;coordination-number=0.1;0\\.1277[0-9]+$"
    "--rattler-fraction;2%;coordination-number=0.1;0\\.6488[0-9]+$")
  list(GET way 0 option)
  list(GET way 1 value)
  list(GET way 2 deviation)
  list(GET way 3 share)
  string(REGEX REPLACE "=.*" "" key "${deviation}")
  string(REPLACE "-" "_" key "${key}")
  granum_cli_test("estimate --uncertainty: ${deviation} with ${option}" EXIT 0
    JSON "uncertainty/relaxed/G_vh/share_of_variance/${key}=^${share}"
    ARGS ${dense} ${option} ${value} --json --uncertainty ${deviation})
endforeach()
# Draws of a share below 0 are left out, and said to be; first order knows nothing of them.
granum_cli_test("estimate --uncertainty: many draws rejected" EXIT 0 JSON "uncertainty/rejected=^1[01][0-9][0-9]$"
  STDERR "warning: 1[01][0-9][0-9] of 4096 draws are outside the range of the inputs"
  ARGS ${dense} --rattler-fraction 2% --json --uncertainty rattler-fraction=0.0325)
granum_cli_test("estimate --uncertainty: many draws rejected, in the table" EXIT 4
  STDOUT "4096 draws, 1[01][0-9][0-9] of them rejected"
  STDERR "error: 1[01][0-9][0-9] of 4096 draws" ARGS ${dense} --rattler-fraction 2% --strict
  --uncertainty rattler-fraction=0.0325)
# Not rigid on average: no derivative, but a band of those draws that are.
granum_cli_test("estimate --uncertainty: below the isostatic point" EXIT 0
  JSON "uncertainty/relaxed/G_vh/standard_deviation=^$" STDERR "warning: some moduli under relaxed have no first-order"
  ARGS ${dense} --mechanical-coordination-number 3.9 --json --uncertainty mechanical-coordination-number=0.3)
granum_cli_test("estimate --uncertainty: below the isostatic point, sampled" EXIT 0
  JSON "uncertainty/relaxed/G_vh/sampled/q84=^[1-9]" STDERR "z\\* = 3.9 is not above"
  ARGS ${dense} --mechanical-coordination-number 3.9 --json --uncertainty mechanical-coordination-number=0.3)

function(granum_uncertainty_refuses what message)
  granum_cli_test("estimate --uncertainty: ${what}" EXIT 2 STDERR "^granum: error: --uncertainty ${message}"
    ARGS estimate --void-ratio 0.6 --pressure 100kPa ${ARGN})
endfunction()
granum_uncertainty_refuses("unknown key"
  "mood: not an input of this packing, which is made of grain-shear-modulus, [^\n]*, pressure\n" --uncertainty mood=1)
granum_uncertainty_refuses("input of another packing" "porosity: not an input of this packing"
  --uncertainty porosity=0.01)
granum_uncertainty_refuses("k_t that follows Poisson's ratio" "tangential-ratio: not an input"
  --uncertainty tangential-ratio=0.1)
granum_uncertainty_refuses("negative deviation" "void-ratio = -0\\.1 is outside \\[0, inf\\)"
  --uncertainty void-ratio=-0.1)
granum_uncertainty_refuses("negative share" "void-ratio = -0\\.1 is outside" --uncertainty void-ratio=-10%)
granum_uncertainty_refuses("no unit" "pressure = 5 has no unit; write 5Pa" --uncertainty pressure=5)
granum_uncertainty_refuses("wrong unit" "pressure = '5mm' must be a pressure, not a length" --uncertainty pressure=5mm)
granum_uncertainty_refuses("per cent of zero" "fabric=5%: per cent of --fabric = 0 are nothing" --uncertainty fabric=5%)
granum_uncertainty_refuses("no value" "void-ratio: write key=sd" --uncertainty void-ratio)
granum_uncertainty_refuses("twice" "void-ratio is given twice" --uncertainty void-ratio=0.1
  --uncertainty void-ratio=0.2)
granum_cli_test("estimate --uncertainty: impossible draws" EXIT 2 STDERR "fewer than two draws are packings"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --uncertainty grain-poisson-ratio=1e12)

# Without contacts there is nothing to be uncertain about, and nothing grows with stress.
granum_cli_test("estimate: no contacts" EXIT 0 JSON
    "uniform_strain/K=^0\\.0$" "uniform_stress/E_v=^0\\.0$" "uniform_strain/s=^$" "uniform_stress/m=^$"
    "notes=m, n and s do not exist: without contacts"
  STDERR "warning: a packing without contacts carries no stress"
    ARGS estimate --void-ratio 0.6 --pressure 100kPa --coordination-number 0 --json)
granum_cli_test("estimate: only rattlers" EXIT 0 JSON "relaxed/K=^0\\.0$" STDERR "z\\* = 0 is not above"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --coordination-number 0 --rattler-fraction 20% --json)
granum_cli_test("sweep: no contacts" EXIT 0 JSON "states/0/rung0/G_hv=^0\\.0$"
  STDERR "warning: 2 of 2 states lie outside a formula's validity[^\n]*without contacts carries no stress"
  ARGS sweep --void-ratio 0.6 --coordination-number 0 --from 10kPa --to 100kPa --points 2 --json)
