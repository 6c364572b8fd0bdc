# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests of written files share: the files of a folder, rows of tables, texts of pictures."""
import csv
import re
import xml.etree.ElementTree

SVG = "{http://www.w3.org/2000/svg}"


def contents(folder):
    """The bytes of all files below a folder, by their paths in it."""
    return {str(file.relative_to(folder)): file.read_bytes() for file in sorted(folder.rglob("*")) if file.is_file()}


def names(folder):
    return sorted(file.name for file in folder.iterdir())


def rows(text):
    """The rows of a CSV by the headings of their columns, without its comments."""
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


def texts(svg):
    """All texts of a picture, which must be whole."""
    return ["".join(text.itertext()) for text in xml.etree.ElementTree.fromstring(svg).iter(SVG + "text")]


def without_times(text):
    """A text without what depends on the speed of the machine."""
    lines = [line for line in text.splitlines() if not re.search(r'seconds"|wall_time_s|^  time ', line)]
    return re.sub(r"[0-9.]+ s(<|,| on)", r"\1", "\n".join(lines))
