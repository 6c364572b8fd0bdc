# SPDX-License-Identifier: GPL-3.0-or-later
"""Packings from files."""

from __future__ import annotations

import glob
import os

from ._errors import InvalidArgument
from ._granum import _frames


def _paths(files):
    """Paths as they are, and what patterns such as "dump.*.gz" match, in the order of their names.

    "~" is the home folder. A folder whose name has brackets is that folder, if there is one.
    """
    paths = []
    for file in files:
        name = os.path.expanduser(os.fspath(file))
        folder, pattern = os.path.split(name)
        matched = [] if os.path.exists(name) else sorted(glob.glob(name))
        if not matched and os.path.isdir(folder):
            matched = sorted(glob.glob(os.path.join(glob.escape(folder), pattern)))
        paths.extend(matched or [name])
    return paths


def frames(*files, box=None, columns=None, units=None):
    """An iterator over all states of a packing in some files.

    Parameters
    ----------
    *files : path_like
        Files of grains and, if available, of contacts, of one format, in any order. The kind of a file is
        recognised by its content. Patterns such as "dump.*.gz" are replaced by all matching files. States come
        in the order of the numbers in the names, those of an index file (.pvd, .vtu.series) in that of its times.
    box : (3,) array_like, optional
        Edges of the periodic box [m], for files that do not contain it (CSV, VTK); others must agree with it.
    columns : dict, optional
        Meaning of columns of dumps that cannot be recognised from their values: {"id1": "c_cl[1]"}; for any
        format {"body": "none"}, no rigid bodies, and {"shape": "none"}, spheres.
    units : str, optional
        "si": numbers without units are SI.

    Returns
    -------
    Frames
        An iterator of Packing. Where steps go back, as those of a restarted job do, the later run answers, and
        earlier frames from there on are left out with a UserWarning.

    Raises
    ------
    FileError
        For a file that cannot be read, with path and line.
    InvalidArgument
        For inconsistent files.

    Notes
    -----
    In C++: granum::io::PackingFiles of granum/io/packing_files.hpp.
    """
    return _frames(_paths(files), box, columns or {}, units)


def read(*files, box=None, columns=None, units=None):
    """The packing in some files.

    Parameters
    ----------
    *files : path_like
        Files of grains and, if available, of contacts, as for frames().
    box : (3,) array_like, optional
        Edges of the periodic box [m], for files that do not contain it (CSV, VTK); others must agree with it.
    columns : dict, optional
        Meaning of columns of dumps that cannot be recognised from their values: {"id1": "c_cl[1]"}; for any
        format {"body": "none"}, no rigid bodies, and {"shape": "none"}, spheres.
    units : str, optional
        "si": numbers without units are SI.

    Returns
    -------
    Packing

    Raises
    ------
    FileError
        For a file that cannot be read, with path and line.
    InvalidArgument
        For inconsistent files, or if they contain more than one state (use frames()) or none.

    Notes
    -----
    In C++: granum::io::PackingFiles of granum/io/packing_files.hpp.
    """
    states = frames(*files, box=box, columns=columns, units=units)
    packing = next(states, None)
    if packing is None:
        raise InvalidArgument("the files contain no state of a packing")
    if next(states, None) is not None:
        raise InvalidArgument("the files contain several states of a packing: iterate over them with frames()")
    return packing
