# SPDX-License-Identifier: GPL-3.0-or-later
# Runs share/yade/granum_export.py on a stand-in scene and compares with the recorded file.
#   cmake -DPYTHON=<python3> -DROOT=<source tree> -DKIND=grains|contacts -DOUT=<scratch name> -P check_yade_script.cmake
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND "${PYTHON}" "${ROOT}/tests/io/yade/yade_scene.py" "${ROOT}/share/yade" "${OUT}" RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the script fails")
endif()
file(READ "${OUT}.${KIND}" written)
file(READ "${ROOT}/tests/io/data/yade_script.${KIND}" recorded)
if(NOT written STREQUAL recorded)
  message(FATAL_ERROR "${OUT}.${KIND} differs from tests/io/data/yade_script.${KIND}")
endif()
