# SPDX-License-Identifier: GPL-3.0-or-later
# Ctrl-C during a study ends it in order, with all files written and marked as incomplete:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_study_stop.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/study_files.cmake")
find_program(TIMEOUT timeout REQUIRED)

# A thousand stages: no machine is done with them in a second.
set(pressures "")
foreach(k RANGE 1001 2000)
  string(APPEND pressures "${k}0Pa,")
endforeach()
file(REMOVE_RECURSE "${FOLDER}")
execute_process(
  COMMAND "${TIMEOUT}" --preserve-status --signal=INT --kill-after=60 1 "${PROGRAM}" verify --grains 300
    --set study.contacts=sphere --set study.pressures=${pressures} --set study.probe_pressures= --out "${FOLDER}"
  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 1)
  fail("a study that was stopped must end with exit code 1")
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
