# SPDX-License-Identifier: GPL-3.0-or-later
set(packing --void-ratio 0.558 --coordination-number 5.73)
set(iso sweep ${packing} --from 10kPa --to 1MPa --points 3)

# states on the paths: both ends, and what each path holds constant
granum_cli_test("sweep: isotropic" EXIT 0 JSON "states/0/p=^10000(\\.0)?$" "states/1/p=^100000(\\.0)?$" "states/2/p=^1000000(\\.0)?$"
  "states/1/q=^0(\\.0)?$" "states/1/eta=^0(\\.0)?$" "states/1/sigma_v=^100000(\\.0)?$" "states/1/error=^$"
  "states/1/notes=^\\[ *\\]$" "notes=assumed --fabric 0 \\+- 0\\.05" ARGS ${iso} --json)
granum_cli_test("sweep: linear spacing" EXIT 0 JSON "states/1/p=^505000(\\.0)?$" ARGS ${iso} --spacing linear --json)
granum_cli_test("sweep: from zero, linear" EXIT 0 JSON "states/0/rung2/G_hv=^0(\\.0)?$" "states/0/rung0/n=^0\\.1111111111111"
  "states/0/answer/shear_modulus/high=^0(\\.0)?$" "states/0/answer/stress_exponent=^$" "states/1/answer/stress_exponent/value=^0\\.3"
  ARGS sweep ${packing} --from 0Pa --to 1MPa --points 3 --spacing linear --json)
# eta = 0.6: v = 1.4 p', h = 0.8 p'; eta = -0.6: v = 0.6 p', h = 1.2 p'
foreach(expectation "txc;0.6;v=^(140000|139999\\.9999999)" "txc;0.6;h=^80000(\\.0)?$" "rtxc;0.6;v=^80000(\\.0)?$"
    "rtxc;0.6;h=^4571[45]\\." "rtxe;-0.6;v=^(40000|39999\\.9999999)" "rtxe;-0.6;h=^80000(\\.0)?$"
    "txe;-0.6;v=^80000(\\.0)?$" "txe;-0.6;h=^(160000|159999\\.9999999)")
  list(GET expectation 0 path)
  list(GET expectation 1 eta)
  list(GET expectation 2 stress)
  granum_cli_test("sweep: end of ${path}, sigma_${stress}" EXIT 0 JSON "states/4/sigma_${stress}"
    ARGS sweep ${packing} --path ${path} --from 80kPa --eta ${eta} --points 5 --json)
endforeach()
granum_cli_test("sweep: a path ends at failure" EXIT 0 STDERR "state 2: stress ratio 3 " JSON "states/1/eta=^1\\.(2$|2000000000000|1999999999999)"
  ARGS sweep ${packing} --path txc --from 80kPa --friction-angle 30deg --points 2 --json)
granum_cli_test("sweep: a path in words" EXIT 0 JSON "path=^RTXE from 80 kPa to eta = -0\\.6$"
  ARGS sweep ${packing} --path rtxe --from 80kPa --eta -0.6 --points 2 --json)

# rungs: at the mean force s is shared as sigma_v and 2 sigma_h share 3 p'; here 1.4/3 and 1.6/3
set(far_fabric STDERR "fabric anisotropy 0\\.5 ")
set(txc sweep ${packing} --fabric 0.5 --path txc --from 80kPa --eta 0.6 --points 2 --json)
granum_cli_test("sweep: exponents of rungs 0 and 1" EXIT 0 ${far_fabric}
  JSON "states/1/rung0/n=^0\\.1555555555555" "states/1/rung0/m=^0\\.1777777777777" "states/1/rung1/n=^0\\.1555555555555"
  "states/1/rung1/m=^0\\.1777777777777" ARGS ${txc})
# Contacts of one stiffness, a = 1/2, r = 0.9, as in the tests of estimate; rung 0 leaves the fabric out:
# G = C_n k_n (1 + 1.5 r)/(10 pi R (1+e)).
set(flat sweep --contact flat --punch-radius 50um --void-ratio 0.558 --coordination-number 5.73 --tangential-ratio 0.9 --from 1kPa --to 100kPa
  --points 2 --json)
granum_cli_test("sweep: fabric of rungs 0 and 1" EXIT 0 ${far_fabric} JSON "states/1/rung1/E_v=^5264800774\\.0791"
  "states/1/rung1/E_h=^3312112348\\.5494" "states/0/rung0/G_hv=^1941947491\\.840" ARGS ${flat} --fabric 0.5)
