#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is installed is found, linked and used:  installed.py consumer|shared|package|wheel root=<source tree> scratch=<folder>
version=<x.y.z> [build=<build tree>] [cxx=<compiler>] [generator=<name>] [cmake=...] [cpack=...] [python=...] [lintian=...]

consumer  installs the build into a fresh prefix and lets projects of their own find, build against and run what is there: all of
          it, and single components where the packages that they do not need cannot be found
shared    the same of the libraries built as shared ones, not optimised; then the installed files: their names for the loader, and
          where each finds the others, also in a prefix that was moved
package   makes the Debian packages of the build, looks into them, installs them below a folder, uses program and package of
          Python, lets a project find the libraries there, and removes them again
wheel     makes an sdist, from it alone a wheel, and installs that where nothing is but numpy, without a network; then pip install .
          in a copy of the source tree, as people type it, which finds compiled what the wheel was made of
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tarfile

HERE = pathlib.Path(__file__).resolve().parent
what = sys.argv[1]
given = dict(word.split("=", 1) for word in sys.argv[2:])
root, scratch = (pathlib.Path(given[name]).resolve() for name in ("root", "scratch"))
version, cmake = given["version"], given.get("cmake", "cmake")
shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)


def run(*command, cwd=None, **environment):
    print("+", *command, flush=True)
    subprocess.run(command, check=True, cwd=cwd, env={**os.environ, **environment})


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def demand(holds, wrong):
    if not holds:
        sys.exit(f"{what}: {wrong}")


def demand_files(folder, *files):
    for file in files:
        demand((folder / file).exists(), f"{file} is not in {folder}")


def configure(prefix, build, use, *options):
    return [cmake, "-S", HERE, "-B", build, "-G", given["generator"], f"-DCMAKE_CXX_COMPILER={given['cxx']}", "-DCMAKE_BUILD_TYPE=Release",
            f"-DCMAKE_PREFIX_PATH={prefix}", f"-DGRANUM_EXPECTED_VERSION={version}", f"-DUSE={use}", *options]


def works(prefix, build, use, *options):
    """A consumer builds and runs."""
    run(*configure(prefix, build, use, *options))
    run(cmake, "--build", build)
    run(build / f"use_{use}")


def consumer(built, folder):
    prefix, build = folder / "the prefix", folder / "the build"
    run(cmake, "--install", built, "--prefix", prefix)
    # A header that no granum_module() line names would be neither checked nor installed.
    written, installed = ({path.relative_to(base / "include") for path in (base / "include").rglob("*") if path.is_file()}
                          for base in (root, prefix))
    demand(installed and written == installed, f"not installed: {written - installed}")
    hidden = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ("GSL", "ZLIB", "EXPAT")]
    works(prefix, build / "granum", "granum")
    works(prefix, build / "theory", "theory", *hidden, "-DCMAKE_DISABLE_FIND_PACKAGE_Threads=ON")
    works(prefix, build / "packing", "packing", *hidden)
    run(*configure(prefix, build / "optional", "optional", *hidden))

    if shutil.which("pkg-config"):  # without CMake; its words are quoted for a shell
        [file] = prefix.rglob("granum.pc")
        os.environ["PKG_CONFIG_PATH"] = str(file.parent)
        for package, use in ("granum", "granum"), ("granum-theory", "theory"):
            flags = said("pkg-config", "--cflags", "--libs", f"{package} = {version}")
            demand(use != "theory" or not re.search("granum_(fit|packing|io)|gsl|expat", flags), f"{package} links more than theory: {flags}")
            program = build / f"by_pkg_config_{use}"
            run(given["cxx"], "-std=c++20", f'-DGRANUM_EXPECTED_VERSION="{version}"', HERE / f"use_{use}.cpp", "-o", program, *shlex.split(flags))
            run(program, LD_LIBRARY_PATH=str(file.parent.parent))

    for use, words, options in (
            ("theroy", "there is no component 'theroy' here; the components are: theory, fit, packing, dem, io, ", []),
            ("fit", "component fit needs GSL, which is not found", hidden),
            ("granum", "component io needs EXPAT, which is not found", hidden[2:])):
        refused = subprocess.run(configure(prefix, build / f"refused_{use}", use, *options), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 text=True)
        demand(refused.returncode and words in " ".join(refused.stdout.split()), f"{use} is not refused with '{words}':\n{refused.stdout}")

    if (built / "granum").exists():
        run(prefix / "bin/granum", "--version")
        demand_files(prefix / "share", "man/man1/granum.1", "man/man1/granum-estimate.1", "bash-completion/completions/granum",
                     "zsh/site-functions/_granum", "doc/granum/copyright", "doc/granum/examples/data/yade_packing.grains.gz")
        run(prefix / "bin/granum", "plan", "--scene", prefix / "share/doc/granum/examples/scene.toml")
    return prefix


