# SPDX-License-Identifier: GPL-3.0-or-later
# What is distributed is optimised: every source of the preset debian is compiled with -O2 or -O3, whichever comes last.
#   cmake -DROOT=<source tree> -DSCRATCH=<folder> -DCXX=<compiler> -P check_optimised.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${SCRATCH}")
execute_process(COMMAND "${CMAKE_COMMAND}" --preset debian -B "${SCRATCH}" "-DCMAKE_CXX_COMPILER=${CXX}"
  WORKING_DIRECTORY "${ROOT}" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(READ "${SCRATCH}/compile_commands.json" commands)
string(JSON count LENGTH "${commands}")
math(EXPR last "${count} - 1")
foreach(k RANGE ${last})
  string(JSON command GET "${commands}" ${k} command)
  string(JSON file GET "${commands}" ${k} file)
  string(REGEX MATCHALL " -O[^ ]*" levels "${command}")
  list(GET levels -1 level)
  if(NOT level MATCHES " -O[23]")
    message(FATAL_ERROR "${file} is compiled with${level}")
  endif()
endforeach()
if(count LESS 20)
  message(FATAL_ERROR "only ${count} sources were looked at")
endif()
file(REMOVE_RECURSE "${SCRATCH}")
