#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps the floors of the library:  check_layering.py <source tree> [planted]

A module includes its own headers and those of strictly lower floors. Rooms, the folders of a module, do not include one another
in a circle. A name of a public type has one meaning: no two namespaces define it. Prints one line for each violation. With
"planted", proves that it can fail: each violation that is planted alone must be found, and what is allowed must not.
"""

import functools
import itertools
import pathlib
import re
import sys

FLOORS = ["core", "contact sizes stress elastic fabric plot", "effective sands packing",
          "hardin estimate rock_physics network dem io", "inverse analysis triaxial", "studies", "cli"]
STUDIES_FLOORS = ["scene paper", "running plan", "verify trade analyse", "report", "reproduce"]
floor, studies_floor = ({name: k for k, names in enumerate(floors) for name in names.split()} for floors in (FLOORS, STUDIES_FLOORS))

# Modules whose headers a user without Eigen can include, and libraries that stay an affair of the sources.
WITHOUT_EIGEN = "core contact sizes stress fabric sands hardin packing".split()
PRIVATE_LIBRARIES = r"(boost|gsl|nlohmann|toml\+\+|CLI|fmt)/|(toml|json|zlib|expat)\.h"
# Exceptions of the closed forms are caught in one source alone, so that targets that cannot catch leave one source out.
THEORY = "core contact sizes stress elastic fabric effective sands estimate rock_physics".split()
# Whose private headers, named by their path below src, a module may include beside its own; those of core are vector code.
PRIVATE_HEADERS = {"estimate": ["effective"], "rock_physics": ["effective"], "inverse": ["hardin"], "cli": ["studies"],
                   "effective": ["core"], "network": ["core"], "dem": ["core"]}
# What core wraps of other libraries, for every module: eigenvalues, gamma functions, roots.
COMPILED_ONCE = r'"core/(compiled_once|root)[.]hpp"$'

# Where alone a pattern may occur, and why. Files are written whole or not at all, and never in the place of a device or a pipe;
# they are read where errors of the disk are reported: streams of the library take them for the end.
ROOMS_OF_MEANS = [
    (r"src/cli/", r"std::(cout|cerr|clog)|(^|[^A-Za-z0-9_])(printf|vprintf|puts|putchar|perror|exit|_Exit|quick_exit|abort|terminate|raise)"
     r"[ \t]*\(|(fmt|std)::print(ln)?[ \t]*\(|fprintf[ \t]*\([ \t]*(stdout|stderr)|(fputs|fwrite)[ \t]*\([^;]*(stdout|stderr)",
     "only src/cli prints and exits"),
    (r"src/core/vector/", r"vector_size|target_clones|gnu::target|__builtin_cpu_|[a-z]mmintrin[.]h|immintrin[.]h",
     "vector code has its room, src/core/vector"),
    (r"src/io/output_file\.cpp$",
     r"std::(basic_)?o?fstream|O_(WRONLY|RDWR|CREAT)|(^|[^A-Za-z0-9_])(fopen|freopen|creat|mkstemp|rename|copy_file)[ \t]*\(",
     "only src/io/output_file.cpp writes files"),
    (r"src/io/text/source\.cpp$", r"std::(basic_)?(i?fstream|filebuf)|(^|[^A-Za-z0-9_])(gzopen|mmap|pread|readv|::read)[ \t]*\(",
     "only src/io/text/source.cpp reads files"),
]
TYPES = re.compile(r"\n(namespace [a-z_:]+ |(?:struct|class|enum class|union) [A-Za-z0-9_]+[^;\n]*[{\n]|using [A-Za-z0-9_]+ =)")


@functools.cache
def look_at(path, text, own_header):
    """Violations of a file by itself, which rooms its room includes, and its public types with their namespaces."""
    found, uses, types = [], set(), []
    parts = path.removeprefix("include/granum/").removeprefix("src/").split("/")
    public, module, room = path.startswith("include/"), parts[0], "/".join(parts[:2]) if len(parts) > 2 else ""
    if module not in floor:
        return found, uses, types
    if module == "studies" and room.removeprefix("studies/") not in studies_floor:
        found.append("lies in no room of studies of a known floor")
    text = re.sub(r"//[^\n]*", "", text)
    includes = re.findall(r'#[ \t]*include[ \t]*([<"][^>"\n]*[>"])', text)
    if own_header and includes[:1] != [own_header]:
        found.append(f"does not include {own_header} first, so nothing shows that this header includes what it uses")
    for include in includes:
        target = include.strip('<>"')
        says = f"includes {include}"
        if of_granum := re.match(r"granum/([^/]+)/", target):
            other = of_granum[1]
            if other not in floor:
                found.append(f"{says}, which is of no known module")
            elif other != module and floor[other] >= floor[module]:
                found.append(f"{says}, but {other} is not below {module}")
            elif module == "analysis" and other in ("dem", "io", "hardin"):
                found.append(f"{says}; analysis takes packings of anyone and does without {other}")
        elif re.match(COMPILED_ONCE, include):
            continue
        elif (private := re.match(r'"([^/"]+)/', include)) and private[1] not in [module, *PRIVATE_HEADERS.get(module, [])]:
            found.append(f"{says}, a private header of {private[1]}")
        of_room = re.match(rf"(?:granum/)?({module}/[^/]+)/", target)
        if room and of_room and of_room[1] != room:
            uses.add((room, of_room[1]))
            study, other = (name.removeprefix("studies/") for name in (room, of_room[1]))
            if module == "studies" and study in studies_floor and studies_floor.get(other, -1) >= studies_floor[study]:
                found.append(f"{says}, but {other} is not below {study} in studies")
        if target.startswith("gsl/") and not path.startswith("src/hardin/"):
            found.append(f"{says}; GSL is for src/hardin alone")
        if public and re.match(PRIVATE_LIBRARIES, target):
            found.append(f"{says}; public headers do without it")
        if public and re.match(r"(unsupported/)?Eigen/", target) and module in WITHOUT_EIGEN:
            found.append(f"{says}; headers of {module} do without Eigen")
    for where, means, why in ROOMS_OF_MEANS:
        if not re.match(where, path) and (used := re.search(means, text)):
            found.append(f"uses {used[0].strip()}; {why}")
    if module in THEORY and path != "src/estimate/uncertain_answer.cpp" and re.search(r"(^|[^A-Za-z0-9_])catch[ \t\n]*\(", text):
        found.append("catches an exception; among the closed forms only src/estimate/uncertain_answer.cpp does")
    if public:
        namespace = ""
        for line in TYPES.findall("\n" + text.replace("[[nodiscard]] ", "")):
            if line.startswith("namespace "):
                namespace = line.split()[1]
            else:
                types.append((re.match(r"(?:struct|enum class|class|union|using) ([A-Za-z0-9_]+)", line), namespace))
    return found, uses, [(name[1], namespace) for name, namespace in types if name]


def violations(files):
    """Of sources by their paths."""
    for folder in sorted({"/".join(path.split("/")[: 3 if path.startswith("include/") else 2]) for path in files}):
        name = folder.split("/")[-1]
        if folder in files:
            yield f"{folder}: lies in no module"
        elif name not in floor:
            yield f"{folder}: is no module of a known floor"
    all_uses, meaning = set(), {}
    for path, text in sorted(files.items()):
        own = path.removeprefix("src/").removesuffix(".cpp") + ".hpp"
        own_header = f"<granum/{own}>" if path.endswith(".cpp") and f"include/granum/{own}" in files else None
        found, uses, types = look_at(path, text, own_header)
        yield from (f"{path}: {one}" for one in found)
        all_uses |= uses
        for name, namespace in types:
            if meaning.setdefault(name, namespace) != namespace:
                yield f"{path}: defines {name}, which {meaning[name]} defines as well; a public name has one meaning"
    # Rooms that include no room any more are taken away until none goes; what is left goes round in a circle.
    while all_uses != (left := {use for use in all_uses if use[1] in {user for user, _ in all_uses}}):
        all_uses = left
    if all_uses:
        yield "rooms: include one another in a circle: " + ", ".join(f"{a}>{b}" for a, b in sorted(all_uses))


def read(root):
    return {str(path.relative_to(root)): path.read_text() for folder in ("include/granum", "src") for path in (root / folder).rglob("*")
            if path.suffix in (".hpp", ".cpp")}


def planted(files):
    """What the table planted.txt demands and does not get."""
    for row in pathlib.Path(__file__).with_name("planted.txt").read_text().splitlines():
        if row.startswith("#"):
            continue
        paths, texts, expected = row.split(" | ")
        for path, text in itertools.product(paths.split(" || "), texts.split(" || ")):
            said = list(violations({**files, path: text.replace("\\n", "\n") + "\n"}))
            of_it = (f"{path}:", path.rpartition("/")[0] + ":", "rooms:")
            if said if expected == "-" else not any(one.startswith(of_it) and expected in one for one in said):
                yield f"{path}: {text}: expected {expected}, found {said}"


sources = read(pathlib.Path(sys.argv[1]))
wrong = list(planted(sources) if sys.argv[2:] == ["planted"] else violations(sources))
print("\n".join(wrong) or f"{len(sources)} files keep their floors")
sys.exit(bool(wrong) or not sources)
