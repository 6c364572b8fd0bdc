# SPDX-License-Identifier: GPL-3.0-or-later
# House rules of every source file: the licence line, and lengths that keep a file readable.
#   cmake -DROOT=<source tree> -P check_sources.cmake
cmake_minimum_required(VERSION 3.25)

set(longest_header 200)
set(longest_source 500)

file(GLOB files RELATIVE "${ROOT}" "${ROOT}/CMakeLists.txt" "${ROOT}/*.sh" "${ROOT}/.ci/*" "${ROOT}/scripts/*" "${ROOT}/cmake/*")
foreach(folder include src tests examples validation bench docs python)
  file(GLOB_RECURSE found RELATIVE "${ROOT}" "${ROOT}/${folder}/*.hpp" "${ROOT}/${folder}/*.cpp"
    "${ROOT}/${folder}/*.cmake" "${ROOT}/${folder}/CMakeLists.txt" "${ROOT}/${folder}/*.sh" "${ROOT}/${folder}/*.py")
  list(APPEND files ${found})
endforeach()

set(violations 0)
foreach(path IN LISTS files)
  file(READ "${ROOT}/${path}" text)
  if(NOT text MATCHES "^(#![^\n]*\n)?(//|#) SPDX-License-Identifier: GPL-3\\.0-or-later\n")
    message(NOTICE "${path}: does not begin with its SPDX-License-Identifier")
    math(EXPR violations "${violations} + 1")
  endif()
  if(path MATCHES "\\.(hpp|cpp)$")
    string(REGEX REPLACE "[^\n]" "" newlines "${text}")
    string(LENGTH "${newlines}" lines)
    if(path MATCHES "^include/")
      set(longest ${longest_header})
    else()
      set(longest ${longest_source})
    endif()
    if(lines GREATER longest)
      message(NOTICE "${path}: ${lines} lines; ${longest} are the most")
      math(EXPR violations "${violations} + 1")
    endif()
  endif()
endforeach()

list(LENGTH files file_count)
if(file_count EQUAL 0 OR violations GREATER 0)
  message(FATAL_ERROR "sources: ${violations} violations in ${file_count} files")
endif()
message(STATUS "sources: ${file_count} files in order")
