# SPDX-License-Identifier: GPL-3.0-or-later
# The threads that solve the 6x6 change nothing of what is said of a packing but the seconds that it took:
#   cmake -DPROGRAM=... -DDATA=<examples/data> -P check_analyse_threads.cmake
cmake_minimum_required(VERSION 3.25)

# analyse(<variable> <option>...): the first frame as JSON, without its seconds
function(analyse variable)
  execute_process(COMMAND "${PROGRAM}" analyse "${DATA}/yade_packing.grains.gz" "${DATA}/yade_packing.contacts.gz" --json ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: exit code ${code}\n${err}")
  endif()
  string(JSON frame GET "${out}" frames 0)
  string(JSON G GET "${frame}" moduli rung4 G) # the network was solved
  string(JSON frame REMOVE "${frame}" seconds)
  set(${variable} "${frame}" PARENT_SCOPE)
endfunction()

analyse(one --threads 1)
foreach(options "--threads;2" "--threads;3" "--threads;0" "")
  analyse(other ${options})
  if(NOT other STREQUAL one)
    message(FATAL_ERROR "'${options}' says something else than one thread:\n${other}")
  endif()
endforeach()