granum_cli_test("sweep: rung 0 without fabric" EXIT 0 JSON "states/0/rung0/G_hv=^1941947491\\.840" ARGS ${flat} --fabric 0)
granum_cli_test("sweep: only the chosen rungs" EXIT 0 STDOUT "\np_kPa,q_kPa,eta,sigma_v_kPa,sigma_h_kPa,e,C_n,a,G_answer_MPa,G_low_MPa,G_high_MPa,[^\n]*,s_answer,s_low,s_high,G_hh_rung0_MPa,[^\n]*s_rung0,G_hh_uniform_stress_MPa,[^\n]*,notes,error,grain_shape[^\n]*\n10,"
  ARGS ${iso} --rungs uniform-stress,0)
granum_cli_test("sweep: assumptions are noted" EXIT 0 STDOUT "# note: assumed --grain-shear-modulus 30 GPa \\+- 9 GPa.*# note: assumed --fabric 0 \\+- 0\\.05"
  ARGS ${iso})
# Every state of a path has the answer, and its rungs the contacts of it: they grow where none is told.
granum_cli_test("sweep: the answer of a preparation in water, all of its columns" EXIT 0
  STDOUT "\np_kPa,[^\n]*,a,G_answer_MPa,[^\n]*,K_answer_MPa,[^\n]*,density_low_kg/m3,[^\n]*,C_n_high,[^\n]*n_answer,[^\n]*,s_high,[^\n]*G_hh_rung3_MPa,[^\n]*,notes,error,grain_shape[^\n]*\n10,0,0,10,10,0\\.56,5\\.[0-9]*,0,[1-9]"
  ARGS sweep --void-ratio 0.56 --from 10kPa --to 100kPa --points 2 --preparation dense --saturation 100% --grain-density 2700kg/m3
    --columns all --rungs 3)
granum_cli_test("sweep: the same in JSON" EXIT 0 JSON "states/0/answer/preparation=^dense$" "states/0/answer/saturation=^1(\\.0)?$"
  "states/0/answer/grain_density=^2700(\\.0)?$" "states/1/answer/compression_wave_speed/value=^1[67]" "states/1/rung3/G_hv=^[1-9]"
  ARGS sweep --void-ratio 0.56 --from 10kPa --to 100kPa --points 2 --preparation dense --saturation 100% --grain-density 2700kg/m3
    --json)
granum_cli_test("sweep: notes of states" EXIT 0 STDOUT "coordination number exceeds 12.*coordination number exceeds 12"
  STDERR "^granum: warning: 3 of 3 states lie outside [^\n]*state 1: coordination number exceeds 12[^\n]*\n$"
  ARGS sweep --void-ratio 0.6 --coordination-number 13 --from 10kPa --to 1MPa --points 3)
granum_cli_test("sweep: notes fail under --strict" EXIT 4 STDOUT "p_kPa,q_kPa" STDERR "^granum: error: 3 of 3 states lie"
  ARGS sweep --void-ratio 0.6 --coordination-number 13 --from 10kPa --to 1MPa --points 3 --strict)
granum_cli_test("sweep: a state that fails leaves the others" EXIT 1 STDOUT "\n100,0,0,100,100,[^\n]*,,sphere\n33\\.334[^\n]*,,,,[^\n]*,\"ratio of vertical to horizontal"
  STDERR "^granum: error: 1 of 2 states failed, see error; state 2: ratio of vertical"
  ARGS sweep ${packing} --path rtxc --from 100kPa --eta 2.9999 --points 2)
granum_cli_test("sweep: no shear stiffness has empty exponents" EXIT 0 JSON "states/0/uniform_stress/s=^$"
  STDERR "warning: 3 of 3 states lie outside" ARGS ${iso} --tangential-ratio 0 --json)

# tables: the answer of each row, and the rungs that are asked for
set(table sweep --table sweep_states.csv --rungs 2)
set(four_of_nine "2 of 9 states lie outside[^\n]*\ngranum: error: 4 of 9 states failed, see error; line 5: stress_h = -100000")
foreach(line "sample,contact,e,C_n,a,sigma_v_kPa,sigma_h_kPa,slope,G_answer_MPa,G_low_MPa,G_high_MPa,V_s_answer_m/s,[^\n]*,z_star_high,s_answer,s_low,s_high,G_hh_rung2_MPa" "\"S1, top\",sphere,0\\.558,5\\.73,0\\.1,200,100,,2"
    "S3,[^\n]*\"stress_h = -100000 Pa is outside" "S4,sphere,0\\.558,,0,100,100,,[0-9.]+,[0-9.]+,[0-9.]+,[^\n]*,,sphere\n" "S5,[^\n]*contact 'egg' is not one of cone"
    "S6,[^\n]*expected a finite number in column 'e', found 'dense'" "S7,[^\n]*--slope goes with --contact cone"
    "S8,[^\n]*coordination number exceeds 12" "S1[^\n]*\nS2[^\n]*\nS3[^\n]*\nS4[^\n]*\nS5[^\n]*\nS6[^\n]*\nS7[^\n]*\nS8[^\n]*\nS9[^\n]*\n$"
    "# note: unused columns: sample\n")
  granum_cli_test("sweep: table, ${line}" EXIT 1 STDOUT "${line}" STDERR "${four_of_nine}" ARGS ${table})
