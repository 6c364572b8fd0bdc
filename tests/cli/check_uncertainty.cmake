# SPDX-License-Identifier: GPL-3.0-or-later
# --uncertainty widens the range of every number by what the answers of an input one deviation less and one more say, added
# in quadrature to what was open before; and a number that is a power of the input follows it:
#   cmake -DPROGRAM=... -DINPUT=<key> -DVALUE=<as typed> -DDEVIATION=<as typed> -DLESS=<as typed> -DMORE=<as typed>
#     [-DPOWER=<field>=<exponent of MORE/VALUE>] [-DWITHOUT=<field that is left out>] -DFILE=<to be written>
#     -P check_uncertainty.cmake -- <the other arguments of estimate>
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/arguments.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/study_files.cmake")
find_program(awk awk REQUIRED)

# ask(<variable> <value of the input> <more arguments>...): the JSON of estimate
function(ask variable value)
  execute_process(COMMAND "${PROGRAM}" estimate ${arguments} "--${INPUT}" "${value}" ${ARGN} --json
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    fail("estimate --${INPUT} ${value} ${ARGN}")
  endif()
  set(${variable} "${out}" PARENT_SCOPE)
endfunction()

ask(exact "${VALUE}")
ask(less "${LESS}")
ask(more "${MORE}")
ask(uncertain "${VALUE}" --uncertainty "${INPUT}=${DEVIATION}")
set(code 0)
set(out "${uncertain}")
set(lines "")
foreach(field shear_modulus horizontal_shear_modulus bulk_modulus young_modulus shear_wave_speed
    compression_wave_speed bulk_density mechanical_coordination_number coordination_number poisson_ratio stress_exponent)
  if(field STREQUAL WITHOUT)
    continue()
  endif()
  set(line "${field}")
  foreach(place "exact;value" "exact;low" "exact;high" "less;value" "more;value" "uncertain;value" "uncertain;low" "uncertain;high")
    list(GET place 0 run)
    list(GET place 1 part)
    string(JSON number GET "${${run}}" answer ${field} ${part})
    string(APPEND line " ${number}")
  endforeach()
  string(APPEND lines "${line}\n")
endforeach()
set(program [[
function beyond(number) { return number > 0 ? number : 0 }
function far(a, b) { return (a - b > tolerance) || (b - a > tolerance) }
{
  log_scale = $1 != "poisson_ratio" && $1 != "stress_exponent"
  for (k = 2; k <= 9; ++k) x[k] = log_scale ? log($k) : $k
  tolerance = $1 == "stress_exponent" ? 1e-6 : 1e-9
  least = x[5] < x[6] ? x[5] : x[6]; most = x[5] > x[6] ? x[5] : x[6]
  down = sqrt((x[2] - x[3])^2 + beyond(x[2] - least)^2)
  up = sqrt((x[4] - x[2])^2 + beyond(most - x[2])^2)
  if (far(x[7], x[2])) print $1 " has the value " $7 ", expected " $2
  if (far(x[2] - x[8], down) || far(x[9] - x[2], up)) print $1 " has the range " $8 " to " $9 "; distances should be " down " and " up
  tolerance = 5e-6 # of cones under 0.1 Pa, whose branches are shortened by 2e-6
  if ($1 == field && far((x[6] - x[2]) / log(to / from), power)) print $1 " grows by " $6 / $2 ", expected " to / from "^" power
}
END { if (NR < 10) print NR " lines" }
]])
string(REGEX MATCH "^([^=]*)=(.*)$" matched "${POWER}")
set(field "${CMAKE_MATCH_1}")
set(power "${CMAKE_MATCH_2}")
string(REGEX MATCH "^[0-9.]+" from "${VALUE}")
string(REGEX MATCH "^[0-9.]+" to "${MORE}")
file(WRITE "${FILE}" "${lines}")
execute_process(COMMAND "${awk}" -v "field=${field}" -v "power=${power}" -v "from=${from}" -v "to=${to}" "${program}" "${FILE}"
  OUTPUT_VARIABLE faults ERROR_VARIABLE err RESULT_VARIABLE code)
if(NOT code EQUAL 0 OR NOT faults STREQUAL "")
  fail("${faults}")
endif()

# It is stated, not assumed.
string(JSON stated ERROR_VARIABLE problem GET "${uncertain}" answer stated_deviations "${INPUT}")
string(JSON assumed ERROR_VARIABLE absent GET "${uncertain}" answer assumed_deviations "${INPUT}")
if(problem OR NOT absent)
  fail("${INPUT} is not among the stated deviations alone")
endif()
