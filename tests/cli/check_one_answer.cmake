# SPDX-License-Identifier: GPL-3.0-or-later
# One state has one answer, letter by letter, whether estimate, a path, a depth or a row of a table asks for it:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_one_answer.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/study_files.cmake")

macro(run)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0)
    fail("granum ${ARGN}")
  endif()
endmacro()
include("${CMAKE_CURRENT_LIST_DIR}/same_answer.cmake")

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
# ask_by_table(<index of a state in `sweep`> <sigma_v> <sigma_h> <saturation>): the same state as the row of a table
macro(ask_by_table index v h saturation)
  file(WRITE "${FOLDER}/state.csv" "e,sigma_v_Pa,sigma_h_Pa,saturation\n0.65,${v},${h},${saturation}\n")
  string(REPLACE "--void-ratio;0.65;" "" rest "${packing}")
  run(sweep ${rest} --table "${FOLDER}/state.csv" --json)
  foreach(quantity ${answer_fields})
    string(JSON a GET "${sweep}" states ${index} answer ${quantity})
    string(JSON b GET "${out}" states 0 answer ${quantity})
    if(NOT a STREQUAL b OR a STREQUAL "")
      fail("${quantity}: ${a}, by a table ${b}")
    endif()
  endforeach()
endmacro()

foreach(known "--grain-shape;sphere" "--grain-shape;sphere;--preparation;loose" "--rattler-fraction;3%" "--coordination-number;5.1"
    "--mechanical-coordination-number;5.2;--rattler-fraction;2%" "--grain-shape;sand" "--sand;toyoura") # sands last: other fields
  set(packing --void-ratio 0.65 --grain quartz --radius 0.2mm --fabric 0.05 ${known})
  if(known MATCHES "sand") # which has no rattlers that are known, and a softness of its contacts
    list(REMOVE_ITEM answer_fields rattler_fraction coordination_number)
    list(APPEND answer_fields contact_softness strained_shear_modulus modulus_ratio damping_ratio slip_strain pm4sand_coefficient)
    list(APPEND packing --strain 0.02%)
  endif()
  # Ground of equal stresses, whose stress is the beginning of a path.
  run(sweep ${packing} --depth 5m..9m --points 2 --k0 1 --json)
  set(sweep "${out}")
  string(JSON p GET "${sweep}" states 0 stress_v)
  string(JSON h GET "${sweep}" states 0 stress_h)
  if(NOT p STREQUAL h)
    fail("stresses of K_0 = 1: ${p} and ${h}")
  endif()
  same_answer("${sweep}" 0 ${packing} --pressure ${p}Pa)
  ask_by_table(0 ${p} ${p} 0)
  run(sweep ${packing} --from ${p}Pa --to 1MPa --points 2 --json)
  set(sweep "${out}")
  same_answer("${sweep}" 0 ${packing} --pressure ${p}Pa)
  ask_by_table(0 ${p} ${p} 0)
  # Unequal stresses at the end of a path.
  run(sweep ${packing} --path txc --from 80kPa --eta 0.6 --points 2 --saturation 100% --json)
  set(sweep "${out}")
  string(JSON v GET "${sweep}" states 1 sigma_v)
  string(JSON h GET "${sweep}" states 1 sigma_h)
  same_answer("${sweep}" 1 ${packing} --stress-v ${v}Pa --stress-h ${h}Pa --saturation 1)
  ask_by_table(1 ${v} ${h} 1)
endforeach()
