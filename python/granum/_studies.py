# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies: scenes and their results."""

from __future__ import annotations

import importlib
import numbers
import os

from ._errors import InvalidArgument, _file_error
from ._granum import _text_in_si, _verify


def _text(name, value, numbers_in_si):
    """A value of a key as text for --set."""
    if isinstance(value, str):
        return value
    if isinstance(value, (list, tuple)) or hasattr(value, "tolist") and getattr(value, "ndim", False):
        return ",".join(_text(name, item, numbers_in_si) for item in value)
    is_flag = isinstance(value, bool)
    if not is_flag and isinstance(value, numbers.Integral):
        integer = int(value)
        return _text_in_si(name, integer) if numbers_in_si and abs(integer) < 2**53 else str(integer)
    if not is_flag and isinstance(value, numbers.Real):
        return _text_in_si(name, float(value)) if numbers_in_si else repr(float(value))
    raise TypeError(f"{name} is a text, a number, or a list of them, not {value!r}")


def _settings(table, numbers_in_si, prefix=""):
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _settings(value, numbers_in_si, f"{prefix}{key}.")
        else:
            yield prefix + key, _text(prefix + key, value, numbers_in_si)


def _reader_of_toml():
    for name in ("tomllib", "tomli"):  # of Python 3.11; the same for older ones
        try:
            return importlib.import_module(name)
        except ImportError:
            pass
    raise InvalidArgument("a scene in a file needs Python 3.11 or the package tomli: give its keys as a dict")


def _scene(scene):
    """Name and text of all keys of a scene."""
    if scene is None:
        return []
    if isinstance(scene, dict):
        return list(_settings(scene, numbers_in_si=True))
    toml = _reader_of_toml()
    with open(os.fspath(scene), "rb") as file:
        try:
            table = toml.load(file)
        except ValueError as error:  # no TOML, or no UTF-8
            shown = os.fsdecode(scene).encode(errors="backslashreplace").decode()
            raise _file_error(f"{shown}: {error}", os.fsdecode(scene)) from None
    return list(_settings(table, numbers_in_si=False))


class _Bar:
    """A progress bar of tqdm for a study."""

    def __init__(self, tqdm):
        self.bar = tqdm(total=100, unit="%", leave=False)

    def __call__(self, done, what):
        self.bar.set_description(what)
        self.bar.update(100 * done - self.bar.n)


def verify(scene=None, *, progress=None):
    """Compares closed form, contact network and DEM probe, as the command granum verify.

    The same scene gives bitwise identical results, on any number of threads. Ctrl-C stops within a second; the
    KeyboardInterrupt then has the finished part as its attribute study.

    Parameters
    ----------
    scene : dict or path_like, optional
        Sections and keys of a scene, {"study": {"grains": 300}} or {"study.grains": 300}: numbers in SI, or texts
        with units, "0.5mm". Or the path of a scene file, TOML. Default: the six specimens of Chung et al. 2014. All
        keys, with their defaults, units and meaning, are in examples/scene.toml of the source.
    progress : callable or "tqdm", optional
        Called periodically as progress(done, what), with the finished share of the work.

    Returns
    -------
    Study

    Raises
    ------
    InvalidArgument
        For an impossible scene, or a key without effect.
    FileError
        For a scene file that is no TOML.

    Notes
    -----
    The experiment of the paper, isotropic part. [Chung2014]

    In C++: granum::studies::run_study, which is not installed; its parts are those of specimen(), compress(),
    measure() and probe().
    """
    if progress != "tqdm":
        return _verify(_scene(scene), progress)
    bar = _Bar(importlib.import_module("tqdm.auto").tqdm)
    try:
        return _verify(_scene(scene), bar)
    finally:
        bar.bar.close()
