# SPDX-License-Identifier: GPL-3.0-or-later
# Gathers the pages, runs doxygen over them and the headers, puts MathJax beside its HTML, and fails if doxygen warned.
#   cmake -DROOT=<source tree> -DOUTPUT=<folder> -DDOXYGEN=<program> -DDOXYFILE=<file> -DMATHJAX=<folder or NOTFOUND>
#         [-DPYTHON=<interpreter> -DPACKAGE=<folder of granum>] [-DPROGRAM=<granum>] -P make_docs.cmake
# With PYTHON the pages of the package of Python and of the notebooks are made, with PROGRAM the gallery.
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/copy_pages.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/namespaces.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/sources_page.cmake")

file(REMOVE_RECURSE "${OUTPUT}/pages" "${OUTPUT}/html" "${OUTPUT}/warnings.txt")
file(GLOB pages RELATIVE "${ROOT}" "${ROOT}/docs/*.md" "${ROOT}/validation/*/*.md" "${ROOT}/README.md"
  "${ROOT}/CHANGELOG.md" "${ROOT}/bench/README.md" "${ROOT}/bench/results/*.md" "${ROOT}/bench/*/README.md"
  "${ROOT}/tests/peer/README.md")
copy_pages("${ROOT}" "${OUTPUT}/pages" "${OUTPUT}/html" ${pages})
# Pages below others in the side bar; doxygen calls a page without a name of its own by its path.
function(put_below page title)
  set(list "\n## ${title}\n\n")
  foreach(path IN LISTS ARGN)
    string(REGEX REPLACE "[/.]" "_" name "md_${path}")
    string(REGEX REPLACE "_md$" "" name "${name}")
    if(EXISTS "${OUTPUT}/pages/${path}")
      string(APPEND list "- \\subpage ${name}\n")
    endif()
  endforeach()
  file(APPEND "${OUTPUT}/pages/${page}" "${list}")
endfunction()
file(GLOB cases RELATIVE "${ROOT}" "${ROOT}/validation/*/*.md")
file(GLOB results RELATIVE "${ROOT}" "${ROOT}/bench/results/*.md" "${ROOT}/bench/*/README.md")
put_below(docs/validation.md "Cases" ${cases} tests/peer/README.md)
put_below(bench/README.md "Results" ${results})
file(WRITE "${OUTPUT}/pages/docs/project.md" "# The project {#project}\n")
foreach(name architecture extending additions promises page sources md_CHANGELOG md_bench_README)
  if(EXISTS "${ROOT}/docs/${name}.md" OR name STREQUAL "sources" OR EXISTS "${ROOT}/CHANGELOG.md")
    file(APPEND "${OUTPUT}/pages/docs/project.md" "\n- \\subpage ${name}")
  endif()
endforeach()
write_sources_page("${ROOT}/validation/references.bib" "${OUTPUT}/pages/sources.md")
write_namespaces("${ROOT}/docs/architecture.md" "${ROOT}/include/granum" "${OUTPUT}/pages/namespaces.dox")

# make_pages(<script> <argument>...): by a script of docs/site.
function(make_pages script)
  set(site "${ROOT}/docs/site")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${PACKAGE}" PYTHONDONTWRITEBYTECODE=1
    "${PYTHON}" "${site}/${script}.py" ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
if(PYTHON)
  make_pages(python_pages "${OUTPUT}/pages")
  make_pages(notebook_pages "${ROOT}" "${OUTPUT}/pages" "${OUTPUT}/html/notebooks")
else()
  file(WRITE "${OUTPUT}/pages/python_api.md" "# Python API {#python_api}\n\nThis site was made without the package.\n")
  file(WRITE "${OUTPUT}/pages/notebooks.md" "# Notebooks {#notebooks}\n\nThis site was made without the package.\n")
endif()
if(PYTHON AND PROGRAM)
  make_pages(gallery "${ROOT}" "${PROGRAM}" "${OUTPUT}/pages/gallery.md" "${OUTPUT}/html/gallery")
else()
  file(WRITE "${OUTPUT}/pages/gallery.md" "# Gallery {#gallery}\n\nThis site was made without the program.\n")
endif()

# The first pages of the side bar, in their order.
set(first "")
foreach(page docs/start docs/commands docs/cluster gallery notebooks docs/python python_api docs/theory docs/glossary docs/literature docs/laboratory
    docs/validation docs/project)
  if(EXISTS "${OUTPUT}/pages/${page}.md")
    string(APPEND first " \"${OUTPUT}/pages/${page}.md\"")
  endif()
endforeach()
set(ENV{GRANUM_DOCS_FIRST} "${first}") # named in the Doxyfile
set(ENV{GRANUM_DOCS_ROOT} "${ROOT}")
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
