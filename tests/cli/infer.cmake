# SPDX-License-Identifier: GPL-3.0-or-later
# What estimate says of known contacts gives the contacts back: C_n = 5 and 2 % of rattlers make z* = 5.1020408163265.
set(packing --grain-shape sphere --void-ratio 0.6 --pressure 100kPa)
set(G 122892352.46641797Pa)
set(glass --grain-shear-modulus 29GPa --grain-poisson-ratio 0.2 --radius 0.05mm --grain-density 2480kg/m3)
set(beads infer --grain-shape sphere --void-ratio 0.613 --pressure 2.76MPa ${glass})
granum_cli_test("infer: there and back" EXIT 0 JSON
    "answer/mechanical_coordination_number/value=^5\\.10204081(6326|6327)"
    "answer/coordination_number/value=^(5\\.0$|5\\.0000000000|4\\.999999999)"
    "answer/rattler_fraction/standard_error=^0(\\.0)?$" "predictions/0/K/value=^1626017(11\\.|10\\.9)"
    "predictions/0/G/value=^1228923(52\\.|51\\.9)" "measurements/0/explained=^yes$" "reference_stress=^100000(\\.0)?$"
    "degrees_of_freedom=^0$" "growth_exponent=^$" "error_shares/rung 3=^0\\.0"
  ARGS infer ${packing} --shear-modulus ${G} --rattler-fraction 2% --json)
granum_cli_test("infer: table" EXIT 0 STDERR "prediction at p' = 34\\.47 MPa"
  STDOUT "^Contacts implied by measured stiffness.*V_s +587 m/s \\+- +1 %.*\n  z\\* +5\\.7.*\n  shares in the variance of z\\*: rung 3 .*\npredicted at p' = 34\\.47 MPa, e = 0\\.5[0-9]*\n  z\\* [^\n]*\n  G +[0-9.]+ .Pa [^\n]*\n  K +[0-9.]+ .Pa [^\n]*\n  V_s +[0-9.]+ m/s [^\n]*\n  V_p +[0-9.]+ m/s "
  ARGS ${beads} --vs 587m/s+-1% --predict-pressure 34.47MPa)
granum_cli_test("infer: a prediction outside of the calibration has a warning, and fails under --strict" EXIT 4
  STDOUT "predicted at p' = 1 GPa" STDERR "prediction at p' = 1 GPa"
  ARGS ${beads} --vs 587m/s --predict-pressure 1GPa --strict)
granum_cli_test("infer: no prediction where no pores are left" EXIT 2
  STDERR "--predict-pressure.*-0\\.[0-9]"
  ARGS ${beads} --vs 587m/s --predict-pressure 10000GPa)
granum_cli_test("infer: directions are distinguished under unequal stresses" EXIT 0 STDOUT "\n  G +[^\n]*\n  G_hh +[^\n]*\n  K "
  ARGS ${beads} --vs 587m/s+-1% --predict-stress-ratio 0.5)
granum_cli_test("infer: an absolute error" EXIT 0 JSON "measurements/0/standard_error=^5(\\.0)?$" ARGS ${beads} --vs 587m/s±5m/s --json)
granum_cli_test("infer: an error for all" EXIT 0 JSON "measurements/0/standard_error=^11\\.74$"
  ARGS ${beads} --vs 587m/s --measurement-error 2% --json)
granum_cli_test("infer: fixed contacts keep the void ratio" EXIT 0 STDERR "prediction at" JSON "predictions/0/void_ratio=^0\\.61(3$|2999999|3000000)"
  ARGS ${beads} --vs 587m/s --predict-pressure 30MPa --growth fixed --json)
granum_cli_test("infer: another packing, prepared alike" EXIT 0 JSON "predictions/0/mechanical_coordination_number/value=^5\\.[23]"
  ARGS ${beads} --vs 587m/s --predict-void-ratio 0.65 --json)
granum_cli_test("infer: uncertain inputs have their share" EXIT 0 BELOW "error_shares/" JSON
    "grain-shear-modulus=^0\\.3" "grain-poisson-ratio=^0\\.2" "grain-density=^0\\.02" "void-ratio=^0\\.001"
  ARGS ${beads} --vs 587m/s --uncertainty grain-shear-modulus=5% --uncertainty grain-poisson-ratio=0.05
      --uncertainty grain-density=20kg/m3 --uncertainty void-ratio=0.01 --measurement-error 0% --json)
granum_cli_test("infer: assumed inputs are uncertain" EXIT 0 STDOUT "in the variance of z\\*: grain-shear-modulus 9.*- assumed --grain-shear-modulus 30 GPa \\+- 9 GPa, [^\n]*\n[^-]*- .*- assumed --grain-density 2650 kg/m3 \\+- 50 kg/m3"
  ARGS infer ${packing} --vs 280m/s+-2%)
