# SPDX-License-Identifier: GPL-3.0-or-later
# The chain of three spheres as the codes wrote it (tests/io/data): two contacts of 0.0235294118 N and 0.0665512265 N.
set(io "${PROJECT_SOURCE_DIR}/tests/io/data")
set(chain "${io}/lammps_chain.atoms" "${io}/lammps_chain.contacts" --frames 0)
set(first_only "granum: warning: coordinates have at most 5 significant digits")

granum_cli_test("analyse: table" EXIT 0 STDERR "${first_only}.*the packing is not at rest"
  STDOUT "a LAMMPS dump of grains.*C_n +1\\.3333.*z\\* +0\\.0000.*xx +0\\.3676102947.*largest f_n +66\\.55 mN.*rung 2"
  ARGS analyse ${chain} --grain-shear-modulus 30GPa)
granum_cli_test("analyse: json" EXIT 0 STDERR "${first_only}" BELOW "frames/0/" JSON
    "forces/largest_normal_force=^0\\.0665512265(0|$)" "counts/coordination_number=^1\\.333333333"
    "counts/rattlers=^3$" "stress/by_contacts/zz=^1039\\.654941" "stress/by_contacts/xy=^178\\.6225"
    "contact_law/force_over_law=^(1\\.0|0\\.99999999)" "moduli/rung0/G=^2171[0-9][0-9][0-9]\\."
  ARGS analyse ${chain} --grain-shear-modulus 30GPa --json)
foreach(code liggghts_chain.atoms%liggghts_chain.contacts mercury_chain.data%mercury_chain.fstat)
  string(REPLACE "%" ";${io}/" files "${io}/${code}")
  granum_cli_test("analyse: ${code}" EXIT 0 STDERR "granum: warning" STDOUT "C_n +1\\.3333.*zz +1\\.03965.*f_n +66\\.55 mN"
    ARGS analyse ${files} --frames 0)
endforeach()
granum_cli_test("analyse: YADE, with its own stiffnesses" EXIT 0 STDERR "granum: warning"
  STDOUT "f_n +66\\.55 mN" ARGS analyse ${io}/yade_script.grains ${io}/yade_script.contacts)
# single precision leaves 0.2 % of these overlaps, and is no warning
granum_cli_test("analyse: YADE's recorder, as VTK XML" EXIT 0 STDERR "^granum: warning: no box in the file[^\n]*\n$"
  STDOUT "contacts as VTK XML.*coordinates are of single precision.*C_n +1\\.3333.*f_n +66\\.55 mN"
  ARGS analyse ${io}/yade_chain.vtu ${io}/yade_chain.vtp)
granum_cli_test("analyse: CSV in a box" EXIT 0 STDERR "the void ratio is 39\\.7: most of the box is empty"
  STDOUT "C_n +1\\.3333.*zz +1\\.03965.*unbalanced force +unknown.*equilibrium cannot be checked"
  ARGS analyse analyse_chain_grains.csv analyse_chain_contacts.csv --box 4mm,4mm,4mm)
granum_cli_test("analyse: a profile across x" EXIT 0 STDERR "." JSON "frames/0/profile/1/low=^0\\.0015" "frames/0/profile/3/grains=^0$"
    "frames/0/profile/3/solid_fraction=^0(\\.0)?$" "frames/0/profile/3/shear_modulus=MISSING"
  ARGS analyse analyse_chain_grains.csv analyse_chain_contacts.csv --box 4mm,4mm,4mm --profile x:4 --json)
granum_cli_test("analyse: slices of a diameter" EXIT 0 STDERR "." STDOUT "4 slices across x, each 1 mm wide, 1 mean"
  ARGS analyse analyse_chain_grains.csv analyse_chain_contacts.csv --box 4mm,4mm,4mm --profile x:4)
foreach(wrong "20" "z" "z:0" "w:3" "z:2.5" "z:")
  granum_cli_test("analyse: profile ${wrong}" EXIT 2 STDERR "--profile takes an axis"
    ARGS analyse analyse_chain_grains.csv analyse_chain_contacts.csv --profile ${wrong})
