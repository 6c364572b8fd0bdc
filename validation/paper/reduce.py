#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is kept here of the folder that `granum reproduce --paper` writes.

    reduce.py FOLDER OUT             FOLDER of granum reproduce; OUT gets the files
    reduce.py seeds OUT FOLDER...    angles_by_seed.csv of runs that differ in their seeds, OUT's own the first
    reduce.py windows OUT            prints how much of Table 2 is met if e and C_n are taken in one part of the box
    reduce.py guess OUT              prints the rms of the exponents of Table 5 less the printed ones, and that of a guess

Tables as they are; states and curves in six digits, states without their 6x6 matrices, every fifth point of the
curves; and angles_by_strain.csv, the mobilised friction angle if each path had ended at a smaller axial strain,
beside the paper's.
"""
import collections
import csv
import math
import pathlib
import shutil
import statistics
import sys

ENDS = (0.0025, 0.005, 0.0075, 0.01, 0.015, 0.02, 0.03)  # axial strain, either sense
TABLES = ("table2.csv", "table4.csv", "table5.csv", "exponents.csv", "verdicts.csv")
PICTURES = ("fig06_sphere_dense", "fig06_sphere_loose", "fig08_cone_dense_3", "fig10_sphere_dense_G_hv_eta",
            "fig13_sphere_loose_G_hv_eta", "fig15_dense", "fig15_loose", "fig16_sphere_dense", "fig18_sphere_dense_C_n",
            "fig18_sphere_dense_a")


def rows_of(path):
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def short(text):
    try:
        return f"{float(text):.6g}"
    except ValueError:
        return text


def write(path, header, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(header)
        out.writerows(rows)


def friction_angle(eta):
    """Of q/p' [deg]; sin(phi) = 3 eta/(6 + eta), extension negative."""
    return math.degrees(math.asin(3 * abs(eta) / (6 + eta)))


def angles_by_strain(curves, table_4):
    points = collections.defaultdict(list)
    for row in curves:
        points[row["contact"], row["density"], row["path"]].append((abs(float(row["axial_strain"])), float(row["eta"])))
    for row in table_4:
        key = row["contact"], row["density"], row["quantity"].split()[0]
        for end in ENDS:
            peak = max((eta for strain, eta in points[key] if strain <= end * 1.001), key=abs)
            angle, printed = friction_angle(peak), float(row["paper"])
            yield [*key, end, f"{angle:.2f}", printed, f"{angle - printed:.2f}"]


def angles_by_seed(out, folders):
    """Means over the seeds, beside the paper's."""
    tables = [[row for row in rows_of(folder / "table4.csv") if "deg" in row["quantity"]] for folder in [out, *folders]]
    rows, gaps = [], collections.defaultdict(list)
    for seeds in zip(*tables, strict=True):
        key = seeds[0]["contact"], seeds[0]["density"], seeds[0]["quantity"].split()[0]
        angles, printed = [float(row["granum"]) for row in seeds], float(seeds[0]["paper"])
        mean = statistics.fmean(angles)
        error = statistics.stdev(angles) / math.sqrt(len(angles))
        gaps["extension" if key[2].endswith("E") else "compression"].append(mean - printed)
        rows.append([*key, printed, *(f"{angle:.2f}" for angle in angles), f"{mean:.2f}", f"{error:.2f}", f"{mean - printed:.2f}"])
    names = [f"seed_{k}_deg" for k in range(1, len(tables) + 1)]
    write(out / "angles_by_seed.csv",
          ["contact", "density", "path", "paper_deg", *names, "mean_deg", "standard_error_deg", "difference_deg"], rows)
    for sense, off in gaps.items():
        print(f"{sense}: {statistics.fmean(off):+.2f} deg in the mean, {min(off):+.2f} to {max(off):+.2f}")
    off = [abs(gap) for all_of_one in gaps.values() for gap in all_of_one]
    print(f"means of {len(tables)} seeds: {sum(g <= 1.5 for g in off)} of {len(off)} within 1.5 deg, "
          f"{sum(g <= 2.5 for g in off)} within 2.5")


def beside_a_guess(out):
    """The guess: s = 1/(1+alpha), 0.2 more if loose, and m = n = s/2."""
    of_contact = {"cone": 1 / 2, "sphere": 1 / 3, "flat": 0}
    for density, more in (("dense", 0), ("loose", 0.2)):
        off, guessed = [], []
        for row in rows_of(out / "table5.csv"):
            if row["density"] == density and row["paper"]:
                s = of_contact[row["contact"]] + more
                printed = float(row["paper"])
                off.append(float(row["granum"]) - printed)
                guessed.append((s if row["quantity"].startswith("s") else s / 2) - printed)
        rms = [math.sqrt(statistics.fmean(x * x for x in of)) for of in (off, guessed)]
        print(f"{density}: {len(off)} exponents, rms {rms[0]:.3f}; guess {rms[1]:.3f}")


def in_one_window(out):
    """Table 2 at 10 kPa, two diameters inside the walls or in the whole box."""
    first = {}
    for row in rows_of(out / "states.csv"):
        first.setdefault((row["contact"], row["density"]), row)
    for window, names in (("inside", ("C_n", "e_interior")), ("whole box", ("C_n_all_grains", "e"))):
        met = {"C_n": 0, "e": 0}
        for row in rows_of(out / "table2.csv"):
            state, name = first[row["contact"], row["density"]], names[row["quantity"] == "e"]
            met[row["quantity"]] += abs(float(state[name]) - float(row["paper"])) <= float(row["reach"])
        print(f"{window}: C_n {met['C_n']} of 6, e {met['e']} of 6")


def main():
    if len(sys.argv) == 3 and sys.argv[1] == "windows":
        in_one_window(pathlib.Path(sys.argv[2]))
        return
    if len(sys.argv) == 3 and sys.argv[1] == "guess":
        beside_a_guess(pathlib.Path(sys.argv[2]))
        return
    if len(sys.argv) > 3 and sys.argv[1] == "seeds":
        angles_by_seed(pathlib.Path(sys.argv[2]), [pathlib.Path(name) for name in sys.argv[3:]])
        return
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    folder, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    for name in TABLES:
        shutil.copyfile(folder / name, out / name)
    for name in PICTURES:
        shutil.copyfile(folder / "figures" / f"{name}.svg", out / f"{name}.svg")
    curves, states = rows_of(folder / "curves.csv"), rows_of(folder / "states.csv")
    write(out / "curves.csv", curves[0].keys(), ([short(x) for x in row.values()] for row in curves[::5]))
    kept = [name for name in states[0] if not name.startswith(("network_C", "affine_C"))]
    write(out / "states.csv", kept, ([short(row[name]) for name in kept] for row in states))
    angles = list(angles_by_strain(curves, rows_of(folder / "table4.csv")))
    write(out / "angles_by_strain.csv",
          ["contact", "density", "path", "largest_axial_strain", "angle_deg", "paper_deg", "difference_deg"], angles)
    for end in ENDS:
        gaps = [abs(float(row[-1])) for row in angles if row[3] == end]
        print(f"to {100 * end:g} % of axial strain: {sum(g <= 1.5 for g in gaps)} of {len(gaps)} within 1.5 deg, "
              f"{sum(g <= 2.5 for g in gaps)} within 2.5, worst {max(gaps):.2f}")


if __name__ == "__main__":
    main()
