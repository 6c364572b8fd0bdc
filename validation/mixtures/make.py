#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes packings of spheres of two materials with LAMMPS, from the decks that granum exports.

    make.py GRANUM FOLDER

The deck is that of one material; here the grains get two types at random, or by their size, and each pair of
types has a pair_coeff of its own. A packing whose file "done" is in its folder is not made again. Needs lmp
(LAMMPS with the package GRANULAR); 1 to 4 minutes for a packing on one core.
"""
import os
import pathlib
import random
import re
import subprocess
import sys

SOFT, NU = 2e9, 0.2  # G_g of the softer material [Pa], Poisson's ratio of both
RATIOS = (10, 100, 30, 3)  # G_g stiff over soft
SHARES = {0.5: 20, 0.25: 80, 0.75: 230}  # share of the stiff grains, and a number of its seeds
SIZED = {"large": 1000, "small": 2000}  # which grains are the stiff ones, likewise
PREPARATIONS = ("dense", "loose")


def pair_coefficients(moduli):
    lines = ""
    for i, first in enumerate(moduli, 1):
        for j, second in list(enumerate(moduli, 1))[i - 1 :]:
            young = 1 / ((1 - NU) / (2 * first) + (1 - NU) / (2 * second))  # E* of the pair
            shear = 1 / ((2 - NU) / first + (2 - NU) / second)
            lines += (
                f"pair_coeff {i} {j} hertz {4 / 3 * young!r} ${{restitution}} tangential mindlin/force "
                f"{8 * shear!r} ${{tangential_damping}} ${{mu}} damping tsuji\n"
            )
    return lines


def with_types(data, chosen):
    """The file of grains, where chosen(radii) says which of them are of type 2."""
    head, rows = data.split("Atoms # sphere\n")
    fields = [row.split() for row in rows.split("\n") if row.strip()]
    stiff = chosen([float(f[2]) for f in fields])
    lines = [" ".join([f[0], "2" if is_stiff else "1", *f[2:]]) for f, is_stiff in zip(fields, stiff)]
    return head.replace("1 atom types", "2 atom types") + "Atoms # sphere\n\n" + "\n".join(lines) + "\n"


def make(granum, folder, preparation, ratio, seed, sizes, chosen):
    stiff = SOFT * ratio
    settings = {
        "study.first_seed": seed,
        "study.contacts": "sphere",
        "study.densities": preparation,
        "study.pressures": "50kPa,100kPa,200kPa",
        "study.probe_pressures": "100kPa",
        "grain.shear_modulus": f"{stiff}Pa",
        "grain.poisson_ratio": NU,
        "grain.sizes": sizes,
    }
    options = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    export = [granum, "export", "lammps", "--grains", "800", "--seeds", "1", "--start", "scattered", *options]
    subprocess.run([*export, "--out", folder, "--force"], check=True, stdout=subprocess.DEVNULL)
    deck = next(path for path in folder.iterdir() if path.is_dir())
    grains, model = deck / "grains.data", deck / "model.lmp"
    grains.write_text(with_types(grains.read_text(), chosen))
    text, count = re.subn(
        r"pair_coeff \* \*.*?damping tsuji\n", pair_coefficients([SOFT, stiff]), model.read_text(), flags=re.S
    )
    assert count == 1
    model.write_text(text)
    for part in ("in.prepare", "in.iso"):
        subprocess.run(["lmp", "-in", part], cwd=deck, check=True, stdout=subprocess.DEVNULL)
    (folder / "done").touch()


def at_random(share, seed):
    def chosen(radii):
        stiff = [k < round(len(radii) * share) for k in range(len(radii))]
        random.Random(seed).shuffle(stiff)
        return stiff

    return chosen


def by_size(which):
    return lambda radii: [(r > sum(radii) / len(radii)) == (which == "large") for r in radii]


def main(granum, folder):
    granum, folder = os.path.abspath(granum), pathlib.Path(folder).resolve()
    plans = [
        (f"{preparation}_{ratio}_{share}", preparation, ratio, first + 7 * ratio, "equal",
         at_random(share, first + 7 * ratio))
        for share, first in SHARES.items()
        for ratio in RATIOS
        for preparation in PREPARATIONS
    ]
    plans += [
        (f"{preparation}_{ratio}_{which}", preparation, ratio, first + 7 * ratio, "bidisperse:2", by_size(which))
        for which, first in SIZED.items()
        for ratio in RATIOS[:2]
        for preparation in PREPARATIONS
    ]
    for name, *plan in plans:
        if not (folder / name / "done").exists():
            make(granum, folder / name, *plan)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(f"usage: {sys.argv[0]} GRANUM FOLDER")
    main(*sys.argv[1:])
