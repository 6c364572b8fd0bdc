# SPDX-License-Identifier: GPL-3.0-or-later
# Ctrl-C, SIGTERM or SIGHUP during a study ends it in order, with all files written and marked as incomplete:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_study_stop.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/study_files.cmake")

# A thousand stages: no machine is done with them when the signal comes.
set(pressures "")
foreach(k RANGE 1001 2000)
  string(APPEND pressures "${k}0Pa,")
endforeach()
foreach(ending HUP:129 INT:130 TERM:143)
  string(REPLACE ":" ";" ending "${ending}")
  list(POP_FRONT ending signal expected)
  file(REMOVE_RECURSE "${FOLDER}")
  execute_process(
    COMMAND "${CMAKE_CURRENT_LIST_DIR}/stop_when.sh" "${FOLDER}" ${signal} "${PROGRAM}" verify --grains 300
      --set study.contacts=sphere --set study.pressures=${pressures} --set study.probe_pressures= --out "${FOLDER}"
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL expected)
    fail("a study that SIG${signal} stopped must end with exit code ${expected}")
  endif()
  read_results("${FOLDER}")
  string(JSON complete GET "${manifest}" complete)
  if(NOT complete STREQUAL OFF)
    fail("the manifest says complete: ${complete}")
  endif()
  string(JSON failure GET "${manifest}" specimens 1 failure)
  if(NOT failure MATCHES "stopped on request")
    fail("the specimen says '${failure}'")
  endif()
  if(out MATCHES "the whole path was run|sphere: s is " OR err MATCHES "check failed")
    fail("what was not run is judged")
  endif()
endforeach()
