# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions of granum."""

from __future__ import annotations

from typing import Optional


class Error(Exception):
    """Root of every exception that granum raises by itself."""


class InvalidArgument(Error, ValueError):
    """An argument that no packing can have, such as a porosity of 38.

    Attributes
    ----------
    name : str or None
        Of the argument, where one number was refused.
    value : float or None
        The number, in SI.
    unit : str or None
        Its unit, "" for a pure number.
    range : str or None
        What is allowed, such as "(0, 1)".
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
        Of the file.
    line : int or None
        Counted from 1, where one line is meant.
    """

    path: Optional[str] = None
    line: Optional[int] = None


class NotConverged(Error, RuntimeError):
    """The result of a calculation that did not converge was asked for."""


class Stopped(Error, RuntimeError):
    """Long work was asked to stop before it had a result."""
