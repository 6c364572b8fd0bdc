# SPDX-License-Identifier: GPL-3.0-or-later

# Grains of 36.6 GPa bulk and 45 GPa shear modulus, porosity 0.4, C_n = 8.6, 20 MPa: K and G as several independent
# codes of the Hertz-Mindlin model give them, and E = 9KG/(3K+G). The expressions leave 1e-14 relative.
set(golden --contact sphere --grain-shear-modulus 45GPa --grain-poisson-ratio 0.06395348837209303
  --radius 0.5mm --porosity 0.4 --coordination-number 8.6 --fabric 0 --pressure 20MPa --json)
set(golden_K "^1906319860\\.92(11[89]|117[2-9]|120)")
set(golden_G "^2802805417\\.138(1[6-9]|15[5-9]|20)")
set(golden_E "^5642891196\\.535(7[1-9]|80)")
granum_cli_test("estimate: golden numbers" EXIT 0 JSON "uniform_strain/K=${golden_K}" "uniform_stress/K=${golden_K}"
  "uniform_strain/G_vh=${golden_G}" "uniform_strain/G_hh=${golden_G}" "uniform_strain/C44=${golden_G}"
  "uniform_strain/C66=${golden_G}" "uniform_strain/E_v=${golden_E}" "uniform_strain/E_h=${golden_E}"
  STDERR "so many contacts, 5\\.6 at most" ARGS estimate ${golden})

# k_n = 2 G a/(1-nu) of a flat punch at every stress: K = C_n k_n/(6 pi R (1+e)), G = C_n (k_n+1.5 k_t)/(10 pi R (1+e)).
foreach(pressure 0Pa 100kPa)
  granum_cli_test("estimate: flat punch at ${pressure}" EXIT 0
    JSON "uniform_strain/K=^157008520\\.6169" "uniform_strain/G_vh=^224055402\\.3938" "uniform_strain/s=^0(\\.0)?$"
    ARGS estimate --contact flat --punch-radius 5.7um --coordination-number 5.73 --void-ratio 0.558
      --pressure ${pressure} --json)
endforeach()

# Of G_hv at equal stresses n = (b/35 + c/15)/(b/15 + c/6)/3 and m = 1/3 - n; b = 1-r and c = r under uniform strain, of
# the compliance 1/G_hv b = 4(1-1/r) and c = 4/r under uniform stress; r = k_t/k_n = 34/37.
granum_cli_test("estimate: exponents at frozen contacts" EXIT 0
  JSON "uniform_strain/m=^0\\.19967532467532" "uniform_strain/n=^0\\.13365800865800" "uniform_stress/m=^0\\.20031923383878"
  "uniform_stress/n=^0\\.13301409949454" ARGS estimate --void-ratio 0.558 --stress-v 100kPa --stress-h 100kPa --json)

set(far_fabric STDERR "beyond the range in which the relaxation of anisotropic packings was validated")
# Contacts of one stiffness, a = 1/2, r = 0.9: moduli over P k_n are 234/875, 372/875, 1013/2385, 464967/1740115.
granum_cli_test("estimate: fabric" EXIT 0 ${far_fabric} JSON "uniform_strain/C11=^3314886660\\.8442"
  "uniform_strain/C33=^5269819819\\.8037" "uniform_strain/E_v=^5264800774\\.0791" "uniform_strain/E_h=^3312112348\\.5494"
  ARGS estimate --contact flat --punch-radius 50um --coordination-number 5.73 --void-ratio 0.558 --fabric 0.5
    --tangential-ratio 0.9 --pressure 100kPa --json)

