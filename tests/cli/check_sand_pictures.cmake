# SPDX-License-Identifier: GPL-3.0-or-later
# Published laws stand in pictures of sweeps where --laws asks for them, and only there:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_sand_pictures.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

# Draws a picture, and asks whether it holds the texts.
function(check_picture wanted text)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} --picture "${FOLDER}/picture.svg" --force
    RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE err)
  file(READ "${FOLDER}/picture.svg" svg)
  string(FIND "${svg}" "${text}" at)
  if(NOT code EQUAL 0 OR (wanted AND at EQUAL -1) OR (NOT wanted AND NOT at EQUAL -1))
    message(FATAL_ERROR "${ARGN}: exit code ${code}, '${text}' in the picture should be ${wanted}: ${err}")
  endif()
endfunction()

set(sand --void-ratio 0.7 --grain-shape sand)
foreach(sweep "--from;50kPa;--to;400kPa" "--depth;1m..20m" "--path;txc;--from;100kPa;--eta;0.6")
  check_picture(TRUE "published laws" sweep ${sand} ${sweep} --points 3 --laws)
  check_picture(FALSE "published laws" sweep ${sand} ${sweep} --points 3)
endforeach()
check_picture(FALSE "published laws" sweep ${sand} --from 50kPa --to 400kPa --points 3 --laws --picture-of K)

# Where nothing says what the grains are both stand in the picture by name, along a path and of a table.
file(WRITE "${FOLDER}/rows.csv" "e,p_kPa\n0.65,50\n0.7,100\n")
foreach(states "--void-ratio;0.7;--from;50kPa;--to;400kPa;--points;3" "--table;${FOLDER}/rows.csv")
  foreach(text sand beads "published laws")
    check_picture(TRUE ">${text}<" sweep ${states} --laws)
  endforeach()
  check_picture(FALSE ">answer<" sweep ${states} --laws)
  check_picture(FALSE ">published laws<" sweep ${states})
  check_picture(TRUE ">answer<" sweep ${states} --grain-shape sand)
  check_picture(FALSE ">beads<" sweep ${states} --grain-shape sand)
endforeach()

# estimate draws around its state: over strain with each law of it, else over stress, both answers where nothing says which.
set(state --void-ratio 0.7 --pressure 100kPa)
foreach(text "shear strain [%]" darendeli menq ishibashi-zhang "given strain" range)
  check_picture(TRUE "${text}" estimate ${state} --strain 0.01%)
endforeach()
foreach(text "p' [kPa]" "sand (measured laws)" "beads (spheres of the model)")
  check_picture(TRUE "${text}" estimate ${state})
endforeach()
check_picture(FALSE "beads" estimate ${state} --grain-shape sand)

# The report holds answers, assumptions, warnings and the picture, and nothing is overwritten unasked.
set(report "${FOLDER}/report.html")
execute_process(COMMAND "${PROGRAM}" estimate ${state} --uniformity 9 --report "${report}" --force RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
file(READ "${report}" page)
foreach(text "sand (measured laws)" "id=\"Lo2021\"" "Lo, M. K., Wei, X." "Kokusho, T. (1980)" "as cited by Millen, M." "What was asked" "--uniformity" "shear wave" "a C_u of 9 lies outside" "</svg>" "<pre>Small-strain stiffness")
  string(FIND "${page}" "${text}" at)
  if(NOT code EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "the report lacks ${text}, or exit code ${code}")
  endif()
endforeach()
if(page MATCHES "from memory|not found in|otechnique'" OR page MATCHES "G[^<>]'eotechnique")
  message(FATAL_ERROR "the report has raw or unchecked sources: ${CMAKE_MATCH_0}")
endif()
execute_process(COMMAND "${PROGRAM}" estimate ${state} --report "${report}" RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE err)
if(NOT (code EQUAL 3 AND err MATCHES "exists already"))
  message(FATAL_ERROR "a report is replaced: exit code ${code}, ${err}")
endif()
execute_process(COMMAND "${PROGRAM}" estimate ${state} --report page.pdf RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
if(NOT code EQUAL 2)
  message(FATAL_ERROR "a report that is no page: exit code ${code}")
endif()
check_picture(FALSE "darendeli" estimate ${state} --grain-shape sand)
