# SPDX-License-Identifier: GPL-3.0-or-later
# What people type who have not read the documents: engineers, users of DEM codes, teachers. Each line either does what was
# meant, or the message names the right option, unit or command.
#
# granum_new_user(<what was meant> <command line> <exit code> <what the output must hold, a regex>). Where something is refused
# or doubted the regex is that of standard error.
set(new_user_folder "${CMAKE_CURRENT_SOURCE_DIR}/data")
function(granum_new_user meant line exit expected)
  separate_arguments(words UNIX_COMMAND "${line}")
  add_test(NAME "cli: a new user types: ${line} (${meant})" WORKING_DIRECTORY "${new_user_folder}"
    COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:granum_cli>" "-DEXIT=${exit}" "-DEXPECTED=${expected}"
      -P "${PROJECT_SOURCE_DIR}/tests/cli/check_new_user.cmake" -- ${words})
  set_tests_properties("cli: a new user types: ${line} (${meant})" PROPERTIES LABELS cli)
endfunction()

set(at "--void-ratio 0.6 --pressure 100kPa")

# ---- units and numbers
granum_new_user("a unit as a word of its own" "estimate --void-ratio 0.6 --pressure 100 kPa" 0 "p' = 100 kPa")
granum_new_user("kN/m2" "estimate --void-ratio=0.6 --pressure=100kN/m2" 0 "p' = 100 kPa")
granum_new_user("American units" "estimate --void-ratio 0.6 --pressure 14.5 psi" 0 "p' = 99\\.97 kPa")
granum_new_user("small letters" "estimate --void-ratio 0.6 --pressure 100kpa" 0 "p' = 100 kPa")
granum_new_user("a unit forgotten" "estimate --void-ratio 0.6 --pressure 100" 2 "--pressure = 100 has no unit; write 100Pa, 100kPa")
granum_new_user("a decimal comma" "estimate --void-ratio 0,6 --pressure 100kPa" 2 "--void-ratio = '0,6'[^\n]* write 0\\.6")
granum_new_user("per cent" "estimate --void-ratio 60% --pressure 100kPa" 0 "e = 0\\.6,")
granum_new_user("per cent without the sign" "estimate --void-ratio 60 --pressure 100kPa" 0 "per cent, 60%, or a porosity, --porosity 60%")
granum_new_user("the same, strictly" "estimate --void-ratio 60 --pressure 100kPa --strict" 4 "per cent, 60%")
granum_new_user("a porosity in per cent" "estimate --porosity 38 --pressure 100kPa" 2 "write 38% for per cent")
granum_new_user("a relative density in per cent" "estimate --sand toyoura --relative-density 60 --pressure 98kPa" 2 "write 60% for per cent")
granum_new_user("compression is negative in codes" "estimate --void-ratio 0.6 --pressure -100kPa" 2 "compression is positive")
granum_new_user("a size without unit" "estimate --d50 0.2 ${at}" 2 "--d50 = 0\\.2 has no unit; write [^\n]*0\\.2mm")
granum_new_user("mm taken for m" "estimate --radius 0.5m ${at}" 0 "--radius 500 mm: [^\n]*did you mean 500 um")
granum_new_user("GPa taken for kPa" "estimate --grain-shear-modulus 44kPa ${at}" 0 "44 kPa: [^\n]*did you mean 44 GPa")
granum_new_user("GPa forgotten" "estimate --grain-shear-modulus 44Pa ${at}" 0 "44 Pa: [^\n]*did you mean 44 GPa")
granum_new_user("g/cm3 taken for kg/m3" "estimate --grain-density 2.65kg/m3 ${at}" 0 "did you mean 2650 kg/m3")
granum_new_user("kPa taken for Pa of a prediction" "infer --void-ratio 0.6 --pressure 100kPa --vs 250m/s --predict-pressure 50Pa" 0 "--predict-pressure 50 Pa[^\n]*did you mean 50 kPa")
granum_new_user("one file for two results" "estimate --void-ratio 0.6 --pressure 100kPa --out one.svg --picture one.svg --force" 2 "--out and --picture name one file")
granum_new_user("one file by two paths" "estimate --void-ratio 0.6 --pressure 100kPa --out one.svg --picture ./one.svg --force" 2 "--out and --picture name one file")
granum_new_user("more accurate than the laws are known" "plan --grains 1000 --error 0.001% --json" 0 "dense: the laws were measured on packings of 250 to 16000 grains, and are extrapolated")
granum_new_user("kPa taken for Pa" "estimate --void-ratio 0.6 --pressure 50Pa" 0 "--pressure 50 Pa[^\n]*did you mean 50 kPa")
granum_new_user("more contacts than there are" "estimate --void-ratio 0.9 --pressure 100kPa --mechanical-coordination-number 7" 0
  "no packing of equal spheres of void ratio 0\\.9 has so many contacts")

