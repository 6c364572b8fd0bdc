# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of the site out of notebooks, which are run: words, cells, what they print and draw.

    python3 docs/site/notebook_pages.py <source tree> <folder of pages> <folder of pictures>

Tested by python/tests/test_documentation.py; that notebooks print what they hold by test_plots.py.
"""

import base64
import pathlib
import runpy
import sys


def outputs(cell, stem, pictures, count):
    """Lines of a cell's output; its pictures are written as files."""
    lines = []
    for output in cell["outputs"]:
        if output["output_type"] == "stream":
            lines += ["```text", "".join(output["text"]).rstrip(), "```", ""]
        elif "image/png" in output.get("data", {}):
            count[0] += 1
            name = f"{stem}_{count[0]}.png"
            (pictures / name).write_bytes(base64.b64decode(output["data"]["image/png"]))
            lines += [f'<img src="notebooks/{name}" alt="picture {count[0]} of the notebook"/>', ""]
    return lines


def write(root, folder, pictures):
    pictures.mkdir(parents=True, exist_ok=True)
    folder.mkdir(parents=True, exist_ok=True)
    executed = runpy.run_path(str(root / "examples" / "notebooks" / "run.py"))["executed"]
    index = ["# Notebooks {#notebooks}", "", "Jupyter opens them from the folder `examples/notebooks`.", ""]
    for path in sorted((root / "examples" / "notebooks").glob("*.ipynb")):
        label, count, lines = f"notebook_{path.stem}", [0], []
        for cell in executed(path)["cells"]:
            source = "".join(cell["source"])
            if cell["cell_type"] == "markdown":
                title, _, rest = source.partition("\n")
                head = f"{title} {{#{label}}}" if not lines and title.startswith("# ") else title
                lines += [head, rest, ""]
            else:
                lines += ["```py", source, "```", "", *outputs(cell, path.stem, pictures, count)]
        (folder / f"{label}.md").write_text("\n".join(lines))
        index.append(f"- \\subpage {label}")
    (folder / "notebooks.md").write_text("\n".join(index) + "\n")


if __name__ == "__main__":
    write(*map(pathlib.Path, sys.argv[1:4]))
