# SPDX-License-Identifier: GPL-3.0-or-later
# Sands: what the grains are is implied or asked for, one answer everywhere, and what engineers type.

set(at --void-ratio 0.7 --pressure 100kPa)

# ---- sand, beads, or both
granum_cli_test("sands: nothing implies it: both, named, and the sand first" EXIT 0
  STDOUT "sand \\(measured laws\\) +beads \\(spheres of the model\\)\n  G +101\\.8 MPa [^\n]*59\\.95 MPa " ARGS estimate ${at})
granum_cli_test("sands: both in JSON" EXIT 0 JSON "answer/grain_shape=^sphere$" "answer/shear_modulus/value=^5995" "sand_answer/grain_shape=^sand$"
  "sand_answer/shear_modulus/value=^1018" "sand_answer/stress_exponent/value=^0\\.43" ARGS estimate ${at} --json)
foreach(case "--grain-shape sand" "--uniformity 2" "--least-void-ratio 0.5 --largest-void-ratio 0.9" "--strain 0.01%" "--sand nevada"
    "--sand toyoura --grain-shape sand")
  separate_arguments(words UNIX_COMMAND "${case}")
  granum_cli_test("sands: ${case} is a sand" EXIT 0 JSON "answer/grain_shape=^sand$" "sand_answer=^$" ARGS estimate ${at} ${words} --json)
endforeach()
foreach(case "--grain-shape sphere" "--grain glass" "--grain steel" "--coordination-number 4.6" "--rattler-fraction 5%" "--contact cone"
    "--sand toyoura --grain-shape sphere")
  separate_arguments(words UNIX_COMMAND "${case}")
  granum_cli_test("sands: ${case} are spheres" EXIT 0 JSON "answer/grain_shape=^sphere$" "sand_answer=^$" ARGS estimate ${at} ${words} --json)
endforeach()
granum_cli_test("sands: --uniformity 2 --grain glass are spheres" EXIT 0 STDERR "contacts of unequal grains" JSON "answer/grain_shape=^sphere$"
  ARGS estimate ${at} --uniformity 2 --grain glass --json)
granum_cli_test("sands: only a relative density" EXIT 0 JSON "answer/shear_modulus/value=^9653" "answer/grain_shape=^sand$"
  ARGS estimate --relative-density 60% --pressure 100kPa --json)
granum_cli_test("sands: only one limit" EXIT 2 STDERR "go together" ARGS estimate --relative-density 60% --least-void-ratio 0.5 --pressure 100kPa)
granum_cli_test("sands: spheres of C_u 10" EXIT 2 STDERR "\\[1, 4\\] for spheres" ARGS estimate ${at} --uniformity 10 --grain-shape sphere)
granum_cli_test("sands: strain of spheres" EXIT 2 STDERR "measured on sands" ARGS estimate ${at} --strain 0.01% --grain-shape sphere)
granum_cli_test("sands: each law with its bias" EXIT 0 STDOUT "kokusho +106\\.8 MPa +1\\.02 Toyoura" ARGS estimate --full ${at} --grain-shape sand)
set(cemented estimate ${at} --sand toyoura --cement 2% --json)
granum_cli_test("sands: cement" EXIT 0 JSON "cemented/porosity=^0\\.391764" "cemented/at_contacts/shear_modulus=^[1-9][0-9.e+]+$"
  "cemented/friable/shear_modulus=^[1-9][0-9.e+]+$" "cemented/surface_layer/compression_wave_speed=^[1-9]" ARGS ${cemented})
granum_cli_test("sands: more cement than pores" EXIT 2 STDERR "--cement = 0\\.5 is outside" ARGS estimate ${at} --cement 50%)
granum_cli_test("sands: cement in wet pores" EXIT 2 STDERR "dry pores" ARGS estimate ${at} --cement 2% --saturation 100%)
granum_cli_test("sands: K_0" EXIT 0 JSON "inputs/stress_h=^50000" ARGS estimate --void-ratio 0.7 --stress-v 100kPa --k0 0.5 --json)
granum_cli_test("sands: limits of the model of spheres are none of a sand" EXIT 0 STDOUT "measured laws"
  ARGS estimate --void-ratio 0.6 --stress-v 100kPa --k0 0.4 --grain-shape sand --uniformity 3 --strict)
