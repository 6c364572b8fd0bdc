#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Medians of the rounds that bench/peers/run.sh has made, as CSV and as a table.

    table.py rounds.csv RESULTS     RESULTS gets peers.csv and peers.md

Exit codes: 0 done, 1 the codes had different contacts or pressures (the files are written all the same), 2 usage.
"""
import csv
import os
import pathlib
import statistics
import sys

REFERENCE = ("LAMMPS", "granular", 1)  # of the ratios, in the same round
OTHER_LAW = "gran/hooke/history"  # linear springs: the same contacts at the start, its own way from there
LIMIT = 0.01  # of contacts and pressure
BUSY = 0.95  # share of its cores below which a run was disturbed


class Case:
    """One code, law and number of cores at one size, over all rounds."""

    def __init__(self, row):
        self.engine, self.style, self.version = row["engine"], row["style"], row["version"]
        self.cores, self.grains, self.steps = int(row["cores"]), int(row["grains"]), int(row["steps"])
        self.contacts, self.pressure = int(row["contacts"]), float(row["pressure_Pa"])
        self.contacts_after, self.pressure_after = int(row["contacts_after"]), float(row["pressure_after_Pa"])
        self.speed, self.shares, self.states = {}, [], set()

    def add(self, row):
        self.states.add((int(row["contacts"]), float(row["pressure_Pa"]),
                         int(row["contacts_after"]), float(row["pressure_after_Pa"])))
        self.speed[int(row["round"])] = self.grains * self.steps / float(row["seconds"])
        if row["cpu_share"]:
            self.shares.append(float(row["cpu_share"]))

    def name(self):
        return f"{self.engine} {self.style}, {self.cores} core{'s' if self.cores > 1 else ''}, {self.grains} grains"

    def median(self):
        return statistics.median(self.speed.values())

    def share(self):
        return statistics.median(self.shares) if self.shares else None


def read(path):
    cases = {}
    with path.open(newline="", encoding="utf-8") as rows:
        for row in csv.DictReader(rows):
            key = (row["grains"], row["engine"], row["style"], row["cores"])
            cases.setdefault(key, Case(row)).add(row)
    return list(cases.values())


def reference(cases, grains):
    """What ratios are taken to, or None."""
    return next((c for c in cases if (c.engine, c.style, c.cores, c.grains) == (*REFERENCE, grains)), None)


def ratio(case, other):
    """Of speeds, in each round, then the median; None without one of them."""
    return statistics.median(case.speed[r] / other.speed[r] for r in case.speed) if case and other else None


def comparisons(cases):
    """(what, ratio, the least that it should be or None), where both sides were run."""
    def fastest(engine, grains=10000, cores=1):
        """The law of Hertz and Mindlin that the code is fastest with, or None."""
        there = [c for c in cases if (c.engine, c.cores, c.grains) == (engine, cores, grains)]
        return max((c for c in there if c.style != OTHER_LAW), key=Case.median, default=None)

    ours = fastest("granum")
    rows = [("granum / LAMMPS `granular`, 10,000 grains, 1 core", ratio(ours, reference(cases, 10000)), 6),
            ("granum / the fastest Hertz law of LAMMPS", ratio(ours, fastest("LAMMPS")), 4),
            ("granum / LIGGGHTS", ratio(ours, fastest("LIGGGHTS")), None),
            ("granum / YADE", ratio(ours, fastest("YADE")), 30)]
    for grains, wanted in (10000, 1.7), (100000, 1.8):
        rows.append((f"granum on 2 cores / on 1, {grains:,} grains",
                     ratio(fastest("granum", grains, 2), fastest("granum", grains)), wanted))
    sizes = [c for c in cases if (c.engine, c.cores) == ("granum", 1)]
    if len(sizes) > 1:
        rows.append(("granum, slowest size / fastest, 1 core",
                     ratio(min(sizes, key=Case.median), max(sizes, key=Case.median)), 1 / 1.5))
    return [(what, value, wanted) for what, value, wanted in rows if value is not None]


def disagreements(cases):
    """What differs from granum's run of the same grains on one core, in any round."""
    found = []
    for case in cases:
        ours = next(c for c in cases if c.grains == case.grains and c.engine == "granum")
        for contacts, pressure, contacts_after, pressure_after in sorted(case.states):
            if contacts != ours.contacts:
                found.append(f"{case.name()}: {contacts} contacts at the start, granum has {ours.contacts}")
            checks = [("pressure at the start", pressure, ours.pressure)]
            if case.style != OTHER_LAW:
                checks += [("contacts after", contacts_after, ours.contacts_after),
                           ("pressure after", pressure_after, ours.pressure_after)]
            found += [f"{case.name()}: {what} {value:.6g}, granum has {wanted:.6g}"
                      for what, value, wanted in checks if not abs(value / wanted - 1) <= LIMIT]
    return found