endforeach()
granum_cli_test("analyse: a profile without grains" EXIT 2 STDERR "--profile needs grains"
  ARGS analyse analyse_chain_contacts.csv --profile z:3)
granum_cli_test("analyse: CSV without a box" EXIT 0 STDERR "no box in the file" STDOUT "C_n +1\\.3333"
  ARGS analyse analyse_chain_grains.csv analyse_chain_contacts.csv)
granum_cli_test("analyse: only contacts" EXIT 0 STDOUT "F_11 F_22 F_33 +0\\.50000 0\\.00000 0\\.50000.*f_n +66\\.55 mN"
  ARGS analyse analyse_chain_contacts.csv)
# types of MercuryDPM (species), YADE (materials) and tables
foreach(files_and_types mercury_chain.data,mercury_chain.fstat=0 yade_script.grains,yade_script.contacts=0,3)
  string(REGEX MATCH "^(.*)=(.*)$" matched "${files_and_types}")
  string(REPLACE "," ";${io}/" files "${io}/${CMAKE_MATCH_1}")
  string(REPLACE "," ";" types "${CMAKE_MATCH_2}")
  list(TRANSFORM types REPLACE "(.+)" "--material;\\1:shear-modulus=30GPa,poisson-ratio=0.15" OUTPUT_VARIABLE materials)
  granum_cli_test("analyse: types of ${matched}" EXIT 0 STDERR "granum: warning" STDOUT "all contacts are of one material, G_g = 30 GPa"
    ARGS analyse ${files} ${materials})
  granum_cli_test("analyse: another type than ${matched}" EXIT 2 STDERR "grains have type 0, for which no --material"
    ARGS analyse ${files} --material 7:shear-modulus=30GPa,poisson-ratio=0.15)
endforeach()
# grains alone: contacts from overlaps, and what nobody can know is unknown
set(alone "the files contain no contacts: overlapping spheres are used instead")
granum_cli_test("analyse: only grains" EXIT 0 STDERR "${alone}, and forces are unknown"
  STDOUT "2 pairs of spheres overlap.*C_n +1\\.3333" ARGS analyse ${io}/lammps_chain.data)
granum_cli_test("analyse: only grains and their material" EXIT 0 STDERR "${alone}, with the normal forces of the given material"
  STDOUT "largest f_n +65\\.63 mN" ARGS analyse ${io}/lammps_chain.data --grain-shear-modulus 30GPa)
granum_cli_test("analyse: only grains under --strict" EXIT 4 STDOUT "C_n" STDERR "granum: error: .*contain no contacts"
  ARGS analyse ${io}/lammps_chain.data --strict)
foreach(key counts/coordination_number counts/contacts counts/mechanical_coordination_number counts/rattlers stress forces)
  granum_cli_test("analyse: grains apart, ${key} is null" EXIT 0 STDERR "no spheres overlap: C_n, z" JSON "frames/0/${key}=^$"
    ARGS analyse analyse_apart.csv --box 4mm,4mm,4mm --json)
endforeach()
granum_cli_test("analyse: grains apart" EXIT 0 STDERR "no spheres overlap" STDOUT "C_n, z\\*, rattlers +unknown"
  ARGS analyse analyse_apart.csv --box 4mm,4mm,4mm)

# 54 spheres at rest in a box under their weight, contacts of 15 values without a column map, walls among the grains
set(box "${io}/lammps_box.atoms" "${io}/lammps_box.contacts")
granum_cli_test("analyse: a layout recognised by its values" EXIT 0 STDERR "47 contacts with walls"
  STDOUT "c_p15\\[1\\] to c_p15\\[15\\] as dist force fx fy fz p1 to p10.*contacts with walls +47"
  ARGS analyse ${box} --no-network)
granum_cli_test("analyse: weight is no unrest" EXIT 0 STDOUT "part due to weight +100 %.*weight +26 kN per m3"
  STDERR "the grains have weight: .* 26 kN per m3 of solid along \\(0, 0, -1\\)" ARGS analyse ${box} --no-network)
