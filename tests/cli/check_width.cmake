# SPDX-License-Identifier: GPL-3.0-or-later
# What commands show on a terminal is at most 80 characters wide, whatever they are asked:
#   cmake -DPROGRAM=... -DIO=<tests/io/data> -DEXAMPLES=<examples/data> -DFOLDER=... -P check_width.cmake
cmake_minimum_required(VERSION 3.25)
set(width 80)

# widest(<text>): the length of its longest line is then in `longest`, and the line in `line`.
function(widest text)
  string(REPLACE ";" "," text "${text}")
  string(REGEX REPLACE "[][]" "|" text "${text}") # brackets would join elements of the list
  string(REPLACE "\n" ";" lines "${text}")
  set(most 0)
  foreach(line IN LISTS lines)
    string(LENGTH "${line}" length)
    if(length GREATER most)
      set(most ${length})
      set(longest_line "${line}")
    endif()
  endforeach()
  set(longest ${most} PARENT_SCOPE)
  set(line "${longest_line}" PARENT_SCOPE)
endfunction()

string(REPEAT "x" 81 wide)
widest("short\n[a;${wide}]\nshort\n")
if(NOT longest EQUAL 85)
  message(FATAL_ERROR "a line of 85 characters measures ${longest}")
endif()

function(fits)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  string(LENGTH "${out}" length)
  if(NOT code MATCHES "^[01]$" OR length LESS 200)
    message(FATAL_ERROR "granum ${ARGN}: exit code ${code}\n${out}\n${err}")
  endif()
  widest("${out}")
  if(longest GREATER width)
    message(FATAL_ERROR "granum ${ARGN}: a line of ${longest} characters:\n${line}")
  endif()
endfunction()

# Copies, as a long name of a folder cannot be broken.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
foreach(file lammps_chain.atoms lammps_chain.contacts lammps_box.atoms lammps_box.contacts lammps_types.atoms
    lammps_types.contacts)
  file(COPY "${IO}/${file}" DESTINATION "${FOLDER}")
endforeach()
file(COPY "${CMAKE_CURRENT_LIST_DIR}/data/" DESTINATION "${FOLDER}")
file(GLOB packings "${EXAMPLES}/yade_lognormal_dense.*")
file(COPY ${packings} DESTINATION "${FOLDER}")

set(chain lammps_chain.atoms lammps_chain.contacts)
set(lattice analyse_lattice.grains analyse_lattice.contacts)
set(small --grains 120 --set study.pressures=10kPa,20kPa,40kPa --set study.probe_pressures=20kPa)
foreach(command
    "analyse|${chain}|--grain-shear-modulus|30GPa"
    "analyse|${chain}|--frames|0|--stress|367.6Pa,0Pa,1049.7Pa,178.6Pa,0Pa,0Pa"
    "analyse|lammps_box.atoms|lammps_box.contacts|--no-network|--window|..,..,1mm..3mm"
    "analyse|lammps_types.atoms|lammps_types.contacts"
    "analyse|${lattice}|--grain-density|2650kg/m3"
    "analyse|yade_lognormal_dense.grains.gz|yade_lognormal_dense.contacts.gz|--grain-density|2650kg/m3"
    "analyse|analyse_chain_contacts.csv"
    "estimate|--void-ratio|0.6|--pressure|100kPa|--bounds|--tolerance|5%"
    "estimate|--void-ratio|0.6|--stress-v|200kPa|--stress-h|100kPa|--saturation|100%|--uniformity|1.5|--bounds"
    "sweep|--void-ratio|0.6|--depth|0m..30m|--water-table|2m" "sweep|--void-ratio|0.6|--depth|0m..3000m"
    "infer|--void-ratio|0.6|--pressure|100kPa|--vs|280m/s+-2%|--predict-pressure|50kPa,400kPa"
    "infer|--void-ratio|0.6|--stress-v|200kPa|--stress-h|100kPa|--vs|280m/s"
    "export|lammps|--grains|60|--start|scattered|--seeds|4|--set|study.contacts=sphere|--out|export"
    "fit|hv_dense_cone.csv" "fit|isotropic_by_hand.csv" "plan|--grains|200" "plan|--error|2%"
    "verify|${small}|--out|verify"
    "trade|--quick|--grains|60|--set|study.densities=dense|--set|study.pressures=20kPa,40kPa,80kPa|--out|trade"
    "reproduce|${small}|--set|study.contacts=sphere|--set|study.densities=dense|--set|shear.paths=TXC,RTXE|--set|shear.inertial_number=5e-4|--set|shear.largest_strain=0.002|--set|shear.strain_step=0.0005|--out|reproduce")
  string(REPLACE "|" ";" command "${command}")
  fits(${command})
endforeach()
