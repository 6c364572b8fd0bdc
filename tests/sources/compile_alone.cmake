# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles every source by itself, without groups and precompiled headers, unoptimised: shows that each includes what it
# uses. cmake -DROOT=<project> -DSCRATCH=<folder> -DCXX=<compiler> -DGENERATOR=<generator> -P compile_alone.cmake
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${ROOT}" -B "${SCRATCH}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${CXX}"
  -DCMAKE_BUILD_TYPE=Debug "-DCMAKE_CXX_FLAGS_DEBUG=-O0" -DGRANUM_UNITY_BUILD=OFF
  -DGRANUM_PRECOMPILED_HEADERS=OFF -DGRANUM_BUILD_PYTHON=ON COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${SCRATCH}" --parallel 2 -- -k 0 COMMAND_ERROR_IS_FATAL ANY)
