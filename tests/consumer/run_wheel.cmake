# SPDX-License-Identifier: GPL-3.0-or-later
# Makes an sdist, from it alone a wheel, and installs that where nothing is but numpy, all without a network; then it
# computes there. What people see of the package before they install it stands in the wheel. Then pip install . in a copy of
# the source tree, as people type it, which finds compiled what the wheel was made of.
#   cmake -DROOT=<source tree> -DSCRATCH=<folder> -DPYTHON=<interpreter with numpy, pip, setuptools> -DVERSION=<x.y.z>
#     -P run_wheel.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${SCRATCH}")
file(MAKE_DIRECTORY "${SCRATCH}")
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY COMMAND_ECHO STDOUT)
endfunction()

# A copy, as a clone has it: what a build leaves in the source tree is not to be found by chance.
foreach(path pyproject.toml setup.py MANIFEST.in CMakeLists.txt LICENSE README.md CHANGELOG.md CITATION.cff cmake include share
    src python tests)
  file(COPY "${ROOT}/${path}" DESTINATION "${SCRATCH}/clone" PATTERN "*.egg-info" EXCLUDE)
endforeach()
file(COPY "${ROOT}/validation/references.bib" DESTINATION "${SCRATCH}/clone/validation")
execute_process(COMMAND "${PYTHON}" -c "import setuptools.build_meta as b; b.build_sdist(r'${SCRATCH}')"
  WORKING_DIRECTORY "${SCRATCH}/clone" OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(sdist "${SCRATCH}/granum-${VERSION}.tar.gz")
execute_process(COMMAND "${CMAKE_COMMAND}" -E tar tf "${sdist}" OUTPUT_VARIABLE members COMMAND_ERROR_IS_FATAL ANY)
foreach(member LICENSE README.md PKG-INFO src/core/version.cpp include/granum/core/version.hpp share/lammps/in.iso)
  string(FIND "${members}" "granum-${VERSION}/${member}\n" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${member} is not in ${sdist}")
  endif()
endforeach()
if(members MATCHES "granum-${VERSION}/tests/")
  message(FATAL_ERROR "tests are in ${sdist}")
endif()

# It is to be seen that it computes, not how fast: the compiler does not optimise.
set(ENV{CMAKE_ARGS} -DCMAKE_CXX_FLAGS_RELEASE=-O0)
set(ENV{PIP_DISABLE_PIP_VERSION_CHECK} 1)
set(tree "${SCRATCH}/granum-${VERSION}")
file(ARCHIVE_EXTRACT INPUT "${sdist}" DESTINATION "${SCRATCH}")
run("${PYTHON}" -m pip wheel --no-index --no-deps --no-build-isolation --wheel-dir "${SCRATCH}" "${tree}")
file(GLOB wheel "${SCRATCH}/granum-${VERSION}-*.whl")

# An environment without pip, in which numpy is the interpreter's own.
run("${PYTHON}" -m venv --without-pip "${SCRATCH}/empty")
set(there "${SCRATCH}/empty/bin/python")
execute_process(COMMAND "${there}" -c "import sysconfig; print(sysconfig.get_path('platlib'))"
  OUTPUT_VARIABLE site OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${PYTHON}" -c "import numpy, os; print(os.path.dirname(numpy.__file__))"
  OUTPUT_VARIABLE numpy OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
file(CREATE_LINK "${numpy}" "${site}/numpy" SYMBOLIC)
run("${PYTHON}" -m pip --python "${there}" install --no-index --no-deps "${wheel}")
run("${CMAKE_COMMAND}" -E env --unset=PYTHONPATH "${there}" "${CMAKE_CURRENT_LIST_DIR}/use_wheel.py" "${VERSION}")

# The tree becomes that of the clone; what both have stays as old as it is, and is not compiled again.
file(GLOB_RECURSE files RELATIVE "${SCRATCH}/clone" "${SCRATCH}/clone/*")
foreach(file IN LISTS files)
  get_filename_component(folder "${tree}/${file}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  file(COPY_FILE "${SCRATCH}/clone/${file}" "${tree}/${file}" ONLY_IF_DIFFERENT)
endforeach()
execute_process(COMMAND "${PYTHON}" -m pip install --no-index --no-deps --no-build-isolation --target "${SCRATCH}/site-packages" .
  WORKING_DIRECTORY "${tree}" COMMAND_ERROR_IS_FATAL ANY COMMAND_ECHO STDOUT)
run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${SCRATCH}/site-packages" "${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/use_wheel.py" "${VERSION}")