granum_cli_test("analyse: a modulus in kPa" EXIT 4 STDOUT "C_n" STDERR "G_g of the grains is 30 kPa, softer than rubber"
  ARGS analyse ${box} --no-network --grain-shear-modulus 30kPa --strict)

# a part of it
granum_cli_test("analyse: a window" EXIT 0 STDERR "have weight" STDOUT "window, .*z +1 mm to 3 mm.*grains +26 .*void ratio e +0\\.9393"
  ARGS analyse ${box} --no-network --window ..,..,1mm..3mm)
granum_cli_test("analyse: a window in JSON" EXIT 0 STDERR "have weight" JSON "frames/0/window/void_ratio=^0\\.939"
  ARGS analyse ${box} --no-network --window ..,..,1mm..3mm --json)
granum_cli_test("analyse: a depth" EXIT 0 STDERR "have weight" STDOUT "window, .*z +980\\.9 um to 3\\.981 mm.*grains +39 "
  ARGS analyse ${box} --no-network --depth 1mm..4mm)
# grains of two materials, and of springs
set(types "${io}/lammps_types.atoms" "${io}/lammps_types.contacts" --no-network)
set(soft 2:shear-modulus=3GPa,poisson-ratio=0.3)
granum_cli_test("analyse: two materials" EXIT 0 STDERR "E\\(gamma; a\\)" STDOUT "force over law +1 .*several materials: rungs 0 to 2"
  ARGS analyse ${types} --material 1:shear-modulus=30GPa,poisson-ratio=0.15 --material ${soft})
granum_cli_test("analyse: several types without materials" EXIT 0 STDOUT "C_n" STDERR "several types: give --material for each"
  ARGS analyse ${types})
granum_cli_test("analyse: 1.5 f/d where no material is known" EXIT 0 STDERR "several types"
  STDOUT "rung 4, network +432\\.[0-9].*the forces are proportional to the overlaps to the power 1\\.50*[0-9]* .*k_n = 1\\.5 f/d of each contact, no material needed"
  ARGS analyse ${io}/lammps_types.atoms ${io}/lammps_types.contacts)
granum_cli_test("analyse: 1.5 f/d" EXIT 0 STDERR "several types" STDOUT "rung 4, network +432\\.[0-9].*1\\.5 f/d of each contact"
  ARGS analyse ${io}/lammps_types.atoms ${io}/lammps_types.contacts --stiffness-from force-over-overlap)
granum_cli_test("analyse: springs" EXIT 0 STDERR "E\\(gamma; a\\)" STDOUT "springs of k_n = 100000 N/m"
  ARGS analyse ${io}/lammps_types.atoms ${io}/lammps_hooke.contacts --no-network)
# numbers of any size stay apart: each row of the matrix has six
set(entry " +-?[0-9.]+e-[0-9]+")
granum_cli_test("analyse: the entries of a tiny matrix" EXIT 0 STDERR "granum: warning"
  STDOUT "relaxed +11 [^\n]*\n[^\n]*\n +22${entry}${entry}${entry}${entry} +-[0-9.]+e-[0-9]+${entry}\n"
  ARGS analyse ${io}/lammps_types.atoms ${io}/lammps_types.contacts --material 1:shear-modulus=3e-9Pa,poisson-ratio=0.15
    --material 2:shear-modulus=1e-9Pa,poisson-ratio=0.15)
# below the isostatic point
granum_cli_test("analyse: rung 3 is not evaluated" EXIT 0 STDERR "${first_only}"
  STDOUT "rung 3 +not evaluated: z\\* = 0 is not above the isostatic value 3\\.[0-9]+" ARGS analyse ${chain} --grain-shear-modulus 30GPa)
granum_cli_test("analyse: rung 3 is not evaluated in JSON" EXIT 0 STDERR "${first_only}" JSON "frames/0/moduli/rung3/error=^not evaluated"
  ARGS analyse ${chain} --grain-shear-modulus 30GPa --json)
# states.csv of a deck of granum export
granum_cli_test("analyse: the stresses of a deck's states.csv" EXIT 0 STDERR "frame 0: coordinates"
  JSON "frames/1/stress/relative_difference/xz=^-?[0-9.]+e-(09|1[0-9])$"
  ARGS analyse ${io}/lammps_chain.atoms ${io}/lammps_chain.contacts --no-network --json --stress analyse_states.csv)

