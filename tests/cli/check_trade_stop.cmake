# SPDX-License-Identifier: GPL-3.0-or-later
# Ctrl-C during a trade study ends it in order, with all files written and marked as incomplete:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_trade_stop.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/study_files.cmake")

# Thousands of specimens: no machine is done with them when the signal comes.
file(REMOVE_RECURSE "${FOLDER}")
execute_process(
  COMMAND "${CMAKE_CURRENT_LIST_DIR}/stop_when.sh" "${FOLDER}" INT "${PROGRAM}" trade --quick --grains 60
    --seeds 900 --set study.densities=dense --out "${FOLDER}"
  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 130)
  fail("a study that Ctrl-C stopped must end with exit code 130")
endif()
read_files("${FOLDER}" "manifest.json;report.html;samples.csv;trade.csv;trade.svg")
string(JSON complete GET "${manifest}" complete)
string(JSON failure GET "${manifest}" failure)
if(NOT (complete STREQUAL OFF AND failure MATCHES "stopped on request"))
  fail("the manifest says complete: ${complete}, failure: '${failure}'")
endif()
# The screen has no table of nothing: each row that it shows has specimens.
if(out MATCHES "(dense|loose) +0 ")
  fail("rows without specimens are shown")
endif()
