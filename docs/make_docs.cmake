# SPDX-License-Identifier: GPL-3.0-or-later
# Gathers the pages, runs doxygen over them and the headers, puts MathJax beside its HTML, and fails if doxygen warned.
#   cmake -DROOT=<source tree> -DOUTPUT=<folder> -DDOXYGEN=<program> -DDOXYFILE=<file> -DMATHJAX=<folder or NOTFOUND>
#         -P make_docs.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/copy_pages.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/sources_page.cmake")

file(REMOVE_RECURSE "${OUTPUT}/pages" "${OUTPUT}/html" "${OUTPUT}/warnings.txt")
file(GLOB pages RELATIVE "${ROOT}" "${ROOT}/docs/*.md" "${ROOT}/validation/*/README.md" "${ROOT}/README.md"
  "${ROOT}/CHANGELOG.md" "${ROOT}/bench/README.md" "${ROOT}/bench/results/*.md" "${ROOT}/bench/*/README.md"
  "${ROOT}/tests/peer/README.md")
copy_pages("${ROOT}" "${OUTPUT}/pages" "${OUTPUT}/html" ${pages})
write_sources_page("${ROOT}/validation/references.bib" "${OUTPUT}/pages/sources.md")

set(ENV{GRANUM_DOCS_ROOT} "${ROOT}") # named in the Doxyfile
set(ENV{GRANUM_DOCS_OUTPUT} "${OUTPUT}")
execute_process(COMMAND "${DOXYGEN}" "${DOXYFILE}" WORKING_DIRECTORY "${ROOT}" COMMAND_ERROR_IS_FATAL ANY)
if(MATHJAX)
  file(CREATE_LINK "${MATHJAX}" "${OUTPUT}/html/mathjax" SYMBOLIC)
else()
  message(STATUS "No local MathJax: formulas stay as they are typed (Debian: libjs-mathjax)")
endif()
file(READ "${OUTPUT}/warnings.txt" warnings)
if(NOT warnings STREQUAL "")
  message(FATAL_ERROR "doxygen warns:\n${warnings}")
endif()
