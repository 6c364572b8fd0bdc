# SPDX-License-Identifier: GPL-3.0-or-later
"""A small packing made by YADE, and what YADE says of it:

    yade -j1 -n -x make_packing.py packing <granum>/share/yade [options]
    granum analyse packing.grains packing.contacts --stress $(head -n 1 packing.own)

Periodic, spheres of quartz, Hertz and Mindlin, compressed to 1 MPa and left to come to rest; without options 120 equal
ones. packing.own holds YADE's own stress (xx, yy, zz, xy, xz, yz, compression positive) and mean number of contacts of a
grain.
"""

import argparse
import math
import random
import statistics
import sys

from yade import pack, utils

options = argparse.ArgumentParser()
options.add_argument("name")
options.add_argument("script")
options.add_argument("--grains", type=int, default=120)
options.add_argument("--pressure", type=float, default=1e6, help="[Pa]")
options.add_argument("--sizes", default="equal", help="equal, uniform:SMALLEST:LARGEST or lognormal:SIGMA, as granum has them")
options.add_argument("--friction", type=float, default=0.2, help="angle while the packing is compressed [rad]")
options.add_argument("--friction-at-rest", type=float, help="angle once the pressure is there, if another [rad]")
options.add_argument("--law", default="hertz", choices=["hertz", "linear", "cohesion", "rolling", "bonds"],
                     help="hertz; linear: springs, k_t/k_n = 0.919 as in hertz; cohesion: these, glued at rest; rolling: with springs "
                     "against rolling and twisting too; bonds: these, glued at rest")
options.add_argument("--clumps", nargs="?", const="pairs", choices=["pairs", "rods", "tetrahedra"],
                     help="rigid bodies of two, three (in a row) or four spheres, which overlap: neighbours are a radius apart")
options.add_argument("--walls", action="store_true", help="six smooth walls in place of periodic faces")
options.add_argument("--unload-to", type=float, help="pressure to which the glued grains are brought at last [Pa]")
options.add_argument("--probe", type=float, help="small strain by which YADE probes its stiffness: packing.probes")
options.add_argument("--rate", type=float, default=2, help="largest rate of strain [1/s]")
options.add_argument("--step", type=float, default=1, help="time step over that of YADE's PWaveTimeStep")
options.add_argument("--rest-at", type=float, default=1e-9, help="unbalanced force over the mean one")
options.add_argument("--seed", type=int, default=1)
asked = options.parse_args()
sys.path.insert(0, asked.script)
import granum_export

name, GRAINS, RADIUS, PRESSURE = asked.name, asked.grains, 0.5e-3, asked.pressure


def radii_over_their_mean(text, count):
    """One radius of each of `count` classes of equal number, in ascending order."""
    kind, *numbers = text.split(":")
    shares = [(k + 0.5) / count for k in range(count)]
    if kind == "equal":
        radii = [1.0 for _ in shares]
    elif kind == "uniform":
        low, high = map(float, numbers)
        radii = [low + (high - low) * share for share in shares]
    elif kind == "lognormal":
        # Cut as granum does: 1 % of the number below, 1 % of the mass above.
        sigma = float(numbers[0])
        normal = statistics.NormalDist()
        low, high = 0.01, normal.cdf(normal.inv_cdf(0.99) + 3 * sigma)
        radii = [math.exp(sigma * normal.inv_cdf(low + (high - low) * share)) for share in shares]
    else:
        raise SystemExit("unknown sizes " + text)
    mean = sum(radii) / count
    return [radius / mean for radius in radii]


def scattered(radii, edge, seed):
    """A place for each grain, the largest first, so that none touches another in a periodic cube."""
    draw = random.Random(seed)
    placed = []
    for radius in sorted(radii, reverse=True):
        while True:
            place = [edge * draw.random() for _ in range(3)]
            if all(apart(place, other, edge) > radius + its for other, its in placed):
                break
        placed.append((place, radius))
    return placed


def apart(a, b, edge):
    return math.sqrt(sum((x - y - edge * round((x - y) / edge)) ** 2 for x, y in zip(a, b)))


# Density sets the time scale alone: heavy grains take longer steps.
LAWS = {  # Young's modulus and Poisson's ratio as YADE's law wants them, and what makes contacts and forces
    "hertz": (69e9, 0.15, Ip2_FrictMat_FrictMat_MindlinPhys, Law2_ScGeom_MindlinPhys_Mindlin),
    "linear": (4e9, 0.919, Ip2_FrictMat_FrictMat_FrictPhys, Law2_ScGeom_FrictPhys_CundallStrack),
    "rolling": (4e9, 0.919, Ip2_CohFrictMat_CohFrictMat_CohFrictPhys, Law2_ScGeom6D_CohFrictPhys_CohesionMoment),
}
LAWS["bonds"] = LAWS["cohesion"] = LAWS["rolling"]
glued = asked.law in ("cohesion", "bonds")
turns = asked.law in ("rolling", "bonds")
young, poisson, make_contacts, make_forces = LAWS[asked.law]
common = dict(young=young, poisson=poisson, density=2.65e6, frictionAngle=asked.friction)
if glued or turns:  # no moment is too large, and glue never breaks
    quartz = CohFrictMat(**common, momentRotationLaw=turns, alphaKr=0.5, alphaKtw=0.3, etaRoll=-1, etaTwist=-1, isCohesive=True,
                         normalCohesion=1e30, shearCohesion=1e30)
else:
    quartz = FrictMat(**common)
