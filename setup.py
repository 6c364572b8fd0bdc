# SPDX-License-Identifier: GPL-3.0-or-later
"""Hands the compiled part of the package to CMake; everything else stands in pyproject.toml.

What stands in the variable CMAKE_ARGS goes to CMake as well, as with other packages that CMake builds.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys

import setuptools
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parent


def version():
    """That of the library."""
    text = (SOURCE / "CMakeLists.txt").read_text()
    return re.search(r"project\(granum VERSION ([0-9.]+)", text).group(1)


def alone():
    """Waits until no other process builds in this folder; the lock ends with the process.

    Builds share the folder build: of two at a time each would delete what the other is about to copy.
    """
    try:
        import fcntl
    except ImportError:  # no POSIX: one at a time is up to the caller
        return None
    folder = SOURCE / "build"
    folder.mkdir(exist_ok=True)
    lock = (folder / "lock").open("w")
    fcntl.flock(lock, fcntl.LOCK_EX)
    return lock


def pybind11_folder():
    """Where pip's pybind11 keeps its files for CMake; none where CMake has to look for the system's."""
    try:
        import pybind11
    except ImportError:
        return {}
    return {"pybind11_DIR": pybind11.get_cmake_dir()}


class CMakeBuild(build_ext):
    """Builds the module by the project's own CMakeLists, for this interpreter."""

    def build_extension(self, ext):
        module = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        tree = pathlib.Path(self.build_temp).resolve()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "GRANUM_UNITY_BUILD": "ON",
            "GRANUM_BUILD_PYTHON": "ON",
            "GRANUM_BUILD_CLI": "OFF",
            "GRANUM_BUILD_TESTS": "OFF",
            "GRANUM_BUILD_EXAMPLES": "OFF",
            "GRANUM_BUILD_DOCS": "OFF",
            "GRANUM_INSTALL": "OFF",
            "GRANUM_PYTHON": sys.executable,
            "GRANUM_PYTHON_FOLDER": module.parent.parent,
            **pybind11_folder(),
        }
        configure = ["cmake", "-S", SOURCE, "-B", tree, "-G", "Ninja"]
        configure += [f"-D{name}={value}" for name, value in options.items()]
        configure += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.run(configure, check=True)
        subprocess.run(["cmake", "--build", tree, "--target", "granum_python_stub"], check=True)


def licence():
    """By PEP 639 where setuptools knows it, and by the older field where it does not."""
    key = "license_expression" if int(setuptools.__version__.split(".")[0]) >= 77 else "license"
    return {key: "GPL-3.0-or-later"}


LOCK = alone()
setup(
    version=version(),
    **licence(),
    ext_modules=[Extension("granum._granum", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
