# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the packing in YADE's memory to two text files that granum reads, with 17 digits.

Inside YADE, at the end of a script or in its console:

    import sys
    sys.path.append("<granum>/share/yade")
    import granum_export
    granum_export.write("packing", O)     # packing.grains, packing.contacts

Reading them: granum::io::read_yade. YADE's own text exports print six digits, too few for overlaps.
Forces act on the second body of a pair, and normals point from the first body to the second. kn and ks are the tangent
stiffnesses at this state [N/m], kr and ktw the stiffnesses against rolling and twisting [N m], 0 if the law has none.
clumpId is -1 for single spheres. A contact of a sphere with a wall, a facet or a box lists the sphere first, and second
-1 minus the id of the other body. Contacts with other bodies are counted and not written.
"""

GRAIN_COLUMNS = "id material x y z r clumpId"
CONTACT_COLUMNS = (
    "id1 id2 cellDistX cellDistY cellDistZ cpx cpy cpz nx ny nz pd fnx fny fnz fsx fsy fsz kn ks kr ktw"
)


def _row(integers, numbers):
    return " ".join([str(int(i)) for i in integers] + ["%.17g" % x for x in numbers]) + "\n"


def _spheres(scene):
    return {b.id: b for b in scene.bodies if b is not None and b.shape.__class__.__name__ == "Sphere"}


WALLS = ("Wall", "Facet", "Box")


def _walls(scene):
    return {b.id for b in scene.bodies if b is not None and b.shape.__class__.__name__ in WALLS}


def _row_of(i, first, second, turn):
    """A contact, with all vectors multiplied by `turn` (1, or -1 to exchange the bodies)."""
    geom, phys = i.geom, i.phys
    numbers = list(geom.contactPoint) + [turn * x for x in geom.normal] + [geom.penetrationDepth]
    numbers += [turn * x for v in (phys.normalForce, phys.shearForce) for x in v] + [phys.kn, phys.ks]
    numbers += [getattr(phys, k) if getattr(phys, "momentRotationLaw", False) else 0 for k in ("kr", "ktw")]
    return _row([first, second] + [turn * int(k) for k in i.cellDist], numbers)


def write_grains(path, scene):
    """Writes spheres, cell, step and time of `scene` (YADE's O) to `path`."""
    with open(path, "w") as out:
        out.write("# granum: grains of a YADE scene, SI\n")
        out.write("# step %d\n# time %.17g\n" % (scene.iter, scene.time))
        if scene.periodic:
            edges = scene.cell.hSize
            out.write("# cell " + _row([], [edges[i, j] for i in range(3) for j in range(3)]))
        out.write("# " + GRAIN_COLUMNS + "\n")
        for number, body in sorted(_spheres(scene).items()):
            material = body.material.id if body.material is not None else -1
            out.write(_row([number, material], list(body.state.pos) + [body.shape.radius, body.clumpId]))


def write_contacts(path, scene):
    """Writes the real contacts of the spheres of `scene` (YADE's O), with each other and with walls, to `path`."""
    spheres, walls = _spheres(scene), _walls(scene)
    rows = []
    left_out = 0
    for i in scene.interactions:
        if not i.isReal:
            continue
        if i.id1 in spheres and i.id2 in spheres:
            rows.append(_row_of(i, i.id1, i.id2, 1))
        elif i.id1 in spheres and i.id2 in walls:
            rows.append(_row_of(i, i.id1, -1 - i.id2, 1))
        elif i.id1 in walls and i.id2 in spheres:
            rows.append(_row_of(i, i.id2, -1 - i.id1, -1))
        else:
            left_out += 1
    with open(path, "w") as out:
        out.write("# granum: contacts of a YADE scene, SI\n")
        out.write("# left_out %d\n" % left_out)
        out.write("# " + CONTACT_COLUMNS + "\n")
        out.writelines(rows)


def write(name, scene):
    """Writes <name>.grains and <name>.contacts of `scene` (YADE's O)."""
    write_grains(name + ".grains", scene)
    write_contacts(name + ".contacts", scene)
