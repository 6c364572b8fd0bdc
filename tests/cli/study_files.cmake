# SPDX-License-Identifier: GPL-3.0-or-later
# What the checks of written studies share: how they fail, and the files of a folder.
function(fail what)
  message(FATAL_ERROR "${what}\n--- exit code ${code}, standard output:\n${out}\n--- standard error:\n${err}")
endfunction()

# Results are three files and nothing else; sets `manifest` to the text of one of them.
macro(read_results folder)
  file(GLOB written RELATIVE "${folder}" "${folder}/*" "${folder}/.[a-z]*")
  list(SORT written)
  if(NOT "${written}" STREQUAL "exponents.csv;manifest.json;states.csv")
    fail("files are ${written}, expected exponents.csv;manifest.json;states.csv")
  endif()
  file(READ "${folder}/manifest.json" manifest)
endmacro()
