# SPDX-License-Identifier: GPL-3.0-or-later
"""Medians of bench/growth.sh: growth_table.py ROUNDS.csv OUT.md"""
import csv
import statistics
import sys


def medians(rows):
    """One dictionary of medians for each kind of run, in order of size."""
    kinds = {}
    for row in rows:
        kinds.setdefault((row["what"], row["density"], int(row["grains"]), int(row["threads"])), []).append(row)
    out = {}
    for kind, runs in sorted(kinds.items()):
        numbers = {name: statistics.median(float(run[name] or 0) for run in runs)
                   for name in ("wall", "cpu", "bytes_a_grain", "count", "C_n")}
        walls = [float(run["wall"]) for run in runs]
        out[kind] = {**numbers, "runs": len(runs), "least": min(walls), "most": max(walls)}
    return out


def engine_table(of):
    yield "| grains | ns a grain-step, 1 thread | over the best | 2 threads: speed over 1 | bytes a grain | runs |"
    yield "| --- | --- | --- | --- | --- | --- |"
    sizes = sorted(kind[2] for kind in of if kind[0] == "engine" and kind[3] == 1)
    best = min(of["engine", "dense", size, 1]["wall"] for size in sizes)
    for size in sizes:
        one, two = of["engine", "dense", size, 1], of.get(("engine", "dense", size, 2))
        speed = f"{one['wall'] / two['wall']:.2f}" if two else "–"
        yield (f"| {size} | {one['wall']:.1f} | {one['wall'] / best:.2f} | {speed} | {one['bytes_a_grain']:.0f} | "
               f"{one['runs']} |")


def network_table(of):
    yield ("| packing | grains | C_n of bearing grains | s, 1 thread | CPU s | s, 2 threads | iterations | bytes a grain | "
           "runs |")
    yield "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    for (what, density, size, threads), one in of.items():
        if what == "network" and threads == 1:
            two = of.get((what, density, size, 2))
            seconds = f"{two['wall']:.3g}" if two else "–"
            yield (f"| {density} | {size} | {one['C_n']:.2f} | {one['wall']:.3g} | {one['cpu']:.3g} | {seconds} | "
                   f"{one['count']:.0f} | {one['bytes_a_grain']:.0f} | {one['runs']} |")


def specimen_table(of):
    yield "| grains | s, median | least | most | steps of the minimiser | C_n | runs |"
    yield "| --- | --- | --- | --- | --- | --- | --- |"
    for (what, _, size, _), one in of.items():
        if what == "specimen":
            yield (f"| {size} | {one['wall']:.2f} | {one['least']:.2f} | {one['most']:.2f} | {one['count']:.0f} | "
                   f"{one['C_n']:.2f} | {one['runs']} |")


def main(rounds, out):
    with open(rounds, newline="", encoding="utf-8") as file:
        of = medians(csv.DictReader(file))
    text = ["Medians; written by `bench/growth.sh`. Spheres at 10 kPa, periodic; from 100,000 grains on copies of 10,000 side",
            "by side, in the network with a random factor between 1/2 and 3/2 on the stiffness of each contact.", "",
            "A step of the engine, Hertz-Mindlin with friction:", "", *engine_table(of), "",
            "The network's 6x6, residual 1e-10:", "", *network_table(of), "",
            "A dense specimen, from nothing to rest at 10 kPa, one core, another seed in each run:", "",
            *specimen_table(of), ""]
    with open(out, "w", encoding="utf-8") as file:
        file.write("\n".join(text))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
