# SPDX-License-Identifier: GPL-3.0-or-later
"""Several builds of one source folder at a time do not disturb each other. CMake, which takes minutes, is played."""

import os
import shutil
import subprocess
import sys
import zipfile

import pytest

pytest.importorskip("wheel")

CMAKE = """#!{python}
import pathlib, sys, time
words = sys.argv[1:]
if words[0] == "--build":
    folder = pathlib.Path((pathlib.Path(words[1]) / "folder").read_text()) / "granum"
    time.sleep(0.3)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "_granum.{suffix}").write_bytes(bytes(1_000_000))
else:
    tree = pathlib.Path(words[words.index("-B") + 1])
    tree.mkdir(parents=True, exist_ok=True)
    key = "-DGRANUM_PYTHON_FOLDER="
    (tree / "folder").write_text(next(word[len(key) :] for word in words if word.startswith(key)))
"""


def test_builds_wait_for_each_other(source, tmp_path):
    tree, tools = tmp_path / "tree", tmp_path / "tools"
    shutil.copytree(source / "python" / "granum", tree / "python" / "granum")
    for name in ("CMakeLists.txt", "setup.py", "pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(source / name, tree / name)
    tools.mkdir()
    cmake = tools / "cmake"
    cmake.write_text(CMAKE.format(python=sys.executable, suffix="so"))
    cmake.chmod(0o755)
    environment = {**os.environ, "PATH": f"{tools}:{os.environ['PATH']}"}
    builds = [
        subprocess.Popen(
            [sys.executable, "setup.py", "-q", "bdist_wheel", "-d", str(tmp_path / f"wheel{k}")],
            cwd=tree,
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        for k in range(3)
    ]
    said = [build.communicate()[0] for build in builds]
    for k, build in enumerate(builds):
        assert build.returncode == 0, said[k]
        (wheel,) = (tmp_path / f"wheel{k}").glob("granum-*.whl")
        assert "granum/_granum.so" in zipfile.ZipFile(wheel).namelist()