granum_cli_test("sands: but of its bounds" EXIT 4 STDERR "2\\.5 " STDOUT "uniform stress"
  ARGS estimate --void-ratio 0.6 --stress-v 100kPa --k0 0.4 --grain-shape sand --uniformity 3 --bounds --strict)
granum_cli_test("sands: K_0 with both stresses" EXIT 2 STDERR "give one of the two" ARGS estimate --void-ratio 0.7 --stress-v 100kPa
  --stress-h 50kPa --k0 0.5)

# ---- the same by sweeps
granum_cli_test("sands: columns of both, and laws" EXIT 0 STDOUT "grain_shape,sand_G_answer_MPa.*G_kokusho_MPa.*,sphere,"
  ARGS sweep --void-ratio 0.7 --from 100kPa --to 200kPa --points 2 --laws)
granum_cli_test("sands: the ground is soil" EXIT 0 STDOUT "void ratio 0\\.7648: sand \\(measured laws\\)"
  ARGS sweep --depth 1m..20m --points 2 --sand toyoura --relative-density 60%)
granum_cli_test("sands: from the surface on, strictly" EXIT 0 STDOUT "no sand was tested below p' = 25 kPa, here at depths of 1\\.7 m and less"
  ARGS sweep --depth 0m..20m --points 201 --sand toyoura --relative-density 60% --k0 1 --unit-weight 14.7kN/m3 --strict)
granum_cli_test("sands: rungs are of spheres" EXIT 2 STDERR "Use grain shape sphere for the rungs" ARGS estimate --sand toyoura ${at} --tolerance 5%)
granum_cli_test("sands: but beads stay beads" EXIT 0 STDOUT "beads \\(spheres of the model\\)" ARGS sweep --depth 1m..20m --points 2
  --void-ratio 0.6 --grain glass)

granum_cli_test("sands: JSON has the inputs of a sand" EXIT 0 JSON "inputs/grain_shape=^sand$" "inputs/uniformity=^2" "inputs/d50=^0\\.0002999"
  "inputs/contact=MISSING" "inputs/radius=MISSING" "inputs/stress_v=^100000" "sand_inputs=MISSING" "assumed=MISSING"
  "sources/Lo2021/reference=^Lo, M\\. K\\., " ARGS estimate --void-ratio 0.7 --grain-shape sand --uniformity 2 --d50 0.3mm --pressure 100kPa --json)
granum_cli_test("sands: JSON has the inputs of each answer" EXIT 0 JSON "inputs/contact=^sphere$" "inputs/radius=^0\\.0005"
  "sand_inputs/grain_shape=^sand$" "sand_inputs/void_ratio=^0\\.(7|69999)" "sand_inputs/contact=MISSING" "sand_inputs/stress_h=^100000"
  "assumed/d50/value=^0\\.0004" "sources/Menq2003/not_checked=^as cited by Kottke" ARGS estimate --void-ratio 0.7 --pressure 100kPa --json)
granum_cli_test("sands: no size is made up for a sand of known C_u" EXIT 0 JSON "inputs/uniformity=^1\\.5" "inputs/gradation=MISSING"
  "assumed/d50/value=^0\\.0004" ARGS estimate --void-ratio 0.7 --grain-shape sand --uniformity 1.5 --pressure 100kPa --json)
granum_cli_test("sands: JSON of a depth has the inputs of the sand" EXIT 0 JSON "inputs/sand=^toyoura$" "inputs/uniformity=^1\\.3" "inputs/relative_density=^0\\.(6|59999)"
  "inputs/contact=MISSING" "sources/Lo2021/not_checked=SAND\\.xlsx" ARGS sweep --sand toyoura --relative-density 60% --depth 1m..5m --points 3 --json)
