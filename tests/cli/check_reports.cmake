# SPDX-License-Identifier: GPL-3.0-or-later
# Reports as a client reads them: what was asked, the answer in words, assumptions and sources, and a way from each citation
# to its source:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_reports.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
set(report "${FOLDER}/report.html")

# run(<exit code> <argument>...): sets `page`.
function(run expected)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} --report "${report}" RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE err)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "${ARGN}: exit code ${code}, ${err}")
  endif()
  if(EXISTS "${report}")
    file(READ "${report}" page)
    set(page "${page}" PARENT_SCOPE)
  endif()
endfunction()

# holds(<text>...): in the page, whose citations all lead to a source.
function(holds)
  string(TIMESTAMP today "%d %B %Y" UTC)
  string(REGEX REPLACE "^0" "" today "${today}")
  foreach(text IN LISTS ARGN ITEMS "${today}" "What was asked" "granum [0-9]+\\.[0-9]" "<h2>Assumptions</h2>" "<h2>Sources</h2>" "</svg>")
    if(NOT page MATCHES "${text}")
      message(FATAL_ERROR "the report lacks ${text}")
    endif()
  endforeach()
  string(REGEX MATCHALL "href=\"#[A-Za-z0-9]+\"" cited "${page}")
  list(REMOVE_DUPLICATES cited)
  foreach(link IN LISTS cited)
    string(REGEX REPLACE "href=\"#(.*)\"" "<td id=\"\\1\">" row "${link}")
    string(FIND "${page}" "${row}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "${link} leads nowhere")
    endif()
  endforeach()
  if(NOT cited OR page MATCHES "from memory|not found in")
    message(FATAL_ERROR "nothing is cited, or the report has '${CMAKE_MATCH_0}'")
  endif()
endfunction()

run(0 sweep --depth 0m..30m --points 7 --sand toyoura --relative-density 60% --water-table 2m --k0 0.5)
holds("At 30 m, p' = 191 kPa, G is" "one standard deviation to each side" "<td class=\"number\">60%</td>" "Every row" "as cited by Millen")
run(3 sweep --void-ratio 0.6 --from 50kPa --to 400kPa) # which is kept
file(REMOVE "${report}")
run(0 sweep --void-ratio 0.6 --from 50kPa --to 400kPa --points 3)
holds("<h1>Stiffness along a stress path</h1>" "Every row" "G_hv_rung3_" "<td>--from</td>")
run(0 estimate --relative-density 60% --uniformity 8 --d50 4mm --pressure 100kPa --force)
holds("Within two standard deviations G of a sand is [0-9.]+ MPa to [0-9.]+ MPa" "sand \\(measured laws\\): G is" "two thirds" "<td class=\"number\">4mm</td>" "<a href=\"#WangStokoe2022\">" "<th class=\"number\">bias</th>")

# A table with decimal commas has a report with decimal commas; what was typed, versions and references stay.
file(WRITE "${FOLDER}/speeds.csv" "p_kPa;e;V_s_m/s\n22,5;0,72;165\n48,0;0,70;198,5\n")
run(0 infer --table "${FOLDER}/speeds.csv" --grain-shape sand --measurement-error 2.5% --predict-pressure 200kPa --force)
holds("forecast at p' = 200 kPa, e = 0,72: G [0-9]+,[0-9]+ MPa" "one standard error" "2\\.5%" "147\\(5\\), 04021020" "level 1 is G = ")
if(page MATCHES ">[^<]* 0\\.72[ <]")
  message(FATAL_ERROR "a decimal point stays: ${CMAKE_MATCH_0}")
endif()
