#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does granum name what is wrong with a packing, and nothing where all is well?

    scenes.py <granum> <yade> <granum>/share/yade <folder> [<scenes of each kind>]

YADE makes thirty packings whose model does not hold, five of each kind, and thirty of plain spheres; `granum analyse` reads
each. A bad packing is judged right if a warning, or the reason why rung 3 is withheld, has the words of its cause; other causes
beside it are not looked for. A good one has no warning at all. Exit code: 0 if all
are right.
"""

import concurrent.futures
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM, YADE, SHARE, FOLDER = (pathlib.Path(text).resolve() for text in sys.argv[1:5])
EACH = int(sys.argv[5]) if len(sys.argv) > 5 else 5

SPRINGS = ["--law", "linear", "--step", "0.4"]
CAUSES = {  # the word of the cause, and what makes it
    "rolling": ("rolling", ["--law", "rolling", "--step", "0.4"]),
    "bonds": ("bonds", ["--law", "bonds", "--step", "0.4", "--unload-to", "1e5"]),
    "cohesion": ("tension", ["--law", "cohesion", "--step", "0.4", "--unload-to", "1e5"]),
    "overlaps": ("overlaps are large", [*SPRINGS, "--pressure", "1.5e8"]),
    "clumps": ("bodies", [*SPRINGS, "--clumps"]),
    "walls": ("walls", ["--walls"]),
}
# Springs of unequal grains are no good ones: their stiffness goes with the size, which no one law of granum's has, and it says so.
GOOD = [
    *([*pressure, *sizes, *friction]
      for pressure in ([], ["--pressure", "2e5"])
      for sizes in ([], ["--sizes", "uniform:0.6:1.4"], ["--sizes", "lognormal:0.25"])
      for friction in (["--friction", "0.05"], ["--friction", "0.2"])),
    [*SPRINGS, "--pressure", "2e6", "--friction", "0.05"],
    [*SPRINGS, "--pressure", "2e6", "--friction", "0.2"],
    ["--friction", "0.46"],
]


def scenes():
    for kind, (word, options) in CAUSES.items():
        for seed in range(1, EACH + 1):
            yield kind, seed, word, options
    for k in range(6 * EACH):
        yield "good", 101 + k // len(GOOD), None, GOOD[k % len(GOOD)]


def messages(name):
    """Warnings of a packing, and why rung 3 is withheld."""
    run = subprocess.run([PROGRAM, "analyse", f"{name}.grains", f"{name}.contacts", "--json"], cwd=FOLDER, capture_output=True, text=True)
    if run.returncode != 0:
        raise RuntimeError(f"{name}: exit code {run.returncode}: {run.stderr}")
    frame = json.loads(run.stdout)["frames"][0]
    return frame["warnings"] + [frame["moduli"].get("rung3", {}).get("error", "")]


def judged(scene):
    number, (kind, seed, word, options) = scene
    name = f"{number}_{kind}"
    subprocess.run([YADE, "-j1", "-n", "-x", HERE / "make_packing.py", name, SHARE, "--seed", str(seed), *options],
                   cwd=FOLDER, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    said = messages(name)
    right = any(word in text for text in said) if word else not any(said)
    return right, f"{name} (seed {seed}, {' '.join(options)}): {'right' if right else 'WRONG'}: {said}"


FOLDER.mkdir(parents=True, exist_ok=True)
with concurrent.futures.ThreadPoolExecutor(2) as pool:
    results = list(pool.map(judged, enumerate(scenes())))
for right, text in results:
    if not right:
        print(text)
print(f"{sum(right for right, _ in results)} of {len(results)} scenes are judged right")
sys.exit(0 if all(right for right, _ in results) else 1)
