# SPDX-License-Identifier: GPL-3.0-or-later
# Helpers that keep every CMakeLists of the project to a few lines.

# Warnings of the project's own sources; never exported to users.
add_library(granum_warnings INTERFACE)
if(GRANUM_WARNINGS)
  target_compile_options(granum_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
    -Woverloaded-virtual -Wnull-dereference
    $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion> # which clang gives for every long double as well
    $<$<BOOL:${GRANUM_WARNINGS_AS_ERRORS}>:-Werror>)
  # g++ 12 reports -Wrestrict on concatenated strings, wrongly, when it optimises (GCC bug 105651, mended in 13).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(granum_warnings INTERFACE -Wno-restrict)
  endif()
else()
  target_compile_options(granum_warnings INTERFACE -w)
endif()

# Language level and arithmetic: no contraction into fused multiply-add, so that every vector level and
# every machine computes the same bits. The engine's sweep names its own (src/core/vector/level.hpp).
function(granum_compile_settings target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -ffp-contract=off
    # g++ looks for memory to free from 512 MB on, instead of 128 MB: 5 % less time for 130 MB more.
    $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:granum_warnings>)
  # Private headers are named by their path below src; tests/layering says which module may include which.
  target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/src")
endfunction()

# granum_precompile(<target> [<header>...]): Eigen, the standard headers that most sources begin with, and the named ones
# are parsed once, where GRANUM_PRECOMPILED_HEADERS asks for it.
function(granum_precompile target)
  if(GRANUM_PRECOMPILED_HEADERS)
    list(TRANSFORM ARGN REPLACE "(.+)" "<\\1>")
    target_precompile_headers(${target} PRIVATE
      <algorithm> <array> <cmath> <functional> <limits> <optional> <span> <string> <vector> <Eigen/Core> ${ARGN})
  endif()
endfunction()

# granum_precompile_together(<library>...): those libraries among them that are built share one set of precompiled headers;
# shared ones cannot, and have each their own.
function(granum_precompile_together)
  foreach(library IN LISTS ARGN)
    if(NOT TARGET granum_${library})
      continue()
    elseif(DEFINED first AND NOT BUILD_SHARED_LIBS)
      target_precompile_headers(granum_${library} REUSE_FROM ${first})
    else()
      set(first granum_${library})
      granum_precompile(${first})
    endif()
  endforeach()
endfunction()

# granum_unity_build(<target> <number>): compiles so many sources in one go where GRANUM_UNITY_BUILD asks for it.
function(granum_unity_build target number)
  set_target_properties(${target} PROPERTIES UNITY_BUILD "${GRANUM_UNITY_BUILD}" UNITY_BUILD_BATCH_SIZE ${number})
endfunction()

# granum_library(<name>): compiled library granum_<name>, exported as granum::<name>. Headers without a source of their own
# are the file set lone_headers, which alone is compiled by itself where headers are checked: the others are the first
# include of their source (tests/layering demands it), which shows as well that they include what they use.
function(granum_library name)
  add_library(granum_${name})
  add_library(granum::${name} ALIAS granum_${name})
  # While the major version is 0, a new minor version may change interfaces.
  set_target_properties(granum_${name} PROPERTIES EXPORT_NAME ${name} VERSION "${PROJECT_VERSION}"
    SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}" INSTALL_RPATH "$ORIGIN")
  granum_compile_settings(granum_${name})
  target_sources(granum_${name} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include"
    FILE_SET lone_headers TYPE HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}/include")
  set_target_properties(granum_${name} PROPERTIES INTERFACE_HEADER_SETS_TO_VERIFY lone_headers)
endfunction()

# granum_module(<library> <module> <concept>...): each concept is include/granum/<module>/<concept>.hpp and,
# where it exists, src/<module>/<concept>.cpp. In a module with rooms a concept is <room>/<concept>.
function(granum_module library module)
  foreach(concept IN LISTS ARGN)
    set(header_set lone_headers)
    if(EXISTS "${PROJECT_SOURCE_DIR}/src/${module}/${concept}.cpp")
      target_sources(granum_${library} PRIVATE "${PROJECT_SOURCE_DIR}/src/${module}/${concept}.cpp")
      set(header_set HEADERS)
    endif()
    target_sources(granum_${library} PUBLIC FILE_SET ${header_set}
      FILES "${PROJECT_SOURCE_DIR}/include/granum/${module}/${concept}.hpp")
  endforeach()
