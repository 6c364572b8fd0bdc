#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# files.sh <program> <data of tests/cli> <scratch folder>: results that are to go where a device, a pipe, a link, a folder, a
# long name, a limit or nothing at all is. No node of the machine is tried: devices are copies in the scratch folder, or
# links from there.
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
parts_left() { find . -name '*.granum.part' -type f | grep -q .; }

state=(estimate --void-ratio 0.6 --pressure 100kPa --full)
"$program" "${state[@]}" >expected || exit 1

# Devices: written to with and without --force, never replaced.
mknod null c 1 3 2>/dev/null && node=null || node=/dev/null # who is not root cannot replace the real one
[[ $node == null ]] && for force in "" --force; do
  ends 0 "${state[@]}" --out null $force
  [[ -c null ]] || fail "a device was replaced, with '$force'"
done
ln -s "$node" link
for force in "" --force; do
  ends 0 "${state[@]}" --out link $force
  [[ -L link && -c link ]] || fail "a link to a device was replaced, with '$force'"
done
ln -s /dev/full full
ends 3 "${state[@]}" --out full
ends 3 "${state[@]}" --out full --force
[[ -L full ]] || fail "a link to a full device was replaced"

# The descriptors of the program: its standard output, be it a pipe or a file, and what a shell makes of >(...).
ends 0 "${state[@]}" --out /dev/stdout
cmp -s answer expected || fail "/dev/stdout that is a file"
"$program" "${state[@]}" --out /dev/stdout 2>said | cmp -s - expected || fail "/dev/stdout that is a pipe: $(cat said)"
ln -s /proc/self/fd/1 own
ends 0 "${state[@]}" --out own --force
{ cmp -s answer expected && [[ -L own ]]; } || fail "a link to standard output"
ends 0 "${state[@]}" --out >(cat >got)
for ((k = 0; k < 500; ++k)); do cmp -s got expected && break; sleep 0.01; done
cmp -s got expected || fail "a process that reads"
ends 3 "${state[@]}" --out /dev/fd/99

# Pipes by name: one that is read, one that nobody reads, one whose reader leaves.
mkfifo pipe
for force in "" --force; do
  (exec timeout 60 cat pipe >got) &
  reader=$!
  ends 0 "${state[@]}" --out pipe $force
  wait "$reader"
  cmp -s got expected || fail "a pipe got something else, with '$force'"
  ends 3 "${state[@]}" --out pipe $force
  (exec timeout 60 head -c 1 pipe >got) &
  reader=$!
  ends 3 sweep --void-ratio 0.6 --from 10kPa --to 20kPa --points 2000 --out pipe $force
  wait "$reader"
  [[ -p pipe ]] || fail "a pipe was replaced, with '$force'"
done

# What is in the way of the temporary name.
for make in 'mkfifo' 'mkdir' 'ln -s expected' 'ln -s link'; do
  rm -rf result result.granum.part
  $make result.granum.part
  ends 3 "${state[@]}" --out result
  [[ -e result.granum.part && ! -e result ]] || fail "$make: was in the way, and is gone"
done
rm -rf result result.granum.part
"$program" "${state[@]}" | cmp -s - expected || fail "the answer has changed"

# Folders and links.
mkdir place
ends 3 "${state[@]}" --out place --force
ends 3 "${state[@]}" --out place/ --force
ln -s place to-folder
ends 3 "${state[@]}" --out to-folder --force
echo kept >target
ln -s target to-file
ends 3 "${state[@]}" --out to-file
ends 0 "${state[@]}" --out to-file --force
{ [[ $(cat target) == kept && ! -L to-file ]] && cmp -s to-file expected; } || fail "a link to a file is replaced, not followed"
ends 3 "${state[@]}" --out /proc/granum
ends 3 "${state[@]}" --out ""$'no\nfolder/result'

# Names as long as the file system takes them, of one byte and of three bytes a character.
for length in 240 243 244 250 255; do
  name=$(printf '%*s' "$length" '' | tr ' ' n)
  ends 0 "${state[@]}" --out "$name"
  cmp -s "$name" expected || fail "a name of $length bytes"
done
ends 0 "${state[@]}" --out "$(printf '\xe7\xa0\x82%.0s' {1..85})"
ends 3 "${state[@]}" --out "$(printf '%256s' '' | tr ' ' n)"

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

parts_left && fail "parts are left: $(find . -name '*.granum.part' -type f)"
exit "$((faults > 0))"
