# SPDX-License-Identifier: GPL-3.0-or-later
"""Packings out of files."""

from __future__ import annotations

import glob
import os

from ._errors import InvalidArgument
from ._granum import _frames


def _paths(files):
    """Paths as they are, and what patterns such as "dump.*.gz" match, in the order of their names."""
    paths = []
    for file in files:
        name = os.fspath(file)
        matched = [] if os.path.exists(name) else sorted(glob.glob(name))
        paths.extend(matched or [name])
    return paths


def frames(*files, box=None, columns=None):
    """All states of a packing that some files hold, one after the other.

    Parameters
    ----------
    *files : path_like
        Of grains, and of contacts if there are any, of one format, in any order. What a file is, is told by what
        stands in it. Patterns such as "dump.*.gz" stand for all files that they match.
    box : (3,) array_like, optional
        Edges of the periodic box [m], for CSV files, which hold none.
    columns : dict, optional
        What columns of dumps hold, where their values do not tell it: {"id1": "c_cl[1]"}.

    Returns
    -------
    Frames
        An iterator of Packing.

    Raises
    ------
    FileError
        For a file that cannot be read, with path and line.
    InvalidArgument
        For files that do not go together.

    Notes
    -----
    In C++: granum::io::PackingFiles of granum/io/packing_files.hpp.
    """
    return _frames(_paths(files), box, columns or {})


def read(*files, box=None, columns=None):
    """The packing that some files hold.

    Parameters
    ----------
    *files : path_like
        Of grains, and of contacts if there are any, as of frames().
    box : (3,) array_like, optional
        Edges of the periodic box [m], for CSV files, which hold none.
    columns : dict, optional
        What columns of dumps hold, where their values do not tell it: {"id1": "c_cl[1]"}.

    Returns
    -------
    Packing

    Raises
    ------
    FileError
        For a file that cannot be read, with path and line.
    InvalidArgument
        For files that do not go together, or hold more than one state or none: frames() goes through them.

    Notes
    -----
    In C++: granum::io::PackingFiles of granum/io/packing_files.hpp.
    """
    states = frames(*files, box=box, columns=columns)
    packing = next(states, None)
    if packing is None:
        raise InvalidArgument("the files hold no state of a packing")
    if next(states, None) is not None:
        raise InvalidArgument("the files hold several states of a packing: frames() goes through them")
    return packing
