# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program and checks exit code and text:
#   cmake -DPROGRAM=... -DEXIT=0 [-DSTDOUT=regex] [-DSTDERR=regex] [-DJSON=key=regex]
#     -P check_run.cmake -- arguments
# A key within objects is written outer/inner.
# What is not asked for must be empty: a run without STDERR may not warn.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/arguments.cmake")

execute_process(COMMAND "${PROGRAM}" ${arguments} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)

function(fail what)
  message(FATAL_ERROR "${what}\n--- standard output:\n${out}\n--- standard error:\n${err}")
endfunction()

if(NOT code STREQUAL EXIT)
  fail("exit code ${code}, expected ${EXIT}")
endif()
if(DEFINED JSON)
  string(FIND "${JSON}" "=" split)
  string(SUBSTRING "${JSON}" 0 ${split} key)
  math(EXPR after "${split} + 1")
  string(SUBSTRING "${JSON}" ${after} -1 expected)
  string(REPLACE "/" ";" key "${key}")
  string(JSON value ERROR_VARIABLE problem GET "${out}" ${key})
  if(problem OR NOT value MATCHES "${expected}")
    fail("JSON ${key} is '${value}' (${problem}), expected ${expected}")
  endif()
elseif(DEFINED STDOUT)
  string(REGEX REPLACE "\n *" " " unwrapped "${out}") # long lines go on in the next one
  if(NOT (out MATCHES "${STDOUT}" OR unwrapped MATCHES "${STDOUT}"))
    fail("standard output does not match ${STDOUT}")
  endif()
elseif(NOT out STREQUAL "")
  fail("unexpected standard output")
endif()
if(DEFINED STDERR)
  if(NOT err MATCHES "${STDERR}")
    fail("standard error does not match ${STDERR}")
  endif()
elseif(NOT err STREQUAL "")
  fail("unexpected standard error")
endif()
