# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the notebooks of this folder without a server: all of them, or those that are named.

    PYTHONPATH=build/python python3 examples/notebooks/run.py --check   # do they print what they hold?
    PYTHONPATH=build/python python3 examples/notebooks/run.py --write   # puts what they print into them

Their pictures are not kept: the site draws them (docs/site/notebook_pages.py).
"""

from __future__ import annotations

import base64
import contextlib
import io
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = pathlib.Path(__file__).resolve().parent


def pictures():
    """The open figures as PNG in base64, and closes them."""
    out = []
    for number in plt.get_fignums():
        memory = io.BytesIO()
        plt.figure(number).savefig(memory, format="png", dpi=60, bbox_inches="tight", metadata={"Software": None})
        out.append(base64.b64encode(memory.getvalue()).decode())
    plt.close("all")
    return out


def outputs(source, names):
    """What a cell prints and draws, as a notebook holds it."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        exec(compile(source, "cell", "exec"), names)
    found = []
    if said.getvalue():
        lines = said.getvalue().splitlines(keepends=True)
        found.append({"name": "stdout", "output_type": "stream", "text": lines})
    for picture in pictures():
        found.append({"data": {"image/png": picture}, "metadata": {}, "output_type": "display_data"})
    return found


def printed(cell_outputs):
    return "".join("".join(output["text"]) for output in cell_outputs if output["output_type"] == "stream")


def executed(path):
    """The notebook with all that its cells print and draw, each run after the one before."""
    notebook = json.loads(path.read_text())
    names = {"__name__": "__main__"}
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    for number, cell in enumerate(cells, 1):
        cell["outputs"], cell["execution_count"] = outputs("".join(cell["source"]), names), number
    return notebook


def run(path, write):
    """Runs one notebook. Returns what differs from what it holds."""
    held, found = json.loads(path.read_text()), executed(path)
    if write:
        for cell in found["cells"]:
            if cell["cell_type"] == "code":
                cell["outputs"] = [output for output in cell["outputs"] if output["output_type"] == "stream"]
        path.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n")
        return []
    return [
        f"{path.name}, cell {new['execution_count']} prints\n{printed(new['outputs'])}where it holds\n"
        f"{printed(old['outputs'])}"
        for old, new in zip(held["cells"], found["cells"])
        if old["cell_type"] == "code" and printed(old["outputs"]) != printed(new["outputs"])
    ]


def main(arguments):
    if not arguments or arguments[0] not in ("--check", "--write"):
        print(__doc__)
        return 2
    paths = [pathlib.Path(name) for name in arguments[1:]] or sorted(FOLDER.glob("*.ipynb"))
    faults = [fault for path in paths for fault in run(path, arguments[0] == "--write")]
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
