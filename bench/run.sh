#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Times the closed forms beside numpy, in turn, and writes bench/results/closed_forms.{csv,md}:
#   bench/run.sh [ROUNDS]     7 rounds by default, 5 at least
# Installs nothing: scripts/setup.sh bench does. GRANUM_PYTHON is the Python that has numpy (/usr/bin/python3).
# Exit codes: 0 done, 1 granum and numpy disagree, 2 usage, 3 numpy is missing.
set -euo pipefail
export PATH # bash supplies one where the environment has none; cmake needs to see it
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
python=${GRANUM_PYTHON:-/usr/bin/python3}

rounds=${1:-7}
if [ "$#" -gt 1 ] || ! [[ $rounds =~ ^[1-9][0-9]{0,3}$ ]] || [ "$rounds" -lt 5 ]; then
  echo "usage: bench/run.sh [ROUNDS]   with 5 rounds or more" >&2
  exit 2
fi
if ! "$python" -c 'import numpy' 2>/dev/null; then
  echo "bench/run.sh: $python has no numpy; scripts/setup.sh bench installs it, GRANUM_PYTHON names another Python" >&2
  exit 3
fi

(cd -- "$root" && cmake --preset bench && cmake --build --preset bench) >&2
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
for ((round = 1; round <= rounds; ++round)); do
  echo "round $round of $rounds" >&2
  "$root/build/bench/bench/bench_closed_forms" --benchmark_min_time=0.05 \
    --benchmark_out="$scratch/granum-$round.json" --benchmark_out_format=json >/dev/null 2>&1
  "$python" "$root/bench/numpy_baseline.py" "$scratch/numpy-$round.json"
done
"$python" "$root/bench/table.py" "$scratch" "$root/bench/results"
