#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz-Mindlin moduli in Python and numpy, timed: the baseline of bench/run.sh.

    numpy_baseline.py OUT.json      exit codes: 0 done, 2 usage, 3 numpy is missing

Writes {"cases": [{"name", "points", "cpu_time"}], "moduli": {row: [K, G]}}, CPU time in ns a call.
"""
import json
import math
import sys
import time

try:
    import numpy
except ImportError:
    numpy = None

SHEAR, POISSON = 30e9, 0.15


def two_roots(pressure, coordination, porosity):
    """As the textbooks print it, a root for each modulus."""
    square = coordination**2 * (1 - porosity) ** 2 * SHEAR**2 * pressure
    bulk = (square / (18 * math.pi**2 * (1 - POISSON) ** 2)) ** (1 / 3)
    shear = (5 - 4 * POISSON) / (5 * (2 - POISSON)) * (3 * square / (2 * math.pi**2 * (1 - POISSON) ** 2)) ** (1 / 3)
    return bulk, shear


def one_root(pressure, coordination, porosity):
    """The same with what both moduli share taken out, and numpy's own cube root."""
    factor = SHEAR / (math.sqrt(18) * math.pi * (1 - POISSON))
    bulk = numpy.cbrt((factor * coordination * (1 - porosity)) ** 2 * pressure)
    return bulk, 0.6 * (5 - 4 * POISSON) / (2 - POISSON) * bulk


def cpu_time(call, least=0.05):
    """ns of CPU a call, mean over at least `least` seconds."""
    calls = 1
    while True:
        start = time.thread_time_ns()
        for _ in range(calls):
            call()
        spent = time.thread_time_ns() - start
        if spent >= least * 1e9:
            return spent / calls
        calls *= 2


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    cases = []

    def add(name, points, call):
        cases.append({"name": name, "points": points, "cpu_time": cpu_time(call)})

    add("two roots", 1, lambda: two_roots(1e5, 6.0, 0.375))
    scalars = [numpy.float64(x) for x in (1e5, 6.0, 0.375)]
    add("two roots, numpy scalars", 1, lambda: two_roots(*scalars))
    for points in 1000, 1000000:
        x = numpy.arange(points) / points
        columns = 1e4 + 1e6 * x, 4 + 5 * x, 0.3 + 0.15 * x
        if points == 1000:
            moduli = [[float(m[row]) for m in two_roots(*columns)] for row in (0, 1, 500, 998, 999)]
        for rule, name in (two_roots, "two roots"), (one_root, "one root"):
            add(name, points, lambda: rule(*columns))
            add(name + ", p varies", points, lambda: rule(columns[0], 6.0, 0.375))
    with open(sys.argv[1], "w", encoding="utf-8") as out:
        rows = dict(zip(("0", "1", "500", "998", "999"), moduli))
        json.dump({"numpy": numpy.__version__, "cases": cases, "moduli": rows}, out, indent=1)


if __name__ == "__main__":
    if numpy is None:
        print("numpy_baseline.py: numpy is missing; scripts/setup.sh bench installs it", file=sys.stderr)
        sys.exit(3)
    main()