endforeach()
granum_cli_test("sweep: table as JSON" EXIT 1 BELOW "states/" JSON
    "2/error=stress_h" "2/rung2/K=^$" "2/answer=^$" "1/rung2/s=^0\\.(5$|4999999999999|50000000000000)" "8/line=^11$"
  STDERR "${four_of_nine}"
    ARGS ${table} --json)
granum_cli_test("sweep: a table has only the answers unless rungs are requested" EXIT 0
  STDOUT "\np_kPa,e,[^\n]*,V_p_high_m/s,z_star_answer,z_star_low,z_star_high,s_answer,s_low,s_high,notes,error,grain_shape" ARGS sweep --table sweep_few.csv)
granum_cli_test("sweep: all columns of a table" EXIT 0 STDOUT ",rattlers_high,C_n_answer,[^\n]*,s_high,[^\n]*G_hh_rung0_MPa,[^\n]*,G_hv_rung3_MPa,[^\n]*,s_uniform_stress,notes,error,grain_shape"
  ARGS sweep --table sweep_few.csv --columns all)

# Headings and numbers as people write them: a byte order mark, CRLF, semicolons, decimal commas, units in brackets.
set(people sweep --table sweep_people.csv --grain-shape sphere)
granum_cli_test("sweep: a table of a spreadsheet" EXIT 0 STDOUT "\nA;0,65;100;50;;;dense;;1[0-9,]+;[^\n]*\nB;0,7;1,5e2;75;5,2;;;;"
  STDERR "1 of 5 states lie outside [^\n]*line 4: contacts of unequal grains" ARGS ${people})
granum_cli_test("sweep: rung 3 and preparation of rows" EXIT 0 STDERR "1 of 5" JSON "states/3/rung3/G_hv=^[1-9]" "states/0/rung3/G_hv=^[1-9]"
  "states/0/answer/preparation=^dense$" "states/1/answer/preparation=^unknown$" "states/1/answer/mechanical_coordination_number/low=^5\\.2"
  ARGS ${people} --json)
granum_cli_test("sweep: no such preparation" EXIT 1 STDOUT "preparation 'tapped' is unknown" STDERR "line 3: preparation 'tapped'"
  ARGS sweep --table sweep_tapped.csv)
granum_cli_test("sweep: two columns of one number" EXIT 3
  STDERR "sweep_twice\\.csv:[0-9]+: columns 1 and 2, 'e' and 'void_ratio', both contain void_ratio" ARGS sweep --table sweep_twice.csv)
granum_cli_test("sweep: two kinds of separators" EXIT 3 STDERR "sweep_mixed\\.csv:1: the headings are separated by commas and by semicolons"
  ARGS sweep --table sweep_mixed.csv)
granum_cli_test("sweep: decimal commas between commas" EXIT 3 STDERR "sweep_commas\\.csv:2: expected 2 fields [^\n]* with decimal commas, separate the fields by semicolons"
  ARGS sweep --table sweep_commas.csv)
granum_cli_test("sweep: a preparation is an option and a column" EXIT 2 STDERR "--preparation is given as an option and by the column 'preparation'"
  ARGS sweep --table sweep_tapped.csv --preparation dense)
granum_cli_test("sweep: options replace missing columns of a table" EXIT 0 STDERR "^granum: note: unused columns: [^\n]*\n$" JSON "states/0/rung0/s=^0\\.5"
  ARGS sweep --table isotropic.csv --contact cone --json)

function(granum_sweep_refuses what message)
  granum_cli_test("sweep: ${what}" EXIT 2 STDERR "^granum: error: ${message}" ARGS sweep ${ARGN})
