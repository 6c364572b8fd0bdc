# SPDX-License-Identifier: GPL-3.0-or-later
# What the checks of interrupted runs of `granum reproduce` share. SIZES may name those of the grains, as grain.sizes.
set(scene --grains 150 --set study.contacts=sphere --set study.densities=dense --set study.pressures=25kPa,50kPa,100kPa
  --set study.probe_pressures= --set shear.paths=TXC,RTXE --set shear.inertial_number=5e-4
  --set shear.largest_strain=0.002 --set shear.strain_step=0.0005)
if(SIZES)
  list(APPEND scene --set grain.sizes=${SIZES})
endif()

function(fail message)
  message(FATAL_ERROR "${message}\nexit code ${code}\n${out}\n${err}")
endfunction()

# The results of a run of one thread that nothing interrupted. What few grains say differs from the paper, which is no failure.
macro(run_whole folder)
  file(REMOVE_RECURSE "${folder}")
  execute_process(COMMAND "${PROGRAM}" reproduce ${scene} --threads 1 --out "${folder}"
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 0 OR NOT err STREQUAL "")
    fail("a whole run must end with 0 and say nothing on standard error")
  endif()
  if(NOT out MATCHES "frozen[ \n]states[ \n]in.*Table 4.*TXC \\[deg\\] +[0-9].*RTXE \\[deg\\] +[0-9]")
    fail("a whole run must print its tables")
  endif()
endmacro()

# Every table must be the same bytes.
function(require_same_results a b)
  foreach(name states curves loops histograms table2 table4 table5 exponents verdicts)
    file(READ "${a}/${name}.csv" first)
    file(READ "${b}/${name}.csv" second)
    if(NOT first STREQUAL second)
      message(FATAL_ERROR "${name}.csv differs between ${a} and ${b}")
    endif()
  endforeach()
  file(STRINGS "${a}/states.csv" lines REGEX "^sphere,dense,1,TXC")
  list(LENGTH lines count)
  if(count LESS 10)
    message(FATAL_ERROR "states.csv has only ${count} states on TXC")
  endif()
endfunction()