granum_cli_test("sands: JSON of infer has the inputs of each kind of grains" EXIT 0 JSON "inputs/contact=^sphere$" "sand_inputs/void_ratio=^0\\.(6|59999)"
  ARGS infer --void-ratio 0.6 --pressure 100kPa --vs 280m/s+-2% --json)

set(deep --depth 1m..20m --points 3)
granum_cli_test("sands: layers on the screen" EXIT 0 STDOUT "10 m +e = 0\\.65, 17 kN/m3.*from 4 m: Hostun" ARGS sweep --layers layers.csv ${deep})
granum_cli_test("sands: a column that is an option too" EXIT 2 STDERR "--void-ratio is given as an option and by the column 'e'" ARGS sweep --layers layers.csv
  ${deep} --void-ratio 0.7)
granum_cli_test("sands: layers without depths" EXIT 2 STDERR "--layers goes with --depth" ARGS sweep --layers layers.csv)
granum_cli_test("sands: layers without tops" EXIT 3 STDERR "sweep_few\\.csv:[0-9]+: [^\n]*top_m" ARGS sweep --layers sweep_few.csv ${deep})
granum_cli_test("sands: a table of stresses has no ground" EXIT 2 STDERR "--unit-weight goes with --depth, or with a table"
  ARGS sweep --table sweep_few.csv --unit-weight 17kN/m3)

# ---- V_s that was measured stands beside that of the answer, and tells bonds
granum_cli_test("sands: measured speeds of a table" EXIT 0 STDERR "line 4: [^\n]*cemented" JSON "states/0/shear_wave_speed/measured_over_answer=^0\\.84"
  "states/1/shear_wave_speed/measured_over_answer=^0\\.99" "states/2/notes/0=7\\.4 times" "states/3/shear_wave_speed/measured_over_answer=MISSING"
  ARGS sweep --table sand_rows.csv --json)
granum_cli_test("sands: a column of the ratio" EXIT 0 STDERR "cemented" STDOUT "V_s \\(m/s\\),V_s_measured_over_answer,.*\nB,0\\.7,100,255,0\\.99"
  ARGS sweep --table sand_rows.csv --grain-shape sand)
granum_cli_test("sands: a measured speed of 0" EXIT 1 STDERR "V_s = 0 m/s" STDOUT "V_s = 0 m/s" ARGS sweep --table sand_speed_zero.csv)

# ---- what slip at contacts takes
granum_cli_test("sands: slip begins" EXIT 0 JSON "answer/slip_strain/value=^1\\.2[0-9]*e-05" ARGS estimate ${at} --strain 0.01% --json)
granum_cli_test("sands: slip is computed with strain" EXIT 0 JSON "answer/slip_strain=^$" ARGS estimate ${at} --grain-shape sand --json)

# ---- infer
set(measured infer --void-ratio 0.58 --pressure 50kPa --uniformity 1.48)
granum_cli_test("sands: a forecast" EXIT 0 JSON "sand/predictions/0/G/value=^1[89]" "sand/tells_contacts=^(false|OFF)$" "grain_shape=^sand$"
  ARGS ${measured} --shear-modulus 68.3MPa+-2% --predict-pressure 500kPa --json)
