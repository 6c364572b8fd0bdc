#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Medians of the rounds that bench/run.sh has made, as CSV and as a table with its targets.

    table.py ROUNDS RESULTS     ROUNDS holds granum-N.json and numpy-N.json, RESULTS gets closed_forms.csv and .md

Ratios are taken in each round, where both sides ran one after the other, and their median is shown.
Exit codes: 0 done, 1 the two sides disagree by more than 1e-14, 2 usage.
"""
import csv
import json
import pathlib
import statistics
import sys

# Vector instructions of the loop over rows of the sphere rule (src/effective/batch.cpp): 5 + 3 + 10 + 8 products,
# sums and fused ones of the argument, the guess, the step and the root with both moduli; and the range checks.
SPHERE_ARITHMETIC, SPHERE_CHECKS = 26, 6

STREAMS = ("limit: stream through caches", "limit: stream past caches", "limit: stream of whole lines")


class Rounds:
    """Times a point in ns: granum[name/points][round], likewise numpy."""

    def __init__(self, folder):
        self.granum, self.numpy, self.context, self.moduli = {}, {}, {}, {}
        for path in sorted(folder.glob("granum-*.json")):
            data = json.loads(path.read_text(encoding="utf-8"))
            self.context = data["context"]
            for case in data["benchmarks"]:
                self.granum.setdefault(case["name"], []).append(case["cpu_time"] / case["points"])
        for path in sorted(folder.glob("numpy-*.json")):
            data = json.loads(path.read_text(encoding="utf-8"))
            self.moduli = data["moduli"]
            for case in data["cases"]:
                name = f"{case['name']}/{case['points']}"
                self.numpy.setdefault(name, []).append(case["cpu_time"] / case["points"])
        self.count = len(next(iter(self.granum.values())))

    def largest_difference(self):
        worst = 0.0
        for row, numbers in self.moduli.items():
            ours = [float(x) for x in self.context[f"moduli of row {row}"].split()]
            worst = max([worst] + [abs(a / b - 1) for a, b in zip(ours, numbers)])
        return worst


def ratios(above, below):
    return [a / b for a, b in zip(above, below)]


def comparisons(rounds):
    """(what, ratio in each round, how to show it, target or None, is it met)."""
    granum, numpy = rounds.granum, rounds.numpy
    out = []

    def add(what, values, shown, target=None, most=False):
        value = statistics.median(values)
        verdict = "" if target is None else "yes" if (value <= target if most else value >= target) else "NO"
        goal = "" if target is None else ("≤ " if most else "≥ ") + shown.format(target)
        out.append((what, shown.format(value), shown.format(min(values)), shown.format(max(values)), goal, verdict))

    rung0 = "hertz_mindlin, rung 0/1" if "hertz_mindlin, rung 0/1" in granum else "K and G, rung 0/1"
    add(f"Python scalar call / `{rung0[:-2]}`", ratios(numpy["two roots/1"], granum[rung0]), "{:.1f} x", 30)
    add("numpy scalar call / the same", ratios(numpy["two roots, numpy scalars/1"], granum[rung0]), "{:.1f} x", 30)
    for points, label in (1000, "1e3"), (1000000, "1e6"):
        for suffix in "", ", p varies":
            batch = granum[f"batch of spheres{suffix}/{points}"]
            for rule, target in ("two roots", 10), ("one root", None):
                add(f"numpy ({rule}) / batch of spheres, {label} points{suffix}",
                    ratios(numpy[f"{rule}{suffix}/{points}"], batch), "{:.1f} x", target)
    spheres = granum["batch of spheres/1000000"]
    stream = [min(times) for times in zip(*(granum[f"{s}/1000000"] for s in STREAMS if f"{s}/1000000" in granum))]
    add("share of the memory limit, spheres, 1e6", ratios(stream, spheres), "{:.0%}", 0.6)
    lanes = int(rounds.context["vector lanes"])
    instruction = next(times for name, times in granum.items() if name.startswith("limit: multiply-add/"))
    for count, what in (SPHERE_ARITHMETIC + SPHERE_CHECKS, "with range checks"), (SPHERE_ARITHMETIC, "without"):
        least = [count * t / lanes for t in instruction]
        target = 0.6 if what == "with range checks" else None
        add(f"share of the arithmetic limit {what}, spheres, 1e3", ratios(least, granum["batch of spheres/1000"]),
            "{:.0%}", target)
    for given in "contacts", "a state":
        add(f"6x6 with fabric in closed form from {given}", granum[f"6x6 with fabric from {given}, rung 1/1"],
            "{:.0f} ns", 50, most=True)
    add("rung 2", granum["uniform strain by direction, rung 2/1"], "{:.0f} ns", 1000, most=True)
    add("rung 3 with standard error", granum["relaxed with standard error, rung 3/1"], "{:.0f} ns", 3000, most=True)
    return out


def write_csv(rounds, path):
    with path.open("w", newline="", encoding="utf-8") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(["side", "case", "points", "rounds", "median_ns_per_point", "min_ns_per_point"])
        for side, cases in ("granum", rounds.granum), ("numpy", rounds.numpy):
            for name, times in cases.items():
                case, points = name.rsplit("/", 1)
                table.writerow([side, case, points, len(times), f"{statistics.median(times):.4g}", f"{min(times):.4g}"])


def markdown(rounds, difference):
    lines = [f"Medians of {rounds.count} rounds; vectors of {rounds.context['vector lanes']} doubles. "
             f"granum and numpy differ by at most {difference:.1e}.", "",
             "| comparison | median | least | most | target | met |", "| --- | --- | --- | --- | --- | --- |"]
    lines += ["| " + " | ".join(row) + " |" for row in comparisons(rounds)]
    lines += ["", "| case | points | ns a point |", "| --- | --- | --- |"]
    for side, cases in ("", rounds.granum), ("numpy: ", rounds.numpy):
        for name, times in cases.items():
            case, points = name.rsplit("/", 1)
            lines.append(f"| {side}{case} | {points} | {statistics.median(times):.3g} |")
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    rounds, results = Rounds(pathlib.Path(sys.argv[1])), pathlib.Path(sys.argv[2])
    results.mkdir(parents=True, exist_ok=True)
    difference = rounds.largest_difference()
    write_csv(rounds, results / "closed_forms.csv")
    text = markdown(rounds, difference)
    (results / "closed_forms.md").write_text(text, encoding="utf-8")
    print(text, end="")
    if not difference <= 1e-14:
        print(f"granum and numpy differ by {difference:.1e}, more than 1e-14", file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()
