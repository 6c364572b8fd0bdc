# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the example of a page and compares what it prints with what the page says that it prints, letter by letter.
#   cmake -DPAGE=<file> -DPROGRAM=<file> -P check_example.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/extract_blocks.cmake")

extract_blocks(expected "${PAGE}" text)
execute_process(COMMAND "${PROGRAM}" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "${PAGE} says\n${expected}but its example prints\n${printed}")
endif()