granum_cli_test("infer: their deviations" EXIT 0 JSON "assumed/grain_shear_modulus/deviation=^90+(\\.0)?$" "assumed/fabric/deviation=^0\\.05"
  "assumed/radius/deviation=MISSING" ARGS infer ${packing} --vs 280m/s+-2% --json)
granum_cli_test("infer: the deviation that a mineral has" EXIT 0 STDOUT "standard deviation of grain-shear-modulus: 1\\.32 GPa"
  ARGS infer --void-ratio 0.6 --pressure 100kPa --grain quartz --grain-shape sphere --vs 250m/s+-2%)
granum_cli_test("infer: exact measurements are possible" EXIT 0 JSON "error_shares/rung 3=^(1\\.0|0\\.9)"
  ARGS infer ${packing} --shear-modulus ${G} --rattler-fraction 2% --uncertainty grain-shear-modulus=0% --uncertainty fabric=0
    --uncertainty grain-poisson-ratio=0 --measurement-error 0% --json)
granum_cli_test("infer: a sand by its name, below water" EXIT 0 JSON "inputs/grain_shear_modulus=^44000000000"
  ARGS infer --sand toyoura --relative-density 60% --pressure 98kPa --vs 240m/s --saturation 100% --json)
granum_cli_test("infer: no compression wave is predicted in wet pores" EXIT 0 STDOUT "\n  K +[^\n]*\n  V_s +[^\n]*\n\n"
  ARGS ${beads} --vs 530m/s --saturation 100%)
granum_cli_test("infer: table of measurements" EXIT 0 JSON "degrees_of_freedom=^7$"
  STDERR "measurements contradict each other"
  ARGS infer --table beads_speeds.csv --porosity 0.38 ${glass} --measurement-error 1% --growth fitted --json)

granum_cli_test("infer: K and G that contradict each other" EXIT 4 STDOUT "chi\\^2 .*of the measurements"
  STDERR "^granum: error: the measurements contradict each other: [^\n]*V_p = 838 m/s at 2760 kPa, [0-9.]+ standard errors softer[^\n]*\n$"
  ARGS ${beads} --vs 587m/s+-1% --vp 838m/s+-1% --strict)
granum_cli_test("infer: too stiff for any contacts" EXIT 1 STDOUT "V_s +1587 m/s \\+- 2 % +none"
  STDERR "no coordination number explains V_s = 1587 m/s at 2760 kPa: with 12 contacts[^\n]*\ngranum: error: no measurement can be explained"
  ARGS ${beads} --vs 1587m/s)
granum_cli_test("infer: too soft for any contacts" EXIT 1 JSON "measurements/0/explained=^too soft$"
  STDERR "the loosest rigid network of contacts would have" ARGS ${beads} --bulk-modulus 100MPa --json)
granum_cli_test("infer: more contacts than usual at that void ratio" EXIT 0 JSON "measurements/0/explained=^yes$"
  STDERR "is larger than in packings of spheres of void ratio 0.613 at this stress" ARGS ${beads} --vs 750m/s --json)

function(granum_infer_refuses what message)
  granum_cli_test("infer: ${what}" EXIT 2 STDERR "^granum: error: ${message}" ARGS infer ${ARGN})
endfunction()
granum_infer_refuses("nothing measured" "no measurement is given: use --shear-modulus" ${packing})
granum_infer_refuses("a compression wave in water" "a compression wave in wet pores travels mainly in the water" ${packing} --vp 1600m/s
  --saturation 100%)
granum_infer_refuses("a picture of a quantity that is not predicted" "--picture-of V_p: no compression wave in wet pores" ${packing} --vs 200m/s
  --saturation 100% --picture a.svg --picture-of V_p)
granum_infer_refuses("a prediction of a sand without grains" "--predict-void-ratio = 4 is outside \\(0, 2\\.97\\)"
  --grain-shape sand --void-ratio 0.6 --pressure 100kPa --vs 280m/s --predict-void-ratio 4)
foreach(shape sand sphere)
  granum_infer_refuses("a stress ratio that no ${shape} bears" "--predict-stress-ratio = 1000000000 is outside"
    --grain-shape ${shape} --void-ratio 0.6 --pressure 100kPa --vs 280m/s --predict-stress-ratio 1e9)
