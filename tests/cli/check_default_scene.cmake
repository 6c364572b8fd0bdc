# SPDX-License-Identifier: GPL-3.0-or-later
# A scene file must resolve to the scene that the program takes when it is given none, and must name every key of it:
#   cmake -DPROGRAM=... -DSCENE=file.toml -P check_default_scene.cmake
cmake_minimum_required(VERSION 3.25)

# scene_of(<variable> <arguments>...): the resolved scene of `granum plan`
function(scene_of variable)
  execute_process(COMMAND "${PROGRAM}" plan --json ${ARGN} OUTPUT_VARIABLE out COMMAND_ERROR_IS_FATAL ANY)
  string(JSON scene GET "${out}" scene)
  set(${variable} "${scene}" PARENT_SCOPE)
endfunction()

scene_of(default)
scene_of(resolved --scene "${SCENE}")
string(JSON same EQUAL "${default}" "${resolved}")
if(NOT same)
  message(FATAL_ERROR "${SCENE} resolves to\n${resolved}\nbut the default is\n${default}")
endif()

# The keys that the program lists, against the lines of the file.
execute_process(COMMAND "${PROGRAM}" plan --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\n +[a-z]+\\.[a-z_]+ " keys "${help}")
list(LENGTH keys count)
if(count EQUAL 0)
  message(FATAL_ERROR "`granum plan --help` lists no keys")
endif()
file(READ "${SCENE}" text)
foreach(key IN LISTS keys)
  string(REGEX REPLACE ".*\\.([a-z_]+) $" "\\1" name "${key}")
  if(NOT text MATCHES "\n${name} = ")
    message(FATAL_ERROR "${SCENE} does not set${key}")
  endif()
endforeach()
