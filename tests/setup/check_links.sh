#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_links.sh <source tree> <scratch folder>: run.sh and test.sh, called by links from elsewhere, find the tree that they
# belong to. Copies of them call a setup.sh that says where it is.
root=$1 folder=$2
rm -rf -- "$folder" && mkdir -p -- "$folder/a tree/scripts" "$folder/bin" && cd -- "$folder" || exit 1
cp -- "$root/run.sh" "$root/test.sh" 'a tree'
printf '#!/bin/sh\nreadlink -f "$0"; exit 7\n' >'a tree/scripts/setup.sh'
chmod +x 'a tree/scripts/setup.sh'
for script in run.sh test.sh; do
  ln -s "../a tree/$script" "bin/$script"
  ln -s "bin/$script" "$script"
  for call in "./$script" "bin/$script" "a tree/$script"; do
    said=$("$call")
    code=$?
    [[ $code == 7 && $said == "$(readlink -f 'a tree/scripts/setup.sh')" ]] || { echo "$call: exit code $code, $said"; exit 1; }
  done
done
