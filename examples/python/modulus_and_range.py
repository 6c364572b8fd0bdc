# SPDX-License-Identifier: GPL-3.0-or-later
"""The shear modulus of a packing of spheres over depth by rung 3, and its range if inputs are uncertain.

Rung 3 is the relaxed closed form (formula). G_vh is the shear modulus of a vertical plane, e the void ratio and C_n
the mean number of contacts per grain. Rattlers are grains that carry no load. The range is one standard deviation
to each side.

PYTHONPATH=build/python python3 examples/python/modulus_and_range.py
"""

import granum
import numpy as np

grain = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
void_ratio, contacts, rattlers = 0.6, 5.7, 0.02  # e, C_n, share of rattlers

depth = np.array([1.0, 3.0, 10.0])  # [m]
unit_weight = granum.bulk_density(grain_density=2650, void_ratio=void_ratio) * 9.81  # of the dry packing [N/m^3]
stress_v = unit_weight * depth

estimate = granum.relaxed(
    law=grain,
    radius=0.5e-3,
    void_ratio=void_ratio,
    coordination_number=contacts,
    rattler_fraction=rattlers,
    stress_v=stress_v,
    stress_h=0.5 * stress_v,  # earth pressure at rest
)
assert estimate.relative_error is not None
# Each modulus with the error of rung 3 alone.
for z, modulus, error in zip(depth, estimate.G_vh, estimate.relative_error.G_vh):
    print(f"{z:4.0f} m: G_vh = {modulus / 1e6:5.1f} MPa +- {100 * error:.1f} %")

# At the second depth, with the errors of the inputs as well.
uncertain = granum.packing_answer(
    law=grain,
    radius=0.5e-3,
    void_ratio=void_ratio,
    coordination_number=contacts,
    rattler_fraction=rattlers,
    stress_v=stress_v[1],
    stress_h=0.5 * stress_v[1],
    # standard deviations
    uncertainty={"void_ratio": 0.03, "coordination_number": 0.3, "rattler_fraction": 0.01},
)
G = uncertain.shear_modulus
print(f"with uncertain e, C_n and rattlers: {G.value / 1e6:.1f}, from {G.low / 1e6:.1f} to {G.high / 1e6:.1f} MPa")
