# SPDX-License-Identifier: GPL-3.0-or-later
"""The gallery of the site: what each command draws or prints, with the line that makes it.

    python3 docs/site/gallery.py <source tree> <program> <page> <folder of pictures>

gallery.txt holds the lines. Fails if a command fails, a picture is missing, or a command of the program is not shown.
"""

import glob
import html
import pathlib
import re
import shlex
import shutil
import subprocess
import sys


def entries(text):
    """Title, command, kept pictures or drawn ones of each entry."""
    for block in text.split("\n== ")[1:]:
        title, *lines = block.strip().splitlines()
        sign, _, pictures = (lines[1] if len(lines) > 1 else "").partition(" ")
        yield title, lines[0], sign, pictures.split()


def run(program, line, folder):
    """What the command prints. Exit code 1 is a finding that differs from the paper's."""
    named = [sorted(glob.glob(word, root_dir=folder)) or [word] for word in shlex.split(line)[1:]]
    words = [program, *(word for words in named for word in words)]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"docs/site/gallery.txt: {line}\n{done.stderr}")
    return done.stdout


def commands_of(program):
    """The names of the program's commands, as its help lists them."""
    text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    return re.findall(r"^  ([a-z]\w+) {2,}", text.partition("\nOptions:")[0], re.M)


def write(root, program, page, pictures):
    shutil.rmtree(pictures, ignore_errors=True)
    pictures.mkdir(parents=True)
    for name in ("examples", "tests"):
        (pictures / name).symlink_to(root / name)
    text = (root / "docs" / "site" / "gallery.txt").read_text()
    lines = ["# Gallery {#gallery}", "", text.split("\n== ")[0], ""]
    shown = set()
    for title, line, sign, wanted in entries(text):
        shown.add(title.split(":")[0])
        lines += [f"## {title}", "", "```sh", line, "```", ""]
        if sign == "<-":
            for kept in wanted:
                for path in sorted(root.glob(kept)):
                    (pictures / "kept").mkdir(exist_ok=True)
                    shutil.copy(path, pictures / "kept" / path.name)
            wanted = ["kept/" + pathlib.Path(kept).name for kept in wanted]
        else:
            said = run(program, line, pictures)
        found = [name for pattern in wanted for name in sorted(glob.glob(pattern, root_dir=pictures))]
        if len(found) < len(wanted):
            sys.exit(f"docs/site/gallery.txt: {title}: no picture {wanted}")
        lines += [f'<img src="gallery/{name}" alt="{html.escape(title)}"/>' for name in found]
        if not wanted:
            lines += ["```text", said.rstrip(), "```"]
        lines.append("")
    for name in ("examples", "tests"):
        (pictures / name).unlink()
    if missing := set(commands_of(program)) - shown:
        sys.exit(f"docs/site/gallery.txt: commands without a picture: {sorted(missing)}")
    lines += ["Notebooks draw with matplotlib: \\ref notebooks.", ""]
    page.write_text("\n".join(lines))


if __name__ == "__main__":
    root, program, page, pictures = (pathlib.Path(word).resolve() for word in sys.argv[1:5])
    write(root, str(program), page, pictures)
