#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_exit_codes.sh <program> <table> <data> <scratch folder>: runs each row of the table, and checks its exit code. A run
# that failed must say why; one that went well or was stopped must not speak of an error.
program=$1 table=$2 data=$3 folder=$4
rm -rf -- "$folder" && mkdir -p -- "$folder" && cd -- "$folder" || exit 1

mkdir -p folder replaced-report holds-report holds-deck/dense-1 blocked/states.csv blocked-checkpoints
echo kept | tee existing existing.svg beside.gp holds-deck/dense-1/manifest.json blocked-checkpoints/checkpoints >replaced
ln -s /dev/full full
for name in report.html trade.csv; do echo kept | tee holds-report/$name >replaced-report/$name; done
printf '\x1f\x8b\x08 is no compressed file' >damaged.gz
printf 'p_kPa\n100\n200\n' >rows.csv
printf 'p_kPa\n100\n-200\n' >bad-row.csv
printf 'p_kPa\n-100\n-200\n' >bad-rows.csv
cp "$data/isotropic.csv" fit.csv
cp "$data/hv_dense_cone.csv" shear.csv
sed 's/,10,10,/,10,-10,/' fit.csv >bad-fit.csv
cp "$data"/../../io/data/lammps_chain.* .

state='--void-ratio 0.6 --pressure 100kPa'
path='--void-ratio 0.6 --from 50kPa --to 200kPa --points 3'
chain='lammps_chain.atoms lammps_chain.contacts'
small='--grains 80 --seeds 1 --set study.contacts=sphere --set study.pressures=20kPa,40kPa,60kPa --set study.probe_pressures='
jammed="$small --set specimen.unjamming_strain=1e-9"
short="$small --set study.densities=dense --set shear.paths=TXC --set shear.largest_strain=0.001"
long='--grains 20000 --set study.contacts=sphere --threads 1'
quick='--quick --grains 60 --set study.densities=dense'
deck="$small --set study.densities=dense"
long_deck=${deck/80/20000}

# ended <signal or nothing> <argument>...: the exit code; what was said is in ./said
ended() {
  local signal=$1
  shift
  if [[ -z $signal ]]; then
    timeout 300 "$program" "$@" 2>said
  else
    rm -rf stopped
    "$data/../stop_when.sh" stopped "$signal" "$program" "$@" --out stopped >/dev/null 2>said
  fi
}

rows=0 faults=0
while read -r code command rest; do
  [[ $code == [0-9]* ]] || continue
  event=${rest%%  *}
  arguments=${rest:${#event}}
  signal=
  [[ $arguments =~ ^\ +(INT|TERM|HUP)\ (.*) ]] && signal=${BASH_REMATCH[1]} arguments=${BASH_REMATCH[2]}
  words=$command
  [[ $command == export && $event != 'no code named' ]] && words='export lammps'
  eval "ended '$signal' $words $arguments" >answer
  found=$?
  rows=$((rows + 1))
  error=no
  grep -q '^granum: error: ' said && error=yes
  expected=yes
  [[ $code == 0 || -n $signal ]] && expected=no
  [[ $found == "$code" && $error == "$expected" ]] && continue
  printf '%s, %s: exit code %s, expected %s; said:\n%s\n' "$command" "$event" "$found" "$code" "$(head -3 said)"
  faults=$((faults + 1))
done <"$table"
printf '%s rows, %s of them not as the table says\n' "$rows" "$faults"
exit "$((rows < 100 || faults > 0))"
