# SPDX-License-Identifier: GPL-3.0-or-later
# Types of the package. SI everywhere; the meaning of each name is in its docstring.
# Made by python/make_stub.py: this head is written by hand, all below of the package itself.
from collections.abc import Callable, Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, ClassVar, Generic, Literal, NoReturn, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import Error as Error
from ._errors import FileError as FileError
from ._errors import InvalidArgument as InvalidArgument
from ._errors import NotConverged as NotConverged
from ._errors import Stopped as Stopped

__version__: str

# A float for a call with numbers only, an array for a call with arrays.
_N = TypeVar("_N", float, NDArray[np.float64])
_Array = NDArray[np.float64]
_Path = Union[str, PathLike[str]]
_Range = Optional[tuple[Optional[float], Optional[float]]]
_TurningSpring = Union[None, float, tuple[float, str], Literal["marshall"]]


# One matrix, a stack of them, or a result that has them.
_Matrices = Union[ArrayLike, "Estimate[Any]", "Isotropic[Any]"]

class _Result:
    def to_dict(self) -> dict[str, Any]: ...
    def to_columns(self) -> dict[str, NDArray[Any]]: ...
    def to_xarray(self, dims: Optional[Sequence[str]] = ...) -> Any: ...
    def __eq__(self, other: object) -> bool: ...

class Record(_Result):
    def __init__(self, kind: str, values: dict[str, Any]) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: Any) -> None: ...
    def __mul__(self, number: float) -> Any: ...
    def __rmul__(self, number: float) -> Any: ...
    def __truediv__(self, number: float) -> Any: ...
    def __add__(self, number: float) -> Any: ...
    def __radd__(self, number: float) -> Any: ...
    def __sub__(self, number: float) -> Any: ...

