# SPDX-License-Identifier: GPL-3.0-or-later
# Units as people type them, also as a word of their own.
foreach(stress "100 kPa" "100 kN/m2" "1 bar" "100 kpa" "14.503773773 psi" "2.0885434233 ksf")
  string(REPLACE " " ";" words "${stress}")
  granum_cli_test("units: ${stress} in two words" EXIT 0 JSON "inputs/stress_v=^(100000(\\.0)?$|99999\\.99999|100000\\.00000)"
    ARGS estimate --void-ratio 0.6 --pressure ${words} --json)
endforeach()
granum_cli_test("units: behind an equals sign" EXIT 0 JSON "inputs/stress_v=^100000"
  ARGS estimate --void-ratio=0.6 --pressure=100 kPa --json)
granum_cli_test("units: per cent apart" EXIT 0 JSON "inputs/void_ratio=^0\\.(6$|6000000000000|5999999999999)"
  ARGS estimate --porosity 37.5 % --pressure 100kPa --json)
granum_cli_test("units: a measurement with its error" EXIT 0 JSON "measurements/0/standard_error=^5(\\.0)?$"
  ARGS infer --void-ratio 0.6 --pressure 100 kPa --vs 250 +- 5 m/s --json)
granum_cli_test("units: behind a key" EXIT 0 JSON "answer/stated_deviations/radius=^(0\\.0001|1(\\.0)?e-0?4|0\\.000099999)"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --uncertainty radius=0.1 mm --json)
granum_cli_test("units: a unit weight is a density times g" EXIT 0 JSON "answer/bulk_density/value=^1656\\.2"
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --grain-density 25.98762 kN/m3 --json)
granum_cli_test("units: an unknown unit in two words" EXIT 2
  STDERR "--pressure = '100kilopascal' has the unknown unit 'kilopascal'; known for a pressure: Pa, kPa, MPa, GPa, [^\n]*psi"
  ARGS estimate --void-ratio 0.6 --pressure 100 kilopascal)
granum_cli_test("units: a word that is none stays a file" EXIT 3 STDERR "kPa: "
  ARGS analyse --grain-density 2650kg/m3 kPa)
granum_cli_test("units: a decimal comma" EXIT 2 STDERR "--void-ratio = '0,6' has a comma in its number: write 0\\.6\n"
  ARGS estimate --void-ratio 0,6 --pressure 100kPa)
