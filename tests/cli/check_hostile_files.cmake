# SPDX-License-Identifier: GPL-3.0-or-later
# Names, headings and files that are meant to do harm:  cmake -DPROGRAM=... -DDATA=<tests/cli/data> -DFOLDER=... -P ...
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
set(ENV{program} "${PROGRAM}")
set(ENV{data} "${DATA}")
string(ASCII 27 escape)
set(shell [[granum() { "$program" "$@"; }; sweep() { granum sweep --void-ratio 0.6 --path iso --from 10kPa --to 20kPa "$@"; }; ]])

# attack(<what> <exit code> <line for sh>): `out` and `err` are what the line wrote; neither may hold the character ESC.
function(attack what expected line)
  execute_process(COMMAND sh -c "${shell}${line}" WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE code OUTPUT_VARIABLE out
    ERROR_VARIABLE err)
  if(NOT code EQUAL expected)
    message(FATAL_ERROR "${what}: exit code ${code}, expected ${expected}\n${out}\n${err}")
  endif()
  string(FIND "${out}${err}" "${escape}" at)
  if(NOT at EQUAL -1)
    message(FATAL_ERROR "${what}: a terminal would obey what is printed")
  endif()
  set(out "${out}" PARENT_SCOPE)
  set(err "${err}" PARENT_SCOPE)
endfunction()
# must(<variable> <regular expression>)
function(must variable expression)
  if(NOT "${${variable}}" MATCHES "${expression}")
    message(FATAL_ERROR "${variable} does not match ${expression}:\n${${variable}}")
  endif()
endfunction()

# names that are no UTF-8, or that a terminal would obey
attack("a hostile name" 0 [[cp "$data/analyse_chain_contacts.csv" "$(printf 'n\377\033[2J.csv')"; granum analyse n*.csv]])
must(out "x1b")
attack("a hostile name as JSON" 0 [[granum analyse n*.csv --json --out results]])
string(JSON path GET "${out}" files 0 path)
string(ASCII 239 191 189 replaced)
must(path "^n${replaced}")
foreach(file frames.csv rose.csv forces.csv rose.svg forces.svg analysis.json)
  if(NOT EXISTS "${FOLDER}/results/${file}")
    message(FATAL_ERROR "${file} is missing")
  endif()
endforeach()
attack("a name that a terminal would obey beyond ASCII, as JSON" 0 [[f="$(printf 'o\302\233\342\200\256.csv')"
  cp "$data/analyse_chain_contacts.csv" "$f"; granum analyse "$f" --json]])
string(FIND "${out}" [["o\u009b\u202e.csv"]] at)
if(at EQUAL -1)
  message(FATAL_ERROR "U+009B or U+202E is not escaped:\n${out}")
endif()
attack("a hostile name that is not there" 3 [[granum analyse "$(printf 'm\033[2J.csv')"]])
must(err "x1b")
attack("hostile headings" 3 [[printf 'nx,ny,nz,\033[2J,nx\n1,0,0,1,1\n' > h.csv; granum analyse h.csv]])
attack("a heading that turns the direction of text" 3 [[printf 'e,p_kPa,a\342\200\256b_kPa\n0.6,100\n' > "$(printf 't\342\200\256.csv')"
  granum sweep --table "$(printf 't\342\200\256.csv')"]])
string(ASCII 226 128 174 turns)
string(FIND "${err}" "${turns}" at)
if(NOT at EQUAL -1)
  message(FATAL_ERROR "U+202E reaches the terminal")
endif()
attack("a formula for a spreadsheet" 0 [[printf 'e,p_kPa,"=note"\n0.6,100,=1+1\n0.6,200,-1.5\n' > f.csv
  granum sweep --table f.csv]])
must(out "'=note.*\n0.6,100,'=1.1,.*\n0.6,200,-1.5,")
attack("a folder of 5,000 characters" 3 [[granum analyse n*.csv --out $(printf '%05000d' 1)]])
attack("a file of 5,000 characters" 3 [[granum analyse $(printf '%05000d' 1)]])

# what a shell would run, as a name
attack("a command for a name" 0 [[sweep --out '< touch x; cat a.csv' --picture a.svg]])
if(NOT EXISTS "${FOLDER}/< touch x; cat a.csv" OR NOT EXISTS "${FOLDER}/a.svg" OR EXISTS "${FOLDER}/x")
  message(FATAL_ERROR "the name is not that of the file")
endif()

# a link that leads nowhere is kept
attack("a dangling link" 3 [[ln -s nowhere link.csv; sweep --out link.csv]])
if(NOT IS_SYMLINK "${FOLDER}/link.csv")
  message(FATAL_ERROR "the link is gone")
endif()

# pipes
foreach(packer cat "gzip -c")
  set(ENV{packer} "${packer}")
  attack("a pipe of ${packer}" 0 [[$packer "$data/../../io/data/lammps_chain.data" | granum analyse /dev/stdin]])
  must(out "a LAMMPS data file.*grains +3")
endforeach()

# frames without end: no more of them are held than one answer has
attack("many frames" 0 [[awk 'BEGIN { for (k = 0; k < 10500; ++k) {
  printf "ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n", k
  printf "ITEM: ATOMS id radius x y z\n1 0.4 0.5 0.5 0.5\n" } }' | granum analyse /dev/stdin]])
must(out "the last of 10000 frames")
must(err "only the first 10000 frames were read; select others with --frames, such as 10000: ")

# out of memory
attack("too many grains" 1 [[ulimit -v 200000
  granum export lammps --set study.contacts=sphere --grains 10000000 --start scattered --out deck]])
must(err "out of memory: .*--grains 10000000")
foreach(study verify reproduce)
  attack("too many grains of ${study}" 1 "ulimit -v 200000
    granum ${study} --set study.contacts=sphere --grains 10000000 --out deck")
  must(err "out of memory: .*--grains 10000000")
endforeach()
