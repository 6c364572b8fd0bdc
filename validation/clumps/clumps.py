#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far closed forms for spheres are from packings of rigid clumps.

    clumps.py run <granum> <yade> <folder>   # makes packings that the folder does not have (half an hour), writes clumps.csv
    clumps.py table                          # prints the table of README.md

`run` needs the Python package and numpy. A body becomes the sphere of its volume: R = (3 V_b/(4 pi))^(1/3), e from that volume,
C_n and z* by bodies; k_n is that of the springs.
"""

import csv
import itertools
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
RECORD = HERE / "clumps.csv"
GRAINS_OF = {"spheres": 1, "pairs": 2, "rods": 3, "tetrahedra": 4}
FRICTION = {"dense": ["--friction", "0", "--friction-at-rest", "0.46"], "loose": ["--friction", "0.46"]}
BODIES, RADIUS, TANGENTIAL_RATIO = 400, 0.5e-3, 0.919


def union_volume(centres):
    """Of the spheres of one body, by the share of the points of a fine grid [m3]."""
    import numpy as np

    low, high = centres.min(axis=0) - RADIUS, centres.max(axis=0) + RADIUS
    number = 160
    axes = [low[k] + (np.arange(number) + 0.5) / number * (high[k] - low[k]) for k in range(3)]
    inside = np.zeros((number,) * 3, dtype=bool)
    for centre in centres:
        x, y, z = ((axes[k] - centre[k]) ** 2 for k in range(3))
        inside |= x[:, None, None] + y[:, None] + z < RADIUS**2
    return inside.mean() * np.prod(high - low)


def row_of(program, name, shape, preparation, seed):
    import granum
    import numpy as np

    said = subprocess.run([program, "analyse", f"{name}.grains", f"{name}.contacts", "--json"], check=True, capture_output=True, text=True)
    frame = json.loads(said.stdout)["frames"][0]
    counts, moduli = frame["counts"], frame["moduli"]
    count = GRAINS_OF[shape]
    # the grains of a body follow one another
    body = np.loadtxt(f"{name}.grains", usecols=(2, 3, 4))[:count]
    volume = union_volume(body) if count > 1 else 4 / 3 * np.pi * RADIUS**3
    bodies = counts["grains"] // count
    e = frame["volume"] / (bodies * volume) - 1
    k_n = float(np.loadtxt(f"{name}.contacts", usecols=18).mean())
    pairs = np.sort(np.loadtxt(f"{name}.contacts", usecols=(0, 1)).astype(int) // count, axis=1)
    neighbours = 2 * len(np.unique(pairs, axis=0)) / bodies
    radius = (3 * volume / (4 * np.pi)) ** (1 / 3)
    punch = 0.05 * radius
    law = granum.flat_punch(shear_modulus=k_n * (1 - 0.15) / (2 * punch), poisson_ratio=0.15, punch_radius=punch)
    packing = dict(law=law, radius=radius, void_ratio=e, coordination_number=counts["coordination_number"],
                   pressure=frame["stress"]["mean"], tangential_ratio=TANGENTIAL_RATIO)
    uniform = granum.uniform_strain(**packing)
    relaxed = granum.relaxed(**packing, mechanical_coordination_number=counts["mechanical_coordination_number"])
    row = {"shape": shape, "preparation": preparation, "seed": seed, "bodies": bodies, "p_Pa": frame["stress"]["mean"], "e": e,
           "C_n": counts["coordination_number"], "z_star": counts["mechanical_coordination_number"], "neighbours": neighbours}
    for modulus, own in (("K", "bulk_modulus"), ("G", "G_vh")):
        row |= {f"{modulus}_network_Pa": moduli["rung4"][modulus], f"{modulus}_affine_Pa": moduli["affine"][modulus],
                f"{modulus}_uniform_Pa": float(getattr(uniform, own)), f"{modulus}_rung3_Pa": float(getattr(relaxed, own))}
    return {key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()}


def run(program, yade, folder):
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for (shape, count), (preparation, friction), seed in itertools.product(GRAINS_OF.items(), FRICTION.items(), (1, 2)):
        name = folder / f"{shape}_{preparation}_{seed}"
        if not name.with_suffix(".own").exists():  # is written last
            subprocess.run([yade, "-j1", "-n", "-x", ROOT / "tests/peer/yade/make_packing.py", name.name, ROOT / "share/yade",
                            "--law", "linear", "--step", "0.4", "--rest-at", "1e-7", "--grains", str(BODIES * count), *friction,
                            "--seed", str(seed), *(["--clumps", shape] if count > 1 else [])],
                           cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        rows.append(row_of(program, name, shape, preparation, seed))
        print(rows[-1], flush=True)
    with RECORD.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def table():
    print("| shape | preparation | e | C_n | z* | neighbours | K over uniform strain, rung 3, network's affine | G over them |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with RECORD.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for (shape, preparation), seeds in itertools.groupby(rows, lambda row: (row["shape"], row["preparation"])):
        seeds = list(seeds)

        def mean(of):
            return sum(of(row) for row in seeds) / len(seeds)

        cells = [shape, preparation, f"{mean(lambda r: float(r['e'])):.2f}"]
        cells += [f"{mean(lambda r, c=c: float(r[c])):.2f}" for c in ("C_n", "z_star", "neighbours")]
        for m in "KG":
            cells.append(", ".join(f"{mean(lambda r, c=c: float(r[f'{m}_network_Pa']) / float(r[f'{m}_{c}_Pa'])):.2f}"
                                   for c in ("uniform", "rung3", "affine")))
        print("| " + " | ".join(cells) + " |")


def main():
    if sys.argv[1:] == ["table"]:
        table()
    elif len(sys.argv) == 5 and sys.argv[1] == "run":
        run(*(pathlib.Path(text).resolve() for text in sys.argv[2:5]))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
