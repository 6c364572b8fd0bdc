# SPDX-License-Identifier: GPL-3.0-or-later
# Ground in layers, and tables whose rows are depths, have the answers of level ground, to the bit:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_layers.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

# The states of a sweep.
function(states name)
  execute_process(COMMAND "${PROGRAM}" sweep ${ARGN} --json RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "sweep ${ARGN}: exit code ${code}, ${err}")
  endif()
  string(JSON all GET "${out}" states)
  set(${name} "${all}" PARENT_SCOPE)
endfunction()

function(same of_one at_one of_other at_other)
  foreach(key stress_v stress_h pore_pressure answer:shear_modulus answer:compression_wave_speed answer:stress_exponent)
    string(REPLACE ":" ";" path "${key}")
    string(JSON one GET "${of_one}" ${at_one} ${path})
    string(JSON other GET "${of_other}" ${at_other} ${path})
    if(NOT one STREQUAL other)
      message(FATAL_ERROR "${key}: ${one} and ${other}")
    endif()
  endforeach()
endfunction()

set(soil --unit-weight 15kN/m3 --saturated-unit-weight 18.8kN/m3 --k0 0.5 --sand toyoura)
set(span --depth 1m..21m --points 4)
set(down --depth 1m..21m --points 5 --water-table 6m)
states(plain --void-ratio 0.8 ${soil} ${down})

# One layer is level ground; so are the first metres of three.
file(WRITE "${FOLDER}/one.csv" "top_m,e\n0,0.8\n")
states(one --layers "${FOLDER}/one.csv" ${soil} ${down})
foreach(k RANGE 4)
  same("${plain}" ${k} "${one}" ${k})
endforeach()
states(three --layers layers.csv ${down})
same("${plain}" 0 "${three}" 0)

# Below, the weights add up: 4 m of 15 and 2 m of 16 kN/m3, then 4 m of 19.3 in water of 9.787037.
states(at_ten --layers layers.csv --depth 6m..10m --points 2 --water-table 6m)
foreach(k_and_stress "0 92000" "1 130051.85")
  separate_arguments(k_and_stress)
  list(GET k_and_stress 0 k)
  list(GET k_and_stress 1 stress)
  string(JSON found GET "${at_ten}" ${k} stress_v)
  if(NOT found MATCHES "^${stress}")
    message(FATAL_ERROR "sigma_v at the end of a layer: ${found}, not ${stress}")
  endif()
endforeach()

# The water table as a column, of any row, is the option; a second one is refused with its line.
file(WRITE "${FOLDER}/wet.csv" "top_m,e,unit_weight_kN/m3,saturated_unit_weight_kN/m3,k0,sand,water_table_m\n"
  "0,0.80,15,18.8,0.5,toyoura,\n4,0.72,16,19.3,0.45,hostun,6\n10,0.65,17,20,0.4,,\n")
states(wet --layers "${FOLDER}/wet.csv" ${span})
states(by_option --layers layers.csv ${span} --water-table 6m)
foreach(k RANGE 3)
  same("${wet}" ${k} "${by_option}" ${k})
endforeach()
file(WRITE "${FOLDER}/two.csv" "top_m,e,water_table_m\n0,0.80,3\n4,0.72,6\n")
execute_process(COMMAND "${PROGRAM}" sweep --layers "${FOLDER}/two.csv" ${span} RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE err)
if(NOT (code EQUAL 3 AND err MATCHES "two.csv:3: "))
  message(FATAL_ERROR "two water tables: exit code ${code}, ${err}")
endif()

# A row with its own ground is a depth of that ground.
file(WRITE "${FOLDER}/sites.csv" "site,depth_m,e,unit_weight_kN/m3,saturated_unit_weight_kN/m3,water_table_m,k0,sand\n"
  "A,6,0.8,15,18.8,6,0.5,toyoura\nB,11,0.8,15,18.8,6,0.5,toyoura\nC,11,0.7,17,,,,\n")
states(sites --table "${FOLDER}/sites.csv")
same("${plain}" 1 "${sites}" 0)
same("${plain}" 2 "${sites}" 1)
states(third --void-ratio 0.7 --unit-weight 17kN/m3 --depth 11m..12m --points 2)
same("${third}" 0 "${sites}" 2)
