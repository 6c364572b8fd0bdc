# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the libraries as shared ones, not optimised, and lets run_consumer.cmake install and use them; then it looks at the
# installed files: their names for the loader, and where each finds the others, also in a prefix that was moved.
#   cmake -DROOT=<source tree> -DSCRATCH=<folder> -DCXX=<compiler> -DGENERATOR=<name> -DVERSION=<x.y.z> -DREADELF=<program>
#     -P run_shared.cmake
cmake_minimum_required(VERSION 3.25)

include("${ROOT}/cmake/GranumLibraries.cmake")
set(outside "${SCRATCH}")
set(BUILD "${outside}/build")
file(REMOVE_RECURSE "${outside}")
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${ROOT}" -B "${BUILD}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${CXX}"
  -DBUILD_SHARED_LIBS=ON -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DGRANUM_UNITY_BUILD=ON
  -DGRANUM_WARNINGS=OFF -DGRANUM_BUILD_CLI=OFF -DGRANUM_BUILD_TESTS=OFF -DGRANUM_BUILD_EXAMPLES=OFF
  -DGRANUM_BUILD_DOCS=OFF COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD}" COMMAND_ERROR_IS_FATAL ANY)

set(SCRATCH "${outside}/consumer")
include("${CMAKE_CURRENT_LIST_DIR}/run_consumer.cmake")

# moved/lib in the place of "the prefix/lib", whatever the folder of libraries is called.
file(GLOB_RECURSE theory "${prefix}/*/libgranum_theory.so")
get_filename_component(folder "${theory}" DIRECTORY)
file(RENAME "${folder}" "${outside}/moved")
set(folder "${outside}/moved")

# said(<variable> <program> <argument>...): what it prints.
function(said variable)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

# demand(<what> <text> <pattern>): the pattern matches.
function(demand what text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "${what}: no '${pattern}' in\n${text}")
  endif()
endfunction()

# A program that was linked asks for the name with the version of the interface, a.b of a.b.c, which is a link to the file.
string(REGEX MATCH "^[0-9]+\\.[0-9]+" interface "${VERSION}")
string(REPLACE "." "\\." interface_pattern "${interface}")
unset(ENV{LD_LIBRARY_PATH})
foreach(library IN LISTS granum_libraries)
  set(name "libgranum_${library}.so")
  file(REAL_PATH "${folder}/${name}" file)
  file(REAL_PATH "${folder}/${name}.${interface}" by_interface)
  if(NOT file STREQUAL "${folder}/${name}.${VERSION}" OR NOT by_interface STREQUAL file)
    message(FATAL_ERROR "${name} is ${file}, ${name}.${interface} is ${by_interface}")
  endif()
  said(dynamic "${READELF}" --dynamic --wide "${file}")
  demand("${name}" "${dynamic}" "SONAME[^\n]*\\[libgranum_${library}\\.so\\.${interface_pattern}\\]")
  demand("${name}" "${dynamic}" "RUNPATH[^\n]*\\[\\$ORIGIN\\]")
  # The loader finds what the library needs, each of granum's beside it.
  said(loaded ldd "${file}")
  if(loaded MATCHES "not found")
    message(FATAL_ERROR "${name} in ${folder}:\n${loaded}")
  endif()
  foreach(needed IN LISTS granum_${library}_needs)
    demand("${name}" "${loaded}" "libgranum_${needed}\\.so\\.${interface_pattern} => ${folder}/libgranum_${needed}\\.so")
  endforeach()
endforeach()

# The cache of ldconfig, as of a prefix that the system looks into, holds all of them by that name.
find_program(ldconfig ldconfig PATHS /sbin /usr/sbin)
if(ldconfig)
  said(cached "${ldconfig}" -n -v -N "${folder}")
  foreach(library IN LISTS granum_libraries)
    demand("ldconfig" "${cached}" "libgranum_${library}\\.so\\.${interface_pattern} -> ")
  endforeach()
endif()