# several frames
granum_cli_test("analyse: both frames" EXIT 0 STDERR "frame 0: coordinates"
  STDOUT "frame +step .* 0 +0 .* 0\\.46909 .* 1 +20 .* 0\\.42956 "
  ARGS analyse ${io}/lammps_chain.atoms ${io}/lammps_chain.contacts)
granum_cli_test("analyse: the last frame" EXIT 0 STDERR "not at rest" JSON "frames/0/step=^20$"
  ARGS analyse ${io}/lammps_chain.atoms ${io}/lammps_chain.contacts --frames last --json)
granum_cli_test("analyse: a range of frames" EXIT 0 STDERR "not at rest" JSON "frames/0/frame=^1$"
  ARGS analyse ${io}/lammps_chain.atoms ${io}/lammps_chain.contacts --frames 1:9:2 --json)

granum_cli_test("analyse: two frames give no exponent" EXIT 0 STDERR "frame 0: coordinates"
  STDOUT "exponents need at least 3 states"
  ARGS analyse ${io}/lammps_chain.atoms ${io}/lammps_chain.contacts --grain-shear-modulus 30GPa)
# Simple cubic lattice of 27 spheres at overlaps of 1, 2 and 4e-7 m: no grain moves against the mean strain, so the
# network is its own affine estimate, and every G goes as p^(1/3).
set(lattice analyse_lattice.grains analyse_lattice.contacts)
granum_cli_test("analyse: a lattice under rising stress" EXIT 0 STDERR "E\\(gamma; a\\) does not describe"
  STDOUT "the last of 3 frames.*C_n +6\\.0000.*network, affine.* 1\\.000  1\\.000.*rung 0 +0\\.333[3-7]\\+-.*rung 4, network +0\\.333[34]\\+-"
  ARGS analyse ${lattice} --grain-shear-modulus 30GPa)
granum_cli_test("analyse: json of the lattice" EXIT 0 STDERR "E\\(gamma; a\\) does not describe" JSON
    "series/0/exponents/rung4/s/value=^0\\.333[345]" "series/0/exponents/rung0/s/value=^0\\.333[3-7]"
    "series/0/exponents/rung4/states=^3$" "series/0/frames/2=^2$" "series/0/name=^analyse_lattice\\.grains$"
    "frames/2/contact_law/alpha=^$" "frames/2/grain/shear_modulus=^(30000|29999)"
  ARGS analyse ${lattice} --json)
# Its C11 is K over 1/3, C12 = 0, C44 = C55 = C66.
granum_cli_test("analyse: both matrices of the lattice on the screen" EXIT 0 STDERR "E\\(gamma; a\\) does not describe"
  STDOUT "in the axes of the file.*affine +11 +22 +33 +23 +13 +12.*relaxed .*along these axes.* C44 +C55 +C66\n.*no wave speeds: the density of the grains is not known"
  ARGS analyse ${lattice} --grain-shear-modulus 30GPa)
granum_cli_test("analyse: wave speeds of the lattice" EXIT 0 STDERR "E\\(gamma; a\\) does not describe"
  STDOUT "wave speeds \\[m/s\\] along 1, 2 and 3.*dry packing of 138[0-9]" ARGS analyse ${lattice} --grain-density 2650kg/m3)
granum_cli_test("analyse: json of the matrices" EXIT 0 STDERR "E\\(gamma; a\\) does not describe" BELOW "frames/2/" JSON
    "network/affine/C/5/5=^[0-9]" "network/relaxed/engineering_moduli/C55=^[0-9]"
    "network/relaxed/distance_from_isotropy=^0\\.[0-9]" "network/relaxed/wave_speeds/along_3/fastest=^[0-9]"
    "bulk_density=^138"
  ARGS analyse ${lattice} --grain-density 2650kg/m3 --json)
