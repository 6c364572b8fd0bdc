# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the C++ example of the README as a source file:  cmake -DREADME=<file> -DSOURCE=<file> -P write_example.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/extract_block.cmake")

extract_block(example "${README}" cpp)
file(WRITE "${SOURCE}" "${example}")
