# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests share. GRANUM_PROGRAM names the program, GRANUM_SOURCE the source tree."""

import json
import os
import pathlib
import subprocess

import granum
import hypothesis
import pytest

hypothesis.settings.register_profile(
    "reproducible", derandomize=True, deadline=None, max_examples=60, database=None
)
hypothesis.settings.load_profile("reproducible")


@pytest.fixture(scope="session")
def source():
    return pathlib.Path(os.environ["GRANUM_SOURCE"])


@pytest.fixture(scope="session")
def dump(source):
    """Files of a loose packing of LAMMPS, 10,000 spheres."""
    return sorted((source / "examples" / "data").glob("lammps_loose_p50.*.gz"))


@pytest.fixture(scope="session")
def packing(dump):
    return granum.read(*dump)


@pytest.fixture(scope="session")
def sphere():
    return granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)


@pytest.fixture(scope="session")
def run_program():
    """Runs the program and returns its JSON object."""

    def run(*arguments):
        command = [os.environ["GRANUM_PROGRAM"], *map(str, arguments), "--json"]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    return run
