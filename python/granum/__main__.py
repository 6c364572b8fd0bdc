# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m granum: what is installed; with arguments the program granum, where there is one."""

from __future__ import annotations

import os
import shutil
import sys

import granum


def main(arguments: list[str]) -> int:
    program = shutil.which("granum")
    if arguments and program:
        os.execv(program, [program, *arguments])
    if arguments:
        print("granum: error: the program granum is not on the PATH; the package alone has no commands", file=sys.stderr)
        return 2
    print(f"granum {granum.__version__}, {os.path.dirname(granum.__file__)}")
    print(f"program: {program or 'not on the PATH'}")
    print("help(granum.packing_answer) is a beginning: a modulus with its range")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
