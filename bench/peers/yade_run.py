# SPDX-License-Identifier: GPL-3.0-or-later
"""YADE's side of bench/peers/run.sh, Hertz and Mindlin with Coulomb friction:

    yade -jTHREADS -n -x yade_run.py SCENE DATA STEPS STRAIN

SCENE holds the numbers of the specimen, as lines name=value. Prints as bench_peer_engine does.
"""

import math
import sys
import time

from yade import utils

scene_path, data, steps, strain = sys.argv[1], sys.argv[2], int(sys.argv[3]), float(sys.argv[4])
with open(scene_path, encoding="utf-8") as file:
    scene = {name: float(value) for name, value in (line.split("=") for line in file)}

quartz = FrictMat(
    young=scene["young"],
    poisson=scene["poisson"],
    density=scene["density"],
    frictionAngle=math.atan(scene["friction"]),
)
O.materials.append(quartz)
O.periodic = True
O.cell.setBox(scene["edge_x"], scene["edge_y"], scene["edge_z"])
with open(data, encoding="utf-8") as file:
    rows = file.read().partition("Atoms")[2].splitlines()[2:]
for row in rows:
    x, y, z = map(float, row.split()[4:7])
    O.bodies.append(utils.sphere((x, y, z), scene["radius"], material=quartz))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=scene["skin"] / 2),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys()],
        [Law2_ScGeom_MindlinPhys_Mindlin()],
    ),
    NewtonIntegrator(damping=0.2),
]


def say_state():
    stress = utils.getStress()
    pressure = -(stress[0, 0] + stress[1, 1] + stress[2, 2]) / 3
    print("state %d %.10g" % (O.interactions.countReal(), pressure))


# A step that hardly moves anything (YADE aborts at one of length 0) finds the contacts; then biaxial strain
# at constant volume.
O.dt = 1e-6 * scene["time_step"]
O.step()
say_state()
O.dt = scene["time_step"]
rate = strain / (steps * O.dt)
O.cell.velGrad = Matrix3(rate, 0, 0, 0, -rate, 0, 0, 0, 0)
begin, cpu = time.perf_counter(), time.process_time()
O.run(steps, True)
seconds, cpu = time.perf_counter() - begin, time.process_time() - cpu
say_state()
print("took %.6g %.6g" % (seconds, cpu))
