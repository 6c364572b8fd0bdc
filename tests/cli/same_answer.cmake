# SPDX-License-Identifier: GPL-3.0-or-later
# Included by tests of sweeps, which define run() and fail() first.

set(answer_fields shear_modulus shear_wave_speed compression_wave_speed bulk_modulus young_modulus poisson_ratio
  horizontal_shear_modulus horizontal_shear_wave_speed horizontal_compression_wave_speed horizontal_young_modulus bulk_density
  mechanical_coordination_number rattler_fraction coordination_number vertical_exponent horizontal_exponent stress_exponent)

# same_answer(<sweep as JSON> <index> <estimate's arguments>...): the answer at one state of the sweep is that of
# `granum estimate`, letter by letter
function(same_answer sweep index)
  run(estimate --json ${ARGN})
  if(NOT code EQUAL 0)
    fail("estimate ${ARGN}")
  endif()
  foreach(quantity ${answer_fields})
    string(JSON shape GET "${out}" answer grain_shape)
    if(shape STREQUAL "sand" AND quantity MATCHES "rattler_fraction|^coordination_number")
      continue() # which nobody knows of a sand
    endif()
    string(JSON swept GET "${sweep}" states ${index} answer ${quantity}) # empty where there is none, as without stress
    string(JSON estimated GET "${out}" answer ${quantity})
    if(NOT swept STREQUAL estimated OR (NOT swept MATCHES "high.*low.*value" AND NOT quantity MATCHES "exponent"))
      fail("state ${index}: ${quantity} is '${swept}', estimate says '${estimated}'")
    endif()
  endforeach()
endfunction()
