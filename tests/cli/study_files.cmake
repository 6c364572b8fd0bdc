# SPDX-License-Identifier: GPL-3.0-or-later
# What the checks of written studies share: how they fail, and the files of a folder.
function(fail what)
  message(FATAL_ERROR "${what}\n--- exit code ${code}, standard output:\n${out}\n--- standard error:\n${err}")
endfunction()

# Results are these files and nothing else; sets `manifest` to the text of one of them.
macro(read_files folder names)
  file(GLOB written RELATIVE "${folder}" "${folder}/*" "${folder}/.[a-z]*")
  list(SORT written)
  if(NOT "${written}" STREQUAL "${names}")
    fail("files are ${written}, expected ${names}")
  endif()
  file(READ "${folder}/manifest.json" manifest)
endmacro()

macro(read_results folder)
  read_files("${folder}" "exponents.csv;figures;manifest.json;report.html;scene.toml;states.csv")
endmacro()
