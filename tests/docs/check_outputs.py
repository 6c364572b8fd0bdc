#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does granum print what pages show below its commands?

    check_outputs.py <granum> <page>...     from the root of the sources

Each block of shell that is followed by a block of output is run, but for commands that simulate. Lines may be left out by "..."
and differ in spaces. Exit code 1 if a line is not printed; it and the nearest printed line are listed.
"""

import difflib
import re
import shlex
import subprocess
import sys
import tempfile

SIMULATE = {"verify", "reproduce", "trade"}
FILES = {"--out", "--picture", "--report", "--paraview"}  # are written to a temporary folder


def commands(block):
    """Arguments of each line that runs granum."""
    for line in block.replace("\\\n", " ").splitlines():
        words = line.split("#")[0].split()
        if words and words[0].rpartition("/")[2] == "granum" and words[1] not in SIMULATE:
            yield line.split("#")[0].strip().partition(" ")[2]


def printed(program, arguments, folder):
    for option in FILES:
        arguments = re.sub(rf"{option} (\S+)", rf"{option} {folder}/\1", arguments)
    # A shell, since pages use its patterns of file names.
    run = subprocess.run(f"{shlex.quote(program)} {arguments}", shell=True, capture_output=True, text=True)
    return run.stdout + run.stderr


def faults(program, page):
    found, looked_for = [], 0
    with open(page, encoding="utf-8") as file:
        blocks = re.findall(r"^( *)```(\w*)\n(.*?)^\1```$", file.read(), re.S | re.M)
    for (_, kind, shell), (_, none, output) in zip(blocks, blocks[1:]):
        if kind != "sh" or none:
            continue
        with tempfile.TemporaryDirectory() as folder:
            lines = [" ".join(line.split()) for arguments in commands(shell) for line in printed(program, arguments, folder).splitlines()]
        if not lines:
            continue
        for line in (" ".join(line.split()) for line in output.splitlines()):
            if line in ("", "..."):
                continue
            looked_for += 1
            if line not in lines:
                nearest = difflib.get_close_matches(line, lines, 1, 0)
                found.append(f"{page}: {line}\n  printed: {nearest[0] if nearest else 'nothing'}")
    return found, looked_for


program, pages = sys.argv[1], sys.argv[2:]
results = [faults(program, page) for page in pages]
print("\n".join(fault for found, _ in results for fault in found))
count = sum(looked_for for _, looked_for in results)
print(f"{count} lines of {len(pages)} pages")
sys.exit(1 if count == 0 or any(found for found, _ in results) else 0)