def shared():
    build = scratch / "build"
    off = [f"-DGRANUM_{part}=OFF" for part in ("WARNINGS", "BUILD_CLI", "BUILD_TESTS", "BUILD_EXAMPLES", "BUILD_DOCS")]
    run(cmake, "-S", root, "-B", build, "-G", given["generator"], f"-DCMAKE_CXX_COMPILER={given['cxx']}", "-DBUILD_SHARED_LIBS=ON",
        "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O0", "-DGRANUM_UNITY_BUILD=ON", *off)
    run(cmake, "--build", build)
    [theory] = consumer(build, scratch / "consumer").rglob("libgranum_theory.so")
    folder = theory.parent.rename(scratch / "moved")  # whatever the folder of libraries is called
    # A program that was linked asks for the name with the version of the interface, a.b of a.b.c, which is a link to the file.
    interface = re.match(r"\d+\.\d+", version)[0]
    os.environ.pop("LD_LIBRARY_PATH", None)
    table = (root / "cmake/GranumLibraries.cmake").read_text()
    needs = {library: needed.split() for library, needed in re.findall(r"set\(granum_(\w+)_needs *([\w ]*)\)", table)}
    ldconfig = shutil.which("ldconfig", path=os.environ["PATH"] + ":/sbin:/usr/sbin")
    cached = said(ldconfig, "-n", "-v", "-N", folder) if ldconfig else None
    for library, needed in needs.items():
        name = f"libgranum_{library}.so"
        by_interface = f"{name}.{interface}"
        file = (folder / name).resolve()
        demand(file.name == f"{name}.{version}" and (folder / by_interface).resolve() == file, f"{name} is {file}")
        dynamic = said("readelf", "--dynamic", "--wide", file)
        for line in rf"SONAME.*\[{re.escape(by_interface)}\]", r"RUNPATH.*\[\$ORIGIN\]":
            demand(re.search(line, dynamic), f"{name}: no {line} in\n{dynamic}")
        # The loader finds what the library needs, each of granum's beside it; so does the cache of a system's prefix.
        loaded = said("ldd", file)
        demand("not found" not in loaded, loaded)
        for other in needed:
            demand(f"libgranum_{other}.so.{interface} => {folder}/libgranum_{other}.so" in loaded, f"{name}: no {other} beside it in\n{loaded}")
        demand(cached is None or f"{by_interface} -> " in cached, f"ldconfig: no {name} in\n{cached}")


def package():
    python = given.get("python")
    run(given["cpack"], "-G", "DEB", "--config", pathlib.Path(given["build"]) / "CPackConfig.cmake", "-B", scratch / "packed")
    packages = sorted((scratch / "packed").glob("*.deb"))
    depends = {"granum": ["libc6 ", r"libstdc\+\+6 ", r"libgsl\d+", r"libfmt\d+", "libtomlplusplus[0-9a-z]* ", "zlib1g ", "libexpat1 "],
               "libgranum-dev": ["libeigen3-dev ", "libgsl-dev", "zlib1g-dev", "libexpat1-dev"]}
    if python:
        depends["python3-granum"] = ["python3 .>= 3", "python3 .<< 3", "python3-numpy", r"libstdc\+\+6 "]
    for name, expected in depends.items():  # whoever installs it gets what it links or needs
        [file] = (scratch / "packed").glob(f"{name}_{version}_*.deb")
        found = said("dpkg-deb", "--field", file, "Depends")
        for one in expected:
            demand(re.search(f"(^|, ){one}", found), f"{name} does not depend on {one}: {found}")
    if given.get("lintian"):  # errors alone; nobody can answer at the address, which is for whoever distributes the packages
        run(given["lintian"], "--fail-on", "error", "--tag-display-limit", "0", "--allow-root", "--suppress-tags",
            "bogus-mail-host,bogus-mail-host-in-debian-changelog", *packages)

    # dpkg with a root of its own, for which nobody needs to be root; its dependencies are not there.
    below = scratch / "root"
    for folder in "info", "updates":
        (below / "var/lib/dpkg" / folder).mkdir(parents=True)
    for file in "status", "available":
        (below / "var/lib/dpkg" / file).touch()
    dpkg = ["dpkg", f"--root={below}", f"--log={scratch / 'log'}", "--force-not-root", "--force-depends", "--force-bad-path",
            "--force-script-chrootless"]
    run(*dpkg, "--install", *packages)
    examples = below / "usr/share/doc/granum/examples"
    demand_files(below / "usr", "share/doc/granum/copyright", "share/doc/granum/changelog.gz", "share/doc/libgranum-dev/copyright",
                 "share/granum/yade/granum_export.py", "include/granum/core/error.hpp", "share/doc/granum/examples/01_quick_modulus.cpp",
                 "share/doc/granum/examples/data/lammps_loose_p50.atoms.gz", "share/man/man1/granum.1.gz",
                 "share/man/man1/granum-estimate.1.gz", "share/man/man1/granum-export-lammps.1.gz",
                 "share/bash-completion/completions/granum", "share/zsh/site-functions/_granum")
    run(below / "usr/bin/granum", "--version")
    run(below / "usr/bin/granum", "plan", "--scene", examples / "scene.toml")
    if python:
        packages_of_python = below / "usr/lib/python3/dist-packages"
        demand_files(below / "usr", packages_of_python / "granum/__init__.pyi", "share/doc/python3-granum/copyright")
        run(python, examples / "python/modulus_and_range.py", PYTHONPATH=str(packages_of_python), PYTHONDONTWRITEBYTECODE="1")
    for use in "theory", "granum":
        works(below / "usr", scratch / use, use)
    run(*dpkg, "--purge", "granum", "libgranum-dev", "granum-doc", *(["python3-granum"] if python else []))
    demand(not (below / "usr").exists(), f"left behind: {sorted((below / 'usr').rglob('*'))}")


