# SPDX-License-Identifier: GPL-3.0-or-later
# LAMMPS packs grains that do not touch, and compresses what it has packed:
#   cmake -DPROGRAM=granum -DLMP=lmp -DDENSITY=dense -DFOLDER=... -P pack_scattered.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/../analysis.cmake")

set(deck "${FOLDER}")
file(REMOVE_RECURSE "${deck}")
file(MAKE_DIRECTORY "${deck}")
run("${PROGRAM}" export lammps --start scattered --grains 500 --set study.contacts=sphere --set study.densities=${DENSITY}
  --set study.pressures=10kPa,20kPa,40kPa --set study.probe_pressures=20kPa,40kPa --out "${deck}")
set(FOLDER "${deck}/${DENSITY}-1")
run("${LMP}" -in in.prepare)
run("${LMP}" -in in.iso)
run("${PROGRAM}" analyse atoms.40kPa.dump contacts.40kPa.dump --json)
value(stress mean FROM 39.96e3 TO 40.04e3)
value(forces unbalanced_force_ratio FROM 0 TO 1e-4)
# Frictionless grains jam at solid fractions near 0.64, with 6 contacts each but for rattlers; grains with friction
# far from both, with more than the 4 contacts that keep them.
if(DENSITY STREQUAL dense)
  value(void_ratio FROM 0.54 TO 0.61)
  value(counts mechanical_coordination_number FROM 5.8 TO 6.4)
else()
  value(void_ratio FROM 0.65 TO 0.80)
  value(counts mechanical_coordination_number FROM 4 TO 5)
endif()
