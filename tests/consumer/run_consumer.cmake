# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the build into a fresh prefix and lets a project of its own find, build against and run what is there.
#   cmake -DBUILD=<build tree> -DSCRATCH=<folder> -DCXX=<compiler> -DGENERATOR=<name> -DVERSION=<x.y.z> -P run_consumer.cmake
cmake_minimum_required(VERSION 3.25)

set(prefix "${SCRATCH}/the prefix")
set(build "${SCRATCH}/the build")
file(REMOVE_RECURSE "${SCRATCH}")

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY COMMAND_ECHO STDOUT)
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")

# A header that no granum_module() line names would be neither checked nor installed.
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
file(GLOB_RECURSE written RELATIVE "${root}/include" "${root}/include/*")
file(GLOB_RECURSE installed RELATIVE "${prefix}/include" "${prefix}/include/*")
if(NOT "granum/io/packing_hdf5.hpp" IN_LIST installed)
  list(REMOVE_ITEM written granum/io/packing_hdf5.hpp) # of GRANUM_HDF5
endif()
if(NOT installed OR NOT written STREQUAL installed)
  list(REMOVE_ITEM written ${installed})
  message(FATAL_ERROR "not installed: ${written}")
endif()

run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${build}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${CXX}"
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=${prefix}" "-DGRANUM_EXPECTED_VERSION=${VERSION}")
run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/use_theory")
run("${build}/use_granum")
if(EXISTS "${BUILD}/granum")
  run("${prefix}/bin/granum" --version)
endif()
