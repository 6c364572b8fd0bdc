# SPDX-License-Identifier: GPL-3.0-or-later
"""The version of CMakeLists.txt is that of the citation and of the newest heading of the changelog, which have one date, and of the
recipes in packaging/:  check_version.py <source tree> <x.y.z>"""

import pathlib
import re
import sys

root, version = pathlib.Path(sys.argv[1]), sys.argv[2]
newest = re.search("^## .*$", (root / "CHANGELOG.md").read_text(), re.M)[0]
date = re.fullmatch(rf"## {re.escape(version)} \((\d+-\d\d-\d\d|unreleased)\)", newest)
assert date, f"CHANGELOG.md begins with '{newest}', not with {version} and a date or the word unreleased"
citation = dict(re.findall("^([a-z-]+): (.*)$", (root / "CITATION.cff").read_text(), re.M))
assert citation["version"] == version, f"CITATION.cff has version {citation['version']}, CMakeLists.txt says {version}"
cited = citation.get("date-released", "unreleased")
assert cited == date[1], f"CITATION.cff was released: {cited}; CHANGELOG.md: {date[1]}"
for path, words in {"conda/meta.yaml": f'version: "{version}"', "vcpkg/vcpkg.json": f'"version": "{version}"',
                    "spack/package.py": f'version("{version}"'}.items():
    assert words in (root / "packaging" / path).read_text(), f"packaging/{path}: '{words}' is missing"
