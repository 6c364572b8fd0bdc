# SPDX-License-Identifier: GPL-3.0-or-later
# C at p_a = 101.325 kPa is 214.5 * 1.01325^-(1-0.51) = 213.1210
# hv_dense_cone.csv: Eq. (1) with the constants of the paper's Table 5 (cone, dense, G_hv) on its triaxial paths.
granum_cli_test("fit: table" EXIT 0 STDOUT "m +0\\.2730 .*exponent of sigma_h.*s = m \\+ n +0\\.5100"
  ARGS fit hv_dense_cone.csv --modulus-column G_hv)
granum_cli_test("fit: C p_a in the table" EXIT 0 STDOUT "C p_a = 21\\.45 MPa"
  ARGS fit hv_dense_cone.csv --modulus-column G_hv)
granum_cli_test("fit: json" EXIT 0 JSON
    "m=^0\\.2(73|729999|730000)" "n=^0\\.2(37|369999|370000)" "s=^0\\.5(1$|10000|09999)" "C=^21[45]\\."
    "notes=^\\[\\]$"
  ARGS fit hv_dense_cone.csv --modulus-column G_hv --json --weights absolute)
granum_cli_test("fit: another p_a gives another C" EXIT 0 JSON "C=^213\\.1209"
  ARGS fit hv_dense_cone.csv --modulus-column G_hv --json --atmospheric-pressure 101.325kPa)
granum_cli_test("fit: isotropic path, sum only" EXIT 0 STDOUT "  s +0\\.3490"
  ARGS fit isotropic.csv --sum-only)
granum_cli_test("fit: sum only has no m" EXIT 0 JSON "m=^$" ARGS fit isotropic.csv --sum-only --json)
granum_cli_test("fit: isotropic path cannot determine m and n separately" EXIT 2
  STDERR "m and n cannot be separated: .*fit s alone" ARGS fit isotropic.csv)
granum_cli_test("fit: a note is a warning" EXIT 0 STDOUT "s +0\\.51"
  STDERR "granum: warning: sigma_i/sigma_j changes"
  ARGS fit hv_dense_cone.csv --modulus-column G_hv --sum-only)
granum_cli_test("fit: a note fails under --strict" EXIT 4 STDOUT "s +0\\.51"
  STDERR "granum: error: sigma_i/sigma_j changes" ARGS fit hv_dense_cone.csv --modulus-column G_hv --sum-only --strict)

granum_cli_test("fit: no file named" EXIT 2 STDERR "granum: error: file is required" ARGS fit)
granum_cli_test("fit: missing file" EXIT 3 STDERR "^granum: error: none\\.csv: cannot be read: No such file"
  ARGS fit none.csv)
granum_cli_test("fit: truncated file" EXIT 3
  STDERR "^granum: error: truncated\\.csv:5: expected 4 fields \\(G_MPa, sigma_v_kPa, sigma_h_kPa, e\\), found 2"
  ARGS fit truncated.csv)
granum_cli_test("fit: negative stress" EXIT 3
  STDERR "^granum: error: negative_stress\\.csv:4: stress_i = -80000 Pa is outside .*stress_i is sigma_h"
  ARGS fit negative_stress.csv)
granum_cli_test("fit: missing column" EXIT 3
  STDERR "isotropic\\.csv:2: expected a column 'G_hh_Pa' \\(or another unit\\)"
  ARGS fit isotropic.csv --modulus-column G_hh)
granum_cli_test("fit: unknown option" EXIT 2
  STDERR "granum: error: .*--sumonly" ARGS fit isotropic.csv --sumonly)
granum_cli_test("fit: pressure without unit" EXIT 2
  STDERR "^granum: error: --atmospheric-pressure = 100 has no unit; write 100Pa, 100kPa"
  ARGS fit isotropic.csv --atmospheric-pressure 100)
granum_cli_test("fit: negative pressure" EXIT 2
  STDERR "--atmospheric-pressure = -5000 Pa is outside \\(0, inf\\)"
  ARGS fit isotropic.csv --atmospheric-pressure -5kPa)
granum_cli_test("fit: length for pressure" EXIT 2 STDERR "must be a pressure, not a length"
  ARGS fit isotropic.csv --atmospheric-pressure 5mm)
granum_cli_test("fit: unknown f(e)" EXIT 2
  STDERR "--void-ratio-function: hardin not in {hardin-richart-round,"
  ARGS fit isotropic.csv --void-ratio-function hardin)
granum_cli_test("fit: unknown weights" EXIT 2
  STDERR "granum: error: --weights: equal not in" ARGS fit isotropic.csv --weights equal)