granum_new_user("several pressures" "estimate --void-ratio 0.6 --pressure 50kPa,100kPa" 2 "several values[^\n]*granum sweep")
granum_new_user("a range" "estimate --void-ratio 0.6 --pressure 10kPa..1MPa" 2 "several values[^\n]*granum sweep")
granum_new_user("several void ratios" "estimate --void-ratio 0.6,0.7 --pressure 100kPa" 2 "several values")

# ---- symbols and near words
granum_new_user("symbols" "estimate --e 0.6 --p 100kPa" 2 "no option --e; did you mean --void-ratio.*no option --p; did you mean --pressure")
granum_new_user("the same in another order" "estimate --p 100kPa --e 0.6" 2 "no option --p; did you mean --pressure.*no option --e; did you mean --void-ratio")
granum_new_user("one hyphen" "estimate -e 0.6 -p 100kPa" 2 "--void-ratio.*--pressure")
granum_new_user("porosity by its symbol" "estimate --n 0.38 --pressure 100kPa" 2 "--n; did you mean --porosity")
granum_new_user("Poisson's ratio" "estimate --nu 0.2 ${at}" 2 "--nu; did you mean --grain-poisson-ratio")
granum_new_user("specific gravity" "estimate --Gs 2.65 ${at}" 2 "--Gs; did you mean --grain-density .*specific gravity of 2\\.65 is the density 2\\.65g/cm3")
granum_new_user("shear modulus of the grains" "estimate --G 44GPa ${at}" 2 "--G; did you mean --grain-shear-modulus")
granum_new_user("D50" "estimate --D50 0.2mm ${at}" 2 "--D50; did you mean --d50")
granum_new_user("coordination number" "estimate --z 5.5 ${at}" 2 "--z; did you mean [^\n]*--mechanical-coordination-number")
granum_new_user("relative density" "estimate --sand toyoura --Dr 60% --pressure 98kPa" 2 "--Dr; did you mean --relative-density")
granum_new_user("a dry density" "estimate --density 1.6g/cm3 --pressure 100kPa" 2 "--grain-density or --void-ratio.*e = rho_s/rho_d - 1")
granum_new_user("what nobody has" "estimate --temperature 20 ${at}" 2 "no option --temperature; granum estimate --help lists")
granum_new_user("confining pressure" "estimate --void-ratio 0.6 --confining-pressure 1bar" 2 "did you mean --pressure")
granum_new_user("underscores" "estimate --void_ratio 0.6 --pressure 100kPa" 2 "did you mean --void-ratio")
granum_new_user("a slip of the fingers" "estimate --void-ratoi 0.6 --presure 100kPa" 2 "--void-ratio.*--pressure")
granum_new_user("an option cut off" "estimate --void 0.6 --pressure 100kPa" 2 "did you mean --void-ratio")
granum_new_user("earth pressure at rest" "estimate --void-ratio 0.6 --stress-v 200kPa --K0 0.5" 2 "--K0; did you mean --k0")
granum_new_user("a shear wave to estimate" "estimate --vs 280m/s ${at}" 2 "--vs is for granum infer")
granum_new_user("a measured G_max" "infer --void-ratio 0.6 --pressure 100kPa --Gmax 120MPa" 2 "--Gmax; did you mean --shear-modulus")
granum_new_user("G measured" "infer --void-ratio 0.6 --pressure 100kPa --G 120MPa" 2 "--G; did you mean --shear-modulus")
granum_new_user("V_s" "infer --void-ratio 0.6 --pressure 100 kPa --Vs 280 m/s" 2 "--Vs; did you mean --vs")
granum_new_user("an equation" "estimate void-ratio=0.6 pressure=100kPa" 2 "write --void-ratio 0\\.6.*write --pressure 100kPa")
granum_new_user("values alone" "estimate 0.6 100kPa" 2 "'0\\.6': each value needs the name of its option")
granum_new_user("a dash of a text processor" "estimate –void-ratio 0.6 --pressure 100kPa" 2 "write --void-ratio")
granum_new_user("hyphens alone" "estimate --- 0.6" 2 "no option ---; granum estimate --help")
granum_new_user("a value forgotten" "estimate --void-ratio --pressure 100kPa" 2 "--void-ratio has no value")
granum_new_user("several mistakes, each named in the order typed" "estimate --pressure 100 --e 0.6 --radius 1,5mm" 2
  "--pressure = 100 has no unit.*no option --e.*--radius = '1,5mm'[^\n]* write 1\\.5mm")
