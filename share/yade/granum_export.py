# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the packing in YADE's memory to two text files that granum reads, with 17 digits.

Inside YADE, at the end of a script or in its console:

    import sys
    sys.path.append("<granum>/share/yade")
    import granum_export
    granum_export.write("packing", O)     # packing.grains, packing.contacts

Reading them: granum::io::read_yade. YADE's own text exports print six digits, too few for overlaps.
Spheres only: contacts with walls, facets or boxes are counted, not written. Forces are those on the second sphere
of a pair, normals point from the first to the second, kn and ks are the tangents at this state.
"""

GRAIN_COLUMNS = "id x y z r"
CONTACT_COLUMNS = (
    "id1 id2 cellDistX cellDistY cellDistZ cpx cpy cpz nx ny nz pd fnx fny fnz fsx fsy fsz kn ks"
)


def _row(integers, numbers):
    return " ".join([str(int(i)) for i in integers] + ["%.17g" % x for x in numbers]) + "\n"


def _spheres(scene):
    return {b.id: b for b in scene.bodies if b is not None and b.shape.__class__.__name__ == "Sphere"}


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
            out.write(_row([number], list(body.state.pos) + [body.shape.radius]))


def write_contacts(path, scene):
    """Writes the real contacts between spheres of `scene` (YADE's O) to `path`."""
    spheres = _spheres(scene)
    real = [i for i in scene.interactions if i.isReal]
    pairs = [i for i in real if i.id1 in spheres and i.id2 in spheres]
    with open(path, "w") as out:
        out.write("# granum: contacts of a YADE scene, SI\n")
        out.write("# wall_contacts %d\n" % (len(real) - len(pairs)))
        out.write("# " + CONTACT_COLUMNS + "\n")
        for i in pairs:
            geom, phys = i.geom, i.phys
            vectors = [geom.contactPoint, geom.normal]
            forces = [phys.normalForce, phys.shearForce]
            numbers = [x for v in vectors for x in v] + [geom.penetrationDepth]
            numbers += [x for v in forces for x in v] + [phys.kn, phys.ks]
            out.write(_row([i.id1, i.id2] + list(i.cellDist), numbers))


def write(name, scene):
    """Writes <name>.grains and <name>.contacts of `scene` (YADE's O)."""
    write_grains(name + ".grains", scene)
    write_contacts(name + ".contacts", scene)
