# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the program and checks exit code and text, on standard error where something is refused or doubted:
#   cmake -DPROGRAM=... -DEXIT=0 -DEXPECTED=regex -P check_new_user.cmake -- arguments
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/arguments.cmake")
execute_process(COMMAND "${PROGRAM}" ${arguments} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)

string(REGEX REPLACE "granum: note: [^\n]*\n" "" err "${err}")
set(told "${out}")
if(NOT err STREQUAL "")
  set(told "${err}")
endif()
if(NOT code STREQUAL EXIT)
  message(FATAL_ERROR "exit code ${code}, expected ${EXIT}\n${told}")
endif()
if(NOT told MATCHES "${EXPECTED}")
  message(FATAL_ERROR "the text does not match ${EXPECTED}\n${told}")
endif()
if(code STREQUAL "2" AND NOT out STREQUAL "")
  message(FATAL_ERROR "refused, and yet there is output:\n${out}")
endif()
