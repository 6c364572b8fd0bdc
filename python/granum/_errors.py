# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions of granum."""

from __future__ import annotations

import errno
import os
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
    """A file that cannot be read or written; where there is none, a FileNotFoundError as well.

    Attributes
    ----------
    errno : int or None
        Of the system, if it refuses the file: errno.ENOENT, errno.EISDIR or errno.EACCES.
    filename : str or None
        The same as path, as other errors of the system have it.
    path : str or None
        Path of the file, as open() takes it; in the message, bytes that are no UTF-8 are written "\\xff".
    line : int or None
        Number of the line, from 1, if the error concerns a line.
    """

    path: Optional[str] = None
    line: Optional[int] = None
    errno: Optional[int] = None  # type: ignore[assignment]
    filename: Optional[str] = None

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class _MissingFile(FileError, FileNotFoundError):
    """A FileError of a file that is not there."""


def _file_error(message: str, path: str, line: Optional[int] = None) -> FileError:
    """Asks the system why it refuses a file, if it does."""
    missing = not os.path.lexists(path)
    error = _MissingFile(message) if missing else FileError(message)
    error.path = error.filename = path
    error.line = line
    if missing:
        error.errno = errno.ENOENT
    elif os.path.isdir(path):
        error.errno = errno.EISDIR
    elif not os.access(path, os.R_OK):
        error.errno = errno.EACCES
    return error


class NotConverged(Error, RuntimeError):
    """A calculation did not converge, so that its result does not exist."""


class Stopped(Error, RuntimeError):
    """A long calculation was stopped before it had a result."""
