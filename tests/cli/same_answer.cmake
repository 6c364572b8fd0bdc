# SPDX-License-Identifier: GPL-3.0-or-later
# Included by tests of sweeps, which define run() and fail() first.

# same_answer(<sweep as JSON> <index> <estimate's arguments>...): the answer at one state of the sweep is that of
# `granum estimate`, letter by letter
function(same_answer sweep index)
  run(estimate --json ${ARGN})
  if(NOT code EQUAL 0)
    fail("estimate ${ARGN}")
  endif()
  foreach(quantity shear_modulus shear_wave_speed compression_wave_speed bulk_modulus poisson_ratio bulk_density
      mechanical_coordination_number rattler_fraction)
    foreach(part value low high)
      string(JSON swept GET "${sweep}" states ${index} answer ${quantity} ${part})
      string(JSON estimated GET "${out}" answer ${quantity} ${part})
      if(NOT swept STREQUAL estimated OR swept STREQUAL "")
        fail("state ${index}: ${quantity} ${part} is '${swept}', estimate says '${estimated}'")
      endif()
    endforeach()
  endforeach()
endfunction()
