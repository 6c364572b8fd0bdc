# SPDX-License-Identifier: GPL-3.0-or-later
# The picture of a fit holds every row, the law and the two slopes, and is kept when it is there already:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_fit_picture.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

function(fit expected)
  execute_process(COMMAND "${PROGRAM}" fit ${ARGN} RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE err)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "fit ${ARGN}: exit code ${code}, expected ${expected}\n${err}")
  endif()
endfunction()

# check_picture(<file> <text>...): the picture says each of them.
function(check_picture file)
  file(READ "${file}" svg)
  foreach(text ${ARGN})
    string(FIND "${svg}" "${text}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${file} does not say '${text}'")
    endif()
  endforeach()
endfunction()

set(picture "${FOLDER}/isotropic.svg")
fit(0 isotropic_by_hand.csv --picture "${picture}")
check_picture("${picture}" "law, s = 0.349" "1/(1+α) = 0.500, cone" "1/(1+α) = 0.333, sphere" "p [kPa]" "G_max/f(e) [MPa]" "measured")
fit(3 isotropic_by_hand.csv --picture "${picture}")
fit(0 isotropic_by_hand.csv --picture "${picture}" --force)
fit(0 hv_dense_cone.csv --picture "${FOLDER}/anisotropic.svg")
check_picture("${FOLDER}/anisotropic.svg" "law, s = 0.510" "σ_h^0.273 σ_v^0.237")
