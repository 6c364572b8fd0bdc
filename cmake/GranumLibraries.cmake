# SPDX-License-Identifier: GPL-3.0-or-later
# The table of granum's libraries, read by the build and, installed, by granumConfig.cmake: which other libraries each
# needs, and which packages whoever links it must have. Each library comes after those that it needs.
set(granum_libraries theory fit packing dem io granum)

set(granum_theory_needs)
set(granum_theory_packages Eigen3)

set(granum_fit_needs theory)
set(granum_fit_packages GSL)

set(granum_packing_needs theory)
set(granum_packing_packages Threads)

set(granum_dem_needs packing)
set(granum_dem_packages)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "wasm32")
  set(granum_packing_packages) # one thread, without the package
endif()

set(granum_io_needs packing)
set(granum_io_packages ZLIB EXPAT)

set(granum_granum_needs fit dem io)
set(granum_granum_packages)

# granum_with_needs(<variable> <library>...): the named libraries and all that they need, in the order of the table.
function(granum_with_needs variable)
  set(wanted ${ARGN})
  set(ordered ${granum_libraries})
  list(REVERSE ordered)
  foreach(library IN LISTS ordered)
    if(library IN_LIST wanted)
      list(APPEND wanted ${granum_${library}_needs})
    endif()
  endforeach()
  set(found "")
  foreach(library IN LISTS granum_libraries)
    if(library IN_LIST wanted)
      list(APPEND found ${library})
    endif()
  endforeach()
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# granum_find_package(<package> [<word>...]): find_package() with the version and parts that granum needs; a macro, as
# what a package defines belongs to the caller.
macro(granum_find_package package)
  if("${package}" STREQUAL "Eigen3")
    find_package(Eigen3 3.4 NO_MODULE ${ARGN})
  else()
    find_package(${package} ${ARGN})
  endif()
endmacro()
