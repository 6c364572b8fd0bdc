# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries alone. Written without having been built; packaging/README.md says what was checked.
vcpkg_download_distfile(archive
  URLS "https://OWNER/granum-${VERSION}.tar.gz" # for the owner
  FILENAME "granum-${VERSION}.tar.gz"
  SHA512 HASH)
vcpkg_extract_source_archive(source ARCHIVE "${archive}")
vcpkg_cmake_configure(SOURCE_PATH "${source}"
  OPTIONS -DGRANUM_BUILD_CLI=OFF -DGRANUM_BUILD_TESTS=OFF -DGRANUM_BUILD_EXAMPLES=OFF -DGRANUM_BUILD_DOCS=OFF
    -DGRANUM_WARNINGS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME granum CONFIG_PATH lib/cmake/granum)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${source}/LICENSE")
