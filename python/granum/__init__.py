# SPDX-License-Identifier: GPL-3.0-or-later
"""Stiffness of granular packings: closed forms, contact networks and a compact DEM verifier.

The library granum on numpy arrays. All numbers are in SI, compression is positive, axis 3 ("v") is the axis of
symmetry. See docs/python.md.
"""

from ._documentation import _attach as _attach_examples
from ._errors import Error, FileError, InvalidArgument, NotConverged, Stopped
from ._files import frames, read
from ._granum import *  # the functions and classes of python/src
from ._granum import __version__ as __version__
from ._lammps import from_lammps
from ._plots import _attach
from ._results import Record, _attach as _attach_results
from ._studies import verify
from ._yade import from_yade

_attach()
_attach_results()
_attach_examples(globals())

__all__ = [name for name in dir() if not name.startswith("_")] + ["__version__"]
