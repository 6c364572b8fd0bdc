# SPDX-License-Identifier: GPL-3.0-or-later
"""Is what a DEM code wrote at rest, which law did it use, and how far are closed forms from its network?

PYTHONPATH=build/python python3 examples/python/judge_a_packing.py
"""

import pathlib

import granum
import numpy as np

data = pathlib.Path(__file__).parents[1] / "data"
packing = granum.read(data / "lammps_loose_p50.*.gz")

# Any numpy on the views: the mean force of horizontal and of vertical contacts.
contacts = packing.contacts
cosine = np.abs(contacts.branch[:, 2]) / np.linalg.norm(contacts.branch, axis=1)
steep = cosine > np.cos(np.pi / 4)
ratio = contacts.normal_force[steep].mean() / contacts.normal_force[~steep].mean()
print(f"steep contacts bear {ratio:.3f} of what flat ones bear")

found = granum.measure(packing)  # nobody says the law: forces against overlaps do
assert found.law is not None and found.law_check is not None and found.forces is not None
assert found.network is not None
print(f"force ~ overlap^{found.law_check.force_exponent:.4f}, G_g = {found.law.shear_modulus / 1e9:.2f} GPa")
print(f"unbalanced force: {found.forces.unbalanced_force_ratio:.0e} of a contact force")
for name, rung in found.rungs.items():
    print(f"{name:15} G_vh is {rung.G_vh / found.network.G_vh:.2f} of the network's")
