# SPDX-License-Identifier: GPL-3.0-or-later
# Included by tests that run as `cmake ... -P check.cmake -- <arguments of the program>`: the list `arguments` is what
# stands behind the first `--`.
set(arguments "")
set(past_separator FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(k RANGE ${last})
  if(past_separator)
    list(APPEND arguments "${CMAKE_ARGV${k}}")
  elseif(CMAKE_ARGV${k} STREQUAL "--")
    set(past_separator TRUE)
  endif()
endforeach()