# The sand of both answers is that of the one.
set(asked infer --void-ratio 0.6 --pressure 100kPa --vs 280m/s --predict-pressure 400kPa)
set(expected "sand/contact_softness/value=^0\\.869" "sand/predictions/0/G/value=^2357" "sand/predictions/0/void_ratio=^0\\.(6$|59999999)")
granum_cli_test("sands: the sand of both answers, inferred" EXIT 0 JSON ${expected} ARGS ${asked} --json)
granum_cli_test("sands: the same sand alone" EXIT 0 JSON ${expected} ARGS ${asked} --grain-shape sand --json)
granum_cli_test("sands: an assumed error is reported" EXIT 0 STDOUT "assumed --measurement-error 2 % of speeds" ARGS ${measured} --vs 200m/s)
granum_cli_test("sands: V_s alone does not determine contacts" EXIT 0 STDOUT "V_p and\n? *V_s together decide" ARGS ${measured} --vs 200m/s+-2%)
granum_cli_test("sands: V_p with V_s does" EXIT 0 JSON "sand/tells_contacts=^(true|ON)$" ARGS ${measured} --vs 200m/s+-1% --vp 310m/s+-1% --json)
granum_cli_test("sands: bonded" EXIT 0 STDERR "cemented" STDOUT "level" ARGS ${measured} --vs 600m/s)
# What a sand would ignore is refused, and nothing of it is said to be uncertain.
foreach(option "--uncertainty void-ratio=0.01" "--contacts rough" "--rattler-fraction 2%")
  separate_arguments(words UNIX_COMMAND "${option}")
  list(GET words 0 name)
  granum_cli_test("sands: infer refuses ${name}" EXIT 2 STDERR "${name} [^\n]*sphere" ARGS ${measured} --vs 200m/s ${words})
endforeach()
granum_cli_test("sands: infer assumes no uncertain input of spheres" EXIT 0 JSON "assumed=MISSING"
  ARGS ${measured} --vs 200m/s+-2% --grain-density 2650kg/m3 --json)
granum_cli_test("sands: --growth packings asks for spheres" EXIT 0 JSON "grain_shape=^sphere$" "sand=^$" ARGS infer --void-ratio 0.6
  --pressure 100kPa --vs 280m/s+-2% --growth packings --json)
granum_cli_test("sands: both where nothing implies it" EXIT 0 STDOUT "sand \\(measured laws\\).*predicted at.*beads \\(spheres of the model\\).*predicted at"
  ARGS infer --void-ratio 0.6 --pressure 100kPa --vs 280m/s+-2% --predict-pressure 400kPa)

