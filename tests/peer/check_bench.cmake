# SPDX-License-Identifier: GPL-3.0-or-later
# Runs bench/peers/run.sh at its smallest and looks at what it wrote:
#   cmake -DBENCH=bench/peers -DENGINE=bench_peer_engine -DROWS=11 -DFOLDER=... -P check_bench.cmake
cmake_minimum_required(VERSION 3.25)

# run(CODE COMMAND...): fails unless the command ends with that exit code; its output is in `output`.
function(run expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "${ARGN}: exit code ${code}, not ${expected}\n${out}\n${err}")
  endif()
  set(output "${out}${err}" PARENT_SCOPE)
endfunction()

# field(LINE NAME OUT): the value of a column; `headings` and LINE are lines of a CSV file without quotes.
function(field line name out)
  string(REPLACE "," ";" names "${headings}")
  string(REPLACE "," ";" values "${line}")
  list(FIND names ${name} k)
  if(k LESS 0)
    message(FATAL_ERROR "no column ${name} in ${headings}")
  endif()
  list(GET values ${k} value)
  set(${out} "${value}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}/none")
set(bench "${BENCH}/run.sh" --sizes 500 --rounds 1 --work 5e4 --engine "${ENGINE}" --packings "${FOLDER}/packings"
  --out "${FOLDER}/results")
run(0 ${bench})

file(STRINGS "${FOLDER}/results/peers.csv" lines)
list(POP_FRONT lines headings)
list(LENGTH lines rows)
if(NOT rows EQUAL ROWS)
  message(FATAL_ERROR "${rows} rows, not ${ROWS}:\n${lines}")
endif()
list(GET lines 0 first)
field("${first}" engine engine)
field("${first}" contacts contacts)
if(NOT engine STREQUAL granum OR contacts LESS 1000)
  message(FATAL_ERROR "no dense packing of 500 grains: ${first}")
endif()
foreach(line IN LISTS lines)
  field("${line}" contacts theirs)
  if(NOT theirs EQUAL contacts)
    message(FATAL_ERROR "${contacts} contacts of granum, not ${theirs}: ${line}")
  endif()
  foreach(column grain_steps_per_s min max)
    field("${line}" ${column} speed)
    if(NOT speed MATCHES "^[0-9.]+(e[+][0-9]+)?$" OR NOT speed GREATER 0)
      message(FATAL_ERROR "${column} is ${speed}: ${line}")
    endif()
  endforeach()
endforeach()

# Results stay as they are without --force.
run(2 ${bench})
if(NOT output MATCHES "exists")
  message(FATAL_ERROR "${output}")
endif()

# Codes whose states differ are found out, in any round.
set(granum granum,law,0,1,500,100,1500,1e5)
set(other YADE,law,0,1,500,100)
file(WRITE "${FOLDER}/same.csv" "round,engine,style,version,cores,grains,steps,contacts,pressure_Pa,contacts_after,"
  "pressure_after_Pa,seconds,cpu_share\n1,${granum},1500,1e5,1,1\n1,${other},1500,1.009e5,1486,1e5,2,1\n"
  "2,${granum},1500,1e5,1,1\n")
set(expected 0) # of the first, which is within the limits
foreach(line ${other},1500,1.009e5,1486,1e5 ${other},1501,1e5,1500,1e5 ${other},1500,1.011e5,1500,1e5
    ${other},1500,1e5,1484,1e5 ${other},1500,1e5,1500,0.989e5)
  file(COPY_FILE "${FOLDER}/same.csv" "${FOLDER}/case.csv")
  file(APPEND "${FOLDER}/case.csv" "2,${line},2,1\n")
  run(${expected} python3 "${BENCH}/table.py" "${FOLDER}/case.csv" "${FOLDER}/results")
  set(expected 1)
endforeach()

# Without any other code there is nothing to compare with.
foreach(tool bash dirname)
  find_program(${tool} ${tool} REQUIRED)
  file(CREATE_LINK "${${tool}}" "${FOLDER}/none/${tool}" SYMBOLIC)
endforeach()
set(ENV{PATH} "${FOLDER}/none")
run(3 ${bench} --force)
foreach(code LAMMPS LIGGGHTS YADE)
  if(NOT output MATCHES "${code} is left out")
    message(FATAL_ERROR "${output}")
  endif()
endforeach()