endfunction()
granum_sweep_refuses("no path and no table" "give --from, the mean stress at the start of a path, or --depth" ${packing})
granum_sweep_refuses("no end" "--to is missing" ${packing} --from 10kPa)
granum_sweep_refuses("no stress to begin with" "--from = 0 Pa is outside" ${packing} --path txc --from 0kPa --eta 0.5)
granum_sweep_refuses("no eta" "give one of --eta and --friction-angle" ${packing} --path txc --from 10kPa)
granum_sweep_refuses("eta and angle" "give one of --eta and --friction-angle"
  ${packing} --path txc --from 10kPa --eta 0.5 --friction-angle 20deg)
granum_sweep_refuses("eta of the isotropic path" "--eta goes with --path txc" ${packing} --from 1kPa --to 2kPa --eta 0.5)
granum_sweep_refuses("end of a shear path as stress" "--to goes with --path iso" ${packing} --path txe --from 1kPa --to 2kPa)
granum_sweep_refuses("eta of the wrong sign" "--eta = 0\\.5 is outside .-1\\.5, 0. of TXE"
  ${packing} --path txe --from 10kPa --eta 0.5)
granum_sweep_refuses("angle that no material has" "--friction-angle = 90 deg [^\n]*\\(0, 90\\)" ${packing} --path txc --from 1kPa
  --friction-angle 90deg)
granum_sweep_refuses("angle without unit" "--friction-angle = 26 has no unit" ${packing} --path txc --from 1kPa
  --friction-angle 26)
granum_sweep_refuses("log spacing from zero" "--from = 0 has no logarithm; use --spacing linear"
  ${packing} --from 0Pa --to 1kPa)
granum_sweep_refuses("log spacing in eta" "--spacing log goes with --path iso"
  ${packing} --path txc --from 1kPa --eta 0.5 --spacing log)
granum_sweep_refuses("negative start" "--from = -1000 Pa is outside" ${packing} --from -1kPa --to 1kPa)
granum_sweep_refuses("one point" "--points: 1 is not in the range 2 to 1000000" ${packing} --from 1kPa --to 2kPa --points 1)
granum_sweep_refuses("unknown rung" "--rungs: 7 not in {0,1,2,3,uniform-stress}" ${packing} --from 1kPa --to 2kPa --rungs 0,7)
granum_sweep_refuses("unknown path" "--path: iss not in" ${packing} --path iss --from 1kPa --to 2kPa)
granum_sweep_refuses("stress of a path" "--pressure goes with --table or --for; the stress of a path begins at --from"
  ${packing} --from 1kPa --to 2kPa --pressure 1kPa)
granum_sweep_refuses("an impossible packing once" "--void-ratio = -1 is outside[^\n]*\n$" --void-ratio -1 --from 1kPa --to 2kPa)
granum_sweep_refuses("no density" "the density is missing" --from 1kPa --to 2kPa)
granum_sweep_refuses("path and table" "--from excludes --table" --table isotropic.csv --from 1kPa)
granum_sweep_refuses("option and column" "--void-ratio is given as an option and by the column 'e'"
  --table isotropic.csv --void-ratio 0.6)
granum_sweep_refuses("picture of another kind" "--picture = 'a\\.png' must end in \\.svg"
  ${packing} --from 1kPa --to 2kPa --out a.csv --picture a.png)

# what a row leaves empty has its default, as without the column
add_test(NAME "cli: sweep: empty fields"
  COMMAND "${CMAKE_CURRENT_SOURCE_DIR}/check_empty_fields.sh" "$<TARGET_FILE:granum_cli>" "${CMAKE_CURRENT_BINARY_DIR}/empty fields")
set_tests_properties("cli: sweep: empty fields" PROPERTIES LABELS cli)
granum_cli_test("sweep: thousands or decimals" EXIT 3 STDERR "sweep_thousands\\.csv:3: column 'p \\(kPa\\)'"
  ARGS sweep --table sweep_thousands.csv)
granum_cli_test("sweep: missing table" EXIT 3 STDERR "none\\.csv: cannot be read: No such file" ARGS sweep --table none.csv)
granum_cli_test("sweep: truncated table" EXIT 3 STDERR "truncated\\.csv:5: expected 4 fields" ARGS sweep --table truncated.csv)
granum_cli_test("sweep: column without unit" EXIT 3 STDERR "sweep_unitless\\.csv:1: column 'sigma_v' has no unit"
  ARGS sweep --table sweep_unitless.csv)
granum_cli_test("sweep: a column of the results is there" EXIT 3 STDERR "sweep_again\\.csv: already has a column 'K_rung2_Pa'"
  ARGS sweep --table sweep_again.csv --columns all --units si)
