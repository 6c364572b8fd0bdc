# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes granum/__init__.pyi from what the package says of itself: signatures, and the types in its docstrings.

    python3 make_stub.py <folder of the package's scripts> <folder of the compiled module> <output>

What cannot be read there is in stub_head.pyi and in the tables below. Where the module cannot be imported, as when it
is compiled for another machine, the stub says nothing of the package, and any use of it passes a checker.
Checked by python/tests/test_types.py
"""

import importlib.util
import inspect
import pathlib
import re
import sys

# Types of parameters, by the words of docstrings.
PARAMETERS = {
    "float": "float",
    "int": "int",
    "bool": "bool",
    "str": "str",
    "int or str": "Union[int, str]",
    "str or sequence of str": "Union[str, Sequence[str]]",
    "str or array of str": "ArrayLike",
    "dict of array_like": "Mapping[str, ArrayLike]",
    "path_like": "_Path",
    "dict": "Mapping[str, str]",
    "dict or path_like": "Union[Mapping[str, Any], _Path]",
    'callable or "tqdm"': 'Union[Literal["tqdm"], Callable[[float, str], object]]',
    "(3,) sequence of bool": "Sequence[bool]",
    "(N,) sequence of int": "Sequence[int]",
    "(2,) sequence of ndarray": "Sequence[_Array]",
    'float, (float, str) or "marshall"': "_TurningSpring",
    '"auto", None or three ranges': 'Union[None, Literal["auto"], Sequence[_Range]]',
}
# Types of keywords whose words are not enough.
KEYWORDS = {"uncertainty": "Mapping[str, float]", "materials": "Mapping[int, tuple[float, float]]"}
# Types of properties of which pybind11 knows less: of any class, or of one.
PROPERTIES = {
    "errors": "dict[tuple[int, ...], str]",
    "shape": "tuple[int, ...]",
    "shares": "dict[str, _N]",
    "notes": "list[str]",
    "relative_error": "Optional[ModulusErrors[_N]]",
    "error_shares": "dict[str, float]",
    "contact_numbers": "dict[str, Measured]",
    "periodic": "tuple[bool, bool, bool]",
    "RungAssessment.estimate": "Optional[Estimate[float]]",
    "Measurement.rungs": "dict[str, Estimate[float]]",
    "Contacts.i": "NDArray[np.uint32]",
    "Contacts.j": "NDArray[np.uint32]",
    "Contacts.sliding": "NDArray[np.bool_]",
    "Packing.id": "NDArray[np.int64]",
    "Packing.type": "NDArray[np.int64]",
    "Packing.body": "NDArray[np.uint32]",
}
ITERATORS = {"Compression": "State", "Frames": "Packing", "Shearing": "PathPoint"}
# Classes whose numbers are floats or arrays, as the arguments of the call.
GENERIC_WITHOUT_SHAPE = ("Moduli", "ModulusErrors", "Range")
# Functions that take no arrays, although their docstring shares entries with others.
OF_NUMBERS = ("estimate",)
# Of a range and a number.
OPERATORS = ("__mul__", "__rmul__", "__truediv__", "__add__", "__radd__", "__sub__")
# Calls of one function with results of different classes: types of keywords, keywords left out, result.
OF_SANDS = ("uniformity", "least_void_ratio", "largest_void_ratio", "relative_density", "d50")
OF_SPHERES = ("pore_density", "rattler_fraction", "contacts", "uncertainty")
ANY_RADIUS = {"radius": "ArrayLike"}
KINDS = {
    "infer": [
        ({"sand": "str", "grain_shape": 'Literal["sand"] = ...', **ANY_RADIUS}, OF_SPHERES, "SandInference"),
        ({"grain_shape": 'Literal["sand"]', **ANY_RADIUS}, OF_SPHERES, "SandInference"),
        ({"grain_shape": 'Optional[Literal["sphere"]] = ...', **ANY_RADIUS}, OF_SANDS, "Inference"),
        ({**ANY_RADIUS}, set(), "Union[Inference, SandInference]"),
    ]
}


def imported(scripts, module):
    """The package, of its scripts in one folder and the compiled module in another."""
    places = [str(scripts), str(module)]
    spec = importlib.util.spec_from_file_location(
        "granum", scripts / "__init__.py", submodule_search_locations=places
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["granum"] = package
    spec.loader.exec_module(package)
    return package


def plain(text):
    """Types as pybind11 2 writes them, where version 3 says more."""
    text = re.sub(r'typing\.Annotated\[(.*?), "FixedSize\(\d+\)"\]', r"\1", text)
    return re.sub(r"typing\.Supports(Float|Int)(?: \| typing\.SupportsIndex)?", lambda m: m[1].lower(), text)


def section(doc, title):
    found = re.search(rf"^{title}\n-+\n(.*?)(?=^\w[\w ]*\n-+\n|\Z)", doc, re.S | re.M)
    return found.group(1) if found else ""


class Stub:
    """The stub of a package."""

    def __init__(self, package):
        self.package = package
        names = sorted(name for name in package.__all__ if not name.startswith("_"))
        self.names = [*names, *sorted(set(package.__all__) - set(names))]
        values = {name: getattr(package, name) for name in names}
        self.classes = {name: v for name, v in values.items() if inspect.isclass(v) and not issubclass(v, Exception)}
        self.functions = {name: v for name, v in values.items() if inspect.isroutine(v)}
        self.generic = {name for name, v in self.classes.items() if hasattr(v, "errors") and hasattr(v, "shape")}
        self.generic |= set(GENERIC_WITHOUT_SHAPE)

    # ---- types

    def with_number(self, text, number):
        """A type with the type of its numbers, where it is generic."""
        return re.sub(r"\b[A-Z]\w+\b(?!\[)", lambda m: m[0] + (f"[{number}]" if m[0] in self.generic else ""), text)

    def parameter(self, name, words, default, number):
        words = words.replace(", optional", "")
        choice = re.fullmatch(r"\{(.*)\}", words)
        if name in KEYWORDS:
            kind = KEYWORDS[name]
        elif choice:
            kind = f"Literal[{choice.group(1)}]"
        elif words in PARAMETERS:
            kind = PARAMETERS[words]
        elif "array_like" in words:
            kind = number if words == "array_like" else "ArrayLike"
        else:
            kind = words if words in self.classes else "Any"
        return f"Optional[{kind}]" if default is None and not kind.startswith("Union[None") else kind

    def result(self, words, number):
        if words == "dict of float or ndarray":
            return "dict[str, Any]"
        words = re.sub(r"^list of (\w+)$", r"list[\1]", words)
        words = re.sub(r"^dict of (\w+)$", r"dict[str, \1]", words).replace("[str, ndarray]", "[str, _Array]")
        words = re.sub(r"^(\w+) or (\w+)$", r"Union[\1, \2]", words.replace("float or ndarray", number))
        words = re.sub(r"^(\(.*\) )?ndarray$", "_Array", words)
        known = re.search(r"\w+", words)
        return self.with_number(words, number) if known and "." not in words else "Any"

    def of_property(self, kind, name, getter):
        found = re.search(r"-> (.*)", getter.__doc__ or "")
        number = "_N" if kind in self.generic else "float"
        for key in (f"{kind}.{name}", name):
            if key in PROPERTIES:
                return PROPERTIES[key]
        text = plain(found.group(1)) if found else "Any"
        text = text.replace("granum._granum.", "").replace("List[float[3]]", "list[float]")
        text = re.sub(r"\b(List|Dict|Tuple)\[", lambda m: m[0].lower(), text)
        array = r"numpy\.(?:ndarray|typing\.NDArray)(\[.*?\])?"  # of pybind11 2, 3
        text = re.sub(array, lambda m: "NDArray[np.bool_]" if "bool" in (m[1] or "") else "_Array", text)
        text = {"object": "Any", "dict": "dict[str, Any]", "tuple": "tuple[Any, ...]", "list": "list[Any]"}.get(text, text)
        if kind in self.generic and text in ("float", "Any"):
            return "_N"
        return self.with_number(text, number)

    # ---- functions and classes

    def signature(self, name, function, number, types=None, without=(), result=None):
        """One line: def name(...) -> result."""
        doc = inspect.getdoc(function) or ""
        words = {}
        for heads, kind in re.findall(r"^(\S.*?) : (.*)$", section(doc, "Parameters"), re.M):
            words.update((head.lstrip("*"), kind) for head in heads.split(", "))
        parts, starred = [], False
        for parameter in inspect.signature(function).parameters.values():
            if parameter.name in without:
                continue
            if parameter.kind == parameter.KEYWORD_ONLY and not starred:
                parts.append("*")
            starred |= parameter.kind in (parameter.KEYWORD_ONLY, parameter.VAR_POSITIONAL)
            if parameter.name == "self":
                parts.append("self")
                continue
            default = parameter.default
            kind = self.parameter(parameter.name, words.get(parameter.name, ""), default, number)
            stars = "*" if parameter.kind == parameter.VAR_POSITIONAL else ""
            plain = default is None or isinstance(default, (bool, int, float, str))
            end = "" if default is parameter.empty else f" = {default!r}" if plain else " = ..."
            parts.append(f"{stars}{parameter.name}: " + (types or {}).get(parameter.name, kind + end))
        returned = result or self.result((section(doc, "Returns").splitlines() or ["Any"])[0], number)
        return f"def {name}({', '.join(parts)}) -> {returned}: ..."

    def overloads(self, name, function, indent=""):
        """All lines of a function; one of arrays has two."""
        if "(..., 6, 6) array_like" in section(inspect.getdoc(function) or "", "Parameters"):
            # Of one matrix or a stack of them, which have one type.
            line = self.signature(name, function, "ArrayLike").replace("[ArrayLike]", "[Any]")
            lines = [line.replace("stiffness: ArrayLike", "stiffness: _Matrices")]
        elif name in KINDS and not indent:
            lines = [self.signature(name, function, "ArrayLike", *kind) for kind in KINDS[name]]
        else:
            of_float = self.signature(name, function, "float")
            of_array = self.signature(name, function, "ArrayLike").replace("[ArrayLike]", "[_Array]")
            of_array = re.sub(r"-> ArrayLike", "-> _Array", of_array)
            of_array = re.sub(r"Optional\[_Array\]", "Optional[ArrayLike]", of_array)
            same_call, same_result = (a == b for a, b in zip(of_float.split(" -> "), of_array.split(" -> ")))
            of_one = of_float if same_call or name in OF_NUMBERS else of_array
            lines = [of_one] if same_call or same_result else [of_float, of_array]
        if len(lines) == 1:
            return [indent + lines[0]]
        lines[0] = lines[0].replace(": ...", ": ...  # type: ignore[misc]")
        return [indent + part for line in lines for part in ("@overload", line)]

    def initializer(self, kind):
        """That of a class that users make, from the docstring that pybind11 wrote."""
        found = re.search(r"__init__\(self: [\w.]+(, .*)?\) -> None", kind.__init__.__doc__ or "")
        if found:
            return [f"    def __init__(self{plain(found.group(1) or '')}) -> None: ..."]
        # Made by functions alone: no argument lets a call pass.
        return ["    def __init__(self, _: NoReturn) -> None: ..."]

    def class_lines(self, name, kind):
        own = vars(kind)
        bases = ["_Result"] if hasattr(kind, "to_dict") else []
        bases += ["Generic[_N]"] if name in self.generic else []
        lines = [f"class {name}({', '.join(bases)}):" if bases else f"class {name}:"]
        lines += self.initializer(kind)
        if name in ITERATORS:
            lines.append(f"    def __iter__(self) -> Iterator[{ITERATORS[name]}]: ...")
            lines.append(f"    def __next__(self) -> {ITERATORS[name]}: ...")
        for copy, arguments in {"__copy__": "self", "__deepcopy__": "self, memo: Any"}.items():
            lines += [f"    def {copy}({arguments}) -> {name}: ..."] if copy in own else []
        if name == "Range":
            lines += [f"    def {op}(self, number: float) -> Range[_N]: ..." for op in OPERATORS]
        if "__len__" in own:
            lines.append("    def __len__(self) -> int: ...")
        if "__eq__" in own and "_Result" not in bases:
            lines.append("    def __eq__(self, arg0: object) -> bool: ...")
        if own.get("__hash__", ...) is None:
            lines.append("    __hash__: ClassVar[None]  # type: ignore[assignment]")
        inherited = [base for base in kind.__mro__[1:] if base.__name__.startswith("_")]
        members = {key: value for base in inherited for key, value in vars(base).items()} | own
        for key, value in members.items():
            if isinstance(value, property):
                lines += ["    @property", f"    def {key}(self) -> {self.of_property(name, key, value.fget)}: ..."]
            elif not key.startswith("_") and callable(value) and key not in ("to_dict", "to_columns", "to_xarray"):
                lines += self.overloads(key, getattr(kind, key), "    ")
        return lines if len(lines) > 1 else [lines[0] + " ..."]

    def text(self, head):
        lines = [head.rstrip(), "", "__all__ = [", *(f'    "{name}",' for name in self.names), "]", ""]
        for name, kind in self.classes.items():
            if f"class {name}(" not in head:
                lines += [*self.class_lines(name, kind), ""]
        for name, function in self.functions.items():
            lines += self.overloads(name, function)
        return "\n".join(lines) + "\n"


def main(scripts, module, output):
    try:
        package = imported(pathlib.Path(scripts), pathlib.Path(module))
    except ImportError as error:
        print(f"the stub of granum is empty, for the module cannot be imported here: {error}", file=sys.stderr)
        text = "from typing import Any\n\ndef __getattr__(name: str) -> Any: ...\n"
    else:
        text = Stub(package).text((pathlib.Path(__file__).resolve().parent / "stub_head.pyi").read_text())
    pathlib.Path(output).write_text(text)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    main(*sys.argv[1:])