granum_new_user("twice" "estimate --pressure 100kPa --void-ratio 0.6 --pressure 200kPa" 2 "--pressure is given twice")
granum_new_user("per cent of a tolerance" "estimate --tolerance 5 ${at}" 0 "--tolerance 5 is 500 %; did you mean 5%")
granum_new_user("a saturation beyond all pores" "estimate --saturation 101% ${at}" 2 "saturation = 1\\.01 is outside \\[0, 1\\]\n")
granum_new_user("a relative density far beyond" "estimate --sand toyoura --relative-density 150% --pressure 98kPa" 2 "relative-density = 1\\.5 is outside \\[0, 1\\.2\\]\n")
granum_new_user("a porosity beyond" "estimate --porosity 110% --pressure 98kPa" 2 "porosity = 1\\.1 is outside \\(0, 1\\)\n")
granum_new_user("a saturation in per cent" "estimate --saturation 100 ${at}" 2 "write 100% for per cent")
granum_new_user("output to a file" "estimate ${at} -o result.json" 2 "no option -o; did you mean --out")

# ---- choices
granum_new_user("Hertz" "estimate --contact hertz ${at}" 2 "hertz not in {cone,sphere,flat,power-law,rough}; did you mean sphere")
granum_new_user("large letters" "estimate --full --contact Sphere ${at}" 0 "contact +sphere")
granum_new_user("a sand's name as it is written" "estimate --full --sand Toyoura --void-ratio 0.7 --pressure 98kPa" 0 "G_g = 44 GPa")
granum_new_user("a sand misspelt" "estimate --sand toyora --void-ratio 0.7 --pressure 98kPa" 2 "sand 'toyora' is unknown; did you mean toyoura")
granum_new_user("a sand with the word sand" "estimate --sand 'Toyoura sand' --void-ratio 0.7 --pressure 98kPa" 2 "did you mean toyoura")
granum_new_user("a mineral misspelt" "estimate --grain quarz ${at}" 2 "did you mean quartz")
granum_new_user("a preparation cut off" "estimate --preparation dens ${at}" 2 "did you mean dense")

granum_new_user("a choice with an underscore, and what belongs to it" "estimate --contact power_law --alpha 2 --profile-constant 1000 ${at}" 2
  "^granum: error: --contact: power_law not in [^\n]*did you mean power-law[^\n]*\n$")
granum_new_user("choices and contradictions, each in the order typed"
  "estimate --preparation tapped --pressure 100kPa --grain quarz --stress-h 50kPa --slope 0.4 --void-ratio 0.6 --porosity 38%" 2
  "preparation 'tapped' is unknown.*did you mean quartz.*--pressure sets both stresses.*--slope goes with --contact cone.*given more than once")
granum_new_user("the same the other way round"
  "estimate --porosity 38% --void-ratio 0.6 --slope 0.4 --stress-h 50kPa --grain quarz --pressure 100kPa --preparation tapped" 2
  "given more than once.*--slope goes with --contact cone.*did you mean quartz.*--pressure sets both stresses.*preparation 'tapped' is unknown")
granum_new_user("three densities, said once" "estimate --porosity 38% --void-ratio 0.6 --solid-fraction 0.62 --pressure 1" 2
  "^granum: error: the density is given more than once[^\n]*\ngranum: error: --pressure = 1 has no unit[^\n]*\n$")
granum_new_user("options of other kinds of sweeps, all at once" "sweep --void-ratio 0.6 --pressure 1kPa --eta 0.5 --k0 0.4 --columns all --force" 2
  "--pressure goes with --table or --for; .*--eta goes with --path txc.*--k0 goes with --depth.*--force goes with --out, --picture or --report")
granum_new_user("choices of the parser beside what they exclude" "sweep --depth 0m..3m --void-ratio 0.6 --from 1kPa --rungs 7 --points 1" 2
  "excludes.*--rungs: 7 not in.*--points: ")