# s = 1/(1+alpha) at any fabric and stress ratio
set(anisotropic --void-ratio 0.6 --fabric 0.5 --stress-v 200kPa --stress-h 100kPa --json)
foreach(case "cone --slope 0.4=0\\.(5$|50000000000000|4999999999999)" "sphere=0\\.3333333333333" "flat --punch-radius 50um=0(\\.0)?$"
    "power-law --alpha 1.5 --profile-constant 180=0\\.(4$|40000000000000|3999999999999)")
  string(REGEX MATCH "^([^=]*)=(.*)$" matched "${case}")
  set(s "${CMAKE_MATCH_2}")
  separate_arguments(contact UNIX_COMMAND "${CMAKE_MATCH_1}")
  granum_cli_test("estimate: s of ${contact}" EXIT 0 ${far_fabric} JSON "uniform_strain/s=^${s}" "uniform_stress/s=^${s}"
    ARGS estimate --contact ${contact} ${anisotropic})
endforeach()
string(REPLACE "--contact;sphere" "--contact;power-law;--alpha;2;--profile-constant;1000" parabola "${golden}")
granum_cli_test("estimate: alpha = 2 and A = 1/(2R) is the sphere" EXIT 0 JSON "uniform_strain/K=${golden_K}"
  STDERR "so many contacts" ARGS estimate ${parabola})

# limits: numbers, never NaN
set(moduli C11 C33 C12 C13 C44 C66 K G_hh G_vh E_v E_h)
foreach(hypothesis uniform_strain uniform_stress)
  list(TRANSFORM moduli REPLACE "(.+)" "${hypothesis}/\\1=^0(\\\\.0)?$" OUTPUT_VARIABLE nothing)
  granum_cli_test("estimate: unloaded spheres, ${hypothesis}" EXIT 0 JSON ${nothing} "${hypothesis}/s=^0\\.3333333333333"
    ARGS estimate --void-ratio 0.6 --pressure 0Pa --json)
endforeach()
granum_cli_test("estimate: unloaded, in the table" EXIT 0 STDOUT "E_v +0 Pa +0 Pa.*limits along the isotropic path"
  ARGS estimate --bounds --full --void-ratio 0.6 --pressure 0Pa)
# Of z* = 4.6 spheres k_r = 0.1 makes G 1.37 times as large; a z* that is estimated is that of other packings.
granum_cli_test("estimate: contacts that resist rolling" EXIT 0 JSON "inputs/rolling=^0\\.1" "answer/shear_modulus/value=^1016279"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --mechanical-coordination-number 4.6 --rolling 0.1 --json)
granum_cli_test("estimate: a prior of packings without rolling resistance" EXIT 0 STDOUT "beads"
  STDERR "warning: z\\* is estimated as in packings without rolling resistance"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --rolling 0.1)
set(frictionless --void-ratio 0.6 --pressure 100kPa --tangential-ratio 0 --json)
granum_cli_test("estimate: k_t = 0" EXIT 0 STDERR "warning: uniform stress without tangential stiffness"
  JSON "uniform_stress/E_v=^0(\\.0)?$" "uniform_stress/E_h=^0(\\.0)?$" "uniform_stress/s=^$" "uniform_strain/E_v=^[1-9]"
  ARGS estimate ${frictionless})
granum_cli_test("estimate: k_t = 0, in the table" EXIT 0 STDOUT "undefined"
  STDERR "warning: uniform stress without" ARGS estimate --bounds --void-ratio 0.6 --pressure 100kPa --tangential-ratio 0)
granum_cli_test("estimate: unstable stiffness has no Young's modulus" EXIT 0 JSON "uniform_strain/E_v=^$"
  STDERR "Young's moduli under uniform strain do not exist"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --fabric -2.3 --tangential-ratio 0.1 --json)

# density
foreach(density "--porosity;37.5%" "--porosity;0.375" "--solid-fraction;0.625" "--void-ratio;0.6")
  granum_cli_test("estimate: density by ${density}" EXIT 0
    JSON "inputs/void_ratio=^0\\.(6$|6000000000000|5999999999999)"
    ARGS estimate ${density} --pressure 100kPa --json)
endforeach()

