# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/additions.md is true: its changes are made in a copy of the sources, which is built, and its commands print what it says.

    follow_additions.py places <source tree>                # finds the places of all changes; makes nothing
    follow_additions.py follow <source tree> <scratch> [<argument of cmake>...]

Files, changes, commands and outputs are taken from the page. Lines of an output have to be among those that the commands
above it print, in this order; a line "..." is any number of lines. Exit code 1 if a place is not there once, the program
does not build, or a line is not printed.
"""

import pathlib
import re
import shutil
import subprocess
import sys

PAGE = "docs/additions.md"
BUILD = "build/dev"
LICENCE = "SPDX-License-" + "Identifier: GPL-3.0-or-later"
LEFT_OUT = shutil.ignore_patterns("build", ".git", "node_modules", "__pycache__", "Testing", "*.csv", "*.ipynb")


class Wrong(Exception):
    """What of the page is not true."""


def blocks_of(page):
    """Pairs of a language and the lines of a block."""
    found = re.findall(r"^```(\w+)\n(.*?)^```$", page, re.S | re.M)
    return [(language, text.splitlines()) for language, text in found]


def changed(path, lines, hunk):
    """The lines of a file after a change."""
    old = [line[1:] for line in hunk if line[:1] in ("", " ", "-")]
    new = [line[1:] for line in hunk if line[:1] in ("", " ", "+")]
    places = [k for k in range(len(lines) - len(old) + 1) if lines[k : k + len(old)] == old]
    if not old or len(places) != 1:
        raise Wrong(f"{path}: the place of a change occurs {len(places)} times:\n" + "\n".join(old))
    return lines[: places[0]] + new + lines[places[0] + len(old) :]


def files_after(root, blocks):
    """New and changed files by their paths, as lists of lines."""
    files = {}
    for language, lines in blocks:
        if language == "cpp":
            path = lines[0].removeprefix("// ")
            if not re.fullmatch(r"[\w./]+\.[ch]pp", path) or (root / path).exists():
                raise Wrong(f"{PAGE}: a block of C++ begins with the name of a new file, not '{lines[0]}'")
            files[path] = [f"// {LICENCE}", *lines[1:]]
        elif language == "diff":
            path = lines[0].removeprefix("+++ ")
            if path not in files:
                files[path] = (root / path).read_text().splitlines()
            hunk = []
            for line in [*lines[1:], "@@"]:
                if line == "@@":
                    files[path] = changed(path, files[path], hunk)
                    hunk = []
                else:
                    hunk.append(line)
    if not files:
        raise Wrong(f"{PAGE} changes nothing")
    return files


def run(scratch, script):
    """What a script of bash prints."""
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", script], cwd=scratch, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    )
    if done.returncode:
        raise Wrong(f"exit code {done.returncode} of\n{script}\n{done.stdout[-8000:]}")
    return done.stdout.splitlines()


def compare(script, printed, expected):
    at = 0
    for line in expected:
        if line.strip() == "...":
            continue
        rest = [shown.rstrip() for shown in printed[at:]]
        if line.rstrip() not in rest:
            raise Wrong(f"not printed, or not there: '{line}'; by\n{script}\nwhich prints\n" + "\n".join(printed))
        at += rest.index(line.rstrip()) + 1


def follow(root, scratch, arguments):
    blocks = blocks_of((root / PAGE).read_text())
    shutil.rmtree(scratch, ignore_errors=True)
    shutil.copytree(root, scratch, ignore=LEFT_OUT, symlinks=True)
    for path, lines in files_after(root, blocks).items():
        (scratch / path).parent.mkdir(parents=True, exist_ok=True)
        (scratch / path).write_text("\n".join(lines) + "\n")
    commands = [(k, "\n".join(lines)) for k, (language, lines) in enumerate(blocks) if language == "sh"]
    first, build = commands[0]
    if f"cmake --build {BUILD}" not in build:
        raise Wrong(f"{PAGE}: the first commands do not build {BUILD}")
    build = build.replace("cmake --preset dev", f"cmake --preset dev {' '.join(arguments)}")
    run(scratch, build)
    for k, script in commands[1:]:
        if blocks[k + 1][0] != "text":
            raise Wrong(f"{PAGE}: it is not said what is printed by\n{script}")
        compare(script, run(scratch, script), blocks[k + 1][1])
    return len(commands) - 1


def main():
    what, root = sys.argv[1], pathlib.Path(sys.argv[2])
    try:
        if what == "places":
            print(len(files_after(root, blocks_of((root / PAGE).read_text()))), "files are new or changed")
        else:
            print(follow(root, pathlib.Path(sys.argv[3]), sys.argv[4:]), "blocks of commands print what they should")
    except Wrong as error:
        sys.exit(f"{PAGE}: {error}")


main()
