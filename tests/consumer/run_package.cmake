# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the Debian packages of the build, looks into them, installs them below a folder, uses program and package of
# Python, lets a project find the libraries there, and removes them again.
#   cmake -DBUILD=<build tree> -DSCRATCH=<folder> -DCXX=<compiler> -DGENERATOR=<name> -DVERSION=<x.y.z>
#     -DCPACK=<cpack> [-DPYTHON=<interpreter>] [-DLINTIAN=<lintian>] -P run_package.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${SCRATCH}")
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY COMMAND_ECHO STDOUT)
endfunction()

run("${CPACK}" -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${SCRATCH}/packed")
file(GLOB packages "${SCRATCH}/packed/*.deb")

# expect_depends(<package> <expression>...): whoever installs it gets what it links or needs.
function(expect_depends package)
  file(GLOB file "${SCRATCH}/packed/${package}_${VERSION}_*.deb")
  execute_process(COMMAND dpkg-deb --field "${file}" Depends OUTPUT_VARIABLE depends COMMAND_ERROR_IS_FATAL ANY)
  foreach(needed IN LISTS ARGN)
    if(NOT depends MATCHES "(^|, )${needed}")
      message(FATAL_ERROR "${package} does not depend on ${needed}: ${depends}")
    endif()
  endforeach()
endfunction()
expect_depends(granum "libc6 " "libstdc\\+\\+6 " "libgsl[0-9]+" "libfmt[0-9]+" "libtomlplusplus[0-9a-z]* " "zlib1g " "libexpat1 ")
expect_depends(libgranum-dev "libeigen3-dev " "libgsl-dev" "zlib1g-dev" "libexpat1-dev")
if(PYTHON)
  expect_depends(python3-granum "python3 .>= 3" "python3 .<< 3" "python3-numpy" "libstdc\\+\\+6 ")
endif()
if(LINTIAN) # errors alone; nobody can answer at the address, which is for whoever distributes the packages
  execute_process(COMMAND "${LINTIAN}" --fail-on error --tag-display-limit 0 --allow-root
    --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog ${packages} COMMAND_ERROR_IS_FATAL ANY)
endif()

# dpkg with a root of its own, for which nobody needs to be root; its dependencies are not there.
set(root "${SCRATCH}/root")
file(MAKE_DIRECTORY "${root}/var/lib/dpkg/info" "${root}/var/lib/dpkg/updates")
file(TOUCH "${root}/var/lib/dpkg/status" "${root}/var/lib/dpkg/available")
set(dpkg dpkg "--root=${root}" "--log=${SCRATCH}/log" --force-not-root --force-depends --force-bad-path --force-script-chrootless)
run(${dpkg} --install ${packages})
set(files bin/granum share/doc/granum/copyright share/doc/granum/changelog.gz share/doc/libgranum-dev/copyright
  share/doc/granum/examples/scene.toml share/granum/yade/granum_export.py include/granum/core/error.hpp
  share/doc/granum/examples/01_quick_modulus.cpp share/doc/granum/examples/data/lammps_loose_p50.atoms.gz
  share/man/man1/granum.1.gz share/man/man1/granum-estimate.1.gz share/man/man1/granum-export-lammps.1.gz
  share/bash-completion/completions/granum share/zsh/site-functions/_granum)
if(PYTHON)
  list(APPEND files lib/python3/dist-packages/granum/__init__.py lib/python3/dist-packages/granum/__init__.pyi
    share/doc/python3-granum/copyright)
endif()
foreach(file IN LISTS files)
  if(NOT EXISTS "${root}/usr/${file}")
    message(FATAL_ERROR "usr/${file} is not in the packages")
  endif()
endforeach()
run("${root}/usr/bin/granum" --version)
run("${root}/usr/bin/granum" plan --scene "${root}/usr/share/doc/granum/examples/scene.toml")
if(PYTHON)
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${root}/usr/lib/python3/dist-packages" PYTHONDONTWRITEBYTECODE=1
    "${PYTHON}" "${root}/usr/share/doc/granum/examples/python/modulus_and_range.py")
endif()
foreach(use theory granum)
  set(build "${SCRATCH}/${use}")
  run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${build}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${CXX}"
    -DCMAKE_BUILD_TYPE=Release "-DCMAKE_PREFIX_PATH=${root}/usr" "-DGRANUM_EXPECTED_VERSION=${VERSION}" -DUSE=${use})
  run("${CMAKE_COMMAND}" --build "${build}")
  run("${build}/use_${use}")
endforeach()

set(names granum libgranum-dev granum-doc)
if(PYTHON)
  list(APPEND names python3-granum)
endif()
run(${dpkg} --purge ${names})
file(GLOB_RECURSE left "${root}/usr/*")
if(left OR EXISTS "${root}/usr")
  message(FATAL_ERROR "left behind: ${left}")
endif()
