# SPDX-License-Identifier: GPL-3.0-or-later
"""Medians of bench/solvers/run.sh: table.py ROWS.csv OUT.md"""
import csv
import statistics
import sys

TOLERANCE = 1e-10


def by_kind(rows):
    """The runs of each (grains, density, method, threads), one a round, in the order of the file."""
    kinds = {}
    for row in rows:
        kinds.setdefault((int(row["grains"]), row["density"], row["method"], int(row["threads"])), []).append(row)
    return kinds


def solved(runs):
    return all(run["residual"] and float(run["residual"]) <= TOLERANCE for run in runs)


def median(runs, value):
    return statistics.median(value(run) for run in runs)


def ratio(runs, of, value):
    """Of a value to that of granum, within each round."""
    return statistics.median(value(run) / value(other) for run, other in zip(runs, of))


def line(method, threads, runs, of):
    name = f"{method}, {threads} threads" if threads > 1 else method
    if not solved(runs):
        why = "stopped" if not runs[0]["residual"] else f"residual {float(runs[0]['residual']):.0e}"
        return f"| {name} | not solved ({why}) | | | | | | {len(runs)} |"

    def cpu(run):
        return float(run["cpu"])

    def memory(run):
        return float(run["bytes_a_grain"])

    def clock(run):
        return float(run["setup"]) + float(run["solution"])
    return (f"| {name} | {runs[0]['iterations']} | {median(runs, cpu):.3g} | {ratio(runs, of, cpu):.1f} | "
            f"{median(runs, clock):.3g} | {median(runs, memory) / 1000:.1f} | {ratio(runs, of, memory):.1f} | "
            f"{len(runs)} |")


def table(rows):
    kinds = by_kind(rows)
    for grains, density in sorted({kind[:2] for kind in kinds}):
        of = kinds[grains, density, "granum", 1]
        yield f"\n{grains:,} grains, {density}:\n"
        yield ("| method | iterations | CPU s | over granum | s by the clock | kB a grain | over granum | runs |\n"
               "| --- | --- | --- | --- | --- | --- | --- | --- |")
        for (size, kind, method, threads), runs in kinds.items():
            if (size, kind) == (grains, density):
                yield line(method, threads, runs, of)


def main(rows_file, out_file):
    with open(rows_file, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    with open(out_file, "w", encoding="utf-8") as out:
        out.write("# The network's solver beside those of libraries\n\nMade by `bench/solvers/run.sh`; what the rows "
                  "mean is in [bench/README.md](../README.md#other-solvers-for-the-network).\n")
        for text in table(rows):
            out.write(text + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