# A lattice with tangential springs: 27 grains, three modes of the least frequency on each axis.
granum_cli_test("analyse: modes of the lattice" EXIT 0 STDERR "E\\(gamma; a\\) does not describe"
  STDOUT "lowest modes of the network\n +f \\[Hz\\] participation\n +142[0-9]+ +0\\.[0-9]+\n +142[0-9]+ +0\\.[0-9]+\n"
  ARGS analyse ${lattice} --frames last --grain-shear-modulus 30GPa --grain-density 2650kg/m3 --modes 2)
granum_cli_test("analyse: json of the modes" EXIT 0 STDERR "E\\(gamma; a\\) does not describe" BELOW "frames/2/modes/" JSON
    "0/frequency=^142[0-9][0-9][0-9]\\." "4/participation_ratio=^0\\.[0-9]"
  ARGS analyse ${lattice} --grain-shear-modulus 30GPa --grain-density 2650kg/m3 --modes 5 --no-network --json)
# A stress that is not symmetric about z: K and G of the nearest isotropic stiffness and the 6x6, no moduli of one axis.
set(along_x analyse_lattice.grains analyse_along_x.contacts --grain-shear-modulus 30GPa)
granum_cli_test("analyse: no moduli of one axis under a stress of another" EXIT 0 STDERR "stress is not symmetric about z"
  STDOUT "rung 4, network +[0-9.]+ +[0-9.]+ +- +- +- +- .*moduli of one axis have no meaning.*relaxed +11 " ARGS analyse ${along_x})
granum_cli_test("analyse: about its own axis there are" EXIT 0 STDERR "granum: warning" JSON "frames/0/moduli/rung4/G_vh=^[0-9]"
  ARGS analyse ${along_x} --axis x --json)
granum_cli_test("analyse: every second frame" EXIT 0 STDERR "E\\(gamma; a\\) does not describe" JSON "frames/1/step=^2$"
  ARGS analyse ${lattice} --frames 0::2 --no-network --json)

# the code's own stress
granum_cli_test("analyse: a stress that agrees" EXIT 0 STDERR "${first_only}" STDOUT "relative difference\n.* zz [^\n]* -?[0-9.]+e-(09|10)\n"
  ARGS analyse ${chain} --stress 367.610294Pa,0Pa,1039.654941Pa,178.622502Pa,0Pa,0Pa)
granum_cli_test("analyse: a stress that does not" EXIT 0 STDOUT "against the code's own"
  STDERR "the stress computed from contacts differs from that reported by the code by 0\\.[0-9]+ of its largest component"
  ARGS analyse ${chain} --stress 367.6Pa,0Pa,1049.7Pa,178.6Pa,0Pa,0Pa)

set(both "${io}/lammps_chain.atoms" "${io}/lammps_chain.contacts" --no-network)
granum_cli_test("analyse: a stress for each frame" EXIT 0 STDERR "frame 0: coordinates"
  JSON "frames/1/stress/relative_difference/zz=^-?[0-9.]+e-(09|1[0-9])$"
  ARGS analyse ${both} --json --stress 367.610295Pa,0Pa,1039.654941Pa,178.622502Pa,0Pa,0Pa
    --stress 340.848683Pa,0.00005344Pa,947.8248458Pa,166.767186Pa,32.342564Pa,0Pa)
granum_cli_test("analyse: a file of stresses" EXIT 0 STDERR "frame 0: coordinates"
  JSON "frames/1/stress/relative_difference/xz=^-?[0-9.]+e-(09|1[0-9])$"
  ARGS analyse ${both} --json --stress analyse_stress_frames.csv)
granum_cli_test("analyse: a file of stresses by their step" EXIT 0 STDERR "not at rest"
  JSON "frames/0/stress/relative_difference/xz=^-?[0-9.]+e-(09|1[0-9])$"
  ARGS analyse ${both} --frames 1 --json --stress analyse_stress_steps.csv)
granum_cli_test("analyse: one of two stresses does not agree" EXIT 0 STDOUT "frame"
  STDERR "frame 1: the stress computed from contacts differs from that reported by the code by 0\\.088"
  ARGS analyse ${both} --stress 367.610295Pa,0Pa,1039.654941Pa,178.622502Pa,0Pa,0Pa
    --stress 367.610295Pa,0Pa,1039.654941Pa,178.622502Pa,0Pa,0Pa)

