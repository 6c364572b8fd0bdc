# SPDX-License-Identifier: GPL-3.0-or-later
# As many ctests as the program lists test cases, and as its sources define:
#   cmake -DPROGRAM=<test program> "-DSOURCES=<source>;..." "-DCTESTS=<pattern of its list of ctests>" -P count_cases.cmake
# A template is listed once for each of its types, as "name<type>".
cmake_minimum_required(VERSION 3.25)

set(defined 0)
set(templates 0)
foreach(source IN LISTS SOURCES)
  file(READ "${source}" text)
  string(REPLACE ";" "," text "\n${text}")
  string(REGEX MATCHALL "\nTEST_CASE\\(" cases "${text}")
  string(REGEX MATCHALL "\nTEST_CASE_TEMPLATE\\(" of_types "${text}")
  list(LENGTH cases count)
  math(EXPR defined "${defined} + ${count}")
  list(LENGTH of_types count)
  math(EXPR templates "${templates} + ${count}")
endforeach()

execute_process(COMMAND "${PROGRAM}" --list-test-cases --no-intro OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," text "\n${text}")
string(REGEX REPLACE "\n(=====|\\[doctest\\])[^\n]*" "" text "${text}")
string(REGEX MATCHALL "\n[^\n]+" listed "${text}")
list(LENGTH listed listed)

file(GLOB lists "${CTESTS}")
set(run 0)
foreach(list IN LISTS lists)
  file(STRINGS "${list}" lines REGEX "^add_test\\(")
  string(REGEX MATCHALL "add_test\\( " calls "${lines}")
  list(LENGTH calls count)
  math(EXPR run "${run} + ${count}")
endforeach()

math(EXPR instances "${listed} - ${defined}")
if(listed EQUAL 0 OR instances LESS templates OR (templates EQUAL 0 AND NOT instances EQUAL 0) OR NOT run EQUAL listed)
  message(FATAL_ERROR "the sources define ${defined} test cases and ${templates} templates; the program lists ${listed}; "
    "ctest runs ${run}")
endif()
message(STATUS "${run} test cases, all of them run")
