# SPDX-License-Identifier: GPL-3.0-or-later
# Proves that check_names.cmake can fail: a page of names that do not exist, each of which it must report, and one of names
# that do.
#   cmake -DROOT=<source tree> -DPROGRAM=<granum> -DSCRATCH=<folder> -P check_planted.cmake
cmake_minimum_required(VERSION 3.25)

function(check_page code output text)
  file(WRITE "${SCRATCH}/page.md" "${text}")
  execute_process(COMMAND "${CMAKE_COMMAND}" "-DROOT=${ROOT}" "-DPROGRAM=${PROGRAM}" "-DPAGES=${SCRATCH}/page.md"
    -P "${CMAKE_CURRENT_LIST_DIR}/check_names.cmake" RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  set(${code} "${result}" PARENT_SCOPE)
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

set(wrong "tests/nowhere/test_nothing.cpp" "effective::uniform_wish" "PowerLaw::colour" "Unimaginable" "granum::everything"
  "granum divine" "granum estimate --colour red" "--colour" "study.colour" "granum verify --set grain.colour=red" "nothing.xyz")
set(failures 0)
set(text "# A page\n\n")
foreach(name IN LISTS wrong)
  string(APPEND text "It names `${name}`.\n")
endforeach()
check_page(code output "${text}")
foreach(name IN LISTS wrong)
  string(FIND "${output}" "`${name}` does not exist" at)
  if(code EQUAL 0 OR at EQUAL -1)
    message(NOTICE "not caught: ${name}\n${output}")
    math(EXPR failures "${failures} + 1")
  endif()
endforeach()
check_page(code output "# A page\n\n```sh\ngranum estimate \\\n  --colour red\nscripts/nothing.sh\n```\n")
if(code EQUAL 0 OR NOT output MATCHES "--colour red` does not exist" OR NOT output MATCHES "scripts/nothing.sh` does not exist")
  message(NOTICE "not caught: commands in a block\n${output}")
  math(EXPR failures "${failures} + 1")
endif()
check_page(code output "`README.md` `effective::uniform_strain` `granum verify --set study.grains=300` `--json` `study.grains` `100kPa`\n")
if(NOT code EQUAL 0)
  message(NOTICE "refused without cause:\n${output}")
  math(EXPR failures "${failures} + 1")
endif()
if(failures GREATER 0)
  message(FATAL_ERROR "${failures} planted cases went wrong")
endif()
