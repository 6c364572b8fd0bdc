# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene of YADE in memory. The scene here has the members of YADE's that are read; tests/peer asks YADE itself."""

from types import SimpleNamespace

import granum
import numpy as np
import pytest


class Sphere(SimpleNamespace):
    pass


class Facet(SimpleNamespace):
    pass


class Clump(SimpleNamespace):
    pass


def body(number, shape, position=(0, 0, 0)):
    return SimpleNamespace(id=number, shape=shape, state=SimpleNamespace(pos=position), clumpId=-1)


def contact(first, second, normal, depth, normal_force, shear_force, real=True):
    return SimpleNamespace(
        id1=first,
        id2=second,
        isReal=real,
        geom=SimpleNamespace(normal=normal, penetrationDepth=depth),
        phys=SimpleNamespace(normalForce=normal_force, shearForce=shear_force, kn=2e5, ks=1e5),
    )


@pytest.fixture
def scene():
    """A floor (body 0), a body that is gone, and two spheres one above the other."""
    return SimpleNamespace(
        bodies=[
            body(0, Facet()),
            None,
            body(2, Sphere(radius=1.0), (0, 0, 0.99)),
            body(3, Sphere(radius=0.5), (0, 0, 2.48)),
        ],
        interactions=[
            contact(0, 2, (0, 0, 1), 0.01, (0, 0, 30), (1, 0, 0)),  # on the sphere, from the floor
            contact(2, 3, (0, 0, 1), 0.01, (0, 0, 10), (0, 2, 0)),
            contact(2, 3, (0, 0, 1), 0.0, (0, 0, 0), (0, 0, 0), real=False),
        ],
        periodic=False,
    )


def test_spheres_walls_and_forces(scene):
    packing = granum.from_yade(scene)
    np.testing.assert_array_equal(packing.radius, [1.0, 0.5])
    pairs, walls = packing.contacts, packing.wall_contacts
    assert (len(pairs), len(walls)) == (1, 1)
    assert (pairs.i[0], pairs.j[0]) == (0, 1)
    assert pairs.normal_force[0] == 10 and pairs.tangential_force[0].tolist() == [0, 2, 0]
    assert pairs.normal_stiffness[0] == 2e5 and pairs.tangential_stiffness[0] == 1e5
    np.testing.assert_allclose(pairs.branch[0], [0, 0, 1.49])
    # The floor is the first body of its contact: turned, so that all points from the grain to the wall.
    assert (walls.i[0], walls.j[0]) == (0, 0)
    np.testing.assert_allclose(walls.branch[0], [0, 0, -0.99])
    assert walls.normal_force[0] == 30 and walls.tangential_force[0].tolist() == [-1, 0, 0]


def test_moments_and_clumps(scene):
    assert granum.from_yade(scene).contacts.rolling_stiffness[0] == 0
    phys = scene.interactions[1].phys
    phys.momentRotationLaw, phys.kr, phys.ktw = True, 3.0, 4.0
    pairs = granum.from_yade(scene).contacts
    assert (pairs.rolling_stiffness[0], pairs.twisting_stiffness[0]) == (3, 4)
    scene.bodies.append(body(4, Sphere(radius=0.5), (5, 0, 0)))
    scene.bodies[2].clumpId = scene.bodies[3].clumpId = 7
    assert granum.from_yade(scene).body.tolist() == [0, 0, 1]  # the third by itself


def test_other_bodies_are_refused(scene):
    scene.bodies.append(body(4, Clump()))
    scene.interactions.append(contact(3, 4, (0, 0, 1), 0.01, (0, 0, 1), (0, 0, 0)))
    with pytest.raises(ValueError, match="3.*4"):
        granum.from_yade(scene)


def test_a_periodic_cell_is_taken_over(scene):
    edges = np.diag([4.0, 5.0, 6.0])
    del scene.interactions[0]  # with the floor
    scene.periodic, scene.cell = True, SimpleNamespace(hSize=edges)
    packing = granum.from_yade(scene)
    assert granum.measure(packing, law=granum.sphere(shear_modulus=1e9, poisson_ratio=0.2, radius=1.0)).volume == (
        pytest.approx(120)
    )
