# SPDX-License-Identifier: GPL-3.0-or-later
"""A scene of YADE, transferred in memory."""

from __future__ import annotations

import numpy as np

from ._granum import packing

_WALLS = ("Wall", "Facet", "Box")


def _numbers(shape_names, scene):
    """Ids of the bodies of some shapes, in order."""
    return [b.id for b in scene.bodies if b is not None and b.shape.__class__.__name__ in shape_names]


def _contacts(scene, spheres, walls):
    """Pairs, branches, overlaps, forces and stiffnesses of the real contacts, from the first to the second."""
    index = {body: k for k, body in enumerate(spheres)}
    walls = set(walls)
    radius = {body: scene.bodies[body].shape.radius for body in spheres}
    pairs, rows = [], []
    for i in scene.interactions:
        if not i.isReal:
            continue
        first, second, turn = i.id1, i.id2, 1
        if first in walls:
            first, second, turn = second, first, -1
        if first not in index or not (second in index or second in walls):
            raise ValueError(
                f"bodies {i.id1} and {i.id2} are in contact, but are not spheres or walls: "
                "granum takes spheres, and Wall, Facet and Box as walls"
            )
        wall = second not in index
        pairs.append((index[first], -1 - second if wall else index[second]))
        length = radius[first] + (0 if wall else radius[second]) - i.geom.penetrationDepth
        normal = [turn * x for x in i.geom.normal]
        rows.append(
            [length * x for x in normal]
            + [i.geom.penetrationDepth, sum(f * turn * n for f, n in zip(i.phys.normalForce, normal))]
            + [turn * x for x in i.phys.shearForce]
            + [i.phys.kn, i.phys.ks]
            + [getattr(i.phys, k) if getattr(i.phys, "momentRotationLaw", False) else 0 for k in ("kr", "ktw")]
        )
    return np.array(pairs, dtype=int).reshape(-1, 2), np.array(rows, dtype=float).reshape(-1, 12)


def from_yade(scene):
    """The packing in the memory of YADE, for scripts and consoles inside YADE.

    Spheres are the grains, in the order of their ids, which they keep. Wall, Facet and Box are walls, numbered by their ids. Forces
    are those on the second body of a pair; kn and ks are the tangent stiffnesses at this state, kr and ktw those
    against rolling and twisting. Spheres of one clump move as one.

    Parameters
    ----------
    scene : Omega
        YADE's O.

    Returns
    -------
    Packing

    Raises
    ------
    ValueError
        For contacts of bodies that are neither spheres nor walls.
    InvalidArgument
        For impossible values, as packing().

    Notes
    -----
    In C++: granum::io::packing_of of granum/io/arrays/packing.hpp.
    """
    spheres = _numbers(("Sphere",), scene)
    pairs, rows = _contacts(scene, spheres, _numbers(_WALLS, scene))
    cell = None
    if scene.periodic:
        edges = scene.cell.hSize
        cell = [[edges[i, j] for j in range(3)] for i in range(3)]
    bodies = [scene.bodies[body] for body in spheres]
    return packing(
        position=np.array([list(b.state.pos) for b in bodies], dtype=float).reshape(-1, 3),
        radius=np.array([b.shape.radius for b in bodies], dtype=float),
        cell=cell,
        contacts=pairs,
        branch=rows[:, 0:3],
        overlap=rows[:, 3],
        normal_force=rows[:, 4],
        tangential_force=rows[:, 5:8],
        normal_stiffness=rows[:, 8],
        tangential_stiffness=rows[:, 9],
        rolling_stiffness=rows[:, 10],
        twisting_stiffness=rows[:, 11],
        body=[b.clumpId for b in bodies],
        id=spheres,
    )
