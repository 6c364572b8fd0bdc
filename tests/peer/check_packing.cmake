# SPDX-License-Identifier: GPL-3.0-or-later
# Lets YADE or LIGGGHTS make a packing and holds what `granum analyse` reads against what the code says and was told:
#   cmake -DPROGRAM=granum -DCODE=YADE -DRUN=yade -DSHARE=share/yade -DFOLDER=... -P check_packing.cmake
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/analysis.cmake")

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
if(CODE STREQUAL YADE)
  run("${RUN}" -j1 -n -x "${CMAKE_CURRENT_LIST_DIR}/yade/make_packing.py" packing "${SHARE}")
  set(files packing.grains packing.contacts)
  file(STRINGS "${FOLDER}/packing.own" own)
  list(GET own 0 stress)
  list(GET own 1 contacts_of_a_grain)
else()
  run("${RUN}" -in "${CMAKE_CURRENT_LIST_DIR}/liggghts/in.packing")
  set(files atoms.dump contacts.dump)
  file(STRINGS "${FOLDER}/own.txt" stress)
endif()

run("${PROGRAM}" analyse ${files} --stress "${stress}" --json)
foreach(component xx yy zz xy xz yz) # twelve digits or more; what rounding of sums leaves of them
  value(stress relative_difference ${component} FROM -1e-10 TO 1e-10)
endforeach()
if(CODE STREQUAL YADE)
  value(counts coordination_number FROM ${contacts_of_a_grain} TO ${contacts_of_a_grain})
endif()
# Both were told E = 69 GPa and nu = 0.15 of spheres, and have come to rest.
value(contact_law alpha value FROM 1.999999 TO 2.000001)
value(grain shear_modulus FROM 29999.9e6 TO 30000.1e6)
value(forces unbalanced_force_ratio FROM 0 TO 1e-3)
value(counts mechanical_coordination_number FROM 4 TO 6)
