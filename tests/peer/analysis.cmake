# SPDX-License-Identifier: GPL-3.0-or-later
# What the tests against other codes need to run them and to look at an answer of `granum analyse --json`.

# run(<command>...) in FOLDER; its output is left in `out`.
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: exit code ${code}\n${out}\n${err}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

# value(<where in the first frame of the JSON in `out`>... FROM <low> TO <high>)
function(value)
  cmake_parse_arguments(PARSE_ARGV 0 it "" "FROM;TO" "")
  string(JSON number GET "${out}" frames 0 ${it_UNPARSED_ARGUMENTS})
  message(STATUS "${it_UNPARSED_ARGUMENTS}: ${number}, from ${it_FROM} to ${it_TO}")
  if(NOT (number GREATER_EQUAL it_FROM AND number LESS_EQUAL it_TO))
    message(SEND_ERROR "${it_UNPARSED_ARGUMENTS}: ${number} is not in [${it_FROM}, ${it_TO}]")
  endif()
endfunction()
