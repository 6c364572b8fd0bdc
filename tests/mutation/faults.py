#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Planted faults: how many of them the tests catch.

faults.tsv lists small faults, one a line of the sources: module, file, number of the operator's place in the line,
operator, the line itself, and the reason if the fault changes nothing (then it does not count). All are compiled into
one copy of the project, each asleep until the environment variable GRANUM_FAULT has its number (fault.hpp).

  faults.py choose   a new list: places at random, spread over the modules by their lines
  faults.py plant    the copy, with all faults of the list
  faults.py build    builds it; faults that do not compile are marked
  faults.py run      each fault against the tests of its module, then the unit tests of others; what survives is printed
"""
import argparse
import collections
import csv
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LIST = pathlib.Path(__file__).with_name("faults.tsv")
uncompilable = "does not compile"  # instead of a reason: these keep their numbers while a copy is in use
FIELDS = ["module", "file", "place", "operator", "line", "harmless"]

NUMBER = r"(?<![\w.\"'])(\d+\.\d*(?:e-?\d+)?|\d+e-?\d+|\d+)(?![\w.\"'])"


def other_constant(kind, value, n):
    """As fault.hpp's number, but not known when it is compiled, where a constant would stay as it is."""
    other = value + " + 1" if kind != "double" or float(value) == 0 else "1.25 * " + value
    return f"(granum::planted::awake() == {n} ? {kind}({other}) : {kind}({value}))"


# Operator: pattern of its places in a line whose comments and strings are blank, and what is written there.
OPERATORS = {
    "sign": (re.compile(r" [-+] (?=[\w(])"), lambda m, n: f"{m[0]}granum::planted::sign({n}) * "),
    "left out": (re.compile(r" [-+] (?=[\w(])"), lambda m, n: f"{m[0]}granum::planted::part({n}) * "),
    "factor": (re.compile(r"(?<=[\w)] [*/] )" + NUMBER + "|" + NUMBER + r"(?= [*/] )"),
               lambda m, n: f"granum::planted::number({n}, {m[0]})"),
    "bound": (re.compile(r"(?<=[\w)\]] )(?:[<>]=?|==) " + NUMBER),
              lambda m, n: m[0].replace(m[1], f"granum::planted::number({n}, {m[1]})")),
    "constant": (re.compile(r"\bconstexpr (double|int|std::size_t) (\w+) = " + NUMBER),
                 lambda m, n: f"const {m[1]} {m[2]} = {other_constant(m[1], m[3], n)}"),
    "index": (re.compile(r"(?<=\[)\d(?=\])"), lambda m, n: f"granum::planted::index({n}, {m[0]})"),
    "unit": (re.compile(r"(?<![\w.])1e-?[369]\b"), lambda m, n: f"granum::planted::unit({n}, {m[0]})"),
    "condition": (re.compile(r"(?<=\bif \()[^;]+(?=\)( \{| [\w].*;)?$)|(?<=\breturn )[^?;]+(?= \? )"),
                  lambda m, n: f"granum::planted::flip({n}) != bool({m[0]})"),
    "extreme": (re.compile(r"\bstd::(max|min)\((?!\{)"),
                lambda m, n: f"granum::planted::{'larger' if m[1] == 'max' else 'smaller'}({n}, "),
}
SKIPPED = re.compile(r"constexpr(?! (double|int|std::size_t) \w+ =)|static_assert|template|\bcase\b|\benum\b|\busing\b|^\s*#|\bwhile\b|operator|\bfor \(")


