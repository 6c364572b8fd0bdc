# SPDX-License-Identifier: GPL-3.0-or-later
# Curves of G/G0 and damping: granum sweep --strain FROM..TO. Their forms are checked by test_curves.cpp.
set(curve --void-ratio 0.7 --pressure 100kPa --strain 0.0001%..1%)
granum_cli_test("curves: on the screen" EXIT 0 STDERR "." STDOUT "\nstrain_percent,G_over_G0,damping_percent,[^\n]*\n0\\.0001,[^\n]*\n0\\.0002154,"
  ARGS sweep ${curve} --for table)
granum_cli_test("curves: a named sand of one state" EXIT 0 STDERR "." STDOUT "name = \"granum, toyoura, C_u 1\\.39, p. 100 kPa\"" ARGS sweep --sand toyoura
  --relative-density 60% --pressure 100kPa --strain 0.0001%..1% --for pystrata)
granum_cli_test("curves: the end that is asked, whatever its unit" EXIT 0 STDERR "." JSON "curves/1/strain=^0\\.000[12]" "curves/2/strain=^0\\.000(3|2999)" ARGS sweep
  --void-ratio 0.7 --pressure 100kPa --strain 1e-4..3e-4 --points 3 --for table --json)
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/curves.csv" "id,e,p_kPa\nA,0.7,50\nB,0.7,-5\nC,0.7,200\n")
granum_cli_test("curves: a row that fails leaves the others" EXIT 1 STDERR "unused columns: id\n.*1 of 3 states failed, see error; line 3: "
  JSON "curves/0/line=^2$" "curves/13/line=^4$" "curves/13/mean_stress=^200000" "curves/26=MISSING" "notes=unused columns: id" ARGS sweep
  --table "${CMAKE_CURRENT_BINARY_DIR}/curves.csv" --strain 0.0001%..1% --for table --json)
granum_cli_test("curves: columns of a profile" EXIT 0 STDERR "." STDOUT "\ncurve,depth_m,p_kPa,V_s_m/s,unit_weight_kN/m3,strain_percent,[^\n]*\n.granum, sand, 2 m, p. [0-9.]+ kPa.,2,"
  ARGS sweep --void-ratio 0.7 --depth 2m..9m --points 2 --strain 0.0001%..1% --for table)
granum_cli_test("curves: K_0 of a state" EXIT 0 STDERR "." STDOUT "p. 66\\.67 kPa" ARGS sweep --void-ratio 0.7 --stress-v 100kPa --k0 0.5
  --strain 0.0001%..1% --for pystrata)
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/curve.csv" "e,p_kPa\n0.7,50\n")
granum_cli_test("curves: a table of one row has the columns of a table" EXIT 0 STDERR "." STDOUT "\ncurve,line,p_kPa," ARGS sweep
  --table "${CMAKE_CURRENT_BINARY_DIR}/curve.csv" --strain 0.0001%..1% --for table)
granum_cli_test("curves: soil types of a table are an array" EXIT 0 STDERR "." STDOUT "^[^{]+{" ARGS sweep
  --table "${CMAKE_CURRENT_BINARY_DIR}/curve.csv" --strain 0.0001%..1% --for strata)

function(granum_curve_refuses what message)
  granum_cli_test("curves: ${what}" EXIT 2 STDERR "^granum: error: ${message}" ARGS sweep ${ARGN})
endfunction()
granum_curve_refuses("spheres have no law of strain" "[^\n]*spheres" ${curve} --for table --grain-shape sphere)
granum_curve_refuses("no form" "--strain FROM..TO [^\n]*--for" --void-ratio 0.7 --from 10kPa --to 1MPa --strain 0.01%..1%)
granum_curve_refuses("one strain" "--for goes with [^\n]*--strain" --void-ratio 0.7 --pressure 100kPa --strain 0.01% --for table)
granum_curve_refuses("no strain" "--for goes with --strain" --void-ratio 0.7 --pressure 100kPa --for table)
granum_curve_refuses("downwards" "--strain = '1%..0\\.1%' must be the smaller" --void-ratio 0.7 --pressure 100kPa --strain 1%..0.1% --for table)
granum_curve_refuses("beyond the laws" "--strain = [^\n]*outside" --void-ratio 0.7 --pressure 100kPa --strain 1%..10% --for table)
granum_curve_refuses("a path" "--for excludes --from|--from excludes --for" --void-ratio 0.7 --from 10kPa --to 1MPa --strain 0.01%..1% --for table)
granum_curve_refuses("no stress" "without stress" --void-ratio 0.7 --pressure 0kPa --strain 0.01%..1% --for table)
granum_curve_refuses("too few for Strata" "--points = 2 " ${curve} --points 2 --for strata)
granum_curve_refuses("two forms" "--for strata [^\n]*--json" ${curve} --for strata --json)
