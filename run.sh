#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The main job, from nothing: sets the machine up, builds build/release/granum, and runs `granum verify`.
# Arguments go to `granum verify`; standard output is the program's alone.
set -euo pipefail
export PATH # bash supplies one where the environment has none; cmake needs to see it
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" && pwd)

"$root/scripts/setup.sh" run
"$root/scripts/build_release.sh"
exec "$root/build/release/granum" verify "$@"