# the formats of the table stand in the help
foreach(format "LAMMPS or LIGGGHTS dumps +ITEM: lines" "MercuryDPM's .data and .fstat" "CSV +headings")
  granum_cli_test("analyse: help names ${format}" EXIT 0 STDOUT "Formats, plain or gzip.*${format}" ARGS analyse --help)
endforeach()

# what is refused
# Moduli by the code's own probes: matched by step, or by the state in the file's name; one of no frame is refused.
granum_cli_test("analyse: probes by step" EXIT 0 STDERR "directions of the contacts" JSON "frames/1/probes/G_vh/value=^200000000" "frames/1/probes/G_vh/network_over_probe=^1\\."
    "frames/2/probes/K/network_over_probe=^1\\.17"
  ARGS analyse ${lattice} --json --probes analyse_probes.csv)
granum_cli_test("analyse: a probe by the state in the name" EXIT 0 STDERR "directions of the contacts" STDOUT "G_vh by probe +46 MPa +network over probe [5-9]\\."
  ARGS analyse ${lattice} --frames last --probes analyse_probes_state.csv)
function(granum_analyse_refuses what code message)
  granum_cli_test("analyse: ${what}" EXIT ${code} STDERR "^granum: error: ${message}" ARGS analyse ${ARGN})
endfunction()
granum_analyse_refuses("a number that is none" 3 "analyse_bad_number\\.atoms:11: expected .*coordinate" analyse_bad_number.atoms)
granum_analyse_refuses("a frame cut off" 3 "analyse_cut\\.contacts:10: " ${io}/lammps_chain.atoms analyse_cut.contacts)
granum_analyse_refuses("a missing file" 3 "none\\.dump: cannot be read" none.dump)
granum_analyse_refuses("a file of no known format" 3 "analyse_words\\.txt:2: of no format that granum reads" analyse_words.txt)
granum_analyse_refuses("only contacts of dumps" 2 "a file of grains is missing" ${io}/lammps_chain.contacts)
granum_analyse_refuses("files of two formats" 2 ".* which does not go with" ${io}/lammps_chain.atoms ${io}/mercury_chain.fstat)
granum_analyse_refuses("a frame that is not there" 2 "--frames selects none of the 2 frames" ${io}/lammps_chain.atoms --frames 5)
granum_analyse_refuses("frames in words" 2 "--frames needs all, last" ${io}/lammps_chain.atoms --frames some)
granum_analyse_refuses("frames backwards" 2 "--frames 3:1 selects no frame" ${io}/lammps_chain.atoms --frames 3:1)
granum_analyse_refuses("five stresses" 2 "--stress takes six stresses" ${chain} --stress 1Pa,1Pa,1Pa,1Pa,1Pa)
granum_analyse_refuses("one stress for two frames" 2 "--stress is given 1 times for 2 frames"
  ${io}/lammps_chain.atoms ${io}/lammps_chain.contacts --stress 1Pa,1Pa,1Pa,1Pa,1Pa,1Pa)
granum_analyse_refuses("a file of stresses without a frame's step" 3 "analyse_stress_steps.csv: expected one row of step 0, found 0"
  ${io}/lammps_chain.atoms ${io}/lammps_chain.contacts --frames 0 --stress analyse_stress_steps.csv)
granum_analyse_refuses("a file of stresses for other frames" 3 "analyse_stress_frames.csv: expected one row of stresses for each of 1 frames, found 2"
  ${io}/lammps_chain.atoms ${io}/lammps_chain.contacts --frames 0 --stress analyse_stress_frames.csv)
granum_analyse_refuses("a missing file of stresses" 3 "none: cannot be read" ${chain} --stress none)
granum_analyse_refuses("modes without masses" 2 "--modes goes with --grain-density, for the masses" ${chain} --modes 3)
granum_analyse_refuses("no modes" 2 "--modes = 0 is outside" ${chain} --modes 0 --grain-density 2650kg/m3)
granum_analyse_refuses("a matrix of contacts alone" 2 "--hessian needs grains" analyse_chain_contacts.csv --hessian never.mtx)
granum_analyse_refuses("a matrix without stiffness" 2 "the contacts have no stiffness, and it does not follow"
  ${io}/lammps_chain.data --hessian never.mtx)
