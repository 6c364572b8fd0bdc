# SPDX-License-Identifier: GPL-3.0-or-later
# The whole analysis of a packing of 10,000 grains that LAMMPS made, against what LAMMPS printed and what was recorded:
#   cmake -DPROGRAM=... -DDATA=<examples/data> -P check_real_packing.cmake
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND "${PROGRAM}" analyse "${DATA}/lammps_loose_p50.atoms.gz" "${DATA}/lammps_loose_p50.contacts.gz" --json
  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT (code EQUAL 0 AND err STREQUAL ""))
  message(FATAL_ERROR "exit code ${code}\n${err}")
endif()

# check(<regex> <key>...): a number of the first frame
set(failures 0)
function(check regex)
  string(JSON value GET "${out}" frames 0 ${ARGN})
  if(NOT value MATCHES "${regex}")
    message(NOTICE "${ARGN} is ${value}, expected ${regex}")
    math(EXPR count "${failures} + 1")
    set(failures ${count} PARENT_SCOPE)
  endif()
endfunction()

# LAMMPS' own pressures to 1e-10, the digits that are fixed by that
check("^49035\\.55655[34]" stress by_contacts xx)
check("^50081\\.00942[56]" stress by_contacts yy)
check("^50855\\.79134[78]" stress by_contacts zz)
check("^-348\\.7204067[78]" stress by_contacts xy)
check("^361\\.551693[67]" stress by_contacts xz)
check("^-259\\.0076620[56]" stress by_contacts yz)
# an independent reader of the same files: 20,172 contacts, C_n 4.0344, 830 grains without one, a = 0.0142
check("^20172$" counts contacts)
check("^4\\.034(4|39999)" counts coordination_number)
check("^830$" counts grains_without_contact)
check("^0\\.0141[5-9]|^0\\.0142[0-4]" fabric anisotropy)
# what LAMMPS was given: G = 30 GPa, spheres, a friction angle of 26.5 degrees, tan 0.498582
check("^(3000000|2999999)[0-9][0-9][0-9][0-9]\\." grain shear_modulus)
check("^(2\\.00000|1\\.99999)" contact_law alpha value) # viscous parts are left
check("^0\\.4985[78]" forces friction_coefficient)
# recorded: the network, and the relaxed estimate within its error of it
check("^4625[0-9][0-9][0-9][0-9]\\.|^4626[0-9][0-9][0-9][0-9]\\." moduli rung4 G)
check("^1027[0-9][0-9][0-9][0-9][0-9]\\.|^1026[0-9][0-9][0-9][0-9][0-9]\\." moduli rung4 K)
check("^1\\.05[56]" moduli rung3 measured_over_this G)
if(failures GREATER 0)
  message(FATAL_ERROR "${failures} numbers are wrong")
endif()
