#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_faults.sh <program> <library fail_at_call> <data> <folder> <most calls of a kind> [studies]: one call of the system
# after the other fails. Either the program says of which file and why, ends with 3, and no file that it writes is there in
# part, or all it answers and writes is as without the fault. Never an answer from a part of a file. With "studies" those
# commands that simulate.
program=$1 library=$2 data=$3 folder=$4 most=$5 studies=${6:-}
rm -rf -- "$folder" && mkdir -p -- "$folder/in" && cd -- "$folder" || exit 1
folder=$PWD faults=0 runs=0

cp "$data"/{sieve,layers,isotropic,analyse_states}.csv "$data"/scene_small.toml \
  "$data"/../../io/data/lammps_chain.{atoms,contacts} in
gzip -c in/lammps_chain.contacts >in/packed.gz
# many reads long, with rows at both ends
{ head -n 5 in/isotropic.csv && yes '# a comment between the rows' | head -n 30000 && tail -n +6 in/isotropic.csv; } >in/long.csv
printf 'e,p_kPa,V_s_m/s\n0.6,100,250\n' >in/speeds.csv
printf 'modulus,value_MPa,step\nK,1,0\n' >in/probes.csv

fail() {
  printf '%s\n' "$*"
  faults=$((faults + 1))
}

# Texts without what depends on the speed of the machine.
timeless() { sed -E '/seconds"|wall_time_s|^  time /d; s/[0-9.]+ s(<|,| on)//g' "$1"; }
same() { cmp -s -- "$1" "$2" || cmp -s <(timeless "$1") <(timeless "$2"); }

# Before a run: the input, and files from earlier.
prepare() {
  rm -rf disk
  cp -r before disk
}

# judge <name> <kind> <exit code>: of the run whose fault is in ./fired
judge() {
  local name=$1 kind=$2 code=$3 failed reason line path
  failed=$(<fired)
  failed=${failed##*/}
  reason='nput/output error'
  [[ $fault == ENOSPC ]] && reason='No space left'
  [[ $fault == EINTR ]] && reason='nterrupted system call'
  if [[ $code == "$whole" ]] && same said silence; then
    same answer expected || fail "$name: another answer"
  elif [[ $code != 3 ]]; then
    fail "$name: exit code $code: $(<said)"
  elif [[ $kind == stat ]]; then # the standard library goes on to a later call, which fails
    :
  elif ! grep -q "$reason" said || ! grep -qF -- "${failed%.granum.part}" said; then
    fail "$name: which file failed, and why? It is $failed: $(<said)"
  fi
  while read -r line; do
    path=${line% differ}
    path=${path##*after/}
    case $line in
    "Only in after"*) [[ $code == 3 ]] || fail "$name: a file is missing: $line" ;;
    "Only in disk"*.granum.part) [[ $kind == remove ]] || fail "$name: a part stays: $line" ;;
    "Files "*.checkpoint\ differ) [[ $code == 3 ]] || fail "$name: $line" ;; # of an earlier moment
    "Files "*)
      same "disk/$path" "after/$path" || { [[ $code == 3 ]] && cmp -s "disk/$path" "before/$path"; } ||
        fail "$name: $path is neither as before nor as after"
      ;;
    *) fail "$name: $line" ;;
    esac
  done < <(diff -rq disk after)
}

# run <kind> <number> <argument>...: the program, with this call failing
run() {
  GRANUM_TEST_CALL=$1 GRANUM_TEST_NUMBER=$2 GRANUM_TEST_FAULT=$fault GRANUM_TEST_FOLDER=$folder/disk \
    GRANUM_TEST_FIRED=$folder/fired LD_PRELOAD=$library "$program" "${@:3}"
}

# attack <argument>...: every call of a command in turn; files are in disk/in, and go to disk/out
attack() {
  local kind number calls
  rm -rf fired after
  prepare
  run all 0 "$@" >expected 2>silence
  whole=$?
  [[ $whole == "$ends" ]] || fail "$*: exit code $whole without a fault: $(<silence)"
  mv disk after
  sort fired | uniq -c >calls
  while read -r calls kind; do
    [[ $fault != short || $kind == read || $kind == write ]] || continue
    for ((number = 0; number < calls && number < most; ++number)); do
      rm -f fired
      prepare
      run "$kind" "$number" "$@" >answer 2>said
      judge "$1, $kind $number, $fault" "$kind" $?
      runs=$((runs + 1))
    done
  done <calls
}

# before <file>...: these files are there, so that each is replaced
before() {
  rm -rf before
  mkdir -p before/out
  cp -r in before/in
  local file
  for file in "$@"; do
    mkdir -p -- "$(dirname -- "before/out/$file")"
    echo kept >"before/out/$file"
  done
}

ends=0 i=$folder/disk/in o=$folder/disk/out
state=(--void-ratio 0.6 --pressure 100kPa)
small=(--grains 40 --seeds 1 --threads 1 --set study.contacts=sphere --set study.densities=dense
  --set study.pressures=20kPa,40kPa,60kPa --set study.probe_pressures=)
if [[ -z $studies ]]; then
  for fault in EIO short; do
    before a
    attack estimate "${state[@]}" --sieve "$i/sieve.csv" --out "$o/a" --force
    attack sweep --depth 1m..9m --points 2 --layers "$i/layers.csv" --out "$o/a" --force
    before a p.svg
    attack fit "$i/long.csv" --sum-only --out "$o/a" --picture "$o/p.svg" --force
    ends=3 attack fit "$i/isotropic.csv" --sum-only --out "$o/a"
    before
    attack sweep --table "$i/speeds.csv" --out "$o/b"
    attack infer --grain-shape sand --table "$i/speeds.csv"
    attack plan --scene "$i/scene_small.toml" --out "$o/b"
    before r/report.html
    attack analyse "$i/lammps_chain.atoms" "$i/packed.gz" --no-network --threads 1 --stress "$i/analyse_states.csv" \
      --probes "$i/probes.csv" --frames 0 --out "$o/r" --force
  done
else
  for fault in EIO ENOSPC EINTR short; do
    before report.html
    attack verify "${small[@]}" --out "$o" --force
    before
    "$program" verify "${small[@]}" --out before/out/v >/dev/null 2>&1
    attack verify --report "$o/v"
    before
    "$program" trade --quick --grains 60 --threads 1 --set study.densities=dense --out before/out/t >/dev/null 2>&1
    attack trade --redraw "$o/t"
    before
    attack export lammps "${small[@]}" --out "$o/deck"
    before
    attack reproduce "${small[@]}" --set shear.paths=TXC --set shear.largest_strain=0.001 --out "$o/r"
    mv after after_run
    before
    cp -r after_run/out before
    attack reproduce --threads 1 --resume "$o/r"
    rm -rf after_run
  done
fi
printf '%s runs with a fault, %s not as they should be\n' "$runs" "$faults"
exit "$((runs < 100 || faults > 0))"