granum_analyse_refuses("a file for OVITO without a folder" 2 "--xyz requires --out" ${chain} --xyz)
granum_analyse_refuses("adhesion without a material" 2 "--adhesion goes with --grain-shear-modulus" ${chain} --adhesion jkr:0.1J/m2)
foreach(adhesion 0.1J/m2 jkr jkr:0.1 jkr:-1J/m2 jkr:0.1J johnson:0.1J/m2)
  granum_analyse_refuses("adhesion given as ${adhesion}" 2 "--adhesion takes jkr or dmt" ${chain} --grain-shear-modulus 1GPa
    --adhesion ${adhesion})
endforeach()
granum_analyse_refuses("adhesion of cones" 2 "--adhesion goes with --contact sphere" ${chain} --grain-shear-modulus 1GPa
  --contact cone --slope 0.1 --adhesion DMT:50mJ/m2)
granum_analyse_refuses("adhesion and 1.5 f/d" 2 "[^\n]*adhesion" ${chain} --grain-shear-modulus 1GPa --adhesion dmt:0.1N/m
  --stiffness-from force-over-overlap)
granum_analyse_refuses("a packing in two dimensions" 2 "all 16 grains lie in one plane, z = 2 mm" analyse_discs.csv --grain-shear-modulus 1GPa)
granum_analyse_refuses("a box without volume" 2 "--box = 0 m is outside" analyse_chain_grains.csv --box 0mm,1mm,1mm)
granum_analyse_refuses("a column map of nonsense" 2 ".*" ${chain} --column-map nonsense)
granum_analyse_refuses("a column that is not there" 3 "[^\n]*expected a column" ${chain} --column-map id1=a,id2=b)
granum_analyse_refuses("a window of two axes" 2 "--window takes three ranges" ${box} --window 0mm..1mm,..)
granum_analyse_refuses("a window without dots" 2 "--window takes ranges such as" ${box} --window 0mm,1mm,2mm)
granum_analyse_refuses("a window of three points" 2 "--window takes ranges such as" ${box} --window 0mm...1mm,..,..)
granum_analyse_refuses("a window without units" 2 "--window = 0 has no unit" ${box} --window 0..1mm,..,..)
granum_analyse_refuses("a window beyond the grains" 2 "the window reaches beyond the grains along z" ${box} --window ..,..,1mm..30mm)
granum_analyse_refuses("a depth without an end" 2 "--depth takes two depths" ${box} --depth 1mm..)
granum_analyse_refuses("a depth and a window of z" 2 "--depth and --window both give z" ${box} --depth 1mm..2mm --window ..,..,1mm..2mm)
granum_analyse_refuses("a material without a type" 2 "--material takes TYPE:shear-modulus" ${types} --material shear-modulus=3GPa)
granum_analyse_refuses("a material without Poisson's ratio" 2 "--material takes TYPE:shear-modulus" ${types} --material 1:shear-modulus=3GPa)
granum_analyse_refuses("a material twice" 2 "--material is given twice for type 2" ${types} --material ${soft} --material ${soft})
granum_analyse_refuses("a type without material" 2 "grains have type 1, for which no --material" ${types} --material ${soft})
granum_analyse_refuses("materials and a material" 2 "--material replaces --grain-shear-modulus" ${types} --material ${soft} --grain-shear-modulus 3GPa)
granum_analyse_refuses("materials of a table without types" 2 "--material needs the types of grains" analyse_chain_grains.csv --material ${soft})
granum_analyse_refuses("grains without mass" 2 "--grain-density = 0 kg/m3 is outside" ${chain} --grain-density 0kg/m3)
granum_analyse_refuses("a slope without cones" 2 "--slope goes with --contact cone" ${chain} --slope 0.4)
granum_cli_test("analyse: a warning fails under --strict" EXIT 4 STDOUT "C_n" STDERR "granum: error: coordinates have"
  ARGS analyse ${chain} --strict)