# what was assumed, and what else is remarked
set(complete --grain-shear-modulus 30GPa --grain-poisson-ratio 0.15 --radius 0.5mm --tangential-ratio 0.9
  --fabric 0 --void-ratio 0.558 --stress-v 100kPa --stress-h 100kPa --json)
granum_cli_test("estimate: nothing assumed" EXIT 0 JSON "notes=^\\[ *\\]$" "answer/notes=^\\[ *\\]$" "answer/assumed_deviations=^{ *\n? *}$"
  "inputs/stress_h=^100000(\\.0)?$" ARGS estimate --contact sphere --coordination-number 5.73 --grain-density 2650kg/m3 ${complete})
# each assumption is named with its deviation
set(assumed "--contact sphere" "--grain-shear-modulus 30 GPa \\+- 9 GPa" "--grain-poisson-ratio 0\\.15 \\+- 0\\.07" "--radius 500 um"
  "--tangential-ratio 0\\.9189" "--fabric 0 \\+- 0\\.05" "--grain-density 2650 kg/m3 \\+- 50 kg/m3")
list(TRANSFORM assumed PREPEND "notes=assumed " OUTPUT_VARIABLE noted)
granum_cli_test("estimate: assumptions, JSON" EXIT 0 JSON ${noted} "answer/assumed_deviations/grain-shear-modulus=^9000000000(\\.0)?$"
  "answer/assumed_deviations/grain-poisson-ratio=^0\\.07" "answer/assumed_deviations/fabric=^0\\.05"
  "answer/assumed_deviations/grain-density=^50(\\.0)?$" "answer/stated_deviations=^{ *\n? *}$"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --json)
list(JOIN assumed "[^\n]*\n.*- assumed " in_order)
foreach(more "" --bounds)
  granum_cli_test("estimate: assumptions, table ${more}" EXIT 0 STDOUT "- assumed ${in_order}"
    ARGS estimate --full ${more} --void-ratio 0.6 --pressure 100kPa)
endforeach()
granum_cli_test("estimate: assumed slope" EXIT 0 JSON "notes=assumed --slope 0\\.4"
  ARGS estimate --contact cone --coordination-number 5.73 ${complete})
granum_cli_test("estimate: assumed punch" EXIT 0 JSON "inputs/punch_radius=^5\\.(7|69999)[0-9]*e-0?6$"
  "notes=assumed --punch-radius 5\\.7 um" ARGS estimate --contact flat --coordination-number 5.73 ${complete})
# Where contacts are not given, bounds and rungs take those of the answer, and the relaxed rung is the answer: at C_n and z*
# of the answer each column is the same again.
granum_cli_test("estimate: rungs have the contacts of the answer" EXIT 0
  STDOUT "\n  G +156\\.8 MPa .*C_n = 5\\.379, z\\* = 5\\.489[^\n]*\n.*G_vh = C44 +[0-9.]+ MPa +[0-9.]+ MPa +156\\.8 MPa \\+- .*C_n = 5\\.38 .*--coordination-number"
  ARGS estimate --bounds --full --void-ratio 0.6 --pressure 100kPa --rattler-fraction 2%)
granum_cli_test("estimate: table" EXIT 0
  STDOUT "\n  K +208 MPa +208 MPa +186\\.2 MPa .*\n  s = m . n +0\\.3333 +0\\.3333 +0\\.3331"
  ARGS estimate --bounds --void-ratio 0.6 --pressure 100kPa --coordination-number 5.73)
granum_cli_test("estimate: table of a profile" EXIT 0 STDOUT "alpha = 1\\.5, A = 180"
  ARGS estimate --full --contact power-law --alpha 1.5 --profile-constant 180 --void-ratio 0.6 --pressure 100kPa)
