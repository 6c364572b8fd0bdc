# SPDX-License-Identifier: GPL-3.0-or-later
# Exports a deck, runs it unchanged, takes one state up again on the other number of ranks, reads all back:
#   cmake -DPROGRAM=granum -DLMP=lmp -DMPIRUN=mpirun -DCHECK=check_lammps_deck -DDENSITY=dense -DRANKS=2 -DGRAINS=2000
#     -DSIZES=equal "-DPATH_OPTIONS=--path;txc" -DFOLDER=... -P run_deck.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  cmake_parse_arguments(PARSE_ARGV 0 it "" "" "COMMAND")
  execute_process(COMMAND ${it_COMMAND} WORKING_DIRECTORY "${FOLDER}/${DENSITY}-1" RESULT_VARIABLE code
    OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    string(LENGTH "${out}" length)
    if(length GREATER 6000) # LAMMPS says much; what went wrong stands at the end
      math(EXPR from "${length} - 6000")
      string(SUBSTRING "${out}" ${from} -1 out)
    endif()
    message(FATAL_ERROR "${it_COMMAND}: exit code ${code}\n${out}\n${err}")
  endif()
  message(STATUS "${it_COMMAND}\n")
  set(last_output "${out}" PARENT_SCOPE)
endfunction()

# Root may run Open MPI in the machines of a build farm. Ranks give way to other work instead of holding a core.
set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
set(on_1 ${LMP})
set(on_2 ${MPIRUN} --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 -np 2 ${LMP})
math(EXPR others "3 - ${RANKS}")

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}/${DENSITY}-1")
run(COMMAND "${PROGRAM}" export lammps --grains ${GRAINS} --set study.contacts=sphere --set study.densities=${DENSITY}
  --set grain.sizes=${SIZES} --set study.pressures=30kPa,60kPa,120kPa --set study.probe_pressures=30kPa,120kPa ${PATH_OPTIONS} --out "${FOLDER}")
# On 2 ranks as the job of a cluster, whose parts go on from one another's files.
if(RANKS EQUAL 2)
  list(REMOVE_AT on_2 -1)
  list(JOIN on_2 " " launch)
  run(COMMAND "${CMAKE_COMMAND}" -E env "LAUNCH=${launch}" "LAMMPS=${LMP}" bash job.sh)
  list(APPEND on_2 ${LMP})
  foreach(part in.prepare in.iso in.probe in.path in.path-probe)
    if(NOT EXISTS "${FOLDER}/${DENSITY}-1/${part}.done")
      message(FATAL_ERROR "job.sh left no ${part}.done")
    endif()
  endforeach()
else()
  run(COMMAND ${on_1} -in in.all)
endif()
file(COPY "${CMAKE_CURRENT_LIST_DIR}/again.lmp" DESTINATION "${FOLDER}/${DENSITY}-1")
run(COMMAND ${on_${others}} -in again.lmp)
# What granum analyse prints of the frozen states beside what LAMMPS probed, a component of the 6x6 each.
file(GLOB dumps RELATIVE "${FOLDER}/${DENSITY}-1" "${FOLDER}/${DENSITY}-1/*.frozen.dump")
run(COMMAND "${PROGRAM}" analyse ${dumps} --grain-shear-modulus 30GPa --probes moduli.csv --json)
string(JSON count LENGTH "${last_output}" frames)
math(EXPR last "${count} - 1")
foreach(frame RANGE ${last})
  foreach(modulus G_vh G_hh K)
    string(JSON ratio GET "${last_output}" frames ${frame} probes ${modulus} network_over_probe)
    if(NOT ((ratio GREATER 0.995 AND ratio LESS 1.005) OR (DENSITY STREQUAL loose AND ratio GREATER 0.98 AND ratio LESS 1.02)))
      message(FATAL_ERROR "frame ${frame}: ${modulus} of the network over the probe is ${ratio}")
    endif()
  endforeach()
endforeach()
run(COMMAND "${CHECK}" . ${DENSITY} ${SIZES})
message(STATUS "${last_output}")
