# SPDX-License-Identifier: GPL-3.0-or-later
# A trade study writes four files that agree with each other, and keeps them without --force:
#   cmake -DPROGRAM=... -DFOLDER=... -P check_trade_files.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/study_files.cmake")

macro(run)
  execute_process(
    COMMAND "${PROGRAM}" trade --quick --grains 60 --set study.densities=dense
      --set study.pressures=20kPa,40kPa,80kPa --out "${FOLDER}" ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
endmacro()

file(REMOVE_RECURSE "${FOLDER}")
run()
if(NOT (code EQUAL 0 AND err STREQUAL ""))
  fail("a small study does not run")
endif()
foreach(line "inertial number of compression" "time step over its stability limit" "rough-walls 125"
    "500 +dense +2 .* reference\n")
  if(NOT out MATCHES "${line}")
    fail("the table lacks '${line}'")
  endif()
endforeach()
read_files("${FOLDER}" "manifest.json;samples.csv;trade.csv;trade.svg")
string(JSON complete GET "${manifest}" complete)
if(NOT complete STREQUAL ON)
  fail("the manifest says complete: ${complete}")
endif()
# Rows: 3 sizes, 3 rates of compression, 3 of shear, 3 time steps, 3 probes and the network; periodic cells of 125
# and 500 grains, and 125 between smooth and rough walls.
string(JSON rows LENGTH "${manifest}" rows)
file(STRINGS "${FOLDER}/trade.csv" lines REGEX ",dense,")
list(LENGTH lines count)
if(NOT (rows EQUAL 20 AND count EQUAL 20))
  fail("${rows} rows in the manifest, ${count} in trade.csv, expected 20")
endif()
file(STRINGS "${FOLDER}/samples.csv" samples REGEX "^shear,periodic,[0-9.e-]+,dense,[12],")
list(LENGTH samples count)
if(NOT count EQUAL 6)
  fail("samples.csv has ${count} shear tests, expected 6")
endif()
file(READ "${FOLDER}/trade.svg" picture)
if(NOT (picture MATCHES "^<svg" OR picture MATCHES "<svg [^\n]*") OR NOT picture MATCHES ">Grains<")
  fail("the picture has no curve of sizes")
endif()
file(SHA256 "${FOLDER}/manifest.json" before)
run()
file(SHA256 "${FOLDER}/manifest.json" after)
if(NOT (code EQUAL 3 AND err MATCHES "trade\\.csv: exists already and is kept" AND before STREQUAL after))
  fail("existing results are not kept")
endif()