granum_cli_test("estimate: assumptions are not outside validity" EXIT 0 JSON "uniform_strain/K=^18[0-9]"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --strict --json)
granum_cli_test("estimate: a validity note fails under --strict" EXIT 4 JSON "notes=coordination number exceeds 12"
  STDERR "^granum: error: coordination number exceeds 12[^\n]*\ngranum: error: z\\* is 13"
  ARGS estimate --coordination-number 13 --void-ratio 0.6 --pressure 100kPa --strict --json)

function(granum_estimate_refuses what message)
  granum_cli_test("estimate: ${what}" EXIT 2 STDERR "^granum: error: ${message}" ARGS estimate ${ARGN})
endfunction()
set(state --void-ratio 0.6 --pressure 100kPa)
granum_estimate_refuses("nu = 0.6" "--grain-poisson-ratio = 0\\.6 is outside \\(-1, 0\\.5\\]"
  ${state} --grain-poisson-ratio 0.6)
granum_estimate_refuses("porosity 38" "--porosity = 38 is outside \\(0, 1\\); write 38% for per cent"
  --porosity 38 --pressure 100kPa)
granum_estimate_refuses("solid fraction 1" "--solid-fraction = 1 is outside \\(0, 1\\)\n"
  --solid-fraction 1 --pressure 100kPa)
granum_estimate_refuses("void ratio 0" "--void-ratio = 0 is outside \\[1e-06, 1e\\+06\\]" --void-ratio 0 --pressure 100kPa)
granum_estimate_refuses("negative void ratio" "--void-ratio = -0\\.5 is outside" --void-ratio -0.5 --pressure 100kPa)
granum_estimate_refuses("void ratio NaN" "--void-ratio = 'nan' is not a pure number"
  --void-ratio nan --pressure 100kPa)
granum_estimate_refuses("pressure NaN" "--pressure = 'nanPa' is not a pressure" --void-ratio 0.6 --pressure nanPa)
granum_estimate_refuses("no density" "the density is missing: give one of --void-ratio" --pressure 100kPa)
granum_estimate_refuses("density twice" "the density is given more than once" ${state} --porosity 0.38)
granum_estimate_refuses("negative C_n" "--coordination-number = -1 is outside" ${state} --coordination-number -1)
granum_estimate_refuses("fabric too large" "--fabric = 1\\.5 is outside" ${state} --fabric 1.5)
granum_estimate_refuses("negative k_t" "--tangential-ratio = -1 is outside" ${state} --tangential-ratio -1)
granum_estimate_refuses("negative k_r" "--rolling = -0\\.1 is outside \\[0, 1\\]" ${state} --rolling -0.1)
granum_estimate_refuses("k_r beyond the fit" "--rolling = 1\\.01 is outside \\[0, 1\\]: the fit ends there" ${state}
  --rolling 1.01)
granum_estimate_refuses("negative pressure" "--pressure = -5000 Pa is outside \\[0, inf\\)"
  --void-ratio 0.6 --pressure -5kPa)
granum_estimate_refuses("negative stress" "--stress-h = -5000 Pa is outside"
  --void-ratio 0.6 --stress-v 5kPa --stress-h -5kPa)
granum_estimate_refuses("stress without unit" "--stress-v = 100 has no unit; write 100Pa, 100kPa"
  --void-ratio 0.6 --stress-v 100 --stress-h 100kPa)
granum_estimate_refuses("length for stress" "--pressure = '5mm' must be a pressure, not a length"
  --void-ratio 0.6 --pressure 5mm)
granum_estimate_refuses("no stress" "the stress is missing: give --pressure" --void-ratio 0.6)
granum_estimate_refuses("only stress-v" "--stress-h is missing: --stress-v and --stress-h go together"
  --void-ratio 0.6 --stress-v 100kPa)
granum_estimate_refuses("only stress-h" "--stress-v is missing" --void-ratio 0.6 --stress-h 100kPa)
granum_estimate_refuses("pressure and stress" "--pressure sets both stresses" ${state} --stress-h 100kPa)
granum_estimate_refuses("one stress zero" "--stress-h = 0 Pa is outside \\(0, inf\\)"
  --void-ratio 0.6 --stress-v 100kPa --stress-h 0kPa)
