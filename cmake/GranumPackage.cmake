# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages of what was built: granum (the program), libgranum-dev, python3-granum, granum-doc.
#   cmake --workflow --preset debian && cpack -G DEB --config build/debian/CPackConfig.cmake
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME granum)
set(CPACK_PACKAGE_VENDOR "granum")
set(GRANUM_MAINTAINER "granum developers <granum@localhost>" CACHE STRING "Of the Debian packages: name <address>")
set(CPACK_PACKAGE_CONTACT "${GRANUM_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "stiffness of granular packings") # the first line of all of them
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_COMPONENTS_ALL "")
# granum_debian_package(<component> <package> <section> <architecture> <depends> <line of the description>...)
macro(granum_debian_package component package section architecture depends)
  string(TOUPPER "${component}" upper)
  string(REPLACE ";" "\n" text "${ARGN}")
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${package}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${text}")
  if("${architecture}" STREQUAL "all")
    set(CPACK_DEBIAN_${upper}_PACKAGE_ARCHITECTURE all)
  else()
    set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS ON) # what is linked is looked up
  endif()
endmacro()

if(TARGET granum_cli)
  granum_debian_package(program granum science any ""
    "The program granum states how stiff a packing of grains is, how that depends"
    "on stress, and how far the number can be trusted: in closed form, from the"
    "contact networks of DEM codes, and by a compact simulation of its own.")
endif()
file(STRINGS "${PROJECT_SOURCE_DIR}/scripts/setup.sh" needed REGEX "^library_packages=")
string(REGEX REPLACE "^[^(]*\\(([^)]*)\\).*" "\\1" needed "${needed}")
string(REPLACE " " ", " needed "${needed}")
string(REPLACE "libeigen3-dev" "libeigen3-dev (>= 3.4)" needed "${needed}")
granum_debian_package(dev libgranum-dev libdevel any "${needed}"
  "Static libraries for C++20, headers, and files for CMake and pkg-config:"
  "closed forms, contact networks, readers of the files of DEM codes, and a DEM"
  "engine.")
if(TARGET granum_python)
  set(version "${GRANUM_PYTHON_VERSION}") # a compiled module is of one version alone
  string(REGEX MATCH "[0-9]+$" minor "${version}")
  math(EXPR next "${minor} + 1")
  granum_debian_package(python python3-granum python any "python3 (>= ${version}), python3 (<< 3.${next}), python3-numpy"
    "The package of Python 3: closed forms that broadcast over numpy arrays,"
    "packings of any DEM code, and everything that is measured on them.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    "${PROJECT_SOURCE_DIR}/packaging/debian/python/postinst;${PROJECT_SOURCE_DIR}/packaging/debian/python/prerm")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-tqdm")
endif()
granum_debian_package(doc granum-doc doc all ""
  "Documentation and examples: the site, where it was made, programs of a page"
  "each, scripts, notebooks, and data of LAMMPS and YADE to try them on.")
set(CPACK_DEBIAN_DOC_PACKAGE_SUGGESTS "libjs-mathjax")

# What Debian wants of every package, and where it has Python's.
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/debian_files.cmake")
include(CPack)
