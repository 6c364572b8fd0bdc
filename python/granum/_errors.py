# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions of granum."""

from __future__ import annotations

from typing import Optional


class Error(Exception):
    """Base class of all exceptions of granum."""


class InvalidArgument(Error, ValueError):
    """An impossible argument, such as a porosity of 38.

    Attributes
    ----------
    name : str or None
        Name of the argument, if a single number was refused.
    value : float or None
        The number, in SI.
    unit : str or None
        Its unit, "" for a pure number.
    range : str or None
        The allowed range, such as "(0, 1)".
    """

    name: Optional[str] = None
    value: Optional[float] = None
    unit: Optional[str] = None
    range: Optional[str] = None


class FileError(Error, OSError):
    """A file that cannot be read or written.

    Attributes
    ----------
    path : str or None
        Path of the file, as open() takes it; in the message, bytes that are no UTF-8 are written "\\xff".
    line : int or None
        Number of the line, from 1, if the error concerns a line.
    """

    path: Optional[str] = None
    line: Optional[int] = None


class NotConverged(Error, RuntimeError):
    """A calculation did not converge, so that its result does not exist."""


class Stopped(Error, RuntimeError):
    """A long calculation was stopped before it had a result."""
