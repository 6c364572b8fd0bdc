# SPDX-License-Identifier: GPL-3.0-or-later
# A disk that is full, here a limit on the size of files, ends a run with exit code 3 and the name of the file; what was
# written before stays, and with room again the run goes on to the same bytes:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_reproduce_disk.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/reproduce_runs.cmake")
find_program(BASH bash REQUIRED)

run_whole("${FOLDER}/whole")

set(full "${FOLDER}/full")
file(REMOVE_RECURSE "${full}")
# Kilobytes: enough for packings, too few for the checkpoints of paths.
execute_process(COMMAND "${BASH}" -c "trap '' XFSZ; ulimit -f 40; exec \"$@\"" -- "${PROGRAM}" reproduce ${scene} --out "${full}"
  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 3 OR NOT err MATCHES "\\.checkpoint: cannot be written: File too large")
  fail("a file that cannot be written must end the run with exit code 3")
endif()
file(GLOB parts "${full}/checkpoints/*.part*")
if(parts)
  fail("half files stayed behind: ${parts}")
endif()
if(NOT EXISTS "${full}/checkpoints/sphere-1-packing.checkpoint")
  fail("what was written before must stay")
endif()
execute_process(COMMAND "${PROGRAM}" reproduce --resume "${full}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code MATCHES "^[01]$")
  fail("the run must go on once there is room")
endif()
require_same_results("${FOLDER}/whole" "${full}")
