# SPDX-License-Identifier: GPL-3.0-or-later
# Components, which become the packages of cmake/GranumPackage.cmake: program (what people run), dev (what compilers and
# linkers read), python and doc.
include(CMakePackageConfigHelpers)

set(granum_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/granum")

# One export a library: a project that names one component loads only what that component needs.
foreach(library IN LISTS granum_built)
  install(TARGETS granum_${library}
    EXPORT granum-${library}
    FILE_SET HEADERS COMPONENT dev
    FILE_SET lone_headers COMPONENT dev
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev)
  install(EXPORT granum-${library} NAMESPACE granum:: DESTINATION "${granum_config_dir}" COMPONENT dev)
endforeach()

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/granumConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/granumConfig.cmake" INSTALL_DESTINATION "${granum_config_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/granumConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/granumConfig.cmake" "${PROJECT_BINARY_DIR}/granumConfigVersion.cmake"
  DESTINATION "${granum_config_dir}" COMPONENT dev)
install(FILES "${PROJECT_SOURCE_DIR}/cmake/GranumLibraries.cmake" DESTINATION "${granum_config_dir}"
  RENAME granumLibraries.cmake COMPONENT dev)
# For pkg-config. Static libraries leave it to the user to link what they need.
# granum_pkg_config(<name> <description> <library>...)
function(granum_pkg_config name description)
  set(libraries "")
  set(packages "")
  foreach(library IN LISTS ARGN)
    list(PREPEND libraries -lgranum_${library})
    list(APPEND packages ${granum_${library}_packages})
  endforeach()
  if("Threads" IN_LIST packages)
    list(REMOVE_ITEM packages Threads)
    list(APPEND libraries -pthread)
  endif()
  list(JOIN libraries " " libraries)
  list(JOIN packages ", " packages)
  string(TOLOWER "Requires: ${packages}" requires) # as their files for pkg-config are called
  string(REPLACE "requires" "Requires" requires "${requires}")
  if(BUILD_SHARED_LIBS)
    string(REGEX REPLACE "Requires: eigen3(, )?" "Requires: eigen3\nRequires.private: " requires "${requires}")
  endif()
  file(RELATIVE_PATH up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  string(REGEX REPLACE "/$" "" up "${up}")
  configure_file("${PROJECT_SOURCE_DIR}/cmake/granum.pc.in" "${PROJECT_BINARY_DIR}/${name}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${name}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT dev)
endfunction()
granum_pkg_config(granum "${PROJECT_DESCRIPTION}" ${granum_built})
granum_pkg_config(granum-theory "Closed forms of granum; needs Eigen and headers of Boost alone" theory)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME copyright COMPONENT program)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples/" DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples" COMPONENT doc
  PATTERN "CMakeLists.txt" EXCLUDE PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/share/" DESTINATION "${CMAKE_INSTALL_DATADIR}/granum" COMPONENT program)
if(TARGET docs) # the site, where it was made
  install(DIRECTORY "${PROJECT_BINARY_DIR}/docs/html" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT doc OPTIONAL
    PATTERN "mathjax" EXCLUDE)
endif()

if(TARGET granum_cli)
  install(TARGETS granum_cli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
endif()
if(TARGET granum_reference)
  set(reference "${PROJECT_BINARY_DIR}/reference")
  install(DIRECTORY "${reference}/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}" COMPONENT program)
  install(FILES "${reference}/bash/granum" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT program)
  install(FILES "${reference}/zsh/_granum" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" COMPONENT program)
endif()
