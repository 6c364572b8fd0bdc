# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the build into a fresh prefix and lets projects of their own find, build against and run what is there: all of
# it, and single components where the packages that they do not need cannot be found.
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
if(NOT installed OR NOT written STREQUAL installed)
  list(REMOVE_ITEM written ${installed})
  message(FATAL_ERROR "not installed: ${written}")
endif()

set(configure "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${CXX}"
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=${prefix}" "-DGRANUM_EXPECTED_VERSION=${VERSION}")
set(hidden -DCMAKE_DISABLE_FIND_PACKAGE_GSL=ON -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_EXPAT=ON)

# A consumer builds and runs.
function(works use)
  run(${configure} -B "${build}/${use}" -DUSE=${use} ${ARGN})
  run("${CMAKE_COMMAND}" --build "${build}/${use}")
  run("${build}/${use}/use_${use}")
endfunction()
works(granum)
works(theory ${hidden} -DCMAKE_DISABLE_FIND_PACKAGE_Threads=ON)
works(packing ${hidden})
run(${configure} -B "${build}/optional" -DUSE=optional ${hidden})

# Without CMake, by what pkg-config says; its words are quoted for a shell.
find_program(pkg_config pkg-config)
if(pkg_config)
  file(GLOB_RECURSE file "${prefix}/*/granum.pc")
  get_filename_component(folder "${file}" DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} "${folder}")
  file(MAKE_DIRECTORY "${build}")
  get_filename_component(libraries "${folder}" DIRECTORY)
  foreach(package_and_use "granum;granum" "granum-theory;theory")
    list(GET package_and_use 0 package)
    list(GET package_and_use 1 use)
    execute_process(COMMAND "${pkg_config}" --cflags --libs "${package} = ${VERSION}" OUTPUT_VARIABLE flags
      OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    if(use STREQUAL "theory" AND flags MATCHES "granum_(fit|packing|io)|gsl|expat")
      message(FATAL_ERROR "${package} links more than theory: ${flags}")
    endif()
    run("${CXX}" -std=c++20 "-DGRANUM_EXPECTED_VERSION=\"${VERSION}\"" "${CMAKE_CURRENT_LIST_DIR}/use_${use}.cpp"
      -o "${build}/by_pkg_config_${use}" ${flags})
    run("${CMAKE_COMMAND}" -E env "LD_LIBRARY_PATH=${libraries}" "${build}/by_pkg_config_${use}")
  endforeach()
endif()

# refused(<use> <text> <option>...): a consumer is refused, with words that say what is wrong.
function(refused use text)
  execute_process(COMMAND ${configure} -B "${build}/refused_${use}" -DUSE=${use} ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}") # as CMake breaks its lines
  string(FIND "${output}" "${text}" at)
  if(result EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "${use} is not refused with '${text}':\n${output}")
  endif()
endfunction()
refused(theroy "there is no component 'theroy' here; the components are: theory, fit, packing, dem, io, ")
refused(fit "component fit needs GSL, which is not found" ${hidden})
refused(granum "component io needs EXPAT, which is not found" -DCMAKE_DISABLE_FIND_PACKAGE_EXPAT=ON)

if(EXISTS "${BUILD}/granum")
  run("${prefix}/bin/granum" --version)
  foreach(file man/man1/granum.1 man/man1/granum-estimate.1 bash-completion/completions/granum zsh/site-functions/_granum
      doc/granum/copyright doc/granum/examples/scene.toml doc/granum/examples/data/yade_packing.grains.gz)
    if(NOT EXISTS "${prefix}/share/${file}")
      message(FATAL_ERROR "share/${file} is not installed")
    endif()
  endforeach()
  run("${prefix}/bin/granum" plan --scene "${prefix}/share/doc/granum/examples/scene.toml")
endif()