granum_estimate_refuses("alpha < 0" "--alpha = -0\\.5 is outside \\(0, inf\\)"
  ${state} --contact power-law --alpha=-0.5 --profile-constant 180)
granum_estimate_refuses("power law without constant" "--contact power-law needs --alpha and --profile-constant"
  ${state} --contact power-law --alpha 1.5)
granum_estimate_refuses("slope of a sphere" "--slope goes with --contact cone, not with --contact sphere"
  ${state} --slope 0.4)
granum_estimate_refuses("punch of a cone" "--punch-radius goes with --contact flat, not with --contact cone"
  ${state} --contact cone --punch-radius 5um)
granum_estimate_refuses("alpha of a flat" "--alpha goes with --contact power-law" ${state} --contact flat --alpha 2)
granum_estimate_refuses("constant of a sphere" "--profile-constant goes with --contact power-law"
  ${state} --profile-constant 180)
granum_estimate_refuses("unknown contact" "--contact: egg not in {cone,sphere,flat,power-law,rough}" ${state} --contact egg)
granum_estimate_refuses("unknown option" "[^\n]*--pressur" ${state} --pressur 5kPa)
granum_estimate_refuses("huge k_t" "--tangential-ratio = 1e\\+20 is outside \\[0, 100\\]" ${state} --tangential-ratio 1e20)
granum_estimate_refuses("overflow" "the moduli exceed the range of a double" ${state}
  --contact flat --punch-radius 1nm --radius 1nm --grain-shear-modulus 1.7e308Pa)

granum_cli_test("estimate: unwritable output" EXIT 3 STDERR "no such folder/estimate\\.json: cannot be written"
  ARGS estimate ${state} --json --out "no such folder/estimate.json")
granum_cli_test("estimate: existing output is kept" EXIT 3 STDERR "isotropic\\.csv: exists already and is kept"
  ARGS estimate ${state} --out isotropic.csv)
granum_cli_test("estimate: output to a file" EXIT 0
  ARGS estimate ${state} --json --force --out "${CMAKE_CURRENT_BINARY_DIR}/estimate result.json")

# Rung 3 where z* is given: z* = C_n/(1 - share), softer than uniform strain by the factor of a dense packing, with its
# standard error; nothing below the isostatic point.
set(dense --void-ratio 0.56 --pressure 100kPa --coordination-number 5.9)
granum_cli_test("estimate: relaxed is not evaluated below the isostatic point" EXIT 0 STDERR "may not be rigid|is not above the isostatic point"
  STDOUT "G_vh = C44 [^\n]* declines " ARGS estimate --bounds ${dense} --mechanical-coordination-number 3.5)
granum_cli_test("estimate: relaxed is not evaluated and states no error" EXIT 0 STDERR "isostatic point" JSON "relaxed/relative_error=^$"
  ARGS estimate ${dense} --mechanical-coordination-number 3.5 --json)
granum_cli_test("estimate: relaxed where rattlers are given" EXIT 0 JSON "inputs/mechanical_coordination_number=^6\\.0204"
  ARGS estimate ${dense} --rattler-fraction 0.02 --json)
granum_cli_test("estimate: relaxed dense spheres have two thirds of G" EXIT 0 JSON "relaxed/G_vh=^20[0-9][0-9]+\\."
  ARGS estimate ${dense} --rattler-fraction 0.02 --json)
granum_cli_test("estimate: relaxed with its error" EXIT 0 STDOUT "G_vh = C44 .* 20[0-9]\\.?[0-9]* MPa \\+- 3 %"
  ARGS estimate --bounds ${dense} --mechanical-coordination-number 6.02)
granum_cli_test("estimate: relaxed and rung 3 are there without z*" EXIT 0 JSON "relaxed/G_vh=^[1-9]" "answer/rattler_fraction/value=^0\\.0"
  ARGS estimate ${dense} --json)
