# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs share/yade/granum_export.py on a stand-in for YADE's scene:  yade_scene.py <folder of the script> <name>

The chain of three spheres of data/README.md, with a deleted body, a wall that touches a sphere, and an interaction that is not real.
"""

import sys
from types import SimpleNamespace as Record

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import granum_export


class Sphere(Record):
    pass


class Box(Record):
    pass


class Matrix3:
    def __init__(self, rows):
        self.rows = rows

    def __getitem__(self, index):
        return self.rows[index[0]][index[1]]


def body(number, position, shape, material=0):
    return Record(id=number, state=Record(pos=position), shape=shape, material=Record(id=material), clumpId=-1)


def interaction(first, second, point, normal, overlap, normal_force, shear_force, kn):
    return Record(
        isReal=True,
        id1=first,
        id2=second,
        cellDist=(0, 0, 0),
        geom=Record(contactPoint=point, normal=normal, penetrationDepth=overlap),
        phys=Record(normalForce=normal_force, shearForce=shear_force, kn=kn, ks=kn * 1.7 / 1.85),
    )


scene = Record(
    iter=20,
    time=1 / 3,
    periodic=True,
    cell=Record(hSize=Matrix3([[4e-3, 0, 0], [0, 4e-3, 0], [0, 0, 4e-3]])),
    bodies=[
        body(0, (1e-3, 2e-3, 2e-3), Sphere(radius=5e-4)),
        None,
        body(2, (1.9999e-3, 2e-3, 2e-3), Sphere(radius=5e-4)),
        body(3, (0, 0, 0), Box()),
        body(4, (1.9999e-3, 2e-3, 2.9998e-3), Sphere(radius=5e-4), material=3),
    ],
    interactions=[
        interaction(0, 2, (1.49995e-3, 2e-3, 2e-3), (1, 0, 0), 1e-7, (0.0235294118, 0, 0), (0, 0.01 / 3, 0), 352941.177),
        interaction(4, 2, (1.9999e-3, 2e-3, 2.4999e-3), (0, 0, -1), 2e-7, (0, 0, -0.0665512265), (0, 0, 0), 499134.19875),
        interaction(3, 0, (0.51e-3, 2e-3, 2e-3), (1, 0, 0), 1e-5, (0.25, 0, 0), (0, 0.125, 0), 1000),
        Record(isReal=False, id1=0, id2=4),
    ],
)
granum_export.write(sys.argv[2], scene)
