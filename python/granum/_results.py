# SPDX-License-Identifier: GPL-3.0-or-later
"""Common methods of all results: repr, comparison, and conversion to dictionaries, tables and pickles.

A result is an instance of a class with properties of the compiled module; _attach adds the functions below to these
classes, unless they define their own. Checked by python/tests/test_results.py
"""

from __future__ import annotations

import copyreg
import html
import importlib
import numbers

from typing import Any

import numpy as np

from . import _granum
from ._errors import InvalidArgument, NotConverged

_WIDTH = 100  # of a line of repr
_ALIVE = ("Compression", "Frames", "Shearing", "Specimen")  # simulations and readers, which have no fixed value
_INPUTS = ("ContactMeans", "Distribution", "NormalLaw", "Packing")  # made by users
# Results of many elements that do not state their shape: an array of one number, or vector of this length, each.
_ELEMENTS = {
    "Contacts": ("i", 0),
    "Moduli": ("shear_modulus", 0),
    "ModulusErrors": ("G_vh", 0),
    "PlaneWaves": ("speed", 1),
    "Range": ("value", 0),
}
_classes: set[Any] = {type_ for type_ in vars(_granum).values() if isinstance(type_, type)}
_results: set[Any] = {type_ for type_ in _classes if type_.__name__ not in _ALIVE + _INPUTS}


def _names(result):
    """The names of its numbers, in the order of their documentation."""
    if isinstance(result, Record):
        return list(vars(result)["_values"])
    types = [type_ for type_ in type(result).__mro__ if type_ in _classes]
    return [name for type_ in types for name, value in vars(type_).items() if isinstance(value, property)]


def _value(result, name):
    """A number of a result; None if it does not exist."""
    try:
        return getattr(result, name)
    except (InvalidArgument, NotConverged):
        return None


def _is_result(value):
    return isinstance(value, Record) or type(value) in _results


def _plain(value):
    """A value for dictionaries: numbers, texts, copies of arrays, and dictionaries for results."""
    if _is_result(value):
        return to_dict(value)
    if isinstance(value, np.ndarray):
        return value.copy()
    if isinstance(value, (list, tuple)):
        return type(value)(_plain(item) for item in value)
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return value


def to_dict(self):
    """The whole result as a new dictionary.

    Returns
    -------
    dict
        By name: numbers, texts, copies of arrays, lists, and dictionaries for nested results. None stands for
        what does not exist.
    """
    return {name: _plain(_value(self, name)) for name in _names(self)}


def _flat(values, prefix=""):
    """Pairs of a name and a number or array of numbers; names of nested results are joined by underscores.

    The value of a range or of a measured number has the name of the range or number itself.
    """
    for name, value in values.items():
        if isinstance(value, dict):
            yield from _flat(value, f"{prefix}{name}_")
        elif isinstance(value, (bool, int, float, np.ndarray)):
            yield prefix[:-1] if prefix and name == "value" else prefix + name, np.asarray(value)


def to_columns(self):
    """The numbers of the result as columns of one length, as for pandas.DataFrame.

    Each row is an element of the arrays in the call, a contact, or a state of a study; a result of one element is one
    row. Each component of a vector or tensor is a column: branch_1, stiffness_12. Lists, texts and arrays of another
    length are left out. Columns are numbered from 0: DataFrame(columns, index=table.index) joins them to a table.

    Returns
    -------
    dict
        Of arrays (N,), by name.
    """
    values = to_dict(self)
    if _kind(self) == "Study":
        values = values["states"]
    shape = _shape(self, values)
    values.pop("errors", None)
    rows = int(np.prod(shape))
    columns = {}
    for name, array in _flat(values):
        if array.shape[: len(shape)] != shape:
            array = np.broadcast_to(array, shape + array.shape) if array.ndim == 0 else None
        elif not shape and _kind(self) not in _ELEMENTS and (array.ndim != 2 or array.shape not in ((3, 3), (6, 6))):
            array = array if array.ndim == 0 else None
        if array is None:
            continue
        table = array.reshape((rows,) + array.shape[len(shape) :])
        for at in np.ndindex(*table.shape[1:]):
            place = "".join(str(k + 1) for k in at)
            columns[f"{name}_{place}" if place else name] = table[(slice(None), *at)].copy()
    return columns


# Dimensions of vectors and tensors in a data set, by their length.
_AXES = {3: "axis", 6: "voigt"}


