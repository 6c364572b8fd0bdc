# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the README's example and compares what it prints with what the README says that it prints, letter by letter.
#   cmake -DREADME=<file> -DPROGRAM=<file> -P check_example.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/extract_block.cmake")

extract_block(expected "${README}" text)
execute_process(COMMAND "${PROGRAM}" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "the README says\n${expected}but its example prints\n${printed}")
endif()
