# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the Debian package of the build, looks into it, installs it below a folder, lets a project find and use it
# there, and removes it again.
#   cmake -DBUILD=<build tree> -DSCRATCH=<folder> -DCXX=<compiler> -DGENERATOR=<name> -DVERSION=<x.y.z>
#     -DCPACK=<cpack> -P run_package.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${SCRATCH}")
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY COMMAND_ECHO STDOUT)
endfunction()

run("${CPACK}" -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${SCRATCH}/packed")
file(GLOB package "${SCRATCH}/packed/granum_${VERSION}_*.deb")

# Whoever installs it gets what the program links, and what linking the libraries takes.
execute_process(COMMAND dpkg-deb --field "${package}" Depends OUTPUT_VARIABLE depends COMMAND_ERROR_IS_FATAL ANY)
foreach(needed "libc6 " "libstdc\\+\\+6 " "libgsl[0-9]+" "libfmt[0-9]+" "libtomlplusplus[0-9a-z]* " "zlib1g " "libexpat1 "
    "libeigen3-dev " "libgsl-dev" "zlib1g-dev" "libexpat1-dev")
  if(NOT depends MATCHES "(^|, )${needed}")
    message(FATAL_ERROR "the package does not depend on ${needed}: ${depends}")
  endif()
endforeach()

# dpkg with a root of its own, for which nobody needs to be root; its dependencies are not there.
set(root "${SCRATCH}/root")
file(MAKE_DIRECTORY "${root}/var/lib/dpkg/info" "${root}/var/lib/dpkg/updates")
file(TOUCH "${root}/var/lib/dpkg/status" "${root}/var/lib/dpkg/available")
set(dpkg dpkg "--root=${root}" "--log=${SCRATCH}/log" --force-not-root --force-depends --force-bad-path)
run(${dpkg} --install "${package}")
foreach(file bin/granum share/doc/granum/copyright share/doc/granum/examples/scene.toml share/granum/yade/granum_export.py
    include/granum/core/error.hpp share/doc/granum/examples/01_quick_modulus.cpp
    share/doc/granum/examples/data/lammps_loose_p50.atoms.gz share/man/man1/granum.1 share/man/man1/granum-estimate.1
    share/man/man1/granum-export-lammps.1 share/bash-completion/completions/granum share/zsh/site-functions/_granum)
  if(NOT EXISTS "${root}/usr/${file}")
    message(FATAL_ERROR "usr/${file} is not in the package")
  endif()
endforeach()
run("${root}/usr/bin/granum" --version)
run("${root}/usr/bin/granum" plan --scene "${root}/usr/share/doc/granum/examples/scene.toml")
foreach(use theory granum)
  set(build "${SCRATCH}/${use}")
  run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${build}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${CXX}"
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=${root}/usr" "-DGRANUM_EXPECTED_VERSION=${VERSION}" -DUSE=${use})
  run("${CMAKE_COMMAND}" --build "${build}")
  run("${build}/use_${use}")
endforeach()

run(${dpkg} --purge granum)
file(GLOB_RECURSE left "${root}/usr/*")
if(left OR EXISTS "${root}/usr")
  message(FATAL_ERROR "left behind: ${left}")
endif()
