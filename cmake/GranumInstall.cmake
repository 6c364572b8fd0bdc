# SPDX-License-Identifier: GPL-3.0-or-later
include(CMakePackageConfigHelpers)

set(granum_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/granum")

# One export a library: a project that names one component loads only what that component needs.
foreach(library IN LISTS granum_built)
  install(TARGETS granum_${library}
    EXPORT granum-${library}
    FILE_SET HEADERS
    FILE_SET lone_headers
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(EXPORT granum-${library} NAMESPACE granum:: DESTINATION "${granum_config_dir}")
endforeach()

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/granumConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/granumConfig.cmake" INSTALL_DESTINATION "${granum_config_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/granumConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/granumConfig.cmake" "${PROJECT_BINARY_DIR}/granumConfigVersion.cmake"
  DESTINATION "${granum_config_dir}")
install(FILES "${PROJECT_SOURCE_DIR}/cmake/GranumLibraries.cmake" DESTINATION "${granum_config_dir}"
  RENAME granumLibraries.cmake)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME copyright)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples/" DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples"
  PATTERN "CMakeLists.txt" EXCLUDE PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/share/" DESTINATION "${CMAKE_INSTALL_DATADIR}/granum")

if(TARGET granum_cli)
  install(TARGETS granum_cli RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
if(TARGET granum_reference)
  set(reference "${PROJECT_BINARY_DIR}/reference")
  install(DIRECTORY "${reference}/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}")
  install(FILES "${reference}/bash/granum" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
  install(FILES "${reference}/zsh/_granum" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
endif()
