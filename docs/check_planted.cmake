# SPDX-License-Identifier: GPL-3.0-or-later
# Proves that make_docs.cmake can fail: plants one fault at a time in a tree of one page and one header.
#   cmake -DSCRATCH=<folder> -DDOXYGEN=<program> -DDOXYFILE=<file> -DMATHJAX=<folder> -P check_planted.cmake
cmake_minimum_required(VERSION 3.25)

set(root "${SCRATCH}/root")
set(failures 0)
# run(<name> <page> <docstring> <expected>): the tree with this text on its page and in its header must be refused with
# <expected>, or pass if that is "".
function(run name page docstring expected)
  file(WRITE "${root}/README.md" "# One page {#mainpage}\n\n${page}\n")
  file(WRITE "${root}/validation/references.bib" "@book{Known2000,\n  title = {A title},\n  year = {2000}\n}\n")
  file(WRITE "${root}/docs/architecture.md" "# Floors {#architecture}\n\n| floor | module | holds |\n| --- | --- | --- |\n| 1 | `p` | what ${module} does |\n")
  file(WRITE "${root}/include/granum/p/p.hpp"
    "#pragma once\n\n/// What stands here.\nnamespace granum::p {\n/// ${docstring}\ndouble f(double pressure);\n}\n")
  execute_process(COMMAND "${CMAKE_COMMAND}" "-DROOT=${root}" "-DOUTPUT=${SCRATCH}/out" "-DDOXYGEN=${DOXYGEN}"
    "-DDOXYFILE=${DOXYFILE}" "-DMATHJAX=${MATHJAX}" -P "${CMAKE_CURRENT_LIST_DIR}/make_docs.cmake"
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[\n ]+" " " output "${output}")
  string(FIND "${output}" "${expected}" at)
  if((expected STREQUAL "" AND NOT code EQUAL 0) OR (NOT expected STREQUAL "" AND (code EQUAL 0 OR at EQUAL -1)))
    message(NOTICE "${name}: expected '${expected}', got ${code} and\n${output}")
    math(EXPR failures "${failures} + 1")
    set(failures ${failures} PARENT_SCOPE)
  endif()
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
run("nothing wrong" "See $x_1 < 2$." "G of <f_n>, in Pa. [Known2000, Eq. 3]" "")
run("unknown source" "Words." "G. [Unknown2000]" "unable to resolve reference to 'Unknown2000'")
run("unknown parameter" "Words." "G.\n/// \\param stress  p [Pa]" "argument 'stress' of command @param is not found")
run("link to no page" "See [that](docs/nowhere.md)." "G." "unable to resolve reference")
if(failures GREATER 0)
  message(FATAL_ERROR "${failures} planted cases went wrong")
endif()
