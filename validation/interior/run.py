#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far rung 3 of a small part of a packing is from rung 3 of the whole packing.

    PYTHONPATH=build/ci/python python3 validation/interior/run.py > validation/interior/parts.csv

Each row: a packing, of examples/data or of validation/sizes, the number of parts, the mean number of grains of a part, and for K and G_vh the
standard deviation of ln(rung 3 of the part / that of the whole) and the root mean square of these logarithms over the
error that granum adds to the stated one for the part: 1 where this error is right. Parts that are not rigid are left out.
"""

import pathlib

import granum
import numpy as np

SOURCE = pathlib.Path(__file__).parents[2]
CHOSEN_ON = ["lammps_loose_p50", "yade_packing", "yade_lognormal_dense", "yade_lognormal_loose"]
NEVER_USED = ["lognormal_dense", "lognormal_loose", "uniform_dense", "uniform_loose"]
PACKINGS = {
    **{name: sorted((SOURCE / "examples/data").glob(f"{name}.*.gz"), reverse=True) for name in CHOSEN_ON},
    **{name: sorted((SOURCE / "validation/sizes").glob(f"{name}.*.gz")) for name in NEVER_USED},
}
MODULUS = 30e9  # of the grains [Pa]; ratios do not depend on it


def moduli(packing, window):
    """ln K and ln G_vh of rung 3, their stated errors, and the number of grains whose contacts it counts."""
    found = granum.measure(packing, grain_shear_modulus=MODULUS, network=False, window=window)
    answer = found.rungs["rung3"]
    errors = answer.relative_error
    with np.errstate(divide="ignore"):
        values = np.log([answer.bulk_modulus, answer.G_vh])
    grains = len(packing.radius) if window is None else found.interior.grains
    return values, np.array([errors.bulk_modulus, errors.G_vh]), grains


def parts(packing, edge, count, rng):
    """Windows that are cubes of an edge, anywhere in the periodic cell."""
    widths = np.diag(np.asarray(packing.cell))
    for _ in range(count):
        low = rng.random(3) * widths
        yield [(float(a), float(a + edge)) for a in low]


def main():
    print("packing,parts,grains,K_sd,K_rms_over_error,G_sd,G_rms_over_error")
    for name, files in PACKINGS.items():
        packing = granum.read(*files)
        whole, error, grains = moduli(packing, None)
        volume = np.linalg.det(np.asarray(packing.cell))
        rng = np.random.default_rng(1)
        for wanted in (50, 100, 200, 400, 800):
            if 6 * wanted > grains:
                continue
            edge = (wanted / grains * volume) ** (1 / 3)
            found = [moduli(packing, window) for window in parts(packing, edge, 60, rng)]
            found = [part for part in found if np.isfinite(part[0]).all()]
            apart = np.array([values - whole for values, _, _ in found])
            added = np.sqrt(np.mean([e**2 for _, e, _ in found], axis=0) - error**2)
            rms = np.sqrt(np.mean(apart**2, axis=0)) / added
            sd = apart.std(axis=0, ddof=1)
            print(
                f"{name},{len(found)},{np.mean([n for _, _, n in found]):.0f},"
                + ",".join(f"{s:.3f},{r:.2f}" for s, r in zip(sd, rms)),
                flush=True,
            )


main()
