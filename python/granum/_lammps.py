# SPDX-License-Identifier: GPL-3.0-or-later
"""A packing of LAMMPS, transferred in memory."""

from __future__ import annotations

import numpy as np

from ._errors import InvalidArgument
from ._granum import _lammps_packing

# Constants of the library interface of LAMMPS: local values, vector, array, numbers of rows and columns.
_LOCAL, _VECTOR, _ARRAY, _ROWS, _COLUMNS = 2, 1, 2, 4, 5


def _of_atoms(lmp, name):
    """A property of all atoms in the memory of LAMMPS."""
    values = lmp.numpy.extract_atom(name)
    if values is None:
        raise InvalidArgument(f"the atoms of LAMMPS have no {name}: granum needs spheres, of atom_style sphere")
    # LAMMPS of November 2024 and later returns the ghosts too, in rows behind those of the grains.
    return values[: lmp.extract_setting("nlocal")]


def _locals_of(lmp, name):
    """Names and values of the columns of a compute, as in a dump local."""
    if not lmp.has_id("compute", name):
        raise InvalidArgument(f"LAMMPS has no compute '{name}'")
    try:
        rows = lmp.extract_compute(name, _LOCAL, _ROWS)
        columns = lmp.extract_compute(name, _LOCAL, _COLUMNS)
    except ValueError as error:  # a null pointer
        raise InvalidArgument(f"compute '{name}' has no local values: name one of style .../local") from error
    names = [f"c_{name}[{k + 1}]" for k in range(columns)] or [f"c_{name}"]
    if rows == 0:
        return names, np.empty((0, len(names)))
    if columns:
        return names, np.array(lmp.numpy.extract_compute(name, _LOCAL, _ARRAY))
    # lmp.numpy of 2021 requests the length of a local vector in a way that LAMMPS does not support.
    vector = np.ctypeslib.as_array(lmp.extract_compute(name, _LOCAL, _VECTOR), shape=(rows,))
    return names, np.array(vector).reshape(-1, 1)


def _contacts_of(lmp, computes):
    """Columns and rows of some computes, joined."""
    names, values = zip(*(_locals_of(lmp, compute) for compute in computes))
    rows = {compute: len(of_one) for compute, of_one in zip(computes, values)}
    if len(set(rows.values())) > 1:
        counts = ", ".join(f"{compute} {count}" for compute, count in rows.items())
        raise InvalidArgument(
            f"the computes have different numbers of rows: {counts}; give all of them the same cutoff, "
            "'cutoff radius', and run LAMMPS once more"
        )
    return sum(names, []), np.ascontiguousarray(np.hstack(values), dtype=float)


def from_lammps(lmp, *, contacts=(), columns=None):
    """The packing in the memory of LAMMPS, for scripts that run LAMMPS through its Python module.

    Equivalent to `dump custom` of the atoms and `dump local` of the computes at this step, without a file: the
    same columns, the same checks, identical numbers. Lengths and forces are converted to SI from units si, cgs,
    micro and nano; numbers in units lj are assumed to be SI, with a note. Forces include viscous parts if grains
    move. Contacts with walls are not transferred.

    Parameters
    ----------
    lmp : lammps.lammps
        On one process, with atoms that have a radius.
    contacts : str or sequence of str
        Ids of the computes with the contacts, such as ("ids", "forces") for

            compute ids all property/local patom1 patom2 cutoff radius
            compute forces all pair/local dist force fx fy fz p1 p2 p3 p4 cutoff radius

        LAMMPS evaluates them for its last step, so at least `run 0` is needed. Without computes, the contacts of
        overlapping spheres are used where needed.
    columns : dict, optional
        Meaning of columns that cannot be recognised from their values, as for read():
        {"id1": "c_ids[1]", "id2": "c_ids[2]", "force": "c_forces[2]"}.

    Returns
    -------
    Packing
        Grains sorted by id.

    Raises
    ------
    InvalidArgument
        For atoms without radius, several processes, other units; for missing computes, computes of different
        lengths, or columns of an unknown layout; and as packing().

    See Also
    --------
    read : The same from files.

    Notes
    -----
    In C++: granum::io::lammps_packing of granum/io/lammps/arrays.hpp.
    """
    processes = lmp.extract_setting("world_size")
    if processes > 1:
        raise InvalidArgument(
            f"LAMMPS runs on {processes} processes, each of which has only its own grains: run it on one, or "
            "read() its dumps"
        )
    low, high, xy, yz, xz, periodic, _ = lmp.extract_box()
    computes = (contacts,) if isinstance(contacts, str) else tuple(contacts)
    names, values = _contacts_of(lmp, computes) if computes else (None, np.empty((0, 0)))
    return _lammps_packing(
        id=_of_atoms(lmp, "id"),
        position=_of_atoms(lmp, "x"),
        radius=_of_atoms(lmp, "radius"),
        type=_of_atoms(lmp, "type"),
        cell=[[high[0] - low[0], xy, xz], [0, high[1] - low[1], yz], [0, 0, high[2] - low[2]]],
        periodic=[bool(flag) for flag in periodic],
        units=lmp.extract_global("units"),
        step=lmp.extract_global("ntimestep"),
        column_names=names,
        values=values,
        columns=columns or {},
    )
