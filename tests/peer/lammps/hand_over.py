# SPDX-License-Identifier: GPL-3.0-or-later
"""A packing in LAMMPS' memory, handed over to granum: the same as by its dumps, to the last digit.

    PYTHONPATH=<folder of the package granum> python3 hand_over.py <folder for the dumps>

LAMMPS' module of Debian loads liblammps.so, which is there with liblammps-dev, or by a link to liblammps.so.0 in
a folder of LD_LIBRARY_PATH.

125 soft spheres in a periodic box that shrinks around them, and then come to rest.
"""

import os
import sys

import granum
import lammps
import numpy as np

os.chdir(sys.argv[1])
lmp = lammps.lammps(cmdargs=["-log", "none"])
lmp.commands_string("""
units si
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
lattice sc 1.1e-3
region box block 0 5 0 5 0 5
create_box 1 box
create_atoms 1 box
set type 1 diameter 1e-3
set type 1 density 2650
displace_atoms all random 4e-5 4e-5 4e-5 1
pair_style granular
pair_coeff * * hertz/material 7e7 0.5 0.3 tangential mindlin 8e7 1.0 0.5 damping tsuji
timestep 1e-6
fix motion all nve/sphere
fix drag all viscous 2e-5
fix shrink all deform 1 x scale 0.87 y scale 0.88 z scale 0.89 xy final 0.0002 remap x
compute ids all property/local patom1 patom2 cutoff radius
compute forces all pair/local dist force fx fy fz p1 p2 p3 p4 p5 p6 p7 p8 p9 p10 p11 p12 cutoff radius
compute some all pair/local dist force p1 p2 p3 p4 cutoff radius
compute dist all pair/local dist cutoff radius
""".replace("region box block 0 5 0 5 0 5", "region box prism 0 5 0 5 0 5 0 0 0"))
lmp.command("run 6000")
lmp.command("unfix shrink")
lmp.command("run 6000")
COMPUTES = {"all": ("ids", "forces"), "some": ("ids", "some"), "dist": ("ids", "dist")}
lmp.command("dump atoms all custom 1 atoms.dump id type radius x y z")
for name, (ids, values) in COMPUTES.items():
    column = f"c_{values}" if name == "dist" else f"c_{values}[*]"
    lmp.command(f"dump {name} all local 1 {name}.dump c_{ids}[*] {column}")
for name in ("atoms", *COMPUTES):
    lmp.command(f"dump_modify {name} format float %.17g")
lmp.command("run 0")
for name in ("atoms", *COMPUTES):
    lmp.command(f"undump {name}")



def compare(in_memory, of_files):
    assert len(in_memory.contacts) == len(of_files.contacts) > 200
    assert in_memory.step == of_files.step == 12000
    assert in_memory.periodic == of_files.periodic
    for name in ("position", "radius", "id", "type"):
        np.testing.assert_array_equal(getattr(in_memory, name), getattr(of_files, name), name)
    # The edges of a tilted box are a difference of bounds that the file holds, so that the last digit may differ.
    np.testing.assert_allclose(in_memory.cell, of_files.cell, rtol=1e-14, atol=0)
    for name in ("i", "j", "branch", "overlap", "normal_force", "tangential_force"):
        np.testing.assert_array_equal(
            getattr(in_memory.contacts, name), getattr(of_files.contacts, name), name
        )
    told = [{note for note in packing.notes if "by their values" in note} for packing in (in_memory, of_files)]
    assert told[0] == told[1]


compare(granum.from_lammps(lmp, contacts=("ids", "forces")), granum.read("atoms.dump", "all.dump"))
compare(granum.from_lammps(lmp, contacts=("ids", "some")), granum.read("atoms.dump", "some.dump"))
named = {"id1": "c_ids[1]", "id2": "c_ids[2]", "force": "c_some[2]"}
compare(
    granum.from_lammps(lmp, contacts=("ids", "some"), columns=named),
    granum.read("atoms.dump", "some.dump", columns=named),
)
# A compute of one value is a vector. Without directions the lines of centres are the nearest images.
apart = granum.from_lammps(lmp, contacts=("ids", "dist"))
assert len(apart.contacts) == len(granum.read("atoms.dump", "dist.dump").contacts)
for contacts, said in (("motion", "no compute 'motion'"), ("thermo_press", "no local values")):
    try:
        granum.from_lammps(lmp, contacts=contacts)
    except granum.InvalidArgument as error:
        assert said in str(error), error
    else:
        raise AssertionError(said)

# What the contacts bear is what LAMMPS says: at rest, without the viscous parts.
lmp.command("compute stress all pressure NULL virial")
lmp.command("run 0")
of_lammps = lmp.numpy.extract_compute("stress", 0, 1)
packing = granum.from_lammps(lmp, contacts=("ids", "forces"))
found = granum.measure(packing, grain_shear_modulus=2.7e7, grain_poisson_ratio=0.3, network=False)
ours = found.stress.tensor
np.testing.assert_allclose([ours[k, k] for k in range(3)], of_lammps[:3], rtol=1e-10)
print("the packing in memory is that of the files")
