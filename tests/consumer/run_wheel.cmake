# SPDX-License-Identifier: GPL-3.0-or-later
# Makes an sdist, from it alone a wheel, and installs that where nothing is but numpy, all without a network; then it
# computes there. What people see of the package before they install it stands in the wheel.
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
file(REMOVE_RECURSE "${SCRATCH}/clone")

# It is to be seen that it computes, not how fast: the compiler does not optimise.
run("${CMAKE_COMMAND}" -E env CMAKE_ARGS=-DCMAKE_CXX_FLAGS_RELEASE=-O0 PIP_DISABLE_PIP_VERSION_CHECK=1
  "${PYTHON}" -m pip wheel --no-index --no-deps --no-build-isolation --wheel-dir "${SCRATCH}" "${sdist}")
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