def to_xarray(self, dims=None):
    """The numbers of the result as a data set of xarray, which has to be installed.

    Numbers keep the axes of the call. Axes of vectors and tensors are called axis and axis_2, those of Voigt matrices
    voigt and voigt_2, with the indices 11 22 33 23 13 12 as coordinates. Lists, texts and messages are left out.

    Parameters
    ----------
    dims : sequence of str, optional
        Names of the axes of the call; default: dim_0, dim_1 and so on.

    Returns
    -------
    xarray.Dataset
        The names of variables are those of to_columns().
    """
    xarray = importlib.import_module("xarray")
    values = to_dict(self)
    if _kind(self) == "Study":
        values = values["states"]
    shape = _shape(self, values)
    names = [f"dim_{k}" for k in range(len(shape))] if dims is None else list(dims)
    if len(names) != len(shape):
        raise InvalidArgument(f"dims has {len(names)} names, and the result has the shape {shape}")
    values.pop("errors", None)
    variables, coordinates = {}, {}
    for name, array in _flat(values):
        if array.ndim and array.shape[: len(shape)] != shape:
            continue
        inner = array.shape[len(shape) :] if array.ndim else ()
        if any(length not in _AXES for length in inner):
            continue
        axes = [_AXES[length] + (f"_{k + 1}" if k else "") for k, length in enumerate(inner)]
        coordinates.update({axis: [11, 22, 33, 23, 13, 12] for axis in axes if axis.startswith("voigt")})
        variables[name] = ([*names, *axes] if array.ndim else [], array)
    return xarray.Dataset(variables, coordinates)


def _shape(result, values):
    """The axes of a result that are those of the call."""
    if _kind(result) == "Study":
        return (len(values["seed"]),)
    if _kind(result) in _ELEMENTS:
        name, axes = _ELEMENTS[_kind(result)]
        shape = np.shape(values[name])
        return shape[: len(shape) - axes]
    return tuple(values.pop("shape", ()))


def _short(value):
    """A short text for a value."""
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, np.ndarray):
        few = value.ndim == 1 and value.size <= 4 and value.dtype.kind == "f"
        return f"[{', '.join(map(_short, value.tolist()))}]" if few else f"<{value.dtype} {value.shape}>"
    if isinstance(value, (list, tuple)):
        if len(value) <= 3 and all(isinstance(item, (int, float)) for item in value):
            return "(" + ", ".join(_short(item) for item in value) + (",)" if len(value) == 1 else ")")
        return f"<{len(value)} of them>" if value else "none"
    if isinstance(value, dict):
        return f"<{len(value)} of them>" if value else "none"
    if _is_result(value):
        return f"{_kind(value)}(...)"
    return repr(value)


def _kind(result):
    return vars(result)["_kind"] if isinstance(result, Record) else type(result).__name__


def _shown(result):
    """The names that its text shows: what the call says of its elements where there is something, behind the numbers."""
    names = _names(result)
    of_call = [name for name in ("errors", "notes", "shape") if name in names] if "shape" in names else []
    return [name for name in names if name not in of_call] + [name for name in of_call if _value(result, name)]


def _repr(self):
    names = _shown(self)
    if not names:
        return f"<{_kind(self)}>"
    lines, line = [], _kind(self) + "("
    for k, name in enumerate(names):
        text = f"{name}={_short(_value(self, name))}" + (")" if k + 1 == len(names) else ", ")
        if len(line) + len(text.rstrip()) > _WIDTH:
            lines.append(line.rstrip())
            line = "    "
        line += text
    return "\n".join([*lines, line])


def _same(a, b):
    """Equal, arrays element by element; NaN equals NaN."""
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(_same(a[key], b[key]) for key in a)
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(map(_same, a, b))
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        a, b = np.asarray(a), np.asarray(b)
        return np.array_equal(a, b, equal_nan=a.dtype.kind == "f" and b.dtype.kind == "f")
    return bool(a == b) or (isinstance(a, float) and isinstance(b, float) and a != a and b != b)


def _equal(self, other):
    if not _is_result(other) or _kind(self) != _kind(other):
        return NotImplemented
    return self is other or _same(to_dict(self), to_dict(other))


def _recorded(value):
    """A value for a pickle: nested results become records too."""
    if type(value) in _results:
        return Record(_kind(value), {name: _recorded(_value(value, name)) for name in _names(value)})
    if isinstance(value, (list, tuple)):
        return type(value)(_recorded(item) for item in value)
    if isinstance(value, dict):
        return {key: _recorded(item) for key, item in value.items()}
    if type(value).__name__ in _ALIVE:
        return None
    return value.copy() if isinstance(value, np.ndarray) else value


def _made_again(name, values):
    """Restores an object made by users from its numbers."""
    return getattr(_granum, name)(**values)


# The numbers that restore each of them.
_MADE_OF = {
    "ContactMeans": ("branch", "branch_square", "pair_radius", "grain_volume"),
    "Distribution": ("text",),
}


def _reduce_input(self):
    name = type(self).__name__
    return _made_again, (name, {number: getattr(self, number) for number in _MADE_OF[name]})


def _reduce(self):
    record = _recorded(self)
    return Record, (vars(record)["_kind"], vars(record)["_values"])


