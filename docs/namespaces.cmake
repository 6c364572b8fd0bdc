# SPDX-License-Identifier: GPL-3.0-or-later

# write_namespaces(<architecture.md> <folder of headers> <path>): what doxygen reads to say of each namespace what
# the table of floors says of the module. Fails where a module has no row.
function(write_namespaces table headers path)
  file(READ "${table}" text)
  set(said "/// \\namespace granum\n/// What every module uses: errors, checks, units, numbers.\n")
  file(GLOB modules RELATIVE "${headers}" "${headers}/*")
  foreach(module IN LISTS modules)
    if(NOT IS_DIRECTORY "${headers}/${module}" OR module STREQUAL "core")
      continue()
    elseif(NOT text MATCHES "\n\\| [0-9] \\| `${module}` \\| ([^\n]*) \\|\n")
      message(FATAL_ERROR "${table} has no row of the module ${module}")
    endif()
    string(APPEND said "\n/// \\namespace granum::${module}\n/// ${CMAKE_MATCH_1}.\n")
  endforeach()
  file(WRITE "${path}" "${said}")
endfunction()
