# SPDX-License-Identifier: GPL-3.0-or-later
# YADE glues a packing whose contacts resist rolling and twisting, unloads it until half of them pull, and probes it by small
# strains; the network that `granum analyse` solves from the files must have the same stiffness:
#   cmake -DPROGRAM=granum -DRUN=yade -DSHARE=share/yade -DFOLDER=... -P check_bonds.cmake
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/analysis.cmake")

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
run("${RUN}" -j1 -n -x "${CMAKE_CURRENT_LIST_DIR}/yade/make_packing.py" packing "${SHARE}" --law bonds --step 0.4
  --unload-to 1e5 --probe 1e-6)
run("${PROGRAM}" analyse packing.grains packing.contacts --probes packing.probes --json)
value(forces in_tension FROM 30 TO 200)
foreach(component C11 C22 C33 C44 C55 C66)
  value(probes ${component} network_over_probe FROM 0.998 TO 1.002)
endforeach()