# What infer() made again gives the same numbers, and its predictions too.
_MADE_BY_A_CALL = ("Inference", "SandInference")


def _called_again(call):
    return _granum.infer(**call)


def _reduce_call(self):
    return _called_again, (self._call,)


def _reduce_state(self):
    return copyreg.__newobj__, (type(self),), self.__getstate__()  # type: ignore[attr-defined]


def _refuse_to_reduce(self):
    raise TypeError(f"a {type(self).__name__} cannot be pickled or copied")


def _scaled(self, factor, shift=0.0):
    """A range times a number, plus a number; its ends change places where the number is negative."""
    ends = [end * factor + shift for end in (self.low, self.high)]
    low, high = np.minimum(*ends), np.maximum(*ends)
    if not isinstance(self.value, np.ndarray):
        low, high = float(low), float(high)
    return Record("Range", {"value": self.value * factor + shift, "low": low, "high": high})


def _is_number(value):
    return isinstance(value, numbers.Real) and not isinstance(value, bool)


# Of a range and a number alone: two ranges may have errors in common.
def _times(self, number):
    return _scaled(self, float(number)) if _kind(self) == "Range" and _is_number(number) else NotImplemented


def _over(self, number):
    return _scaled(self, 1 / float(number)) if _kind(self) == "Range" and _is_number(number) else NotImplemented


def _plus(self, number):
    return _scaled(self, 1.0, float(number)) if _kind(self) == "Range" and _is_number(number) else NotImplemented


def _minus(self, number):
    return _plus(self, -number) if _is_number(number) else NotImplemented


def _format(self, how):
    """A range as f"{value:.3g} ({low:.3g} to {high:.3g})"."""
    if _kind(self) != "Range" or not how:
        return format(str(self), how)
    if isinstance(self.value, np.ndarray):
        raise TypeError("a range of arrays has no format: take one element of value, low and high")
    return f"{self.value:{how}} ({self.low:{how}} to {self.high:{how}})"


_OF_RANGES = {
    "__mul__": _times,
    "__rmul__": _times,
    "__truediv__": _over,
    "__add__": _plus,
    "__radd__": _plus,
    "__sub__": _minus,
    "__format__": _format,
}


def _repr_html_(self):
    """The numbers of the result as a table, for notebooks."""
    rows = "".join(
        f"<tr><th>{html.escape(name)}</th><td>{html.escape(_short(_value(self, name)))}</td></tr>" for name in _names(self)
    )
    return f"<table><caption>{html.escape(_kind(self))}</caption>{rows}</table>"


class Record:
    """A result restored from a pickle or a copy: the same names and numbers, without methods.

    Made only by pickle and copy. A record equals the original result.
    """

    def __init__(self, kind: str, values: dict[str, Any]) -> None:
        vars(self).update(_kind=kind, _values=values)

    def __getattr__(self, name):
        try:
            return vars(self)["_values"][name]
        except KeyError:
            raise AttributeError(f"the record of {vars(self).get('_kind', 'a result')} has no {name}") from None

    def __setattr__(self, name, value):
        raise AttributeError("a result cannot be changed")

    def __reduce__(self):
        return Record, (vars(self)["_kind"], vars(self)["_values"])

    def __dir__(self):
        return [*super().__dir__(), *vars(self)["_values"]]

    __repr__ = _repr
    __eq__ = _equal
    __hash__ = None  # type: ignore[assignment]
    to_dict = to_dict
    to_columns = to_columns
    to_xarray = to_xarray
    __mul__ = __rmul__ = _times
    __truediv__ = _over
    __add__ = __radd__ = _plus
    __sub__ = _minus
    __format__ = _format
    _repr_html_ = _repr_html_


def _attach():
    """Adds the common methods to the classes of the compiled module."""
    for type_ in _classes:
        own = vars(type_)
        if type_.__repr__ is object.__repr__:
            type_.__repr__ = _repr
        # pybind11 ends the process in object.__reduce__, as protocols 0 and 1 call it: no class may inherit it.
        if type_.__name__ in _MADE_OF:
            type_.__reduce__ = _reduce_input
        elif type_.__name__ in _MADE_BY_A_CALL:
            type_.__reduce__ = _reduce_call
        elif "__getstate__" in own:
            type_.__reduce__ = _reduce_state
        else:
            type_.__reduce__ = _reduce if type_ in _results else _refuse_to_reduce
        if type_ not in _results:
            continue
        type_.to_dict, type_.to_columns, type_._repr_html_ = to_dict, to_columns, _repr_html_
        type_.to_xarray = to_xarray
        if type_.__name__ == "Range":
            for name, function in _OF_RANGES.items():
                setattr(type_, name, function)
        if type_.__eq__ is object.__eq__:
            type_.__eq__, type_.__hash__ = _equal, None