granum_new_user("what needs another option" "plan --force --set study.grain=4" 2 "--force requires --out")
granum_new_user("numbers that are no whole ones" "verify --grains many --seeds 1.5" 2
  "--grains = 'many': expected a whole number.*--seeds = '1\\.5': expected a whole number")
granum_new_user("a list with a slip" "infer --void-ratio 0.6 --pressure 100kPa --vs 280m/s --predict-pressure 50kPa,1 --growth fix" 2
  "--predict-pressure = 1 has no unit.*--growth: fix not in {packings,fixed,fitted,sand}; did you mean fixed")
granum_new_user("an unknown option that another one may need" "sweep --dept 0m..3m --void-ratio 0.6 --k0 0.4" 2 "^granum: error: [^\n]*did you mean --depth[^\n]*\n$")

# ---- what is missing
granum_new_user("nothing but the command" "estimate" 2 "density and stress are missing: give --void-ratio,[^\n]*--pressure")
granum_new_user("no stress" "estimate --void-ratio 0.6" 2 "the stress is missing: give --pressure")
granum_new_user("one stress" "estimate --void-ratio 0.6 --stress-v 200kPa" 2 "--stress-h is missing")
granum_new_user("no command" "${at}" 2 "the first word is the command.*--void-ratio is for granum estimate")

# ---- commands
granum_new_user("a slip" "fitt data.csv" 2 "no command 'fitt'; did you mean fit")
granum_new_user("American spelling" "analyze dump.lammps" 2 "did you mean analyse")
granum_new_user("help as a command" "help estimate" 0 "Usage: granum estimate")
granum_new_user("a stiffness" "calculate ${at}" 2 "did you mean estimate")
granum_new_user("the version" "--verison" 2 "did you mean --version")
granum_new_user("depths with their units apart" "sweep --void-ratio 0.6 --depth 1 m .. 2 m --points 2" 0 "\n +2 32\\.4[89] ")
granum_new_user("the water table" "sweep --void-ratio 0.6 --depth 1m..2m --gwt 2m" 2 "--gwt; did you mean --water-table")
granum_new_user("a profile" "profile --depth 0m..30m" 2 "did you mean sweep")
granum_new_user("DEM" "simulate" 2 "did you mean verify")
granum_new_user("an unknown code" "export yade" 2 "no command 'yade'; there are lammps")

# ---- scenes
granum_new_user("a key without its section" "plan --set radius=0.4mm" 2 "key 'radius' is unknown; did you mean grain\\.radius")
granum_new_user("a key as an option" "verify --radius 0.4mm" 2 "no option --radius; did you mean --set grain\\.radius")
granum_new_user("a plural" "plan --set study.contacts=spheres" 2 "'spheres' is unknown; did you mean sphere")
granum_new_user("particles" "plan --particles 500" 2 "--particles; did you mean --grains")
granum_new_user("a number of grains with a comma" "plan --set study.grains=2,000" 2 "write 2\\.000 or 2000")

# ---- tables
granum_new_user("an isotropic path to fit" "fit isotropic.csv" 2 "--sum-only")
granum_new_user("p and G with units in brackets" "fit isotropic_by_hand.csv" 0 "s +0\\.3490")
granum_new_user("a column with its unit" "fit isotropic_by_hand.csv --modulus-column 'G_max [MPa]'" 0 "s +0\\.3490")
granum_new_user("no file" "fit" 2 "file is required; see granum fit --help")
granum_new_user("a file that is not there" "fit moduli.csv" 3 "moduli\\.csv: cannot be read: No such file")

granum_cli_test("people: a likely mistake is in the JSON" EXIT 0 STDERR "warning: --void-ratio 60: is it per cent"
  JSON "warnings/0=^--void-ratio 60: is it per cent, 60%" ARGS estimate --void-ratio 60 --pressure 100kPa --json)
granum_cli_test("people: of infer too, strictly" EXIT 4 STDERR "error: --grain-shear-modulus 44 kPa: softer than rubber; did you mean 44 GPa"
  JSON "command=infer" ARGS infer --void-ratio 0.6 --pressure 100kPa --vs 0.3m/s --grain-shear-modulus 44kPa --strict --json)