endforeach()
granum_infer_refuses("an error larger than the value" "--measurement-error = 5 is outside \\[0, 1\\]" ${packing} --vs 200m/s --measurement-error 5)
granum_infer_refuses("a speed without unit" "--shear-wave-speed = 200 has no unit; write 200m/s, 200km/s" ${packing} --vs 200)
granum_infer_refuses("an error without unit" "--shear-modulus error = 5 has no unit" ${packing} --shear-modulus 100MPa+-5)
granum_infer_refuses("a negative error" "--shear-modulus error = -5000000 Pa" ${packing} --shear-modulus 100MPa+--5MPa)
granum_infer_refuses("a negative modulus" "G = -100000000 Pa is outside" ${packing} --shear-modulus -100MPa)
granum_infer_refuses("an input of contacts, which are inferred" "granum infer has no option --coordination-number; --coordination-number is for granum estimate"
  ${packing} --shear-modulus 100MPa --coordination-number 5)
granum_infer_refuses("no stress" "stress = 0 Pa is outside" --grain-shape sphere --void-ratio 0.6 --pressure 0kPa --shear-modulus 100MPa)
granum_infer_refuses("growth of one measurement" "the growth of z\\* with stress can be fitted to measurements at two stresses"
  ${packing} --shear-modulus 100MPa --growth fitted)
granum_infer_refuses("an uncertainty of contacts" "--uncertainty pressure: not an input common to all measurements; these are grain-shear-modulus, "
  ${packing} --shear-modulus 100MPa --uncertainty pressure=5%)
granum_infer_refuses("an uncertainty twice" "--uncertainty void-ratio is given twice"
  ${packing} --shear-modulus 100MPa --uncertainty void-ratio=0.01 --uncertainty void-ratio=0.02)
granum_infer_refuses("options with a table" "measurements are given both by --table and by options: use one of the two"
  --table beads_speeds.csv --porosity 0.38 --vs 200m/s)
granum_infer_refuses("picture of another kind" "--picture = 'a\\.png' must end in \\.svg" ${packing} --shear-modulus 100MPa --picture a.png)
granum_cli_test("infer: a table without measurements" EXIT 3 STDERR "sweep_states\\.csv: has no column of a measured quantity"
  ARGS infer --table sweep_states.csv)
granum_cli_test("infer: a row without a stress" EXIT 3 STDERR "infer_no_stress\\.csv:4: the stress is missing"
  ARGS infer --table infer_no_stress.csv --void-ratio 0.6)
granum_cli_test("infer: existing output is kept" EXIT 3 STDERR "isotropic\\.csv: exists already and is kept"
  ARGS infer ${packing} --shear-modulus 100MPa --out isotropic.csv)

# What contacts speeds imply: more numbers than z*, each with its error, and what data cannot tell.
set(quartz --grain quartz --radius 0.1mm)
granum_cli_test("infer: contacts of both speeds" EXIT 0 STDERR "larger than in packings of spheres" JSON "contacts/kind=^power-law$" "contacts/numbers/0/key=^z\\*$" "contacts/numbers/0/value=^4\\.99"
    "contacts/numbers/0/determined=^(ON|true)$" "contacts/numbers/1/key=^softness$" "contacts/numbers/2/key=^alpha$" "contacts/correlation/1=^-0\\.[89]"
    "contacts/would_determine=^$"
  ARGS infer --table sand_speeds.csv ${quartz} --contacts power-law --json)
granum_cli_test("infer: shear waves alone do not determine contacts" EXIT 0 JSON "contacts/numbers/0/determined=^(OFF|false)$"
    "contacts/would_determine=^V_p$"
  ARGS infer --table sand_shear_speeds.csv ${quartz} --contacts power-law --json)
granum_cli_test("infer: roughness" EXIT 0 STDOUT "inferred contact law: rough.*roughness +[0-9.]+ .m \\+-"
  ARGS infer --table sand_speeds.csv ${quartz} --contacts rough)
granum_cli_test("infer: contacts that are both given and inferred" EXIT 2 STDERR "--contacts rough"
  ARGS infer ${packing} --vs 280m/s --contact cone --contacts rough)

# The growth of sands and that of spheres each belong to their kind of grains.
set(speed infer --void-ratio 0.6 --pressure 100kPa --vs 250m/s)
foreach(case "--grain-shape sand --growth fixed" "--sand toyoura --growth packings" "--grain-shape sphere --growth sand" "--grain glass --growth sand"
    "--contact cone --growth sand --grain quartz" "--uniformity 2 --growth packings" "--rattler-fraction 2% --growth sand")
  separate_arguments(words UNIX_COMMAND "${case}")
  list(GET words 0 shape)
  granum_cli_test("infer: ${case}" EXIT 2 STDERR "^granum: error: --growth [^\n]*${shape} " ARGS ${speed} ${words})
endforeach()
granum_cli_test("infer: the growth of the same kind" EXIT 0 JSON "grain_shape=^sand$" ARGS ${speed} --sand ottawa-20-30 --growth sand --json)