contacts, forces = make_contacts(), make_forces()
if glued or turns:
    contacts.setCohesionOnNewContacts = False
    forces.always_use_moment_law = turns
O.materials.append(quartz)
O.periodic = not asked.walls
sizes = radii_over_their_mean(asked.sizes, GRAINS)
solid = 4.19 * RADIUS**3 * sum(x**3 for x in sizes)
edge = (solid / (0.3 if asked.sizes == "equal" else 0.2)) ** (1 / 3)
if O.periodic:
    O.cell.setBox(edge, edge, edge)
else:
    O.bodies.append(utils.aabbWalls([(0, 0, 0), (edge, edge, edge)], thickness=0, material=quartz))
if asked.clumps:
    centres = {  # in radii
        "pairs": [(0, 0, 0), (1, 0, 0)],
        "rods": [(0, 0, 0), (1, 0, 0), (2, 0, 0)],
        "tetrahedra": [(0, 0, 0), (1, 0, 0), (0.5, math.sqrt(3 / 4), 0), (0.5, math.sqrt(1 / 12), math.sqrt(2 / 3))],
    }[asked.clumps]
    body = pack.SpherePack([(tuple(RADIUS * x for x in centre), RADIUS) for centre in centres])
    spheres = pack.SpherePack()
    spheres.makeClumpCloud((0, 0, 0), (edge, edge, edge), [body], periodic=True, num=GRAINS // len(centres), seed=asked.seed)
    spheres.toSimulation(material=quartz)
elif asked.sizes == "equal":
    spheres = pack.SpherePack()
    spheres.makeCloud((0, 0, 0), (edge, edge, edge), rMean=RADIUS, periodic=O.periodic, num=GRAINS, seed=asked.seed)
    spheres.toSimulation(material=quartz)
else:  # makeCloud scales such sizes down where they do not fit in its order
    for place, radius in scattered([RADIUS * x for x in sizes], edge, asked.seed):
        O.bodies.append(utils.sphere(place, radius, material=quartz))

between_walls = TriaxialStressController(
    thickness=0, stressMask=7, internalCompaction=False, goal1=-PRESSURE, goal2=-PRESSURE, goal3=-PRESSURE, max_vel=asked.rate * edge / 2
)
servo = PeriTriaxController(
    goal=(-PRESSURE,) * 3,
    stressMask=7,
    dynCell=True,
    mass=1000 * solid * 2.65e3,
    maxUnbalanced=0.03,
    relStressTol=0.02,
    maxStrainRate=(asked.rate,) * 3,
    globUpdate=5,
    doneHook="O.pause()",
)
motion = NewtonIntegrator(damping=0.4)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Box_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom6D() if glued or turns else Ig2_Sphere_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom()],
        [contacts],
        [forces],
    ),
    servo if O.periodic else between_walls,
    motion,
]
O.dt = asked.step * utils.PWaveTimeStep()


def is_there(stress, within):
    return all(abs(stress[k] / servo.goal[k] - 1) < within for k in range(3))


def compress():
    servo.dead = False
    motion.damping = 0.4
    O.run(200000, True)  # or until the servo is done


def rest():
    """In a cell that stands still."""
    servo.dead = True
    O.cell.velGrad = Matrix3.Zero
    motion.damping = 0.7
    for _ in range(100):
        O.run(1000, True)
        if utils.unbalancedForce() < asked.rest_at:
            return


# Walls go on pressing while the grains come to rest.
if asked.walls:
    for _ in range(200):
        O.run(1000, True)
        if utils.unbalancedForce() < 1e-6 and abs(between_walls.meanStress / PRESSURE + 1) < 0.02:
            break

# Grains that are still moving together bear the pressure for a moment and give way at rest: again, at half the rate.
for _ in range(0 if asked.walls else 40):
    compress()
    if not is_there(servo.stress, servo.relStressTol):
        continue
    if asked.friction_at_rest is not None:
        utils.setContactFriction(asked.friction_at_rest)
    rest()
    print("step %d at rest: %s Pa" % (O.iter, list(utils.getStress().diagonal())), flush=True)
    if is_there(utils.getStress().diagonal(), 0.05):
        break
    servo.maxStrainRate = 0.5 * servo.maxStrainRate

if glued:
    contacts.setCohesionNow = True
    O.step()
if asked.unload_to is not None:
    servo.goal = (-asked.unload_to,) * 3
    compress()
    rest()
print("unbalanced force %.2g" % utils.unbalancedForce())

granum_export.write(name, O)
stress = utils.getStress()
with open(name + ".own", "w") as out:
    out.write(",".join("%.17gPa" % -stress[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (1, 0), (2, 0), (2, 1))) + "\n")
    out.write("%.17g\n" % utils.avgNumInteractions())


PROBES = {"C11": (0, 0), "C22": (1, 1), "C33": (2, 2), "C44": (1, 2), "C55": (0, 2), "C66": (0, 1)}


def strained(i, j, strain, steps=2000):
    """The stress at rest after a strain of the cell, of which ij is the only component [Pa]."""
    rate = Matrix3.Zero
    rate[i, j] = strain / (steps * O.dt)
    O.cell.velGrad = rate
    O.run(steps, True)
    rest()
    return utils.getStress()[i, j]


if asked.probe is not None:
    with open(name + ".probes", "w") as out:
        out.write("modulus,value_Pa\n")
        for component, (i, j) in PROBES.items():
            before = utils.getStress()[i, j]
            out.write("%s,%.17g\n" % (component, (strained(i, j, asked.probe) - before) / asked.probe))
            strained(i, j, -asked.probe)
