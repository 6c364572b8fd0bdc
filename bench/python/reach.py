# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast the package is: calls with numbers, large arrays, a large packing, import. Medians of 7.

PYTHONPATH=build/python python3 bench/python/reach.py [path of bench_closed_forms]

With the path of the C++ benchmark its time for the batch of a million rows is measured beside.
"""

import concurrent.futures
import json
import statistics
import subprocess
import sys
import time
import timeit

import granum
import numpy as np

REPEATS = 7
LAW = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
STATE = {"law": LAW, "radius": 0.5e-3, "void_ratio": 0.6, "coordination_number": 5.7, "pressure": 100e3}


def seconds(call, number=1):
    """Median time of one call."""
    return statistics.median(timeit.repeat(call, number=number, repeat=REPEATS)) / number


def cpu_seconds(call, least=0.2):
    """Mean CPU time of one call, over calls of at least so many seconds."""
    call()
    calls, start = 0, time.process_time()
    while time.process_time() - start < least:
        call()
        calls += 1
    return (time.process_time() - start) / calls


def row(what, value, unit):
    print(f"{what:66} {value:10.3g} {unit}")


def calls():
    def rung_0():
        return granum.answer(
            rung=0, law=LAW, radius=0.5e-3, void_ratio=0.6, coordination_number=5.7, pressure=100e3
        ).G_vh

    def rung_1():
        return granum.answer(
            rung=1,
            law=LAW,
            radius=0.5e-3,
            void_ratio=0.6,
            coordination_number=5.7,
            pressure=100e3,
            fabric_anisotropy=0.1,
        ).stiffness

    def hertz_mindlin():
        return granum.hertz_mindlin(
            shear_modulus=30e9, poisson_ratio=0.15, porosity=0.375, coordination_number=5.7, pressure=100e3
        ).shear_modulus

    row("rung 0, G of one state", 1e6 * seconds(rung_0, 20000), "us")
    row("rung 1, 6x6 of one state", 1e6 * seconds(rung_1, 20000), "us")
    row("Hertz-Mindlin, G of one packing", 1e6 * seconds(hertz_mindlin, 20000), "us")


def columns(rows):
    generator = np.random.default_rng(1)
    return (
        generator.uniform(0.3, 0.5, rows),
        generator.uniform(4, 9, rows),
        generator.uniform(1e4, 1e6, rows),
    )


def numpy_moduli(porosity, contacts, pressure, shear_modulus=30e9, poisson_ratio=0.15):
    """Hertz-Mindlin as packages of rock physics write it, one numpy operation after the other."""
    bulk = (
        contacts**2
        * (1 - porosity) ** 2
        * shear_modulus**2
        * pressure
        / (18 * np.pi**2 * (1 - poisson_ratio) ** 2)
    ) ** (1 / 3)
    shear = (
        (5 - 4 * poisson_ratio)
        / (5 * (2 - poisson_ratio))
        * (
            3
            * contacts**2
            * (1 - porosity) ** 2
            * shear_modulus**2
            * pressure
            / (2 * np.pi**2 * (1 - poisson_ratio) ** 2)
        )
        ** (1 / 3)
    )
    return bulk, shear


def arrays(bench):
    rows = 1_000_000
    porosity, contacts, pressure = columns(rows)

    def batch():
        return granum.uniform_strain_moduli(
            law=LAW, radius=0.5e-3, porosity=porosity, coordination_number=contacts, pressure=pressure
        )

    out = np.empty(rows), np.empty(rows)

    def batch_into():
        return granum.uniform_strain_moduli(
            law=LAW, radius=0.5e-3, porosity=porosity, coordination_number=contacts, pressure=pressure, out=out
        )

    def formula():
        return numpy_moduli(porosity, contacts, pressure)

    np.testing.assert_allclose(batch().shear_modulus, formula()[1], rtol=1e-12)
    np.testing.assert_array_equal(batch().shear_modulus, batch_into().shear_modulus)
    times = {"new": [], "out": [], "numpy": [], "C++": []}
    for _ in range(REPEATS):  # in turn: a shared machine changes from one minute to the next
        times["new"].append(cpu_seconds(batch))
        times["out"].append(cpu_seconds(batch_into))
        times["numpy"].append(cpu_seconds(formula))
        if bench:
            times["C++"].append(1e-9 * rows * cpp_batch(bench))

    def ratio(of, to):
        return statistics.median(a / b for a, b in zip(times[of], times[to]))

    for name, what in (("new", "new arrays"), ("out", "out="), ("numpy", "numpy formulas"), ("C++", "C++ batch")):
        if times[name]:
            row(f"rung 0, a million rows, {what}", 1e9 * statistics.median(times[name]) / rows, "ns CPU a row")
    row("numpy formulas over new arrays", ratio("numpy", "new"), "times")
    row("numpy formulas over out=", ratio("numpy", "out"), "times")
    if bench:
        row("out= over the C++ batch, both into memory that is there", ratio("out", "C++"), "times")
        row("new arrays over the C++ batch", ratio("new", "C++"), "times")

    known = {"law": LAW, "radius": 0.5e-3, "rattler_fraction": 0.02}
    halves = [slice(0, rows // 2), slice(rows // 2, rows)]

    def relaxed(part):
        return granum.relaxed(
            **known, void_ratio=porosity[part], coordination_number=contacts[part], pressure=pressure[part]
        )

    row(
        "rung 3, a million states, one thread",
        1e6 * seconds(lambda: relaxed(slice(None))) / rows,
        "us a state",
    )
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        two = seconds(lambda: list(pool.map(relaxed, halves)))
    row("rung 3, a million states, two threads of Python", 1e6 * two / rows, "us a state")


def cpp_batch(bench):
    """CPU time of a row [ns]."""
    command = [bench, "--benchmark_filter=batch of spheres/1000000$", "--benchmark_format=json"]
    command += ["--benchmark_min_time=0.2"]
    said = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    found = said["benchmarks"][0]
    return found["cpu_time"] / 1e6 * {"ns": 1, "us": 1e3, "ms": 1e6}[found["time_unit"]]


def cubic_lattice(edge):
    """edge^3 spheres that touch their six neighbours: as many contacts as a dense packing has."""
    place = np.stack(np.meshgrid(*[np.arange(edge)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    index = np.arange(edge**3).reshape(edge, edge, edge)
    pairs = np.concatenate(
        [np.stack([index.ravel(), np.roll(index, -1, axis).ravel()], axis=1) for axis in range(3)]
    )
    grains = np.random.default_rng(1).normal(scale=1e-3, size=place.shape)
    return {
        "position": (place + 0.5 + grains) * 0.99e-3,
        "radius": 0.5e-3,
        "cell": np.full(3, edge * 0.99e-3),
        "contacts": pairs,
        "normal_force": np.full(len(pairs), 1.0),
    }


def packings():
    given = cubic_lattice(47)

    def convert():
        return granum.packing(**given)

    packing = convert()
    row("grains of the packing", len(packing), "")
    row("contacts of it", len(packing.contacts), "")
    conversion = seconds(convert)
    whole = statistics.median(timeit.repeat(lambda: granum.measure(packing, law=LAW), number=1, repeat=3))
    row("from numpy to a packing", conversion, "s")
    row("from the packing to both 6x6 and all else (median of 3)", whole, "s")
    row("conversion over the whole", 100 * conversion / (conversion + whole), "%")


def imports():
    def start(statement):
        began = time.perf_counter()
        subprocess.run([sys.executable, "-c", statement], check=True)
        return time.perf_counter() - began

    plain = statistics.median(start("import numpy") for _ in range(REPEATS))
    ours = statistics.median(start("import numpy, granum") for _ in range(REPEATS))
    row("import beyond numpy's", 1e3 * (ours - plain), "ms")


calls()
arrays(sys.argv[1] if len(sys.argv) > 1 else None)
packings()
imports()
