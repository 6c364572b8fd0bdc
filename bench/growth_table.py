# SPDX-License-Identifier: GPL-3.0-or-later
"""Medians of bench/growth.sh: growth_table.py ROUNDS.csv OUT.md"""
import csv
import math
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
        if what == "network" and threads == 1 and density in ("dense", "loose"):
            two = of.get((what, density, size, 2))
            seconds = f"{two['wall']:.3g}" if two else "–"
            yield (f"| {density} | {size} | {one['C_n']:.2f} | {one['wall']:.3g} | {one['cpu']:.3g} | {seconds} | "
                   f"{one['count']:.0f} | {one['bytes_a_grain']:.0f} | {one['runs']} |")


def analyse_table(of):
    yield "| packing | grains | s, 1 thread | s, 2 threads | runs |"
    yield "| --- | --- | --- | --- | --- |"
    for (what, density, size, threads), two in of.items():
        if what == "analyse" and threads == 2:
            one = of.get((what, density, size, 1))
            seconds = f"{one['wall']:.3g}" if one else "–"
            yield f"| {density} | {size} | {seconds} | {two['wall']:.3g} | {two['runs']} |"


def iterations_table(of):
    packings = sorted({kind[1] for kind in of if kind[0] == "network" and kind[1].startswith("loose ")},
                      key=lambda name: int(name.split()[1]))
    yield "| grains | " + " | ".join(name.replace("loose", "seed") for name in packings) + " | median | over the one above |"
    yield "| --- |" + " --- |" * (len(packings) + 2)
    above = None
    for size in sorted({kind[2] for kind in of if kind[1] in packings}):
        counts = [of["network", name, size, 2]["count"] for name in packings]
        median = statistics.median(counts)
        growth = f"{median / above:.2f}" if above else "–"
        yield f"| {size} | " + " | ".join(f"{count:.0f}" for count in counts) + f" | {median:.0f} | {growth} |"
        above = median


def exponent(points):
    """The slope of the straight line through (ln x, ln y) by least squares."""
    x, y = [math.log(p[0]) for p in points], [math.log(p[1]) for p in points]
    middle_x, middle_y = statistics.mean(x), statistics.mean(y)
    return (sum((a - middle_x) * (b - middle_y) for a, b in zip(x, y)) / sum((a - middle_x) ** 2 for a in x))


def exponents_table(of):
    def points(what, density, threads, value):
        return [(kind[2], value(kind[2], run)) for kind, run in of.items()
                if kind[0] == what and kind[1] == density and kind[3] == threads]

    yield "| what | sizes | exponent |"
    yield "| --- | --- | --- |"
    for name, found in [
            ("a step of the engine, 1 thread", points("engine", "dense", 1, lambda size, run: size * run["wall"])),
            ("6x6 dense, 1 thread", points("network", "dense", 1, lambda _, run: run["wall"])),
            ("6x6 loose, 1 thread", points("network", "loose", 1, lambda _, run: run["wall"])),
            ("memory of the 6x6, loose", points("network", "loose", 1, lambda size, run: size * run["bytes_a_grain"])),
            ("its iterations, dense", points("network", "dense", 1, lambda _, run: run["count"])),
            ("its iterations, loose, median of the packings",
             [(size, statistics.median(run["count"] for kind, run in of.items()
                                       if kind[1].startswith("loose ") and kind[2] == size))
              for size in sorted({kind[2] for kind in of if kind[1].startswith("loose ")})]),
            ("analyse from file to 6x6, dense, 2 threads", points("analyse", "dense", 2, lambda _, run: run["wall"])),
            ("analyse from file to 6x6, loose, 2 threads", points("analyse", "loose", 2, lambda _, run: run["wall"])),
            ("a dense specimen, 1 thread", points("specimen", "dense", 1, lambda _, run: run["wall"]))]:
        if len(found) > 1:
            yield f"| {name} | {min(found)[0]} to {max(found)[0]} | {exponent(found):.2f} |"


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
            "Its iterations for loose packings of several seeds, in the same way:", "", *iterations_table(of), "",
            "`granum analyse` of such grains as a LAMMPS data file, by the clock, from file to 6x6 (exact copies, without the random factor):",
            "", *analyse_table(of), "",
            "A dense specimen, from nothing to rest at 10 kPa, one core, another seed in each run:", "",
            *specimen_table(of), "",
            "Exponents of growth with the number of grains, by least squares over all sizes:", "", *exponents_table(of), ""]
    with open(out, "w", encoding="utf-8") as file:
        file.write("\n".join(text))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