granum_cli_test("estimate: below the isostatic point" EXIT 0 STDERR "z\\* = 3.5 is not above the isostatic point"
  JSON "relaxed/G_vh=^0\\.0$" ARGS estimate ${dense} --mechanical-coordination-number 3.5 --json)
granum_cli_test("estimate: z* given twice" EXIT 2 STDERR "coordination_number, mechanical_coordination_number and rattler_fraction"
  ARGS estimate ${dense} --mechanical-coordination-number 6 --rattler-fraction 0.02)
granum_cli_test("estimate: z* and rattlers are C_n" EXIT 0 JSON "answer/coordination_number/value=^(5\\.88$|5\\.88000000000|5\\.87999999999)"
  "answer/coordination_number/high=^(5\\.88$|5\\.88000000000|5\\.87999999999)"
  ARGS estimate --void-ratio 0.56 --pressure 100kPa --mechanical-coordination-number 6 --rattler-fraction 0.02 --json)
granum_cli_test("estimate: rattlers in per cent" EXIT 2 STDERR "--rattler-fraction = 2 is outside .0, 1.; write 2% for per cent"
  ARGS estimate ${dense} --rattler-fraction 2)

# --tolerance: the cheapest rung whose stated error fits; exit code 4 under --strict if none does. Errors are halves of the
# answer's range over its value. Dense spheres of known grains and contacts: rung 3 is good to 3 %, rung 0 off by two thirds.
set(counted ${dense} --rattler-fraction 0.02 --fabric 0 --grain-shear-modulus 30GPa --grain-poisson-ratio 0.15)
granum_cli_test("estimate: a tolerance of 5% takes rung 3" EXIT 0 JSON "ladder/rung=^3$" "ladder/tolerance_met=^(ON|true)$"
  "ladder/rungs/3/relative_error/G_vh=^0\\.0295" "ladder/rungs/3/verdict=^chosen$" "ladder/rungs/0/verdict=^beyond_tolerance$"
  "ladder/mechanical_coordination_number/value=^6\\.0204" "ladder/mechanical_coordination_number/low=^6\\.0204"
  "ladder/mechanical_coordination_number/high=^6\\.0204" "ladder/mechanical_coordination_number/estimated=MISSING"
  ARGS estimate ${counted} --tolerance 5% --strict --json)
granum_cli_test("estimate: a tolerance of 80% takes rung 0" EXIT 0 JSON "ladder/rungs/0/verdict=^chosen$" "ladder/rung=^0$"
  ARGS estimate ${counted} --tolerance 80% --strict --json)
granum_cli_test("estimate: a plain fraction is a tolerance" EXIT 0 JSON "ladder/tolerance=^0\\.05" "ladder/rung=^3$"
  ARGS estimate ${counted} --tolerance 0.05 --json)
granum_cli_test("estimate: the chosen rung on the screen" EXIT 0
  STDOUT "\nRung 3, [^\n]* 5 % met\n.*G_vh +20[0-9]\\.?[0-9]* MPa \\+- 3 %\n.*\n  3  relaxed +20[0-9]\\.?[0-9]* MPa +3 % .*\n  rung 3, chosen: "
  ARGS estimate ${counted} --tolerance 5%)
granum_cli_test("estimate: a tolerance that nothing meets" EXIT 0 JSON "ladder/tolerance_met=^(OFF|false)$" "ladder/rung=^3$"
  STDERR "warning: [^\n]* 1 % is not met: [^\n]* 3, [^\n]* 3 %\n" ARGS estimate ${counted} --tolerance 1% --json)
granum_cli_test("estimate: a tolerance that nothing meets, strictly" EXIT 4 STDOUT "a packing of grains"
  STDERR "error: [^\n]* 1 % is not met" ARGS estimate ${counted} --tolerance 1% --strict)
