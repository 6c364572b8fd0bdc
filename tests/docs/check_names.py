#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every name in backticks in README.md and docs/*.md exists:  check_names.py <source tree> <granum> [planted]

Paths are in the tree, identifiers and namespaces in the headers, commands and options in the program's help, keys in
examples/scene.toml, libraries and presets in the build. So are the commands, options, keys and paths of the program in blocks of
shell, and cases in quotes behind the path of their test. Names that are nowhere in the tree, such as other people's commands:
other_names.txt, each with its reason. With "planted", proves that it can fail.
"""

import functools
import pathlib
import re
import shlex
import subprocess
import sys

ROOT, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]
WORD = "[A-Za-z_][A-Za-z0-9_]*"


def texts(*patterns):
    return "\n".join(path.read_text() for pattern in patterns for path in sorted(ROOT.glob(pattern)) if path.is_file())


# ---- what there is
headers = [path.read_text() for path in (ROOT / "include/granum").rglob("*.hpp")]
words = [set(re.findall(WORD, text)) for text in headers]
scopes = [{scope.split("::")[-1] for scope in re.findall("(?:struct|class|namespace) ([A-Za-z_:]+)", text)} for text in headers]
build = texts("CMakeLists.txt", "CMakePresets.json", "cmake/*.cmake",
              *(f"{folder}/**/CMakeLists.txt" for folder in "src tests examples validation bench docs python".split()))
source = texts("src/**/*.cpp", "src/**/*.hpp")
python_names = set(re.findall(WORD, texts("python/granum/*.py", "python/src/*.cpp")))
keys, section = set(), ""
for row in (ROOT / "examples/scene.toml").read_text().splitlines():
    if found := re.match(r"\[([a-z_]+)]", row):
        section = found[1]
        keys.add(section)
    elif found := re.match("([a-z_]+) *=", row):
        keys.add(f"{section}.{found[1]}")
other_names = {re.sub("  +#.*$", "", row) for row in pathlib.Path(__file__).with_name("other_names.txt").read_text().splitlines()
               if not row.startswith("#")}


@functools.cache
def help_of(*command):
    """What the program says to --help; nothing for an unknown command, whose help is that of the program."""
    run = subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True)
    return run.stdout if run.returncode == 0 and " ".join(["Usage: granum", *command, ""]) in run.stdout else ""


commands = re.findall("\n  ([a-z]+)", "\n" + help_of().split("Subcommands:\n")[-1])
every_help = help_of() + "".join(map(help_of, commands))


# ---- whether a name is one of them
def identifier_exists(name):
    """a::b::c, or a word, in the headers."""
    *outer, last = name.removesuffix("()").removeprefix("granum::").split("::")
    if not outer:
        return any(last in of_header for of_header in words) or (ROOT / "include/granum" / last).exists()
    return any(outer[-1] in declared and last in of_header for declared, of_header in zip(scopes, words))


def command_exists(line):
    """`granum <command> --option ...` with options that the command has, and keys of scenes."""
    arguments, command = shlex.split(line)[1:], []
    for argument in arguments:
        if not re.fullmatch("[a-z]+", argument) or not help_of(*command, argument):
            break
        command.append(argument)
    if re.fullmatch("[a-z]+", arguments[0]) and not command:
        return False
    text = help_of(*command)
    for before, argument in zip(["", *arguments], arguments):
        if option := re.match("--[a-z-]+", argument):
            if option[0] not in text:
                return False
        elif before == "--set" and argument.split("=")[0] not in keys | {"key"}:
            return False
    return True


def name_exists(name):
    path = name.removeprefix("./")
    if name in other_names | keys | set(commands) or re.fullmatch("[0-9.]+(kPa|MPa|GPa|Pa|mm|um|m|deg|%|s)?", name):
        return True
    if (ROOT / path).exists() or (ROOT / "include/granum" / path).exists():
        return True
    if re.match("granum( |$)", name):
        return command_exists(name + " --help")
    if found := re.fullmatch(rf"granum\.({WORD})", name):
        return found[1] in python_names
    if found := re.match("--[a-z-]+", name):
        return found[0] in every_help
    if found := re.fullmatch("granum::([a-z]+)", name):  # a library or a namespace
        return bool(re.search(rf"set\(granum_{found[1]}_needs[ )]", build)) or (ROOT / "include/granum" / found[1]).exists()
    if re.fullmatch(rf"({WORD}::)*~?{WORD}(\(\))?", name):
        preset_or_target = rf'"{re.escape(name)}"|(add_custom_target|granum_program|set)\({re.escape(name)}[ )]'
        return identifier_exists(name) or bool(re.search(preset_or_target, build) or re.search(rf"[^A-Za-z_]{re.escape(name)}\(", source))
    if found := re.fullmatch(r"(.*/)?([A-Za-z0-9_]*\.[a-z]+)", name):  # a file that the program writes, or a file's ending
        return found[2] in source
    return f'"{name}"' in build  # a test


def faults(page, text):
    """What of a page does not exist, and how many names were looked for."""
    found, checked, fenced = [], 0, False
    for line in text.replace("\\\n", " ").replace("\\", "/").splitlines():
        names = []
        if re.match(" *```", line):
            fenced = not fenced
        elif fenced or line.startswith("    "):
            line = re.sub("  +#.*$", "", line)
            names = re.findall(r"^ *(?:build/release/)?(granum [a-z].*)$", line) or re.findall(
                r"^ *(\./[a-z]+\.sh|(?:scripts|bench|tests|share)/[A-Za-z0-9_./]+)(?: |$)", line)
        else:
            names = re.findall("`([^`]+)`", line)
            for path, case in re.findall(r'`(tests/[^`]+\.cpp)` ("[^"]+")', line):
                if f"TEST_CASE({case})" not in (ROOT / path).read_text():
                    found.append(f"{page}: {path} has no case {case}")
        checked += len(names)
        found += [f"{page}: `{name}` does not exist" for name in names if not name_exists(name)]
    return found, checked


def planted():
    """Faults that are not found, and names that are refused without cause."""
    wrong = ["tests/nowhere/test_nothing.cpp", "effective::uniform_wish", "PowerLaw::colour", "Unimaginable", "granum::everything",
             "granum.dream", "granum divine", "granum estimate --colour red", "--colour", "study.colour",
             "granum verify --set grain.colour=red", "nothing.xyz"]
    block = "```sh\ngranum estimate \\\n  --colour red\nscripts/nothing.sh\n```\n"
    case = '`tests/core/test_number.cpp` "a number is a colour"\n'
    right = "`README.md` `effective::uniform_strain` `granum.measure` `granum verify --set study.grains=300` `--json` `study.grains` `100kPa`"
    for text, number in ("".join(f"It names `{name}`.\n" for name in wrong), len(wrong)), (block, 2), (case, 1), (right, 0):
        if len(found := faults("page", text)[0]) != number:
            yield f"{len(found)} faults instead of {number} in:\n{text}{found}"


if sys.argv[3:] == ["planted"]:
    missing, checked = list(planted()), 1
else:
    of_pages = [faults(page.relative_to(ROOT), page.read_text()) for page in [ROOT / "README.md", *sorted(ROOT.glob("docs/*.md"))]]
    missing, checked = [one for found, _ in of_pages for one in found], sum(count for _, count in of_pages)
print("\n".join(missing) or f"{checked} names exist")
sys.exit(bool(missing) or checked == 0)
