# SPDX-License-Identifier: GPL-3.0-or-later
# YADE makes a packing and probes it by small strains; the network that `granum analyse` solves from the files must have the
# same stiffness:
#   cmake -DPROGRAM=granum -DRUN=yade -DSHARE=share/yade -DOPTIONS=<of make_packing.py> -DLOW=0.995 -DHIGH=1.005 -DFOLDER=...
#         -P check_probes.cmake
cmake_minimum_required(VERSION 3.25)

include("${CMAKE_CURRENT_LIST_DIR}/analysis.cmake")

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
run("${RUN}" -j1 -n -x "${CMAKE_CURRENT_LIST_DIR}/yade/make_packing.py" packing "${SHARE}" --step 0.4 --probe 1e-6 ${OPTIONS})
run("${PROGRAM}" analyse packing.grains packing.contacts --probes packing.probes --json)
if(OPTIONS MATCHES "bonds") # glue that pulls
  value(forces in_tension FROM 30 TO 200)
endif()
foreach(component C11 C22 C33 C44 C55 C66)
  value(probes ${component} network_over_probe FROM ${LOW} TO ${HIGH})
endforeach()
