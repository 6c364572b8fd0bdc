# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the C++ of a page as a source file:  cmake -DPAGE=<file> -DSOURCE=<file> -P write_example.cmake
cmake_minimum_required(VERSION 3.25)
include("${CMAKE_CURRENT_LIST_DIR}/extract_blocks.cmake")

extract_blocks(example "${PAGE}" cpp)
file(WRITE "${SOURCE}" "${example}")
