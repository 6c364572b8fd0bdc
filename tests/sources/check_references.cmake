# SPDX-License-Identifier: GPL-3.0-or-later
# Every source key in square brackets, [Hertz1882] or [Mindlin1949, Eq. 3; Walton1987], stands in the bibliography, and
# every entry of the bibliography is cited somewhere.
#   cmake -DROOT=<source tree> -P check_references.cmake
cmake_minimum_required(VERSION 3.25)

set(key "[A-Z][A-Za-z]+[12][0-9][0-9][0-9][a-z]?")

file(READ "${ROOT}/validation/references.bib" bibliography)
string(REPLACE ";" "," bibliography "${bibliography}")
string(REGEX MATCHALL "@[a-z]+{${key}," known "${bibliography}")
list(TRANSFORM known REPLACE "@[a-z]+{|," "")
set(distinct ${known})
list(REMOVE_DUPLICATES distinct)
if(NOT known STREQUAL distinct)
  message(FATAL_ERROR "references.bib: a key stands twice")
endif()

set(files "${ROOT}/README.md")
foreach(folder include src tests examples validation bench docs)
  file(GLOB_RECURSE found "${ROOT}/${folder}/*.hpp" "${ROOT}/${folder}/*.cpp" "${ROOT}/${folder}/*.md" "${ROOT}/${folder}/*.csv")
  list(APPEND files ${found})
endforeach()

# Brackets and semicolons mean something to CMake lists, so they are read as other characters.
string(ASCII 1 open)
string(ASCII 2 close)
set(uses 0)
set(unknown 0)
set(uncited ${known})
foreach(path IN LISTS files)
  file(READ "${path}" text)
  string(REPLACE "[" "${open}" text "${text}")
  string(REPLACE "]" "${close}" text "${text}")
  string(REPLACE ";" "," text "${text}")
  string(REGEX MATCHALL "${open}[^${open}${close}]*${close}" groups "${text}")
  string(REGEX MATCHALL "${key}" keys "${groups}")
  foreach(used IN LISTS keys)
    math(EXPR uses "${uses} + 1")
    list(REMOVE_ITEM uncited ${used})
    if(NOT used IN_LIST known)
      message(NOTICE "${path}: ${used} is not in validation/references.bib")
      math(EXPR unknown "${unknown} + 1")
    endif()
  endforeach()
endforeach()

if(uses EQUAL 0 OR unknown GREATER 0 OR uncited)
  message(FATAL_ERROR "references: ${unknown} of ${uses} uses are unknown; cited nowhere: ${uncited}")
endif()
list(LENGTH known known_count)
message(STATUS "references: ${uses} uses of ${known_count} known sources")
