# SPDX-License-Identifier: GPL-3.0-or-later
"""A small packing made by YADE, and what YADE says of it:

    yade -j1 -n -x make_packing.py packing <granum>/share/yade
    granum analyse packing.grains packing.contacts --stress $(head -n 1 packing.own)

Periodic, equal spheres of quartz, Hertz and Mindlin, compressed to 1 MPa and left to come to rest. packing.own holds
YADE's own stress (xx, yy, zz, xy, xz, yz, compression positive) and mean number of contacts of a grain.
"""

import sys

from yade import pack, utils

name, script = sys.argv[1], sys.argv[2]
sys.path.insert(0, script)
import granum_export

GRAINS, RADIUS, PRESSURE = 120, 0.5e-3, 1e6

# Density sets the time scale alone: heavy grains take longer steps.
quartz = FrictMat(young=69e9, poisson=0.15, density=2.65e6, frictionAngle=0.2)
O.materials.append(quartz)
O.periodic = True
edge = (GRAINS * 4.19 * RADIUS**3 / 0.3) ** (1 / 3)
O.cell.setBox(edge, edge, edge)
spheres = pack.SpherePack()
spheres.makeCloud((0, 0, 0), (edge, edge, edge), rMean=RADIUS, periodic=True, num=GRAINS, seed=1)
spheres.toSimulation(material=quartz)

servo = PeriTriaxController(
    goal=(-PRESSURE,) * 3,
    stressMask=7,
    dynCell=True,
    mass=1000 * GRAINS * 4.19 * RADIUS**3 * 2.65e3,
    maxUnbalanced=0.03,
    relStressTol=0.02,
    maxStrainRate=(2, 2, 2),
    globUpdate=5,
    doneHook="O.pause()",
)
motion = NewtonIntegrator(damping=0.4)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys()],
        [Law2_ScGeom_MindlinPhys_Mindlin()],
    ),
    servo,
    motion,
]
O.dt = utils.PWaveTimeStep()
O.run(200000, True)  # or until the servo is done

# To rest in a cell that stands still.
servo.dead = True
O.cell.velGrad = Matrix3.Zero
motion.damping = 0.7
for _ in range(100):
    O.run(1000, True)
    if utils.unbalancedForce() < 1e-9:
        break

granum_export.write(name, O)
stress = utils.getStress()
with open(name + ".own", "w") as out:
    out.write(",".join("%.17gPa" % -stress[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (1, 0), (2, 0), (2, 1))) + "\n")
    out.write("%.17g\n" % utils.avgNumInteractions())
