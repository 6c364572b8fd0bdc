#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What bash offers after the beginning of a command line:  check_completion.sh <program> <completion script>
set -euo pipefail
program=$1
source "$2"

# offered <words> <word that is being typed>: what completion answers, in one line
offered() {
  read -r -a COMP_WORDS <<< "granum $1"
  COMP_WORDS+=("$2")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _granum
  echo "${COMPREPLY[*]:-}"
}

expect() {
  local answer
  answer=$(offered "$1" "$2")
  if [[ $answer != "$3" ]]; then
    echo "granum $1 $2<TAB>: '$answer', expected '$3'" >&2
    exit 1
  fi
}

expect "" es "estimate"
expect "" "--v" "--version"
expect "estimate" --void "--void-ratio"
expect "estimate --void-ratio 0.6" --pres "--pressure"
expect "estimate --contact" s "sphere"
expect "estimate --contact =" c "cone"
expect "estimate --preparation" f "friction:"
expect "estimate --pressure" "" ""
expect "estimate --out" isotropic. "isotropic.csv"
expect "export" l "lammps"
expect "export lammps" --sta "--start"
expect "export lammps --start" sc "scattered"
expect "infer --growth" "" "packings fixed fitted sand"
expect "fit" isotropic_ "isotropic_by_hand.csv"
expect "fit isotropic.csv" --sum "--sum-only"
expect "analyse analyse_lattice.grains" analyse_lattice.c "analyse_lattice.contacts"

# Every option that help lists is offered.
for command in estimate infer sweep fit analyse verify plan reproduce trade "export lammps"; do
  all=" $(offered "$command" --) "
  # shellcheck disable=SC2086
  for option in $("$program" $command --help | grep -oE '^  --[a-z0-9-]+'); do
    if [[ $all != *" $option "* ]]; then
      echo "granum $command: $option is not offered" >&2
      exit 1
    fi
  done
done
