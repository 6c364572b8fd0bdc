# SPDX-License-Identifier: GPL-3.0-or-later
# A Debian package of program, libraries and headers:  cpack -G DEB --config build/release/CPackConfig.cmake
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME granum)
set(CPACK_PACKAGE_VENDOR "granum")
set(CPACK_PACKAGE_CONTACT "The granum maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "How stiff a granular packing is, how that depends on stress, and how far the number can be
trusted: the program granum, and its libraries for C++20 with a CMake package.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# What the program links is looked up in it; what a project that links the libraries needs is said here.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), libgsl-dev, zlib1g-dev, libexpat1-dev")
include(CPack)