granum_cli_test("fit: unwritable output" EXIT 3 STDERR "no such folder/fit\\.json: cannot be written"
  ARGS fit isotropic.csv --sum-only --json --out "no such folder/fit.json")
granum_cli_test("fit: existing output is kept" EXIT 3 STDERR "isotropic\\.csv: exists already and is kept"
  ARGS fit isotropic.csv --sum-only --out isotropic.csv)
granum_cli_test("fit: output to a file" EXIT 0 ARGS fit isotropic.csv --sum-only --json --force
  --out "${CMAKE_CURRENT_BINARY_DIR}/fit result.json")

# Tables as people write them: one mean stress, a modulus by its usual name, units in brackets.
granum_cli_test("fit: p and G_max with units in brackets" EXIT 0
  STDOUT "G_max = C p_a f\\(e\\) \\(p/p_a\\)\\^s.*  s +0\\.3490.*1/\\(1\\+alpha\\) +0\\.5000 .*cone.*1/\\(1\\+alpha\\) +0\\.3333 .*sphere.*s.between.1/3.and.1/2.*alpha.*1\\.87.*p\\*[^;]*695.+Pa"
  ARGS fit isotropic_by_hand.csv)
granum_cli_test("fit: p and G_max, json" EXIT 0 JSON
    "s=^0\\.3(49$|490000|489999)" "alpha=^1\\.8653" "one_over_one_plus_alpha/sphere=^0\\.33333333"
    "inputs/stress_j_column=^p$" "inputs/sum_only=^(ON|true)$" "m=^$"
  ARGS fit isotropic_by_hand.csv --json)
granum_cli_test("fit: a column by its whole heading" EXIT 0 STDOUT "  s +0\\.3490"
  ARGS fit isotropic_by_hand.csv --modulus-column "G_max [MPa]" --stress-i-column "p (kPa)" --stress-j-column p --sum-only)
granum_cli_test("fit: the name of the modulus column determines its directions" EXIT 0 STDOUT "G_hv = .*m +0\\.2730 .*exponent of sigma_h"
  ARGS fit hv_dense_cone.csv)
granum_cli_test("fit: s above one half is not explained by a constant number of contacts" EXIT 0
  STDOUT "s = m \\+ n +0\\.5100 .*s above 1/2: " ARGS fit hv_dense_cone.csv)
granum_cli_test("fit: no void ratio" EXIT 3 STDERR "expected a column 'e' of the void ratio; .*--void-ratio-function none"
  ARGS fit beads_speeds.csv --modulus-column p --void-ratio-column e)
granum_cli_test("fit: m and n that cannot be separated name --sum-only" EXIT 2 STDERR "or add rows of another stress ratio\\. --sum-only fits s\n"
  ARGS fit isotropic.csv)
granum_cli_test("fit: picture of another kind" EXIT 2 STDERR "--picture = 'a\\.png' must end in \\.svg"
  ARGS fit isotropic_by_hand.csv --picture a.png)

# V_s: G = density V_s^2. s is twice that of V_s, here 2 log(341/205)/log(8) with little scatter.
granum_cli_test("fit: V_s with a density" EXIT 0 JSON "inputs/by_speed=^(ON|true)$" "inputs/modulus_column=^Vs$" "inputs/void_ratio_column=^e_c$"
  "s=^0\\.489" ARGS fit fit_speeds.csv --json)
granum_cli_test("fit: V_s is named in the law" EXIT 0 STDOUT "^rho Vs\\^2 = C p_a" ARGS fit fit_speeds.csv)
# (1900 (1 + 0.7)/2650) is the factor of G between the two tables
granum_cli_test("fit: V_s of dry grains of 2650 kg/m3" EXIT 0 STDERR "2650 kg/m3 and dry pores" JSON "s=^0\\.489" "C=^723\\.9"
  ARGS fit fit_speeds_bare.csv --json)
granum_cli_test("fit: C of the given density" EXIT 0 JSON "C=^882\\.3" ARGS fit fit_speeds.csv --json)
granum_cli_test("fit: V_s by its name" EXIT 0 STDERR "2650" JSON "inputs/by_speed=^(ON|true)$" ARGS fit fit_speeds_bare.csv --modulus-column V_s --json)
granum_cli_test("fit: V_s without any density" EXIT 3 STDERR "fit_speeds_no_density\\.csv:1: [^\n]*rho_kg/m3" ARGS fit fit_speeds_no_density.csv)
granum_cli_test("fit: suction" EXIT 3 STDERR "fit_suction\\.csv:3: column 'suction_kPa' has 20: suction" ARGS fit fit_suction.csv)