def as_csv(cases):
    lines = [["engine", "style", "version", "cores", "grains", "contacts", "pressure_Pa", "contacts_after",
              "pressure_after_Pa", "steps", "rounds", "grain_steps_per_s", "min", "max",
              "ratio_to_lammps_granular_1_core", "cpu_share"]]
    for case in cases:
        of_reference, share = ratio(case, reference(cases, case.grains)), case.share()
        lines.append([case.engine, case.style, case.version, case.cores, case.grains, case.contacts, case.pressure,
                      case.contacts_after, case.pressure_after, case.steps, len(case.speed)]
                     + [f"{x:.4g}" for x in (case.median(), min(case.speed.values()), max(case.speed.values()))]
                     + ["" if x is None else f"{x:.3g}" for x in (of_reference, share)])
    return lines


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.partition(":")[2].strip()
    return "unknown processor"


def as_markdown(cases, found):
    versions = dict.fromkeys(f"{case.engine} {case.version}" for case in cases)
    lines = [f"Medians of {len(cases[0].speed)} rounds on {os.cpu_count()} cores, {processor()}.",
             f"{'; '.join(versions)}.",
             "Speeds in million grain-steps/s; ratio to LAMMPS `granular` on 1 core in the same round; contacts and "
             "pressure before and after the steps.", ""]
    disturbed = [case for case in cases if case.share() is not None and case.share() < BUSY]
    if disturbed:
        lines += [f"**The machine had other work:** {len(disturbed)} of {len(cases)} rows got less than {BUSY:.0%} of "
                  "their cores.", ""]
    lines += [f"**Not the same state:** {line}." for line in found] + ([""] if found else [])
    compared = comparisons(cases)
    if compared:
        lines += ["| comparison | ratio | target | met |", "| --- | --- | --- | --- |"]
        for what, value, wanted in compared:
            goal = ("", "") if wanted is None else (f"≥ {wanted:.2g}", "yes" if value >= wanted else "NO")
            lines.append(f"| {what} | {value:.2f} | {goal[0]} | {goal[1]} |")
        lines.append("")
    for grains in dict.fromkeys(case.grains for case in cases):
        lines += [f"{grains:,} grains", "",
                  "| code | law | cores | speed | least | most | ratio | cpu | steps | contacts | pressure, kPa |",
                  "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
        for case in (c for c in cases if c.grains == grains):
            speeds = [case.median(), min(case.speed.values()), max(case.speed.values())]
            of_reference, share = ratio(case, reference(cases, case.grains)), case.share()
            cells = [case.engine, case.style, case.cores] + [f"{x / 1e6:.3g}" for x in speeds]
            cells += ["" if of_reference is None else f"{of_reference:.2f}", "" if share is None else f"{share:.0%}",
                      case.steps, f"{case.contacts} → {case.contacts_after}",
                      f"{case.pressure / 1e3:.2f} → {case.pressure_after / 1e3:.2f}"]
            lines.append("| " + " | ".join(map(str, cells)) + " |")
        lines.append("")
    return "\n".join(lines)


def write(path, save):
    """Whole or not at all."""
    part = path.with_name(path.name + ".part")
    with part.open("w", newline="", encoding="utf-8") as out:
        save(out)
    part.replace(path)


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    cases, results = read(pathlib.Path(sys.argv[1])), pathlib.Path(sys.argv[2])
    found = disagreements(cases)
    text = as_markdown(cases, found)
    write(results / "peers.csv", lambda out: csv.writer(out, lineterminator="\n").writerows(as_csv(cases)))
    write(results / "peers.md", lambda out: out.write(text))
    print(text, end="")
    for line in found:
        print(f"table.py: {line}", file=sys.stderr)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
