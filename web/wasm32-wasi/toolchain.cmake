# SPDX-License-Identifier: GPL-3.0-or-later
# Toolchain for the page in the browser: clang with the C and C++ libraries that Debian offers for WebAssembly. There are
# neither threads nor unwinding: src/dem/sweep/team.hpp works in turn, web/src/errors.cpp hands messages to the page.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fvisibility=hidden -isystem ${CMAKE_CURRENT_LIST_DIR}")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# Boost, Eigen and fast_float are headers alone, those of this machine; its C headers must come last.
set(machine_headers /usr/include)
string(APPEND CMAKE_CXX_FLAGS_INIT " -idirafter ${machine_headers}")
set(Boost_NO_BOOST_CMAKE ON)
set(Boost_INCLUDE_DIR ${machine_headers})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