granum_cli_test("estimate: assumed inputs contribute to a stated error" EXIT 0 STDERR "not met"
  JSON "ladder/rungs/3/relative_error/G_vh=^0\\.2[0-9]" "ladder/rungs/3/error_source=grain-shear-modulus 20 %"
  ARGS estimate ${dense} --rattler-fraction 0.02 --fabric 0 --tolerance 5% --json)
granum_cli_test("estimate: unknown rattlers count in a stated error" EXIT 0 STDERR "not met"
  JSON "ladder/mechanical_coordination_number/value=^4\\.4" "ladder/mechanical_coordination_number/low=^4\\.3"
  "ladder/mechanical_coordination_number/high=^4\\.5" "ladder/rungs/3/error_source=contacts 10 %" "ladder/advice=rattlers"
  ARGS estimate --void-ratio 0.57 --pressure 10kPa --coordination-number 4.1 --tolerance 5% --json)
granum_cli_test("estimate: rungs 1 and 2 miss the fabric" EXIT 0 STDERR "not met" JSON "ladder/rungs/1/verdict=^inputs_missing$"
  "ladder/rungs/2/missing/0=fabric" "ladder/rungs/0/missing=^\\[ *\\]$" ARGS estimate ${dense} --tolerance 5% --json)
granum_cli_test("estimate: the error of uncounted contacts" EXIT 4 STDERR "10 % is not met"
  JSON "ladder/rungs/3/relative_error/G_vh=^0\\.5[0-9]" "ladder/rungs/3/error_source=contacts 5[0-9] %" "ladder/rungs/0/relative_error/G_vh=^[1-9]"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --tolerance 10% --strict --json)
granum_cli_test("estimate: below the isostatic point the error is unknown" EXIT 0 JSON "ladder/rungs/0/relative_error=^$"
  STDERR "may not be rigid" ARGS estimate ${dense} --mechanical-coordination-number 3.5 --tolerance 5% --json)
granum_estimate_refuses("tolerance 0" "--tolerance = 0 is outside \\(0, inf\\)" ${dense} --tolerance 0)
granum_estimate_refuses("tolerance NaN" "--tolerance = 'nan' is not a pure number" ${dense} --tolerance nan)
granum_estimate_refuses("tolerance with a unit" "--tolerance = '5kPa' must be a pure number" ${dense} --tolerance 5kPa)

# k_t = k_n, as for grains of nu = 0: C12 and C13 of uniform strain vanish, and no rung is lost
set(equal_stiffness --void-ratio 0.6 --tangential-ratio 1 --pressure 100kPa --rattler-fraction 2%)
granum_cli_test("estimate: s of rung 3 at k_t = k_n" EXIT 0 JSON "relaxed/s=^0\\.33305"
  ARGS estimate ${equal_stiffness} --json)
granum_cli_test("estimate: uncertainty at k_t = k_n" EXIT 0 JSON "answer/shares/void-ratio=^0\\.[0-9]"
  ARGS estimate ${equal_stiffness} --uncertainty void-ratio=0.01 --json)
granum_cli_test("estimate: ladder at k_t = k_n" EXIT 0 JSON "ladder/rung=^3$"
  ARGS estimate ${equal_stiffness} --coordination-number 6 --fabric 0 --grain-shear-modulus 30GPa --grain-poisson-ratio 0.15
    --tolerance 10% --json)
granum_cli_test("estimate: k_t = k_n of grains of nu = 0" EXIT 0 JSON "relaxed/n=^0\\.[1-9]"
  ARGS estimate --void-ratio 0.6 --grain-poisson-ratio 0 --pressure 100kPa --rattler-fraction 2% --json)
granum_cli_test("estimate: warnings of the ladder are in the JSON" EXIT 0 STDERR "tolerance of 0.1 % is not met"
  JSON "warnings/0=tolerance of 0.1 % is not met" ARGS estimate ${equal_stiffness} --coordination-number 6 --fabric 0
    --tolerance 0.1% --json)