# ---- forty lines as engineers type them, and files as they have them: answered right, or refused with what helps
set(new_user_folder "${CMAKE_CURRENT_SOURCE_DIR}/data")
granum_new_user("a sand by name" "estimate --sand toyoura --relative-density 60% --pressure 98kPa" 0 "sand .measured laws.*G +10[0-9]\\.[0-9]* MPa")
granum_new_user("a sand by its density alone" "estimate --Dr 0.6 --pressure 100kPa" 2 "did you mean --relative-density")
granum_new_user("a loose sand" "estimate --void-ratio 0.85 --pressure 100kPa --grain-shape sand" 0 "G +8[0-9]\\.[0-9]* MPa")
granum_new_user("a dense sand" "estimate --void-ratio 0.5 --pressure 200kPa --grain-shape sand" 0 "G +18[0-9]\\.[0-9]* MPa")
granum_new_user("a porosity" "estimate --porosity 40% --pressure 100kPa --grain-shape sand" 0 "G +107 MPa")
granum_new_user("a porosity typed as void ratio" "estimate --void-ratio 0.38 --pressure 100kPa" 0 "is it a porosity, --porosity 0\\.38")
granum_new_user("very dense" "estimate --void-ratio 0.3 --pressure 100kPa" 0 "denser than sands of one size")
granum_new_user("a well graded sand" "estimate --void-ratio 0.443 --pressure 100kPa --uniformity 8" 0 "G +124 MPa")
granum_new_user("C_u as Cu" "estimate --void-ratio 0.5 --pressure 100kPa --Cu 3" 2 "did you mean --uniformity")
granum_new_user("gravel" "estimate --void-ratio 0.4 --pressure 100kPa --uniformity 20 --d50 10mm" 0 "a C_u of 20 lies outside")
granum_new_user("K_0" "estimate --void-ratio 0.7 --stress-v 200kPa --k0 0.5 --grain-shape sand" 0 "G_vh +[0-9.]+ MPa")
granum_new_user("K0 in capitals" "estimate --void-ratio 0.7 --stress-v 200kPa --K0 0.5 --grain-shape sand" 2 "did you mean --k0")
granum_new_user("strain" "estimate --void-ratio 0.7 --pressure 100kPa --strain 0.01%" 0 "G/G0 +0\\.799")
granum_new_user("strain as a number" "estimate --void-ratio 0.7 --pressure 100kPa --strain 1e-4" 0 "G/G0 +0\\.799")
granum_new_user("large strain" "estimate --void-ratio 0.7 --pressure 100kPa --strain 2%" 0 "strength governs")
granum_new_user("strain of 10 %" "estimate --void-ratio 0.7 --pressure 100kPa --strain 10%" 2 "strain = 0\\.1 is outside \\(0, 0\\.05")
granum_new_user("fines" "estimate --void-ratio 0.7 --pressure 100kPa --fines 12%" 0 "12 % of fines")
granum_new_user("fines of beads" "estimate --void-ratio 0.65 --pressure 100kPa --grain-shape sphere --fines 20%" 2 "--fines is silt and clay")
granum_new_user("fines in per cent" "estimate --void-ratio 0.7 --pressure 100kPa --fines 12" 2 "write 12% for per cent")
granum_new_user("more than half of fines" "estimate --void-ratio 0.7 --pressure 100kPa --fines 0.6" 2 "0.6 is outside .0, 0.5.: with more it is silt or clay, no sand\n")
granum_new_user("OCR" "estimate --void-ratio 0.7 --pressure 100kPa --ocr 4" 2 "overconsolidation and age are not modelled")
granum_new_user("cement" "estimate --void-ratio 0.7 --pressure 100kPa --cement 2%" 0 "all at the contacts +[0-9.]+ GPa")
granum_new_user("100 Pa" "estimate --void-ratio 0.7 --pressure 100Pa" 0 "did you mean 100 kPa")
granum_new_user("G_g in MPa" "estimate --void-ratio 0.7 --pressure 100kPa --grain-shear-modulus 44MPa" 0 "did you mean 44 GPa")
granum_new_user("C_n 8" "estimate --void-ratio 0.6 --pressure 100kPa --coordination-number 8" 0 "no packing of equal spheres[^\n]*has so many contacts")
granum_new_user("saturated sand" "estimate --sand toyoura --void-ratio 0.75 --pressure 100kPa --saturation 100%" 0 "V_p +1[56][0-9][0-9]")
granum_new_user("ground" "sweep --sand toyoura --relative-density 60% --depth 0m..20m --water-table 2m --points 3" 0 "sand .measured laws.")
granum_new_user("a path with laws" "sweep --sand toyoura --void-ratio 0.7 --from 50kPa --to 400kPa --points 2 --laws" 0 "G_kokusho_MPa")
granum_new_user("a table with a decimal comma" "sweep --table engineer_boreholes.csv --grain-shape sand" 1 "error: [^\n]*states failed")
granum_new_user("a table with tabs" "sweep --table engineer_table_tabs.csv --grain-shape sand" 0 "A\t0\\.65\t100\t[^\n]*\tsand")
granum_new_user("a table with D_r and limits" "sweep --table engineer_table_Dr_percent_emin_emax.csv" 0 "A,60,[^\n]*,sand")
granum_new_user("a table with a per cent cell" "sweep --table engineer_table_percent_cell.csv --grain-shape sand" 0 "a mean stress of 16\\.26 MPa lies far outside")
granum_new_user("V_s without error" "infer --sand toyoura --void-ratio 0.75 --pressure 100kPa --vs 240m/s --predict-pressure 400kPa" 0 "assumed --measurement-error 2 %")
granum_new_user("V_s and V_p" "infer --grain-shape sand --void-ratio 0.7 --pressure 100kPa --vs 250m/s+-1% --vp 400m/s+-1%" 0 "nu +0\\.1[0-9]*")
granum_new_user("cemented ground" "infer --grain-shape sand --void-ratio 0.5 --pressure 100kPa --vs 800m/s" 0 "cemented")
granum_new_user("a cemented log" "infer --table engineer_cemented_log_10_rows.csv --grain-shape sand" 0 "the ground is cemented")
granum_new_user("p and G without e" "fit engineer_p_G_without_e.csv" 0 "no void ratio: f.e. = 1 is used")
granum_new_user("an empty cell" "fit engineer_fit_one_blank_G.csv" 0 "1 of 5 rows have an empty cell")
granum_new_user("sigma'v" "fit engineer_fit_primed_headings.csv" 0 "m +0\\.[0-9]+")
granum_new_user("G in kPa" "fit engineer_fit_kPa_slip.csv" 0 "did you mean 149 MPa")
granum_new_user("a forecast by name" "infer --sand hostun --void-ratio 0.7 --pressure 50kPa --shear-modulus 70MPa+-3% --predict-pressure 100kPa,400kPa" 0 "predicted at p' = 400 kPa")
granum_new_user("beads" "estimate --grain glass --void-ratio 0.6 --pressure 100kPa" 0 "beads .spheres of the model.")
granum_new_user("a shape of grains misspelt" "estimate --grain-shape sands --void-ratio 0.6 --pressure 100kPa" 2 "sphere or sand")
granum_new_user("a depth" "estimate --sand toyoura --relative-density 60% --depth 10m" 2 "did you mean --stress-v[^\n]*granum sweep --depth")
granum_new_user("blows of a penetration test" "estimate --N60 15 --pressure 100kPa" 2 "penetration tests are not modelled")
granum_new_user("a relative density of 60" "estimate --relative-density 60 --pressure 100kPa" 2 "write 60% for per cent")
granum_new_user("a pressure in bar" "estimate --void-ratio 0.7 --pressure 1bar --grain-shape sand" 0 "p' = 100 kPa")
granum_new_user("a dry density" "estimate --dry-density 1600kg/m3 --pressure 100kPa" 2 "e = rho_s/rho_d - 1")
granum_new_user("a shell sand" "estimate --void-ratio 0.9 --pressure 100kPa --grain calcite --grain-shape sand" 0 "scatter by a factor of 1\\.6")
granum_new_user("a sand that nobody knows here" "estimate --sand monterey --relative-density 50% --pressure 100kPa" 2 "known are toyoura, ottawa")
granum_new_user("a depth without units" "sweep --depth 0..30 --void-ratio 0.7" 2 "--depth = 0 has no unit; write 0m")
granum_new_user("ground water as gwt" "sweep --depth 0m..30m --void-ratio 0.7 --gwt 2m" 2 "did you mean --water-table")
granum_new_user("K_0 of a measured speed" "infer --vs 200m/s --void-ratio 0.7 --stress-v 100kPa --k0 0.5" 0 "sigma_h = 50 kPa")
granum_new_user("water in the layers' file" "sweep --layers engineer_layers_water.csv --depth 0m..12m --points 4" 0 "below 2 m 1[89][0-9.]*[ \n]+kN/m3")
granum_new_user("measured speeds beside a table's states" "sweep --table engineer_speeds.csv --grain-shape sand" 0 "1 of 3 states[^\n]*cemented")

# Wider gradings than any that was tested, by each door.
granum_cli_test("sands: C_u of 25" EXIT 2 STDERR "= 25 is outside \\[1, 20\\]" ARGS estimate --grain-shape sand --void-ratio 0.4 --pressure 100kPa --uniformity 25)
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/wide.csv" "e,p_kPa,C_u\n0.4,100,25\n0.4,100,15\n")
granum_cli_test("sands: C_u of 25 in a row" EXIT 1 STDERR "line 2: [^\n]*25 is outside" STDOUT "." ARGS sweep --table "${CMAKE_CURRENT_BINARY_DIR}/wide.csv")
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/wide_sieve.csv" "d_mm,passing_%\n0.063,0\n0.1,12\n1,40\n4,65\n8,100\n")
granum_cli_test("sands: C_u of a sieve curve" EXIT 2 STDERR "is outside \\[1, 20\\]" ARGS estimate --sieve "${CMAKE_CURRENT_BINARY_DIR}/wide_sieve.csv"
  --void-ratio 0.4 --pressure 100kPa)
