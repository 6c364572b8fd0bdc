# SPDX-License-Identifier: GPL-3.0-or-later
"""use_wheel.py <version>: the installed package says what it is, and a law of Hertz has the stiffness of its formula."""

import importlib.metadata
import math
import sys

import granum
import numpy

about = importlib.metadata.metadata("granum")
assert granum.__version__ == about["Version"] == sys.argv[1]
assert about["Author"] and about["Summary"] and about["Description-Content-Type"] == "text/markdown"
assert about.get_payload().lstrip().startswith("# granum")
assert about["License"] == "GPL-3.0-or-later" and len(about.get_all("Classifier")) > 5
assert set(about.get_all("Provides-Extra")) == {"plot", "progress", "test"}
files = {path.name for path in importlib.metadata.files("granum")}
assert {"LICENSE", "py.typed", "__init__.pyi"} <= files, files
assert "site-packages" in granum.__file__ or "dist-packages" in granum.__file__, granum.__file__

# k_n = (6 R E*^2 f)^(1/3), with E* = G/(1 - nu) of equal grains and R half of the radius.
shear_modulus, poisson_ratio, radius, force = 30e9, 0.15, 0.5e-3, 1e-3
law = granum.sphere(shear_modulus=shear_modulus, poisson_ratio=poisson_ratio, radius=radius)
expected = (6 * (radius / 2) * (shear_modulus / (1 - poisson_ratio)) ** 2 * force) ** (1 / 3)
assert math.isclose(law.stiffness_at_force(force), expected, rel_tol=1e-12), (law.stiffness_at_force(force), expected)
answers = granum.uniform_strain(
    law=law, radius=radius, void_ratio=0.6, coordination_number=5.7, pressure=numpy.array([1e5, 8e5])
)
assert math.isclose(answers.G_vh[1] / answers.G_vh[0], 2.0, rel_tol=1e-9), answers.G_vh
