# SPDX-License-Identifier: GPL-3.0-or-later
"""A packing of a DEM code: is it at rest, what is its contact law, and how accurate are the closed forms (formulas)?

The reference is the contact network: all contacts as springs, every grain in equilibrium. G_vh is the shear
modulus of a vertical plane, G_g that of the grains. Rungs 0 to 3 are closed forms that assume less and less.

PYTHONPATH=build/python python3 examples/python/judge_a_packing.py
"""

import pathlib

import granum
import numpy as np

data = pathlib.Path(__file__).parents[1] / "data"
packing = granum.read(data / "lammps_loose_p50.*.gz")

# The arrays of a packing are numpy arrays: the mean force of contacts above and below 45 degrees.
contacts = packing.contacts
cosine = np.abs(contacts.branch[:, 2]) / np.linalg.norm(contacts.branch, axis=1)
steep = cosine > np.cos(np.pi / 4)
ratio = contacts.normal_force[steep].mean() / contacts.normal_force[~steep].mean()
print(f"steep contacts carry {ratio:.3f} times the mean force of flat ones")

found = granum.measure(packing)  # the law is not given: it is inferred from forces and overlaps
assert found.law is not None and found.law_check is not None and found.forces is not None
assert found.network is not None
print(f"force ~ overlap^{found.law_check.force_exponent:.4f}, G_g = {found.law.shear_modulus / 1e9:.2f} GPa")
print(f"unbalanced force: {found.forces.unbalanced_force_ratio:.0e} of the mean contact force")
for name, rung in found.rungs.items():
    print(f"{name:15} G_vh is {rung.G_vh / found.network.G_vh:.2f} of the network's")
