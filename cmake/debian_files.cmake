# SPDX-License-Identifier: GPL-3.0-or-later
# Run by cpack between installing and packing, in the folder of each component: licence and changelog in a folder of the
# package, manual pages compressed, and the package of Python where Debian has them.
set(root "${CMAKE_CURRENT_LIST_DIR}/..")
file(STRINGS "${root}/CITATION.cff" released REGEX "^date-released:")
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" released "${released}")
execute_process(COMMAND date -u -d "${released} 12:00" -R OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(prefix "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr")
  string(TOUPPER "${component}" upper)
  set(package "${CPACK_DEBIAN_${upper}_PACKAGE_NAME}")
  set(folder "${prefix}/share/doc/${package}")
  file(MAKE_DIRECTORY "${folder}")
  file(COPY_FILE "${root}/packaging/debian/copyright" "${folder}/copyright")
  file(WRITE "${folder}/changelog" "granum (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
    "  * Release ${CPACK_PACKAGE_VERSION}; what changed: CHANGELOG.md of the sources.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  if(component STREQUAL "doc" AND EXISTS "${prefix}/share/doc/granum/html") # formulas by Debian's MathJax
    file(CREATE_LINK ../../../javascript/mathjax "${prefix}/share/doc/granum/html/mathjax" SYMBOLIC)
  endif()
  file(GLOB manuals "${prefix}/share/man/man1/*.1")
  execute_process(COMMAND gzip -9nf "${folder}/changelog" ${manuals} COMMAND_ERROR_IS_FATAL ANY)
  if(component STREQUAL "python")
    set(wanted "${prefix}/lib/python3/dist-packages/granum")
    file(GLOB_RECURSE entry "${prefix}/__init__.py")
    get_filename_component(found "${entry}" DIRECTORY)
    if(NOT found MATCHES "^${prefix}/.*/granum$")
      message(FATAL_ERROR "the package of Python is not below ${prefix}: '${entry}'")
    elseif(NOT found STREQUAL wanted)
      file(MAKE_DIRECTORY "${prefix}/lib/python3/dist-packages")
      file(RENAME "${found}" "${wanted}")
      file(REMOVE_RECURSE "${prefix}/local")
    endif()
  endif()
endforeach()
