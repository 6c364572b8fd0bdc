#!/usr/bin/env zsh
# SPDX-License-Identifier: GPL-3.0-or-later
# What zsh makes of the beginning of a command line and a tab:  check_completion.zsh <folder of _granum>
# A shell of its own loads the completion as an installed one is, through compinit.
emulate -L zsh
zmodload zsh/zpty || exit 77
folder=${1:a}
scratch=$(mktemp -d) || exit 1
trap 'rm -rf $scratch' EXIT

# In the inner shell a key shows the line as it stands, between marks.
cat > $scratch/start.zsh <<END
PS1= PS2= RPS1=
unsetopt zle_bracketed_paste 2>/dev/null
stty -echo 2>/dev/null
fpath=($folder \$fpath)
autoload -Uz compinit
compinit -u -d $scratch/dump
zstyle ':completion:*' list-prompt ''
zstyle ':completion:*' menu no
setopt no_auto_list no_auto_menu no_list_beep no_list_ambiguous
show-line() { print -r -- "<<\$BUFFER>>" > $scratch/line; BUFFER= }
zle -N show-line
bindkey '^X^L' show-line
print ready > $scratch/ready
END

zpty shell "ZDOTDIR=$scratch TERM=dumb COLUMNS=80 zsh -f -i"
zpty -w shell "source $scratch/start.zsh"

wait_for() {
  local k
  for ((k = 0; k < 3000; ++k)); do
    [[ -s $1 ]] && return 0
    zpty -r -t shell ignored 2>/dev/null
    sleep 0.02
  done
  print -u2 "the inner shell does not answer"
  exit 1
}
wait_for $scratch/ready

expect() {
  rm -f $scratch/line
  zpty -w -n shell "$1"$'\t'$'\C-x\C-l'
  wait_for $scratch/line
  local found=$(<$scratch/line)
  if [[ $found != "<<$2>>" ]]; then
    print -u2 -r -- "$1<TAB>: '$found', expected '<<$2>>'"
    exit 1
  fi
}

expect "granum est" "granum estimate "
expect "granum estimate --void" "granum estimate --void-ratio="
expect "granum estimate --void-ratio 0.6 --pres" "granum estimate --void-ratio 0.6 --pressure="
expect "granum estimate --contact sp" "granum estimate --contact sphere "
expect "granum estimate --contact=c" "granum estimate --contact=cone "
expect "granum infer --growth pa" "granum infer --growth packings "
expect "granum export lam" "granum export lammps "
expect "granum export lammps --start sc" "granum export lammps --start scattered "
expect "granum fit isotropic.csv --sum" "granum fit isotropic.csv --sum-only "
zpty -d shell
print "zsh completes"
