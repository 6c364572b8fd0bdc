#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rung 3 of the interior of a box with walls, beside the stiffness that this interior has while the whole box is strained.

    windows.py <granum> <yade> <granum>/share/yade <folder> [<scenes>]

YADE compresses 1,000 spheres between six walls. `granum analyse` chooses the window and gives its rung 3, and the stiffness of
the whole box. Here the contacts of the files are solved once more, densely, with walls that follow the mean strain; the
stiffness of the window is the change of its stress (branches as far as they lie inside) over its own mean strain (a straight
line through the displacements of its grains). Exit code 0 if the dense solution has granum's stiffness of the whole box to
0.1 % (its contacts touch in the middle of their overlaps, which are some 0.05 % of the diameter), and in nine of ten scenes K
of rung 3 is within two stated errors of the window's. G is printed and not demanded: see README.md.
"""

import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # scenes side by side
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
VOIGT = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)]


def cross(r):
    """The matrix of r x."""
    return np.array([[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]])


class Box:
    """Grains and contacts of the files of make_packing.py; grains without two contacts carry nothing and are left out."""

    def __init__(self, name):
        grains = np.loadtxt(f"{name}.grains")
        rows = np.loadtxt(f"{name}.contacts")
        place = {int(row[0]): k for k, row in enumerate(grains)}
        self.x = grains[:, 2:5]
        self.contacts = []  # grain, grain or None for a wall, point, normal, k_n, k_t
        for row in rows:
            ends = [place.get(int(e)) for e in row[:2]]
            point, normal, stiffness = row[5:8], row[8:11], row[18:20]
            if ends[0] is None:
                ends.reverse()
                normal = -normal
            self.contacts.append((*ends, point, normal, *stiffness))
        while True:
            count = np.bincount([e for c in self.contacts for e in c[:2] if e is not None], minlength=len(self.x))
            kept = [c for c in self.contacts if all(count[e] > 1 for e in c[:2] if e is not None)]
            if len(kept) == len(self.contacts):
                break
            self.contacts = kept
        self.carries = count > 1

    def displacements(self, strain):
        """Of all grains when walls follow the strain, spins at rest in the mean: (N, 3) of places, and the forces of contacts."""
        number = len(self.x)
        matrix, load = np.zeros((6 * number, 6 * number)), np.zeros(6 * number)
        for i, j, point, n, k_n, k_t in self.contacts:
            k = k_t * np.eye(3) + (k_n - k_t) * np.outer(n, n)
            parts = [(i, np.hstack([-np.eye(3), cross(point - self.x[i])]))]
            if j is not None:
                parts.append((j, np.hstack([np.eye(3), -cross(point - self.x[j])])))
            else:
                load[6 * i : 6 * i + 6] -= parts[0][1].T @ k @ (strain @ point)
            for a, of_a in parts:
                for b, of_b in parts:
                    matrix[6 * a : 6 * a + 6, 6 * b : 6 * b + 6] += of_a.T @ k @ of_b
        free = np.repeat(self.carries, 6)
        matrix = matrix[np.ix_(free, free)]
        matrix[np.diag_indices_from(matrix)] *= 1 + 1e-10  # pairs that turn about each other
        solution = np.zeros(6 * number)
        solution[free] = np.linalg.solve(matrix, load[free])
        moved = solution.reshape(number, 6)
        forces = []
        for i, j, point, n, k_n, k_t in self.contacts:
            k = k_t * np.eye(3) + (k_n - k_t) * np.outer(n, n)

            def at(e):
                return moved[e, :3] + np.cross(moved[e, 3:], point - self.x[e])

            forces.append(k @ ((strain @ point if j is None else at(j)) - at(i)))
        return moved[:, :3], forces

    def stress(self, forces, low, high):
        """By the parts of branches between two corners."""
        total = np.zeros((3, 3))
        for (i, j, point, *_), force in zip(self.contacts, forces):
            begin, end = self.x[i], point if j is None else self.x[j]
            branch = end - begin
            with np.errstate(divide="ignore", invalid="ignore"):
                cuts = np.sort(np.stack([(low - begin) / branch, (high - begin) / branch]), axis=0)
            part = min(1, np.nanmin(cuts[1])) - max(0, np.nanmax(cuts[0]))
            outside = (branch == 0) & ((begin < low) | (begin > high))
            if part > 0 and not outside.any():
                total += part * np.outer(branch, force)
        return (total + total.T) / 2 / np.prod(high - low)


def stiffnesses(box, low, high):
    """6x6 of the window, by its own strain, and of the whole box, by that of the walls."""
    inside = box.carries & np.all((box.x > low) & (box.x < high), axis=1)
    centred = box.x[inside] - box.x[inside].mean(axis=0)
    whole_low, whole_high = box.x.min(axis=0) - 1, box.x.max(axis=0) + 1
    strains, stresses, whole = np.zeros((6, 6)), np.zeros((6, 6)), np.zeros((6, 6))
    for case, (a, b) in enumerate(VOIGT):
        strain = np.zeros((3, 3))
        strain[a, b] += 0.5
        strain[b, a] += 0.5
        moved, forces = box.displacements(strain)
        gradient = np.linalg.lstsq(centred, moved[inside] - moved[inside].mean(axis=0), rcond=None)[0]
        gradient = (gradient + gradient.T) / 2
        window = box.stress(forces, low, high)
        all_of_it = box.stress(forces, whole_low, whole_high) * np.prod(whole_high - whole_low)
        for row, (c, d) in enumerate(VOIGT):
            strains[row, case] = gradient[c, d] * (1 if row < 3 else 2)
            stresses[row, case] = window[c, d]
            whole[row, case] = all_of_it[c, d]
    return stresses @ np.linalg.inv(strains), whole


def isotropic(c):
    """K and G of the nearest isotropic stiffness."""
    bulk = c[:3, :3].sum() / 9
    return bulk, (c[0, 0] + c[1, 1] + c[2, 2] - c[0, 1] - c[1, 2] - c[0, 2] + 3 * (c[3, 3] + c[4, 4] + c[5, 5])) / 15


def judged(program, yade, share, folder, seed):
    name = folder / f"walls_{seed}"
    if not name.with_suffix(".contacts").exists():
        subprocess.run([yade, "-j1", "-n", "-x", HERE / "make_packing.py", name.name, share, "--seed", str(seed), "--walls",
                        "--grains", "1000", "--rate", "20"], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    said = subprocess.run([program, "analyse", f"{name}.grains", f"{name}.contacts", "--json"], check=True, capture_output=True, text=True)
    frame = json.loads(said.stdout)["frames"][0]
    rung = frame["moduli"]["rung3"]
    low, high = (np.array(frame["window"][end]) for end in ("low", "high"))
    window, whole = stiffnesses(Box(name), low, high)
    bulk, shear = isotropic(window)
    granum_whole = np.array(frame["network"]["relaxed"]["C"])
    off = np.abs(whole / frame["volume"] - granum_whole).max() / np.abs(granum_whole).max()
    error = {"K": rung["relative_error"]["K"], "G": rung["relative_error"]["G_vh"]}
    times = {"K": (rung["K"] / bulk - 1) / error["K"], "G": (rung["G"] / shear - 1) / error["G"]}
    right = off < 1e-3 and abs(times["K"]) <= 2
    print(f"seed {seed}: window of {frame['window']['grains']} grains: K {bulk / 1e6:.1f}, G {shear / 1e6:.1f} MPa; rung 3 "
          + ", ".join(f"{m} {rung[m] / 1e6:.1f} ({times[m]:+.1f} stated errors of {100 * error[m]:.1f} %)" for m in "KG")
          + f"; whole box off by {off:.1e}", flush=True)
    return right, abs(times["G"]) <= 2


def main():
    program, yade, share, folder = (pathlib.Path(text).resolve() for text in sys.argv[1:5])
    scenes = int(sys.argv[5]) if len(sys.argv) > 5 else 10
    folder.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        bulk, shear = zip(*pool.map(lambda seed: judged(program, yade, share, folder, seed), range(1, scenes + 1)))
    print(f"within two stated errors: K in {sum(bulk)}, G in {sum(shear)} of {scenes} scenes")
    return 0 if 10 * sum(bulk) >= 9 * scenes else 1


if __name__ == "__main__":
    sys.exit(main())