def code_of(text):
    """Lines with comments, strings and characters blank, of the same lengths."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text).split("\n")


def sources():
    """Module and path of every source."""
    tracked = subprocess.run(["git", "ls-files", "src", "include"], cwd=SOURCE, check=True, capture_output=True,
                             text=True).stdout.split()
    for name in tracked:
        parts = pathlib.PurePath(name).parts
        if name.endswith((".cpp", ".hpp")) and "coefficients" not in name:
            inner = parts[1:-1] if parts[0] == "src" else parts[2:-1]
            yield "/".join(inner[:2] if inner and inner[0] in ("cli", "studies", "io") else inner[:1]) or "main", name


def places(line):
    return [(place, name) for name, (pattern, _) in OPERATORS.items() for place, found in enumerate(pattern.finditer(line))
            if found[0].count("(") == found[0].count(")") or name != "condition"]  # (a ? b : c) * d is no condition


def choose(options):
    """One fault at most a line; as many a module as it has lines with places."""
    chance = random.Random(options.seed)
    found = collections.defaultdict(list)
    for module, name in sources():
        text = (SOURCE / name).read_text()
        lines = text.split("\n")
        alone = collections.Counter(map(str.strip, lines))
        for code, line in zip(code_of(text), lines):
            if SKIPPED.search(code) or alone[line.strip()] > 1:
                continue
            here = places(code)
            if {name for _, name in here} == {"condition"} and chance.random() > options.conditions:
                continue  # most lines with places have no other
            if here:
                operator = chance.choice(sorted({name for _, name in here}))
                place = chance.choice([place for place, name in here if name == operator])
                found[module].append([module, name, place, operator, line.strip(), ""])
    total = sum(map(len, found.values()))
    rows = []
    for module, all_of in sorted(found.items()):
        rows += chance.sample(all_of, max(1, round(options.number * len(all_of) / total)))
    write(rows)


def write(rows):
    with LIST.open("w", newline="") as file:
        out = csv.writer(file, delimiter="\t", lineterminator="\n")
        out.writerow(FIELDS)
        out.writerows(sorted(rows, key=lambda r: (r[0], r[1], r[4])))


def faults():
    """Rows of the list with their numbers, from 1."""
    with LIST.open(newline="") as file:
        return {k: row for k, row in enumerate(csv.reader(file, delimiter="\t")) if k > 0}


def plant(options):
    """Returns the file and the number of the line of each fault; writes files that changed alone."""
    at, stale = {}, []
    tracked = subprocess.run(["git", "ls-files"], cwd=SOURCE, check=True, capture_output=True, text=True).stdout
    texts = {name: None for name in tracked.split("\n") if name}
    for number, (_, name, place, operator, line, harmless) in faults().items():
        if harmless == uncompilable:
            continue
        text = texts.get(name) or ((SOURCE / name).read_text() if name in texts else "")
        lines = text.split("\n")
        where = [k for k, one in enumerate(lines) if one.strip() == line]
        match = None
        if len(where) == 1:
            code = code_of(text)[where[0]]
            match = next((m for k, m in enumerate(OPERATORS[operator][0].finditer(code)) if k == int(place)), None)
        if match is None:
            stale.append(f"{name}: {line}")
            continue
        old = lines[where[0]]
        real = OPERATORS[operator][0].pattern and old[match.start():match.end()]
        written = OPERATORS[operator][1](_Real(match, real), number)
        lines[where[0]] = old[:match.start()] + written + old[match.end():]
        texts[name] = "\n".join(lines)
        at[number] = (name, where[0] + 1)
    for name, text in texts.items():
        target = options.copy / name
        content = text.encode() if text is not None else (SOURCE / name).read_bytes()
        if not target.exists() or target.read_bytes() != content:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
            shutil.copymode(SOURCE / name, target)
    for line in stale:
        print("no longer there:", line)
    return at


class _Real:
    """A match whose text is that of the source, with its strings."""

    def __init__(self, match, text):
        self.match, self.text = match, text

    def __getitem__(self, group):
        return self.text if group == 0 else self.match[group]


def build(options):
    """Until it builds: faults in lines that do not compile are marked."""
    tree = options.copy / "build"
    while True:
        at = plant(options)
        if not (tree / "build.ninja").exists():
            subprocess.run(["cmake", "-S", options.copy, "-B", tree, "-G", "Ninja", *options.define,
                            f"-DCMAKE_CXX_FLAGS=-include {SOURCE}/tests/mutation/fault.hpp -w"], check=True)
        done = subprocess.run(["cmake", "--build", tree, "--", "-k", "0", f"-j{options.jobs}", *options.targets],
                              capture_output=True, text=True)
        if done.returncode == 0:
            return
        drop = set()
        for kind in "error|  +required", "note":  # notes name the constant that another line needs
            wrong = {(pathlib.Path(os.path.relpath(m[1], options.copy)).as_posix(), int(m[2]))
                     for m in re.finditer(rf"(/\S+?):(\d+):\d+: (?:{kind})", done.stdout)}
            drop = drop or {number for number, place in at.items() if place in wrong}
        if not drop:
            sys.exit(done.stdout[-8000:])
        print(f"{len(drop)} faults do not compile", flush=True)
        write([row[:5] + [uncompilable if number in drop else row[5]] for number, row in faults().items()])


def seconds(command, number, longest):
    """How long a test command takes that passes with the fault; none if it fails."""
    start = time.monotonic()
    try:
        code = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=longest,
                              cwd=pathlib.Path(command[0]).parent,
                              env={**os.environ, "GRANUM_FAULT": str(number)}).returncode
    except subprocess.TimeoutExpired:
        return None
    return time.monotonic() - start if code == 0 else None


def commands(options):
    """Test programs by module; the runs of the program granum, in one, are "runs"."""
    tree = options.copy / "build"
    found = {p.name[len("test_"):]: [p, "--abort-after=1"] for p in sorted((tree / "tests").glob("*/test_*"))
             if os.access(p, os.X_OK) and p.is_file()}
    if (tree / "granum").exists():
        found["runs"] = [shutil.which("ctest"), "--test-dir", tree, "-L", "^cli$", "-LE", "slow", "--stop-on-failure",
                         f"-j{os.cpu_count()}"]
    return found


# Of a room of the program, the tests of its runs; of others the table with its name.
RUNS = {"analyse": "rows, analyse|packing_files", "document": "rows, (answer|estimate|export|sands)|sand_pictures",
        "frame": "rows, (program|sweep|fit|people)|screens", "sweep": "rows, (sweep|depth|curves)|written_tables",
        "estimate": "rows, (answer|estimate|sands)|answers", "options": "rows, (people|units|scene|sands)|columns",
        "export": "studies|screens", "infer": "rows, infer|columns|written_tables", "plan": "rows, verify",
        "reference": "screens", "trade": "rows, trade|studies"}
RUNS["all"] = "|".join([*RUNS.values(), "rows, (reproduce|verify)"])


def with_test(command, name, row):
    """A test command for a fault."""
    room = row[0].split("/")[-1]
    tests = RUNS.get(room, f"rows, {room}")
    return [*command, "-R", f"^cli: test_({tests})$"] if name == "runs" else command


def own_tests(row):
    """Of the module of a fault."""
    own = row[0].split("/")[0]
    return {"cli": ["document", "runs"], "studies": ["studies", "document"]}.get(own, [own])


def run(options):
    """What catches each fault, in the file of results; what is there is not run again."""
    tests = commands(options)
    wanted = set(tests)
    if options.own:
        wanted = {own for row in faults().values() if row[0].startswith(options.module) for own in own_tests(row)}
    times = options.results.with_suffix(".json")  # of programs without a fault; measured again where they are newer
    known = json.loads(times.read_text()) if times.exists() else {}
    healthy = {}
    for name in sorted(wanted & set(tests)):
        program = options.copy / "build/granum" if name == "runs" else pathlib.Path(tests[name][0])
        built = program.stat().st_mtime
        if known.get(name, [0, 0])[0] != built:
            known[name] = [built, seconds(with_test(tests[name], name, ["cli/all"]), 0, 2000)]
            times.write_text(json.dumps(known))
        if known[name][1] is None:
            print("fails without a fault, not used:", name)
        else:
            healthy[name] = known[name][1]
    print("seconds without a fault:", {name: round(one, 1) for name, one in healthy.items()}, flush=True)
    done = {}
    if options.results.exists():
        done = {tuple(row[:5]): row[5] for row in csv.reader(options.results.open(newline=""), delimiter="\t")}

    def judge(item):
        number, row = item
        key = tuple(row[:5])
        order = [name for name in own_tests(row) if name in healthy]
        if row[5] or not order or not row[0].startswith(options.module) or (key in done and not (options.again and done[key] == "-")):
            return
        if not options.own:
            order += [name for name in sorted(healthy, key=healthy.get)
                      if name not in order and name != "runs" and healthy[name] <= options.longest]
        by = next((name for name in order
                   if seconds(with_test(tests[name], name, row), number, 20 + 4 * healthy[name]) is None), "-")
        with options.results.open("a", newline="") as file:
            csv.writer(file, delimiter="\t", lineterminator="\n").writerow([*key, by])
        done[key] = by

    with ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(judge, faults().items()))
    counted = [(row, done.get(tuple(row[:5]), "-")) for row in faults().values() if not row[5]]
    for row, by in counted:
        if by == "-":
            print(f"survives: {row[1]} ({row[3]} {row[2]}): {row[4]}")
    of_module = collections.Counter(row[0] for row, _ in counted)
    for module, all_of in sorted(of_module.items()):
        print(f"{module}: {sum(by != '-' for row, by in counted if row[0] == module)} of {all_of} caught")
    print(f"{sum(by != '-' for _, by in counted)} of {len(counted)} caught")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("step", choices=["choose", "plant", "build", "run"])
    parser.add_argument("--copy", type=pathlib.Path, default=SOURCE / "build/planted")
    parser.add_argument("--number", type=int, default=400, help="of faults to choose")
    parser.add_argument("--conditions", type=float, default=0.3, help="share of lines with a condition alone")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--define", action="append", default=[], help="passed to cmake, such as -DNAME=VALUE")
    parser.add_argument("--targets", nargs="*", default=[])
    parser.add_argument("--longest", type=float, default=1e9, help="seconds of a test program of another module")
    parser.add_argument("--own", action="store_true", help="the tests of the fault's module alone")
    parser.add_argument("--module", default="", help="whose faults are run, by the first letters of its name")
    parser.add_argument("--again", action="store_true", help="what survived is run again")
    parser.add_argument("--results", type=pathlib.Path, default=SOURCE / "build/planted/results.tsv")
    options = parser.parse_args()
    {"choose": choose, "plant": plant, "build": build, "run": run}[options.step](options)


if __name__ == "__main__":
    main()
