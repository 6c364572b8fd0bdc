# SPDX-License-Identifier: GPL-3.0-or-later
# scripts/setup.sh on systems that are made up: a folder of stand-ins for dpkg-query, apt-get, apt-cache and id, which
# read what is installed and offered from files and note what they were asked.
#   cmake -DROOT=<source tree> -DSCRATCH=<folder> -P check_setup.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE "${SCRATCH}")
find_program(bash bash REQUIRED)

function(write_program name text)
  file(WRITE "${SCRATCH}/bin/${name}" "#!${bash}\n${text}")
  file(CHMOD "${SCRATCH}/bin/${name}" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()

# system([INSTALLED <package>...] [OFFERED <package>...] [AFTER_UPDATE <package>...] [WITHOUT <tool>...] [USER <id>]);
# "all" stands for every package.
function(system)
  cmake_parse_arguments(PARSE_ARGV 0 has "" "USER" "INSTALLED;OFFERED;AFTER_UPDATE;WITHOUT")
  file(REMOVE_RECURSE "${SCRATCH}/bin")
  foreach(list INSTALLED OFFERED AFTER_UPDATE)
    list(JOIN has_${list} "\n" lines)
    file(WRITE "${SCRATCH}/${list}" "${lines}\n")
  endforeach()
  file(WRITE "${SCRATCH}/log" "")
  file(MAKE_DIRECTORY "${SCRATCH}/bin")
  foreach(tool bash env sed grep cat)
    find_program(real_${tool} ${tool} REQUIRED)
    file(CREATE_LINK "${real_${tool}}" "${SCRATCH}/bin/${tool}" SYMBOLIC)
  endforeach()
  if(NOT DEFINED has_USER)
    set(has_USER 0)
  endif()
  set(in "in_list() { grep -qx -e all -e \"$2\" '${SCRATCH}/'\"$1\"; }\n")
  write_program(id "echo ${has_USER}\n")
  write_program(dpkg-query "${in}in_list INSTALLED \"\${@: -1}\" && echo installed\n")
  write_program(apt-cache
    "${in}echo \"$2:\"; in_list OFFERED \"$2\" && echo '  Candidate: 1.0-1' || echo '  Candidate: (none)'\n")
  write_program(apt-get "${in}
simulated=0 names=()
for word; do
  case \"$word\" in
  -s) simulated=1 ;;
  --print-uris) echo \"'http://somewhere/a.deb' a.deb 2000001 SHA256:0\"; exit 0 ;;
  update) echo update >>'${SCRATCH}/log'; cat '${SCRATCH}/AFTER_UPDATE' >>'${SCRATCH}/OFFERED'; exit 0 ;;
  -* | DPkg::* | install) ;;
  *) names+=(\"$word\") ;;
  esac
done
for name in \"\${names[@]}\"; do in_list OFFERED \"$name\" || exit 100; done
[ $simulated = 1 ] || echo \"install \${names[*]}\" >>'${SCRATCH}/log'
")
  foreach(tool IN LISTS has_WITHOUT)
    file(REMOVE "${SCRATCH}/bin/${tool}")
  endforeach()
endfunction()

set(failures 0)
# expect(<what> <exit code> <log> <text in the output> <argument>...)
function(expect what code log text)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env --unset=GRANUM_SKIP_SETUP "PATH=${SCRATCH}/bin"
      "${bash}" "${ROOT}/scripts/setup.sh" ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  file(READ "${SCRATCH}/log" written)
  string(STRIP "${written}" written)
  string(FIND "${output}" "${text}" at)
  if(NOT result EQUAL code OR NOT written MATCHES "^${log}$" OR at EQUAL -1)
    message(NOTICE "${what}: exit code ${result} instead of ${code}, did '${written}', not '${log}'; said:\n${output}")
    math(EXPR failures "${failures} + 1")
    set(failures ${failures} PARENT_SCOPE)
  endif()
endfunction()

system(INSTALLED all)
expect("nothing missing" 0 "" "" run)
expect("not a purpose" 2 "" "usage: scripts/setup.sh" everything)

system(INSTALLED g++ cmake OFFERED all)
expect("lists that know all" 0 "install ninja-build .*libfmt-dev" " packages (1 files of 3 MB are fetched, with what they need): ninja-build" run)

system(INSTALLED g++ AFTER_UPDATE all)
expect("lists not yet fetched" 0 "update\ninstall cmake ninja-build .*" "" run)

system(OFFERED cmake AFTER_UPDATE g++ ninja-build)
expect("packages that the system has not" 3 "update" "this system offers no package libeigen3-dev " run)

system(OFFERED all WITHOUT apt-get)
expect("no apt" 3 "" "this system has no apt-get" run)

system(OFFERED all USER 1000)
expect("no root" 3 "" "installing them needs root" test)

system(INSTALLED all USER 1000)
expect("nothing missing, no root" 0 "" "" test)

if(failures GREATER 0)
  message(FATAL_ERROR "setup: ${failures} systems went wrong")
endif()