# Grains of many sizes: equal ones are the special case, a sieve curve knows its sizes, and mistakes are named.
set(dense estimate --void-ratio 0.6 --pressure 100kPa --rattler-fraction 2%)
foreach(equal lognormal:0 bidisperse:1 uniform:2:2)
  granum_cli_test("estimate: --sizes ${equal} is equal grains" EXIT 0 JSON "uniform_strain/G_vh=^296755944\\.3"
    ARGS ${dense} --coordination-number 5.73 --sizes ${equal} --json)
endforeach()
granum_estimate_refuses("grains cut to one size" "[^\n]*= 1 is outside \\[1\\.000001, " ${state} --sizes lognormal:0.5:1)
granum_cli_test("estimate: equal grains without --sizes" EXIT 0 JSON "uniform_strain/G_vh=^296755944\\.3"
  ARGS ${dense} --coordination-number 5.73 --json)
granum_cli_test("estimate: lognormal grains" EXIT 0 STDOUT "sizes +lognormal:0\\.35.*C_u = 1\\.704.*<l\\^2>"
  STDERR "contacts of unequal grains" ARGS ${dense} --full --sizes lognormal:0.35)
granum_cli_test("estimate: a sieve curve" EXIT 0 STDERR "contacts of unequal grains" JSON "inputs/gradation/d10=^0\\.0002(0|$)" ARGS ${dense} --grain-shape sphere --sieve sieve.csv --json)
granum_cli_test("estimate: --uniformity with --d50" EXIT 0 STDERR "contacts of unequal grains" JSON "inputs/gradation/uniformity=^2\\.(5|4999999|5000000)"
  ARGS ${dense} --grain-shape sphere --uniformity 2.5 --d50 0.5mm --json)
granum_cli_test("estimate: --d50 is the diameter of half of the mass" EXIT 0 STDERR "contacts of unequal grains" JSON "inputs/gradation/d50=^0\\.000(5|4999999)"
  ARGS ${dense} --grain-shape sphere --uniformity 2.5 --d50 0.5mm --json)
granum_cli_test("estimate: a wide distribution is reported as not validated" EXIT 0 STDERR "contacts of unequal grains"
  STDOUT "C_u is 2\\.5: the sizes in contact were validated with packings only up to 1\\.75" ARGS ${dense} --full --grain-shape sphere --uniformity 2.5)
granum_cli_test("estimate: --d50 moves as --radius does" EXIT 0 STDERR "contacts of unequal grains"
  JSON "answer/stated_deviations/d50=^0\\.0001" ARGS ${dense} --grain-shape sphere --uniformity 2.5 --d50 0.5mm --uncertainty d50=0.1mm --json)
granum_cli_test("estimate: a sieve curve that does not end" EXIT 3 STDERR "sieve_cut.csv:4: sieve curve: passing must end at 1"
  ARGS ${dense} --sieve sieve_cut.csv)
granum_cli_test("estimate: no sieve curve" EXIT 3 STDERR "no_such.csv.*cannot be read" ARGS ${dense} --sieve no_such.csv)
granum_cli_test("estimate: sizes of no form" EXIT 2 STDERR "sizes 'normal:1' are not one of equal, bidisperse"
  ARGS ${dense} --sizes normal:1)
granum_cli_test("estimate: sizes given twice" EXIT 2 STDERR "--sizes, --sieve and --uniformity are alternatives"
  ARGS ${dense} --sizes uniform:1:2 --uniformity 2)
granum_cli_test("estimate: a sieve curve sets the radius" EXIT 2 STDERR "leave out --radius"
  ARGS ${dense} --sieve sieve.csv --radius 1mm)
granum_cli_test("estimate: --radius and --d50" EXIT 2 STDERR "--radius and --d50 are alternatives" ARGS ${dense} --radius 1mm --d50 2mm)
