# SPDX-License-Identifier: GPL-3.0-or-later
# The answer of estimate is in at most 16 lines of 80 characters, and each of its numbers is on the full screen too:
#   cmake -DPROGRAM=... -P check_first_screen.cmake
cmake_minimum_required(VERSION 3.25)

function(check_first_screen)
  foreach(more "" --full)
    execute_process(COMMAND "${PROGRAM}" estimate ${ARGN} ${more} RESULT_VARIABLE code OUTPUT_VARIABLE out${more} ERROR_QUIET)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "${ARGN}: exit code ${code}")
    endif()
  endforeach()
  string(REPLACE ";" "," lines "${out}")
  string(REGEX MATCHALL "[^\n]*\n" lines "${lines}")
  list(LENGTH lines count)
  if(count GREATER 16)
    message(FATAL_ERROR "${ARGN}: ${count} lines\n${out}")
  endif()
  foreach(line IN LISTS lines)
    string(LENGTH "${line}" length) # with its end
    if(length GREATER 81)
      message(FATAL_ERROR "${ARGN}: a line of ${length} characters: ${line}")
    endif()
  endforeach()
  string(REGEX MATCHALL "[0-9]+\\.[0-9]+" numbers "${out}")
  foreach(number IN LISTS numbers)
    string(FIND "${out--full}" "${number}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${ARGN}: --full lacks ${number}\n${out--full}")
    endif()
  endforeach()
endfunction()

foreach(stress "--pressure;100kPa" "--pressure;123456kPa" "--pressure;0kPa" "--stress-v;200kPa;--k0;0.5")
  foreach(grains "" "--grain-shape;sand" "--grain-shape;sphere;--preparation;dense" "--sand;toyoura;--strain;0.1%"
      "--fabric;0.1;--saturation;100%" "--coordination-number;5.2;--rattler-fraction;2%" "--uniformity;2;--grain-shape;sphere")
    check_first_screen(--void-ratio 0.65 ${stress} ${grains})
  endforeach()
endforeach()