endfunction()

# granum_private(<library> <module> <source>...): sources without a public header, src/<module>/<source>.cpp.
function(granum_private library module)
  list(TRANSFORM ARGN REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/src/${module}/\\1.cpp" OUTPUT_VARIABLE sources)
  target_sources(granum_${library} PRIVATE ${sources})
endfunction()

# granum_tests(<module>): program test_<module> from all test_<concept>.cpp in tests/<module> and its rooms; each doctest
# case becomes a ctest of label "unit". They are not listed, so that none can be left out.
function(granum_tests module)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/tests/${module}/test_*.cpp")
  list(SORT sources)
  add_executable(test_${module} ${sources})
  granum_compile_settings(test_${module})
  set(libraries ${granum_built})
  list(TRANSFORM libraries PREPEND granum::)
  target_link_libraries(test_${module} PRIVATE ${libraries} granum_doctest_main Eigen3::Eigen $<BUILD_INTERFACE:Boost::headers>)
  target_include_directories(test_${module} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  # Tests that compute much themselves would take minutes unoptimised, as tests are otherwise where they are many.
  set(headers granum_test_headers)
  if((CMAKE_BUILD_TYPE STREQUAL "Debug" OR "-O0" IN_LIST GRANUM_TEST_COMPILE_OPTIONS)
      AND module MATCHES "^(calibration|effective|network|dem|rock_physics|triaxial)$")
    target_compile_options(test_${module} PRIVATE -O1)
    set(headers granum_optimised_test_headers)
  endif()
  if(GRANUM_PRECOMPILED_HEADERS)
    target_precompile_headers(test_${module} REUSE_FROM ${headers})
  endif()
  # Several in one go: no two of them give one name two meanings.
  granum_unity_build(test_${module} 4)
  # A ctest whose name matches no case would pass.
  doctest_discover_tests(test_${module} TEST_PREFIX "${module}: "
    PROPERTIES LABELS unit FAIL_REGULAR_EXPRESSION "test cases: +0 ")
  add_test(NAME "${module}: all test cases of the sources are run"
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:test_${module}>" "-DSOURCES=${sources}"
            "-DCTESTS=${CMAKE_CURRENT_BINARY_DIR}/test_${module}_tests*.cmake"
            -P "${PROJECT_SOURCE_DIR}/tests/count_cases.cmake")
  set_tests_properties("${module}: all test cases of the sources are run" PROPERTIES LABELS unit)
endfunction()

# granum_program(<name> <source>...): an example or validation program.
function(granum_program name)
  add_executable(${name} ${ARGN})
  granum_compile_settings(${name})
  target_link_libraries(${name} PRIVATE granum::granum)
endfunction()

# granum_share_precompiled(): the programs of a folder, so far, share precompiled headers with those of other folders; not
# those with flags of their own.
function(granum_share_precompiled)
  get_directory_property(programs BUILDSYSTEM_TARGETS)
  foreach(program IN LISTS programs)
    get_target_property(flags ${program} COMPILE_OPTIONS)
    get_target_property(type ${program} TYPE)
    get_property(first GLOBAL PROPERTY granum_precompiled_program)
    if(NOT GRANUM_PRECOMPILED_HEADERS OR NOT type STREQUAL "EXECUTABLE")
      continue()
    elseif(NOT first)
      set_property(GLOBAL PROPERTY granum_precompiled_program ${program})
      set_property(GLOBAL PROPERTY granum_precompiled_flags "${flags}")
      granum_precompile(${program} cstdio filesystem)
      continue()
    endif()
    get_property(shared_flags GLOBAL PROPERTY granum_precompiled_flags)
    if(flags STREQUAL shared_flags)
      target_precompile_headers(${program} REUSE_FROM ${first})
    endif()
  endforeach()
endfunction()
