# SPDX-License-Identifier: GPL-3.0-or-later
# A run of two threads that is killed (SIGKILL) again and again, and resumed each time, ends with the same bytes as one of
# one thread that nothing interrupted:
#   cmake -DPROGRAM=... -DFOLDER=... -DKILLER=<library kill_at_rename> [-DSIZES=lognormal:0.25] -P check_reproduce_resume.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/reproduce_runs.cmake")
find_program(env_program env REQUIRED)

run_whole("${FOLDER}/whole")

set(resumed "${FOLDER}/resumed")
file(REMOVE_RECURSE "${resumed}")
set(start reproduce ${scene} --threads 2 --out "${resumed}")
set(kills 0)
# Each round is killed later: after its first file, before its second, after its second ...
foreach(round RANGE 1 40)
  execute_process(
    COMMAND "${env_program}" "LD_PRELOAD=${KILLER}" GRANUM_TEST_MOMENT=${round} "${PROGRAM}" ${start}
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(code MATCHES "^[01]$")
    break()
  endif()
  if(NOT code MATCHES "^(137|Subprocess killed)$")
    fail("killed or done is all that may happen in round ${round}")
  endif()
  math(EXPR kills "${kills} + 1")
  if(EXISTS "${resumed}/scene.toml")
    set(start reproduce --threads 2 --resume "${resumed}")
  endif()
endforeach()
# Begun anew in the folder of an unfinished run: that it can be gone on with is said, and nothing is touched.
set(unfinished "${FOLDER}/unfinished")
file(REMOVE_RECURSE "${unfinished}")
execute_process(COMMAND "${env_program}" "LD_PRELOAD=${KILLER}" GRANUM_TEST_MOMENT=3 "${PROGRAM}" reproduce ${scene} --out "${unfinished}"
  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
execute_process(COMMAND "${PROGRAM}" reproduce ${scene} --out "${unfinished}"
  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 3 OR NOT err MATCHES "unfinished run; continue it with: granum reproduce --resume ")
  fail("--resume must be suggested for an unfinished run")
endif()
if(kills LESS 5)
  fail("the run was killed ${kills} times only")
endif()
require_same_results("${FOLDER}/whole" "${resumed}")
file(STRINGS "${FOLDER}/whole/scene.toml" sizes REGEX "^sizes = ")
if(SIZES AND NOT sizes STREQUAL "sizes = \"${SIZES}\"")
  fail("the grains were not ${SIZES}: ${sizes}")
endif()

# A finished run writes its tables again.
file(REMOVE "${resumed}/states.csv")
execute_process(COMMAND "${PROGRAM}" reproduce --resume "${resumed}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
require_same_results("${FOLDER}/whole" "${resumed}")

# New results do not replace old ones unasked.
execute_process(COMMAND "${PROGRAM}" reproduce ${scene} --out "${resumed}"
  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 3 OR NOT err MATCHES "exists already and is kept; --force replaces it")
  fail("existing results must be kept")
endif()

# A folder that is no run keeps its files, though it has a scene.
set(foreign "${FOLDER}/foreign")
file(REMOVE_RECURSE "${foreign}")
file(COPY "${FOLDER}/whole/scene.toml" DESTINATION "${foreign}")
file(WRITE "${foreign}/states.csv" "mine")
execute_process(COMMAND "${PROGRAM}" reproduce --resume "${foreign}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
file(READ "${foreign}/states.csv" kept)
file(GLOB left RELATIVE "${foreign}" "${foreign}/*")
if(NOT code EQUAL 3 OR NOT err MATCHES "foreign/checkpoints: " OR NOT kept STREQUAL "mine" OR NOT left STREQUAL "scene.toml;states.csv")
  fail("a folder that is no run must stay as it is")
endif()

# A checkpoint that was damaged is named, not run on.
file(APPEND "${resumed}/checkpoints/sphere-dense-1-txc.checkpoint" "x")
execute_process(COMMAND "${PROGRAM}" reproduce --resume "${resumed}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code EQUAL 3 OR NOT err MATCHES "sphere-dense-1-txc\\.checkpoint: ")
  fail("a damaged checkpoint must be named")
endif()