granum_cli_test("sweep: unwritable output" EXIT 3 STDERR "no such folder/s\\.csv: cannot be written"
  ARGS ${iso} --out "no such folder/s.csv")
granum_cli_test("sweep: existing output is kept" EXIT 3 STDERR "isotropic\\.csv: exists already and is kept"
  ARGS sweep --table isotropic.csv --out isotropic.csv)

add_test(NAME "cli: sweep: files, and the same numbers as estimate" WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/data"
  COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:granum_cli>" "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/sweep files"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/check_sweep.cmake")
set_tests_properties("cli: sweep: files, and the same numbers as estimate" PROPERTIES LABELS cli)

granum_cli_test("sweep: all rungs of a path" EXIT 0 STDOUT ",s_rung2,G_hh_rung3_MPa,"
  ARGS sweep --void-ratio 0.56 --from 10kPa --to 100kPa --points 2)

# k_t = k_n: rung 3 stays
granum_cli_test("sweep: rung 3 at k_t = k_n" EXIT 0 JSON "states/1/rung3/s=^0\\.33307"
  ARGS ${iso} --tangential-ratio 1 --rattler-fraction 2% --json)

# A state below the pressure of preparation is refused, the others are answered: on a path, of a table, at depths and in layers.
set(prepared --grain-shape sphere --preparation dense:50kPa)
set(below STDERR "pressure of preparation = 50000 Pa is outside \\(0, ")
granum_cli_test("sweep: states below the preparation" EXIT 1 ${below} JSON "states/0/answer=^$" "states/0/error=^pressure of preparation"
  "states/1/error=^$" "states/1/answer/shear_modulus/value=^1[0-9]+" ARGS sweep --void-ratio 0.6 ${prepared} --from 10kPa --to 1MPa --points 3 --json)
granum_cli_test("sweep: none is above the preparation" EXIT 2 ${below} ARGS sweep --void-ratio 0.6 ${prepared} --from 1kPa --to 10kPa --points 2)
granum_cli_test("sweep: a sand and beads below the preparation" EXIT 0 STDERR "state 1: beads: pressure of preparation"
  JSON "states/0/answer/grain_shape=^sand$" "states/0/notes/0=^beads: pressure" "states/1/answer/grain_shape=^sphere$"
  "states/1/sand_answer/grain_shape=^sand$" "inputs/grain_shear_modulus=^30000000000" ARGS sweep --void-ratio 0.6 --preparation dense:50kPa
  --from 10kPa --to 1MPa --points 3 --json)
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/prepared.csv" "e,p_kPa\n0.6,20\n0.6,100\n")
granum_cli_test("sweep: rows below the preparation" EXIT 1 ${below} JSON "states/0/error=^pressure of preparation" "states/1/error=^$"
  "notes/0=assumed --contact" ARGS sweep --table "${CMAKE_CURRENT_BINARY_DIR}/prepared.csv" ${prepared} --json)
granum_cli_test("sweep: depths below the preparation" EXIT 1 ${below} STDOUT "\n +2 [^\n]* -  +- [^\n]*-\n +10 [^\n]*\\([0-9]+-" ARGS sweep
  --void-ratio 0.6 ${prepared} --depth 2m..10m --points 2)
granum_cli_test("sweep: no depth is above the preparation" EXIT 2 STDERR "at 1 m: pressure of preparation" ARGS sweep --void-ratio 0.6 ${prepared}
  --depth 1m..2m --points 2)
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/prepared_layers.csv" "top_m,e,preparation\n0,0.6,loose\n5,0.58,dense:60kPa\n")
granum_cli_test("sweep: layers have their preparation" EXIT 0 STDOUT "From 0 m: contacts: [^\n]* preparation loose\n +From 5 m: [^\n]* dense:60kPa\n"
  ARGS sweep --grain-shape sphere --depth 2m..10m --points 3 --layers "${CMAKE_CURRENT_BINARY_DIR}/prepared_layers.csv")

granum_cli_test("sweep: the densest packing is made once" EXIT 0 JSON "inputs/least_void_ratio=^0\\.5[67]" "states/1/answer/mechanical_coordination_number/value=^4"
  ARGS sweep --void-ratio 0.65 --grain-shape sphere --densest made --from 10kPa --to 100kPa --points 2 --json)
granum_cli_test("sweep: rows have their own densest packing" EXIT 2 STDERR "column least_void_ratio" ARGS sweep --densest made --grain-shape sphere
  --table "${CMAKE_CURRENT_BINARY_DIR}/prepared.csv")
