#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rung 3 of the interior of a box with walls, beside the stiffness that this interior has while the whole box is strained.

    windows.py <granum> <yade> <granum>/share/yade <folder> [<scenes>]

YADE compresses 4,000 spheres (some 3,600 find a place) between six walls. `granum analyse` chooses the window and gives its
rung 3, and the stiffness of the whole box. Here the contacts of the files are solved once more, by conjugate gradients, with
walls that follow the mean strain; the stiffness of the window is the change of its stress (branches as far as they lie inside)
over its own mean strain (a straight line through the displacements of its grains). Exit code 0 if this solution has granum's
stiffness of the whole box to 0.1 % (its contacts touch in the middle of their overlaps, which are some 0.05 % of the diameter),
and in nine of ten scenes K and G of rung 3 are within two stated errors of the window's.
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


class Box:
    """Grains and contacts of the files of make_packing.py; grains without two contacts carry nothing and are left out."""

    def __init__(self, name):
        grains = np.loadtxt(f"{name}.grains")
        rows = np.loadtxt(f"{name}.contacts")
        self.x = grains[:, 2:5]
        self.number = len(self.x)
        place = {int(row[0]): k for k, row in enumerate(grains)}
        ends = np.array([[place.get(int(e), self.number) for e in row[:2]] for row in rows])  # one more "grain" for all walls
        swapped = ends[:, 0] == self.number
        ends[swapped] = ends[swapped, ::-1]
        normals = np.where(swapped[:, None], -1, 1) * rows[:, 8:11]
        while True:
            count = np.bincount(ends.ravel(), minlength=self.number + 1)
            count[self.number] = 2
            kept = np.all(count[ends] > 1, axis=1)
            if kept.all():
                break
            ends, rows, normals = ends[kept], rows[kept], normals[kept]
        self.carries = count[: self.number] > 1
        self.i, self.j = ends.T
        self.wall = self.j == self.number
        self.point, self.n = rows[:, 5:8], normals
        self.k_n, self.k_t = rows[:, 18:20].T
        centres = np.vstack([self.x, np.zeros(3)])
        self.arms = self.point - centres[self.i], np.where(self.wall[:, None], 0, self.point - centres[self.j])

    def force(self, relative):
        """Of contacts whose sides move by `relative` to each other."""
        along = np.sum(relative * self.n, axis=1)
        return self.k_t[:, None] * relative + ((self.k_n - self.k_t) * along)[:, None] * self.n

    def relative(self, moved):
        """How the second side of each contact moves from the first; moved: (N, 6), walls at rest."""
        moved = np.vstack([moved, np.zeros(6)])
        (of_i, of_j), (at_i, at_j) = (moved[self.i], moved[self.j]), self.arms
        return of_j[:, :3] + np.cross(of_j[:, 3:], at_j) - of_i[:, :3] - np.cross(of_i[:, 3:], at_i)

    def balance(self, force):
        """Forces and moments on the grains, (N, 6), against those of the contacts."""
        total = np.zeros((self.number + 1, 6))
        for side, ends, arm in ((-1, self.i, self.arms[0]), (1, self.j, self.arms[1])):
            parts = side * np.hstack([force, np.cross(arm, force)])
            for column in range(6):
                total[:, column] += np.bincount(ends, weights=parts[:, column], minlength=self.number + 1)
        return total[:-1]

    def displacements(self, strain):
        """Of all grains when walls follow the strain, (N, 3), and the forces of contacts: by conjugate gradients."""
        imposed = np.where(self.wall[:, None], self.point @ strain, 0)
        load = -self.balance(self.force(imposed))
        size = np.r_[np.ones(3), np.full(3, np.abs(self.arms[0]).max())]  # rotations as displacements of the surface
        moved, residual = np.zeros_like(load), load / size
        direction, before = residual.copy(), np.sum(residual**2)
        goal = 1e-16 * before
        for _ in range(20000):
            along = self.balance(self.force(self.relative(direction / size))) / size
            step = before / np.sum(direction * along)
            moved += step * direction
            residual -= step * along
            after = np.sum(residual**2)
            if after < goal:
                moved /= size
                return moved[:, :3], self.force(self.relative(moved) + imposed)
            direction = residual + after / before * direction
            before = after
        raise RuntimeError("the contacts' equations were not solved")

    def stress(self, forces, low, high):
        """By the parts of branches between two corners."""
        begin = self.x[self.i]
        branch = np.where(self.wall[:, None], self.point, self.x[np.minimum(self.j, self.number - 1)]) - begin
        with np.errstate(divide="ignore", invalid="ignore"):
            cuts = np.sort(np.stack([(low - begin) / branch, (high - begin) / branch]), axis=0)
        part = np.minimum(1, np.nanmin(cuts[1], axis=1)) - np.maximum(0, np.nanmax(cuts[0], axis=1))
        outside = np.any((branch == 0) & ((begin < low) | (begin > high)), axis=1)
        part = np.where(outside, 0, np.maximum(part, 0))
        total = (part[:, None] * branch).T @ forces
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
    if not name.with_suffix(".own").exists():  # is written last
        subprocess.run([yade, "-j1", "-n", "-x", HERE / "make_packing.py", name.name, share, "--seed", str(seed), "--walls",
                        "--grains", "4000", "--rate", "20"], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    said = subprocess.run([program, "analyse", f"{name}.grains", f"{name}.contacts", "--json"], check=True, capture_output=True, text=True)
    frame = json.loads(said.stdout)["frames"][0]
    rung = frame["moduli"]["rung3"]
    low, high = (np.array(frame["window"][end]) for end in ("low", "high"))
    window, whole = stiffnesses(Box(name), low, high)
    bulk, shear = isotropic(window)
    granum_whole = np.array(frame["network"]["relaxed"]["C"])
    off = np.abs(whole / frame["volume"] - granum_whole).max() / np.abs(granum_whole).max()
    error = {"K": rung["relative_error"]["K"], "G": rung["relative_error"]["G_vh"]}
    ratio = {"K": rung["K"] / bulk, "G": rung["G"] / shear}
    print(f"seed {seed}: window of {frame['window']['grains']} grains: K {bulk / 1e6:.1f}, G {shear / 1e6:.1f} MPa; rung 3 "
          + ", ".join(f"{m} {100 * (ratio[m] - 1):+.1f} % (stated error {100 * error[m]:.1f} %)" for m in "KG")
          + f"; whole box off by {off:.1e}", flush=True)
    return off < 1e-3 and all(abs(ratio[m] - 1) <= 2 * error[m] for m in "KG")


def main():
    program, yade, share, folder = (pathlib.Path(text).resolve() for text in sys.argv[1:5])
    scenes = int(sys.argv[5]) if len(sys.argv) > 5 else 10
    folder.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        right = sum(pool.map(lambda seed: judged(program, yade, share, folder, seed), range(1, scenes + 1)))
    print(f"K and G are within two stated errors in {right} of {scenes} scenes")
    return 0 if 10 * right >= 9 * scenes else 1


if __name__ == "__main__":
    sys.exit(main())