def wheel():
    python, clone = given["python"], scratch / "clone"
    # A copy, as a clone has it: what a build leaves in the source tree is not to be found by chance.
    for path in ("pyproject.toml setup.py MANIFEST.in CMakeLists.txt LICENSE README.md CHANGELOG.md CITATION.cff cmake include share src "
                 "python tests validation/references.bib").split():
        (clone / path).parent.mkdir(parents=True, exist_ok=True)
        if (root / path).is_dir():
            shutil.copytree(root / path, clone / path, ignore=shutil.ignore_patterns("*.egg-info"))
        else:
            shutil.copy2(root / path, clone / path)
    run(python, "-c", f"import setuptools.build_meta as b; b.build_sdist(r'{scratch}')", cwd=clone)
    tree = scratch / f"granum-{version}"
    with tarfile.open(f"{tree}.tar.gz") as sdist:
        members = sdist.getnames()
        sdist.extractall(scratch)
    for member in "LICENSE", "README.md", "PKG-INFO", "src/core/version.cpp", "include/granum/core/version.hpp", "share/lammps/in.iso":
        demand(f"{tree.name}/{member}" in members, f"{member} is not in the sdist")
    demand(not any(member.startswith(f"{tree.name}/tests/") for member in members), "tests are in the sdist")

    # It is to be seen that it computes, not how fast: the compiler does not optimise.
    os.environ.update(CMAKE_ARGS="-DCMAKE_CXX_FLAGS_RELEASE=-O0", PIP_DISABLE_PIP_VERSION_CHECK="1")
    build = [python, "-m", "pip", "wheel", "--no-index", "--no-deps", "--no-build-isolation"]
    run(*build, "--wheel-dir", scratch, tree)
    [made] = scratch.glob(f"granum-{version}-*.whl")
    # An environment without pip, in which numpy is the interpreter's own.
    run(python, "-m", "venv", "--without-pip", scratch / "empty")
    there = scratch / "empty/bin/python"
    site = pathlib.Path(said(there, "-c", "import sysconfig; print(sysconfig.get_path('platlib'))").strip())
    (site / "numpy").symlink_to(said(python, "-c", "import numpy, os; print(os.path.dirname(numpy.__file__))").strip())
    run(python, "-m", "pip", "--python", there, "install", "--no-index", "--no-deps", made)
    os.environ.pop("PYTHONPATH", None)
    run(there, HERE / "use_wheel.py", version)

    # The tree becomes that of the clone; what both have stays as old as it is, and is not compiled again.
    for path in clone.rglob("*"):
        target = tree / path.relative_to(clone)
        if path.is_file() and not (target.exists() and target.read_bytes() == path.read_bytes()):
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)
    run(python, "-m", "pip", "install", *build[4:], "--target", scratch / "site-packages", ".", cwd=tree)
    run(python, HERE / "use_wheel.py", version, PYTHONPATH=str(scratch / "site-packages"))


{"consumer": lambda: consumer(pathlib.Path(given["build"]), scratch), "shared": shared, "package": package, "wheel": wheel}[what]()