granum_cli_test("people: of a path" EXIT 0 STDERR "warning: 2 of 2 states [^\n]*state 1: --radius 500 mm: [^\n]*did you mean 500 um" STDOUT "p_kPa"
  ARGS sweep --void-ratio 0.6 --radius 0.5m --from 10kPa --to 100kPa --points 2)
granum_cli_test("people: over depth" EXIT 0 STDERR "warning: 2 of 2 states [^\n]*1 m: --d50 200 mm: [^\n]*did you mean 200 um" STDOUT "s'_v"
  ARGS sweep --void-ratio 0.6 --d50 0.2m --depth 1m..2m --points 2)
granum_cli_test("people: a depth of 5 mm is no mistyped stress" EXIT 0 STDOUT "s'_v"
  ARGS sweep --void-ratio 0.6 --depth 0m..5mm --points 2 --strict)
granum_cli_test("people: the ends of a path" EXIT 4 STDERR "^granum: error: --from 10 Pa [^\n]*\n$" STDOUT "p_kPa"
  ARGS sweep --void-ratio 0.6 --from 10Pa --to 100kPa --points 3 --strict)
granum_cli_test("people: a picture with an uncertain pressure" EXIT 0 STDOUT "V_s "
  ARGS estimate --void-ratio 0.6 --pressure 100kPa --uncertainty pressure=5% --force --picture "${CMAKE_CURRENT_BINARY_DIR}/pressure.svg")
# rows of a table: each kind of slip once, with its first row and how many there are
set(slips "2 of 4 states have a likely mistake, see notes; line 3: --void-ratio 60: is it per cent, 60%")
granum_cli_test("people: of the rows of a table, counted" EXIT 0 STDERR "${slips}" ARGS sweep --table sweep_slips.csv
  STDOUT "\nB,60,100,[^\n]*,\"?'--void-ratio 60: is it per cent[^\n]*\nC,0\\.65,0\\.05,[^\n]*--pressure 50 Pa[^\n]*did you mean 50 kPa[^\n]*\nD,62,[^\n]*--void-ratio 62: ")
granum_cli_test("people: together with one of another kind" EXIT 0 STDERR "1 of 4 states have a likely mistake, see notes; line 4: --pressure 50 Pa"
  JSON "states/1/notes/0=^--void-ratio 60: is it" ARGS sweep --table sweep_slips.csv --json)
granum_cli_test("people: of a table in the JSON" EXIT 0 STDERR "${slips}" JSON "warnings=2 of 4 states have a likely mistake"
  ARGS sweep --table sweep_slips.csv --json)
granum_cli_test("people: of a table, strictly" EXIT 4 STDERR "error: ${slips}" STDOUT "sample" ARGS sweep --table sweep_slips.csv --strict)

# scenes of simulations: said before anything is computed, and nothing is under --strict
set(large "grain\\.radius 500 mm: grains so large are not sand; did you mean 500 um")
set(small --set study.contacts=sphere --set study.grains=40 --set grain.radius=0.5m)
granum_cli_test("people: of a scene" EXIT 0 STDERR "^granum: warning: ${large}[^\n]*\n$" JSON "warnings/0=^${large}" ARGS plan ${small} --json)
granum_cli_test("people: of a scene, strictly" EXIT 4 STDERR "^granum: error: ${large}" STDOUT "granum verify would run" ARGS plan ${small} --strict)
granum_cli_test("people: of a density and pressures" EXIT 0 JSON "command=plan"
  STDERR "grain\\.density 2\\.65 kg/m3: [^\n]*did you mean 2650 kg/m3[^\n]*\n[^\n]*study\\.pressures 20 Pa[^\n]*did you mean 20 kPa[^\n]*\n$"
  ARGS plan --set grain.density=2.65kg/m3 --set study.pressures=20Pa,50Pa,90Pa --set study.probe_pressures=20Pa --json)
foreach(command verify trade "export lammps --out of_a_slip" reproduce)
  separate_arguments(words UNIX_COMMAND "${command}")
  list(GET words 0 name)
  granum_cli_test("people: ${name} does not begin with a slip, strictly" EXIT 4 STDERR "^granum: error: ${large}[^\n]*\n$"
    ARGS ${words} ${small} --strict)
endforeach()
granum_cli_test("people: a slip in a manifest" EXIT 0 STDERR "^granum: warning: ${large}" JSON "warnings/0=^${large}"
  ARGS verify ${small} --set study.densities=dense --set study.pressures=20kPa,40kPa,80kPa --set study.probe_pressures=40kPa --json)
