#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# files.sh <program> <data of tests/cli> <scratch folder>: all files that the commands write, in whose places are devices and
# pipes, and what only a process of its own can show: standard output, readers that leave, limits, a folder that goes. What
# else may be in the place of a file is tests/io/test_output_file.cpp. No node of the machine is tried, links to them are.
program=$1 data=$(readlink -f -- "$2") folder=$3
rm -rf -- "$folder" && mkdir -p -- "$folder" && cd -- "$folder" || exit 1

faults=0
fail() {
  printf '%s\n' "$*"
  faults=$((faults + 1))
}
# ends <code> <argument>...: runs the program, which must neither hang nor end otherwise
ends() {
  local expected=$1 code
  shift
  timeout 60 "$program" "$@" >answer 2>said
  code=$?
  [[ $code == "$expected" ]] || fail "exit code $code, expected $expected: $(printf "%.90s " "$@"): $(head -c 300 said)"
}

state=(estimate --void-ratio 0.6 --pressure 100kPa --full)
"$program" "${state[@]}" >expected || exit 1
ln -s /dev/null link

# The descriptors of the program: its standard output, be it a pipe or a file, and what a shell makes of >(...).
ends 0 "${state[@]}" --out /dev/stdout
cmp -s answer expected || fail "/dev/stdout that is a file"
"$program" "${state[@]}" --out /dev/stdout 2>said | cmp -s - expected || fail "/dev/stdout that is a pipe: $(cat said)"
ends 0 "${state[@]}" --out >(cat >got)
for ((k = 0; k < 500; ++k)); do cmp -s got expected && break; sleep 0.01; done
cmp -s got expected || fail "a process that reads"
ends 3 "${state[@]}" --out /dev/fd/99

# A pipe by name whose reader leaves.
mkfifo pipe
for force in "" --force; do
  (exec timeout 60 head -c 1 pipe >got) &
  reader=$!
  ends 3 sweep --void-ratio 0.6 --from 10kPa --to 20kPa --points 2000 --out pipe $force
  wait "$reader"
  [[ -p pipe ]] || fail "a pipe was replaced, with '$force'"
done

# A limit of file sizes (ulimit -f), for a result and for standard output.
code=$(ulimit -f 1 && "$program" "${state[@]}" --json --out limited >/dev/null 2>said; echo $?)
[[ $code == 3 && ! -e limited ]] || fail "a file at its limit: exit code $code: $(cat said)"
code=$(ulimit -f 1 && "$program" "${state[@]}" --json >limited 2>/dev/null; echo $?)
[[ $code == 3 ]] || fail "standard output at its limit: exit code $code"

# All files that a command writes: devices and pipes in their place stay what they are.
study=(--grains 80 --seeds 1 --set study.contacts=sphere --set study.densities=dense
  --set study.pressures=20kPa,40kPa,60kPa --set study.probe_pressures=)
io=$data/../../io/data
every() {
  local what=$1 files=0 file
  shift
  mkdir "$what" && pushd "$what" >/dev/null || exit 1
  ends 0 "$@"
  while IFS= read -r file; do
    ln -sf "$(realpath --relative-to="$(dirname "$file")" ../link)" "$file"
    files=$((files + 1))
  done < <(find . -type f ! -name answer ! -name said ! -path './*/checkpoints/*')
  ((files > 0)) || fail "$what wrote nothing"
  ends 0 "$@" --force
  [[ $(find . -type l ! -path './*/checkpoints/*' | wc -l) == "$files" ]] || fail "$what replaced a link to a device"
  find . -type l -exec sh -c 'for link; do rm "$link" && mkfifo "$link"; done' - {} +
  ends 3 "$@" --force
  [[ $(find . -type p | wc -l) == "$files" ]] || fail "$what replaced a pipe"
  popd >/dev/null || exit 1
}
every estimate "${state[@]}" --json --out result.json
every path sweep --void-ratio 0.6 --from 10kPa --to 20kPa --out path.csv --picture path.svg
every depth sweep --void-ratio 0.6 --depth 1m..9m --points 3 --out depth.csv --picture depth.svg
every infer infer --void-ratio 0.6 --pressure 100kPa --vs 280m/s --out infer.csv --picture infer.svg
every fit fit "$data/hv_dense_cone.csv" --out fit.txt --picture fit.svg
every analyse analyse "$io/lammps_chain.atoms" "$io/lammps_chain.contacts" --out results --paraview
every plan plan "${study[@]}" --out plan.txt
every verify verify "${study[@]}" --out results
every reproduce reproduce "${study[@]}" --set shear.paths=TXC --set shear.largest_strain=0.001 --out results
every trade trade --quick --grains 60 --set study.densities=dense --out results
every export export lammps "${study[@]}" --out decks

# The folder is removed while the study runs.
"$program" verify --grains 20000 --set study.contacts=sphere --threads 1 --out going >answer 2>said &
child=$!
until [[ -e going ]]; do sleep 0.01; done
rm -rf going
kill -s TERM "$child"
wait "$child"
code=$?
{ [[ $code == 3 ]] && grep -q 'going' said; } || fail "a folder that was removed: exit code $code: $(cat said)"

left=$(find . -name "*.granum.part" -type f)
[[ -z $left ]] || fail "parts are left: $left"
exit "$((faults > 0))"