# dense and loose apart, by the names of their files, in the order of the numbers in them
add_test(NAME "cli: analyse: series" COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:granum_cli>"
  "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/series" -P "${CMAKE_CURRENT_SOURCE_DIR}/check_series.cmake")
set_tests_properties("cli: analyse: series" PROPERTIES LABELS cli)
add_test(NAME "cli: analyse: files" COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:granum_cli>" "-DIO=${io}"
  "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/analysis" -P "${CMAKE_CURRENT_SOURCE_DIR}/check_analysis_files.cmake")
set_tests_properties("cli: analyse: files" PROPERTIES LABELS cli)
add_test(NAME "cli: analyse: every option of the readers with every format" COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:granum_cli>"
  "-DIO=${io}" "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/reader_options" -P "${CMAKE_CURRENT_SOURCE_DIR}/check_reader_options.cmake")
set_tests_properties("cli: analyse: every option of the readers with every format" PROPERTIES LABELS cli)
add_test(NAME "cli: hostile files" COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:granum_cli>"
  "-DDATA=${CMAKE_CURRENT_SOURCE_DIR}/data" "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/hostile_files"
  -P "${CMAKE_CURRENT_SOURCE_DIR}/check_hostile_files.cmake")
set_tests_properties("cli: hostile files" PROPERTIES LABELS cli)
add_test(NAME "cli: analyse: 10,000 grains of LAMMPS" COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:granum_cli>"
  "-DDATA=${PROJECT_SOURCE_DIR}/examples/data" -P "${CMAKE_CURRENT_SOURCE_DIR}/check_real_packing.cmake")
set_tests_properties("cli: analyse: 10,000 grains of LAMMPS" PROPERTIES LABELS slow)
add_test(NAME "cli: analyse: the same with any number of threads" COMMAND "${CMAKE_COMMAND}"
  "-DPROGRAM=$<TARGET_FILE:granum_cli>" "-DDATA=${PROJECT_SOURCE_DIR}/examples/data"
  -P "${CMAKE_CURRENT_SOURCE_DIR}/check_analyse_threads.cmake")
set_tests_properties("cli: analyse: the same with any number of threads" PROPERTIES LABELS cli)

# Unequal grains of LAMMPS (validation/sizes): what the closed forms take of them is counted, and said.
set(unequal "${PROJECT_SOURCE_DIR}/validation/sizes/lognormal_dense")
granum_cli_test("analyse: unequal grains" EXIT 0 BELOW "frames/0/" JSON
    "gradation/uniformity=^1\\.7056" "contact_means/branch_square=^0\\.92" "moduli/rung3/G=^1790" "forces/unevenness=^-0\\.0"
  ARGS analyse ${unequal}.atoms.gz ${unequal}.contacts.gz --grain-shear-modulus 30GPa --no-network --json)
granum_cli_test("analyse: unequal grains on the screen" EXIT 0
  STDOUT "C_u = d60/d10 +1\\.7056.*d50 1\\.346 mm.*<l> = 0\\.9342 x 2R, <l\\^2> = 0\\.9200 x \\(2R\\)\\^2"
  ARGS analyse ${unequal}.atoms.gz ${unequal}.contacts.gz --grain-shear-modulus 30GPa --no-network)
granum_analyse_refuses("a probe of a frame that is left out" 3 "analyse_probes\\.csv:3: step 1: no frame" ${lattice} --frames last --probes analyse_probes.csv)
granum_analyse_refuses("a probe of several frames" 3 "analyse_probes_state\\.csv:2: state analyse_lattice: no frame matches, or more" ${lattice}
  --probes analyse_probes_state.csv)
granum_analyse_refuses("a probe of this step and of another state" 3
  "analyse_probes_another\\.csv:4: step 2 of state another: no frame" ${lattice} --probes analyse_probes_another.csv)
granum_analyse_refuses("no table of probes" 3 "isotropic\\.csv:.*column modulus" ${lattice} --probes isotropic.csv)
